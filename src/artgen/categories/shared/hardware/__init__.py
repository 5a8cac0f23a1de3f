"""Parts that categories share: door hardware.

Door hardware is modeled about its own axis on a leaf in the x-z plane: the origin is on the spindle (or on
the axis of a lock) in the middle of the leaf's thickness, the faces of the leaf are at y = -thickness / 2 and
y = thickness / 2, and the lock edge is at x = backset. Levers therefore point to -x. Callers move parts with
`.at(spindle)` and mirror the finished door for the other hand.
"""

from collections.abc import Mapping

import artgen as ag


def require_suited(
    handle: ag.Generator, option: str, chosen: str, handles: Mapping[str, ag.Generator]
) -> None:
    """Reject a sample with the handle of another option value; a handle from the caller is accepted."""
    own = [value for value, each in handles.items() if handle == each]
    ag.require(
        not own or chosen in own,
        f"handle={handle.name} belongs to {option}={' or '.join(own)}, not to {option}={chosen}: "
        f"set {option} as well, or leave handle out",
    )


HARDWARE_LABELS = (
    "handle",
    "rose",
    "latch",
    "faceplate",
    "strike",
    "lock",
    "deadbolt",
    "cylinder",
    "hinge",
    "screw",
)
"""All labels of the parts of door hardware."""
