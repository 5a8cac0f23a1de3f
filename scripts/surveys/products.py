"""Real products: the sizes and masses that are sold, one line for each category and kind of it.

Sizes are those of the whole thing at rest, with what sticks out of it, such as handles and levers, but
without what is only seen, such as a cord. A new category enters its line; where kinds of it differ, as a
table lamp and a floor lamp do, each has one.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from artgen.asset import Asset

Span = tuple[float, float]

_SLACK = 0.0005  # tolerance for rounding and bevels [m]


@dataclass(frozen=True)
class Product:
    """The range of the products of a kind."""

    kind: str  # short description
    width: Span  # range from left to right [m]
    depth: Span  # range from front to back [m]
    height: Span  # range from the ground [m]
    mass: Span  # range of the mass [kg]
    turns: bool = False  # whether either side may be the front

    def misfits(self, asset: Asset) -> list[str]:
        """Return the deviations of an asset from such products."""
        size = size_of(asset)
        both = (size, size[[1, 0, 2]]) if self.turns else (size,)
        deviations = [
            [
                f"{name} {length:.3f} m, {least:g} to {most:g} m are sold"
                for name, length, (least, most) in zip(
                    ("width", "depth", "height"), each, (self.width, self.depth, self.height), strict=True
                )
                if not least - _SLACK <= length <= most + _SLACK
            ]
            for each in both
        ]
        least, most = self.mass
        heavy = [] if least <= asset.mass <= most else [f"mass {asset.mass:.2f} kg, {least:g} to {most:g} kg"]
        return [*min(deviations, key=len), *heavy]


PRODUCTS: Mapping[str, tuple[Product, ...]] = {
    # leaves 0.61-1.07 x 1.98-2.44 m of 15-35 kg indoors and 30-60 kg outdoors, in frames of 0.03-0.09 m
    # at each side; softwood frames weigh 2-4 kg a metre
    "door": (
        Product("single door", (0.64, 1.30), (0.09, 0.36), (2.00, 2.75), (16.0, 110.0)),
        Product("double door", (1.25, 2.40), (0.09, 0.36), (2.00, 2.75), (30.0, 190.0)),
    ),
    # DIN EN 1116 and furniture: 0.30-0.60 m wide with one door, to 1.20 m with two; handles stand out by
    # 0.03 m, worktops by 0.04 m
    "cabinet": (
        Product("base cabinet", (0.29, 1.21), (0.37, 0.66), (0.71, 0.93), (10.0, 125.0)),
        Product("wall cabinet", (0.29, 1.01), (0.29, 0.44), (0.59, 0.93), (7.0, 50.0)),
        Product("tall cabinet", (0.29, 1.11), (0.37, 0.64), (1.59, 2.11), (22.0, 130.0)),
    ),
    # closed; wire arms lie back
    "clothespin": (
        Product("clothespin", (0.064, 0.092), (0.008, 0.016), (0.014, 0.028), (0.003, 0.013)),
        Product("bag clip", (0.056, 0.060), (0.059, 0.112), (0.017, 0.021), (0.018, 0.045)),
        Product("binder clip", (0.023, 0.070), (0.018, 0.052), (0.014, 0.048), (0.0015, 0.050)),
        Product("bulldog clip", (0.042, 0.070), (0.037, 0.077), (0.028, 0.050), (0.015, 0.095)),
        Product("hair claw", (0.038, 0.056), (0.058, 0.107), (0.056, 0.086), (0.012, 0.060)),
        Product("spring clamp", (0.095, 0.175), (0.015, 0.032), (0.055, 0.098), (0.02, 0.10)),
    ),
    # closed, the plunger pushed in
    "syringe": (
        Product("syringe", (0.070, 0.140), (0.015, 0.048), (0.009, 0.036), (0.0015, 0.036)),
        Product("glass syringe", (0.070, 0.112), (0.024, 0.042), (0.012, 0.029), (0.010, 0.095)),
        Product("pen for insulin", (0.150, 0.176), (0.016, 0.018), (0.017, 0.021), (0.022, 0.046)),
        Product("syringe for icing", (0.235, 0.300), (0.085, 0.095), (0.046, 0.052), (0.07, 0.35)),
    ),
    # roses of 0.05-0.08 m and levers of 0.10-0.16 m on a sample board of a shop
    "handle": (Product("handle on a stand", (0.15, 0.40), (0.10, 0.30), (0.20, 0.60), (1.5, 9.0)),),
    # plates of 0.56-0.92 x 0.50-0.56 m; dials and grates stand up to 0.05 m above them; a frame adds 0.02 m
    "cooktop": (Product("cooktop", (0.55, 0.94), (0.49, 0.58), (0.06, 0.16), (5.0, 20.0)),),
    # sample decks of 0.12-0.42 m in shops; spouts reach 0.10-0.25 m and turn, 0.12-0.45 m over the deck
    # one with a drain stands on a piece of a vanity top of up to 0.41 x 0.34 x 0.03 m, of stone up to 11 kg
    "faucet": (
        Product("faucet on a sample deck", (0.12, 0.50), (0.12, 0.45), (0.12, 0.55), (1.2, 14.0)),
        Product("faucet with its drain", (0.20, 0.42), (0.24, 0.36), (0.24, 0.50), (2.5, 17.0)),
    ),
    # sides of 0.15-0.80 m of board of 0.5-1.2 kg/m2; a strap, a bow or the end of a tape stands up by
    # 0.02-0.03 m; a full bottle weighs 1.25 kg
    "box": (
        Product("shipping box", (0.19, 0.76), (0.11, 0.73), (0.15, 0.66), (0.12, 4.5)),
        Product("carton that opens at its ends", (0.19, 0.79), (0.11, 0.73), (0.098, 0.30), (0.10, 4.0)),
        Product("mailer or pizza box", (0.18, 0.42), (0.12, 0.42), (0.055, 0.20), (0.05, 0.6)),
        Product("tray with a lid", (0.23, 0.43), (0.14, 0.32), (0.12, 0.30), (0.08, 0.8)),
        Product("wine box", (0.17, 0.40), (0.09, 0.30), (0.34, 0.37), (0.10, 16.5)),
        Product("gift box", (0.15, 0.31), (0.10, 0.33), (0.074, 0.18), (0.15, 1.2)),
    ),
    # bails lie in front, by up to 0.05 m before the rim, and stand out at both sides
    "bucket": (
        Product("household bucket", (0.23, 0.34), (0.24, 0.37), (0.18, 0.29), (0.25, 0.8)),
        Product("bucket of builders", (0.30, 0.39), (0.32, 0.43), (0.24, 0.34), (0.6, 1.4)),
        Product("galvanized bucket", (0.27, 0.37), (0.29, 0.40), (0.22, 0.32), (1.1, 2.2)),
        Product("wooden pail", (0.25, 0.34), (0.26, 0.36), (0.23, 0.33), (1.2, 3.0)),
        Product("cooler or pail", (0.18, 0.27), (0.15, 0.24), (0.18, 0.32), (0.9, 2.5)),
        Product("can of paint", (0.12, 0.29), (0.13, 0.31), (0.10, 0.27), (1.3, 15.0)),
    ),
    # the bar of a tool cart stands out by 0.07 m, wheels and bumpers by 0.02-0.05 m
    "cart": (
        Product("service trolley", (0.69, 0.97), (0.42, 0.61), (0.85, 0.99), (9.0, 25.0)),
        Product("drinks trolley", (0.62, 0.86), (0.42, 0.56), (0.75, 0.88), (7.0, 27.0)),
        Product("tool cart", (0.68, 0.86), (0.37, 0.50), (0.83, 0.99), (30.0, 60.0)),
        Product("platform", (0.74, 0.98), (0.46, 0.64), (0.84, 0.98), (9.0, 26.0)),
        Product("hand truck", (0.42, 0.58), (0.42, 0.58), (1.05, 1.28), (5.0, 15.0)),
    ),
    # with the stand; columns stand up above small screens by 0.02 m
    "display": (
        Product("monitor", (0.49, 0.64), (0.18, 0.26), (0.34, 0.52), (3.2, 9.0)),
        Product("television", (0.71, 0.99), (0.18, 0.36), (0.46, 0.67), (4.5, 14.0)),
    ),
    # lids and pulls stand out at the front by 0.013 m, a feeder above by 0.045 m
    "printer": (
        Product("inkjet printer with a scanner", (0.42, 0.48), (0.33, 0.41), (0.16, 0.34), (6.0, 12.0)),
        Product("laser printer", (0.36, 0.42), (0.37, 0.43), (0.21, 0.32), (7.0, 15.0)),
        Product("laser printer with a scanner", (0.39, 0.45), (0.39, 0.46), (0.34, 0.54), (12.0, 25.0)),
    ),
    # with folded feet; knobs stand 0.015 m above the case
    "keyboard": (
        Product("pad of macros", (0.080, 0.100), (0.090, 0.115), (0.030, 0.042), (0.11, 0.30)),
        Product("numeric pad", (0.080, 0.105), (0.100, 0.120), (0.014, 0.030), (0.06, 0.30)),
        Product("keyboard of 60 %", (0.290, 0.312), (0.100, 0.118), (0.014, 0.030), (0.2, 0.75)),
        Product("keyboard without a numeric pad", (0.352, 0.375), (0.120, 0.175), (0.014, 0.042), (0.3, 1.0)),
        Product("full keyboard", (0.430, 0.460), (0.120, 0.175), (0.014, 0.042), (0.38, 1.3)),
    ),
    # cables stick out by 0.082 m, receivers by 0.007 m
    "mouse": (
        Product("plain mouse", (0.057, 0.076), (0.106, 0.202), (0.034, 0.042), (0.065, 0.11)),
        Product("mouse for travel", (0.053, 0.062), (0.092, 0.112), (0.032, 0.039), (0.05, 0.085)),
        Product("mouse for games", (0.061, 0.079), (0.116, 0.212), (0.037, 0.044), (0.065, 0.11)),
        Product("mouse for the right hand", (0.061, 0.080), (0.110, 0.130), (0.040, 0.052), (0.09, 0.14)),
        Product("upright mouse", (0.060, 0.090), (0.108, 0.130), (0.062, 0.080), (0.11, 0.165)),
    ),
    # closed; handsets stand above a desk telephone by 0.033 m
    "phone": (
        Product("flip phone", (0.049, 0.055), (0.098, 0.110), (0.017, 0.023), (0.08, 0.13)),
        Product("slider", (0.048, 0.054), (0.097, 0.107), (0.015, 0.020), (0.095, 0.135)),
        Product("phone in one piece", (0.047, 0.053), (0.110, 0.128), (0.0125, 0.017), (0.07, 0.11)),
        Product("folding smartphone", (0.070, 0.074), (0.083, 0.089), (0.0145, 0.0185), (0.17, 0.20)),
        Product("desk telephone", (0.17, 0.21), (0.20, 0.24), (0.085, 0.13), (0.55, 1.0)),
    ),
    # with cells; the rings of fobs stick out by 0.032 m
    "remote": (
        Product("remote of a television", (0.045, 0.055), (0.14, 0.27), (0.020, 0.027), (0.07, 0.16)),
        Product("remote of a streaming stick", (0.038, 0.044), (0.11, 0.17), (0.018, 0.022), (0.04, 0.08)),
        Product("remote of an air conditioner", (0.052, 0.063), (0.15, 0.21), (0.023, 0.028), (0.09, 0.17)),
        Product("fob", (0.034, 0.046), (0.08, 0.13), (0.014, 0.019), (0.015, 0.06)),
    ),
    # bodies of 0.45 or 0.60 x 0.57-0.62 x 0.82-0.88 m; handles and hoses stand out by up to 0.06 m
    "dishwasher": (
        Product("slim dishwasher", (0.44, 0.46), (0.56, 0.68), (0.81, 0.89), (30.0, 45.0)),
        Product("dishwasher", (0.59, 0.61), (0.56, 0.68), (0.81, 0.89), (35.0, 55.0)),
    ),
    # bases of 0.08-0.18 m radius; arms and arcs reach farther
    "lamp": (
        Product("table lamp", (0.14, 0.90), (0.14, 0.90), (0.28, 0.90), (0.8, 8.0)),
        Product("floor lamp", (0.16, 1.60), (0.16, 1.60), (1.15, 2.05), (2.0, 22.0)),
    ),
    # cases of 0.44-0.60 x 0.32-0.45 x 0.25-0.34 m, of 17-32 litres; handles and dials stand 0.03 m out
    "microwave": (Product("microwave oven", (0.44, 0.60), (0.32, 0.46), (0.25, 0.34), (10.0, 18.0)),),
    # chests, bedside tables, filing cabinets and banks of 0.4-1.4 x 0.35-0.6 x 0.4-1.3 m; handles stand out
    # by 0.04 m, tops by 0.016 m at each side
    "drawer": (
        Product("bedside table", (0.39, 0.60), (0.34, 0.52), (0.40, 0.70), (8.0, 40.0)),
        Product("filing cabinet", (0.39, 0.94), (0.50, 0.66), (0.65, 1.31), (15.0, 110.0)),
        Product("chest of drawers", (0.59, 1.44), (0.40, 0.60), (0.68, 1.31), (25.0, 140.0)),
        Product("bank of drawers", (0.39, 1.41), (0.52, 0.66), (0.80, 0.94), (22.0, 170.0)),
    ),
    # fronts of 0.56-0.60 x 0.60-0.64 m for niches of 60 cm; ranges of 24-30 in, 0.85-0.92 m high, on which
    # grates stand up by 0.045 m; depths with handles
    "oven": (
        Product("built-in oven", (0.55, 0.61), (0.55, 0.66), (0.59, 0.65), (30.0, 45.0)),
        Product("range", (0.59, 0.77), (0.59, 0.66), (0.84, 0.97), (45.0, 90.0)),
    ),
    # cabinets of 0.55-0.92 x 0.60-0.80 x 0.80-1.83 m; handles stand out by up to 0.07 m, hinge caps by 0.03 m
    # shelves stand out by 0.30 m at both sides, handles and hinges by 0.06 m
    "grill": (
        Product("kettle", (0.50, 0.66), (0.52, 0.70), (0.88, 1.10), (7.0, 18.0)),
        Product("gas grill", (1.18, 1.42), (0.58, 0.68), (1.05, 1.25), (40.0, 65.0)),
        Product("ceramic egg", (0.38, 0.52), (0.45, 0.60), (0.92, 1.25), (36.0, 95.0)),
        Product("portable grill", (0.55, 0.68), (0.38, 0.46), (0.30, 0.42), (8.0, 15.0)),
        Product("contact grill", (0.33, 0.42), (0.34, 0.42), (0.14, 0.21), (4.0, 8.0)),
    ),
    # without the hood's duct above a cabinet; catches hang down by 0.022 m
    "range_hood": (
        Product("hood with a chimney", (0.59, 0.91), (0.45, 0.54), (0.70, 1.12), (9.5, 23.0)),
        Product("hood below a cabinet", (0.59, 0.61), (0.46, 0.54), (0.16, 0.23), (4.5, 9.5)),
        Product("telescopic hood", (0.59, 0.61), (0.27, 0.32), (0.34, 0.42), (7.0, 11.0)),
        Product("inclined hood", (0.58, 0.90), (0.35, 0.46), (0.78, 1.12), (12.0, 27.0)),
        Product("hood over an island", (0.89, 1.01), (0.59, 0.71), (0.70, 1.12), (18.0, 36.0)),
    ),
    # handles at the sides stand out by 0.02 m, dials and levers at the front by 0.03 m
    "rice_cooker": (
        Product("cooker with a hinged lid", (0.260, 0.30), (0.30, 0.39), (0.185, 0.24), (2.9, 4.7)),
        Product("upright cooker", (0.255, 0.295), (0.30, 0.37), (0.24, 0.31), (3.9, 7.0)),
        Product("cooker with a lever", (0.22, 0.33), (0.21, 0.32), (0.19, 0.30), (1.2, 3.2)),
        Product("pressure cooker", (0.32, 0.38), (0.30, 0.36), (0.29, 0.36), (4.8, 7.2)),
        Product("slow cooker", (0.37, 0.46), (0.26, 0.34), (0.20, 0.28), (3.6, 7.0)),
    ),
    "refrigerator": (
        Product("refrigerator", (0.54, 0.93), (0.58, 0.88), (1.20, 1.87), (50.0, 130.0)),
        Product("refrigerator under a counter", (0.54, 0.71), (0.58, 0.88), (0.79, 1.20), (25.0, 60.0)),
    ),
    # bodies of 0.25-0.40 x 0.15-0.32 x 0.18-0.22 m; levers, knobs and crumb trays stand out by up to 0.06 m
    "toaster": (Product("toaster", (0.24, 0.46), (0.14, 0.38), (0.17, 0.24), (1.0, 3.5), turns=True),),
    # pedals, lids that overhang and handles stand out of bodies of 0.15-0.45 m by up to 0.08 m
    "trashcan": (Product("trash can", (0.14, 0.53), (0.14, 0.53), (0.24, 0.83), (0.3, 10.0)),),
    # cases of 0.60 x 0.85 x 0.40-0.63 m, 0.51 x 0.70 x 0.46 m, in the USA 0.69 x 0.99 x 0.77 m; doors stand
    # out by 0.05 m, consoles of top loaders up by 0.16 m
    "washing_machine": (
        Product("washing machine or dryer", (0.505, 0.69), (0.43, 0.83), (0.69, 1.005), (38.0, 105.0)),
        Product("top loader", (0.525, 0.69), (0.53, 0.75), (0.94, 1.12), (35.0, 75.0)),
    ),
    # 0.12-0.40 m high and 50-75 mm wide; cranks reach out to 0.085 m
    "pepper_grinder": (Product("pepper mill", (0.045, 0.085), (0.045, 0.13), (0.12, 0.40), (0.10, 0.95)),),
    # bottles of 0.25-1.5 l, jars of 0.2-0.7 l, full; spouts and sprays stand out by up to 0.02 m
    "bottle": (
        Product("bottle", (0.057, 0.091), (0.057, 0.10), (0.15, 0.33), (0.3, 1.95)),
        Product("jar", (0.061, 0.081), (0.061, 0.081), (0.08, 0.155), (0.2, 1.15)),
    ),
    # frames of 0.4-2.4 x 0.5-1.8 m and 0.06-0.13 m deep; sills stand out by 0.05 m outside and 0.14 m inside,
    # shutters by 0.09 m; glass of two sheets weighs 20 kg/m2, frames and sashes 10-20 kg/m2
    "window": (Product("window", (0.47, 2.52), (0.10, 0.42), (0.49, 1.81), (8.0, 190.0)),),
    # 0.13-0.21 m high with the pump; spouts stand out by up to 0.055 m; those on walls come with a tile
    "soap_dispenser": (
        Product("soap bottle", (0.055, 0.095), (0.045, 0.11), (0.13, 0.215), (0.2, 0.9)),
        Product("soap dispenser on a wall tile", (0.09, 0.145), (0.07, 0.13), (0.19, 0.215), (0.6, 1.6)),
    ),
    # EN 997 and shops: 0.65-0.72 m from the wall with a cistern of 5-6 l, which is full; one that hangs has a
    # piece of its tiled wall of 0.6 x 0.13 x 1.16 m
    "toilet": (
        Product("toilet with a cistern", (0.345, 0.45), (0.62, 0.78), (0.70, 0.92), (30.0, 60.0)),
        Product("toilet on a wall", (0.595, 0.605), (0.57, 0.72), (1.15, 1.17), (70.0, 100.0)),
    ),
    # EN 1335-1 and shops; backs and arms stand above seats of 0.42-0.66 m
    "chair": (
        Product("office chair", (0.60, 0.74), (0.60, 0.74), (0.98, 1.34), (10.0, 20.0)),
        Product("bar stool", (0.38, 0.46), (0.38, 0.52), (0.55, 1.10), (7.0, 16.0)),
        Product("rolling stool", (0.52, 0.62), (0.52, 0.62), (0.42, 0.52), (5.0, 12.0)),
        Product("folding chair", (0.42, 0.46), (0.55, 0.65), (0.78, 0.84), (2.5, 7.0)),
        Product("recliner", (0.80, 0.96), (0.80, 0.92), (1.00, 1.30), (30.0, 60.0)),
        Product("recliner with arms of wood", (0.62, 0.78), (0.80, 0.92), (1.00, 1.30), (24.0, 45.0)),
    ),
    # EN 13310, EN 14688 and shops, with a tap of 0.1-0.45 m; a washbasin has its wall or pedestal
    "sink": (
        Product("kitchen sink in a worktop", (0.55, 1.50), (0.50, 0.64), (1.15, 1.40), (22.0, 150.0)),
        Product("bowl on a vanity", (0.55, 0.90), (0.48, 0.62), (0.95, 1.15), (20.0, 130.0)),
        Product("washbasin on a wall", (0.79, 0.81), (0.50, 0.72), (1.15, 1.17), (70.0, 130.0)),
        Product("washbasin on a pedestal", (0.50, 0.64), (0.42, 0.52), (0.90, 1.10), (15.0, 45.0)),
    ),
    # cabin and large trolleys, those of aluminium up to 7.3 kg; tool cases of 0.34-0.48 m; handles and
    # latches stand out by 0.01-0.02 m
    "suitcase": (
        Product("trolley case", (0.34, 0.60), (0.20, 0.32), (0.58, 0.82), (2.2, 7.3)),
        Product("tool case", (0.32, 0.50), (0.26, 0.43), (0.13, 0.20), (1.2, 4.5)),
        Product("attaché case", (0.41, 0.48), (0.30, 0.38), (0.10, 0.14), (1.8, 4.5)),
    ),
    # 12-16 inches; tabs and hinges stand out by up to 0.02 m
    "laptop": (
        Product("thin laptop", (0.30, 0.38), (0.20, 0.29), (0.017, 0.024), (0.8, 1.8)),
        Product("laptop with a tray", (0.30, 0.38), (0.20, 0.28), (0.026, 0.036), (1.6, 2.8)),
    ),
    # 1.0-1.7 l electric and 1.5-2.5 l for a stove, half full; spouts and handles stand out
    "kettle": (
        Product("electric kettle", (0.15, 0.19), (0.22, 0.34), (0.17, 0.28), (1.1, 2.4)),
        Product("stove kettle", (0.175, 0.235), (0.22, 0.30), (0.16, 0.25), (1.3, 2.8)),
    ),
    # 4-6 slices, and 3.8-6.2 l; handles stand out by 0.04-0.1 m
    "toaster_oven": (
        Product("toaster oven", (0.39, 0.49), (0.32, 0.41), (0.23, 0.30), (5.0, 10.5)),
        Product("air fryer", (0.24, 0.31), (0.36, 0.46), (0.28, 0.345), (4.0, 7.5)),
        Product("air fryer with two drawers", (0.37, 0.43), (0.38, 0.48), (0.28, 0.345), (7.0, 11.0)),
    ),
    # 8-12 cups; the handle of the jug stands out by 0.04 m; it is half full
    # shops, with lens and clip; levers and rings stand out
    "camera": (
        Product("compact camera", (0.094, 0.113), (0.024, 0.036), (0.055, 0.070), (0.12, 0.30)),
        Product("reflex camera", (0.126, 0.145), (0.115, 0.145), (0.095, 0.122), (0.55, 1.0)),
        Product("camera for film", (0.136, 0.153), (0.090, 0.112), (0.085, 0.102), (0.40, 0.95)),
        Product("instant camera", (0.105, 0.123), (0.090, 0.112), (0.105, 0.130), (0.35, 0.70)),
        Product("webcam", (0.075, 0.100), (0.040, 0.060), (0.070, 0.090), (0.07, 0.20)),
    ),
    # shops; rays stand out to 1.9 times the radius of the disc
    "clock": (
        Product("clock for a wall", (0.22, 0.39), (0.02, 0.05), (0.22, 0.39), (0.2, 2.4)),
        Product("clock with rays", (0.41, 0.73), (0.02, 0.05), (0.41, 0.73), (0.4, 3.0)),
        Product("clock with bells", (0.10, 0.14), (0.06, 0.09), (0.14, 0.19), (0.2, 0.6)),
        Product("mantel clock", (0.23, 0.30), (0.13, 0.18), (0.28, 0.51), (3.0, 6.5)),
        Product("regulator", (0.27, 0.36), (0.13, 0.18), (0.58, 0.95), (5.5, 10.5)),
        Product("longcase clock", (0.42, 0.54), (0.24, 0.30), (1.65, 2.30), (30.0, 52.0)),
        Product("alarm clock with digits", (0.12, 0.19), (0.05, 0.09), (0.055, 0.095), (0.13, 0.6)),
    ),
    "coffee_machine": (
        Product("filter machine", (0.16, 0.205), (0.27, 0.38), (0.31, 0.40), (2.2, 4.9)),
        Product("capsule machine", (0.10, 0.14), (0.31, 0.42), (0.23, 0.28), (2.3, 4.8)),
        Product("espresso machine", (0.20, 0.27), (0.38, 0.50), (0.33, 0.41), (4.5, 9.5)),
    ),
    # 1.5-2 l, empty; handles and cords stand out by 0.04-0.09 m
    "blender": (
        Product("blender", (0.175, 0.24), (0.24, 0.32), (0.40, 0.49), (2.6, 6.2)),
        Product("personal blender", (0.11, 0.165), (0.18, 0.23), (0.29, 0.39), (1.0, 1.9)),
    ),
    # 14-30 cm wide at the rim, chafing dishes to 39 cm; handles stand out by 0.03-0.06 m, long ones by 0.19 m
    "pot": (
        Product("saucepan or frying pan", (0.14, 0.31), (0.32, 0.49), (0.09, 0.20), (0.7, 2.8)),
        Product("stockpot or casserole", (0.24, 0.38), (0.21, 0.30), (0.13, 0.34), (2.0, 7.5)),
        Product("pressure cooker", (0.23, 0.27), (0.46, 0.52), (0.17, 0.26), (2.3, 4.0)),
        Product("chafing dish", (0.40, 0.50), (0.37, 0.46), (0.09, 0.17), (3.5, 7.5)),
    ),
    # EN 527-1 and shops, desks with two columns of drawers 50-70 kg; leaves hang at the sides, handles stand
    # out by 0.04 m, splayed legs by 0.02 m
    "table": (
        Product("desk", (1.0, 1.55), (0.54, 0.75), (0.71, 0.77), (22.0, 70.0)),
        Product("side table", (0.38, 0.64), (0.34, 0.50), (0.44, 0.64), (6.0, 26.0)),
        Product("drop-leaf table", (0.50, 0.82), (0.71, 0.92), (0.71, 0.77), (16.0, 45.0)),
        Product("standing desk", (1.14, 1.62), (0.61, 0.80), (0.64, 0.74), (24.0, 60.0)),
    ),
    # sample boards of a shop, 0.16-0.18 m wide on a foot of 0.13 m; an emergency stop stands out by 0.07 m
    "switch": (Product("switch on a board", (0.15, 0.19), (0.12, 0.17), (0.22, 0.28), (0.4, 1.5)),),
    # desk fans 0.30-0.41 m across, 1.8-4 kg; pedestal fans 0.42-0.47 m across, 1.0-1.35 m high, 3.5-7.5 kg;
    # box fans of 20 in on feet, 0.52-0.56 m wide, 3-5.5 kg; clip fans 0.16-0.21 m across, 0.5-1.2 kg
    "fan": (
        Product("desk fan", (0.30, 0.41), (0.23, 0.32), (0.38, 0.56), (1.8, 4.0)),
        Product("pedestal fan", (0.42, 0.47), (0.37, 0.47), (1.00, 1.35), (3.5, 7.5)),
        Product("box fan", (0.52, 0.56), (0.11, 0.18), (0.58, 0.64), (3.0, 5.5)),
        Product("clip fan", (0.16, 0.21), (0.17, 0.22), (0.26, 0.34), (0.5, 1.2)),
    ),
    # KitchenAid 5KSM125 and 5KSM175 8.5-12 kg with a tilting head, 5KSM55 and 5KSM7580 11-14 kg with a crank;
    # the depth counts a stub of the cord
    "stand_mixer": (
        Product("tilting head", (0.24, 0.275), (0.44, 0.50), (0.33, 0.37), (8.5, 12.0)),
        Product("bowl lift", (0.26, 0.31), (0.48, 0.54), (0.38, 0.45), (11.0, 14.0)),
    ),
    # hotel safes 0.40-0.43 x 0.20-0.25 x 0.35-0.40 m, 10-17 kg; home safes 8-20 kg; fire safes (UL 72) with
    # walls of 0.045-0.055 m, 26-80 kg; gun cabinets (EN 14450) 1.3-1.5 m high, 45-110 kg; handles stand out
    # by 0.03-0.05 m
    "safe": (
        Product("hotel safe", (0.40, 0.43), (0.375, 0.45), (0.195, 0.25), (10.0, 17.0)),
        Product("home safe", (0.31, 0.38), (0.24, 0.36), (0.23, 0.30), (8.0, 20.0)),
        Product("fire safe", (0.41, 0.46), (0.43, 0.54), (0.42, 0.62), (26.0, 80.0)),
        Product("gun cabinet", (0.30, 0.45), (0.30, 0.46), (1.30, 1.50), (45.0, 110.0)),
    ),
    # handles stand out by up to 0.07 m
    "shower": (
        Product("shower door in a niche", (0.74, 1.32), (0.72, 0.96), (1.88, 2.10), (32.0, 100.0)),
        Product("sliding shower door", (1.08, 1.62), (0.72, 0.98), (1.88, 2.08), (50.0, 125.0)),
        Product("corner or quarter circle", (0.78, 1.02), (0.78, 1.02), (1.88, 2.08), (48.0, 115.0)),
        Product("screen on a bath", (1.58, 1.82), (0.68, 0.83), (1.88, 2.08), (44.0, 66.0)),
    ),
    # 0.125-0.26 m long with bows of 0.06-0.09 m; forged tailor's shears weigh up to 0.4 kg
    "scissors": (
        Product("scissors", (0.055, 0.095), (0.122, 0.262), (0.008, 0.015), (0.02, 0.40)),
        Product("tongs", (0.04, 0.055), (0.23, 0.315), (0.03, 0.04), (0.09, 0.19)),
    ),
    # closed; sliders stand out by 3 mm
    "usb_stick": (
        Product("USB stick", (0.038, 0.075), (0.0165, 0.022), (0.0075, 0.0135), (0.007, 0.024)),
        Product("rugged USB stick", (0.074, 0.090), (0.021, 0.028), (0.021, 0.028), (0.03, 0.065)),
    ),
    # lying, closed; clips stand out by up to 2 mm
    "pen": (
        Product("pen", (0.126, 0.150), (0.009, 0.0145), (0.010, 0.017), (0.005, 0.04)),
        Product("marker", (0.128, 0.143), (0.0145, 0.0185), (0.0145, 0.0205), (0.012, 0.026)),
        Product("highlighter", (0.102, 0.113), (0.024, 0.028), (0.015, 0.019), (0.017, 0.03)),
    ),
    # closed; hinges, levers and triggers stand out by up to 8 mm
    "lighter": (
        Product("pocket lighter", (0.023, 0.045), (0.012, 0.018), (0.054, 0.084), (0.013, 0.13)),
        Product("table lighter", (0.069, 0.096), (0.069, 0.096), (0.070, 0.098), (0.18, 1.4)),
        Product("stick lighter", (0.248, 0.292), (0.034, 0.042), (0.016, 0.024), (0.045, 0.09)),
    ),
    # closed; studs, heads of screws and clips stand out by up to 5 mm
    "knife": (
        Product("pocket knife", (0.082, 0.130), (0.012, 0.022), (0.022, 0.033), (0.040, 0.22)),
        Product("cutter", (0.130, 0.175), (0.017, 0.030), (0.014, 0.028), (0.018, 0.11)),
        Product("utility knife", (0.148, 0.168), (0.019, 0.027), (0.033, 0.039), (0.12, 0.22)),
    ),
    # lenses of 46-58 mm, folded; tips of temples stand out by up to 0.01 m on both sides
    "eyeglasses": (
        Product("full rim", (0.132, 0.178), (0.018, 0.056), (0.024, 0.066), (0.016, 0.040)),
        Product("rimless", (0.132, 0.170), (0.018, 0.040), (0.022, 0.056), (0.012, 0.028)),
    ),
    # balls of 0.14-0.33 m on a foot, 0.32-0.40 m in a frame; a full meridian stands out by 0.02 m
    "globe": (
        Product("desk globe", (0.14, 0.38), (0.13, 0.36), (0.16, 0.46), (0.25, 4.5)),
        Product("floor globe", (0.42, 0.62), (0.42, 0.62), (0.85, 1.15), (3.2, 12.0)),
    ),
    # desk staplers of 20-30 sheets with the arm up; heavy ones with their lever; pliers lie on their side
    "stapler": (
        Product("desk stapler", (0.040, 0.050), (0.110, 0.200), (0.05, 0.085), (0.17, 0.50)),
        Product("heavy stapler", (0.064, 0.082), (0.28, 0.33), (0.17, 0.22), (1.3, 2.7)),
        Product("plier stapler", (0.07, 0.085), (0.155, 0.19), (0.017, 0.025), (0.2, 0.45)),
        Product("hole punch", (0.115, 0.16), (0.10, 0.135), (0.08, 0.115), (0.3, 0.55)),
    ),
    # DN 15-50 of brass, DN 15-100 of iron with flanges (EN 558, EN 1092-1); closed levers point to the front
    "valve": (
        Product("ball valve", (0.050, 0.112), (0.055, 0.20), (0.055, 0.105), (0.12, 1.6)),
        Product("gate valve", (0.148, 0.255), (0.16, 0.26), (0.35, 0.49), (9.0, 26.0)),
        Product("globe valve", (0.118, 0.235), (0.09, 0.19), (0.17, 0.28), (2.5, 13.0)),
        Product("butterfly valve", (0.098, 0.102), (0.23, 0.34), (0.18, 0.27), (2.8, 7.5)),
        Product("needle valves", (0.09, 0.22), (0.095, 0.11), (0.135, 0.145), (0.35, 1.5)),
    ),
    # 0.13-0.25 m long and 0.1-0.45 kg; closed handles are 0.04-0.09 m wide, grips up to 0.022 m thick
    "plier": (Product("pliers", (0.035, 0.095), (0.125, 0.256), (0.006, 0.024), (0.08, 0.46)),),
}
"""The products, by the name of the category."""


def size_of(asset: Asset) -> NDArray[np.float64]:
    """Return width, depth and height of an asset at rest, without visual details, shape (3,) [m]."""
    solids = [piece.shape.bounds() for link in asset.links for piece in link.pieces if not piece.visual]
    boxes = np.array(solids or [asset.bounds()])  # an asset from files has no solids
    size: NDArray[np.float64] = boxes[:, 1].max(axis=0) - boxes[:, 0].min(axis=0)
    return size


def misfits(asset: Asset) -> list[str]:
    """Return the deviations of an asset from the most similar product of its category."""
    deviations = [product.misfits(asset) for product in PRODUCTS.get(asset.category, ())]
    return min(deviations, key=len, default=[])
