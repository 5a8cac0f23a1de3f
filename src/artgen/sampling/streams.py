"""One random stream for each parameter name, so that no draw shifts another."""

import hashlib

import numpy as np


def stream(seed: int, path: str, attempt: int = 0) -> np.random.Generator:
    """Return the random stream of one parameter of one asset.

    Args:
        seed: Seed of the asset, not negative.
        path: Category and parameter, such as `door/handle.lever_handle.length`.
        attempt: Number of infeasible draws before.
    """
    name = int.from_bytes(hashlib.blake2b(path.encode(), digest_size=8).digest(), "little")
    return np.random.Generator(np.random.PCG64(np.random.SeedSequence([seed, attempt, name])))
