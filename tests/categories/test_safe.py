"""What is special to a safe: the lock holds the handle, the bolts hold the door, sizes and masses."""

from functools import lru_cache
from pathlib import Path
from typing import Any

import mujoco
import pytest

from artgen.asset import Asset
from artgen.catalog import find
from artgen.errors import InfeasibleError
from artgen.validate.behavior import check_behavior

LOCKS = {"key": "key_turn", "dial": "dial_turn", "keypad": "tongue_slide"}


@lru_cache(maxsize=12)
def made(seed: int, **given: Any) -> Asset:
    return find("safe").generate(seed, on_collision="fail", **given)


def end(asset: Asset, name: str) -> float:
    return (asset.joint(name).limits or (0.0, 0.0))[1]


@pytest.mark.parametrize("lock", LOCKS)
def test_lock_handle_and_door_open_in_this_order(lock: str) -> None:
    asset = made(1, style="home", lock=lock)
    leader, turn = LOCKS[lock], end(asset, "handle_turn")
    unlocked = {leader: end(asset, leader)}
    assert asset.blocked({"handle_turn": 0.5 * turn})
    assert asset.blocked({"door_hinge": 0.05} | unlocked)
    assert not asset.blocked({"handle_turn": turn} | unlocked)
    assert not asset.blocked({"door_hinge": 1.0, "handle_turn": turn} | unlocked)
    assert not asset.blocked({"door_hinge": 1.0}), "the bolts may stand out of an open door"


@pytest.mark.parametrize("style", ["hotel", "gun"])
def test_bolts_behind_the_frame_hold_the_door(style: str) -> None:
    asset = made(2, style=style, lock="keypad")
    turn, solenoid = end(asset, "handle_turn"), end(asset, "tongue_slide")
    model = asset.to_mjspec().compile()
    for drawn in (False, True):
        data = mujoco.MjData(model)
        state = {"handle_turn": turn, "tongue_slide": solenoid} if drawn else {}
        for name, value in asset.positions(state).items():
            data.joint(name).qpos = value
        for _ in range(300):
            data.joint("door_hinge").qfrc_applied = 12.0
            mujoco.mj_step(model, data)
        assert (data.joint("door_hinge").qpos[0] > 0.2) == drawn
        assert (data.joint("door_hinge").qpos[0] < 0.02) != drawn


def test_bolts_go_in_by_their_throw() -> None:
    asset = made(3, style="fire")
    pose = asset.pose({"handle_turn": end(asset, "handle_turn")})["bolts"]
    tip = asset.link("bolts").bounds()[1][0]
    edge = asset.link("door").bounds()[1][0]
    frame = asset.parameters["width"] / 2 - asset.parameters["wall"] - 0.018
    assert tip > frame + 0.010, "thrown, they stand behind the frame"
    assert tip + pose[0, 3] < edge, "drawn, they are inside the door"


@pytest.mark.parametrize(
    ("style", "masses"),
    [("hotel", (9.0, 18.0)), ("home", (7.0, 17.0)), ("fire", (28.0, 75.0)), ("gun", (45.0, 105.0))],
)
def test_masses_are_those_of_shops(style: str, masses: tuple[float, float]) -> None:
    assert masses[0] < made(4, style=style).mass < masses[1]


@pytest.mark.parametrize("seed", [233, 490])
def test_the_tongue_holds_the_handle_against_a_hand(seed: int, tmp_path: Path) -> None:
    asset = find("safe").generate(seed, certify=False)
    found = check_behavior(asset, asset.export(tmp_path / asset.name, formats=("mjcf",), textures=0))
    assert not found.faults, found.faults


@pytest.mark.parametrize(("style", "least"), [("fire", 0.42), ("gun", 0.6)])
def test_a_safe_that_is_too_low_for_its_lock_is_refused(style: str, least: float) -> None:
    assert made(1, style=style, height=least).certificate
    with pytest.raises(InfeasibleError, match=f"height of a {style} safe must be >= {least:g} m"):
        made(1, style=style, height=least - 0.01)


def test_thick_walls_are_for_fire_safes() -> None:
    assert made(1, style="home", wall=0.01).certificate
    with pytest.raises(InfeasibleError, match=r"only fire safes have thick walls: wall must be <= 0\.01 m"):
        made(1, style="home", wall=0.02)
