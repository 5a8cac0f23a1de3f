"""Handles that an option brings: with an override of only one of them, the two may not belong together."""

from collections.abc import Mapping

from artgen import Generator, require


def require_suited(handle: Generator, option: str, chosen: str, handles: Mapping[str, Generator]) -> None:
    """Rule out a sample with the handle of another option value; a caller's own handle passes."""
    own = [value for value, each in handles.items() if handle == each]
    require(
        not own or chosen in own,
        f"handle={handle.name} belongs to {option}={' or '.join(own)}, not to {option}={chosen}: "
        f"set {option} as well, or leave handle out",
    )
