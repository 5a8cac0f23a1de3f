"""Bodies: parts become links, joints join them."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from artgen import asset as values
from artgen._names import NAME_RULE, is_identifier
from artgen.asset import Branch, Grasp, Link, Piece, PrintDirection, Push, Shape, Tree, rotation
from artgen.asset.gripper import GRIPPER, held
from artgen.graph import kernel
from artgen.materials import Material
from artgen.nodes.grasp_frames import Array4x4, Frame
from artgen.nodes.handles import Array3, ArrayN3, Body, PointsLike, Scalar, Solid, VectorLike
from artgen.nodes.joint import Joint
from artgen.nodes.vector import unit


def _check_name(name: str, what: str) -> None:
    if not is_identifier(name):
        raise ValueError(f"{what} {name!r} is no identifier; use {NAME_RULE}")


@kernel
def _part(
    solid: Shape,
    label: str,
    material: Material,
    name: str | None,
    grasp: tuple[Array4x4, ...],
    grasp_width: float | None,
    separate: str,
    push: tuple[Array4x4, ...],
) -> Tree:
    link_name = label if name is None else name
    _check_name(label, "label")
    _check_name(link_name, "link name")
    if grasp_width is not None and grasp_width <= 0.0:
        raise ValueError(f"grasp_width must be positive, got {grasp_width:.6g} m")
    grasps = tuple(
        Grasp(
            f"{link_name}_grasp{f'_{index}' if len(grasp) > 1 else ''}",
            pose,
            _opening(solid, pose) if grasp_width is None else grasp_width,
        )
        for index, pose in enumerate(grasp)
    )
    pushes = tuple(
        Push(f"{link_name}_push_point{f'_{index}' if len(push) > 1 else ''}", pose)
        for index, pose in enumerate(push)
    )
    return Tree(Link(link_name, label, (Piece(label, material, solid),), grasps, separate, pushes))


def _opening(solid: Shape, pose: Array4x4) -> float:
    """Return the opening of the fingers around a solid; the full opening if there is none."""
    reach = held([solid.manifold], pose)
    return GRIPPER.stroke if reach is None else GRIPPER.opening(reach[1] - reach[0])


def part(
    solid: Solid,
    label: str,
    material: Material,
    *,
    name: str | None = None,
    grasp: Frame | Sequence[Frame] = (),
    grasp_width: Scalar | None = None,
    separate: str = "",
    push: Frame | Sequence[Frame] = (),
) -> Body:
    """Make a rigid link of a solid.

    Args:
        solid: The solid in asset coordinates.
        label: Semantic label.
        material: Its material.
        name: Name of the link; by default its label.
        grasp: Frames at which a hand grasps, in asset coordinates: from `frame`, or from `grasp_on`, which
            finds them.
        grasp_width: Opening of the fingers, at most 0.08; by default the measured width between the fingers
            plus 5 mm on either side [m].
        separate: Reason why the solids of the link are not all connected; without a reason, checks report
            gaps above 0.5 mm as a fault.
        push: Frames at which a finger pushes: on the surface, with `approach` in the direction of the push,
            as `push_on` finds them.

    Examples:
        >>> part(box(0.3, 0.2, 0.018, bevel=0.002), "shelf", material("oak"))
    """
    grasps = (grasp,) if isinstance(grasp, Frame) else grasp
    pushes = (push,) if isinstance(push, Frame) else push
    return Body.record(
        _part,
        solid=solid,
        label=label,
        material=material,
        name=name,
        grasp=grasps,
        grasp_width=grasp_width,
        separate=separate,
        push=pushes,
    )


@kernel
def _detail(solid: Shape, label: str, material: Material, reads: Array3 | None, about: Array3 | None) -> Tree:
    _check_name(label, "label")
    reading = None
    if reads is not None:
        middle = solid.bounds().mean(axis=0) if about is None else about
        reading = PrintDirection(middle, unit(reads))
    return Tree(Link(label, label, (Piece(label, material, solid, visual=True, reading=reading),)))


def detail(
    solid: Solid,
    label: str,
    material: Material,
    *,
    reads: VectorLike | None = None,
    about: VectorLike | None = None,
) -> Body:
    """Make a visual detail, such as print or the head of a screw: without mass and collider.

    It must be welded to a part.

    Args:
        solid: The solid in asset coordinates.
        label: Semantic label.
        material: What it is made of.
        reads: Direction of the lines of print, which stays readable if the body is mirrored.
        about: Center of the print [m]; by default the center of its bounding box.

    Examples:
        >>> plate = part(box(0.06, 0.004, 0.04), "plate", material("abs"))
        >>> weld(plate, detail(box(0.03, 0.001, 0.01).at(y=-0.0025), "stripe", material("copper")))
    """
    return Body.record(_detail, solid=solid, label=label, material=material, reads=reads, about=about)


@kernel
def _weld(bodies: tuple[Tree, ...]) -> Tree:
    if not bodies:
        raise ValueError("weld needs at least one body")
    first = bodies[0].link
    link = Link(
        first.name,
        first.label,
        tuple(piece for body in bodies for piece in body.link.pieces),
        tuple(grasp for body in bodies for grasp in body.link.grasps),
        "; ".join(dict.fromkeys(body.link.separate for body in bodies if body.link.separate)),
        tuple(push for body in bodies for push in body.link.pushes),
    )
    contacts = tuple(
        contact.renamed({body.link.name: first.name}, {}) for body in bodies for contact in body.contacts
    )
    return Tree(link, tuple(branch for body in bodies for branch in body.branches), contacts).checked()


def weld(*bodies: Body) -> Body:
    """Join bodies rigidly to one link, named like the first body; solids keep their labels and materials.

    A volume in several solids counts once, with the density of the first.

    Examples:
        >>> head = part(box(0.1, 0.03, 0.03).at(z=0.15), "head", material("steel"))
        >>> weld(part(cylinder(0.012, 0.3), "handle", material("oak")), head)
    """
    return Body.record(_weld, bodies=bodies)


@kernel
def _attach(parent: Tree, child: Tree, joints: tuple[values.AssetJoint, ...]) -> Tree:
    if not joints:
        raise ValueError("attach needs at least one joint; weld joins bodies rigidly")
    return replace(parent, branches=(*parent.branches, Branch(joints, child))).checked()


def attach(parent: Body, child: Body, joints: Sequence[Joint]) -> Body:
    """Join a child to a parent by joints that act in order, the first nearest to the parent."""
    return Body.record(_attach, parent=parent, child=child, joints=joints)


_NOWHERE = Link("nowhere", "nowhere")  # placeholder for the parent while a branch is copied


@kernel
def _repeat(parent: Tree, child: Tree, joints: tuple[values.AssetJoint, ...], at: ArrayN3) -> Tree:
    if not joints:
        raise ValueError("repeat needs at least one joint; array and weld join copies rigidly")
    branches = []
    for index, point in enumerate(at):
        matrix = np.eye(4)
        matrix[:3, 3] = point
        copy = Tree(_NOWHERE, (Branch(joints, child),)).moved(matrix).suffixed(f"_{index}")
        branches.append(copy.branches[0])
    return replace(parent, branches=(*parent.branches, *branches)).checked()


def repeat(parent: Body, child: Body, joints: Sequence[Joint], at: PointsLike) -> Body:
    """Join a copy of a child at each point, with copies of its joints, suffixed `_0`, `_1`, ..."""
    return Body.record(_repeat, parent=parent, child=child, joints=joints, at=at)


@kernel
def _translate_body(body: Tree, offset: Array3) -> Tree:
    matrix = np.eye(4)
    matrix[:3, 3] = offset
    return body.moved(matrix)


def translate_body(body: Body, offset: VectorLike) -> Body:
    """Move a body with its joints by a vector [m]."""
    return Body.record(_translate_body, body=body, offset=offset)


@kernel
def _rotate_body(body: Tree, axis: Array3, angle: float, about: Array3) -> Tree:
    matrix = np.eye(4)
    matrix[:3, :3] = rotation(unit(axis), angle)
    matrix[:3, 3] = about - matrix[:3, :3] @ about
    return body.moved(matrix)


def rotate_body(body: Body, axis: VectorLike, angle: Scalar, about: VectorLike) -> Body:
    """Rotate a body with its joints about an axis through a point by an angle [rad]."""
    return Body.record(_rotate_body, body=body, axis=axis, angle=angle, about=about)


@kernel
def _mirror_body(body: Tree, normal: Array3) -> Tree:
    direction = unit(normal)
    matrix = np.eye(4)
    matrix[:3, :3] -= 2.0 * np.outer(direction, direction)
    return body.moved(matrix)


def mirror_body(body: Body, normal: VectorLike) -> Body:
    """Reflect a body with its joints in the plane through the origin with a normal."""
    return Body.record(_mirror_body, body=body, normal=normal)


@kernel
def _suffix(body: Tree, suffix: str) -> Tree:
    _check_name(f"x{suffix}", "suffix")
    return body.suffixed(suffix)


def suffix(body: Body, suffix: str) -> Body:
    """Add a suffix to the names of all links, joints, grasps and pushes of a body."""
    return Body.record(_suffix, body=body, suffix=suffix)
