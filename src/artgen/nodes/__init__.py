"""The language: handles, and the operations that authors combine.

Importing the package registers every operation for the operators and methods of handles.
"""

from artgen.nodes import (
    body,
    choose,
    contact,
    csg,
    details,
    extrude,
    grasp_frames,
    joint,
    loft,
    measure,
    path,
    points,
    primitive,
    profile,
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
    sweep,
    loft,
    csg,
    transform,
    measure,
    joint,
    grasp_frames,
    body,
    contact,
    details,
)
"""The modules that define operations."""

__all__ = ["MODULES"]
