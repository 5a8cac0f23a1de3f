"""Masses and centers of mass as numbers of the graph."""

import pytest

from artgen import Revolute, Y, box, detail, material, part, weld
from artgen.graph import Cache, Graph, Handle

STEEL = material("steel")


def value(handle: Handle):
    return Graph(handle).evaluate({}, Cache()).value


def test_a_body_weighs_what_its_links_weigh_together():
    arm = part(box(0.1, 0.1, 0.2).at(0.0, 0.0, 0.1), "arm", STEEL)
    base = part(box(0.2, 0.2, 0.1), "base", STEEL)
    body = base.attach(arm.at(1.0, 0.0, 0.0), Revolute("turn", axis=Y, limits=(0.0, 1.0)))
    assert value(body.mass()) == pytest.approx(7850.0 * (0.002 + 0.004))
    assert value(body.center_of_mass()) == pytest.approx((1.0 / 3.0, 0.0, 0.1 / 3.0))


def test_overlaps_count_once_and_details_weigh_nothing():
    block = part(box(0.1, 0.1, 0.1), "block", STEEL)
    both = weld(block, part(box(0.1, 0.1, 0.1), "block", STEEL), detail(box(1.0, 1.0, 1.0), "print", STEEL))
    assert value(both.mass()) == pytest.approx(7.85)
