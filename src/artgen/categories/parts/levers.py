"""Lever handles, and the sprung joint by which a handle turns."""

from typing import Literal

from artgen.categories.parts.roses import NECK_GAP, SPINDLE
from artgen.generator import generator
from artgen.materials import Material
from artgen.nodes.body import Frame, frame, part
from artgen.nodes.csg import union
from artgen.nodes.handles import Body, Float, Path, Profile, Scalar, Solid, VectorLike
from artgen.nodes.joint import Joint, Revolute
from artgen.nodes.path import polyline, spline
from artgen.nodes.primitive import cylinder, dome, ellipsoid
from artgen.nodes.profile import circle, ellipse, rectangle
from artgen.nodes.sweep import sweep
from artgen.nodes.vector import Y
from artgen.sampling import choice, uniform

Faces = Literal["both", "front", "back"]
"""On which faces of the leaf a handle sits; the front faces -y."""

SIDES: dict[str, tuple[int, ...]] = {"both": (-1, 1), "front": (-1,), "back": (1,)}
"""The signs of y that belong to `Faces`."""


def spring_turn(
    name: str = "handle_turn",
    *,
    limit: Scalar,
    pivot: VectorLike = (0.0, 0.0, 0.0),
    toward: int = -1,
    preload: Scalar = 0.7,
    torque: Scalar = 1.3,
    damping: Scalar = 0.06,
    friction: Scalar = 0.02,
) -> Joint:
    """Make the joint of a lever or knob that a spring turns back; positive moves the free end down.

    Args:
        name: Name of the joint.
        limit: How far it turns [rad].
        pivot: A point on the spindle [m].
        toward: Direction of the lever along X, -1 or 1.
        preload: Torque of the spring at rest; a lever must not sag under its weight (about 0.3) [N m].
        torque: Torque of the spring at the limit [N m].
        damping: [N m s/rad].
        friction: [N m].
    """
    stiffness = (torque - preload) / limit
    return Revolute(
        name,
        axis=(0.0, toward, 0.0),
        pivot=pivot,
        limits=(0.0, limit),
        stiffness=stiffness,
        rest=-(preload / stiffness),
        damping=damping,
        friction=friction,
        armature=0.0005,  # the follower and the springs in the lock case
        effort=20.0,
    )


@generator
def lever_handle(
    *,
    thickness: Float,
    rose: Float,
    finish: Material,
    toward: int = -1,
    faces: Faces = "both",
    style: Literal["straight", "bent", "wave"] = choice("straight", "bent", "wave"),
    section: Literal["round", "flat"] = choice("round", "flat"),
    length: Float = uniform(0.11, 0.145, "m", doc="spindle to the tip of the lever", within=(0.10, 0.20)),
    projection: Float = uniform(0.046, 0.056, "m", doc="face of the leaf to the middle of the lever"),
    girth: Float = uniform(0.0085, 0.0105, "m", doc="half the height of the grip"),
) -> Body:
    """Make a lever on each face of the leaf, joined by the spindle.

    Links: it is the link `handle`. Attach it by `spring_turn`.

    Args:
        thickness: Thickness of the leaf [m].
        rose: Thickness of the rose or plate, from which the neck keeps a gap [m].
        finish: Metal of the lever.
        toward: Direction in which the levers point, -1 or 1 along X.
        faces: Which faces have a lever.
        style: Plain bar, bar whose tip returns to the leaf, or a curved lever.
        section: Round bar or rounded flat bar; a curved lever is always oval.
        length: From the spindle to the tip [m].
        projection: From the face of the leaf to the middle of the lever [m].
        girth: Half the height of the grip [m].
    """
    solids: list[Solid] = []
    grasps: list[Frame] = []
    for side in SIDES[faces]:
        start, out = side * (thickness / 2 + rose + NECK_GAP), side * (thickness / 2 + projection)
        grip = _profile("oval" if style == "wave" else section, girth)
        solids.append(sweep(grip, _course(style, start, out, side, toward, length, girth)))
        solids.append(_neck(start, side, girth))
        solids.append(_tip(style, section, out, side, toward, length, girth))
        grasps.append(frame((toward * length * 0.62, out, 0.0), approach=(0.0, -side, 0.0)))
    solids.append(spindle(thickness, rose, faces))
    width = 2 * girth + 0.03
    return part(union(*solids), "handle", finish, grasp=grasps, grasp_width=width)
