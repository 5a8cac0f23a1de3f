"""What is special to an oven: racks behind the door, the balanced door, a range's drawer."""

import itertools
import math
from functools import lru_cache
from typing import Any

import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import find
from artgen.errors import InfeasibleError
from artgen.feel import GRAVITY


@lru_cache(maxsize=16)
def made(seed: int, **given: Any) -> Asset:
    return find("oven").generate(seed, certify=False, **given)


def between(asset: Asset, q: dict[str, float], first: str, second: str) -> float:
    apart = asset.clearance(q)
    return apart.get((first, second), apart.get((second, first), math.inf))


@pytest.mark.parametrize(("seed", "build"), [(0, "built_in"), (1, "range"), (4, "built_in")])
def test_racks_come_out_only_over_the_open_door(seed: int, build: str) -> None:
    asset = made(seed, build=build, racks=3, burner="radiant")
    opened = asset.joint("door_hinge").limits[1]  # type: ignore[index]
    racks = [joint for joint in asset.joints if joint.name.startswith("rack_slide")]
    assert len(racks) == 3
    for joint in racks:
        assert joint.limits is not None
        out = joint.limits[1]
        assert 0.30 <= out <= 0.40
        assert asset.blocked({joint.name: out}) == (joint.name,)
        assert asset.blocked({joint.name: out, "door_hinge": opened}) == ()
        assert asset.blocked({joint.name: 0.005}) == (), "the play up to the closed door is free"
        child = joint.child
        assert between(asset, {joint.name: 0.2}, "door", child) < 0.0, "it would strike the closed door"
        assert between(asset, {joint.name: out, "door_hinge": opened}, "door", child) > 0.002


def test_the_higher_a_rack_the_sooner_it_comes_out() -> None:
    asset = made(0, build="built_in", racks=3, pan=False)
    angles = [asset.joint(f"rack_slide_{number}").needs.condition.value for number in range(3)]  # type: ignore[union-attr]
    assert angles[0] > angles[1] > angles[2] > 0.6


def test_a_pan_that_hangs_lower_waits_longer_than_a_rack_in_its_place() -> None:
    angles = [
        made(0, racks=2, pan=pan).joint("rack_slide_1").needs.condition.value  # type: ignore[union-attr]
        for pan in (False, True)
    ]
    assert angles[1] > angles[0]


@pytest.mark.parametrize("seed", [0, 6])
def test_racks_lie_on_rods_at_the_sides(seed: int) -> None:
    asset = made(seed)
    for joint in (each for each in asset.joints if each.name.startswith("rack_slide")):
        assert 0.0003 < between(asset, {}, "body", joint.child) < 0.0015


def weight_torque(asset: Asset, angle: float) -> float:
    """Return the torque by which gravity opens the door at an angle [N m]."""
    hinge, mass = asset.joint("door_hinge"), asset.link("door").mass_properties
    y, z = (mass.center - hinge.pivot)[1:]
    return float(GRAVITY * mass.mass * (z * math.sin(angle) - y * math.cos(angle)))


@pytest.mark.parametrize(
    ("seed", "given"), [(0, {}), (1, {}), (3, {"window": "none"}), (5, {"window": "full"}), (6, {})]
)
def test_springs_carry_the_door_and_friction_holds_it_where_it_is_left(
    seed: int, given: dict[str, Any]
) -> None:
    asset = made(seed, **given)
    hinge = asset.joint("door_hinge")
    assert hinge.limits is not None
    grasp = next(each for each in asset.link("door").grasps if each.name.startswith("handle"))
    lever = float(np.linalg.norm(grasp.frame[1:3, 3] - hinge.pivot[1:]))
    for angle in np.linspace(0.0, hinge.limits[1], 12):
        left = weight_torque(asset, angle) - hinge.stiffness * angle
        assert abs(left) < hinge.friction, f"the door would move by itself at {angle:.2f} rad"
        assert (hinge.friction - left) / lever < 45.0
    assert 3.5 <= asset.link("door").mass_properties.mass <= 11.0


@pytest.mark.parametrize("build", ["built_in", "range"])
def test_the_handle_of_the_open_door_stays_above_the_ground(build: str) -> None:
    asset = made(2, build=build, hinge_height=0.076 if build == "built_in" else 0.215, projection=0.046)
    opened = asset.joint("door_hinge").limits[1]  # type: ignore[index]
    low, high = asset.link("door").bounds()
    corners = np.array(
        [(x, y, z, 1.0) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])]
    )
    moved = corners @ asset.pose({"door_hinge": opened})["door"].T
    assert moved[:, 2].min() > 0.003


def test_a_drawer_passes_below_the_open_door() -> None:
    asset = made(1, build="range", drawer=True, burner="radiant", racks=1)
    out = asset.joint("drawer_slide").limits[1]  # type: ignore[index]
    assert out >= 0.28
    for angle in np.linspace(0.0, asset.joint("door_hinge").limits[1], 4):  # type: ignore[index]
        assert between(asset, {"door_hinge": angle, "drawer_slide": out}, "door", "drawer") > 0.002


def test_a_drawer_that_would_come_to_the_handle_of_the_open_door_is_ruled_out() -> None:
    given: dict[str, Any] = {
        "build": "range",
        "burner": "radiant",
        "drawer": True,
        "handle": "box",
        "depth": 0.72,
        "height": 0.86,
        "hinge_height": 0.22,
        "panel": 0.09,
        "projection": 0.038,
        "door_thickness": 0.055,
    }
    asset = made(3, **given, drawer_travel=0.79)
    q = {joint: asset.joint(joint).limits[1] for joint in ("door_hinge", "drawer_slide")}  # type: ignore[index]
    assert 0.002 < between(asset, q, "door", "drawer") < 0.02
    with pytest.raises(InfeasibleError, match="the handle of the open door would strike the drawer"):
        made(3, **given, drawer_travel=0.82, attempts=1)


@pytest.mark.parametrize(
    ("racks", "pan", "fits", "meets"),
    [(3, True, 0.100, 0.110), (3, False, 0.130, 0.140), (2, True, 0.260, 0.280)],
)
def test_racks_for_which_the_cavity_is_too_low_are_ruled_out(
    *, racks: int, pan: bool, fits: float, meets: float
) -> None:
    given: dict[str, Any] = {"build": "built_in", "racks": racks, "pan": pan, "height": 0.6, "panel": 0.1}
    names = [f"rack_{number}" for number in range(racks)]
    asset = made(3, **given, hinge_height=fits)
    for lower, upper in itertools.pairwise(names):
        assert between(asset, {}, lower, upper) > 0.001
    with pytest.raises(
        InfeasibleError, match="racks would collide with each other or with the heating element"
    ):
        made(3, **given, hinge_height=meets, attempts=1)


@pytest.mark.parametrize(("build", "dials"), [("built_in", 0), ("built_in", 3), ("range", 6)])
def test_dials_turn_clockwise_from_off(build: str, dials: int) -> None:
    asset = made(7, build=build, dials=dials)
    turned = [joint for joint in asset.joints if joint.name.startswith("dial_turn")]
    assert len(turned) == dials
    for joint in turned:
        assert joint.limits == (0.0, pytest.approx(4.7))
        np.testing.assert_allclose(joint.axis, (0.0, 1.0, 0.0))


@pytest.mark.parametrize(
    "given",
    [
        {"build": "built_in", "width": 0.56, "height": 0.60, "depth": 0.56, "racks": 3, "pan": True},
        {"build": "range", "width": 0.60, "height": 0.85, "depth": 0.60, "dials": 6, "show": "12:30"},
        {
            "build": "range",
            "burner": "gas",
            "burners": 5,
            "width": 0.76,
            "dials": 6,
            "racks": 3,
            "drawer": True,
        },
        {"build": "built_in", "handle": "box", "window": "none", "door_thickness": 0.046, "travel": 0.36},
    ],
)
def test_the_ends_of_its_sizes_are_proven_free_of_collisions(given: dict[str, Any]) -> None:
    asset = find("oven").generate(4, on_collision="fail", **given)
    assert asset.certificate is not None
    assert asset.certificate.proven
    assert max(len(link.colliders) for link in asset.links) <= 64
    assert sum(len(link.colliders) for link in asset.links) < 200
