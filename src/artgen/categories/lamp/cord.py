"""The cord of a lamp, with the switch on it: it leaves the base at the back and lies on the floor."""

from dataclasses import dataclass

import artgen as ag
from artgen.categories.lamp.switches import Switch
from artgen.categories.shared.appliances.cords import CORD, strain_relief

CASE = (0.034, 0.080, 0.024)
"""Width, length and height of a case on the cord [m]."""

_TAIL = 0.21  # of the cord behind its switch [m]
_ALONE = 0.15  # farther back that a cord without one ends [m]


@dataclass(frozen=True)
class Cord:
    """Where a cord runs."""

    finish: ag.Material  # what cord and case are made of
    start: ag.Scalar  # where it leaves the base, along y [m]
    end: ag.Scalar  # where its switch lies [m]
    height: ag.Scalar  # of its outlet [m]
    # how far it goes straight back at first; from high up it bends down in a wider arc [m]
    stiff: ag.Scalar = 0.022

    def alone(self) -> ag.Body:
        """Make the cord without a switch."""
        return cord_run(
            self.start,
            self.end + _ALONE,
            height=self.height,
            finish=self.finish,
            sway=0.04,
            stiff=self.stiff,
        )

    def with_case(self, switched: Switch) -> ag.Body:
        """Make the cord with a switch in a case."""
        half = CASE[1] / 2.0
        near, far = self.end - half + 0.002, self.end + half
        return ag.weld(
            cord_case(switched, self.finish).at(0.0, self.end, 0.0),
            cord_run(self.start, near, height=self.height, finish=self.finish, stiff=self.stiff),
            cord_run(far, far + _TAIL, height=0.010, finish=self.finish, sway=0.03),
        )


def cord_case(switched: Switch, finish: ag.Material) -> ag.Body:
    """Make the case of a switch on a cord: it lies on the floor about the origin, the cord runs along y."""
    wide, long, high = CASE
    block = ag.box(wide, long, high - 0.001, bevel=0.005).at(0.0, 0.0, (high + 0.001) / 2.0)
    if switched.hole is not None:
        block = block - switched.hole.at(0.0, 0.0, high)
    seam = ag.box(wide - 0.004, long - 0.004, 0.0012)
    foot = ag.box(wide - 0.010, long - 0.012, 0.002, bevel=0.0006).at(0.0, 0.0, 0.001)
    joined = "its cord, which is only seen, joins it to the base"
    return ag.weld(
        ag.part(block, "switch", finish, separate=joined),
        ag.part(foot, "switch", finish),
        ag.detail(seam.at(0.0, 0.0, 0.009), "switch", finish),
        switched.body.at(0.0, 0.0, high),
    )


def cord_run(
    start: ag.Scalar,
    end: ag.Scalar,
    *,
    height: ag.Scalar,
    finish: ag.Material,
    sway: ag.Scalar = 0.0,
    stiff: ag.Scalar = 0.022,
) -> ag.Body:
    """Make a cord that leaves a base at the back, at y = start, and lies on the floor up to y = end."""
    run = end - start
    path = ag.bezier(  # which stays above the floor, as its control points do
        [
            (0.0, start - 0.004, height),
            (0.0, start + stiff, height - 0.001),
            (1.2 * sway, start + 0.022 + 0.30 * (run - 0.022), CORD),
            (3.0 * sway, start + 0.022 + 0.50 * (run - 0.022), CORD),
            (-3.0 * sway, start + 0.022 + 0.75 * (run - 0.022), CORD),
            (0.0, end, CORD),
        ]
    )
    return ag.weld(
        *(ag.detail(each.at(0.0, start, height), "cord", finish) for each in strain_relief()),
        ag.detail(ag.sweep(ag.circle(CORD - 0.0002), path), "cord", finish),
    )
