"""Soft closing: its law, in MuJoCo and in motion; reading it back; what is refused."""

import json
import re
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import artgen as ag
from artgen import feel
from artgen.asset import Asset
from artgen.errors import ArtgenError
from artgen.graph import Graph
from artgen.validate import validate
from artgen.validate.behavior import check_behavior

RUNNER = feel.soft_closing(0.04, preload=15.0, force=28.0, damping=320.0)
DRAWER = {"kind": ag.Prismatic, "axis": (0.6, 0.8, 0.0), "limits": (0.0, 0.3), "friction": 5.0}


def made(kind: Any, **options: Any) -> Asset:
    """Return a part on a case that moves, so that both have frames of their own."""
    floor = ag.part(ag.box(0.4, 0.4, 0.1).at(0.0, 0.0, -0.5), "base", ag.material("oak"))
    case = ag.part(ag.box(0.3, 0.3, 0.02).at(0.0, 0.0, -0.3), "case", ag.material("oak"))
    leaf = ag.part(ag.box(0.2, 0.3, 0.1), "leaf", ag.material("oak"))
    lift = ag.Prismatic("lift", axis=-ag.Z, limits=(0.0, 0.05), friction=500.0, effort=900.0)

    @ag.generator
    def cupboard() -> ag.Body:
        return floor.attach(case.attach(leaf, kind("slide", **options)), lift)

    return cupboard.generate(0, certify=False)


shares = st.floats(0.0, 1.0)


@settings(max_examples=12, deadline=None)
@given(
    kind=st.sampled_from(["revolute", "prismatic"]),
    way=st.sampled_from([-1.0, 1.0]),
    numbers=st.tuples(*[shares] * 6),
)
def test_mujoco_has_the_law_and_moves_by_it(kind: str, way: float, numbers: tuple[float, ...]) -> None:
    reach, spring, damping, rest, far, arm = numbers
    turns = kind == "revolute"
    inertia = 0.05 + 0.1 * arm if turns else 2.0 + 4.0 * arm
    limit = 1.0 + 1.9 * far if turns else 0.2 + 0.3 * far
    reach = way * (0.1 + 0.5 * reach) * limit
    force = (1.0 + spring) if turns else (15.0 + 15.0 * spring)
    soft = feel.soft_closing(
        reach, preload=(0.3 + 0.5 * rest) * force, force=force, damping=(4.0 + 6.0 * damping) * inertia
    )
    limits = (-limit, 0.0) if way < 0.0 else (0.0, limit)
    asset = made(
        ag.Revolute if turns else ag.Prismatic,
        axis=(0.6, 0.0, 0.8),
        pivot=(0.1, 0.2, 0.3),
        limits=limits,
        armature=inertia,
        closing=soft,
    )
    joint, model = asset.joint("slide"), asset.to_mjspec().compile()
    model.opt.timestep, model.opt.gravity, model.opt.integrator = 0.0005, 0.0, 3
    data, at = mujoco.MjData(model), int(model.joint("slide").dofadr[0])
    q, found = np.linspace(0.0, way * limit, 101), []
    for position in q:
        data.joint("slide").qpos, data.joint("slide").qvel = position, 0.3
        mujoco.mj_forward(model, data)
        found.append(float(data.qfrc_passive[at]))
    off = abs(q - reach) > 1e-6
    assert np.array(found)[off] == pytest.approx(joint.closing_force(q, 0.3)[off], abs=1e-3 * max(force, 1.0))

    mujoco.mj_resetData(model, data)
    start = 0.95 * reach
    data.joint("slide").qpos = start
    mujoco.mj_forward(model, data)
    moved = float(joint.closing_force(start)) / float(data.qacc[at])  # inertia of all that moves with it
    position, speed = start, 0.0
    for _ in range(6000):
        mujoco.mj_step(model, data)
        # the same step with the law alone; the damping is implicit, as in MuJoCo
        pull = float(joint.closing_force(position))
        speed = (moved * speed + 0.0005 * pull) / (moved + 0.0005 * soft_damping(asset))
        position += 0.0005 * speed
        if abs(position) < 0.02 * abs(reach):
            break
        assert abs(float(data.joint("slide").qpos[0]) - position) < 0.01 * abs(start), "within 1 %"


def soft_damping(asset: Asset) -> float:
    closing = asset.joint("slide").closing
    assert closing is not None
    return closing.damping


def test_a_drawer_closes_within_its_reach_and_stays_behind_it(tmp_path: Path) -> None:
    result = check_behavior(made(**DRAWER, closing=RUNNER))
    assert not [each for each in result.findings if each.severity == "fault"], result.findings
    assert "1 closed softly" in result.detail


@pytest.mark.parametrize(
    ("change", "message"),
    [({"preload": 2.0, "force": 4.0}, "it is still open"), ({"damping": 20.0}, "it is closed after")],
)
def test_a_closing_that_is_weak_or_hard_is_found(change: dict[str, float], message: str) -> None:
    numbers = {"preload": 15.0, "force": 28.0, "damping": 320.0} | change
    result = check_behavior(made(**DRAWER, closing=feel.soft_closing(0.04, **numbers)))
    assert any(message in each.message for each in result.findings), result.findings


@pytest.mark.parametrize("attribute", ["damping", "stiffness"])
def test_a_changed_tendon_is_found(attribute: str, tmp_path: Path) -> None:
    asset = made(**DRAWER, closing=RUNNER)
    folder = asset.export(tmp_path, formats=("mjcf",), textures=0)
    assert not validate(folder, behavior=False, checks=["mjcf"]).faults
    path = folder / f"{asset.name}.xml"
    text = path.read_text(encoding="utf-8")
    changed = re.sub(rf'(<spatial [^>]*{attribute}=")', r"\g<1>1", text)
    assert changed != text
    path.write_text(changed, encoding="utf-8")
    faults = [str(each) for each in validate(folder, behavior=False, checks=["mjcf"]).faults]
    assert any("its soft closing in" in each for each in faults), faults


def test_other_formats_record_it_as_data(tmp_path: Path) -> None:
    asset = made(**DRAWER, closing=RUNNER)
    folder = asset.export(tmp_path, textures=0)
    assert Asset.load(folder).joint("slide").closing == asset.rounded().joint("slide").closing
    record = json.loads((folder / "asset.json").read_text(encoding="utf-8"))
    lost = {name: [each["feature"] for each in form["losses"]] for name, form in record["formats"].items()}
    assert {name: "soft closing" in features for name, features in lost.items()} == {
        "urdf": True, "mjcf": False, "usd": True,
    }  # fmt: skip


@pytest.mark.parametrize(
    ("reach", "numbers", "message"),
    [
        (0.04, {"preload": 5.0, "force": 5.0, "damping": 1.0}, "its force grows from the closed position"),
        (0.04, {"damping": 0.0}, "the damping of a soft closing is 0"),
        (0.4, {"damping": 1.0}, "closes softly from 0.4 to 0: it closes at a limit"),
    ],
)
def test_what_makes_no_sense_is_refused(reach: float, numbers: dict[str, float], message: str) -> None:
    with pytest.raises(ArtgenError, match=re.escape(message)):
        made(**DRAWER, closing=feel.soft_closing(reach, **numbers))


def test_a_graph_with_a_soft_closing_goes_to_python_and_back() -> None:
    graph = Graph(ag.Prismatic("slide", axis=ag.Y, limits=(0.0, 0.3), closing=RUNNER))
    names: dict[str, Any] = {}
    exec(graph.to_python(), names)  # noqa: S102 - the source is what is tested
    assert names["build"]().node.key == graph.key
