"""Door sets: one leaf, or an active and an inactive one, hung in their frame.

All are built with the hinges of the (active) leaf at the left, opening towards the viewer (-y); other hands
and doors that open away are mirror images.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Literal

from artgen import Body, Dependency, X, Y, Z, union, weld
from artgen.categories.door import flush_bolt as bolts
from artgen.categories.door.hanging import Hanging
from artgen.categories.door.lockset import Lockset, Site
from artgen.categories.door.plates import astragal
from artgen.categories.shared.furniture.door_slab import Blank

Hand = Literal["left", "right"]
"""The side of the hinges of the (active) leaf."""

Opens = Literal["towards", "away"]
"""Whether the viewer pulls or pushes."""

_HALF_OPEN = 0.42
"""Two leaves are out of each other's way when either stands further open than this [rad]."""


def handed(body: Body, hand: Hand, opens: Opens) -> Body:
    """Turn or mirror the door with hinges at the left that opens towards the viewer into another one."""
    if opens == "towards":
        return body.mirror(X) if hand == "right" else body
    return body.rotate(Z, math.pi) if hand == "right" else body.mirror(Y)


@dataclass(frozen=True)
class DoorSet:
    """What a door is put together of."""

    surround: Callable[..., Body]  # makes the frame, given `jamb_cut` or `head_cut`
    leaf: Callable[..., Body]  # makes a leaf of a blank
    blank: Blank  # the measures of a leaf
    hanging: Hanging  # its hinges
    lockset: Lockset  # what the (active) leaf has
    needs: Dependency | None  # where that leaf may open

    def single(self) -> Body:
        """Hang one leaf in its frame."""
        lockset = self.lockset
        cut = union(*lockset.strike_cuts) if lockset.strike_cuts else None
        frame = weld(self.surround(jamb_cut=cut), self.hanging.on_frame(), *lockset.strikes)
        panel = _moving(self._fixed(lockset), lockset)
        return frame.attach(panel, self.hanging.joint("door_hinge", needs=self.needs))

    def double(self, site: Site, hand: Hand) -> Body:
        """Hang the active leaf at the left and the inactive one, which a flush bolt holds, at the right."""
        blank, hanging, lockset = self.blank, self.hanging, self.lockset
        other = "right" if hand == "left" else "left"
        thickness, gap = blank.thickness, hanging.gap  # the flush bolt's gap to the head is that to the jambs
        middle = (blank.width + site.gap) / 2.0
        active = _moving(self._fixed(lockset).suffixed(f"_{hand}"), lockset)

        # seen from the inactive leaf, which is drawn like the active one and mirrored into place
        opposite = [body.mirror(X).at(blank.width + site.gap, 0.0, 0.0) for body in lockset.strikes]
        pockets = [solid.mirror(X).at(blank.width + site.gap, 0.0, 0.0) for solid in lockset.strike_cuts]
        rod = (blank.width / 2.0 - 0.05, 0.0, blank.top)  # in the middle of a stile, behind the strikes
        slide = bolts.flush_bolt_slide(gap)
        held = Lockset(
            cuts=(bolts.flush_bolt_channel(thickness, gap).at(rod), *pockets),
            fixed=(
                bolts.flush_bolt_plate(thickness=thickness, gap=gap, finish=site.finish).at(rod),
                astragal(blank, site.gap),
                *opposite,
            ),
            moving=((bolts.flush_bolt(thickness=thickness, gap=gap, finish=site.finish).at(rod), slide),),
        )
        inactive = replace(self, blank=replace(blank, fittings=blank.fittings.bare()))
        second_leaf = _moving(inactive._fixed(held).suffixed(f"_{other}"), held).mirror(X)

        in_head = (middle - rod[0], 0.0, blank.top)
        hung = hanging.on_frame().at(-middle)
        frame = weld(self.surround(head_cut=bolts.flush_bolt_pocket(gap).at(in_head)), hung, hung.mirror(X))
        first = hanging.joint(f"door_hinge_{hand}", middle=-middle, needs=self.needs)
        # the inactive leaf follows once the active one is out of its way
        free = ((slide > bolts.throw(gap)) & (first > _HALF_OPEN)).until(_HALF_OPEN)
        second = hanging.joint(f"door_hinge_{other}", middle=middle, side=-1, needs=free)
        frame = frame.attach(active.at(-middle), first)
        return frame.attach(second_leaf.at(middle), second)

    def _fixed(self, lockset: Lockset) -> Body:
        """Make a leaf with everything that is fixed on it."""
        cut = union(*lockset.cuts) if lockset.cuts else None
        return weld(self.leaf(blank=replace(self.blank, cut=cut)), self.hanging.on_leaf(), *lockset.fixed)


def _moving(panel: Body, lockset: Lockset) -> Body:
    """Attach what moves on a leaf."""
    for body, joint in lockset.moving:
        panel = panel.attach(body, joint)
    return panel
