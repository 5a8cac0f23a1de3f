"""The plate of a cooktop and the case below it, which fits into a worktop."""

from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.shared.appliances import cord_stub, filled
from artgen.categories.shared.cooktops import BOWL, BurnerKind, Plan, coil_hole

Trim = Literal["none", "frame", "sides"]
"""Edge protection of a glass plate: none, a steel frame, or bars at its left and right."""

THICK: dict[BurnerKind, float] = {"gas": 0.007, "radiant": 0.0045, "coil": 0.014, "induction": 0.0045}
"""Thickness of the modeled plate; a real pressed plate is of sheet and hollow below [m]."""

_LAP = 0.016  # overlap of the plate with the worktop at the sides [m]
_LAP_BACK = 0.012
_WALL = 0.003  # wall thickness of the hollow case of a gas cooktop [m]
# density of the modeled plate for pressed sheet of 0.8-1.0 mm [kg/m3]
_SHEET = {"gas": 1100.0, "coil": 600.0}
_GLASS = 2050.0  # density for 6 mm of tempered glass, modeled 7 mm thick [kg/m3]
_CASE = {"gas": 1250.0, "radiant": 230.0, "coil": 210.0, "induction": 290.0}
"""Density of cases: walls of 0.8 mm sheet, heaters in wool, or coils with their electronics."""

_GALVANISED = ag.material("zinc").with_(name="galvanised_sheet", base_color=(0.50, 0.51, 0.52), texture="")
_SEAL = ag.material("rubber").with_(name="foam_seal", base_color=(0.05, 0.05, 0.05), density=120.0)


@dataclass(frozen=True)
class Case:
    """A plate and the case below it."""

    kind: BurnerKind  # kind of burners
    plan: Plan  # positions of burners and dials on the plate
    height: ag.Scalar  # height of the plate's upper face [m]
    finish: ag.Material  # finish of the plate
    metal: ag.Material  # metal of trims
    trim: Trim  # edge protection of the glass

    @property
    def thick(self) -> float:
        """Thickness of the plate [m]."""
        return THICK[self.kind]

    @property
    def under(self) -> ag.Scalar:
        """Height of the plate's underside [m]."""
        return self.height - self.thick

    def plate(self, holes: ag.Solid | None, coils: list[tuple[ag.Scalar, ag.Scalar, float]]) -> ag.Body:
        """Make the plate."""
        plan, glass = self.plan, self.kind in ("radiant", "induction") or self.is_glass
        outline = ag.rectangle(plan.width, plan.depth, radius=0.009 if glass else 0.014)
        bevel = 0.0012 if glass else 0.0022
        density = _SHEET.get(self.kind)
        if self.is_glass:
            density = _GLASS if self.kind == "gas" else None
        finish = self.finish if density is None else filled(self.finish, density, "sheet")
        if coils:
            # the layer with the holes for the bowls lies on a layer without holes
            layer = self.thick - BOWL
            open_: ag.Profile = outline
            for x, y, radius in coils:
                open_ = open_ - coil_hole(radius).at(x, y)
            upper = ag.extrude(open_, BOWL).align((0.0, 0.0, self.height), z=1)
            lower = ag.extrude(outline, layer).align((0.0, 0.0, self.under), z=-1)
            rim = ag.extrude(
                ag.rectangle(plan.width, plan.depth, radius=0.014)
                - ag.rectangle(plan.width - 0.006, plan.depth - 0.006, radius=0.011),
                0.004,
                bevel=0.0012,
            )
            return ag.weld(
                ag.part(upper, "plate", finish),
                ag.part(lower, "plate", finish),
                ag.detail(rim.at(0.0, 0.0, self.height - 0.0005), "plate", self.finish),
            )
        slab = ag.extrude(outline, self.thick, bevel=bevel).at(0.0, 0.0, self.height - self.thick / 2)
        plate = ag.part(slab if holes is None else slab - holes, "plate", finish)
        return ag.weld(plate, *self._trims(), *([] if glass else [self._border(0.010)]))

    def _border(self, wide: float) -> ag.Body:
        """Make the raised border of a pressed plate of some width [m], visual only."""
        plan = self.plan
        around = ag.rectangle(plan.width - 0.003, plan.depth - 0.003, radius=0.0125)
        within = ag.rectangle(plan.width - 2.0 * wide, plan.depth - 2.0 * wide, radius=0.008)
        border = details.relief(
            around - within, (0.0, 0.0, self.height), facing=ag.Z, proud=0.0016, bevel=0.0012
        )
        return ag.detail(border, "plate", self.finish)

    @property
    def is_glass(self) -> bool:
        """Whether the plate is of glass."""
        return "glass" in self.finish.name

    def _trims(self) -> list[ag.Body]:
        plan = self.plan
        low, high = self.under - 0.0005, self.height + 0.0009
        if self.trim == "frame":
            around = ag.rectangle(plan.width + 0.006, plan.depth + 0.006, radius=0.011)
            within = ag.rectangle(plan.width - 0.007, plan.depth - 0.007, radius=0.006)
            frame = ag.extrude(around - within, high - low, bevel=0.0008).at(0.0, 0.0, 0.5 * (low + high))
            return [ag.detail(frame, "trim", self.metal)]
        if self.trim == "sides":
            bar = ag.box(0.008, plan.depth + 0.002, high - low, bevel=0.0012)
            both = ag.array(
                bar, at=[(side * (plan.width / 2 - 0.001), 0.0, 0.5 * (low + high)) for side in (-1, 1)]
            )
            return [ag.detail(both, "trim", self.metal)]
        return []

    def case(self, lines: tuple[str, ...]) -> ag.Body:
        """Make the case from the floor to the plate, with all its parts."""
        plan = self.plan
        x, y = plan.width / 2 - _LAP, plan.depth / 2 - _LAP_BACK
        shell = ag.Region.between((-x, -y, 0.0), (x, y, self.under + 0.0003)).box()
        if self.kind == "gas":
            room = ag.Region.between((_WALL - x, _WALL - y, _WALL), (x - _WALL, y - _WALL, self.height)).box()
            shell = shell - room
        sheet = filled(_GALVANISED, _CASE[self.kind], "case")
        seam = ag.extrude(
            ag.rectangle(plan.width - 0.006, plan.depth - 0.006, radius=0.008)
            - ag.rectangle(2.0 * x - 0.002, 2.0 * y - 0.002),
            0.002,
        ).at(0.0, 0.0, self.under - 0.0007)
        bodies = [ag.part(shell, "body", sheet), ag.detail(seam, "seal", _SEAL)]
        if self.kind == "induction":  # the fan takes in air in front and blows it out at the back
            for face in (-1, 1):
                slots = details.vent_slots(0.7 * plan.width, 0.016, 44, slot=0.003)
                bodies.append(
                    details.printed(
                        slots,
                        ag.vector(0.0, face * y, 0.62 * self.under),
                        material=ag.material("black_abs"),
                        facing=face * ag.Y,
                        label="vent",
                    )
                )
        for side in (-1, 1):
            at = ag.vector(side * x, -0.36 * plan.depth, 0.70 * self.under)
            bodies.append(details.screw(0.0032, at, facing=side * ag.X, material=ag.material("stainless")))
        label = ag.vector(x, 0.12 * plan.depth, 0.5 * self.under)
        bodies.append(details.rating_plate(0.07, 0.022, lines, at=label, facing=ag.X))
        clamp = ag.box(0.020, 0.004, 0.030, bevel=0.0008)
        steel = ag.material("steel").with_(name="clamp_steel", base_color=(0.42, 0.42, 0.42))
        clamps = [(i * 0.32 * plan.width, -y - 0.0012, 0.5 * self.under) for i in (-1, 1)]
        bodies.append(ag.detail(ag.array(clamp, at=clamps), "clamp", steel))
        bodies.append(cord_stub(height=0.55 * self.under).at(0.32 * plan.width, y, 0.55 * self.under))
        if self.kind == "gas":
            pipe = ag.cylinder(0.0075, 0.034, axis=ag.Y, bevel=0.001).at(
                -0.36 * plan.width, y + 0.015, 0.4 * self.under
            )
            nut = ag.cylinder(0.0125, 0.010, axis=ag.Y, bevel=0.0015).at(
                -0.36 * plan.width, y + 0.012, 0.4 * self.under
            )
            brass = ag.material("brass").with_(name="gas_brass", specular_roughness=0.4)
            bodies += [ag.detail(pipe, "gas_pipe", brass), ag.detail(nut, "gas_pipe", brass)]
        return ag.weld(*bodies)

    def maker(self, name: str, ink: ag.Material) -> ag.Body:
        """Print the maker's name at the middle of the edge without dials."""
        plan = self.plan
        _, _, front, back = plan.field
        y = back - 0.004 if plan.side == "front" else front + 0.001
        x = 0.5 * (plan.field[0] + plan.field[1])
        logo = details.logo(name, 0.0062, tracking=0.15)
        return details.printed(logo, ag.vector(x, y, self.height), material=ink, facing=ag.Z)
