"""Locksets: handle, latch and deadbolt, with their cutouts in the leaf and their parts in the jamb."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import partial, reduce
from operator import and_
from typing import Any

import artgen as ag
from artgen.categories.door import fittings
from artgen.categories.shared import locks
from artgen.categories.shared.door_handles import spring_turn
from artgen.categories.shared.finish import recess
from artgen.categories.shared.fronts import Blank

_RELEASE = 0.85
"""Share of the range of a handle at which its latch is fully drawn."""

_DRAWN = 0.02
"""Angle of its turn below which a deadbolt is inside its leaf [rad]."""


@dataclass
class Lockset:
    """The hardware of a leaf with its middle plane at y = 0 and its lock edge at the right."""

    spindle: ag.Vector  # intersection of the spindle and the middle plane [m]
    backset: ag.Scalar  # distance from the spindle to the lock edge [m]
    thickness: ag.Scalar  # thickness of the leaf [m]
    gap: ag.Scalar  # gap between the leaf and the parts that its bolts enter [m]
    finish: ag.Material  # metal of all visible parts
    throw: ag.Scalar  # travel of the latch [m]
    maker: str  # name on the faceplate
    cuts: list[ag.Solid] = field(default_factory=list)  # cutters of the leaf
    fixed: list[ag.Body] = field(default_factory=list)  # parts welded to the leaf
    moving: list[tuple[ag.Body, ag.Joint]] = field(default_factory=list)  # moving parts of the leaf
    strikes: list[ag.Body] = field(default_factory=list)  # parts welded to the jamb
    strike_cuts: list[ag.Solid] = field(default_factory=list)  # cutters of the jamb
    conditions: list[ag.Condition] = field(default_factory=list)  # under which the closed leaf may open

    def leaf_with(self, leaf: Callable[..., ag.Body], blank: Blank, *fixed: ag.Body, suffix: str) -> ag.Body:
        """Make a leaf with this hardware and other fixed parts."""
        body = leaf(blank=replace(blank, cut=united(self.cuts, self.finish)))
        body = ag.weld(body, *fixed, *self.fixed)
        body = body.suffixed(suffix) if suffix else body
        for part, joint in self.moving:
            body = body.attach(part, joint)
        return body

    def free(self, until: ag.Scalar) -> ag.Dependency | None:
        """Return the condition under which the closed leaf may open, up to an angle [rad]."""
        return reduce(and_, self.conditions).until(until) if self.conditions else None

    def turning_handle(
        self,
        handle: Callable[..., ag.Body],
        limit: ag.Scalar,
        torque: ag.Scalar,
        depth: ag.Scalar,
        **roses: Any,
    ) -> None:
        """Add a lever or knob on roses of a height, with the latch that it draws."""
        at, thickness, finish = self.spindle, self.thickness, self.finish
        turn = spring_turn(limit=limit, pivot=at, preload=0.55 * torque, torque=torque)
        self.cuts.append(locks.spindle_hole(thickness, height=locks.LATCH_HOLE).at(at))
        cover = locks.rose(thickness=thickness, depth=depth, finish=finish, height=0.22, **roses)
        self.fixed.append(cover.at(at))
        self.moving.append((handle(thickness=thickness, rose_depth=depth, finish=finish).at(at), turn))
        self._latch(turn, _RELEASE * limit, through=True)

    def pushed_handle(self, bar: Callable[..., ag.Body], width: ag.Scalar, travel: ag.Scalar) -> None:
        """Add a push bar on the face away from the opening side, a pull on the other face, and the latch."""
        at, thickness, finish, length = self.spindle, self.thickness, self.finish, width - 0.15
        push = fittings.push_slide(travel=travel)
        pull = partial(fittings.pull_handle, style="U", length=0.22, projection=0.05, girth=0.0095)
        outside = pull(thickness=thickness, finish=finish, faces="front")
        case = fittings.push_bar_case(thickness=thickness, length=length, finish=finish)
        self.fixed += [case.at(at), outside.at(at)]
        moving = bar(thickness=thickness, length=length, travel=travel, finish=finish)
        self.moving.append((moving.at(at), push))
        self._latch(push, _RELEASE * travel)

    def rigid_handle(self, handle: Callable[..., ag.Body]) -> None:
        """Add a pull or finger plates, with a roller catch in the jamb instead of a latch."""
        at, backset, finish = self.spindle, self.backset, self.finish
        plate = ag.box(0.0008, 0.0235, 0.057, bevel=0.0002).at(backset)
        roller = ag.cylinder(0.006, 0.014, bevel=0.001).at(backset - 0.0045)
        catch = ag.weld(ag.detail(plate, "faceplate", finish), ag.detail(roller, "latch", finish))
        self.fixed += [handle(thickness=self.thickness, finish=finish).at(at), catch.at(at)]

    def _latch(self, leader: ag.Joint, release: ag.Scalar, *, through: bool = False) -> None:
        """Add a latch that a handle draws."""
        at, backset, finish, throw = self.spindle, self.backset, self.finish, self.throw
        self.cuts.append(locks.latch_pocket(backset=backset, throw=throw, through=through).at(at))
        self.fixed.append(locks.faceplate(backset=backset, finish=finish, mark=self.maker).at(at))
        bolt = locks.latch_bolt(backset=backset, throw=throw, finish=finish)
        self.moving.append((bolt.at(at), locks.latch_slide(leader, throw=throw, release=release)))
        self._strike(at, throw, "latch", locks.LATCH)
        self.conditions.append(leader > release)

    def dead_lock(self, above: ag.Scalar) -> None:
        """Add a deadbolt above the spindle, with a thumb turn in front and a key cylinder at the back."""
        at, backset = self.spindle + (0.0, 0.0, above), self.backset
        thickness, finish = self.thickness, self.finish
        turn = locks.thumb_turn_joint(pivot=at)
        pocket = locks.deadbolt_pocket(backset=backset)
        self.cuts += [pocket.at(at), locks.deadbolt_hole(thickness).at(at)]
        plate = locks.faceplate(backset=backset, finish=finish, bolt="deadbolt")
        cover = locks.deadbolt_cover(thickness=thickness, finish=finish)
        self.fixed += [plate.at(at), cover.at(at)]
        bolt = locks.deadbolt(backset=backset, finish=finish).at(at)
        self.moving.append((locks.thumb_turn(thickness=thickness, finish=finish).at(at), turn))
        self.moving.append((bolt, locks.deadbolt_slide(turn)))
        self._strike(at, locks.THROW, "deadbolt", locks.DEADBOLT)
        self.conditions.append(turn < _DRAWN)

    def _strike(self, at: ag.Vector, throw: ag.Scalar, name: locks.BoltName, bolt: locks.Bolt) -> None:
        backset, gap, thickness, finish = self.backset, self.gap, self.thickness, self.finish
        plate = locks.strike_plate(
            backset=backset, gap=gap, throw=throw, thickness=thickness, finish=finish, bolt=name
        )
        self.strikes.append(plate.at(at))
        self.strike_cuts.append(locks.strike_pocket(backset=backset, gap=gap, throw=throw, bolt=bolt).at(at))


def united(cuts: list[ag.Solid], finish: ag.Material) -> ag.Solid | None:
    """Return one cutter with the dark faces of a recess; None without cutters."""
    return ag.union(*cuts).paint(recess(finish)) if cuts else None
