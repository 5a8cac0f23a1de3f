"""The referee: proofs and refutations for articulated files that other tools made."""

from artgen.referee.judge import JudgedPair, Judgment, certify

__all__ = ["JudgedPair", "Judgment", "certify"]
