"""The language: handles, and the operations that authors combine.

Importing the package registers every operation, so that handles' operators and methods find theirs.
"""

from artgen.nodes import (
    arrays,
    body,
    choose,
    contact,
    csg,
    details,
    extrude,
    joint,
    loft,
    measure,
    path,
    points,
    primitive,
    profile,
    revolve,
    scalar,
    sweep,
    text,
    transform,
    vector,
)
from artgen.nodes import grasp_frames as hold
from artgen.nodes import simplified_collider as coarse

MODULES = (
    scalar,
    vector,
    points,
    choose,
    profile,
    text,
    path,
    primitive,
    extrude,
    revolve,
    sweep,
    loft,
    csg,
    coarse,
    transform,
    arrays,
    measure,
    joint,
    hold,
    body,
    contact,
    details,
)
"""The modules that define operations."""

__all__ = ["MODULES"]
