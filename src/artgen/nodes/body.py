"""Bodies: parts become links, joints join them; masses and allowed contacts."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from artgen._arrays import Array, affine
from artgen._names import NAME_RULE, WORLD, is_identifier
from artgen.asset import (
    AllowedContact,
    AssetCondition,
    AssetJoint,
    Branch,
    Grasp,
    Link,
    Piece,
    Push,
    Shape,
    Tree,
    rotation,
)
from artgen.asset.affordance import GRIPPER, held
from artgen.asset.link import MovedLink, PrintDirection
from artgen.asset.mass import total
from artgen.asset.shape import LateShape
from artgen.errors import nearest
from artgen.graph import kernel, records
from artgen.materials import Material
from artgen.nodes.csg import poses, subtracted
from artgen.nodes.grasp_frames import Array4x4, Frame
from artgen.nodes.handles import Array3, ArrayN3, Body, Scalar, Solid, VectorLike
from artgen.nodes.joint import Condition
from artgen.nodes.validators import finite
from artgen.nodes.vector import unit


def _check_name(name: str, what: str) -> None:
    if not is_identifier(name):
        raise ValueError(f"{what} {name!r} is no identifier; use {NAME_RULE}")
    if name == WORLD:
        raise ValueError(f"{what} {name!r} is the fixed frame in MJCF and URDF; use another name")


def _part(
    solid: Shape | tuple[Shape, ...],
    label: str,
    material: Material,
    name: str | None,
    grasp: tuple[Array4x4, ...],
    grasp_width: float | None,
    separate: str,
    push: tuple[Array4x4, ...],
    when: AssetCondition | None,
) -> Tree:
    link_name = label if name is None else name
    _check_name(label, "label")
    _check_name(link_name, "link name")
    if grasp_width is not None and grasp_width <= 0.0:
        raise ValueError(f"grasp_width must be positive, got {grasp_width:.6g} m")
    solids = solid if isinstance(solid, tuple) else (solid,)
    widths = [_opening(solids[0], frame) if grasp_width is None else grasp_width for frame in grasp]
    if when is not None and not (grasp or push):
        raise ValueError(
            f"when={when} tells where a hand reaches a grasp or push; give grasp= or push= as well"
        )
    grasps = tuple(map(partial(Grasp, when=when), _numbered(f"{link_name}_grasp", len(grasp)), grasp, widths))
    pushes = tuple(map(partial(Push, when=when), _numbered(f"{link_name}_push_point", len(push)), push))
    return Tree(
        Link(
            link_name, label, tuple(Piece(label, material, each) for each in solids), grasps, separate, pushes
        )
    )


def _numbered(name: str, count: int) -> list[str]:
    return [f"{name}_{index}" for index in range(count)] if count > 1 else [name] * count


def _opening(solid: Shape, frame: Array4x4) -> float:
    """Return the opening of the fingers around a solid; the full opening if there is none."""
    reach = held([solid.manifold], frame)
    return GRIPPER.stroke if reach is None else GRIPPER.opening(reach[1] - reach[0])


@records(_part)
def part(
    solid: Solid | Sequence[Solid],
    label: str,
    material: Material,
    *,
    name: str | None = None,
    grasp: Frame | Sequence[Frame] = (),
    grasp_width: Scalar | None = None,
    separate: str = "",
    push: Frame | Sequence[Frame] = (),
    when: Condition | None = None,
) -> Body:
    """Make a rigid link of a solid, or of several with one label and material.

    Args:
        solid: The solid in asset coordinates, or several; the first one carries the grasps.
        label: Semantic label.
        material: Their material.
        name: Name of the link; by default its label.
        grasp: Frames at which a hand grasps, in asset coordinates: from `frame`, or from `grasp_on`, which
            finds them.
        grasp_width: Opening of the fingers, at most 0.08; by default the measured width between the fingers
            plus 5 mm on either side [m].
        separate: Reason why the solids of the link are not all connected; without a reason, checks report
            gaps above 0.5 mm as a fault.
        push: Frames at which a finger pushes: on the surface, with `approach` in the direction of the push,
            as `push_on` finds them.
        when: Condition under which a hand reaches these frames, such as `lid_hinge > 1.0` for keys under a
            lid; by default always. Checks open the lid first, also a lid that a motor drives.

    Examples:
        >>> part(box(0.3, 0.2, 0.018, bevel=0.002), "shelf", material("oak"))
    """


def _detail(
    solid: Shape | tuple[Shape, ...],
    label: str,
    material: Material,
    reads: Array3 | None,
    about: Array3 | None,
) -> Tree:
    _check_name(label, "label")
    solids = solid if isinstance(solid, tuple) else (solid,)
    reading = None
    if reads is not None:
        if about is None:
            corners = np.concatenate([each.bounds() for each in solids])
            about = 0.5 * (corners.min(axis=0) + corners.max(axis=0))
        reading = PrintDirection(about, unit(reads))
    pieces = tuple(Piece(label, material, each, visual=True, reading=reading) for each in solids)
    return Tree(Link(label, label, pieces))


def _without_print(inputs: Mapping[str, Any]) -> Any:
    """Return an empty detail in place of print, which needs no solid."""
    label = inputs["label"]
    return NotImplemented if inputs["reads"] is None else Tree(Link(label, label))


@records(_detail, bare=_without_print, later={"solid": LateShape})
def detail(
    solid: Solid | Sequence[Solid],
    label: str,
    material: Material,
    *,
    reads: VectorLike | None = None,
    about: VectorLike | None = None,
) -> Body:
    """Make a visual detail, such as print or the head of a screw: without mass and collider.

    It must be welded to a part.

    Args:
        solid: The solid in asset coordinates, or several.
        label: Semantic label.
        material: Their material.
        reads: Direction of the lines of print, which stays readable if the body is mirrored.
        about: Center of the print [m]; by default the center of its bounding box.

    Examples:
        >>> plate = part(box(0.06, 0.004, 0.04), "plate", material("abs"))
        >>> weld(plate, detail(box(0.03, 0.001, 0.01).at(y=-0.0025), "stripe", material("copper")))
    """


def _weld(bodies: tuple[Tree, ...]) -> Tree:
    if not bodies:
        raise ValueError("weld needs at least one body")
    first = bodies[0].link
    pieces = tuple(piece for body in bodies for piece in body.link.pieces)
    names = (first.name, re.sub(r"(_(\d+|left|right))+$", "", first.name), first.label)
    labels = {piece.label for piece in pieces} | {first.label}
    link = Link(
        first.name,
        next(name for name in names if name in labels),  # a handle may name the link of a drawer
        pieces,
        tuple(grasp for body in bodies for grasp in body.link.grasps),
        "; ".join(dict.fromkeys(body.link.separate for body in bodies if body.link.separate)),
        tuple(push for body in bodies for push in body.link.pushes),
    )
    contacts = tuple(
        contact.renamed({body.link.name: first.name}, {}) for body in bodies for contact in body.contacts
    )
    loops = tuple(loop.renamed({body.link.name: first.name}, {}) for body in bodies for loop in body.loops)
    branches = tuple(branch for body in bodies for branch in body.branches)
    outputs = tuple(output for body in bodies for output in body.outputs)
    return Tree(link, branches, contacts, loops, outputs).checked()


@records(_weld)
def weld(*bodies: Body) -> Body:
    """Join bodies rigidly to one link, named like the first body; solids keep their labels and materials.

    A volume in several solids counts once, with the density of the first.

    Examples:
        >>> head = part(box(0.1, 0.03, 0.03).at(z=0.15), "head", material("steel"))
        >>> weld(part(cylinder(0.012, 0.3), "handle", material("oak")), head)
    """


_NOWHERE = Link("nowhere", "nowhere")  # placeholder for the parent of a branch


def _placed(child: Tree, joints: tuple[AssetJoint, ...], matrix: Array, suffix: str = "") -> Branch:
    """Return a child with its joints, carried along by a rigid motion or a reflection, shape (4, 4)."""
    copy = Tree(_NOWHERE, (Branch(joints, child),)).moved(matrix)
    return (copy.suffixed(suffix) if suffix else copy).branches[0]


@kernel(spelling="{parent}.attach({child}, *{joints}, at={at})")
def _attach(parent: Tree, child: Tree, joints: tuple[AssetJoint, ...], at: Array3) -> Tree:
    if not joints:
        raise ValueError("attach needs at least one joint; weld joins bodies rigidly")
    branch = _placed(child, joints, affine(np.eye(3), at)) if at.any() else Branch(joints, child)
    return replace(parent, branches=(*parent.branches, branch)).checked()


@kernel(spelling="{parent}.attach_pair({child}, *{joints}, normal={normal}, suffixes={suffixes})")
def _attach_pair(
    parent: Tree, child: Tree, joints: tuple[AssetJoint, ...], normal: Array3, suffixes: tuple[str, str]
) -> Tree:
    if not joints:
        raise ValueError("attach_pair needs at least one joint; weld(body, body.mirror(...)) joins rigidly")
    for suffix in suffixes:
        _check_name(f"x{suffix}", "suffix")
    images = (np.eye(4), _reflection(normal))
    pair = (_placed(child, joints, *each) for each in zip(images, suffixes, strict=True))
    return replace(parent, branches=(*parent.branches, *pair)).checked()


def _reflection(normal: Array3) -> Array:
    direction = unit(normal)
    return affine(np.eye(3) - 2.0 * np.outer(direction, direction))


@kernel(spelling="{parent}.repeat({child}, *{joints}, at={at}, around={around})")
def _repeat(
    parent: Tree, child: Tree, joints: tuple[AssetJoint, ...], at: ArrayN3, around: Array3 | None
) -> Tree:
    if not joints:
        raise ValueError("repeat needs at least one joint; array and weld join copies rigidly")
    places = enumerate(poses(at, around))
    copies = (_placed(child, joints, pose, f"_{index}") for index, pose in places)
    return replace(parent, branches=(*parent.branches, *copies)).checked()


@kernel
def _copies(body: Tree, at: ArrayN3, around: Array3 | None) -> Tree:
    """Weld copies of the body of a fitting."""
    places = enumerate(poses(at, around))
    return _weld(tuple(body.moved(pose).suffixed(f"_{index}") for index, pose in places))


@kernel
def _mounted(child: Tree, joints: tuple[AssetJoint, ...]) -> Tree:
    if not joints:
        raise ValueError("a moving fitting needs at least one joint; Fitting(body) is a fixed one")
    return Tree(_NOWHERE, (Branch(joints, child),))


@kernel(spelling="{body}.cut({tool})")
def _cut(body: Tree, tool: Shape) -> Tree:
    low, high = tool.bounds()
    pieces: list[Piece] = []
    for piece in body.link.pieces:
        least, most = piece.shape.bounds()
        if not (np.all(least < high) and np.all(most > low)):
            pieces.append(piece)
        elif (rest := subtracted(piece.shape, tool)) is not None:
            pieces.append(replace(piece, shape=rest))
    if not pieces:
        raise ValueError(
            f"nothing is left of {body.link.name!r}: the cut contains all its pieces; make the cut smaller"
        )
    return replace(body, link=replace(body.link, pieces=tuple(pieces)))


@kernel(spelling="{body}.at({offset})")
def _translate_body(body: Tree, offset: Array3) -> Tree:
    return body.moved(affine(np.eye(3), offset))


@kernel(spelling="{body}.rotate({axis}, {angle}, about={about})")
def _rotate_body(body: Tree, axis: Array3, angle: float, about: Array3) -> Tree:
    turn = rotation(unit(axis), angle)
    return body.moved(affine(turn, about - turn @ about))


@kernel(spelling="{body}.mirror({normal})")
def _mirror_body(body: Tree, normal: Array3) -> Tree:
    return body.moved(_reflection(normal))


@kernel(spelling="{body}.suffixed({suffix})")
def _suffix(body: Tree, suffix: str) -> Tree:
    _check_name(f"x{suffix}", "suffix")
    return body.suffixed(suffix)


Place = tuple[str, str]
"""A link and a label of solid pieces on it."""


@kernel
def _allow_contact(
    body: Tree, a: str, b: str, depth: float, reason: str, when: AssetCondition | None
) -> Tree:
    if finite("depth", depth) < 0.0:
        raise ValueError(f"depth must not be negative, got {depth:.6g} m; 0 allows them to touch")
    if not reason.strip():
        raise ValueError(f"the contact of {a!r} with {b!r} has no reason; say why they may touch")
    found: dict[frozenset[Place], AllowedContact] = {}
    first, second = _places(body, a), _places(body, b)
    for one in first:
        for other in second:
            if one[0] != other[0]:
                links, labels = (one[0], other[0]), (one[1], other[1])
                contact = AllowedContact(links, labels, depth, reason.strip(), when)
                found.setdefault(frozenset((one, other)), contact)
    if not found:
        raise ValueError(
            f"{a!r} and {b!r} are both on link {first[0][0]!r} and on no other; pieces of one link never "
            "move against each other: name pieces of two links"
        )
    return replace(body, contacts=(*body.contacts, *found.values()))


def _places(body: Tree, name: str) -> list[Place]:
    """Return the links and labels of `label` or `link/label` in a body, at least one."""
    labels = {link.name: _solid_labels(link) for link in body.links()}
    link, slash, label = name.rpartition("/")
    if slash:
        if link not in labels:
            raise ValueError(f"{name!r}: this body has no link {link!r}.{nearest(link, labels)}")
        if label not in labels[link]:
            options = nearest(label, labels[link])
            raise ValueError(f"{name!r}: link {link!r} has no solid labelled {label!r}.{options}")
        return [(link, label)]
    found = [(each, name) for each, carried in labels.items() if name in carried]
    if not found and name in labels:
        raise ValueError(
            f"{name!r} is a link, and contacts are declared per labelled piece; write "
            + " or ".join(f"'{name}/{each}'" for each in labels[name])
        )
    if not found:
        every = {each for carried in labels.values() for each in carried}
        raise ValueError(f"no solid of this body is labelled {name!r}.{nearest(name, every)}")
    return found


def _solid_labels(link: Link) -> tuple[str, ...]:
    """Return the labels of a link's solids, without visual details."""
    while isinstance(link, MovedLink):  # accessing its own pieces would move them all
        link = link.source
    return tuple(dict.fromkeys(piece.label for piece in link.pieces if not piece.visual))


@kernel(spelling="{body}.mass()")
def _mass(body: Tree) -> float:
    return sum(link.mass_properties.mass for link in body.links())


@kernel(spelling="{body}.center_of_mass()")
def _center_of_mass(body: Tree) -> Array3:
    return total([link.mass_properties.moments() for link in body.links()]).center
