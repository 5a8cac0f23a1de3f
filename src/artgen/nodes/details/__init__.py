"""Visual details: print, icons, dials, displays, screws, vents, seals and racks.

Most functions return profiles and solids for any use; `printed`, `raised`, `engraved`, `display`, `screw` and
`rating_plate` return visual bodies to be welded to a part.
"""

from artgen.nodes.details.dials import dial_band, dial_icons, dial_scale, pointer
from artgen.nodes.details.displays import display
from artgen.nodes.details.icons import ICONS, icon
from artgen.nodes.details.lettering import BRANDS, emblem, lettering, lettering_width, logo
from artgen.nodes.details.plates import rating_plate
from artgen.nodes.details.racks import bent_wires, wire_rack
from artgen.nodes.details.relief import engraved, printed, raised, relief, wrap, wrapped
from artgen.nodes.details.screws import drive_recess, rivet, screw, screw_head
from artgen.nodes.details.seals import foot, gasket
from artgen.nodes.details.vents import perforation, vent_slots

__all__ = [
    "BRANDS", "ICONS", "bent_wires", "dial_band", "dial_icons", "dial_scale", "display", "drive_recess",
    "emblem", "engraved", "foot", "gasket", "icon", "lettering", "lettering_width", "logo", "perforation",
    "pointer", "printed", "raised", "rating_plate", "relief", "rivet", "screw", "screw_head", "vent_slots",
    "wire_rack", "wrap", "wrapped",
]  # fmt: skip
