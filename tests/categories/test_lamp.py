"""What is special to lamps: arms that hold, limits that follow from lengths, switches, chains, shades."""

import math
from functools import lru_cache
from typing import Any, get_args

import numpy as np
import pytest

from artgen import InfeasibleError, sqrt
from artgen.asset import Asset
from artgen.categories.lamp import Style, lamp
from artgen.categories.lamp.arms import Load
from artgen.feel import GRAVITY
from artgen.graph import Cache, Graph

STYLES: tuple[str, ...] = get_args(Style)
ARMED = ("desk", "architect", "led_bar", "reading", "arc")
HEIGHTS = {
    "desk": (0.35, 0.7),
    "architect": (0.35, 0.7),
    "led_bar": (0.35, 0.7),
    "table": (0.35, 0.7),
    "mushroom": (0.35, 0.7),
}
FLOOR = (1.2, 1.85)


@lru_cache(maxsize=64)
def _drawn(style: str, seed: int, more: tuple[tuple[str, Any], ...] = ()) -> Asset:
    return lamp.generate(seed, cache=Cache(), certify=False, style=style, **dict(more))


def drawn(style: str, seed: int, **more: Any) -> Asset:
    return _drawn(style, seed, tuple(more.items()))


def _step(asset: Asset, q: dict[str, float], joint: str) -> float:
    limits = asset.joint(joint).limits
    return -1e-5 if limits is not None and q.get(joint, 0.0) > sum(limits) / 2.0 else 1e-5


def torque(asset: Asset, joint: str, q: dict[str, float]) -> float:
    """Return the torque or force of gravity at a joint, from the masses of all links beyond it."""
    pose, step = asset.pose(q), _step(asset, q, joint)
    after = asset.pose({**q, joint: q.get(joint, 0.0) + step})
    change = 0.0
    for link in asset.links:
        center = np.append(link.mass_properties.center, 1.0)
        change += link.mass_properties.mass * GRAVITY * ((after[link.name] - pose[link.name]) @ center)[2]
    return -change / step


@pytest.mark.parametrize("style", STYLES)
def test_every_style_stands_in_the_size_of_shops(style: str) -> None:
    for seed in range(4):
        low, high = drawn(style, seed).bounds()
        least, most = HEIGHTS.get(style, FLOOR)
        assert least <= high[2] <= most, f"{style} {seed} is {high[2]:.3f} m high"
        assert low[2] == pytest.approx(0.0, abs=1e-6), f"{style} {seed} stands on {low[2]:.6f} m"


@pytest.mark.parametrize("style", ARMED)
def test_arms_hold_where_they_are_put(style: str) -> None:
    """Springs and brakes hold what gravity does, with 5 % to spare, wherever the other joints stand."""
    generator = np.random.default_rng(5)
    for seed in range(4):
        asset = drawn(style, seed)
        for _ in range(8):
            q = {
                joint.name: float(generator.uniform(*(joint.limits or (-math.pi, math.pi))))
                for joint in asset.free_joints
            }
            for joint in asset.free_joints:
                if joint.name.startswith("switch") or joint.name == "shade_turn":
                    continue
                spring = joint.stiffness * (joint.rest - q[joint.name])
                left = abs(torque(asset, joint.name, q) + spring)
                assert 1.05 * left <= joint.friction, (
                    f"{asset.name} {style}: {joint.name} is pulled by {left:.3f}, its brake holds "
                    f"{joint.friction:.3f}, at {q}"
                )


@pytest.mark.parametrize("style", ["desk", "architect", "reading", "led_bar"])
def test_nothing_that_arms_carry_gets_below_the_base(style: str) -> None:
    generator = np.random.default_rng(3)
    for seed in range(3):
        asset = drawn(style, seed)
        top = float(asset.links[0].colliders[0].convex.bounds()[1, 2]) if style != "reading" else 0.05
        for _ in range(16):
            q = {
                joint.name: float(generator.choice(joint.limits or (-2.0, 2.0)))
                for joint in asset.free_joints
                if not joint.name.startswith("switch")
            }
            pose = asset.pose(q)
            for link in asset.links:
                if not link.name.startswith(("arm", "shade")):
                    continue
                for collider in link.colliders:
                    points = collider.convex.outer_points()
                    lowest = float((points @ pose[link.name][:3, :3].T + pose[link.name][:3, 3])[:, 2].min())
                    assert lowest > top - 1e-3, (
                        f"{style} {seed}: {link.name} comes down to {lowest:.3f} m at {q}"
                    )


def test_the_springs_of_an_architect_lamp_carry_its_arms() -> None:
    """Over the range of each arm, springs leave the brake less to hold than gravity alone would."""
    asset = drawn("architect", 1)
    for name in ("arm_lower_hinge", "arm_upper_hinge"):
        joint = asset.joint(name)
        assert joint.limits is not None
        places = np.linspace(*joint.limits, 9)
        weights = np.array([torque(asset, name, {name: float(place)}) for place in places])
        springs = joint.stiffness * (joint.rest - places)
        alone, left = np.abs(weights).max(), np.abs(weights + springs).max()
        assert left < 0.9 * alone, f"{name}: {left:.2f} N m are left of {alone:.2f} N m"
        hand = (joint.friction + left) / 0.35
        assert 5.0 <= hand <= 25.0, f"{name}: a hand needs {hand:.1f} N at the end of the arm"
    assert any(link.label == "arm_lower" and "spring" in link.labels for link in asset.links)
    assert all("spring" not in link.labels for link in drawn("desk", 1).links)


def test_arms_turn_on_their_base_without_limits() -> None:
    for style in ARMED:
        assert drawn(style, 2).joint("arm_swivel").limits is None, f"{style} has a stop"
    slide = drawn("reading", 2).joint("height_slide")
    assert slide.limits is not None
    assert slide.limits[0] == 0.0
    assert 0.25 <= slide.limits[1] <= 0.40


@pytest.mark.parametrize(
    ("kind", "joint", "limits"),
    [
        ("button", "switch_slide", (0.0, 0.003)),
        ("rocker", "switch_rock", (-0.25, 0.25)),
        ("dial", "switch_turn", None),
    ],
)
def test_each_switch_moves_as_its_kind_does(
    kind: str, joint: str, limits: tuple[float, float] | None
) -> None:
    for style in ("desk", "floor", "table"):
        assert drawn(style, 1, switch=kind, switch_on="cord").joint(joint).limits == limits
    assert drawn("architect", 1, switch="button", switch_on="base").joint("switch_slide").axis[2] == -1.0


def test_a_chain_is_pulled_down_and_its_spring_takes_it_up() -> None:
    for seed in range(4):
        asset = drawn("floor", seed, switch="pull_chain", switch_on="socket")
        pull = asset.joint("switch_pull")
        chain = next(link for link in asset.links if link.name == "pull_chain")
        shade = next(link for link in asset.links if link.name == "shade")
        assert pull.limits is not None
        assert pull.axis.tolist() == [0.0, 0.0, -1.0]
        force = [pull.stiffness * (q - pull.rest) for q in pull.limits]
        weight = GRAVITY * chain.mass_properties.mass
        assert force[0] > weight + pull.friction, "the chain sags"
        assert 3.0 <= force[1] <= 8.0, f"it is pulled out with {force[1]:.1f} N"
        below = shade.bounds()[0, 2] - chain.bounds()[0, 2]
        assert below > 0.04, f"its knob hangs only {1e3 * below:.0f} mm below the shade"


def test_a_chain_hangs_out_of_its_switch_under_a_shade_however_small() -> None:
    small = {"switch": "pull_chain", "switch_on": "socket", "shade_radius": 0.06, "shade_height": 1.3}
    for style in ("floor", "tripod", "table"):
        asset = drawn(style, 2, chain_travel=0.03, **small)
        for pulled in (0.0, 0.015, 0.03):
            assert min(asset.clearance({"switch_pull": pulled}).values()) > 0.0002, f"{style} at {pulled}"


def test_a_chain_is_not_pulled_into_what_stands_under_it() -> None:
    deep = {"shade": "cone", "shade_radius": 0.105, "shade_height": 2.2}
    chain = {"switch": "pull_chain", "switch_on": "socket", "chain_travel": 0.07, "base_height": 0.024} | deep
    wide = {**chain, "body": "column", "body_radius": 0.11}
    for style, height, more in (("mushroom", 0.379, chain), ("table", 0.69, wide)):
        with pytest.raises(InfeasibleError, match="pulled into the part under it: raise height"):
            lamp.generate(2, style=style, height=height, attempts=1, **more)
    asset = drawn("mushroom", 2, height=0.405, **chain)
    assert 0.0 < asset.clearance({"switch_pull": 0.07})["base", "pull_chain"] < 0.005


def test_a_switch_in_the_base_is_not_under_what_stands_on_it() -> None:
    chosen = {"switch": "button", "switch_on": "base", "base_shape": "round"}
    for style, more in (("mushroom", {}), ("table", {"body": "column", "body_radius": 0.06})):
        with pytest.raises(InfeasibleError, match=r"cover the switch in it: raise base_radius"):
            lamp.generate(2, style=style, base_radius=0.1, attempts=1, **chosen, **more)
        asset = drawn(style, 2, base_radius=0.13, **chosen, **more)
        assert asset.clearance({"switch_slide": 0.003})["base", "button"] > 0.0002


def test_a_globe_does_not_reach_into_the_base_nor_a_shade_into_the_floor() -> None:
    globe = {"style": "mushroom", "shade": "globe", "shade_radius": 0.17, "base_height": 0.018}
    table = {"style": "table", "body": "column", "shade": "cone", "shade_radius": 0.26, "shade_height": 2.0}
    for chosen, low, high in ((globe, 0.36, 0.40), (table, 0.42, 0.62)):
        with pytest.raises(InfeasibleError, match=r"the body of the lamp has no room .*: raise height"):
            lamp.generate(2, height=low, attempts=1, **chosen)
        assert drawn(seed=2, height=high, **chosen)
    with pytest.raises(InfeasibleError, match=r"the shade would touch the floor, .*: raise height"):
        lamp.generate(2, height=0.46, attempts=1, switch="rocker", switch_on="cord", **table)


def test_a_reading_lamp_does_not_strike_its_base_with_its_clamp_down() -> None:
    chosen = {"style": "reading", "travel": 0.3, "arm_length": 0.4}
    assert lamp.generate(2, height=0.9, on_collision="fail", cache=Cache(), **chosen)
    with pytest.raises(InfeasibleError, match=r"strike the base at the lowest position of its clamp: raise"):
        lamp.generate(2, height=0.6, attempts=1, **chosen)


def test_a_wide_shade_on_a_short_arc_swings_to_its_bow_only_as_far_as_it_may() -> None:
    chosen = {"style": "arc", "shade": "dome", "base_radius": 0.18, "shade_height": 2.2, "reach": 0.3}
    asset = lamp.generate(2, shade_radius=0.18, on_collision="fail", cache=Cache(), **chosen)
    low, high = asset.joint("shade_hinge").limits
    assert low == -0.6, "away from its bow it swings freely"
    assert 0.1 < high < 0.4
    assert asset.clearance({"shade_hinge": high})["arm_lower", "shade"] < 0.02, "it could swing farther"
    with pytest.raises(InfeasibleError, match=r"the shade would strike the bow: raise reach, or lower"):
        lamp.generate(2, shade_radius=0.26, attempts=1, **chosen)


def test_an_arc_lamp_does_not_stand_on_a_base_like_a_tower() -> None:
    chosen = {"style": "arc", "shade_radius": 0.12}
    assert drawn(seed=2, base_radius=0.12, reach=0.62, **chosen)
    with pytest.raises(InfeasibleError, match=r"would be higher than wide: raise base_r"):
        lamp.generate(2, base_radius=0.08, reach=0.62, attempts=1, **chosen)


def test_a_shade_does_not_hang_down_to_the_switch_on_the_cord() -> None:
    chosen = {"style": "floor", "shade": "curved", "switch": "button", "switch_on": "cord"}
    wide = {"shade_radius": 0.26, "shade_height": 1.25}
    assert lamp.generate(2, height=0.38, on_collision="fail", cache=Cache(), **chosen, **wide)
    with pytest.raises(
        InfeasibleError, match=r"would touch the floor, the base or the switch on the cord: raise"
    ):
        lamp.generate(2, height=0.34, attempts=1, **chosen, **wide)


def test_a_globe_has_no_spider_and_a_dome_has_its_own_knob() -> None:
    globe = drawn("mushroom", 1, shade="globe")
    assert [link.name for link in globe.links if link.label == "shade"] == []
    assert "shade" in globe.links[0].labels
    domed = drawn("mushroom", 1, shade="dome")
    assert "finial" in next(link for link in domed.links if link.name == "shade").labels


def test_a_load_knows_its_extremes() -> None:
    def ends(load: Load) -> list[float]:
        return [
            float(Graph(value + sqrt(0.0)).evaluate({}, Cache()).value) for value in (load.low, load.high)
        ]

    low, high = ends(Load().lever(2.0, 0.5, -0.5, 2.0))
    assert low == pytest.approx(math.sin(-0.5))
    assert high == pytest.approx(1.0)
    low, high = ends(Load().lever(2.0, 0.5, 0.2, 1.0).free(1.0, 0.1))
    assert low == pytest.approx(math.sin(0.2) - 0.1)
    assert high == pytest.approx(math.sin(1.0) + 0.1)


def test_masses_are_those_of_lamps() -> None:
    for style in STYLES:
        for seed in range(4):
            weight = sum(link.mass_properties.mass for link in drawn(style, seed).links)
            low, high = (1.5, 8.0) if style in HEIGHTS else (1.8, 14.0)
            assert low <= weight <= high, f"{style} {seed} weighs {weight:.1f} kg"
