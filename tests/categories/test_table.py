"""What is special to a table: supports under raised leaves, a top that rises, drawers, sizes and masses."""

import math
from functools import lru_cache
from typing import Any

import mujoco
import pytest

from artgen.asset import Asset
from artgen.catalog import find

STYLES = ("desk", "side", "leaf", "lift")


@lru_cache(maxsize=12)
def made(seed: int, **given: Any) -> Asset:
    return find("table").generate(seed, on_collision="fail", **given)


def test_a_raised_leaf_lies_on_its_support_and_falls_without_it() -> None:
    asset = made(1, style="leaf")
    model = asset.to_mjspec().compile()
    data = mujoco.MjData(model)
    leaf, support = (model.joint(f"{name}_right").qposadr[0] for name in ("leaf_hinge", "support_slide"))
    _, out = asset.joint("support_slide_right").limits or (0.0, 0.0)
    for drawn, least, most in ((out, 1.52, math.pi / 2 + 0.01), (0.0, -0.02, 0.3)):
        mujoco.mj_resetData(model, data)
        data.qpos[leaf], data.qpos[support] = math.pi / 2 - 0.002, drawn
        mujoco.mj_step(model, data, nstep=round(4.0 / model.opt.timestep))
        assert least < data.qpos[leaf] < most


def test_a_support_comes_out_only_under_a_raised_leaf() -> None:
    asset = made(1, style="leaf")
    assert asset.blocked({"support_slide_left": 0.08})
    assert not asset.blocked({"support_slide_left": 0.08, "leaf_hinge_left": math.pi / 2})


def test_the_top_of_a_standing_desk_stays_where_it_is_put() -> None:
    asset = made(2, style="lift")
    model = asset.to_mjspec().compile()
    data = mujoco.MjData(model)
    lift = model.joint("top_lift").qposadr[0]
    data.qpos[lift] = 0.3
    mujoco.mj_step(model, data, nstep=round(2.0 / model.opt.timestep))
    assert data.qpos[lift] == pytest.approx(0.3, abs=0.002)


@pytest.mark.parametrize("columns", [1, 2, 3])
def test_drawers_keep_their_distance_in_every_position(columns: int) -> None:
    asset = made(3, style="desk", columns=columns)
    slides = [joint for joint in asset.joints if joint.name.startswith("drawer_slide")]
    assert len(slides) == columns
    open_ = {joint.name: joint.limits[1] for joint in slides if joint.limits}
    for positions in ({}, open_):
        gaps = asset.clearance(positions)
        assert min(gap for pair, gap in gaps.items() if "body" in pair) > 0.0015


@pytest.mark.parametrize("style", STYLES)
def test_sizes_and_masses_are_those_of_furniture(style: str) -> None:
    asset = made(4, style=style)
    low, high = asset.bounds()
    assert high[2] == pytest.approx(asset.parameters["height"], abs=1e-6)
    assert low[2] == pytest.approx(0.0, abs=1e-6)
    least, most = {"side": (6.0, 30.0), "leaf": (14.0, 40.0)}.get(style, (25.0, 75.0))
    assert least < asset.mass < most


@pytest.mark.parametrize("leg", ["tapered", "splayed"])
def test_a_round_leg_collides_as_a_piece_whose_ends_have_16_corners(leg: str) -> None:
    asset = made(1, style="desk", leg=leg, columns=1)
    hulls = [each.convex for each in asset.link("body").colliders if each.label == "leg"]
    assert len(hulls) == 4, "one for each leg"
    for hull in hulls:
        assert hull.faces.contact.sum(axis=0).max() == 16, (
            "MJX leaves out every second corner of a face with more than 20"
        )
