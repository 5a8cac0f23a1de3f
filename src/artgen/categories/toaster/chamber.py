"""The chamber of a toaster: sheets of mica with ribbons of wire, guides for the bread, walls at both ends."""

from itertools import pairwise

import artgen as ag
from artgen.categories.toaster.plan import Plan

GAP = 0.006
"""Half of the gap in the front wall in which a carriage moves [m]."""

_MICA = 0.0085  # from the side of a slot to its sheet of mica [m]
_WALL = 0.0015  # thickness of the walls [m]
_GUIDE = 0.0009  # radius of the guide wires [m]
_LOW = 0.014  # how far over the floor of the sleeve the chamber begins, over the crumb tray [m]
_RIBBONS = 9


def _mica() -> ag.Material:
    """Return the material of the sheets that carry the heating wires: pressed mica, with air between."""
    return ag.material("mdf").with_(
        name="mica", base_color=(0.36, 0.30, 0.21), specular_roughness=0.4, density=500.0, texture=""
    )


def _heating_wire() -> ag.Material:
    """Return the material of cold heating ribbons, oxidised by use."""
    return ag.material("steel").with_(
        name="heating_wire", base_color=(0.20, 0.11, 0.08), specular_roughness=0.45, texture=""
    )


def chamber(plan: Plan) -> ag.Body:
    """Make what is around the slots inside, to be welded to the shell."""
    begin, end = plan.chamber
    middle, long = 0.5 * (begin + end), end - begin
    low, high = plan.floor + _LOW, plan.top - 0.002  # into the sheet of the top
    tall, level = high - low, 0.5 * (low + high)
    sides = [(x, side) for x in plan.middles for side in (-1, 1)]

    outer = ag.box(0.001, long + 0.002, tall)
    inner = ag.box(plan.bridge - 2 * _MICA + 0.001, long + 0.002, tall)  # sheets of two slots, back to back
    edge = plan.span / 2 + _MICA
    between = [0.5 * (left + right) for left, right in pairwise(plan.middles)]
    sheets = [outer.at(side * edge, middle, level) for side in (-1, 1)]
    sheets += [inner.at(x, middle, level) for x in between]
    ribbon = ag.box(0.0006, long - 0.016, 0.0024).at(0.0, middle, low + 0.012)
    ribbons = ag.array(
        ribbon, at=ag.row((0.0, 0.0, 0.0), (0.0, 0.0, (tall - 0.030) / (_RIBBONS - 1)), _RIBBONS)
    )
    places = [(x + side * (plan.slot_width / 2 + _MICA - 0.0007), 0.0, 0.0) for x, side in sides]
    steel = ag.material("stainless")
    liner = ag.box(plan.width - 0.044, plan.length - plan.cap - 0.018, 0.0006).at(
        0.0, 0.0, plan.floor + 0.0001
    )
    return ag.weld(
        ag.part(_walls(plan, level, tall), "chamber", steel.with_(name="chamber_steel", density=3500.0)),
        ag.part(ag.union(*sheets), "heating_element", _mica()),
        ag.detail(ag.array(ribbons, at=places), "heating_element", _heating_wire()),
        *_guides(plan, level, tall, steel),
        ag.detail(liner, "chamber", steel.with_(name="liner", base_color=(0.33, 0.33, 0.33))),
    )


def _walls(plan: Plan, level: ag.Float, tall: ag.Float) -> ag.Solid:
    """Make the wall at the back, and the one before the bay, which leaves the carriages a gap per slot."""
    begin, end = plan.chamber
    half = plan.span / 2 + _MICA + 0.0006  # within the bevels of a classic body
    back = ag.box(2 * half, _WALL, tall).at(0.0, end + _WALL / 2, level)
    edges = [-half, *(x + side * GAP for x in plan.middles for side in (-1, 1)), half]
    boards = [
        ag.board((left, right), (begin - _WALL, begin), (level - tall / 2, level + tall / 2))
        for left, right in zip(edges[::2], edges[1::2], strict=True)
    ]
    return ag.union(back, *boards)


def _guides(plan: Plan, level: ag.Float, tall: ag.Float, steel: ag.Material) -> tuple[ag.Body, ag.Body]:
    """Make the guides at both sides of all slots: a rod along each; upright wires on it are only seen."""
    begin, end = plan.chamber
    count = 8 if plan.long else 5
    first, last = begin + 0.008, end - 0.008
    wire = ag.cylinder(_GUIDE, tall - 0.004).at(0.0, first, level + 0.002)
    wires = ag.array(wire, at=ag.row((0.0, 0.0, 0.0), (0.0, (last - first) / (count - 1), 0.0), count))
    low = level - 0.1 * tall
    rod = ag.cylinder_between((0.0, begin - 0.001, low), (0.0, end + 0.001, low), _GUIDE)
    at = [(x + side * (plan.slot_width / 2 + _GUIDE), 0.0, 0.0) for x in plan.middles for side in (-1, 1)]
    return ag.part(ag.array(rod, at=at), "guide_wire", steel), ag.detail(
        ag.array(wires, at=at), "guide_wire", steel
    )
