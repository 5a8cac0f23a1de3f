"""Detents: their law, in MuJoCo and against its potential; reading them back; what is refused."""

import json
import math
import re
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import pytest

import artgen as ag
from artgen import feel
from artgen.asset import Asset, AssetJoint
from artgen.asset.valid_states import ValidStates
from artgen.errors import ArtgenError
from artgen.graph import Graph
from artgen.validate import validate

ROUND = {"axis": (0.6, 0.0, 0.8), "detents": feel.detents(9, torque=0.04)}
LEVELS = {"axis": (0.6, 0.0, 0.8), "limits": (-1.0, 1.4), "detents": feel.detents((-0.9, -0.2, 1.3), 0.3)}
ROCKER = {"axis": ag.X, "limits": (-0.2, 0.2), "detents": feel.detents((-0.3, 0.3), torque=0.02)}
SLIDE = {"axis": (0.0, 0.6, 0.8), "limits": (0.0, 0.05), "detents": feel.detents((0.0, 0.01, 0.04), 4.0)}
KINDS: list[tuple[Any, dict[str, Any]]] = [
    (ag.Revolute, ROUND), (ag.Revolute, LEVELS), (ag.Revolute, ROCKER), (ag.Prismatic, SLIDE),
]  # fmt: skip


def made(kind: Any = ag.Revolute, **given: Any) -> Asset:
    """Return a knob without friction before a panel that moves, so that both have frames of their own."""
    panel = ag.part(ag.box(0.06, 0.02, 0.06).at(0.3, 0.1, 0.2), "panel", ag.material("abs"))
    knob = ag.part(ag.sphere(0.010).at(0.3, 0.05, 0.2), "knob", ag.material("abs"))
    other = ag.part(ag.box(0.06, 0.02, 0.06).at(0.3, 0.2, 0.2), "base", ag.material("abs"))
    lift = ag.Prismatic("lift", axis=ag.Z, limits=(0.0, 0.1), friction=30.0, damping=1.0)
    joint = kind("turn", **{"pivot": (0.31, 0.05, 0.2), "armature": 1e-3, "damping": 0.01} | given)

    @ag.generator
    def dial() -> ag.Body:
        return other.attach(panel.attach(knob, joint), lift)

    return dial.generate(0, certify=False)


def potential(joint: AssetJoint, q: np.ndarray) -> np.ndarray:
    """Return the energy of one spring at each ridge, from the distance of its ends in the plane [J]."""
    result = np.zeros_like(q)
    assert joint.detents is not None
    for ridge, gap in joint.ridges:
        if joint.kind == "prismatic":
            reach, length, stiffness = gap / 2, abs(q - ridge), joint.detents.torque / (gap / 2)
        else:
            reach = abs(np.exp(0.5j * gap) - 1.0)
            length = abs(np.exp(1j * q) - np.exp(1j * ridge))
            stiffness = joint.detents.torque / reach
        result += 0.5 * stiffness * np.maximum(reach - length, 0.0) ** 2
    return result


@pytest.mark.parametrize(("kind", "given"), KINDS)
def test_the_law_is_the_slope_of_springs_and_mujoco_has_it(kind: Any, given: dict[str, Any]) -> None:
    asset = made(kind, **given)
    joint = asset.joint("turn")
    low, high = joint.limits or (-4.0, 9.0)
    q = np.random.default_rng(1).uniform(low - 0.1 * (high - low), high + 0.1 * (high - low), 400)
    q = q[
        [min(abs(math.remainder(each - ridge, math.tau)) for ridge, _ in joint.ridges) > 1e-4 for each in q]
    ]
    assert joint.detents is not None
    step, most = 1e-7 * (high - low), joint.detents.torque
    slope = (potential(joint, q - step) - potential(joint, q + step)) / (2 * step)
    assert joint.detent_torque(q) == pytest.approx(slope, abs=1e-5 * most)
    assert 0.9 * most < abs(joint.detent_torque(q)).max() <= most
    model = asset.to_mjspec().compile()
    data, found = mujoco.MjData(model), []
    for lift, each in zip(np.linspace(0.0, 0.1, len(q)), q, strict=True):
        data.joint("lift").qpos, data.joint("turn").qpos = lift, each
        mujoco.mj_forward(model, data)
        found.append(float(data.joint("turn").qfrc_passive[0]))
    assert found == pytest.approx(joint.detent_torque(q), abs=1e-6 * most)


def test_a_released_knob_stops_at_the_nearest_detent_as_the_law_says() -> None:
    asset = made(**ROUND)
    joint, model = asset.joint("turn"), asset.to_mjspec().compile()
    model.opt.timestep, model.opt.gravity = 0.0005, 0.0
    data = mujoco.MjData(model)
    at = float(data.joint("turn").qpos[0])
    data.joint("turn").qpos = at + 0.3
    mujoco.mj_forward(model, data)
    inertia, q, speed = float(1.0 / data.joint("turn").qacc[0] * joint.detent_torque(0.3)), 0.3, 0.0
    swing: list[tuple[float, float]] = []
    for _ in range(12000):
        mujoco.mj_step(model, data)
        # the same step with the law alone; the damping is implicit, as in MuJoCo
        speed = (inertia * speed + 0.0005 * float(joint.detent_torque(q))) / (
            inertia + 0.0005 * joint.damping
        )
        q += 0.0005 * speed
        swing.append((float(data.joint("turn").qpos[0]), q))
    simulated, expected = np.array(swing).T
    assert abs(simulated - expected).max() < 0.01 * 0.3, "within 1 % of the motion"
    assert abs(simulated[-1]) < 0.002


def test_a_rocker_snaps_to_one_of_its_ends_and_stays() -> None:
    asset = made(**ROCKER)
    model = asset.to_mjspec().compile()
    for start in (-0.02, 0.02):
        data = mujoco.MjData(model)
        data.joint("turn").qpos = start
        for _ in range(3000):
            mujoco.mj_step(model, data)
        end = float(data.joint("turn").qpos[0])
        assert end == pytest.approx(math.copysign(0.2, start), abs=0.01)
        assert float(asset.joint("turn").detent_torque(end)) * start > 0.0, "it presses on its stop"


@pytest.mark.parametrize("change", ["stiffness", "name", "pos", "none"])
def test_changed_detents_are_found_in_the_file(change: str, tmp_path: Path) -> None:
    asset = made(**LEVELS)
    folder = asset.export(tmp_path, formats=("mjcf",), textures=0)
    assert not validate(folder, behavior=False, checks=["mjcf"]).faults
    path = folder / f"{asset.name}.xml"
    text = path.read_text(encoding="utf-8")
    changed = {
        "stiffness": text.replace('turn_ridge_0" stiffness="', 'turn_ridge_0" stiffness="1'),
        "name": text.replace('<spatial name="turn_ridge_0"', '<spatial name="pull"'),
        "pos": re.sub(r'(site name="turn_detent" pos=")[0-9.e-]+', r"\g<1>0.02", text),
        "none": re.sub(r"<tendon>.*</tendon>", "", text, flags=re.DOTALL),
    }[change]  # fmt: skip
    assert changed != text
    path.write_text(changed, encoding="utf-8")
    faults = [str(each) for each in validate(folder, behavior=False, checks=["mjcf"]).faults]
    expected = "other <tendon> than the detents" if change in ("name", "none") else "its detents in"
    assert any(expected in each for each in faults), faults


def test_other_formats_record_them_as_data(tmp_path: Path) -> None:
    asset = made(**ROUND)
    folder = asset.export(tmp_path, textures=0)
    loaded = Asset.load(folder)
    assert loaded.joint("turn").detents == asset.rounded().joint("turn").detents
    assert loaded.joint("lift").detents is None
    for suffix in (".urdf", ".usda"):
        text = (folder / f"{asset.name}{suffix}").read_text(encoding="utf-8")
        states = next(json.loads(each) for each in re.findall(r'(\{"format":"artgen-states-1".*\})', text))
        row = next(each for each in states["joints"] if each["name"] == "turn")
        assert row["detents"]["torque"] == 0.04
        assert len(row["detents"]["positions"]) == 9
        assert ValidStates.read(folder / f"{asset.name}{suffix}").dofs == ("lift", "turn")
    record = json.loads((folder / "asset.json").read_text(encoding="utf-8"))
    lost = {name: [each["feature"] for each in form["losses"]] for name, form in record["formats"].items()}
    assert {name: "joint detents" in features for name, features in lost.items()} == {
        "urdf": True, "mjcf": False, "usd": True,
    }  # fmt: skip


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"detents": feel.detents((0.5, 0.1), 0.1)}, "positions of detents are 0.5, 0.1: give them from low"),
        ({"detents": feel.detents((), 0.1)}, "positions of detents are missing"),
        ({"detents": feel.detents((0.0, 0.5), 0.0)}, "torque of detents is 0: it must be positive"),
        ({"detents": feel.detents((0.0, 7.0), 0.1)}, "from 0 to 7 rad: they must lie in one turn"),
        (
            {"detents": feel.detents((0.0, 0.2), 0.1), "limits": (0.5, 1.0)},
            "no two detents around a position",
        ),
    ],
)
def test_what_makes_no_sense_is_refused(given: dict[str, Any], message: str) -> None:
    with pytest.raises(ArtgenError, match=re.escape(message)):
        made(axis=ag.X, **given)


def test_a_joint_beside_another_one_is_refused() -> None:
    panel = ag.part(ag.box(0.06, 0.02, 0.06), "panel", ag.material("abs"))
    knob = ag.part(ag.sphere(0.010).at(y=-0.05), "knob", ag.material("abs"))

    @ag.generator
    def tap() -> ag.Body:
        turn = ag.Revolute("turn", axis=ag.Y, detents=feel.detents(9, 0.04))
        return panel.attach(knob, ag.Prismatic("push", axis=ag.Y, limits=(0.0, 0.01)), turn)

    with pytest.raises(ArtgenError, match="'turn' has detents and shares its links with another joint"):
        tap.generate(0)


def test_a_graph_with_detents_goes_to_python_and_back() -> None:
    graph = Graph(ag.Revolute("turn", axis=ag.Y, detents=feel.detents((0.0, 0.5), 0.04)))
    names: dict[str, Any] = {}
    exec(graph.to_python(), names)  # noqa: S102 - the source is what is tested
    assert names["build"]().node.key == graph.key
