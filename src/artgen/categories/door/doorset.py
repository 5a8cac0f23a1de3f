"""Door sets: one leaf, or an active and an inactive leaf, in their frame.

All sets are built with the hinges of the (active) leaf at the left, opening towards the viewer (-y); the
other hand and doors that open away are mirror images.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Literal

import artgen as ag
from artgen.categories.door.fittings import astragal
from artgen.categories.door.frame import Hanging
from artgen.categories.door.lockset import Lockset, Site
from artgen.categories.shared.fronts import Blank

_ROD = 0.010  # width of the square bolt [m]
_PLAY = 0.0004  # gap around the bolt in the leaf [m]
_STEM = (0.006, 0.012)  # width and height of the link between a bolt and its slide [m]
_BELOW = 0.420  # distance of the slide below the top of the leaf, within reach of a hand [m]
_GRASP = 0.012  # engagement of the bolt in the head [m]
_PLATE = (0.024, 0.0018, 0.075)  # width, thickness and height of the cover around the slide [m]


def throw(gap: ag.Scalar) -> ag.Scalar:
    """Return the length of the bolt outside the leaf at rest [m]."""
    return gap + _GRASP


def flush_bolt_slide(gap: ag.Scalar, *, name: str = "flush_bolt_slide") -> ag.Joint:
    """Make the joint of the bolt: 0 is thrown, positive is drawn down; friction carries the weight."""
    # 1 mm beyond flush
    return ag.Prismatic(
        name, axis=-ag.Z, limits=(0.0, throw(gap) + 0.001), friction=12.0, damping=20.0, effort=100.0
    )


@ag.generator
def flush_bolt(*, thickness: ag.Float, gap: ag.Float, finish: ag.Material) -> ag.Body:
    """Make the bolt with its thumb slide: the link `flush_bolt`."""
    long = _BELOW + 0.012 + throw(gap)
    rod = ag.box(_ROD, _ROD, long, bevel=0.001).at(0.0, 0.0, throw(gap) - long / 2.0)
    face = thickness / 2.0 + _PLATE[1]
    stem = ag.box(_STEM[0], face + 0.002, _STEM[1]).at(0.0, -(face + 0.002) / 2.0, -_BELOW)
    thumb = ag.box(0.018, 0.010, 0.024, bevel=0.003).at(0.0, -(face + 0.0055), -_BELOW)
    # 1 mm less than the height of the slide
    hold = ag.grasp_on(thumb, approach=ag.Y, closing=ag.X, depth=0.009)
    return ag.part(ag.union(rod, stem, thumb), "flush_bolt", finish, grasp=hold)


def flush_bolt_channel(thickness: ag.Scalar, gap: ag.Scalar) -> ag.Solid:
    """Make the cutter for the bolt's channel and the slot of its slide in the leaf."""
    long = _BELOW + 0.012 + throw(gap) + 0.007  # 4 mm out of the leaf, 2 mm below the drawn bolt
    channel = ag.box(_ROD + 2 * _PLAY, _ROD + 2 * _PLAY, long).at(0.0, 0.0, 0.004 - long / 2.0)
    return channel | _slot(thickness / 2.0 + 0.004, gap)


def _slot(reach: ag.Scalar, gap: ag.Scalar) -> ag.Solid:
    tall = _STEM[1] + throw(gap) + 0.003
    return ag.box(_STEM[0] + 2 * _PLAY, reach, tall).align(
        (0.0, 0.0, -_BELOW + _STEM[1] / 2.0 + 0.001), y=1.0, z=1.0
    )


def flush_bolt_pocket(gap: ag.Scalar) -> ag.Solid:
    """Make the cutter for the hole of the thrown bolt in the head; the leaf has a play of 0.7 mm."""
    deep = throw(gap) + 0.004
    pocket = ag.box(_ROD + 0.004, _ROD + 0.0007 + 0.002, deep - gap + 0.002)
    return pocket.align((0.0, -_ROD / 2.0 - 0.0007, deep), y=-1.0, z=1.0)


@ag.generator
def flush_bolt_plate(*, thickness: ag.Float, gap: ag.Float, finish: ag.Material) -> ag.Body:
    """Make the cover around the slide, which is welded to the leaf, with the label `faceplate`."""
    wide, thick, tall = _PLATE
    middle = -_BELOW - throw(gap) / 2.0
    plate = ag.box(wide, thick, tall, bevel=0.0004).at(0.0, -(thickness / 2.0 + thick / 2.0 - 0.0004), middle)
    screws = [
        ag.detail(
            ag.cylinder(0.003, 0.0008, axis=ag.Y, bevel=0.0002).at(
                0.0, -(thickness / 2.0 + thick - 0.0004), place
            ),
            "screw",
            finish,
        )
        for place in (middle - tall / 2.0 + 0.006, middle + tall / 2.0 - 0.006)
    ]
    cover = plate - _slot(thickness / 2.0 + 0.004, gap)
    return ag.weld(ag.detail(cover, "faceplate", finish), *screws)  # thin, behind the slide


Hand = Literal["left", "right"]
"""Hinge side of the (active) leaf."""

Opens = Literal["towards", "away"]
"""Direction of opening: the viewer pulls or pushes."""

_HALF_OPEN = 0.42
"""Opening angle of either leaf of a pair beyond which both clear each other [rad]."""


def handed(body: ag.Body, hand: Hand, opens: Opens) -> ag.Body:
    """Turn or mirror a door with hinges at the left that opens towards the viewer."""
    if opens == "towards":
        return body.mirror(ag.X) if hand == "right" else body
    return body.rotate(ag.Z, math.pi) if hand == "right" else body.mirror(ag.Y)


@dataclass(frozen=True)
class DoorSet:
    """Parts of a door."""

    surround: Callable[..., ag.Body]  # function that makes the frame, with `jamb_cut` or `head_cut`
    leaf: Callable[..., ag.Body]  # function that makes a leaf of a blank
    blank: Blank  # dimensions of a leaf
    hanging: Hanging  # hinges of a leaf
    lockset: Lockset  # hardware of the (active) leaf
    needs: ag.Dependency | None  # condition under which that leaf may open

    def single(self) -> ag.Body:
        """Make a door of one leaf in its frame."""
        lockset = self.lockset
        cut = ag.union(*lockset.strike_cuts) if lockset.strike_cuts else None
        frame = ag.weld(self.surround(jamb_cut=cut), self.hanging.on_frame(), *lockset.strikes)
        panel = _moving(self._fixed(lockset), lockset)
        return frame.attach(panel, self.hanging.joint("door_hinge", needs=self.needs))

    def double(self, site: Site, hand: Hand) -> ag.Body:
        """Make a door with the active leaf at the left and the inactive leaf, which has a flush bolt."""
        blank, hanging, lockset = self.blank, self.hanging, self.lockset
        other = "right" if hand == "left" else "left"
        # the flush bolt has the same gap to the head as the leaf to the jambs
        thickness, gap = blank.thickness, hanging.gap
        middle = (blank.width + site.gap) / 2.0
        active = _moving(self._fixed(lockset).suffixed(f"_{hand}"), lockset)

        # in the frame of the inactive leaf, which is modeled like the active leaf and mirrored into place
        opposite = [body.mirror(ag.X).at(blank.width + site.gap, 0.0, 0.0) for body in lockset.strikes]
        pockets = [solid.mirror(ag.X).at(blank.width + site.gap, 0.0, 0.0) for solid in lockset.strike_cuts]
        rod = (blank.width / 2.0 - 0.05, 0.0, blank.top)  # in the middle of a stile, behind the strikes
        slide = flush_bolt_slide(gap)
        held = Lockset(
            cuts=(flush_bolt_channel(thickness, gap).at(rod), *pockets),
            fixed=(
                flush_bolt_plate(thickness=thickness, gap=gap, finish=site.finish).at(rod),
                astragal(blank, site.gap),
                *opposite,
            ),
            moving=((flush_bolt(thickness=thickness, gap=gap, finish=site.finish).at(rod), slide),),
        )
        inactive = replace(self, blank=replace(blank, fittings=blank.fittings.bare()))
        second_leaf = _moving(inactive._fixed(held).suffixed(f"_{other}"), held).mirror(ag.X)

        in_head = (middle - rod[0], 0.0, blank.top)
        hung = hanging.on_frame().at(-middle)
        frame = ag.weld(self.surround(head_cut=flush_bolt_pocket(gap).at(in_head)), hung, hung.mirror(ag.X))
        first = hanging.joint(f"door_hinge_{hand}", middle=-middle, needs=self.needs)
        # the inactive leaf can open after the active leaf has cleared it
        free = ((slide > throw(gap)) & (first > _HALF_OPEN)).until(_HALF_OPEN)
        second = hanging.joint(f"door_hinge_{other}", middle=middle, side=-1, needs=free)
        frame = frame.attach(active.at(-middle), first)
        return frame.attach(second_leaf.at(middle), second)

    def _fixed(self, lockset: Lockset) -> ag.Body:
        """Make a leaf with all its fixed parts."""
        cut = ag.union(*lockset.cuts) if lockset.cuts else None
        return ag.weld(self.leaf(blank=replace(self.blank, cut=cut)), self.hanging.on_leaf(), *lockset.fixed)


def _moving(panel: ag.Body, lockset: Lockset) -> ag.Body:
    """Attach the moving parts of a leaf."""
    for body, joint in lockset.moving:
        panel = panel.attach(body, joint)
    return panel
