"""Clients that are installed read what artgen exports, and notice what is wrong with it.

Those of `artgen[test]` always run; `make clients` installs the others and `make test-clients` runs them.
"""

import re

import pytest

import artgen
from artgen.export import LAYOUTS
from artgen.validate.clients.exported import read_exported
from artgen.validate.clients.registry import CLIENTS
from artgen.validate.clients.run import run_client
from support.cases import some

SAMPLES = [("door", 3, "fixed", 0), ("handle", 4, "free", 256)]


@pytest.fixture(scope="session")
def exports(tmp_path_factory):
    """Some assets in every layout, with all formats of each."""
    folder = tmp_path_factory.mktemp("clients")
    result = []
    for category, seed, base, textures in SAMPLES:
        asset = artgen.generate(category, seed=seed, certify=False).with_base(base)
        for name, layout in LAYOUTS.items() if category == "handle" else (("flat", LAYOUTS["flat"]),):
            directory = asset.export(
                folder / f"{asset.name}_{name}", formats=layout.formats, layout=name, textures=textures
            )
            result.append(read_exported(directory))
    return result


@pytest.mark.parametrize("name", CLIENTS)
def test_it_reads_what_is_exported_without_a_word(name, exports):
    client = CLIENTS[name]
    readable = [each for each in exports if each.is_read_by(client)]
    if not readable:
        pytest.skip(f"no layout has what {name} reads")
    outcomes = run_client(client, readable)
    if all(outcome.state == "absent" for outcome in outcomes):
        pytest.skip(f"{name}: {outcomes[0].message}")
    for outcome, each in zip(outcomes, readable, strict=True):
        assert outcome.state == "passed", f"{each.asset.name}, {each.layout}: {outcome.message}"
        assert outcome.version


@pytest.mark.parametrize("name", ["mujoco", "newton_mjcf", "newton_urdf"])
def test_it_reads_a_screw_and_a_dial_that_follows_it(name, tmp_path):
    post = artgen.part(artgen.box(0.02, 0.02, 0.2), "post", artgen.material("oak"))
    nut = artgen.part(artgen.box(0.05, 0.05, 0.01).at(z=0.107), "nut", artgen.material("brass"))
    feel = {"friction": 0.1, "armature": 1e-4, "effort": 3}
    turn = artgen.Screw("nut_turn", pitch=0.004, axis=artgen.Z, limits=(0, 9), **feel)

    dial = artgen.part(
        artgen.cylinder(0.008, 0.004, axis=artgen.Y).at(y=-0.0125), "dial", artgen.material("brass")
    )
    spin = artgen.Revolute("dial_turn", axis=artgen.Y, follows=0.5 * turn)

    @artgen.generator
    def vise():
        return post.attach(nut, turn).attach(dial, spin)

    asset = vise.generate(0, certify=False)
    exported = read_exported(asset.export(tmp_path / "vise", formats=("urdf", "mjcf"), textures=0))
    (outcome,) = run_client(CLIENTS[name], [exported])
    if outcome.state == "absent":
        pytest.skip(f"{name}: {outcome.message}")
    assert outcome.state == "passed", outcome.message


@pytest.mark.parametrize("style", ["rocker", "toggle"])
def test_what_snaps_over_stops_at_its_end(style, tmp_path):
    switch = artgen.generate("switch", seed=1, style=style, plate="tall", certify=False)
    exported = read_exported(switch.export(tmp_path / "switch", formats=("mjcf",), textures=0))
    (outcome,) = run_client(CLIENTS["mujoco"], [exported])
    assert outcome.state == "passed", outcome.message


def test_a_lid_that_falls_turns_on_its_pot(tmp_path):
    pot = artgen.generate("pot", seed=0, certify=False)
    exported = read_exported(pot.export(tmp_path / "pot", formats=("urdf",), textures=0))
    (outcome,) = run_client(CLIENTS["mujoco_urdf"], [exported])
    assert outcome.state == "passed", outcome.message


@pytest.mark.parametrize(
    "name", ["mujoco", "drake_urdf", "newton_mjcf", "newton_usd", "ovphysx", "mujoco_usd_converter"]
)
def test_it_reads_a_closed_chain(name, tmp_path):
    chair = artgen.generate("chair", seed=11, style="folding", certify=False)
    exports = [
        read_exported(chair.with_base(base).export(tmp_path / base, textures=0)) for base in ("fixed", "free")
    ]
    outcomes = run_client(CLIENTS[name], exports)
    for base, outcome in zip(("fixed", "free"), outcomes, strict=True):
        if outcome.state == "absent":
            pytest.skip(f"{name}: {outcome.message}")
        assert outcome.state == "passed", f"{base}: {outcome.message}"


MASS = (r'<mass value="(?!1e-)[^"]*"', '<mass value="3"', "its mass is 3 kg")
LIMIT = (r' upper="[^"]*"', ' upper="0.01"', "its limits are")
AXIS = (r'<axis xyz="0 -1 0"', '<axis xyz="0 1 0"', "its frame is off by")
MESH = (r"meshes/drawer_drawer_oak\.obj", "meshes/nothing.obj", "nothing.obj")
FAULTS = {"mass": MASS, "limit": LIMIT, "axis": AXIS, "mesh": MESH}
BLIND = {("mesh", "mujoco_urdf"), ("mesh", "check_urdf"), ("mass", "check_urdf"), ("limit", "check_urdf"),
         ("axis", "check_urdf")}  # fmt: skip


@pytest.mark.parametrize("fault", some(FAULTS, 2))
@pytest.mark.parametrize(
    "name", ["mujoco_urdf", "pinocchio", "yourdfpy", "check_urdf", "urchin", "pybullet", "drake_urdf"]
)
def test_it_notices_a_fault(name, fault, directory):
    if (fault, name) in BLIND:
        pytest.skip(f"{name} does not look at that")
    pattern, instead, message = FAULTS[fault]
    path = directory / "stand_0.urdf"
    text, count = re.subn(pattern, instead, path.read_text())
    assert count
    path.write_text(text)
    (outcome,) = run_client(CLIENTS[name], [read_exported(directory)])
    if outcome.state == "absent":
        pytest.skip(f"{name}: {outcome.message}")
    assert outcome.state == "failed"
    assert message in "\n".join(str(finding) for finding in outcome.findings)
