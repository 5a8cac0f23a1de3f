"""Parts that hoods share: grease filters on catches, lamps, keys, chimneys.

A filter drops on its hinge when its catch is pushed back.
"""

import functools
import operator
from collections.abc import Sequence
from typing import Literal, NamedTuple

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.shared import controls
from artgen.categories.shared.appliances import DARK, filled
from artgen.categories.shared.finish import casting
from artgen.nodes.fitting import Fitting

TAB = 0.022
"""Height of the underside of a hood above the lower end of its catches [m]."""

Mesh = Literal["mesh", "baffle", "slots"]
"""Face of a filter: woven mesh in a frame, baffles, or a plate with slots."""

_THICK = 0.009  # thickness of a filter [m]
_DEEP = 0.040  # depth of its bay [m]
_GAP = 0.0016  # gap around a filter [m]
_BEHIND = 0.0030  # gap behind it [m]
_AXLE = 0.006  # distance of the hinge from its rear edge [m]
_REACH = 0.0042  # how far its bolt reaches over the lip [m]
_PULL = 0.006  # travel of its catch [m]
_OPEN = 1.35  # angle of an open filter [rad]
_BOLT = ag.material("stainless").with_(name="filter_catch", texture="")
_FALL = feel.Feel(friction=0.08, damping=0.08, armature=2e-3, effort=8.0)
_ICONS = ("power", "minus", "plus", "timer", "light")


class Look(NamedTuple):
    """Finishes of a hood, and its controls."""

    finish: ag.Material
    metal: ag.Material
    mesh: Mesh
    knob: bool
    maker: str

    @property
    def ink(self) -> ag.Material:
        """Return the print on the finish."""
        return controls.ink_on(self.finish)


def with_filters(hood: ag.Body, room: ag.Region, look: Look, count: int) -> ag.Body:
    """Put filters into the underside of a hood."""
    for number, bay in enumerate(_bays(room, count)):
        hood = hood.install(_filter(bay, look.mesh, ag.material("brushed_aluminium"), number))
    return hood


def _bays(room: ag.Region, count: int) -> list[ag.Region]:
    """Divide the underside of a hood into the bays of its filters."""
    return [each.with_(z=(room.z.low, room.z.low + _DEEP)) for each in room.columns(count, gap=0.012)]


def _filter(bay: ag.Region, mesh: Mesh, metal: ag.Material, number: int) -> Fitting:
    """Make a filter in its bay, in place, with its catch and the hole that both need.

    Links are `filter_0` and `catch_0`, joints `filter_hinge_0` and `catch_slide_0`.
    """
    low, tail = bay.z.low, f"_{number}"
    plate = bay.shrink(x=_GAP, front=_GAP, back=_BEHIND).with_(z=(low, low + _THICK))
    x = plate.x.mid
    channel = ag.Region(
        (x - 0.0094, x + 0.0094), (plate.y.low - 0.01, plate.y.low + 0.036), (low - 0.001, low + 0.01)
    )
    bolt = ag.Region(
        (x - 0.0080, x + 0.0080),
        (plate.y.low - _GAP - _REACH, plate.y.low + 0.026),
        (low + 0.0032, low + 0.0072),
    )
    stem = bolt.with_(y=(plate.y.low + 0.012, plate.y.low + 0.018), z=(low - 0.0035, low + 0.005))
    tab = ag.Region(
        (x - 0.022, x + 0.022), (plate.y.low + 0.010, plate.y.low + 0.0165), (low - TAB, low - 0.0018)
    ).box(bevel=0.002)
    catch = ag.part(
        [tab, bolt.box(), stem.box()], "catch", _BOLT, name="catch", push=ag.push_on(tab, direction=ag.Y)
    )
    slide = ag.Prismatic(
        "catch_slide", axis=ag.Y, limits=(0, _PULL), spring=ag.Spring(preload=2.5, force=6.0),
        feel=feel.SWITCH, armature=0.05, effort=30.0,
    )  # fmt: skip
    leaf = ag.part(plate.box(bevel=0.0012) - channel.box(), "filter", casting(metal, 0.25), name="filter")
    leaf = ag.weld(leaf, *_face(plate, mesh, metal)).attach(catch, slide)
    axle = (x, plate.y.high - _AXLE, low + _THICK / 2)
    hinge = ag.Revolute(
        "filter_hinge", axis=ag.X, pivot=axle, limits=(0, _OPEN), feel=_FALL, driven="its weight",
        needs=(slide > 0.9 * _PULL).until(0.06).beyond(0.0005 / plate.y.size),
    )  # fmt: skip
    pocket = bolt.with_(y=(plate.y.low - _GAP - _REACH - 0.0012, bay.y.low + 0.01)).grow(
        x=0.0014, z=0.0008, top=0.03
    )
    cut = bay.grow(bottom=0.01).box() | pocket.box()
    return Fitting.moving(leaf, hinge, cut=cut.paint(DARK)).suffixed(tail)


def _face(plate: ag.Region, mesh: Mesh, metal: ag.Material) -> list[ag.Body]:
    """Print the openings of a filter on its lower side."""
    wide, deep = plate.x.size - 0.030, plate.y.size - 0.086
    at = (plate.x.mid, plate.y.mid + 0.026, plate.z.low)
    if mesh == "mesh":
        sheet = ag.rectangle(wide, deep, radius=0.006)
        film = details.printed(
            sheet, at, material=ag.material("mesh").with_(name="filter_mesh"), facing=-ag.Z, label="mesh"
        )
        edge = details.printed(
            ag.rectangle(wide + 0.006, deep + 0.006, radius=0.008) - sheet,
            at,
            material=DARK,
            facing=-ag.Z,
            label="mesh",
        )
        return [film, edge]
    count = 11 if mesh == "baffle" else 21
    slot = details.vent_slots(wide, deep, count, slot=0.42 * wide / count)
    return [details.printed(slot, at, material=DARK, facing=-ag.Z, label="mesh")]


LAMP = ag.material("led_white").with_(name="hood_lamp")
"""Lens of the lamps."""


def lamps(
    points: Sequence[tuple[ag.Scalar, ag.Scalar]], level: ag.Scalar, metal: ag.Material
) -> list[ag.Body]:
    """Make round lamps in the underside, which are only seen."""
    discs, rings = (
        functools.reduce(operator.or_, [outline.at(-x, y) for x, y in points])
        for outline in (ag.circle(0.024), ag.ring(0.030, 0.024))
    )
    return [
        details.printed(shape, (0, 0, level), material=stuff, facing=-ag.Z, label="lamp")
        for shape, stuff in ((discs, LAMP), (rings, metal))
    ]


def with_keys(
    hood: ag.Body, look: Look, at: ag.VectorLike, *, count: int = 5, width: float = 0.013
) -> ag.Body:
    """Put a row of round keys on a front."""
    for number, x in enumerate(controls.places(count, 0.026)):
        key = controls.push_button(
            finish=look.metal, through=0.0125, width=0.013, proud=0.004, deep=0.008, icon=_ICONS[number % 5],
            ink=controls.ink_on(look.metal), plate=look.metal,
        )  # fmt: skip
        hood = hood.install(key.suffixed(f"_{number}").at(x, 0, 0), at=at)
    power, less, more, timer, *light = (signals.pressed(f"button_slide_{number}") for number in range(count))
    runs = signals.toggle(power) | signals.timer(timer, 300.0)
    hood = hood.output("fan", runs & ~signals.latest([less, more], [0.6, 0.0]), kind="flow")
    if not light:
        return hood
    return hood.output("light", signals.toggle(light[0]), kind="light", material=LAMP)


def name_of(look: Look, at: ag.VectorLike, ink: ag.Material | None = None) -> ag.Body:
    """Print the maker on a front."""
    return details.printed(details.logo(look.maker, 0.007), at, material=ink or look.ink)


def duct(
    plan: ag.Region, look: Look, low: ag.Scalar, y: ag.Scalar, deep: float, wide: float = 0.28
) -> ag.Body:
    """Make a chimney in two sections, with outlets at its upper sides."""
    top, seam = plan.z.high, low + 0.58 * (plan.z.high - low)
    lower = ag.Region((-wide / 2, wide / 2), (y - deep / 2, y + deep / 2), (low - 0.002, seam))
    upper = lower.shrink(x=0.0016, front=0.0016).with_(z=(seam - 0.004, top))
    slots = details.vent_slots(0.12, 0.034, 5, slot=0.004, direction="horizontal")
    films = [
        details.printed(
            slots,
            (side * (wide / 2 - 0.0016), y, top - 0.05),
            material=DARK,
            facing=side * ag.X,
            label="chimney",
        )
        for side in (-1, 1)
    ]
    stuff = filled(look.finish, 115.0, "duct")
    return ag.weld(ag.part([lower.box(bevel=0.0015), upper.box(bevel=0.0015)], "chimney", stuff), *films)
