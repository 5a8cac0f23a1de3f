"""What the Omniverse Asset Validator, which simready-validate is built on, calls things."""

from typing import Any


def place(at: Any) -> str:
    """Return what an issue is about: a prim, or the stage as a whole."""
    path = getattr(at, "path", None)
    return str(path) if path is not None else "the stage"
