"""A display on a stand: a monitor that rises, turns and tilts, one that tilts only, or a television.

Links: `base`; `column` and `carriage` of a monitor that rises; `screen`; `button_0`, .... Joints:
`stand_swivel`, `height_slide`, `screen_tilt`; `button_slide_0`, ....

At 0 the screen is upright, in its lowest position, and faces the user. A spring carries most of its weight,
and friction holds it at any height and angle. The keys are under the lower edge, and are pressed upwards. A
television turns on its foot.

Sizes are those of shops: monitors of 22-27 inches have screens of 0.49-0.62 m by 0.28-0.36 m and weigh 3.5-8
kg with a stand of 0.20-0.27 m; televisions of 32-43 inches 0.71-0.97 m by 0.42-0.56 m, 4-11 kg. Stands rise
by 0.10-0.14 m, turn by 45 degrees to each side and tilt from -5 to 19 degrees.
"""

import math
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.shared import controls, screens
from artgen.categories.shared.finish import casting, colors
from artgen.nodes.fitting import FIT

Style = Literal["rising", "tilting", "television"]
"""A monitor that rises, turns and tilts, one that tilts only, or a television."""

_THIN = 0.009  # thickness of the panel [m]
_BULGE = 0.034  # depth of the housing behind it [m]
_BEHIND = 0.052  # from the housing to the column [m]
_CASES = colors("abs", "graphite black white light_grey")
_METALS = ("brushed_aluminium", "powder_coat_black", "black_anodised", "powder_coat_white")
_BLACK = ag.material("black_abs")


@dataclass(frozen=True)
class _Plan:
    """Measures and materials of a display."""

    style: Style
    wide: ag.Scalar  # of the panel [m]
    tall: ag.Scalar  # of the panel [m]
    level: ag.Scalar  # height of the middle of the panel [m]
    case: ag.Material
    metal: ag.Material
    maker: str

    @property
    def back(self) -> float:
        """Position of the rear of the housing along y [m]."""
        return _THIN + _BULGE

    @property
    def axis(self) -> float:
        """Position of the axis of the stand along y [m]."""
        return self.back + _BEHIND + 0.016

    def neck(self, end: float) -> list[ag.Solid]:
        """Make the pin of the tilt and its neck, back to a position along y."""
        y, z = self.back + 0.020, self.level
        bar = ag.Region((-0.016, 0.016), (y, end), (z - 0.013, z + 0.013)).box(bevel=0.003)
        return [bar, ag.cylinder(0.013, 0.046, axis=ag.X, bevel=0.002).at(0, y, z)]


@ag.category(
    labels="base column carriage screen bezel housing display hinge button port vent foot rating_plate print",
    joints=(2, 8),
)
def display(
    *,
    style: Style = ag.choice({"rising": 0.45, "tilting": 0.25, "television": 0.30}),
    inches: int = ag.by(
        "style",
        rising={22: 1, 24: 3, 27: 3},
        tilting={22: 2, 24: 3, 27: 1},
        television={32: 2, 40: 1, 43: 2},
        doc="diagonal of the picture",
    ),
    margin: ag.Float = ag.uniform(0.004, 0.012, "m", doc="width of the bezel", within=(0.003, 0.02)),
    raised: ag.Float = ag.by(
        "style",
        television=ag.uniform(0.055, 0.085),
        otherwise=ag.uniform(0.070, 0.120),
        unit="m",
        within=(0.05, 0.2),
        doc="height of the lower edge above the table",
    ),
    foot: Literal["plate", "disc"] = ag.choice({"plate": 0.6, "disc": 0.4}),
    travel: ag.Float = ag.by(
        "style", rising=ag.uniform(0.10, 0.14), otherwise=0.1, unit="m", within=(0.05, 0.17)
    ),
    keys: int = ag.by("style", television=1, otherwise=ag.count(2, 5), doc="number of keys"),
    picture: str = ag.choice(*screens.PICTURES, weights=(2, 2, 2, 2)),
    case: ag.Material = ag.shades(*_CASES, weights=(3, 3, 1, 1), color=0.03),
    metal: ag.Material = ag.choice(*_METALS, doc="stand"),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make an upright display in its lowest position."""
    wide, tall = 0.02214 * inches + 2 * margin, 0.01245 * inches + 2 * margin
    plan = _Plan(style, wide, tall, raised + tall / 2, case, metal, maker)
    screen = _screen(plan, margin, picture, keys)
    pivot = (0, plan.back + 0.020, plan.level)
    hold = feel.Feel(friction=0.06 * screen.weight(), damping=0.15, effort=60.0)
    tilt = ag.Revolute("screen_tilt", axis=-ag.X, pivot=pivot, limits=(-0.08, 0.33), feel=hold)
    base, column = _base(plan, foot), plan.axis
    turn = ag.Revolute(
        "stand_swivel", axis=ag.Z, pivot=(0, column, 0), limits=(-0.78, 0.78),
        feel=feel.Feel(friction=0.6, damping=0.1, effort=30.0),
    )  # fmt: skip
    if style == "rising":
        carriage = _carriage(plan).attach(screen, tilt)
        weight = carriage.weight()
        lift = ag.Prismatic(
            "height_slide", axis=ag.Z, limits=(0, travel), stiffness=weight, rest=1 + travel / 2,
            friction=0.22 * weight, damping=20.0, effort=200.0,
        )  # fmt: skip
        return base.attach(_column(plan, travel).attach(carriage, lift), turn).at(y=-column)
    post = _post(plan)
    if style == "television":
        return base.attach(ag.weld(screen, post), turn).at(y=-column)
    return ag.weld(base, post).attach(screen, tilt).at(y=-column)


def _screen(plan: _Plan, margin: ag.Scalar, picture: str, keys: int) -> ag.Body:
    """Make the screen with its housing, the hinge arms of a monitor, and the keys below the housing."""
    low, high = plan.level - plan.tall / 2, plan.level + plan.tall / 2
    panel = ag.Region((-plan.wide / 2, plan.wide / 2), (0.0, _THIN), (low, high))
    room = ag.Region(
        (-0.31 * plan.wide, 0.31 * plan.wide), (_THIN - 0.0004, plan.back), (low + 0.012, high - 0.10)
    )
    solid = ag.extrude(panel.front(radius=0.006), _THIN, axis=ag.Y, bevel=0.0015).at(0, _THIN / 2, 0)
    hollow = plan.case.with_(name=f"{plan.case.name}_screen", density=720.0)
    hold = ag.grasp_on(solid, approach=-ag.Z, closing=ag.Y, depth=0.012)
    inner = panel.shrink(0.0014, front=0, back=0)
    glass = panel.shrink(margin, front=0.0, back=0.0, bottom=0.006)
    parts = [
        ag.part(solid, "screen", hollow, name="screen", grasp=hold, grasp_width=_THIN + 0.012),
        ag.part(
            room.box(bevel=0.010), "housing", plan.case.with_(name=f"{plan.case.name}_works", density=420.0)
        ),
        ag.detail(inner.with_(y=(-0.0006, 0.0004)).box(), "bezel", screens.GLASS),
        *screens.picture_films(
            picture, (glass.x.size, glass.z.size), (0, -0.0006, glass.z.mid), facing=-ag.Y
        ),
        details.printed(
            details.logo(plan.maker, 0.0035), (0, -0.0006, low + 0.0045), material=controls.LIGHT_INK
        ),
        *_rear(plan, room),
    ]
    if plan.style != "television":
        ear = ag.hull(
            ag.box(0.006, 0.004, 0.034).at(y=plan.back + 0.0016),
            ag.cylinder(0.010, 0.006, axis=ag.X).at(y=plan.back + 0.020),
        )
        ears = [ear.at(side * 0.0275, 0, plan.level) for side in (-1, 1)]
        parts.append(ag.part(ears, "hinge", plan.metal))
    screen = ag.weld(*parts)
    for number, x in enumerate(controls.places(keys, 0.021, middle=0.20 * plan.wide)):
        key = controls.push_button(
            finish=_BLACK, through=0.008, shape="square", width=0.010, proud=0.003, deep=0.005, travel=0.0015
        )
        turned = key.rotate(ag.X, math.pi / 2).suffixed(f"_{number}")
        screen = screen.install(turned, at=(x, _THIN + 0.5 * _BULGE, room.z.low))
    if not keys:
        return screen
    *others, power = [f"button_slide_{number}" for number in range(keys)]
    on = screens.powered(picture, signals.pressed(power))
    screen = screens.lit(screen, picture, on)
    if not others:
        return screen
    return screen.output("menu", signals.timer(controls.any_pressed(others), 10.0) & on, kind="display")


def _rear(plan: _Plan, room: ag.Region) -> list[ag.Body]:
    """Make vents, ports and the plate at the back."""
    slots = details.vent_slots(0.6 * room.x.size, 0.022, 21, slot=0.0035)
    lines = (f"{plan.maker} display", "12 V - 3.0 A", "Class I")
    plate = details.rating_plate(
        0.05, 0.022, lines, at=(-0.32 * room.x.size, room.y.high, room.z.mid), facing=ag.Y
    )
    ports = [
        ag.box(0.016, 0.003, 0.008, bevel=0.001).at(
            -0.1 * room.x.size - 0.026 * number, room.y.high, room.z.low + 0.02
        )
        for number in range(4)
    ]
    at = (0, room.y.high, room.z.high - 0.022)
    return [
        details.printed(slots, at, facing=ag.Y, material=_BLACK, label="vent"),
        plate,
        ag.detail(ports, "port", _BLACK),
    ]


def _base(plan: _Plan, foot: str) -> ag.Body:
    """Make the base about the axis of its column."""
    y = plan.axis
    size = 0.36 * plan.wide
    if foot == "disc":
        solid = ag.cylinder(ag.max_(0.5 * size, 0.11), 0.010, bevel=0.002).at(0, y - 0.03, 0.007)
    else:
        solid = ag.extrude(ag.rectangle(ag.max_(size, 0.22), 0.19, radius=0.012), 0.008, bevel=0.002).at(
            0, y - 0.045, 0.006
        )
    pads = [
        ag.cylinder(0.008, 0.0025).at(side * 0.065, y - 0.03 + way * 0.055, 0.00125)
        for side in (-1, 1)
        for way in (-1, 1)
    ]
    heavy = plan.metal.with_(name=f"{plan.metal.name}_base", density=4200.0)
    return ag.weld(ag.part(solid, "base", heavy, name="base"), ag.part(pads, "foot", ag.material("rubber")))


def _column(plan: _Plan, travel: ag.Scalar) -> ag.Body:
    """Make the column that turns on the base, with the rail of the carriage."""
    y, top = plan.axis, plan.level + 0.008 + travel
    disc = ag.cylinder(0.046, 0.010, bevel=0.002).at(0, y, 0.0128 + 0.005)
    post = ag.Region((-0.030, 0.030), (y - 0.016, y + 0.016), (0.020, top)).box(bevel=0.006)
    hole = ag.detail(
        ag.tube(0.020, 0.0165, 0.003, axis=ag.Y, bevel=0.001).at(0, y + 0.016, 0.10), "column", _BLACK
    )
    hold = ag.grasp_on(post, approach=-ag.Z, closing=ag.X, depth=0.02)
    return ag.weld(
        ag.part(
            [disc, post], "column", casting(plan.metal, 0.5), name="column", grasp=hold, grasp_width=0.072
        ),
        hole,
    )


def _carriage(plan: _Plan) -> ag.Body:
    """Make the carriage before the column, with the neck of the hinge."""
    face = plan.back + _BEHIND
    plate = ag.Region(
        (-0.026, 0.026), (face - 0.008, face - FIT.running), (plan.level - 0.072, plan.level + 0.004)
    )
    solids = [plate.box(bevel=0.002), *plan.neck(face - 0.0075)]
    return ag.part(solids, "carriage", casting(plan.metal, 0.6), name="carriage")


def _post(plan: _Plan) -> ag.Body:
    """Make the post of a stand that does not rise: to the hinge of a monitor, or to a television."""
    y = plan.axis
    if plan.style == "television":
        arm = ag.Region(
            (-0.055, 0.055), (plan.back - 0.001, y + 0.012), (plan.level - 0.12, plan.level - 0.06)
        )
        post = ag.Region((-0.045, 0.045), (y - 0.012, y + 0.012), (0.0160, plan.level - 0.062))
        disc = ag.cylinder(0.055, 0.006, bevel=0.001).at(0, y, 0.0158)
        solids = [arm.box(bevel=0.004), post.box(bevel=0.004), disc]
        return ag.part(solids, "column", casting(plan.metal, 0.3))
    column = ag.Region((-0.024, 0.024), (y - 0.014, y + 0.014), (0.006, plan.level + 0.020)).box(bevel=0.005)
    return ag.part([column, *plan.neck(y - 0.013)], "column", casting(plan.metal, 0.4))
