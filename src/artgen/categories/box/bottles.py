"""Bottles in the cells of a wine box, which a hand lifts out by their necks."""

import functools
import operator
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import artgen as ag

Wine = Literal["red", "white", "rose"]

_FULL = 1450.0  # 0.5 kg of glass and 0.75 l of wine: 1.25 kg in the 0.86 l of the facets [kg/m3]
_RADIUS, _NECK = 0.0372, 0.0142  # radii of the body and the neck of a Bordeaux bottle [m]
_BODY, _SHOULDER, _TALL = 0.192, 0.226, 0.300  # heights of the ends of body and shoulder, and of the top [m]
_GRAVITY = 9.81  # gravity [m/s2]
_SPARE = 0.0025  # least gap above a bottle [m]
_DEEP = 0.1  # largest gap below a lid: a hand reaches the neck, and the lift takes the bottle out [m]
_TOO_DEEP = "a hand cannot reach bottles of 0.3 m in so deep a box: lower height"
_NO_ROOM = "bottles of 0.3 m would collide with the lid over them: raise height, or take a thinner flute"


def _glass(name: str, color: tuple[float, float, float]) -> ag.Material:
    return ag.material("black_glass").with_(name=f"{name}_bottle", base_color=color, density=_FULL)


_GLASS = {
    "red": _glass("green", (0.012, 0.026, 0.012)),
    "white": _glass("yellow_green", (0.16, 0.20, 0.05)),
    "rose": _glass("pink", (0.52, 0.18, 0.13)),
}
_FOIL = {
    "red": ag.colored("abs", "burgundy"),
    "white": ag.colored("abs", "mustard"),
    "rose": ag.colored("abs", "silver"),
}


@dataclass(frozen=True)
class Bottles:
    """Bottles of a wine box."""

    wine: Wine  # kind of wine
    columns: int  # number of cells along x
    rows: int  # number of cells along y
    cell: ag.Scalar  # side length of a cell [m]
    floor: ag.Scalar  # height of the surface below the bottles [m]
    # height of the lower face of the lid, or of the minor flaps above some of the bottles [m]
    ceiling: ag.Scalar
    higher: ag.Scalar = 0.0  # height of the major flaps above the minor ones [m]

    def under(self, lid: ag.Joint, angle: float, body: ag.Body) -> ag.Body:
        """Put a bottle into each cell; its lift is free while the lid is open beyond an angle [rad]."""
        needs = [lid > angle] * (self.columns * self.rows)
        return self._put(body, needs, [self.ceiling] * len(needs))

    def below(self, flaps: Sequence[ag.Joint], angle: float, body: ag.Body) -> ag.Body:
        """Put a bottle into each cell; its lift is free while the flaps above it are open beyond an angle."""
        needs, ceilings = [], []
        for row in range(self.rows):
            for column in range(self.columns):
                far = (row, self.rows - 1 - row, column, self.columns - 1 - column)
                over = [
                    flap > angle
                    for flap, cells in zip(flaps, far, strict=True)
                    if cells + 0.08 < self.rows / 2.0
                ]
                needs.append(functools.reduce(operator.and_, over))
                by_minor = min(far[2:]) + 0.08 < self.rows / 2.0
                ceilings.append(self.ceiling if by_minor else self.ceiling + self.higher)
        return self._put(body, needs, ceilings)

    def _put(self, body: ag.Body, needs: Sequence[ag.Condition], ceilings: Sequence[ag.Scalar]) -> ag.Body:
        bottle, low = self._bottle(), self.floor + 0.0006
        body = body.require(self.ceiling - low >= _TALL + _SPARE, _NO_ROOM)
        body = body.require(self.ceiling + self.higher - low <= _TALL + _DEEP, _TOO_DEEP)
        effort = 1.03 * _GRAVITY * bottle.mass() + 0.3  # the lifting force opens no flap
        for number, (need, ceiling) in enumerate(zip(needs, ceilings, strict=True)):
            row, column = divmod(number, self.columns)
            x = self.cell * (column - (self.columns - 1) / 2.0)
            y = self.cell * (row - (self.rows - 1) / 2.0)
            slide = ag.Prismatic(
                f"bottle_lift_{number}",
                axis=ag.Z,
                limits=(0.0, 0.32),
                friction=0.3,
                damping=3.0,
                effort=effort,
                velocity=1.0,
                needs=need.beyond(ceiling - low - _TALL - 0.002),
            )
            body = body.attach(bottle.at(x, y, low).suffixed(f"_{number}"), slide)
        return body

    def _bottle(self) -> ag.Body:
        """Make a bottle with its bottom at the origin."""
        glass, foil = _GLASS[self.wine], _FOIL[self.wine].with_(name=f"{self.wine}_foil", texture="")
        body = ag.cylinder_between((0.0, 0.0, 0.0), (0.0, 0.0, _BODY), _RADIUS, bevel=0.004)
        shoulder = ag.frustum(_RADIUS, _NECK + 0.003, _SHOULDER - _BODY + 0.004).at(
            0.0, 0.0, (_SHOULDER + _BODY) / 2.0 - 0.003
        )
        neck = ag.cylinder_between((0.0, 0.0, _SHOULDER - 0.004), (0.0, 0.0, _TALL), _NECK, bevel=0.001)
        across = ag.X if self.rows == 1 else ag.Y  # an open lid is behind a single row
        # a hull of few facets just under the round surface carries the weight and collides
        core = ag.extrude(ag.regular_polygon(12, _RADIUS - 0.0001), _BODY).at(0.0, 0.0, _BODY / 2.0)
        stem = ag.extrude(ag.regular_polygon(12, _NECK - 0.0001), _TALL - _BODY + 0.01)
        stem = stem.at(0.0, 0.0, (_TALL + _BODY - 0.01) / 2.0)
        hold = ag.grasp_on(stem, approach=-ag.Z, closing=across, depth=0.010)
        paper = ag.colored("abs", "cream").with_(name="wine_label", texture="", specular_roughness=0.7)
        sleeve = ag.tube(_NECK + 0.0003, _NECK - 0.001, 0.052).at(0.0, 0.0, _TALL - 0.0257)
        around = ag.tube(_RADIUS + 0.0002, _RADIUS - 0.001, 0.085).at(0.0, 0.0, 0.082)
        return ag.weld(
            ag.part(core | stem, "bottle", glass, grasp=hold),
            *(ag.detail(each, "bottle", glass) for each in (body, shoulder, neck)),
            ag.detail(sleeve, "bottle", foil),
            ag.detail(around, "bottle", paper),
        )
