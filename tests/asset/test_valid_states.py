"""Valid joint states: draws, projection and forward kinematics, in Python and from exported files."""

import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import artgen
from artgen.asset import Asset, valid_states
from artgen.asset.valid_states import ValidStates
from artgen.errors import AssetError, ParameterError
from artgen.graph import evaluate
from artgen.materials import material
from artgen.nodes.body import part
from artgen.nodes.joint import Prismatic, Revolute
from artgen.nodes.primitive import box
from artgen.nodes.vector import X, Y, Z
from support.cases import some

FORMATS = {"urdf": "urdf", "mjcf": "xml", "usd": "usda", "glb": "glb", "sdf": "sdf"}
OAK = material("oak")
CATEGORIES = some(artgen.catalog.categories(), 10)


def block(name):
    return part(box(0.1, 0.1, 0.1), name, OAK)


def machine():
    """A door with a latch, a rack that needs the door, a pin that follows the rack, and a locked knob."""
    turn = Revolute("turn", axis=Y, limits=(0, 0.8))
    door = Revolute("door", axis=Z, pivot=(0.5, 0, 0), limits=(0, 1.5), needs=(turn > 0.5).until(0.05))
    rack = Prismatic("rack", axis=-Y, limits=(0, 0.3), needs=(door > 1.2).beyond(0.01))
    pin = Prismatic("pin", axis=Z, follows=-0.5 * rack + 0.02)
    knob = Revolute("knob", axis=X, limits=(0.3, 0.3))
    spin = Revolute("spin", axis=Z, limits=None)
    body = block("case").attach(block("leaf").attach(block("latch").at(2), turn), door)
    body = body.attach(block("tray").at(4).attach(block("dial").at(6), knob), rack)
    body = body.attach(block("bolt").at(8), pin).attach(block("wheel").at(10), spin)
    return Asset.from_tree(evaluate(body).value, "machine", "test")


MACHINE = machine()
STATES = MACHINE.valid_states


def test_degrees_of_freedom_neither_follow_nor_are_locked():
    assert set(MACHINE.dof_names) == {"turn", "door", "rack", "spin"}
    assert STATES.joints == tuple(joint.name for joint in MACHINE.joints)


def state(**positions):
    return np.array([positions.get(name, 0.0) for name in MACHINE.dof_names])


def blocked(q):
    return {name for name, is_blocked in zip(STATES.joints, STATES.blocked(q), strict=True) if is_blocked}


def test_a_joint_is_blocked_between_beyond_and_until():
    assert blocked(state(rack=0.01)) == set()
    assert blocked(state(rack=0.02)) == {"rack"}
    assert blocked(state(rack=0.02, door=1.3)) == set()
    assert blocked(state(door=0.04)) == {"door"}
    assert blocked(state(door=0.04, turn=0.6)) == set()
    assert blocked(state(door=0.05)) == set()


@pytest.mark.parametrize(
    ("q", "got"),
    [
        ([0.1, 0.2], r"the shape \(2,\) with 0 NaN"),
        (np.full((5, 4), np.nan), r"the shape \(5, 4\) with 20 NaN"),
        ([0.0, 0.1, np.inf, -np.inf], r"the shape \(4,\) with 2 NaN or infinite"),
        ({"door": 0.3}, r"\{'door': 0.3\}"),
        ("open", "'open'"),
        (None, "None"),
    ],
)
def test_what_is_no_state_is_named(q: Any, got: str) -> None:
    message = rf"shape \(..., 4\), positions of {', '.join(MACHINE.dof_names)}; got {got}"
    states = MACHINE.valid_states
    for function in (MACHINE.project, MACHINE.fk, states.blocked, states.positions, states.project):
        with pytest.raises(AssetError, match=message):
            function(q)


def test_projection_takes_the_nearest_allowed_position_and_clips():
    found = MACHINE.project([state(rack=0.2), state(door=0.04), state(door=0.01), state(door=2.0, rack=9.0)])
    at = dict(zip(MACHINE.dof_names, found.T, strict=True))
    assert at["rack"] == pytest.approx([0.01, 0.0, 0.0, 0.3])
    assert at["door"] == pytest.approx([0.0, 0.05, 0.0, 1.5])
    assert not STATES.blocked(found).any()


def test_a_joint_that_others_depend_on_is_moved_first():
    # the door closes, as its latch is closed; so the rack has to go back as well
    chain = Asset.from_tree(
        evaluate(
            block("case")
            .attach(block("a").at(2), Revolute("first", axis=Z, limits=(0, 1)))
            .attach(block("b").at(4), _needing("second", Revolute("first", axis=Z) > 0.5))
            .attach(block("c").at(6), _needing("third", Revolute("second", axis=Z) > 0.5))
        ).value,
        "chain",
        "test",
    )
    assert chain.project([0.2, 0.9, 0.9]) == pytest.approx([0.2, 0.0, 0.0])
    assert chain.project([0.6, 0.9, 0.9]) == pytest.approx([0.6, 0.9, 0.9])


def _needing(name, condition):
    return Revolute(name, axis=Z, limits=(0, 1), needs=condition)


@given(st.integers(0, 10**6), st.integers(1, 5), st.integers(1, 4))
def test_projection_is_valid_idempotent_and_keeps_valid_states(seed, rows, columns):
    raw = np.random.default_rng(seed).uniform(-2.0, 2.0, (rows, columns, len(MACHINE.dof_names)))
    found = MACHINE.project(raw)
    assert found.shape == raw.shape
    assert not STATES.blocked(found).any()
    assert MACHINE.project(found) == pytest.approx(found, abs=1e-15)
    free = ~STATES.blocked(raw).any(axis=-1)
    inside = ((raw >= STATES.lower) & (raw <= STATES.upper)).all(axis=-1)
    assert (found[free & inside] == raw[free & inside]).all()


def test_draws_are_valid_cover_the_ranges_and_repeat():
    drawn = MACHINE.sample_states(4000, seed=3)
    assert not STATES.blocked(drawn).any()
    assert (drawn == MACHINE.sample_states(4000, seed=3)).all()
    assert not (drawn == MACHINE.sample_states(4000, seed=4)).all()
    at = dict(zip(MACHINE.dof_names, drawn.T, strict=True))
    assert at["turn"].max() > 0.79
    shut, wide = at["rack"][at["door"] <= 1.2], at["rack"][at["door"] > 1.2]
    assert shut.max() <= 0.01
    assert wide.mean() == pytest.approx(0.15, abs=0.01)
    assert len(wide) / len(drawn) == pytest.approx(0.2, abs=0.03)
    assert abs(at["spin"]).max() <= np.pi


@pytest.mark.parametrize("name", CATEGORIES)
def test_states_of_a_category_agree_with_its_asset(name):
    asset = artgen.generate(name, seed=1)
    states = asset.valid_states
    low, high = np.maximum(states.lower, -4.0), np.minimum(states.upper, 4.0)
    raw = low + np.random.default_rng(5).random((200, len(low))) * (high - low)
    for q, shut, poses in zip(raw, states.blocked(raw), asset.fk(raw), strict=True):
        given_ = dict(zip(asset.dof_names, q, strict=True))
        assert asset.blocked(given_) == tuple(np.array(states.joints)[shut])
        moved = asset.pose(given_)
        for link, pose in zip(asset.links, poses, strict=True):
            expected = moved[link.name].copy()
            expected[:3, 3] += expected[:3, :3] @ asset.origin(link.name)
            np.testing.assert_allclose(pose, expected, atol=1e-9)
    assert not states.blocked(asset.project(raw)).any()
    assert not states.blocked(asset.sample_states(200)).any()


@pytest.fixture(scope="module")
def exported(tmp_path_factory):
    folder = tmp_path_factory.mktemp("states") / "machine"
    MACHINE.export(folder, formats=tuple(FORMATS), textures=0, states=64)
    return folder


@pytest.mark.parametrize("suffix", [*FORMATS.values(), "json"])
def test_every_format_carries_the_states(exported, suffix):
    read = ValidStates.read(exported / ("asset.json" if suffix == "json" else f"machine.{suffix}"))
    raw = np.random.default_rng(2).uniform(-2.0, 2.0, (5000, len(MACHINE.dof_names)))
    assert read.dofs == MACHINE.dof_names
    assert (read.blocked(raw) == STATES.blocked(raw)).all()
    assert (read.project(raw) == MACHINE.project(raw)).all()


def test_the_reader_beside_an_export_needs_numpy_alone(exported):
    program = (
        "import sys, numpy; sys.path.insert(0, '.'); from valid_states import ValidStates\n"
        "states = ValidStates.read('machine.urdf'); found = numpy.load('states.npz')\n"
        "assert found['dofs'].tolist() == list(states.dofs) and found['q'].shape == (64, len(states.dofs))\n"
        "assert not states.blocked(found['q']).any()\n"
        "assert not any(name.startswith('artgen') for name in sys.modules)\n"
    )
    done = subprocess.run(
        [sys.executable, "-I", "-c", program], cwd=exported, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert len(Path(valid_states.__file__).read_text(encoding="utf-8").splitlines()) <= 150


def test_a_file_without_states_is_refused(tmp_path):
    place = tmp_path / "other.urdf"
    place.write_text("<robot name='other'/>")
    with pytest.raises(ValueError, match=r"other\.urdf has no artgen_states"):
        ValidStates.read(place)


def test_keyframes_are_valid_states(exported):
    mujoco = pytest.importorskip("mujoco")
    model = mujoco.MjModel.from_xml_path(str(exported / "machine.xml"))
    names = [model.joint(number).name for number in range(model.njnt)]
    assert [model.key(number).name for number in range(2)] == ["machine_closed", "machine_open"]
    data = mujoco.MjData(model)
    for number in range(model.nkey):
        positions = {name: model.key_qpos[number][model.joint(name).qposadr[0]] for name in names}
        q = [positions[name] for name in MACHINE.dof_names]
        assert not STATES.blocked(q).any()
        mujoco.mj_resetDataKeyframe(model, data, number)
        mujoco.mj_forward(model, data)
        for link, pose in zip(MACHINE.links, MACHINE.fk(q), strict=True):
            np.testing.assert_allclose(data.body(link.name).xpos, pose[:3, 3], atol=1e-9)
    assert model.key_qpos[1][model.joint("door").qposadr[0]] == pytest.approx(1.5)
    assert model.key_qpos[1][model.joint("rack").qposadr[0]] == pytest.approx(0.3)


# independent limits


def limits(asset):
    return {joint.name: joint.limits for joint in asset.joints}


def test_independent_limits_leave_no_dependency():
    narrowed = MACHINE.with_limits("independent")
    assert all(joint.needs is None for joint in narrowed.joints)
    assert limits(narrowed)["rack"] == (0.0, 0.3)  # it moves as much mass as the door
    assert limits(narrowed)["turn"] == (0.0, 0.8)
    assert limits(narrowed)["spin"] is None
    kept = MACHINE.with_limits("independent", keep=["rack"])
    assert limits(kept)["rack"] == (0.0, 0.3)
    assert limits(kept)["door"] == pytest.approx((1.2, 1.5), abs=1e-5)
    assert limits(kept)["pin"] == limits(MACHINE)["pin"]
    other = MACHINE.with_limits("independent", keep=["turn", "door"])
    assert limits(other)["rack"] == (0.0, 0.01)
    assert limits(other)["pin"] == pytest.approx((0.015, 0.02))


@pytest.mark.parametrize(("needed", "left"), [(0.003, (0.003, 0.004)), (0.0039, (0.004, 0.004))])
def test_a_joint_that_stays_pressed_in_a_small_range_is_locked_at_its_end(needed, left):
    press = Prismatic("press", axis=Y, limits=(0, 0.004), stiffness=500.0, rest=-0.002)
    turn = Revolute("turn", axis=Y, limits=(0, 3), needs=(press > needed).beyond(0.05))
    asset = Asset.from_tree(
        evaluate(block("case").attach(block("dial").at(2), press, turn)).value, "knob", ""
    )
    narrowed = asset.with_limits("independent", keep=["turn"])
    assert limits(narrowed)["turn"] == (0.0, 3.0)
    assert limits(narrowed)["press"] == pytest.approx(left, abs=2e-6)
    assert narrowed.joint("press").locked == (left[0] == left[1])


def test_limits_are_narrowed_once_and_patterns_fit_a_joint():
    narrowed = MACHINE.with_limits("independent")
    assert narrowed.with_limits("independent") is narrowed
    with pytest.raises(AssetError, match="has independent limits; narrow the original asset instead"):
        narrowed.with_limits("full")
    with pytest.raises(AssetError, match="keep='racks' fits no joint of 'machine'"):
        MACHINE.with_limits("independent", keep=["racks"])
    with pytest.raises(AssetError, match="keep='racks' fits no joint of 'machine'"):
        MACHINE.with_limits("independent", keep="racks")


@pytest.mark.parametrize("keep", [5, [5], None])
def test_what_keeps_its_limits_are_names(keep):
    message = f"keep = {keep!r} is not allowed: give names of joints, such as ['rack_*']"
    with pytest.raises(ParameterError, match=re.escape(message)):
        MACHINE.with_limits("independent", keep=keep)


@pytest.mark.parametrize("name", CATEGORIES)
def test_independent_limits_of_a_category_are_proven_and_written(name, tmp_path):
    asset = artgen.generate(name, seed=2, limits="independent")
    assert asset.limits == "independent"
    assert asset.certificate.proven
    full = artgen.generate(name, seed=2)
    for joint in asset.joints:
        low, high = joint.limits or (-np.inf, np.inf)
        least, most = full.joint(joint.name).limits or (-np.inf, np.inf)
        assert least - 1e-9 <= low <= high <= most + 1e-9
    q = asset.sample_states(200)
    rows = [dict(zip(asset.dof_names, each, strict=True)) for each in q]
    held = {joint.name: joint.limits[0] for joint in asset.joints if joint.locked and not joint.follows}
    assert not any(full.blocked(held | row) for row in rows)
    full.export(tmp_path / "a", formats=["urdf"], textures=0, limits="independent", frames=False)
    assert artgen.Asset.load(tmp_path / "a").limits == "independent"


@pytest.mark.parametrize("count", [True, -1, 2.5, "3", None, float("inf"), float("nan")])
def test_a_wrong_number_of_states_is_named(count: object) -> None:
    asset = artgen.generate("drawer", 0, certify=False)
    with pytest.raises(AssetError, match="the number of states must be a whole number of at least 0, got"):
        asset.sample_states(count)  # type: ignore[arg-type]
    with pytest.raises(AssetError, match="the seed must be a whole number of at least 0, got"):
        asset.sample_states(2, seed=count)  # type: ignore[arg-type]


def test_projected_states_are_free_by_the_unrounded_dependencies() -> None:
    box = artgen.generate("box", 11, certify=False)
    states = np.random.default_rng(1).uniform(-0.2, 3.2, (200, len(box.dof_names)))
    for state in box.project(states).tolist():
        assert not box.blocked(dict(zip(box.dof_names, state, strict=True)))
