"""The language: handles, and the operations that authors combine.

Importing the package registers every operation, so that handles' operators and methods find theirs.
"""

from artgen.nodes import (
    arrays,
    body,
    choose,
    coarse,
    contact,
    csg,
    details,
    extrude,
    hold,
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
