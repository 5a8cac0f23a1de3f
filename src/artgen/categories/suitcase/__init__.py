"""A suitcase: a trolley case with a telescopic handle, a tool case, or an attaché case.

Links: `base`, the half at the back or below; `lid`; `latch_left`, `latch_right`; `handle`, which folds down.
A trolley has a `pull`, the telescopic handle, with its `button`, and `caster_fork_0`, `caster_wheel_0`, ....
Joints: `lid_hinge`, `latch_turn_left`, `latch_turn_right`, `handle_turn`; `pull_slide`, `button_press`,
`caster_swivel_0`, `caster_roll_0`, .... A trolley on two wheels has only `caster_wheel_0`, `caster_wheel_1`
and their `caster_roll_0`, `caster_roll_1` below its base, and two fixed feet below its lid.

The lid opens while both latches are open, which hook over keepers on it. Friction of 25 N holds the pull
where a hand leaves it, at any length; the button in its grip springs back and locks nothing. A trolley stands
upright, with the lid before its base, hinged at the left; half of its four casters stand below the lid and
roll with it.

Sizes are those of shops: cabin trolleys are 350-400 mm wide, 200-250 mm deep and 530-560 mm high with
wheels of 40-50 mm, 2.3-3.6 kg, and large ones 450-520 mm wide, 270-310 mm deep, 660-770 mm high, 3.5-5.5 kg;
their pull brings the grip to 0.95-1.10 m. Protective tool cases of polypropylene are 330-500 mm wide and
120-190 mm high, 1.5-4 kg (Peli 1400-1500); attaché cases are 420-460 mm wide, 310-340 mm deep and 90-130 mm
high, 2-4 kg. Draw latches of cases hold 100-300 N and are opened with 10-40 N (catalogs of toggle latches).
"""

import math
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details, feel
from artgen.categories.shared import controls, fixings
from artgen.categories.shared.finish import casting, colors
from artgen.nodes.fitting import FIT, Fitting

Style = Literal["trolley", "tool_case", "attache"]
"""A trolley case that stands on wheels, a case with draw latches, or a flat case for papers."""

_GAP = FIT.running  # between the rims of base and lid [m]
_OPEN = 0.8  # angle of a latch that frees the lid [rad]
_WHEEL = 0.021  # radius of a caster [m]
_STAND = 2 * _WHEEL + 0.0155  # height of the shell above the floor [m]
_TUBES = 0.042  # from the back of a trolley to the tubes of its pull [m]
_PIVOT = 0.0062  # from the sides of a case to the axis of its lid, and from its front to that of a handle [m]
_STEEL = ag.material("black_steel")
_BLACK = ag.material("black_abs")
_LINING = ag.material("fabric").with_(name="case_lining", base_color=(0.10, 0.10, 0.11))
_FOAM = ag.material("foam").with_(name="case_foam", base_color=(0.05, 0.05, 0.055))

_SHELLS = ag.shades(
    *colors("abs", "black graphite navy red teal white sage"), "brushed_aluminium", color=0.04
)
_TOUGH = ag.shades(
    *colors("leather_grain_abs", "black graphite orange yellow sage"), weights=(3, 2, 1, 1.5, 1), color=0.03
)
_PLASTICS = ag.choice("black_abs", "satin_nickel", ag.colored("abs", "graphite"))
_FLAT = ag.shades("black_leather", "leather", "brushed_aluminium", "black_anodised", color=0.05)
_LATCH = feel.Feel(friction=0.12, damping=0.004, armature=2e-5, effort=5.0)
_HANDLE = feel.Feel(friction=0.05, damping=0.005, armature=1e-4, effort=8.0)


@dataclass(frozen=True)
class _Plan:
    """Measures and materials of one case, which lies on its base with the hinge at the back."""

    style: Style
    wide: ag.Scalar  # along the hinge [m]
    deep: ag.Scalar  # from the front to the hinge [m]
    low: ag.Scalar  # height of the base, and of the seam [m]
    high: ag.Scalar  # height of the closed case [m]
    radius: float  # of the corners [m]
    wall: float  # [m]
    shell: ag.Material
    metal: ag.Material

    @property
    def soft(self) -> float:
        """Radius of the edges around both large faces [m]."""
        return {"trolley": 0.022, "tool_case": 0.007, "attache": 0.006}[self.style]

    def half(self, *, upper: bool) -> ag.Solid:
        """Make the hollow shell of the lid or of the base: its room has flat sides, each with a collider."""
        outer = ag.extrude(ag.rectangle(self.wide, self.deep, radius=self.radius), self.high, bevel=self.soft)
        room = ag.hull(
            ag.extrude(self._outline(self.radius - self.wall), self.high - 2 * self.soft),
            ag.extrude(self._outline(self.radius - self.soft), self.high - 2 * self.wall),
        )
        level = self.low + (_GAP / 2 if upper else -_GAP / 2)
        shell = (ag.bounding_collider(outer) - room).at(z=self.high / 2)
        return shell.split(point=(0, 0, level), normal=ag.Z if upper else -ag.Z)

    def _outline(self, radius: float) -> ag.Profile:
        """Make a rectangle of the size of the case, less its corners, with corners of two chords."""
        turns = [(side + chord / 2) * math.pi / 2 for side in range(4) for chord in range(3)]
        signs = [(x, y) for x, y in ((1, 1), (-1, 1), (-1, -1), (1, -1)) for _ in range(3)]
        x, y = self.wide / 2 - self.radius, self.deep / 2 - self.radius
        return ag.polygon(
            [
                (a * x + radius * math.cos(turn), b * y + radius * math.sin(turn))
                for (a, b), turn in zip(signs, turns, strict=True)
            ]
        )

    def band(self, low: ag.Scalar, high: ag.Scalar, proud: float) -> ag.Solid:
        """Make a band around the case between two heights."""
        outer = ag.rectangle(self.wide + 2 * proud, self.deep + 2 * proud, radius=self.radius + proud)
        inner = ag.rectangle(self.wide - 0.004, self.deep - 0.004, radius=self.radius - 0.002)
        return ag.extrude(outer - inner, high - low, bevel=0.4 * proud).at(z=(low + high) / 2)


@ag.category(
    labels="base lid band rib hinge latch keeper handle grip tube button caster wheel screw lining foot "
    "print",
    joints=(4, 14),
)
def suitcase(
    *,
    style: Style = ag.choice({"trolley": 0.5, "tool_case": 0.27, "attache": 0.23}),
    size: Literal["cabin", "large"] = ag.by("style", trolley={"cabin": 0.6, "large": 0.4}, otherwise="cabin"),
    rolling: Literal["casters", "wheels"] = ag.by(
        "style", trolley={"casters": 0.65, "wheels": 0.35}, otherwise="wheels", doc="parts below a trolley"
    ),
    wide: ag.Float = ag.by(
        "style",
        trolley=ag.by("size", cabin=ag.uniform(0.487, 0.512), large=ag.uniform(0.60, 0.70)),
        tool_case=ag.uniform(0.34, 0.48),
        attache=ag.uniform(0.42, 0.46),
        unit="m",
        within=(0.32, 0.74),
        doc="length of the side with the hinge; height of the shell of a trolley",
    ),
    aspect: ag.Float = ag.by(
        "style",
        trolley=ag.uniform(0.70, 0.76),
        tool_case=ag.uniform(0.72, 0.82),
        attache=ag.uniform(0.72, 0.76),
        within=(0.66, 0.86),
        doc="depth from front to hinge as a share of the length",
    ),
    high: ag.Float = ag.by(
        "style",
        trolley=ag.by("size", cabin=ag.uniform(0.205, 0.245), large=ag.uniform(0.27, 0.30)),
        tool_case=ag.uniform(0.135, 0.185),
        attache=ag.uniform(0.100, 0.130),
        unit="m",
        within=(0.09, 0.32),
        doc="thickness of the closed case",
    ),
    ribs: int = ag.by(
        "style",
        trolley=ag.choice({0: 1, 3: 1, 5: 2, 9: 2}),
        tool_case=ag.choice({2: 1, 3: 1, 4: 1}),
        attache=0,
        doc="number of ribs on the outer faces",
    ),
    opens: ag.Float = ag.by(
        "style",
        trolley=ag.uniform(2.6, 3.0),
        otherwise=ag.uniform(1.65, 1.95),
        unit="rad",
        within=(1.4, 3.05),
        doc="angle of the open lid",
    ),
    shell: ag.Material = ag.by("style", trolley=_SHELLS, tool_case=_TOUGH, attache=_FLAT),
    metal: ag.Material = ag.by(
        "style",
        trolley=ag.choice("satin_nickel", "black_anodised", "brushed_aluminium"),
        tool_case=_PLASTICS,
        attache=ag.choice("satin_brass", "chrome", "satin_nickel"),
    ),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a closed and latched case: a trolley stands on its wheels, the others lie on their base."""
    share = {"trolley": 0.5, "tool_case": 0.64, "attache": 0.62}[style]
    radius = {"trolley": 0.042, "tool_case": 0.022, "attache": 0.012}[style]
    wall = {"trolley": 0.004, "tool_case": 0.006, "attache": 0.005}[style]
    if style == "trolley":
        high = ag.require(high, high >= 0.11, "wheels need room: high of a trolley must be >= 0.11 m")
    plan = _Plan(style, wide, aspect * wide, share * high, high, radius, wall, shell, metal)
    base, lid = _halves(plan, ribs, maker)
    latches = []
    for side, name in ((-1, "_left"), (1, "_right")):
        at = (side * 0.30 * wide, -plan.deep / 2, plan.low)
        latch, turn = _latch(plan, name)
        base = base.install(latch, at=at)
        keeper = ag.Region((-0.013, 0.013), (-0.0045, 0.0005), (0.008, 0.0122)).box(bevel=0.0006)
        lid = ag.weld(lid, ag.part(keeper, "keeper", metal).at(at))
        latches.append(turn)
    pivot = (0, plan.deep / 2 + _PIVOT, plan.low)
    free = ((latches[0] > _OPEN) & (latches[1] > _OPEN)).beyond(0.001)
    hinge = ag.Revolute("lid_hinge", axis=-ag.X, pivot=pivot, limits=(0, opens), feel=feel.HINGE, needs=free)
    front = -plan.deep / 2
    tab = ag.Region((-0.028, 0.028), (front - 0.0115, front + 0.003), (plan.low + 0.003, plan.low + 0.008))
    lip = tab.box(bevel=0.0012)
    hold = ag.grasp_on(lip, approach=ag.Y, closing=ag.Z, depth=0.0095)
    lid = ag.weld(lid, ag.part(lip, "keeper", metal, name="lid_tab", grasp=hold))
    base = base.install(_handle(plan), at=(0, -plan.deep / 2, plan.low - 0.020))
    if style == "trolley":
        base, lid = _wheeled(base, lid, plan, rolling)
        base = base.install(_pull(plan), at=(wide / 2, 0, _TUBES))
        upright = base.attach(lid, hinge).rotate(ag.Z, math.pi / 2).rotate(ag.X, math.pi / 2)
        return upright.at(z=wide / 2 + _STAND)
    return base.attach(lid, hinge).at(z=0.003)


def _halves(plan: _Plan, ribs: int, maker: str) -> tuple[ag.Body, ag.Body]:
    """Make base and lid with their rims, hinges, ribs, lining and the name of the maker."""
    style, low, high = plan.style, plan.low, plan.high
    density = {"trolley": 820.0, "tool_case": 850.0, "attache": 850.0}[style]
    if plan.shell.base_metalness > 0.5:
        density *= 1.35
    shell = plan.shell.with_(name=f"{plan.shell.name}_shell", density=density)
    trim, proud = (plan.shell, 0.0016) if style == "tool_case" else (plan.metal, 0.0009)
    inner = ag.Region.centered(plan.wide, plan.deep, 0.0).shrink(x=plan.wall, y=plan.wall)
    sunk = ag.max_(plan.soft - plan.wall - 0.004, 0.0)  # the edges of the lining lie in the rounded edges
    sheet = inner.shrink(x=sunk, y=sunk).plan(radius=plan.radius - plan.wall - sunk)
    cloth = _FOAM if style == "tool_case" else _LINING
    made = []
    for name, upper in (("base", False), ("lid", True)):
        edge = (low + _GAP / 2, low + 0.009) if upper else (low - 0.009, low - _GAP / 2)
        floor = high - plan.wall - 0.0008 if upper else plan.wall + 0.0008
        body = ag.weld(
            ag.part(plan.half(upper=upper), name, shell, name=name),
            ag.detail(plan.band(*edge, proud), "band", trim),
            ag.detail(ag.extrude(sheet, 0.002).at(z=floor), "lining", cloth),
            _knuckles(plan, upper=upper),
        )
        if ribs and (upper or style == "trolley"):
            strip = _ribs(plan, ribs).at(z=high if upper else 0)
            body = ag.weld(body, ag.detail(strip, "rib", plan.shell))
        made.append(body)
    base, lid = made
    at: tuple[ag.Scalar, ag.Scalar, ag.Scalar]
    if style == "trolley":
        at, up, tall = (0.42 * plan.wide, 0, high), ag.X, 0.010
    else:
        at, up, tall = (0, -0.3 * plan.deep, high), ag.Y, 0.012
    mark = details.logo(maker, tall if style != "attache" else 0.006)
    ink = controls.ink_on(plan.shell) if style == "tool_case" else plan.metal
    lid = ag.weld(lid, details.printed(mark, at, facing=ag.Z, up=up, material=ink))
    if style != "trolley":
        spots = [
            (x * (plan.wide / 2 - 0.04), y * (plan.deep / 2 - 0.04), 0) for x in (-1, 1) for y in (-1, 1)
        ]
        foot = ag.cylinder(0.011, 0.004, bevel=0.0008).at(z=-0.001)
        feet = ag.array(foot, at=spots)
        base = ag.weld(base, ag.part(feet, "foot", ag.material("rubber"), separate="four feet"))
    if style == "tool_case":
        base = ag.weld(base, _insert(plan, inner))
    return base, lid


def _ribs(plan: _Plan, count: int) -> ag.Solid:
    """Make raised strips about z = 0 on a large face: upright on a trolley, from front to back else."""
    if plan.style == "trolley":
        pitch = 0.72 * plan.deep / count
        rib = ag.box(0.72 * plan.wide, 0.5 * pitch, 0.005, bevel=0.0016)
        return ag.array(rib, at=[(-0.02 * plan.wide, y, 0) for y in controls.places(count, pitch)])
    pitch = plan.wide / (count + 1)
    rib = ag.box(0.20 * pitch, 0.56 * plan.deep, 0.007, bevel=0.0022)
    return ag.array(rib, at=[(x, 0.12 * plan.deep, 0) for x in controls.places(count, pitch)])


def _insert(plan: _Plan, inner: ag.Region) -> ag.Body:
    """Make the foam in the base of a tool case, with hollows for tools."""
    top = 0.72 * plan.low
    block = inner.shrink(0.0006, top=0, bottom=0).with_(z=(plan.wall, top))
    left, right = block.shrink(0.028, top=0, bottom=0).columns(2, 0.024)
    foam = ag.extrude(block.plan(radius=plan.radius - plan.wall), top - plan.wall).at(z=(top + plan.wall) / 2)
    for cell in (left, *right.layers(2, 0.022)):
        foam -= cell.with_(z=(0.4 * top, top + 0.01)).box()
    return ag.part(foam, "lining", _FOAM)


def _knuckles(plan: _Plan, *, upper: bool) -> ag.Body:
    """Make the leaves and barrels of two hinges at the back."""
    back, low, gap = plan.deep / 2, plan.low, FIT.running
    spans = ((-0.029, -0.015 - gap), (0.015 + gap, 0.029)) if upper else ((-0.015, 0.015),)
    rise = (0.0006, 0.016) if upper else (-0.016, -0.0006)
    made: list[ag.Solid] = []
    for place in (-0.30, 0.30):
        for start, end in spans:
            x = (place * plan.wide + start, place * plan.wide + end)
            leaf = ag.Region(x, (back - 0.0004, back + 0.0022), (low + rise[0], low + rise[1])).box()
            lip = (low + 0.0006, low + 0.0036) if upper else (low - 0.0036, low - 0.0006)
            web = ag.Region(x, (back, back + _PIVOT), lip).box()
            pin = ag.cylinder(0.0042, end - start, axis=ag.X, bevel=0.0004)
            arm = web | pin.at((x[0] + x[1]) / 2, back + _PIVOT, low)
            made.append(ag.bounding_collider(leaf | arm, leaf, ag.hull(arm)))
    return ag.part(made, "hinge", plan.metal)


def _latch(plan: _Plan, name: str) -> tuple[Fitting, ag.Joint]:
    """Make a latch about the seam, hinged at the base below it, and return it with its joint."""
    half = {"trolley": 0.015, "tool_case": 0.022, "attache": 0.016}[plan.style]
    axle = (0.0, -0.0070, -0.022)
    back = ag.Region((-half - 0.006, half + 0.006), (-0.0022, 0.0004), (-0.028, -0.010)).box()
    ears = []
    for side in (-1, 1):
        ear = ag.Region((-0.0025, 0.0025), (-0.0100, 0.0), (-0.0265, -0.0175)).box(bevel=0.0008)
        ears.append(ear.at(side * (half + 0.0035 - FIT.sliding / 2 + FIT.running)))
    fixed = ag.part(ag.union(back, *ears), "latch", plan.metal)
    plate = ag.Region((-half, half), (-0.0110, -0.0058), (-0.022, 0.026)).box(bevel=0.0016)
    lip = ag.Region((-0.012, 0.012), (-0.0080, -0.0014), (0.0130, 0.0172)).box()
    barrel = ag.cylinder(0.0036, 2 * half, axis=ag.X, bevel=0.0004).at(axle)
    tab = ag.Region((-0.6 * half, 0.6 * half), (-0.0140, -0.0085), (0.020, 0.032)).box(bevel=0.0016)
    hold = ag.grasp_on(plate, approach=ag.Y, closing=ag.X, at=(0, -0.0084, 0.002), depth=0.004)
    latch = ag.part(ag.union(plate, lip, barrel, tab), "latch", plan.metal, name=f"latch{name}", grasp=hold)
    clicks = feel.detents((0.0, 1.9), 0.35)
    turn = ag.Revolute(
        f"latch_turn{name}", axis=ag.X, pivot=axle, limits=(0, 1.9), detents=clicks, feel=_LATCH
    )
    return Fitting.moving(latch, turn, fixed=fixed), turn


def _handle(plan: _Plan) -> Fitting:
    """Make a handle at the front, which folds down onto the case."""
    half, reach = 0.062, 0.030
    bar = ag.Region((-half, half), (-0.0175, -0.0030), (-reach - 0.008, -reach + 0.008)).box(bevel=0.005)
    arm = ag.Region((-0.0045, 0.0045), (-0.0098, -0.0030), (-reach, 0.0035)).box(bevel=0.0010)
    solid = ag.union(bar, *(arm.at(side * (half - 0.0047)) for side in (-1, 1)))
    hold = ag.grasp_on(bar, approach=ag.Y, closing=ag.Z, depth=0.0095)
    grip = plan.metal if plan.style == "attache" and plan.shell.base_metalness > 0.5 else _BLACK
    handle = ag.part(solid, "handle", casting(grip, 0.7), name="handle", grasp=hold)
    ear = ag.Region((half + FIT.running, half + 0.011), (-0.0115, 0.0004), (-0.0075, 0.0075)).box(
        bevel=0.0012
    )
    fixed = ag.part([ear, ear.mirror(ag.X)], "hinge", plan.metal)
    turn = ag.Revolute("handle_turn", axis=-ag.X, pivot=(0, -0.0062, 0), limits=(0, 1.5), feel=_HANDLE)
    return Fitting.moving(handle, turn, fixed=fixed)


def _pull(plan: _Plan) -> Fitting:
    """Make the telescopic handle of a trolley, which slides along x, with the button in its grip."""
    long, apart = plan.wide - 0.05, 0.072
    travel = ag.min_(long - 0.09, 0.42)
    spots = [(0, -apart, 0), (0, apart, 0)]
    outline = (0.018, 0.011)
    tube = ag.box(long + 0.016, *outline, bevel=0.002).at(0.008 - long / 2)
    holes = ag.array(ag.box(0.06, *(size + 2 * FIT.sliding for size in outline)), at=spots)
    plate = ag.box(0.0035, 0.190, 0.032, bevel=0.001).at(0.0015)
    bezel = ag.detail(plate - holes, "tube", _BLACK)
    room = ag.Region((0.008, 0.033), (-0.090, 0.090), (-0.0135, 0.0135))
    cap = ag.Region((0.027, 0.037), (-0.017, 0.017), (-0.0065, 0.0065))
    grip = room.box(bevel=0.006) - cap.grow(FIT.sliding, left=0.005, right=0.02).box()
    hold = ag.grasp_on(room.box(), approach=-ag.X, closing=ag.Z, at=(0.02, 0.052, 0), depth=0.013)
    body = ag.weld(
        ag.part(grip, "grip", casting(_BLACK, 0.7), name="pull", grasp=hold),
        ag.part([tube.at(spot) for spot in spots], "tube", casting(ag.material("aluminium"), 0.35)),
    )
    key = cap.box(bevel=0.0012)
    button = ag.part(key, "button", plan.metal, push=ag.push_on(key, direction=-ag.X))
    spring = ag.Spring(preload=2.0, force=6.0)
    press = ag.Prismatic("button_press", axis=-ag.X, limits=(0, 0.003), spring=spring, feel=feel.SWITCH)
    slide = ag.Prismatic(
        "pull_slide", axis=ag.X, limits=(0, travel), friction=25.0, damping=20.0, effort=150.0
    )
    return Fitting.moving(body.attach(button, press), slide, fixed=bezel, cut=holes)


def _wheeled(base: ag.Body, lid: ag.Body, plan: _Plan, rolling: str) -> tuple[ag.Body, ag.Body]:
    """Put casters below both halves, or wheels below the base and feet below the lid."""
    casters = rolling == "casters"
    under, aside = -plan.wide / 2, plan.deep / 2 - 0.055
    apart = 0.008 if casters else 0.0  # from the middles: casters of both halves stay apart however they turn
    levels = (plan.low / 2 - apart, (plan.low + plan.high) / 2 + apart)
    wheel = fixings.caster(radius=_WHEEL, width=0.018, finish=_BLACK, swivel=casters).rotate(
        ag.Z, -math.pi / 2
    )
    for number, side in enumerate((-1, 1)):
        base = base.install(wheel.suffixed(f"_{number}"), at=(under, side * aside, levels[0]))
        if casters:
            lid = lid.install(wheel.suffixed(f"_{number + 2}"), at=(under, side * aside, levels[1]))
    if not casters:
        block = ag.box(_STAND + 0.001, 0.045, 0.030, bevel=0.006).at(
            under - _STAND / 2 + 0.0005, 0, levels[1]
        )
        feet = [block.at(y=side * aside) for side in (-1, 1)]
        lid = ag.weld(lid, ag.part(feet, "foot", casting(_BLACK, 0.5)))
    return base, lid
