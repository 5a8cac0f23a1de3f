"""The details that make a panel look made: icons, scales, a display, screws and a logo, all only seen."""

from artgen import Body, Float, Y, box, category, cylinder, detail, material, part, text, uniform, weld
from artgen import details as d

PANEL, INK, STEEL = material("black_abs"), material("abs"), material("stainless")
MODES = ("power", "light", "defrost", "heat_both", "grill", "grill_fan", "convection", "hot_air", "pizza")


@category(labels=("panel", "knob", "print", "display", "screw"))
def panel(*, width: Float = uniform(0.32, 0.4, "m"), knob: Float = uniform(0.016, 0.02, "m")) -> Body:
    """The control panel of an oven."""
    bodies = [part(box(width, 0.02, 0.09, bevel=0.002).at(0, 0.01), "panel", PANEL)]
    numbers = [str(value) for value in range(50, 275, 25)]
    scale = d.dial_scale(knob + 0.003, 25, major_every=3, numbers=numbers)
    for side, around in ((-1, scale), (1, d.dial_icons(MODES, knob + 0.011, 0.0072))):
        x = side * (width / 2 - 0.05)
        bodies.append(d.printed(around, (x, 0, 0), material=INK))
        bodies.append(detail(cylinder(knob, 0.02, axis=Y, bevel=0.0015).at(x, -0.01), "knob", STEEL))
        bodies.append(d.printed(d.pointer(0.006, knob - 0.002, 0.0012), (x, -0.02, 0), material=PANEL))
        bodies.append(d.screw(0.003, (side * (width / 2 - 0.008), 0, 0.037), material=STEEL, drive="torx"))
    bodies.append(d.display("12:30", 0.055, 0.024, at=(0, 0, 0.012), color="amber"))
    for place, name in enumerate(("child_lock", "timer", "minus", "plus")):
        bodies.append(d.printed(d.icon(name, 0.0065), (-0.027 + 0.018 * place, 0, -0.016), material=INK))
    bodies.append(d.printed(text("TOUCH", 0.002), (0, 0, -0.026), material=INK))
    bodies.append(d.raised(d.logo(d.BRANDS[0], 0.0042, sign="peak"), (0, 0, 0.035), material=STEEL))
    return weld(*bodies)


asset = panel.generate(seed=3)
print(
    asset.name, "with", ", ".join(asset.links[0].labels), "in", asset.export("out/panel", formats=("mjcf",))
)
