"""The dispenser of water and ice in the front of a refrigerator's door."""

from artgen import Material, Scalar, box, cylinder, detail, details, frustum, material, part, rectangle, weld
from artgen.categories.shared.appliances.finish import DARK
from artgen.categories.shared.controls.panels import control_panel
from artgen.categories.shared.hardware.bar_handles import Grip, niche

_SHEET = 0.002


def dispenser(*, width: Scalar, height: Scalar, deep: Scalar, trim: Material, show: str) -> Grip:
    """Make a niche about the origin of the front y = 0, with spout, lever and tray, under a touch panel."""
    cut = box(width, deep + 0.010, height).at(0.0, deep / 2 - 0.005, 0.0)
    walls = niche(width, height, deep, sheet=_SHEET)
    panel_high = 0.072
    top, bottom = height / 2, -0.5 * height
    frame = rectangle(width + 0.022, height + 0.022, radius=0.008) - rectangle(
        width - 0.003, height - 0.003, radius=0.002
    )
    spout = frustum(0.009, 0.016, 0.03, bevel=0.002).at(0.0, 0.45 * deep, top - 0.016)
    lever = box(0.045, 0.006, 0.085, bevel=0.0025).at(0.0, deep - 0.0045, top - 0.085)
    slots = details.vent_slots(0.8 * width, 0.6 * deep, 7, slot=0.0026)
    tray = box(0.86 * width, 0.8 * deep, 0.006, bevel=0.0015).at(0.0, 0.48 * deep, bottom + 0.005)
    panel = control_panel(
        width + 0.022, panel_high, icons=("drop", "ice", "child_lock", "light"), show=show, color="cyan",
        screen=(0.05, 0.022), pitch=0.026,
    ).at(0.0, 0.0, top + 0.012 + panel_high / 2)  # fmt: skip
    return Grip(
        cut,
        weld(
            *(part(wall, "dispenser", DARK) for wall in walls),
            detail(details.relief(frame, proud=0.0022, bevel=0.0012), "dispenser", trim),
            detail(spout, "dispenser", material("chrome")),
            detail(cylinder(0.011, 0.004).at(0.0, 0.45 * deep, top - 0.003), "dispenser", trim),
            detail(lever, "dispenser", material("black_abs")),
            detail(tray, "dispenser", trim),
            details.printed(
                slots,
                (0.0, 0.48 * deep, bottom + 0.008),
                facing=(0.0, 0.0, 1.0),
                material=DARK,
                label="dispenser",
            ),
            panel,
        ),
    )
