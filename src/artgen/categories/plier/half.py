"""A half of pliers with all that is on it, and what both halves are made with."""

import math
from dataclasses import dataclass

import artgen as ag
from artgen._arrays import cached_property
from artgen.categories.plier.fittings import (
    Grip,
    Key,
    cutting_edge,
    grip_inlay,
    hold_on,
    jaw_face,
    leaf_spring,
    pipe_lining,
    pivot_hole,
    rivet,
    sleeve_end,
    sleeve_thickness,
    sleeved,
)
from artgen.categories.plier.halves import Forging

_RIVET = 0.36  # radius of a rivet, in radii of the lap
_PLAY = 0.0003  # of a rivet in its hole [m]


@dataclass(frozen=True)
class Make:
    """What pliers are made with."""

    forging: Forging  # the measures of their halves
    teeth: int  # teeth on the flat of a jaw; 0 for plain jaws
    steel: ag.Material  # of the halves
    grip: Grip  # what is on their handles
    sleeve: ag.Material  # its material
    inlay: ag.Material  # of its soft part
    width: ag.Scalar  # of the bars of the handles, in the plane of the tool [m]
    thick: ag.Float  # of these bars [m]
    sprung: bool  # whether a leaf spring opens them
    key: Key | None  # the keyed bolt of slip-joint pliers; None for a rivet

    def lower(self) -> ag.Body:
        """Make the half whose jaw is at the right, with its plate below: the link `body`."""
        pivot = [] if self.key else rivet(self.forging, _RIVET * self.forging.lap, self.steel)
        return ag.weld(self._half("body", over=False), *pivot)

    def upper(self) -> ag.Body:
        """Make the half whose jaw is at the left, with its plate on top: the link `jaw`."""
        pivot = self.key.bolt(self.forging, self.steel) if self.key else []
        return ag.weld(self._half("jaw", over=True), *pivot).rotate(ag.Y, math.pi)

    def rests(self) -> ag.Float:
        """Return how far the middle of the tool lies above the table [m]."""
        nut = 0.0020 if self.key else 0.0
        return ag.max_(sleeve_thickness(self.grip, self.thick) / 2.0, self.forging.thick / 2.0 + nut)

    def middle(self) -> ag.Float:
        """Return the middle of the lower half, x [m]."""
        left, right = self._lower.anchor(x=-1.0).x, self._lower.anchor(x=1.0).x
        if self.grip != "bare":
            left = ag.min_(left, self._sleeve.anchor(x=-1.0).x)
        return (left + right) / 2.0

    @cached_property
    def _bar(self) -> ag.Solid:
        """The steel of a handle."""
        return self.forging.handle_solid(self.width, self.thick, hidden=self.grip != "bare")

    @cached_property
    def _sleeve(self) -> ag.Solid:
        """What is on it."""
        return sleeved(self.forging, self.grip, self.width, self.thick)

    @cached_property
    def _sleeve_end(self) -> ag.Body:
        """Its round end, as it is seen."""
        return sleeve_end(self.forging, self.grip, self.width, self.thick, self.sleeve)

    @cached_property
    def _forged(self) -> ag.Solid:
        """What is the same in both halves."""
        return ag.union(self.forging.jaw_solid(), *self.forging.shoulders(), self._bar)

    @cached_property
    def _lower(self) -> ag.Solid:
        """The steel of the lower half."""
        return self._forged | self.forging.plate(self.key.slot() if self.key else None)

    @cached_property
    def _upper(self) -> ag.Solid:
        """That of the other half, before it is turned over."""
        hole = None if self.key else pivot_hole(_RIVET * self.forging.lap + _PLAY)
        return self._forged | self.forging.plate(hole)

    def _half(self, label: str, *, over: bool) -> ag.Body:
        """Make a half as it is drawn, its jaw at the right, without its pivot."""
        forging, solid = self.forging, self._upper if over else self._lower
        if self.grip == "bare":
            hold = hold_on(forging, self._bar, self.thick, over=over)
            bodies = [ag.part(solid, label, self.steel, grasp=hold)]
        else:
            tall = sleeve_thickness(self.grip, self.thick)
            hold = hold_on(forging, self._sleeve, tall, over=over)
            name = "upper_grip" if over else "lower_grip"
            bodies = [
                ag.part(solid, label, self.steel),
                ag.part(self._sleeve, "grip", self.sleeve, name=name, grasp=hold),
                self._sleeve_end,
            ]
        if self.grip == "two_component":
            bodies.append(grip_inlay(forging, self.width, self.thick, self.inlay, over=over))
        if not forging.keen:
            bodies.append(jaw_face(forging, self.teeth, self.steel, phase=-1 if over else 1))
        if forging.head.pipe[1]:
            bodies.append(pipe_lining(forging, self.steel))
        if forging.head.cuts[1] and not forging.keen:
            bodies.append(cutting_edge(forging, self.steel))
        if self.sprung:
            bodies.append(leaf_spring(forging, ag.material("stainless"), width=self.width))
        return ag.weld(*bodies)
