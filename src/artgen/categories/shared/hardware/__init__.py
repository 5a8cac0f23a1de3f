"""Parts that categories share: door hardware.

Door hardware is drawn about its own axis on a leaf that stands in the X-Z plane: the origin lies on the
spindle (or on the axis of a lock) in the middle of the leaf's thickness, the faces of the leaf are at
y = -thickness / 2 and y = thickness / 2, and the edge with the lock is at x = backset. Levers therefore point
to -x. Callers move parts with `.at(spindle)` and mirror the finished door for the other hand.
"""

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
"""Every label that the parts of a door's hardware may carry."""
