"""A half of pliers with all that is on it, and what both halves are made with."""

import math
from dataclasses import dataclass

from artgen import Body, Float, Material, Scalar, Solid, Y, material, max_, min_, part, union, weld
from artgen.categories.parts.plier_fittings import (
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
    sleeve_thickness,
    sleeved,
)
from artgen.categories.parts.plier_halves import Forging

_RIVET = 0.36  # radius of a rivet, in radii of the lap
_PLAY = 0.0003  # of a rivet in its hole [m]


@dataclass(frozen=True)
class Make:
    """What pliers are made with.

    Attributes:
        forging: The measures of their halves.
        teeth: Teeth on the flat of a jaw; 0 for plain jaws.
        steel: Of the halves.
        grip: What is on their handles.
        sleeve: Its material.
        inlay: Of its soft part.
        width: Of the bars of the handles, in the plane of the tool [m].
        thick: Of these bars [m].
        sprung: Whether a leaf spring opens them.
        key: The keyed bolt of slip-joint pliers; None for a rivet.
    """

    forging: Forging
    teeth: int
    steel: Material
    grip: Grip
    sleeve: Material
    inlay: Material
    width: Scalar
    thick: Float
    sprung: bool
    key: Key | None

    def lower(self) -> Body:
        """Make the half whose jaw is at the right, with its plate below: the link `body`."""
        pivot = [] if self.key else rivet(self.forging, _RIVET * self.forging.lap, self.steel)
        return weld(self._half("body", over=False), *pivot)

    def upper(self) -> Body:
        """Make the half whose jaw is at the left, with its plate on top: the link `jaw`."""
        pivot = self.key.bolt(self.forging, self.steel) if self.key else []
        return weld(self._half("jaw", over=True), *pivot).rotate(Y, math.pi)

    def rests(self) -> Float:
        """Return how far the middle of the tool lies above the table [m]."""
        nut = 0.0020 if self.key else 0.0
        return max_(sleeve_thickness(self.grip, self.thick) / 2.0, self.forging.thick / 2.0 + nut)

    def middle(self) -> Float:
        """Return the middle of the lower half, x [m]."""
        solid = self._bare(over=False)
        left, right = solid.anchor(x=-1.0).x, solid.anchor(x=1.0).x
        if self.grip != "bare":
            left = min_(left, sleeved(self.forging, self.grip, self.width, self.thick).anchor(x=-1.0).x)
        return (left + right) / 2.0

    def _bare(self, *, over: bool) -> Solid:
        """Make the steel of a half."""
        forging = self.forging
        if self.key:
            hole = None if over else self.key.slot()
        else:
            hole = pivot_hole(_RIVET * forging.lap + _PLAY) if over else None
        handle = forging.handle_solid(self.width, self.thick)
        return union(forging.jaw_solid(), *forging.shoulders(), forging.plate(hole), handle)

    def _half(self, label: str, *, over: bool) -> Body:
        """Make a half as it is drawn, its jaw at the right, without its pivot."""
        forging, solid = self.forging, self._bare(over=over)
        if self.grip == "bare":
            bar = forging.handle_solid(self.width, self.thick)
            bodies = [part(solid, label, self.steel, grasp=hold_on(forging, bar, self.thick, over=over))]
        else:
            sleeve = sleeved(forging, self.grip, self.width, self.thick)
            tall = sleeve_thickness(self.grip, self.thick)
            hold = hold_on(forging, sleeve, tall, over=over)
            name = "upper_grip" if over else "lower_grip"
            bodies = [
                part(solid, label, self.steel),
                part(sleeve, "grip", self.sleeve, name=name, grasp=hold),
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
            bodies.append(leaf_spring(forging, material("stainless"), width=self.width))
        return weld(*bodies)
