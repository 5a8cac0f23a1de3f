"""The language: handles, and the operations that authors combine.

Importing the package registers every operation for the operators and methods of handles.
"""

from artgen.nodes import (
    body,
    csg,
    details,
    extrude,
    grasp_frames,
    joint,
    loft,
    loop,
    path,
    primitive,
    profile,
    scalar,
    solid_methods,
    sweep,
    text,
    vector,
)

__all__ = [
    "body", "csg", "details", "extrude", "grasp_frames", "joint", "loft", "loop", "path", "primitive",
    "profile", "scalar", "solid_methods", "sweep", "text", "vector",
]  # fmt: skip
