"""The certificate: a proof that no two links collide anywhere in the joint ranges."""
