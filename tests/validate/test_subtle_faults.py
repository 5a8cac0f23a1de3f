"""Subtle faults in exports: what nothing compares number by number is told by its words, or by the record."""

import re
import runpy
import shutil
from pathlib import Path
from typing import Any

import pytest
from lxml import etree

from artgen.validate import validate
from support.exports import edit_json
from support.injections import Export, named

pytest.importorskip("mujoco")

HANDMADE = runpy.run_path(str(Path(__file__).parents[1] / "export/conftest.py"))


@pytest.fixture(scope="module")
def source(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The directory of the handmade cabinet, in all formats."""
    folder = tmp_path_factory.mktemp("subtle")
    directory: Path = HANDMADE["make_cabinet"]().export(
        folder / "cabinet", formats=("urdf", "mjcf", "usd", "glb"), textures=0
    )
    return directory


@pytest.fixture
def export(source: Path, tmp_path: Path) -> Export:
    """A copy of it, to be changed."""
    return Export(shutil.copytree(source, tmp_path / source.name))


def told(export: Export, check: str) -> str:
    """Return the faults that a check finds, one in each line."""
    return "\n".join(
        str(fault) for fault in validate(export.directory, behavior=False, checks=[check]).faults
    )


def test_the_unchanged_export_is_sound(export: Export) -> None:
    for check in ("files", "solids", "urdf", "mjcf", "usd"):
        assert told(export, check) == ""


WORDS = [
    ('<option><flag contact="disable"/></option>', "sets contact to disable, which belongs to the scene"),
    (
        '<actuator><position joint="lid_hinge" kp="9"/></actuator>',
        "has <actuator>, which does not belong to an asset",
    ),
    (
        '<tendon><fixed stiffness="50" springlength="1"><joint joint="lid_hinge" coef="1"/></fixed></tendon>',
        "has <tendon>, which does not belong",
    ),
    (
        '<equality><weld body1="lid" body2="body"/></equality>',
        "has the equality <weld>, which holds links together",
    ),
    (
        '<equality><joint joint1="lid_hinge" polycoef="0.2 0 0 0 0"/></equality>',
        "joint lid_hinge: an equality of .* holds it in place",
    ),
    (
        '<worldbody><geom name="wall" type="box" size="1 1 1" pos="0 -1.3 0"/></worldbody>',
        "its body 'world' is not a link of the asset and collides, by the geom 'wall'",
    ),
    (
        '<worldbody><body name="ball"><freejoint/><geom size="0.05" mass="1e-6"/></body></worldbody>',
        "the body 'ball' moves freely in",
    ),
]


@pytest.mark.parametrize(("words", "says"), WORDS)
def test_what_acts_on_links_is_no_part_of_mjcf(export: Export, words: str, says: str) -> None:
    with export.xml("mjcf") as root:
        root.append(etree.fromstring(words))
    assert re.search(says, told(export, "mjcf"))


@pytest.mark.parametrize(
    ("key", "value", "says"),
    [
        ("contype", "2", "has contype 2 in .*, not 1"),
        ("margin", "0.02", "has margin 0.02 in .*, not 0"),
        ("condim", "1", "has condim 1 in .*, not 3"),
        ("solref", "0.5 1", "is softer than MuJoCo's default"),
    ],
)
def test_colliders_of_mjcf_are_plain(export: Export, key: str, value: str, says: str) -> None:
    with export.xml("mjcf") as root:
        for geom in root.iterfind("default//default[@class='" + root.get("model") + "_collision']/geom"):
            geom.set(key, value)
    text = told(export, "mjcf")
    assert re.search(says, text)
    assert "link body" in text


def test_limits_and_couplings_of_mjcf_are_plain(export: Export) -> None:
    with export.xml("mjcf") as root:
        named(root, "worldbody//joint", "lid_hinge").set("solreflimit", "2 1")
        root.find("equality/joint").set("polycoef", "0 1 0.5 0 0")
    text = told(export, "mjcf")
    assert "joint lid_hinge: its limits are softer than MuJoCo's default" in text
    assert "its coupling has terms of higher order" in text


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (
            '<gazebo reference="lid"><gravity>false</gravity><mu1>0</mu1></gazebo>',
            "it sets <mu1> of 'lid', which belongs to the scene",
        ),
        ('<transmission name="t"/>', "it sets <transmission> of 'the model', which belongs to the scene"),
    ],
)
def test_what_single_readers_obey_is_no_part_of_urdf(export: Export, words: str, says: str) -> None:
    with export.xml("urdf") as root:
        root.append(etree.fromstring(words))
    assert says in told(export, "urdf")


def test_soft_limits_are_no_part_of_urdf(export: Export) -> None:
    with export.xml("urdf") as root:
        soft = '<safety_controller soft_lower_limit="0.1" soft_upper_limit="0.2" k_velocity="1"/>'
        named(root, "joint", "lid_hinge").append(etree.fromstring(soft))
    assert "joint lid_hinge: its <safety_controller> changes its limits" in told(export, "urdf")


@pytest.mark.parametrize(
    ("prim", "name", "kind", "value", "says"),
    [
        (
            "lid",
            "physxRigidBody:disableGravity",
            "Bool",
            True,
            "link lid: lid has physxRigidBody:disableGravity = True",
        ),
        (
            "lid_hinge",
            "physics:breakForce",
            "Float",
            1.0,
            "joint lid_hinge: lid_hinge has physics:breakForce = 1.0",
        ),
        (
            "lid_hinge",
            "drive:angular:physics:targetVelocity",
            "Float",
            90.0,
            "joint lid_hinge: lid_hinge has drive:angular:physics:targetVelocity = 90.0",
        ),
        (
            "lid_hinge",
            "physxLimit:angular:stiffness",
            "Float",
            0.1,
            "lid_hinge has physxLimit:angular:stiffness = 0.1",
        ),
        ("lid_hinge", "state:angular:physics:position", "Float", 30.0, "it begins at 0.5235988, not at 0"),
    ],
)
def test_prims_of_physics_say_what_an_asset_says(
    export: Export, prim: str, name: str, kind: str, value: Any, says: str
) -> None:
    from pxr import Sdf

    with export.layer() as layer:
        spec = export.prim(layer, prim)
        attribute = Sdf.AttributeSpec(spec, name, getattr(Sdf.ValueTypeNames, kind))
        attribute.default = value
    assert says in told(export, "usd")


def test_bodies_stand_still_in_time(export: Export) -> None:
    from pxr import Gf

    with export.layer() as layer:
        path = export.prim(layer, "lid").path.AppendProperty("xformOp:translate")
        for time in (1.0, 9.0):
            layer.SetTimeSample(path, time, Gf.Vec3d(0, 0, time))
    assert "link lid: lid has a xformOp:translate that changes with time" in told(export, "usd")


def record(export: Export, key: str, value: Any) -> None:
    def change(data: Any) -> None:
        data[key] = value

    edit_json(export.directory / "asset.json", change)


def test_the_layout_of_the_record_is_one_that_clients_know(export: Export) -> None:
    record(export, "layout", "flatt")
    assert "asset.json has the unknown layout 'flatt'. Did you mean 'flat'?" in told(export, "files")
    record(export, "layout", "simready")
    assert "asset.json has the layout 'simready', which has no urdf, mjcf, glb" in told(export, "files")


def test_a_record_without_formats_is_no_pass(export: Export) -> None:
    record(export, "formats", {})
    assert "asset.json lists no format, so nothing can be read" in told(export, "files")


def test_every_file_has_a_digest_and_every_digest_a_file(export: Export) -> None:
    def forget(data: Any) -> None:
        del data["digests"]["cabinet_7.glb"]
        del data["formats"]["usd"]

    edit_json(export.directory / "asset.json", forget)
    text = told(export, "files")
    assert "asset.json has no digest of cabinet_7.glb, so changes cannot be noticed" in text
    assert "a digest of cabinet_7.usda, cabinet_7_geometry.usdc, which no format lists" in text


def test_a_mass_that_all_files_agree_on_must_be_one_of_the_solids(export: Export) -> None:
    def change(data: Any) -> None:
        (lid,) = (link for link in data["links"] if link["name"] == "lid")
        lid["mass"] *= 1.01

    edit_json(export.directory / "asset.json", change)
    assert "link lid: its mass is" in told(export, "solids")
