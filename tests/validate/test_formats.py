import re
import shutil
import sys

import numpy as np
import pytest
from pxr import Usd

import artgen
from artgen import Prismatic, Revolute, X, Y, Z, box, capsule, part, sphere
from artgen.asset import Asset
from artgen.validate.readback import check_formats
from artgen.validate.readback.compare import Comparison, Expected
from artgen.validate.readback.reading import Faces, Reading
from support.blocks import STEEL

pytest.importorskip("mujoco")


@artgen.generator
def machine() -> artgen.Body:
    """Every kind of joint: turning, sliding, unlimited, coupled, locked, and two on one pair of links."""
    tray = part(box(0.1, 0.1, 0.02).at(0.3, 0, 0), "tray", STEEL)
    slide = Prismatic("slide", axis=X, limits=(0.01, 0.2))
    turn = Revolute("turn", axis=Z, pivot=(0.3, 0, 0), limits=(-0.5, 0.5))
    dial = part(capsule(0.02, 0.05).at(0, -0.2, 0), "dial", STEEL)
    spin = Revolute("spin", axis=Y, pivot=(0, -0.2, 0))
    flap = part(sphere(0.03).at(0, 0, 0.3), "flap", STEEL)
    follow = Revolute("follow", axis=X, pivot=(0, 0, 0.25), follows=2.0 * slide + 0.1)
    lid = part(box(0.1, 0.1, 0.01).at(0, 0.3, 0), "lid", STEEL)
    lean = Revolute("lean", axis=X, pivot=(0, 0.25, 0), follows=0.2 - 0.5 * turn)
    plate = part(box(0.05, 0.05, 0.01).at(0, 0, -0.3), "plate", STEEL)
    held = Revolute("held", axis=Z, pivot=(0, 0, -0.3), limits=(0.2, 0.2))
    body = part(box(0.2, 0.2, 0.2, bevel=0.01), "body", STEEL)
    body = body.attach(tray, slide, turn).attach(dial, spin).attach(flap, follow)
    return body.attach(plate, held).attach(lid, lean)


@pytest.fixture(scope="module")
def exported(tmp_path_factory):
    asset = machine.generate(name="machine", certify=False)
    return asset.export(tmp_path_factory.mktemp("exported") / "machine")


@pytest.fixture
def copy(exported, tmp_path):
    return shutil.copytree(exported, tmp_path / "machine")


def results(directory):
    return {result.check: result for result in check_formats(Asset.load(directory), directory)}


def edit(directory, suffix, pattern, replacement, count=1):
    """Replace what a pattern matches in the file of a format."""
    path = directory / f"machine.{suffix}"
    text, found = re.subn(pattern, replacement, path.read_text(), count=count, flags=re.DOTALL)
    assert found, f"{pattern} is not in {path.name}"
    path.write_text(text)


def only(directory, check):
    """The findings of one format, where the others have none."""
    found = results(directory)
    assert [name for name, result in found.items() if result.findings] == [check]
    return [(finding.link or finding.joint, finding.message) for finding in found[check].findings]


def test_formats_say_what_the_asset_is(exported, capfd):
    found = results(exported)
    assert list(found) == ["urdf", "mjcf", "usd"]
    assert not [finding for result in found.values() for finding in result.findings]
    assert found["urdf"].detail == "machine.urdf: 6 links, 5 joints, 6 poses"
    assert not any(capfd.readouterr())


def test_specks_of_links_between_joints_are_no_faces(tmp_path):
    directory = machine.generate(name="machine", certify=False).export(tmp_path / "machine", frames=False)
    assert 'sphere radius="0.0001"' in (directory / "machine.urdf").read_text()
    assert not [finding for result in results(directory).values() for finding in result.findings]


def test_a_locked_joint_has_no_tendon_to_compare(tmp_path):
    asset = artgen.generate("toilet", 737304, detail="medium", limits="independent")
    assert asset.joint("seat_hinge").locked
    assert asset.joint("seat_hinge").closing is not None
    directory = asset.export(tmp_path / "out", formats=("mjcf",), textures=0)
    assert not [finding for result in results(directory).values() for finding in result.findings]


@pytest.mark.parametrize(("category", "seed"), [("door", 3), ("handle", 5)])
@pytest.mark.long
def test_categories_agree(category, seed, tmp_path):
    directory = artgen.generate(category, seed, certify=False).export(tmp_path / "out")
    assert not [finding for result in results(directory).values() for finding in result.findings]


def test_only_the_formats_that_are_there_are_checked(copy):
    (copy / "machine.xml").unlink()
    assert list(results(copy)) == ["urdf", "usd"]


def test_mjcf_is_skipped_without_mujoco(exported, monkeypatch):
    monkeypatch.setitem(sys.modules, "mujoco", None)
    found = results(exported)
    assert found["mjcf"].skipped == "needs artgen[sim]"
    assert not found["urdf"].skipped


@pytest.mark.parametrize(
    ("check", "suffix", "pattern"),
    [
        ("urdf", "urdf", r'(<link name="tray">.*?<mass value=")[^"]*'),
        ("mjcf", "xml", r'(<body name="tray".*? mass=")[^"]*'),
        ("usd", "usda", r'(def Xform "tray".*?physics:mass = )[^\n]*'),
    ],
)
def test_another_mass_is_found(copy, check, suffix, pattern):
    edit(copy, suffix, pattern, r"\g<1>1.5")
    ((place, message),) = only(copy, check)
    assert place == "tray"
    assert message == f"its mass is 1.5 kg in machine.{suffix}, not 1.57 kg"


@pytest.mark.parametrize(
    ("check", "suffix", "pattern", "unit"),
    [
        ("urdf", "urdf", r'(<joint name="turn".*?upper=")[^"]*', 1.0),
        ("mjcf", "xml", r'(<joint name="turn".*?range="-0.5 )[^"]*', 1.0),
        ("usd", "usda", r'(Joint "turn".*?physics:upperLimit = )[^\n]*', 180.0 / np.pi),
    ],
)
def test_another_limit_is_found(copy, check, suffix, pattern, unit):
    edit(copy, suffix, pattern, rf"\g<1>{0.75 * unit:.9g}")
    ((place, message),) = only(copy, check)
    assert place == "turn"
    assert message == f"its limits are -0.5 to 0.75 rad in machine.{suffix}, not -0.5 to 0.5 rad"


@pytest.mark.parametrize(
    ("check", "suffix", "pattern"),
    [
        ("urdf", "urdf", r'(<mimic [^>]*multiplier=")[^"]*'),
        ("mjcf", "xml", r'(polycoef="0 )[^ ]*'),
        ("usd", "usda", r"(mjc:coef1 = )[^\n]*"),
    ],
)
def test_another_coupling_is_found(copy, check, suffix, pattern):
    edit(copy, suffix, pattern, r"\g<1>2.5")
    found = only(copy, check)
    assert found[0][0] == "follow"
    assert found[0][1].startswith("it is 2.5 * slide + ")
    assert found[0][1].endswith(f" in machine.{suffix}, not 2 * slide + 0.1")


@pytest.mark.parametrize(
    ("check", "suffix", "pattern"),
    [
        ("urdf", "urdf", r"<mimic [^>]*>"),
        ("mjcf", "xml", r"<equality>.*</equality>"),
        ("usd", "usda", r"rel mjc:target = [^\n]*"),
    ],
)
def test_a_coupling_that_is_gone_is_found(copy, check, suffix, pattern):
    edit(copy, suffix, pattern, "")
    assert ("follow", f"it follows another joint, but not in machine.{suffix}") in only(copy, check)


@pytest.mark.parametrize(
    ("check", "suffix", "pattern", "replacement"),
    [
        ("urdf", "urdf", r'(<joint name="spin".*?)<axis xyz="0 1 0"/>', r'\g<1><axis xyz="0 0 1"/>'),
        ("mjcf", "xml", r'(<joint name="spin"[^>]*?)axis="0 1 0"', r'\g<1>axis="0 0 1"'),
    ],
)
def test_another_axis_moves_frames(copy, check, suffix, pattern, replacement):
    edit(copy, suffix, pattern, replacement)
    found = dict(only(copy, check))
    assert found["spin"] == f"its axis differs by 1 in machine.{suffix}"
    assert re.fullmatch(rf"its frame is off by [0-9.]+ \(m or radians\) in machine.{suffix}", found["dial"])


def test_another_pivot_is_found_with_the_pose_at_which_it_shows(copy):
    edit(copy, "usda", r'(Joint "turn".*?physics:localPos0 = \()[^,]*', r"\g<1>0.1")
    found = results(copy)["usd"].findings
    assert {finding.link for finding in found} == {"tray"}
    assert found[0].message.startswith("its frame is off by ")


@pytest.mark.parametrize(
    ("check", "suffix", "pattern"),
    [
        ("urdf", "urdf", r'(<collision name="tray_collider_0">.*?<box size=")[^"]*'),
        ("mjcf", "xml", r'(<geom name="tray_collider_0"[^>]*? size=")[^"]*'),
    ],
)
def test_another_collider_is_found(copy, check, suffix, pattern):
    edit(copy, suffix, pattern, r"\g<1>0.1 0.1 0.03" if suffix == "urdf" else r"\g<1>0.05 0.05 0.015")
    ((place, message),) = only(copy, check)
    assert place == "tray"
    assert message == (
        f"its collider tray_collider_0 is off by 5 mm and has 300 cm^3 in machine.{suffix}, not 200 cm^3"
    )


def test_usd_is_read_from_the_disk_though_it_is_open(copy):
    stage = Usd.Stage.Open(str(copy / "machine.usda"))
    edit(copy, "usda", r'(def Xform "tray".*?physics:mass = )[^\n]*', r"\g<1>1.5")
    assert [place for place, _ in only(copy, "usd")] == ["tray"]
    del stage


def test_a_collider_that_is_gone_is_found(copy):
    edit(copy, "urdf", r'<collision name="tray_collider_0">.*?</collision>', "")
    message = "it has 0 colliders in machine.urdf, not 1, without 0 (box of 'tray')"
    assert only(copy, "urdf") == [("tray", message)]


def test_another_kind_of_joint_is_found(copy):
    edit(copy, "urdf", r'(<joint name="turn" type=")revolute', r"\g<1>prismatic")
    found = only(copy, "urdf")
    assert ("turn", "it is prismatic in machine.urdf, not revolute") in found


def test_a_joint_that_is_fixed_or_strange_is_found(copy):
    edit(copy, "urdf", r'(<joint name="turn" type=")revolute', r"\g<1>fixed")
    assert ("turn", "machine.urdf has no such joint that can move") in only(copy, "urdf")
    edit(copy, "urdf", r'(<joint name=")turn(" type=")fixed', r"\g<1>turned\g<2>revolute")
    assert ("turned", "it can move in machine.urdf, but is not a moving joint of the asset") in only(
        copy, "urdf"
    )


@pytest.mark.parametrize(("check", "suffix"), [("urdf", "urdf"), ("mjcf", "xml"), ("usd", "usda")])
def test_a_file_that_cannot_be_read_is_one_finding(copy, check, suffix, capfd):
    path = copy / f"machine.{suffix}"
    path.write_text(path.read_text()[:2000])
    ((place, message),) = only(copy, check)
    assert not place
    assert message.startswith("it cannot be read: ")
    assert "\n" not in message
    assert not any(capfd.readouterr())


def test_a_missing_mesh_is_found(copy):
    (path,) = (copy / "meshes").glob("tray_*.obj")
    path.unlink()
    found = results(copy)
    assert any("tray_tray" in finding.message for finding in found["urdf"].findings)
    assert any(path.name in finding.message for finding in found["mjcf"].findings)


def test_a_missing_layer_is_found(copy, capfd):
    (copy / "machine_geometry.usdc").unlink()
    found = results(copy)["usd"].findings
    assert any("machine_geometry.usdc" in finding.message for finding in found)
    assert not any(capfd.readouterr())


def face_findings(wanted, found):
    """Return the differences of the meshes of one link."""
    board = part(box(0.2, 0.1, 0.02), "board", STEEL)
    expected = Expected(artgen.generator(lambda: board).generate(name="board", certify=False))
    vars(expected)["faces"] = {"board": wanted}
    links = frozenset({"links"})
    reading = Reading("board.xml", lambda _: {}, parts=links, faces={"board": found}, partial=True)
    found = Comparison("mjcf", expected, reading, "mjcf").differences()
    return [finding for finding in found if "faces" in finding.message]


def test_meshes_with_one_bounding_box_are_told_apart_by_their_triangles():
    """The faces and the edges of a board, which rounding would exchange."""
    low, high = (np.array([[-0.1, -0.05, -0.01], [0.1, 0.05, 0.01]]) + noise for noise in (0.0, 2e-9))
    wanted = (Faces("faces", low, 4), Faces("edges", high, 8))
    found = (Faces("edges", low, 8), Faces("faces", high, 4))
    assert face_findings(wanted, found) == []
    fewer = (Faces("edges", low, 7), Faces("faces", high, 4))
    (fault,) = face_findings(wanted, fewer)
    assert "edges have 7 triangles in board.xml, not 8" in fault.message


@pytest.mark.parametrize(
    ("pattern", "replacement", "fault"),
    [
        (r'(physics:axis = )"\w"', r'\1"W"', "has the physics:axis 'W', not 'X', 'Y' or 'Z'"),
        (
            r"(physics:localPos0 = )\([^)]*\)",
            r"\1(inf, 0, 0)",
            "has the physics:localPos0 (inf, 0, 0), which",
        ),
        (r"(physics:localRot0 = )\([^)]*\)", r"\1(nan, 0, 0, 0)", "has the physics:localRot0 (nan, 0, 0, 0)"),
        (r"(inputs:file = )@[^@]*@", r"\1@/etc/hosts@", "it reads '/etc/hosts', which is outside its folder"),
        (r'kind = "component"', r"\g<0>\n    payload = @../other.usda@", "other.usda', which is outside"),
    ],
    ids=["axis", "position", "rotation", "texture", "payload"],
)
def test_usd_that_readers_take_silently_is_found(copy, pattern, replacement, fault):
    (copy.parent / "other.usda").write_text('#usda 1.0\n(defaultPrim = "a")\ndef Xform "a" {}\n')
    edit(copy, "usda", pattern, replacement)
    assert [finding for finding in results(copy)["usd"].faults if fault in finding.message]


def test_a_urdf_of_very_many_links_is_refused_before_it_is_read(copy):
    edit(copy, "urdf", "</robot>", "".join(f'<link name="z{n}"/>' for n in range(2000)) + "</robot>")
    faults = [finding.message for finding in results(copy)["urdf"].faults]
    assert any(
        "it cannot be read: it has 20" in fault and "links, where the asset has" in fault for fault in faults
    )
