"""Locksets: handle, latch and deadbolt, with their cutouts in the leaf and their parts in the jamb."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen.categories.door.fittings import pull_handle, push_bar_case, push_slide
from artgen.categories.shared.door_handles import spring_turn
from artgen.categories.shared.finish import recess
from artgen.categories.shared.locks import (
    DEADBOLT,
    LATCH_HOLE,
    THROW,
    Fixing,
    deadbolt,
    deadbolt_cover,
    deadbolt_hole,
    deadbolt_pocket,
    deadbolt_slide,
    faceplate,
    latch_bolt,
    latch_pocket,
    latch_slide,
    rose,
    spindle_hole,
    strike_plate,
    strike_pocket,
    thumb_turn,
    thumb_turn_joint,
)

HandleKind = Literal["lever", "knob", "push_bar", "pull", "none"]

_RELEASE = 0.85
"""Share of the range of a handle at which its latch is fully drawn."""

_PLATE = 0.22
"""Height of long plates [m]."""

_DRAWN = 0.02
"""Angle of its turn below which a deadbolt is inside its leaf [rad]."""


@dataclass(frozen=True)
class Site:
    """Position of a lockset on a leaf with its middle plane at y = 0 and its lock edge at the right."""

    spindle: ag.Vector  # intersection of the spindle and the middle plane [m]
    backset: ag.Scalar  # distance from the spindle to the lock edge [m]
    thickness: ag.Scalar  # thickness of the leaf [m]
    gap: ag.Scalar  # gap between the leaf and the parts that its bolts enter [m]
    finish: ag.Material  # metal of all visible parts
    mark: str = ""  # name of the maker


@dataclass(frozen=True)
class Roses:
    """Covers of the hole for the spindle of a handle."""

    style: Literal["round", "square", "plate"]  # round or square roses, or long plates
    across: ag.Scalar  # width of a rose [m]
    depth: ag.Scalar  # height of a rose above the leaf [m]
    fixing: Fixing = "hidden"  # fixing of a rose
    keyed: bool = False  # whether a plate has a key cylinder


@dataclass(frozen=True)
class Lockset:
    """Parts of a lock, and the cutters for them."""

    cuts: tuple[ag.Solid, ...] = ()  # cutters of the leaf
    fixed: tuple[ag.Body, ...] = ()  # parts welded to the leaf
    moving: tuple[tuple[ag.Body, ag.Joint], ...] = ()  # moving parts of the leaf, with their joints
    strikes: tuple[ag.Body, ...] = ()  # parts welded to the jamb
    strike_cuts: tuple[ag.Solid, ...] = ()  # cutters of the jamb
    free: tuple[ag.Condition, ...] = ()  # conditions under which the closed leaf may open

    def __add__(self, other: "Lockset") -> "Lockset":
        """Combine the parts of both."""
        return Lockset(
            self.cuts + other.cuts,
            self.fixed + other.fixed,
            self.moving + other.moving,
            self.strikes + other.strikes,
            self.strike_cuts + other.strike_cuts,
            self.free + other.free,
        )


def latch(
    site: Site, leader: ag.Joint, *, throw: ag.Scalar, release: ag.Scalar, through: bool = False
) -> Lockset:
    """Make a latch that a handle draws."""
    at, backset, finish = site.spindle, site.backset, site.finish
    strike = strike_plate(backset=backset, gap=site.gap, throw=throw, thickness=site.thickness, finish=finish)
    return Lockset(
        cuts=(latch_pocket(backset=backset, throw=throw, through=through).paint(recess(finish)).at(at),),
        fixed=(faceplate(backset=backset, finish=finish, mark=site.mark).at(at),),
        moving=(
            (
                latch_bolt(backset=backset, throw=throw, finish=finish).at(at),
                latch_slide(leader, throw=throw, release=release),
            ),
        ),
        strikes=(strike.at(at),),
        strike_cuts=(strike_pocket(backset=backset, gap=site.gap, throw=throw).paint(recess(finish)).at(at),),
        free=(leader > release,),
    )


def turning_handle(
    site: Site,
    handle: Callable[..., ag.Body],
    *,
    limit: ag.Scalar,
    torque: ag.Scalar,
    throw: ag.Scalar,
    roses: Roses,
) -> Lockset:
    """Make a lever or knob on its roses, with the latch that it draws."""
    at, thickness, finish = site.spindle, site.thickness, site.finish
    turn = spring_turn(limit=limit, pivot=at, preload=0.55 * torque, torque=torque)
    covers = rose(
        thickness=thickness,
        depth=roses.depth,
        across=roses.across,
        finish=finish,
        style=roses.style,
        height=_PLATE,
        fixing=roses.fixing,
        keyed=roses.keyed,
    )
    moving = handle(thickness=thickness, rose_depth=roses.depth, finish=finish)
    fitted = Lockset(
        cuts=(spindle_hole(thickness, height=LATCH_HOLE).paint(recess(finish)).at(at),),
        fixed=(covers.at(at),),
        moving=((moving.at(at), turn),),
    )
    return fitted + latch(site, turn, throw=throw, release=_RELEASE * limit, through=True)


def pushed_handle(
    site: Site, bar: Callable[..., ag.Body], *, width: ag.Scalar, travel: ag.Scalar, throw: ag.Scalar
) -> Lockset:
    """Make a push bar on the face away from the opening side, a pull on the other face, and the latch."""
    at, thickness, finish = site.spindle, site.thickness, site.finish
    length = width - 0.15
    push = push_slide(travel=travel)
    moving = bar(thickness=thickness, length=length, travel=travel, finish=finish)
    outside = pull_handle(
        thickness=thickness,
        finish=finish,
        faces="front",
        style="U",
        length=0.22,
        projection=0.05,
        girth=0.0095,
    )
    fixed = (push_bar_case(thickness=thickness, length=length, finish=finish).at(at), outside.at(at))
    return Lockset(fixed=fixed, moving=((moving.at(at), push),)) + latch(
        site, push, throw=throw, release=_RELEASE * travel
    )


def rigid_handle(site: Site, handle: Callable[..., ag.Body]) -> Lockset:
    """Make a pull or finger plates, with a roller catch in the jamb instead of a latch."""
    at, backset, finish = site.spindle, site.backset, site.finish
    plate = ag.box(0.0008, 0.0235, 0.057, bevel=0.0002).at(backset, 0.0, 0.0)
    roller = ag.cylinder(0.006, 0.014, bevel=0.001).at(backset - 0.0045, 0.0, 0.0)
    catch = ag.weld(ag.detail(plate, "faceplate", finish), ag.detail(roller, "latch", finish))
    return Lockset(fixed=(handle(thickness=site.thickness, finish=finish).at(at), catch.at(at)))


def dead_lock(site: Site) -> Lockset:
    """Make a deadbolt with a thumb turn in front and a key cylinder at the back."""
    at, backset, thickness, finish = site.spindle, site.backset, site.thickness, site.finish
    turn = thumb_turn_joint(pivot=at)
    strike = strike_plate(
        backset=backset, gap=site.gap, throw=THROW, thickness=thickness, finish=finish, bolt="deadbolt"
    )
    return Lockset(
        cuts=(
            deadbolt_pocket(backset=backset).paint(recess(finish)).at(at),
            deadbolt_hole(thickness).paint(recess(finish)).at(at),
        ),
        fixed=(
            faceplate(backset=backset, finish=finish, bolt="deadbolt").at(at),
            deadbolt_cover(thickness=thickness, finish=finish).at(at),
        ),
        moving=(
            (thumb_turn(thickness=thickness, finish=finish).at(at), turn),
            (deadbolt(backset=backset, finish=finish).at(at), deadbolt_slide(turn)),
        ),
        strikes=(strike.at(at),),
        strike_cuts=(
            strike_pocket(backset=backset, gap=site.gap, throw=THROW, bolt=DEADBOLT)
            .paint(recess(finish))
            .at(at),
        ),
        free=(turn < _DRAWN,),
    )
