"""The plate of a cooktop and the case below it, which is sunk into a worktop."""

from dataclasses import dataclass
from typing import Literal

from artgen import (
    Body,
    Material,
    Profile,
    Scalar,
    Solid,
    X,
    Y,
    Z,
    array,
    box,
    box_between,
    cylinder,
    detail,
    details,
    extrude,
    material,
    part,
    rectangle,
    vector,
    weld,
)
from artgen.categories.shared.appliances.cords import cord_stub
from artgen.categories.shared.appliances.finish import filled
from artgen.categories.shared.cooktops.burners import BOWL, coil_hole
from artgen.categories.shared.cooktops.plan import BurnerKind, Plan

Trim = Literal["none", "frame", "sides"]
"""What guards the edge of a glass plate: nothing, a frame of steel, or bars at its left and right."""

THICK: dict[BurnerKind, float] = {"gas": 0.007, "radiant": 0.0045, "coil": 0.014, "induction": 0.0045}
"""How thick a plate is drawn; a pressed one is of sheet and hollow below [m]."""

_LAP = 0.016  # how far the plate laps over the worktop at the sides [m]
_LAP_BACK = 0.012
_WALL = 0.003  # of the hollow case of a gas cooktop [m]
_SHEET = {"gas": 1100.0, "coil": 600.0}  # pressed sheet of 0.8-1.0 mm, drawn so thick [kg/m3]
_GLASS = 2050.0  # 6 mm of tempered glass, drawn 7 mm thick [kg/m3]
_CASE = {"gas": 1250.0, "radiant": 230.0, "coil": 210.0, "induction": 290.0}
"""What cases weigh by their volume: walls of 0.8 mm sheet, heaters in wool, coils with their electronics."""

_GALVANISED = material("zinc").with_(name="galvanised_sheet", base_color=(0.50, 0.51, 0.52), texture="")
_SEAL = material("rubber").with_(name="foam_seal", base_color=(0.05, 0.05, 0.05), density=120.0)


@dataclass(frozen=True)
class Case:
    """A plate over its case."""

    kind: BurnerKind  # what heats
    plan: Plan  # where things are on the plate
    height: Scalar  # of the plate's upper face [m]
    finish: Material  # of the plate
    metal: Material  # of trims
    trim: Trim  # what guards the edge of glass

    @property
    def thick(self) -> float:
        """Thickness of the plate [m]."""
        return THICK[self.kind]

    @property
    def under(self) -> Scalar:
        """Height of the plate's underside [m]."""
        return self.height - self.thick

    def plate(self, holes: Solid | None, coils: list[tuple[Scalar, Scalar, float]]) -> Body:
        """Make the plate."""
        plan, glass = self.plan, self.kind in ("radiant", "induction") or self.is_glass
        outline = rectangle(plan.width, plan.depth, radius=0.009 if glass else 0.014)
        bevel = 0.0012 if glass else 0.0022
        density = _SHEET.get(self.kind)
        if self.is_glass:
            density = _GLASS if self.kind == "gas" else None
        finish = self.finish if density is None else filled(self.finish, density, "sheet")
        if coils:
            # the layer with the holes for the bowls lies on one without
            layer = self.thick - BOWL
            open_: Profile = outline
            for x, y, radius in coils:
                open_ = open_ - coil_hole(radius).at(x, y)
            upper = extrude(open_, BOWL).align((0.0, 0.0, self.height), z=1)
            lower = extrude(outline, layer).align((0.0, 0.0, self.under), z=-1)
            rim = extrude(
                rectangle(plan.width, plan.depth, radius=0.014)
                - rectangle(plan.width - 0.006, plan.depth - 0.006, radius=0.011),
                0.004,
                bevel=0.0012,
            )
            return weld(
                part(upper, "plate", finish),
                part(lower, "plate", finish),
                detail(rim.at(0.0, 0.0, self.height - 0.0005), "plate", self.finish),
            )
        slab = extrude(outline, self.thick, bevel=bevel).at(0.0, 0.0, self.height - self.thick / 2)
        plate = part(slab if holes is None else slab - holes, "plate", finish)
        return weld(plate, *self._trims(), *([] if glass else [self._border(0.010)]))

    def _border(self, wide: float) -> Body:
        """Make the raised border of a pressed plate, of some width [m]; only seen."""
        plan = self.plan
        around = rectangle(plan.width - 0.003, plan.depth - 0.003, radius=0.0125)
        within = rectangle(plan.width - 2.0 * wide, plan.depth - 2.0 * wide, radius=0.008)
        border = details.relief(
            around - within, (0.0, 0.0, self.height), facing=Z, proud=0.0016, bevel=0.0012
        )
        return detail(border, "plate", self.finish)

    @property
    def is_glass(self) -> bool:
        """Whether the plate is of glass."""
        return "glass" in self.finish.name

    def _trims(self) -> list[Body]:
        plan = self.plan
        low, high = self.under - 0.0005, self.height + 0.0009
        if self.trim == "frame":
            around = rectangle(plan.width + 0.006, plan.depth + 0.006, radius=0.011)
            within = rectangle(plan.width - 0.007, plan.depth - 0.007, radius=0.006)
            frame = extrude(around - within, high - low, bevel=0.0008).at(0.0, 0.0, 0.5 * (low + high))
            return [detail(frame, "trim", self.metal)]
        if self.trim == "sides":
            bar = box(0.008, plan.depth + 0.002, high - low, bevel=0.0012)
            both = array(
                bar, at=[(side * (plan.width / 2 - 0.001), 0.0, 0.5 * (low + high)) for side in (-1, 1)]
            )
            return [detail(both, "trim", self.metal)]
        return []

    def case(self, lines: tuple[str, ...]) -> Body:
        """Make the case from the floor to the plate, with what is on it."""
        plan = self.plan
        x, y = plan.width / 2 - _LAP, plan.depth / 2 - _LAP_BACK
        shell = box_between((-x, -y, 0.0), (x, y, self.under + 0.0003))
        if self.kind == "gas":
            room = box_between((_WALL - x, _WALL - y, _WALL), (x - _WALL, y - _WALL, self.height))
            shell = shell - room
        sheet = filled(_GALVANISED, _CASE[self.kind], "case")
        seam = extrude(
            rectangle(plan.width - 0.006, plan.depth - 0.006, radius=0.008)
            - rectangle(2.0 * x - 0.002, 2.0 * y - 0.002),
            0.002,
        ).at(0.0, 0.0, self.under - 0.0007)
        bodies = [part(shell, "body", sheet), detail(seam, "seal", _SEAL)]
        if self.kind == "induction":  # the fan takes its air in front and blows it out at the back
            for face in (-1, 1):
                slots = details.vent_slots(0.7 * plan.width, 0.016, 44, slot=0.003)
                bodies.append(
                    details.printed(
                        slots,
                        vector(0.0, face * y, 0.62 * self.under),
                        material=material("black_abs"),
                        facing=face * Y,
                        label="vent",
                    )
                )
        for side in (-1, 1):
            at = vector(side * x, -0.36 * plan.depth, 0.70 * self.under)
            bodies.append(details.screw(0.0032, at, facing=side * X, material=material("stainless")))
        label = vector(x, 0.12 * plan.depth, 0.5 * self.under)
        bodies.append(details.rating_plate(0.07, 0.022, lines, at=label, facing=X))
        clamp = box(0.020, 0.004, 0.030, bevel=0.0008)
        steel = material("steel").with_(name="clamp_steel", base_color=(0.42, 0.42, 0.42))
        clamps = [(i * 0.32 * plan.width, -y - 0.0012, 0.5 * self.under) for i in (-1, 1)]
        bodies.append(detail(array(clamp, at=clamps), "clamp", steel))
        bodies.append(cord_stub(height=0.55 * self.under).at(0.32 * plan.width, y, 0.55 * self.under))
        if self.kind == "gas":
            pipe = cylinder(0.0075, 0.034, axis=Y, bevel=0.001).at(
                -0.36 * plan.width, y + 0.015, 0.4 * self.under
            )
            nut = cylinder(0.0125, 0.010, axis=Y, bevel=0.0015).at(
                -0.36 * plan.width, y + 0.012, 0.4 * self.under
            )
            brass = material("brass").with_(name="gas_brass", specular_roughness=0.4)
            bodies += [detail(pipe, "gas_pipe", brass), detail(nut, "gas_pipe", brass)]
        return weld(*bodies)

    def maker(self, name: str, ink: Material) -> Body:
        """Print the maker's name at the middle of the edge that is free of dials."""
        plan = self.plan
        _, _, front, back = plan.field
        y = back - 0.004 if plan.side == "front" else front + 0.001
        x = 0.5 * (plan.field[0] + plan.field[1])
        logo = details.logo(name, 0.0062, tracking=0.15)
        return details.printed(logo, vector(x, y, self.height), material=ink, facing=Z)
