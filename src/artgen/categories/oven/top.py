"""The top of a range: gas burners under grates that lift off, or glass with its zones."""

from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details
from artgen._arrays import cached_property
from artgen.categories.oven.space import LAP, TOP, UNDER, Space
from artgen.categories.shared.appliances import DARK, filled
from artgen.categories.shared.controls import ink_on
from artgen.categories.shared.cooktops import (
    ALUMINIUM,
    BRASS,
    ZONE_RADIUS,
    Plan,
    gas_burner,
    grates,
    induction_zone,
    printed_zones,
    radiant_zone,
)

BurnerKind = Literal["gas", "radiant", "induction"]
"""Gas flames, radiant heaters under glass, or induction coils under glass."""

_EDGE = 0.020  # distance from the edges of the top to the field of the burners [m]
_VENT = 0.046  # distance from the back edge to that field, for the steam outlet of the oven [m]
_GLASS = 0.005
_LIP = 0.12  # depth of the hollow front edge [m]


@dataclass(frozen=True)
class TopPlan(Plan):
    """A plan whose burners fill the top except for its border: the dials are on the panel."""

    @cached_property
    def field(self) -> tuple[ag.Scalar, ag.Scalar, ag.Scalar, ag.Scalar]:
        """Positions of the left, right, front and back of the field of the burners [m]."""
        x, y = self.width / 2.0 - _EDGE, self.depth / 2.0
        return (-x, x, _EDGE - y, y - _VENT)


@dataclass(frozen=True)
class Top:
    """Top of a range."""

    space: Space  # dimensions of the range
    kind: BurnerKind  # kind of burners
    burners: int  # number of burners
    mirrored: bool  # whether the large burners are on the right
    finish: ag.Material  # finish of a sheet top, or of the edge of a glass top
    brass: bool  # whether gas burners are of brass
    maker: str  # brand name on the glass; `""` for none
    drawer: bool  # whether there is a drawer below, instead of a sheet panel

    @cached_property
    def _deep(self) -> tuple[ag.Scalar, ag.Scalar]:
        """Positions of the front and the back of the top along y [m]."""
        return (self.space.front - 0.004, self.space.rear - 0.0006)

    @cached_property
    def _y(self) -> ag.Scalar:
        """Position of the middle of the top along y [m]."""
        return (self._deep[0] + self._deep[1]) / 2.0

    @cached_property
    def _plan(self) -> TopPlan:
        front, back = self._deep
        return TopPlan(self.burners, 2, 0, "front", self.space.width, back - front, 0.02, 0.07, self.mirrored)

    def body(self) -> ag.Body:
        """Make the top with its burners or zones, which is welded to the cabinet."""
        space, plan = self.space, self._plan
        wide, deep = space.width, plan.depth
        thick = TOP - 0.0004
        outline = ag.rectangle(wide, deep, radius=0.010)
        low = space.height - thick
        glass = self.kind != "gas"
        half = 0.5 * (thick - (_GLASS if glass else 0.0))
        slab = details.relief(
            outline, (0.0, 0.0, low + half), facing=ag.Z, up=ag.Y, proud=half, sunk=half, bevel=0.0028
        )
        bodies = [ag.detail(slab, "top", self.finish), *self._tray(low)]
        if glass:
            pane = ag.extrude(
                ag.rectangle(wide - 0.010, deep - 0.010, radius=0.008), _GLASS + 0.001, bevel=0.0014
            )
            bodies.append(
                ag.part(pane.align((0.0, 0.0, space.height), z=1), "top", ag.material("black_glass"))
            )
            bodies += self._zones()
        else:
            border = ag.rectangle(wide - 0.004, deep - 0.004, radius=0.009)
            border = border - ag.rectangle(wide - 0.020, deep - 0.020, radius=0.007)
            rim = details.relief(border, (0.0, 0.0, space.height), facing=ag.Z, proud=0.0018, bevel=0.0014)
            bodies.append(ag.detail(rim, "top", self.finish))
            cap = ag.material("enamel_black").with_(name="cap_enamel", specular_roughness=0.5)
            metal = BRASS if self.brass else ALUMINIUM
            bodies += [
                gas_burner(each.size, spreader=metal, cap=cap).at(each.x, each.y, space.height)
                for each in plan.places
            ]
        slots = details.vent_slots(0.62 * wide, 0.014, 34, slot=0.0060)
        at = (0.0, deep / 2.0 - 0.024, space.height)
        bodies.append(ag.detail(details.relief(slots, at, facing=ag.Z, proud=0.0003), "vent", DARK))
        return ag.weld(*bodies).at(0.0, self._y, 0.0)

    def _tray(self, low: ag.Scalar) -> list[ag.Body]:
        """Make the boards that carry the burners, just under the surface; the front edge is hollow."""
        x, y = self.space.width / 2.0 - UNDER, self._plan.depth / 2.0 - UNDER
        z = (low + UNDER, self.space.height - UNDER)
        edge = -y + _LIP
        return [
            ag.part(ag.Region((-x, x), (edge, y), z).box(), "top", filled(self.finish, 560.0, "top")),
            ag.part(
                ag.Region((LAP - x, x - LAP), (-y, edge + LAP), (z[0] + LAP, z[1])).box(),
                "top",
                filled(self.finish, 150.0 if self.drawer else 420.0, "edge"),
            ),
        ]

    def _zones(self) -> list[ag.Body]:
        plan, top = self._plan, self.space.height
        ink = ink_on(ag.material("black_glass"))
        zones = []
        for place in plan.places:
            radius = ag.min_(ZONE_RADIUS[place.size], 0.92 * place.reach)
            film = (
                radiant_zone(radius, dual=place.size in ("large", "wok"))
                if self.kind == "radiant"
                else induction_zone(radius, style="cross")
            )
            zones.append((place, film))
        bodies = [printed_zones(zones, top, ink)]
        if self.maker:
            word = details.logo(self.maker, 0.008)
            at = (0.0, -0.5 * plan.depth + 0.022, top)
            bodies.append(details.printed(word, at, material=ink, facing=ag.Z))
        return bodies

    def joined(self, body: ag.Body) -> ag.Body:
        """Attach the grates of gas burners, which lift off, to a body with the top."""
        if self.kind != "gas":
            return body
        made = grates(
            self._plan.columns,
            plate=self.space.height,
            style="continuous",
            iron=ag.material("cast_iron"),
            feet=ag.material("rubber"),
        )
        for grate, lift in made:
            body = body.attach(grate.at(0.0, self._y, 0.0), lift)
        return body
