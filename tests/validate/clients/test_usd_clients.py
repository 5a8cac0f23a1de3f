"""The clients of USD: that their drivers drive, and which faults each of them notices.

Those of `artgen[test]` always run; `make clients` installs the others and `make test-clients` runs them.
"""

import importlib
import re
import shutil
import sys

import numpy as np
import pytest
from pxr import Sdf, Usd, UsdPhysics

import artgen
from artgen.asset.files import main_files
from artgen.export import LAYOUTS
from artgen.validate.clients.exported import read_exported
from artgen.validate.clients.registry import CLIENTS, REQUIREMENTS
from artgen.validate.clients.run import DRIVERS, run_client


@pytest.fixture
def driver(monkeypatch):
    """Return a function that imports a module beside the drivers."""
    monkeypatch.syspath_prepend(str(DRIVERS))

    def load(name):
        for each in ("driver_protocol", "driver_motion", name):
            monkeypatch.delitem(sys.modules, each, raising=False)
        return importlib.import_module(name)

    return load


@pytest.mark.parametrize("client", CLIENTS.values(), ids=lambda client: client.name)
def test_an_entry_names_what_there_is(client):
    assert (DRIVERS / f"{client.driver}.py").is_file()
    assert not client.environment or client.environment in REQUIREMENTS
    assert set(client.layouts) <= set(LAYOUTS)
    assert all(client.format in LAYOUTS[layout].formats for layout in client.layouts)
    assert max(client.tolerances) <= 1e-5
    assert client.distribution or client.obtain
    for pattern, reason in client.unavoidable:
        re.compile(pattern)
        assert reason


class Slide:
    """A mass on a slide with friction and damping, stopped at its ends, and a bolt that may hold it."""

    def __init__(self, limits, mass=2.0, friction=3.0, damping=1.0, *, bolted=False):
        self.steps, self.finite = 0, True
        self._limits, self._mass, self._friction, self._damping = limits, mass, friction, damping
        self._bolted = bolted
        self._positions = {"slide": limits[0], "bolt": 0.0}
        self._speed, self._forces = 0.0, {}

    def position(self, name):
        return self._positions[name]

    def push(self, forces):
        self._forces = forces

    def advance(self, seconds):
        step = 0.001
        for _ in range(round(seconds / step)):
            self.steps += 1
            bolt = np.sign(self._forces.get("bolt", 0.0)) * step
            self._positions["bolt"] = float(np.clip(self._positions["bolt"] + bolt, 0.0, 0.02))
            if self._bolted and self._positions["bolt"] > 0.001:
                continue
            pull = self._forces.get("slide", 0.0) - self._damping * self._speed
            if abs(self._speed) < 1e-9:
                pull = np.sign(pull) * max(0.0, abs(pull) - self._friction)
            else:
                pull -= np.sign(self._speed) * self._friction
            self._speed += step * pull / self._mass
            moved = self._positions["slide"] + step * self._speed
            self._positions["slide"] = float(np.clip(moved, *self._limits))
            if self._positions["slide"] != moved:
                self._speed = 0.0


def joint(name, limits, *, blocked=False, effort=100.0, freed=()):
    state = {"follows": None, "curve": None, "blocked": blocked, "freed": dict(freed)}
    return {"name": name, "limits": limits, "effort": effort, **state}


@pytest.mark.parametrize("mass", [0.05, 2.0, 60.0])
@pytest.mark.parametrize("limits", [(0.0, 0.01), (-0.2, 0.5)])
def test_a_joint_is_driven_to_both_ends(driver, mass, limits):
    slide = Slide(limits, mass)
    moved = driver("driver_motion").drive_all(slide, {"joints": [joint("slide", limits)]})["moved"]
    low, high = moved["slide"]
    span = limits[1] - limits[0]
    assert low <= limits[0] + 0.021 * span
    assert high >= limits[1] - 0.021 * span
    assert slide.steps < 20_000


def test_a_blocked_joint_is_driven_once_the_others_free_it(driver):
    limits = (0.0, 0.3)
    slide = joint("slide", limits, blocked=True, freed={"bolt": 0})
    request = {"joints": [slide, joint("bolt", (0.0, 0.02))]}
    moved = driver("driver_motion").drive_all(Slide(limits, bolted=True), request)["moved"]
    assert moved["slide"][1] > 0.29
    assert moved["bolt"][1] >= 0.0196


def test_a_joint_that_stays_blocked_is_not_said_to_be_driven(driver):
    limits = (0.0, 0.3)
    request = {"joints": [joint("slide", limits, blocked=True)]}
    slide = Slide(limits, friction=1e6)
    assert driver("driver_motion").drive_all(slide, request)["moved"] == {}


@pytest.mark.parametrize(("drift", "told"), [(0.0, []), (0.1, ["mill", "slide"])])
def test_a_room_is_watched_at_rest(driver, drift, told):
    motion = driver("driver_motion")

    class Room(motion.Simulation):
        def step(self, count):
            self.now = getattr(self, "now", 0.0) + count * self.time_step

        def positions(self):
            return np.array([drift * self.now])

        def frames(self):
            frame = np.eye(4)
            frame[0, 3] = drift * self.now
            return {"mill": frame}

    request = {"joints": [joint("slide", (0.0, 0.3))], "free_links": ["mill"], "rest": [1.0, 3.0, 0.05, 0.1]}
    answer = motion.drive_all(Room({"slide": 0}, {"slide": 0}), request)
    assert [each.partition(" ")[0] for each in answer["said"]] == told
    assert answer["steps"] == 2000


def test_a_coupled_joint_that_leaves_its_leader_is_told(driver):
    poses = [{"turn": turn, "rise": 0.1 * turn - 0.2} for turn in (0.0, 1.0, 3.0)]
    joints = [{"name": "turn", "follows": None}, {"name": "rise", "follows": "turn", "curve": None}]
    turn = np.linspace(0.0, 3.0, 7)
    lags = driver("driver_motion").lags
    assert lags({"joints": joints, "poses": poses}, {"turn": turn, "rise": 0.1 * turn - 0.2}) == []
    (message,) = lags({"joints": joints, "poses": poses}, {"turn": turn, "rise": 0.08 * turn - 0.2})
    assert message.startswith("rise does not follow turn")


def test_a_joint_of_a_closed_chain_is_compared_with_its_law_where_pins_hold_it(driver):
    turn = np.linspace(0.0, 1.0, 65)
    rocker = {"name": "rocker", "follows": "turn", "curve": [turn.tolist(), (turn**2).tolist()]}
    request = {"joints": [rocker], "poses": [{"turn": each, "rocker": each**2} for each in (0.0, 0.4, 1.0)]}
    lags = driver("driver_motion").lags
    assert lags(request, {"turn": turn, "rocker": turn**2}) == []
    (message,) = lags(request, {"turn": turn, "rocker": turn**2 + 0.02 * turn})
    assert message == "rocker does not follow turn: it is off by 0.02"
    assert lags(request | {"joints": [rocker | {"curve": []}]}, {"turn": turn, "rocker": turn}) == []


def test_a_follower_is_told_by_the_head_of_its_chain(driver):
    found = driver("driver_protocol").couplings_to_heads({"b": ["a", 2.0, 0.1], "c": ["b", 3.0, 0.2]})
    assert found == {"b": ["a", 2.0, 0.1], "c": ["a", 6.0, pytest.approx(0.5)]}


@pytest.fixture(scope="session")
def packages(tmp_path_factory):
    """One handle in both layouts of USD."""
    asset = artgen.generate("handle", seed=8, certify=False)
    folder = tmp_path_factory.mktemp("usd")
    return {
        layout: asset.export(folder / layout, formats=("usd",), textures=0, layout=layout)
        for layout in ("flat", "simready")
    }


def test_a_variant_is_enabled_where_there_are_some(driver, packages):
    module = driver("driver_protocol")
    for layout, directory in packages.items():
        request = read_exported(directory).request(CLIENTS["ovphysx"])
        with module.enabled(request, "PhysX") as file:
            assert (file == request["file"]) == (layout == "flat")
            stage = Usd.Stage.Open(file)
            assert stage.GetDefaultPrim().GetName() == request["asset"]
            slide = next(prim for prim in stage.Traverse() if prim.GetName() == "latch_slide")
            assert slide.HasAPI(UsdPhysics.DriveAPI) or slide.GetAttribute("physics:axis").Get() == "X"
            assert slide.GetRelationship("physxMimicJoint:rotX:referenceJoint").GetTargets()


def radians(stage):
    for end in ("lower", "upper"):
        change(stage, f"physics:{end}Limit", np.radians)


def mass(stage):
    change(stage, "physics:mass", lambda value: 1.1 * value, UsdPhysics.RigidBodyAPI)


def inertia(stage):
    change(stage, "physics:diagonalInertia", lambda value: 0.0 * value, UsdPhysics.RigidBodyAPI)


def frames(stage):
    change(stage, "physics:localPos1", lambda value: value + type(value)(0.05, 0.0, 0.0))


def axis(stage):
    change(stage, "physics:axis", lambda value: "Y")


def inside_out(stage):
    def flip(value):
        return type(value)(np.array(value).reshape(-1, 3)[:, ::-1].ravel().tolist())

    change(stage, "faceVertexIndices", flip, UsdPhysics.MeshCollisionAPI)


def no_root(stage):
    for prim in stage.Traverse():
        for spec in prim.GetPrimStack():
            names = spec.GetInfo("apiSchemas").GetAppliedItems() if spec.HasInfo("apiSchemas") else []
            kept = [name for name in names if "ArticulationRoot" not in name]
            if kept != list(names):
                spec.SetInfo("apiSchemas", Sdf.TokenListOp.Create(prependedItems=kept))


def change(stage, attribute, new, kind=UsdPhysics.RevoluteJoint):
    """Change an attribute of the first prim of a kind, or with a schema, in the layer that has it."""
    prims = [prim for prim in stage.Traverse() if prim.IsA(kind) or prim.HasAPI(kind)]
    spec = prims[0].GetAttribute(attribute).GetPropertyStack(Usd.TimeCode.Default())[0]
    spec.default = new(spec.default)


VALIDATORS = ("usd_validation", "omniverse_asset_validator", "simready_validate")
SIMULATORS = ("ovphysx", "newton_usd")
FAULTS = [
    (inertia, ("usd_validation", "omniverse_asset_validator"), r"principalAxes"),
    (inside_out, ("omniverse_asset_validator", "simready_validate"), r"inconsistent with the face windings"),
    (radians, SIMULATORS, r"its limits are 0 to 0\.0\d+ rad in handle_8\.usda, not 0 to 0\.\d+ rad"),
    (mass, SIMULATORS, r"its mass is .* kg in handle_8\.usda, not .* kg"),
    (frames, SIMULATORS, r"its frame is off by 0\.05"),
    (axis, SIMULATORS, r"its frame is off by"),
    (no_root, ("ovphysx",), r"PhysX finds 0 articulations in the file, not one"),
]


@pytest.mark.parametrize(
    ("fault", "name", "message"),
    [
        pytest.param(fault, name, message, id=f"{fault.__name__}-{name}")
        for fault, names, message in FAULTS
        for name in names
    ],
)
def test_a_fault_is_noticed(fault, name, message, packages, tmp_path):
    client = CLIENTS[name]
    directory = shutil.copytree(packages[client.layouts[0]], tmp_path / "export")
    stage = Usd.Stage.Open(str(main_files(directory)["usd"]))
    fault(stage)
    for layer in stage.GetUsedLayers():
        if layer.dirty and not layer.anonymous:
            layer.Save()
    (outcome,) = run_client(client, [read_exported(directory)])
    if outcome.state == "absent":
        pytest.skip(f"{name}: {outcome.message}")
    assert outcome.state == "failed"
    assert re.search(message, "\n".join(map(str, outcome.findings))), outcome.findings


@pytest.mark.long
def test_simready_tells_which_optional_requirements_are_unmet(packages):
    (outcome,) = run_client(CLIENTS["simready_validate"], [read_exported(packages["simready"])])
    if outcome.state == "absent":
        pytest.skip(f"simready_validate: {outcome.message}")
    assert outcome.state == "passed", outcome.findings
    assert re.match(r"\d+ of \d+ features", outcome.note)
