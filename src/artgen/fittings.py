"""Fittings: what a shop for hardware and controls sells, ready to be installed on a panel.

    from artgen import fittings
    panel = panel.install(fittings.push_button(icon="fan"), at=cell.anchor(y=-1))

Each function returns a `Fitting`: its fixed parts and moving links with their joints, and the hole that it
needs. A fitting is modeled about the origin on the plane y = 0, the face of its host, and faces -y; turn it
with `rotate` for another face: `fittings.caster().rotate(X, pi / 2)` is for an underside. `suffixed("_2")`
gives copies names of their own. All lengths are in meters.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import wraps
from types import GenericAlias
from typing import Any, Literal, TypeVar, Union, cast, get_args, get_origin, get_type_hints

import artgen as ag
from artgen import details, feel
from artgen.asset.joint import is_number
from artgen.categories.shared import controls, door_handles, fixings, locks, pulls
from artgen.categories.shared.furniture import ZINC
from artgen.categories.shared.shelves import open_box
from artgen.errors import BuildError
from artgen.graph.handle import Handle, lift
from artgen.graph.kernel import alternatives
from artgen.graph.node import authors_line
from artgen.nodes.details.dials import SWEEP
from artgen.nodes.details.displays import Color
from artgen.nodes.fitting import FIT, Fitting

__all__ = [
    "FIT", "Fitting", "bar_handle", "cam_lock", "caster", "cup_pull", "deadbolt", "dial", "display",
    "drawer_runners", "edge_pull", "foot", "hinge", "knob", "knob_set", "latch", "lever_set", "logo",
    "pocket_handle", "push_button", "recessed_handle",
]  # fmt: skip

_STEEL = ag.material("stainless")
_NICKEL = ag.material("satin_nickel")
_SUNK = 0.0003  # overlap of fixed parts with the face [m]
_ROSE = 0.009  # height of roses [m]
_POSITIVE = frozenset(["height", "limit", "throw", "travel"])  # parameters that are above 0
_Make = TypeVar("_Make", bound=Callable[..., Fitting])


def _kernel_type(hint: Any) -> Any:
    """Return the type that operations have for an annotation of authors."""
    options, found = alternatives(hint), []
    for option in options:
        origin, members = get_origin(option), get_args(option)
        if origin in (tuple, Sequence):
            members = (*members, ...) if origin is Sequence else members
            kinds = tuple(each if each is Ellipsis else _kernel_type(each) for each in members)
            found.append(GenericAlias(tuple, kinds))
        elif isinstance(option, type) and issubclass(option, Handle):
            found.append(option.value_type)
        elif option is not int or ag.Float not in options:
            found.append(option)
    return Union[tuple(found)]  # noqa: UP007 - of a computed tuple


def _checked(function: _Make) -> _Make:
    """Check the arguments of a fitting by its annotations before it is made."""
    kinds = {name: _kernel_type(hint) for name, hint in get_type_hints(function).items()}

    @wraps(function)
    def made(*arguments: Any, **keywords: Any) -> Fitting:
        for name, value in {**dict(zip(kinds, arguments, strict=False)), **keywords}.items():
            what = f"{function.__name__}(..., {name}=...)"
            if name in kinds:
                lift(value, kinds[name], what)
            if name in _POSITIVE and is_number(value) and not value > 0.0:
                raise BuildError(f"{what} must be above 0, got {value!r}\n  at {authors_line()}")
        return function(*arguments, **keywords)

    return cast("_Make", made)


@_checked
def push_button(
    *,
    shape: controls.ButtonShape = "round",
    width: ag.Scalar = 0.012,
    height: ag.Scalar | None = None,
    proud: ag.Scalar = 0.004,
    deep: ag.Scalar = 0.008,
    travel: ag.Scalar = 0.003,
    preload: ag.Scalar = 0.6,
    force: ag.Scalar = 3.0,
    damping: ag.Scalar | None = None,
    effort: ag.Scalar | None = None,
    icon: str | ag.Profile = "power",
    finish: ag.Material = ag.MATERIALS["black_abs"],
    plate: ag.Material | None = ag.MATERIALS["stainless"],
    ink: ag.Material | None = None,
    name: str = "button",
) -> Fitting:
    """Make a push button: a cap that slides into its panel against a spring, in a thin plate.

    Keys of appliances have caps of 8-20 mm, strokes of 1-3 mm and close at 2-4 N (catalogs of tactile
    switches). A finger needs 10 mm plus half of a cap to the middle of the next button.

    Args:
        shape: Outline of the cap.
        width: Width or diameter of the cap [m].
        height: Height of the cap; by default its width [m].
        proud: Projection at rest, which must exceed the travel [m].
        deep: Depth of the cap behind the face [m].
        travel: Stroke [m].
        preload: Force that starts it [N].
        force: Force that presses it home [N].
        damping: Damping, by default that of `feel.SWITCH` [N s/m].
        effort: Largest force, by default that of `feel.SWITCH` [N].
        icon: Name of an icon, or a profile such as lettering, that is printed on the cap; `""` for none.
        finish: Material of the cap.
        plate: Material of the plate around it; None for no plate.
        ink: Material of the print, by default one with good contrast.
        name: Name of its link; its joint is `{name}_slide`.

    Examples:
        >>> panel = part(box(0.06, 0.012, 0.04).at(y=0.006), "panel", material("abs"))
        >>> panel = panel.install(fittings.push_button().suffixed("_0"), at=(-0.012, 0, 0))
        >>> panel.install(fittings.push_button(shape="square", icon="fan").suffixed("_1"), at=(0.012, 0, 0))
    """
    return controls.push_button(
        finish=finish,
        through=deep + travel + 0.001,
        shape=shape,
        width=width,
        height=height,
        proud=proud,
        deep=deep,
        travel=travel,
        preload=preload,
        force=force,
        damping=damping,
        effort=effort,
        icon=icon,
        ink=ink or controls.ink_on(finish),
        plate=plate,
        name=name,
    )


@_checked
def dial(
    *,
    style: controls.DialStyle = "fluted",
    radius: ag.Scalar = 0.016,
    depth: ag.Scalar = 0.016,
    limits: tuple[ag.Scalar, ag.Scalar] | None = (-2.4, 2.4),
    friction: ag.Scalar | None = None,
    clicks: int = 0,
    torque: ag.Scalar = 0.04,
    scale: controls.DialScale | None = "ticks",
    count: int = 6,
    icons: tuple[str, ...] = (),
    finish: ag.Material = ag.MATERIALS["black_abs"],
    cap: ag.Material | None = ag.MATERIALS["aluminium"],
    ink: ag.Material | None = controls.DARK_INK,
    name: str = "dial",
) -> Fitting:
    """Make a dial: a knob that fingers turn, with its mark up at rest, and a scale printed around it.

    Knobs of appliances are 20-50 mm across; their switches and potentiometers turn through 270-300 degrees
    with 0.02-0.06 N m (`feel.DIAL`). A gap of 0.6 mm hides the shaft, so that no hole is cut.

    Args:
        style: Shape of the knob.
        radius: Radius of the knob [m].
        depth: Projection of the knob [m].
        limits: Range from the mark up, clockwise; None to turn without end [rad].
        friction: Its dry friction, by default that of `feel.DIAL` [N m].
        clicks: Number of detents from the lower to the upper limit; of a dial without limits, over 270
            degrees around the mark. 0 for none.
        torque: Greatest torque of its detents [N m].
        scale: Print around it, over its range; None for no print.
        count: Number of steps of the print.
        icons: Names of the icons of the scale "icons", clockwise.
        finish: Material of the knob.
        cap: Metal of the cap of the style "capped".
        ink: Material of the scale, which has to differ from the panel.
        name: Name of its link; its joint is `{name}_turn`.

    Examples:
        >>> panel = part(box(0.14, 0.012, 0.06).at(y=0.006), "panel", material("abs"))
        >>> heat = fittings.dial(style="bar", scale="band", limits=(0, 4.7), name="heat")
        >>> panel.install(fittings.dial(), at=(-0.035, 0, 0)).install(heat, at=(0.035, 0, 0))
    """
    if clicks < 0 or clicks == 1:
        raise BuildError(f"dial(..., clicks=...) is 0 or at least 2, got {clicks}\n  at {authors_line()}")
    low, high = limits or (-SWEEP / 2, SWEEP / 2)
    turn = controls.dial_turn(
        f"{name}_turn",
        low=low,
        high=high,
        friction=friction,
        endless=limits is None,
        clicks=[low + (high - low) * click / (clicks - 1) for click in range(clicks)],
        torque=torque,
    )
    around = None
    if scale is not None and ink is not None:
        around = controls.dial_print(
            radius, ink=ink, style=scale, count=count, icons=icons, sweep=high - low, start=low
        )
    return controls.dial(turn, style, radius, finish, depth=depth, cap=cap, scale=around, name=name)


@_checked
def bar_handle(
    *,
    length: ag.Scalar = 0.30,
    style: pulls.BarStyle = "round",
    projection: ag.Scalar = 0.045,
    girth: ag.Scalar = 0.008,
    level: bool = False,
    finish: ag.Material = _STEEL,
    name: str = "handle",
) -> Fitting:
    """Make a bar handle: 100-230 mm long on furniture, 300-700 mm on appliances (catalogs of handles).

    Fingers need 28 mm behind the bar on furniture (DIN 33402: fingers are at most 23 mm thick).

    Args:
        length: Overall length [m].
        style: A rod on posts, a square rod, a bent rod, a flat strap, a tube with caps, or a curved blade.
        projection: Distance from the face to the middle of the bar [m].
        girth: Half of the thickness of the bar [m].
        level: Whether it is horizontal.
        finish: Material.
        name: Name of its grasp.

    Examples:
        >>> door = part(box(0.25, 0.02, 0.4).at(y=0.01), "door", material("lacquered_mdf"))
        >>> door = door.install(fittings.bar_handle(), at=(-0.08, 0, 0))
        >>> door.install(fittings.bar_handle(style="bow").suffixed("_1"), at=(0.08, 0, 0))
    """
    made: ag.Body = pulls.bar_handle(
        length=length,
        finish=finish,
        style=style,
        level=level,
        name=name,
        overhang=ag.min_(0.045, 0.16 * length),
        projection=projection,
        girth=girth,
    )
    return Fitting(made)


@_checked
def pocket_handle(
    *,
    length: ag.Scalar = 0.30,
    lip: ag.Scalar = 0.013,
    gap: ag.Scalar = 0.022,
    deep: ag.Scalar = 0.030,
    finish: ag.Material = ag.MATERIALS["aluminium"],
    name: str = "handle",
) -> Fitting:
    """Make a pocket in the free edge of a door: fingers reach behind a lip from the side.

    The origin is on the edge between the face and the free edge, which faces +x. A gap of 22 mm takes the
    fingers of most hands (DIN 33402); the door must be thicker than lip and gap.

    Args:
        length: Length along z [m].
        lip: Thickness of the lip [m].
        gap: Width of the pocket behind the lip [m].
        deep: Depth of the pocket [m].
        finish: Material of the lining.
        name: Name of its grasp.

    Examples:
        >>> door = part(box(0.12, 0.04, 0.3).at(0.06, 0.02), "door", material("enamel_white"))
        >>> door.install(fittings.pocket_handle(length=0.2).mirror(X))
    """
    return pulls.pocket_grip(length, finish=finish, lip=lip, gap=gap, deep=deep, name=name)


@_checked
def recessed_handle(
    *,
    length: ag.Scalar = 0.26,
    width: ag.Scalar = 0.074,
    deep: ag.Scalar = 0.034,
    level: bool = False,
    finish: ag.Material = _STEEL,
    lining: ag.Material = ag.MATERIALS["black_abs"],
    name: str = "handle",
) -> Fitting:
    """Make a recess in a front with a blade in its middle, flush with the front, as the grip.

    The front must be thicker than the recess is deep.

    Args:
        length: Length of the recess [m].
        width: Width of the recess, with 30 mm for fingers at each side of the blade [m].
        deep: Depth of the recess [m].
        level: Whether it is horizontal.
        finish: Material of the blade and the rim.
        lining: Material of the recess.
        name: Name of its grasp.

    Examples:
        >>> door = part(box(0.3, 0.04, 0.4).at(y=0.02), "door", material("enamel_white"))
        >>> door.install(fittings.recessed_handle())
    """
    return pulls.recessed_grip(
        length, finish=finish, lining=lining, width=width, deep=deep, level=level, name=name
    )


@_checked
def knob(
    *,
    style: Literal["mushroom", "ball", "disc", "cone", "square"] = "mushroom",
    radius: ag.Scalar = 0.016,
    projection: ag.Scalar = 0.028,
    finish: ag.Material = ag.MATERIALS["brass"],
    name: str = "handle",
) -> Fitting:
    """Make a knob of a drawer or a cabinet; they are 27-36 mm across (catalogs of furniture fittings).

    Args:
        style: Shape of the head.
        radius: Radius of the head [m].
        projection: Distance from the face to the end [m].
        finish: Material.
        name: Name of its grasp.

    Examples:
        >>> front = part(box(0.25, 0.018, 0.12).at(y=0.009), "drawer", material("walnut"))
        >>> front = front.install(fittings.knob(), at=(-0.06, 0, 0))
        >>> front.install(fittings.knob(style="square").suffixed("_1"), at=(0.06, 0, 0))
    """
    made: ag.Body = pulls.knob_pull(
        finish=finish, name=name, style=style, radius=radius, projection=projection
    )
    return Fitting(made)


@_checked
def cup_pull(
    *,
    width: ag.Scalar = 0.070,
    height: ag.Scalar = 0.028,
    projection: ag.Scalar = 0.025,
    finish: ag.Material = ag.MATERIALS["brass"],
    name: str = "handle",
) -> Fitting:
    """Make a cup pull (bin pull): a quarter of a shell, open below; 64-73 mm suit a parallel gripper.

    Args:
        width: Overall width, at most 0.074 [m].
        height: Height above the origin [m].
        projection: Distance from the face to the lip [m].
        finish: Material.
        name: Name of its grasp.

    Examples:
        >>> front = part(box(0.2, 0.018, 0.1).at(y=0.009), "drawer", material("oak"))
        >>> front.install(fittings.cup_pull())
    """
    made: ag.Body = pulls.cup_pull(
        finish=finish, name=name, width=width, height=height, projection=projection
    )
    return Fitting(made)


@_checked
def edge_pull(
    *,
    length: ag.Scalar = 0.12,
    reach: ag.Scalar = 0.024,
    finish: ag.Material = ag.MATERIALS["aluminium"],
    name: str = "handle",
) -> Fitting:
    """Make an edge pull: a plate on the upper edge of a front that projects, with a rolled lip.

    The origin is on the edge between the face and the upper edge of the front.

    Args:
        length: Length along x [m].
        reach: Projection from the face [m].
        finish: Material.
        name: Name of its grasp.

    Examples:
        >>> front = part(box(0.25, 0.018, 0.12).at(0, 0.009, -0.06), "drawer", material("oak"))
        >>> front.install(fittings.edge_pull())
    """
    made: ag.Body = pulls.edge_pull(finish=finish, name=name, level=True, length=length, reach=reach)
    return Fitting(made)


@_checked
def lever_set(
    *,
    thickness: ag.Scalar = 0.040,
    style: Literal["straight", "bent", "wave"] = "straight",
    section: Literal["round", "flat"] = "round",
    length: ag.Scalar = 0.125,
    limit: ag.Scalar = 0.8,
    torque: ag.Scalar = 1.3,
    rose: Literal["round", "square"] = "round",
    finish: ag.Material = _NICKEL,
) -> Fitting:
    """Make a set of door levers: a lever on each face on one spindle, a return spring, roses, and the hole.

    The origin is on the spindle in the front of the leaf; the levers point to -x. The link is `handle`, its
    joint `handle_turn`. Springs give 1-1.5 N m at the full turn, and EN 1906 allows at most 2.4 N m.

    Args:
        thickness: Thickness of the leaf [m].
        style: Course of the levers.
        section: Section of the levers.
        length: Distance from the spindle to the tip [m].
        limit: Range of the turn [rad].
        torque: Torque of the spring at the full turn [N m].
        rose: Shape of the roses, 54 mm across.
        finish: Material.

    Examples:
        >>> leaf = part(box(0.26, 0.04, 0.3).at(y=0.02), "door", material("oak"))
        >>> leaf.install(fittings.lever_set(), at=(0.07, 0, 0))
    """
    handle: ag.Body = door_handles.lever_handle(
        thickness=thickness,
        rose_depth=_ROSE,
        finish=finish,
        style=style,
        section=section,
        length=length,
        projection=0.050,
        girth=0.0095,
    )
    return _on_spindle(handle, thickness, limit, torque, rose, finish)


@_checked
def knob_set(
    *,
    thickness: ag.Scalar = 0.040,
    style: Literal["ball", "flat", "tulip", "egg"] = "ball",
    radius: ag.Scalar = 0.027,
    lock: Literal["none", "turn", "push"] = "none",
    limit: ag.Scalar = 0.8,
    torque: ag.Scalar = 0.6,
    rose: Literal["round", "square"] = "round",
    finish: ag.Material = _NICKEL,
) -> Fitting:
    """Make a set of door knobs on one spindle, with a return spring, roses, and the hole.

    The origin is on the spindle in the front of the leaf. The link is `handle`, its joint `handle_turn`; a
    privacy lock is the link `lock`. Knobs are 50-57 mm across (ANSI/BHMA A156.2); two fingers turn 0.6 N m.

    Args:
        thickness: Thickness of the leaf [m].
        style: Shape of the knobs.
        radius: Radius of the knobs [m].
        lock: Privacy lock in the front knob: none, a small knob, or a pin.
        limit: Range of the turn [rad].
        torque: Torque of the spring at the full turn [N m].
        rose: Shape of the roses, 54 mm across.
        finish: Material.

    Examples:
        >>> leaf = part(box(0.18, 0.04, 0.2).at(y=0.02), "door", material("oak"))
        >>> leaf.install(fittings.knob_set(lock="turn"))
    """
    handle: ag.Body = door_handles.knob_handle(
        thickness=thickness,
        rose_depth=_ROSE,
        finish=finish,
        lock=lock,
        style=style,
        radius=radius,
        projection=0.064,
    )
    return _on_spindle(handle, thickness, limit, torque, rose, finish)


def _on_spindle(
    handle: ag.Body,
    thickness: ag.Scalar,
    limit: ag.Scalar,
    torque: ag.Scalar,
    rose: Literal["round", "square"],
    finish: ag.Material,
) -> Fitting:
    """Put handles of both faces on their roses, with the return spring."""
    roses = locks.rose(thickness=thickness, depth=_ROSE, across=0.054, finish=finish, style=rose)
    turn = door_handles.spring_turn(limit=limit, preload=0.55 * torque, torque=torque)
    fitting = Fitting.moving(handle, turn, fixed=roses, cut=locks.spindle_hole(thickness))
    return fitting.at(0.0, thickness / 2)


@_checked
def latch(
    *,
    throw: ag.Scalar = 0.011,
    preload: ag.Scalar = 2.5,
    force: ag.Scalar = 6.0,
    finish: ag.Material = _NICKEL,
    name: str = "latch",
) -> Fitting:
    """Make a tubular latch for the edge of a door: a sprung bolt in a plate of 23 by 57 mm.

    The face of the host is the edge of the door; the bolt is slanted towards -x, for closing. Bolts project
    by 10-13 mm; EN 12209 allows 50 N to close a door with its latch.

    Args:
        throw: Projection of the bolt [m].
        preload: Force of the spring at rest [N].
        force: Force that presses the bolt home [N].
        finish: Material.
        name: Name of the link, and first part of the name of its joint, `{name}_slide`.

    Examples:
        >>> edge = part(box(0.04, 0.08, 0.12).at(y=0.04), "door", material("oak"))
        >>> edge.install(fittings.latch())
    """
    slide = ag.Prismatic(
        f"{name}_slide",
        axis=-ag.X,
        limits=(0.0, throw),
        spring=ag.Spring(preload=preload, force=force),
        feel=feel.LATCH,
    )
    press = ag.frame((throw, -0.0045, 0.0), approach=-ag.X, closing=ag.Z)  # on its blunt nose
    bolt = locks.latch_bolt(backset=0.0, throw=throw, finish=finish, push=[press], name=name)
    plate = locks.faceplate(backset=0.0, finish=finish)
    pocket = locks.latch_pocket(backset=0.0, throw=throw)
    return Fitting.moving(bolt, slide, fixed=plate, cut=pocket).rotate(ag.Z, -math.pi / 2)


@_checked
def deadbolt(
    *, thickness: ag.Scalar = 0.040, backset: ag.Scalar = 0.060, finish: ag.Material = _NICKEL
) -> Fitting:
    """Make a deadbolt: a thumb turn on the front throws the bolt out of the edge at the right.

    The origin is on the axis of the turn in the front of the leaf. The links are `lock` and `deadbolt`; the
    bolt follows `lock_turn`. Its throw is 25 mm, the least of ANSI/BHMA A156.5; its detent takes 0.12 N m.

    Args:
        thickness: Thickness of the leaf [m].
        backset: Distance from the axis to the edge, 60 or 70 mm [m].
        finish: Material.

    Examples:
        >>> leaf = part(box(0.15, 0.04, 0.15).at(-0.015, 0.02), "door", material("oak"))
        >>> leaf.install(fittings.deadbolt())
    """
    turn = locks.thumb_turn_joint()
    plate = locks.faceplate(backset=backset, finish=finish, bolt="deadbolt")
    body = ag.weld(locks.deadbolt_cover(thickness=thickness, finish=finish), plate)
    body = body.attach(locks.thumb_turn(thickness=thickness, finish=finish), turn)
    body = body.attach(locks.deadbolt(backset=backset, finish=finish), locks.deadbolt_slide(turn))
    cut = locks.deadbolt_pocket(backset=backset) | locks.deadbolt_hole(thickness)
    return Fitting(body, cut).at(0.0, thickness / 2)


@_checked
def cam_lock(
    *, thickness: ag.Scalar = 0.018, finish: ag.Material = ag.MATERIALS["chrome"], name: str = "lock"
) -> Fitting:
    """Make a cam lock of furniture with its key: a turn of 90 degrees swings the cam behind the panel.

    Cylinders are 16-19 mm across, their cams 25-40 mm long; a key turns them with some 0.1 N m (catalogs).

    Args:
        thickness: Thickness of the panel [m].
        finish: Material.
        name: Name of its link; its joint is `{name}_turn`.

    Examples:
        >>> door = part(box(0.1, 0.018, 0.1).at(y=0.009), "door", material("oak"))
        >>> door.install(fittings.cam_lock())
    """
    radius, back = 0.0085, thickness + 0.005
    cam = ag.box(0.014, 0.0025, 0.040, bevel=0.0006).at(0.0, back + 0.0010, -0.012)
    solids, hold = locks.inserted_key(back, radius=radius)
    key = ag.part([*solids, cam], "lock", finish, name=name, grasp=hold)
    turn = ag.Revolute(f"{name}_turn", axis=ag.Y, limits=(0.0, math.pi / 2), feel=feel.DETENT)
    collar = ag.extrude(ag.ring(0.0115, radius + 0.0004), 0.0018, axis=ag.Y, bevel=0.0005).at(y=-0.0006)
    cut = ag.bore(radius + FIT.sliding, 2 * thickness + 0.02, axis=ag.Y).at(y=thickness / 2)
    return Fitting.moving(key, turn, fixed=ag.detail(collar, "cylinder", finish), cut=cut)


@_checked
def hinge(
    leaf: ag.Body | None = None,
    *,
    levels: Sequence[ag.Scalar] = (0.0,),
    height: ag.Scalar = 0.076,
    radius: ag.Scalar = 0.0050,
    depth: ag.Scalar = 0.026,
    limit: ag.Scalar = 1.9,
    finish: ag.Material = _STEEL,
    name: str = "leaf",
) -> Fitting:
    """Make butt hinges between a host at x < 0 and a leaf at x > 0 with its front flush at y = 0.

    The plates are screwed on both fronts, and the knuckles lie in a slot that is cut out of both. The leaf
    opens towards -y. Hinges of 60-100 mm carry doors of 10-40 kg (EN 1935); friction is that of
    `feel.HINGE`.

    Args:
        leaf: The leaf at its closed place; by default the moving plates alone, as the link `hinge_{name}`.
        levels: Heights of the middles of the hinges [m].
        height: Length of a hinge along z [m].
        radius: Radius of the knuckles [m].
        depth: Width of a plate beside the knuckles [m].
        limit: Range of the leaf [rad].
        finish: Material.
        name: First part of the name of the joint, `{name}_hinge`.

    Examples:
        >>> frame = part(box(0.08, 0.03, 0.3).at(-0.042, 0.015), "frame", material("oak"))
        >>> door = part(box(0.2, 0.03, 0.3).at(0.102, 0.015), "door", material("walnut"))
        >>> frame.install(fittings.hinge(door, levels=(-0.09, 0.09), name="door"))
    """
    out = 0.0026 + _SUNK  # distance of the pin from the fronts: the plates lie behind it
    moving, fixed = (
        half(height=height, radius=radius, depth=depth, finish=finish, levels=levels)
        .rotate(ag.Z, quarter * math.pi / 2)
        .mirror(ag.X)
        .at(y=-out)
        for half, quarter in ((fixings.hinge_leaf, 1), (fixings.hinge_frame, -1))
    )
    slot = ag.Region.centered(2 * radius, 0.0, height).grow(x=0.0006, z=0.0006, front=0.002)
    slot = slot.grow(back=radius - out + 0.0006)
    cut = ag.array(slot.box(), at=[(0.0, 0.0, level) for level in levels])
    moving = moving.suffixed(f"_{name}") if leaf is None else ag.weld(leaf.cut(cut), moving)
    swing = ag.Revolute(
        f"{name}_hinge", axis=-ag.Z, pivot=(0.0, -out, 0.0), limits=(0.0, limit), feel=feel.HINGE
    )
    return Fitting(ag.weld(Fitting.moving(moving, swing).body, fixed), cut)


@_checked
def foot(
    *,
    style: fixings.FootStyle = "levelling",
    radius: ag.Scalar = 0.018,
    height: ag.Scalar = 0.030,
    finish: ag.Material = ag.MATERIALS["black_abs"],
) -> Fitting:
    """Make a foot of furniture or of an appliance; turn it by `rotate(X, pi / 2)` for an underside.

    Pads are 10-20 mm across; leveling feet of appliances have discs of 30-40 mm and 10-20 mm of thread.

    Args:
        style: A rubber pad, a rounded knob, or a disc on a leveling screw.
        radius: Radius [m].
        height: Height below the face [m].
        finish: Material.

    Examples:
        >>> board = part(box(0.14, 0.018, 0.07).at(y=0.009), "case", material("oak"))
        >>> pad = fittings.foot(style="pad", radius=0.012, height=0.008)
        >>> board.install(fittings.foot(), at=(-0.03, 0, 0)).install(pad, at=(0.03, 0, 0))
    """
    body = fixings.feet([(0.0, 0.0)], radius=radius, height=height, style=style, finish=finish)
    return Fitting(body.at(z=-height).rotate(ag.X, -math.pi / 2))


@_checked
def caster(
    *,
    radius: ag.Scalar = 0.025,
    width: ag.Scalar = 0.020,
    swivel: bool = True,
    finish: ag.Material = ZINC,
    tread: ag.Material = ag.MATERIALS["rubber"],
    name: str = "caster",
) -> Fitting:
    """Make a caster: a plate, a fork that swivels, and a wheel; `rotate(X, pi / 2)` for an underside.

    Casters of furniture and equipment have wheels of 40-75 mm (EN 12529, EN 12530). They swivel and roll
    without limits, with a rolling resistance of at most a fiftieth of their load (`feel.CASTER`). The height
    from the face to the floor is 2 * radius + 0.0155.

    Args:
        radius: Radius of the wheel [m].
        width: Width of the wheel [m].
        swivel: Whether the fork swivels; otherwise it is fixed, and rolls along z.
        finish: Metal of plate and fork.
        tread: Material of the wheel.
        name: Links are `{name}_fork` and `{name}_wheel`, joints `{name}_swivel` and `{name}_roll`.

    Examples:
        >>> board = part(box(0.09, 0.018, 0.09).at(y=0.009), "cart", material("plywood"))
        >>> board.install(fittings.caster())
    """
    return fixings.caster(radius=radius, width=width, swivel=swivel, finish=finish, tread=tread, name=name)


@_checked
def drawer_runners(
    drawer: ag.Body | None = None,
    *,
    width: ag.Scalar = 0.36,
    height: ag.Scalar = 0.14,
    length: ag.Scalar = 0.30,
    travel: ag.Scalar = 0.22,
    finish: ag.Material = ZINC,
    wood: ag.Material = ag.MATERIALS["oak"],
    name: str = "drawer",
) -> Fitting:
    """Make a pair of ball-bearing runners in an opening, with the drawer on them.

    The opening is cut about the origin; the drawer pulls out towards -y. Runners are 45 mm high and take
    12.7 mm at each side; 2-5 N move a drawer of 5 kg, and EN 15338 allows 50 N (`feel.RUNNER`).

    Args:
        drawer: The drawer at its closed place, 25.4 mm narrower than the opening behind its front; by default
            a box with a front and a knob.
        width: Width of the opening [m].
        height: Height of the opening [m].
        length: Length of the runners [m].
        travel: Extension, at most three quarters of the length [m].
        finish: Material of the runners.
        wood: Material of the default drawer.
        name: Name of the default drawer; the joint is `{name}_slide`.

    Examples:
        >>> case = part(box(0.44, 0.018, 0.2).at(y=0.009), "case", material("walnut"))
        >>> case.install(fittings.drawer_runners())
    """
    hole = ag.Region.centered(width, 0.0, height)
    front, space = 0.018, FIT.runner
    if drawer is None:
        face = hole.shrink(x=FIT.reveal, z=FIT.reveal, y=0).grow(back=front).box(bevel=0.001)
        tray = open_box(width - 2 * space, length, height - 0.03, wall=0.012, front=0.012)
        tray = [board.at(0.0, front - _SUNK, 0.012 - height / 2) for board in tray]
        handle = knob(name=f"{name}_handle")
        drawer = ag.part([face, *tray], "drawer", wood, name=name).install(handle)
    run = hole.with_(y=(front + 0.004, front + length)).with_(z=(-0.0225, 0.0225))
    side = run.with_(x=(width / 2 - 0.0062, width / 2 + _SUNK)).box(bevel=0.0008)
    rail = run.with_(x=(width / 2 - space - _SUNK, width / 2 - 0.0068)).shrink(z=0.006).box(bevel=0.0008)
    slide = ag.Prismatic(f"{name}_slide", axis=-ag.Y, limits=(0.0, travel), feel=feel.RUNNER)
    moving = ag.weld(drawer, ag.part([rail, rail.mirror(ag.X)], "runner", finish))
    fixed = ag.part([side, side.mirror(ag.X)], "runner", finish, separate="the case is between the runners")
    cut = hole.grow(front=0.01, back=length + 0.05).box()
    return Fitting.moving(moving, slide, fixed=fixed, cut=cut)


@_checked
def display(
    text: str = "12:30", *, width: ag.Scalar = 0.060, height: ag.Scalar = 0.024, color: Color = "cyan"
) -> Fitting:
    """Make a display of seven-segment figures on a pane, which is only seen.

    Figures of appliances are 10-20 mm high: legible from 2-4 m (ISO 9241: 20 minutes of arc).

    Args:
        text: Digits, letters of seven segments, colons and points; known while building.
        width: Width of the pane [m].
        height: Height of the pane [m].
        color: Color of the figures, or `lcd` for black on grey.

    Examples:
        >>> panel = part(box(0.12, 0.012, 0.06).at(y=0.006), "panel", material("black_abs"))
        >>> panel.install(fittings.display("18:45", color="green"))
    """
    return Fitting(details.display(text, width, height, color=color))


@_checked
def logo(
    brand: str = "Norvik",
    *,
    height: ag.Scalar = 0.008,
    style: Literal["printed", "raised"] = "raised",
    finish: ag.Material = ag.MATERIALS["chrome"],
) -> Fitting:
    """Make the name of a maker, as raised letters or as print; `details.BRANDS` lists invented names.

    Args:
        brand: The name; known while building.
        height: Height of the capital letters, 3-10 mm on appliances [m].
        style: Letters of 0.8 mm on the face, or ink.
        finish: Material of the letters; print is dark by default.

    Examples:
        >>> panel = part(box(0.16, 0.012, 0.05).at(y=0.006), "panel", material("enamel_white"))
        >>> panel.install(fittings.logo("Norvik"))
    """
    word = details.logo(brand, height)
    if style == "printed":
        ink = controls.DARK_INK if finish == ag.MATERIALS["chrome"] else finish
        return Fitting(details.printed(word, material=ink))
    return Fitting(details.raised(word, material=finish, proud=0.0008))
