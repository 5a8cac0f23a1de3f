"""Validation: sound exports pass, and each edit of the files is found by the check that it concerns."""

import json
import math
import os
import shutil
import sys
import types
import zlib
from dataclasses import replace
from unittest.mock import Mock

import pytest

from artgen.asset import Asset
from artgen.asset.asset import remember
from artgen.asset.certificate import Certificate, OpenCell, PairResult, Witness
from artgen.asset.joint import AllowedContact
from artgen.asset.report import CheckResult, Finding, Report
from artgen.commands.checks import write_report
from artgen.errors import AssetError, ExportError, ParameterError
from artgen.validate import CHECKS, Examination, tree, validate
from artgen.validate.files import check_certificate, read_export
from support.exports import edit_json, edit_text, stand


@pytest.fixture(scope="session")
def made():
    """A stand with its certificate."""
    return stand.generate(0)


@pytest.fixture(scope="session")
def exported(made, tmp_path_factory):
    return made.export(tmp_path_factory.mktemp("exported") / "stand_0")


@pytest.fixture
def copy(exported, tmp_path):
    """A copy of the export that may be edited."""
    return shutil.copytree(exported, tmp_path / "stand_0")


def faults(report: Report) -> dict[str, list[str]]:
    found: dict[str, list[str]] = {}
    for fault in report.faults:
        found.setdefault(fault.check, []).append(str(fault))
    return found


def judge(directory, **options) -> dict[str, list[str]]:
    return faults(validate(directory, behavior=False, **options))


def test_a_sound_export_passes_every_check(exported):
    report = validate(exported)
    assert not faults(report)
    assert report.passed
    assert [result.check for result in report.results] == [name for name in CHECKS if name != "room"]
    assert not [result for result in report.results if result.skipped]
    details = {result.check: result.detail for result in report.results}
    assert details["files"] == "12 files: urdf, mjcf, usd"  # three of them are maps
    assert details["certificate"].startswith(
        "1 pair of links, tolerance 0 mm, body and drawer never closer than "
    )


def test_the_name_may_be_a_string_or_a_path(exported):
    assert validate(str(exported), checks=["files"]) == validate(exported, checks=["files"])


def test_an_asset_in_memory_is_judged_by_its_files(made, monkeypatch):
    report = validate(made, behavior=False)
    assert not faults(report)
    assert report.asset == "stand_0"
    wanted = replace(made, joints=(replace(made.joints[0], limits=(0.0, 0.1)),))
    (found,) = judge(wanted)["certificate"]
    assert found == (
        "there is no certificate: nothing is proven about collisions between its links; generate with "
        "certification or asset.certify() before export; colliders of other kinds than 'exact' are proven by "
        "artgen.Asset.load(directory).certify()"
    )


@pytest.mark.parametrize("name", ["door", "handle"])
@pytest.mark.long
def test_the_categories_of_artgen_pass(name):
    from artgen import catalog

    report = validate(catalog.generate(name, seed=3), behavior=False)
    assert not faults(report)


def test_a_mass_changed_in_the_urdf_is_found(copy):
    path = copy / "stand_0.urdf"
    mass = path.read_text().split('<mass value="')[1].split('"')[0]
    edit_text(path, f'<mass value="{mass}"', '<mass value="9.5"')
    found = judge(copy)
    assert set(found) == {"urdf"}
    assert "9.5" in found["urdf"][0]
    assert "mass" in found["urdf"][0]
    assert "body" in found["urdf"][0]


def test_a_mesh_that_was_deleted_is_found(copy):
    (copy / "meshes/drawer_drawer_oak.obj").unlink()
    found = judge(copy)
    assert found["files"] == [
        "meshes/drawer_drawer_oak.obj is missing, which urdf and mjcf need; export the asset again"
    ]
    assert "link drawer: its meshes cannot be read: " in found["solids"][0]
    assert "tree" not in found
    assert {"urdf", "mjcf", "certificate"} <= set(found), "the proof is of these meshes"


def test_a_limit_changed_in_the_record_is_found_by_formats_and_proof(copy):
    edit_json(copy / "asset.json", lambda data: data["joints"][0].update(limits=[0.0, 0.25]))
    found = judge(copy)
    assert {"urdf", "mjcf", "usd", "certificate"} <= set(found)
    assert "slide" in found["urdf"][0]
    assert "files" not in found


@pytest.mark.parametrize("text", ["", "{", "[]"])
def test_a_damaged_certificate_file_is_found(copy, text):
    (copy / "certificate.json").write_text(text)
    found = judge(copy)
    assert found
    assert any("certificate" in fault for faults in found.values() for fault in faults)


def test_a_proof_that_was_tampered_with_is_found(copy):
    text = (copy / "certificate.json").read_text()
    data = json.loads(text)

    def widened(item):
        """Move every number of the proof."""
        if isinstance(item, dict):
            return {key: widened(value) for key, value in item.items()}
        if isinstance(item, list):
            return [widened(value) for value in item]
        return item * 0.5 + 0.01 if isinstance(item, float) else item

    (copy / "certificate.json").write_text(json.dumps(widened(data)))
    assert "certificate" in judge(copy)


def test_a_certificate_without_its_proof_is_found(copy):
    (copy / "certificate.json").unlink()
    assert "certificate.json with the proof is missing; certify the asset and export it again" in str(
        judge(copy)
    )


@pytest.mark.parametrize("content", ["{", '{"format": "other"}', "[]", '{"formats": 3}'])
def test_a_record_that_cannot_be_read_is_a_fault_and_the_rest_is_skipped(copy, content):
    (copy / "asset.json").write_text(content)
    report = validate(copy)
    assert set(faults(report)) == {"files"}
    assert faults(report)["files"][0].startswith("asset.json cannot be read: ")
    assert {result.skipped for result in report.results[1:]} == {"the asset cannot be read"}
    assert report.asset == "stand_0"


@pytest.mark.parametrize(
    "damage",
    [
        lambda data: data.pop("joints"),
        lambda data: data["joints"][0].update(limits=[0.0]),
        lambda data: data["joints"][0].update(axis="x"),
        lambda data: data.update(links=3),
    ],
)
def test_a_record_that_makes_no_asset_is_a_fault(copy, damage):
    edit_json(copy / "asset.json", damage)
    found = judge(copy)
    assert set(found) == {"files"}
    assert "asset.json cannot be read: " in found["files"][0]


def files_faults(directory) -> list[str]:
    return [str(finding) for finding in read_export(directory).result.faults]


MOVE_AWAY = "move it away: simulators that search meshes by name may load it"


def test_empty_unreadable_and_stray_files_are_found(copy):
    (copy / "meshes/drawer_drawer_oak.obj").write_bytes(b"")
    (copy / "stand_0.xml").unlink()
    (copy / "stand_0.xml").mkdir()
    (copy / "meshes/drawer_old.obj").write_text("v 0 0 0")
    assert files_faults(copy) == [
        "meshes/drawer_drawer_oak.obj is empty, which urdf and mjcf need; export the asset again",
        "stand_0.xml cannot be read (Is a directory), which mjcf needs; export the asset again",
        f"meshes/drawer_old.obj is not listed in asset.json; {MOVE_AWAY}",
    ]


def test_a_path_may_not_lead_out(copy):
    edit_json(copy / "asset.json", lambda data: data["formats"]["urdf"]["files"].append("../secret"))
    (found,) = files_faults(copy)
    assert found.endswith(
        "the path '../secret' is not allowed; it must be relative and stay in the folder of the asset; "
        "export the asset again"
    )


def test_a_file_that_would_fill_the_memory_or_the_stack_is_a_fault(copy):
    deep = b"[" * 200_000 + b"]" * 200_000
    (copy / "certificate.json").write_bytes(deep)
    texture = next(copy.glob("meshes/textures/*.png"))
    content = bytearray(texture.read_bytes())
    content[16:24] = (60_000).to_bytes(4, "big") * 2
    content[29:33] = zlib.crc32(content[12:29]).to_bytes(4, "big")
    texture.write_bytes(content)
    found = " ".join(files_faults(copy))
    assert "certificate.json cannot be read: RecursionError" in found
    assert f"{texture.name} is not a readable image" in found
    (copy / "asset.json").write_bytes(deep)
    assert "asset.json cannot be read: RecursionError" in " ".join(files_faults(copy))


def test_a_stray_file_whose_name_is_no_utf_8_can_be_reported(copy):
    (copy / os.fsdecode(b"\xff.txt")).write_text("x")
    report = validate(copy, behavior=False, checks=["files"])
    assert "\\xff.txt is not listed in asset.json" in str(report)
    report.to_json().encode()


def test_a_link_to_itself_is_a_fault(copy):
    urdf = next(copy.glob("*.urdf"))
    urdf.unlink()
    urdf.symlink_to(urdf.name)
    assert any(f"{urdf.name} cannot be read" in message for message in files_faults(copy))
    assert "its main file is missing" in " ".join(judge(copy, checks=["urdf"])["urdf"])


@pytest.mark.parametrize("pattern", ["*.urdf", "*.xml", "meshes/*.obj"])
def test_a_pipe_is_a_fault_and_no_reader_waits_for_it(copy, pattern):
    pipe = next(copy.glob(pattern))
    pipe.unlink()
    os.mkfifo(pipe)
    assert any("a pipe or a socket, not an ordinary file" in message for message in files_faults(copy))
    report = validate(copy, behavior=False, checks=["urdf", "mjcf"])
    assert {result.skipped for result in report.results} == {f"{pipe} is a device, a pipe or a socket"}


def test_a_pipe_that_is_not_listed_is_a_fault_as_it_stops_all_readers(copy):
    os.mkfifo(copy / "pipe.xml")
    report = validate(copy, behavior=False)
    assert not report.passed
    assert files_faults(copy) == [
        "pipe.xml is not listed in asset.json, and is a device, a pipe or a socket; remove it"
    ]


@pytest.mark.parametrize(
    ("old", "new", "fault"),
    [
        ("<worldbody>", '<include file="{outside}"/><worldbody>', "it has <include>, which is not loaded"),
        ("<worldbody>", '<worldbody><replicate count="90000"><geom size="1"/></replicate>', "<replicate>"),
        (
            "<worldbody>",
            '<worldbody><flexcomp type="grid" count="900 9 9" spacing="1 1 1" dim="3" name="f"/>',
            "<flexcomp>",
        ),
        (
            "<compiler ",
            '<compiler meshdir="/etc" ',
            "its <compiler> names '/etc', which is outside its folder",
        ),
        ('file="meshes/', 'file="../', "which is outside its folder"),
        ("</worldbody>", '<geom size="1"/>' * 50_001 + "</worldbody>", "at most 50000 are read"),
    ],
    ids=["include", "replicate", "flexcomp", "directory", "mesh", "many"],
)
def test_mujoco_opens_no_mjcf_that_reads_other_files_or_grows(copy, old, new, fault):
    (copy.parent / "outside.xml").write_text("<mujoco/>")
    path = copy / "stand_0.xml"
    text = path.read_text()
    path.write_text(text.replace(old, new.format(outside=copy.parent / "outside.xml"), 1))
    found = faults(validate(copy, checks=["mjcf", "behavior"]))
    assert [each for each in found["mjcf"] if "it cannot be read: it" in each and fault in each]
    assert len(found["behavior"]) == 1
    assert "MuJoCo cannot use stand_0.xml: it" in found["behavior"][0]
    assert fault in found["behavior"][0]


def test_a_simulation_has_its_own_time_step(copy):
    path = copy / "stand_0.xml"
    path.write_text(path.read_text().replace("<worldbody>", '<option timestep="1e-9"/><worldbody>', 1))
    found = faults(validate(copy, checks=["mjcf", "behavior"]))
    (fault,) = found["mjcf"]
    assert "sets timestep to 1e-9, which belongs to the scene" in fault
    assert "behavior" not in found


def test_a_report_has_no_number_that_json_lacks():
    finding = Finding("certificate", "a gap", value=math.nan, pose={"slide": math.inf})
    report = Report("stand_0", (CheckResult("certificate", (finding,)),))
    (written,) = json.loads(report.to_json())["results"][0]["findings"]
    assert (written["value"], written["pose"]) == (None, {"slide": None})


def test_a_broken_link_is_a_missing_file(copy):
    (copy / "stand_0.usda").unlink()
    (copy / "stand_0.usda").symlink_to(copy / "nowhere")
    assert files_faults(copy) == ["stand_0.usda is missing, which usd needs; export the asset again"]


def test_files_of_others_beside_an_asset_are_noted_only(copy):
    (copy / "photo.png").write_bytes(b"png")
    (copy / "notes").mkdir()
    (copy / "notes/todo.txt").write_text("sand")
    result = read_export(copy).result
    assert not result.faults
    assert [str(note) for note in result.findings] == [
        "notes/todo.txt is not listed in asset.json",
        "photo.png is not listed in asset.json",
    ]
    write_report(Report("stand_0", ()), copy)
    assert len(read_export(copy).result.findings) == 2, "a report is no stranger"


def test_a_check_that_raises_is_a_fault_and_the_others_run(exported, monkeypatch):
    def broken(asset):
        raise ZeroDivisionError("by zero")

    monkeypatch.setattr(tree, "check_tree", broken)
    report = validate(exported, checks=["tree", "files"])
    assert [result.check for result in report.results] == ["files", "tree"]
    (fault,) = report.faults
    assert fault.message == "the check could not run: ZeroDivisionError: by zero"

    def refused(asset):
        raise AssetError("link 'a' is odd", link="a")

    monkeypatch.setattr(tree, "check_tree", refused)
    assert validate(exported, checks=["tree"]).faults[0].message == "the check could not run: link 'a' is odd"


def test_checks_run_once_and_only_when_asked_for(exported, monkeypatch):
    runs = []
    monkeypatch.setattr(tree, "check_tree", lambda asset: runs.append(asset.name) or CheckResult("tree"))
    examination = Examination(exported)
    assert not runs
    assert examination.result("tree") is examination.result("tree")
    assert runs == ["stand_0"]


def test_what_was_not_exported_is_not_checked(made, tmp_path):
    directory = made.export(tmp_path / "usd", formats=["usd"])
    report = validate(directory)
    assert not report.faults
    skipped = {result.check: result.skipped for result in report.results if result.skipped}
    assert skipped == {
        "solids": "the export has no meshes to read back: those of urdf and mjcf in the layout flat have",
        "colliders": "the export has no meshes to read back: those of urdf and mjcf in the layout flat have",
        "grasps": "the export has no meshes to read back: those of urdf and mjcf in the layout flat have",
        "behavior": "the export has no mjcf",
    }
    assert [result.check for result in report.results if result.check in ("urdf", "mjcf", "usd")] == ["usd"]
    (note,) = next(result for result in report.results if result.check == "certificate").findings
    assert note.message == "the proof is not verified: the export has no meshes to compare its pieces with"
    (asked,) = validate(directory, checks=["urdf"]).results
    assert asked.skipped == "the export has no urdf"


def test_the_simulation_can_be_left_out(exported, monkeypatch):
    monkeypatch.setitem(sys.modules, "artgen.validate.behavior", None)  # importing it would raise
    (result,) = validate(exported, behavior=False, checks=["behavior"]).results
    assert result.skipped == "not requested"
    (result,) = validate(exported, checks=["behavior"]).results
    assert result.faults


@pytest.mark.parametrize(
    ("what", "message"),
    [
        ("nowhere", "nowhere is not a directory; give a directory that artgen exported an asset to"),
        (".", "has no asset.json; give a directory that artgen exported an asset to"),
    ],
)
def test_a_directory_that_is_no_export_is_wrong_use(tmp_path, what, message):
    with pytest.raises(ExportError, match=message):
        validate(tmp_path / what)


def test_an_unknown_check_is_wrong_use(exported):
    with pytest.raises(ParameterError, match=r"there is no check 'trea'\. Did you mean 'tree'\?"):
        validate(exported, checks=["trea"])


def test_a_report_is_written_whole_or_not_at_all(tmp_path, monkeypatch):
    report = Report("stand_0", (CheckResult("tree", (Finding("tree", "floats", value=0.1),)),))
    assert write_report(report, tmp_path) == tmp_path / "report.json"
    assert (tmp_path / "report.json").read_text() == report.to_json()
    other = replace(report, asset="other")
    with pytest.raises(ExportError, match=r"cannot write .*report\.json is a file"):
        write_report(other, tmp_path / "report.json")

    def full(*arguments):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("pathlib.Path.replace", full)
    with pytest.raises(ExportError, match="No space left on device"):
        write_report(other, tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["report.json"]
    assert (tmp_path / "report.json").read_text() == report.to_json()


def test_a_checked_asset_can_be_exported_again(made, copy):
    write_report(validate(copy, checks=["files"]), copy)
    made.export(copy)
    assert Asset.load(copy).name == "stand_0"


# ---- certificates: what a pair that is not proven tells


@pytest.fixture
def with_certificate(made, monkeypatch):
    """Return the findings about an asset with a certificate of these pairs, whose proof holds."""

    def judged(*pairs, contacts=(), tolerance=0.0, asset=made):
        asset = replace(asset)
        remember(asset, Certificate(tolerance, pairs, contacts, {}))
        return check_certificate(asset)

    rechecker = types.ModuleType("artgen.proof.recheck")
    monkeypatch.setitem(sys.modules, rechecker.__name__, rechecker)
    judged.rechecked = rechecker.recheck = Mock(return_value=[])
    return judged


PAIR = PairResult(("body", "drawer"), ("slide",), "proven", "proven", 0.0021)
WITNESS = Witness({"slide": 0.1}, {"slide": 0.05}, 0.003, 1e-6, (0.1, 0.2, 0.3), ("body", "drawer"))


def test_a_proven_certificate_lists_tolerance_clearance_and_contacts(with_certificate, made):
    contact = AllowedContact(("body", "drawer"), ("seal", "drawer"), 0.0012, "a seal is pressed")
    assert with_certificate(PAIR, tolerance=0.001).detail == (
        "1 pair of links, tolerance 1 mm, body and drawer never closer than 2.1 mm"
    )
    sealed = replace(made, contacts=(contact,))
    result = with_certificate(PAIR, contacts=(contact,), asset=sealed)
    assert not result.findings
    assert result.detail.endswith(
        "allowed contacts: body/seal may press 1.2 mm into drawer/drawer: a seal is pressed"
    )
    (finding,) = with_certificate(PAIR, contacts=(contact,)).findings
    assert "the certificate allows a contact that the asset does not declare: body/seal" in finding.message
    assert with_certificate().detail == "nothing moves"


PRESSES = "body presses 3.000 mm into drawer at (0.100, 0.200, 0.300) m; first contact at "
CLEARANCE = "give the two pieces more clearance there, or shorten the limits to asset.safe_limits()"
AT_REST = "they overlap at rest: move one of the parts, or allow the contact with body.allow_contact(...)"
REGION = "slide in 0.1..0.2, where body is 0.010 mm from drawer"
OPEN = OpenCell({"slide": (0.1, 0.2)}, ("body", "drawer"), 1e-5)


@pytest.mark.parametrize(
    ("pair", "message", "hint", "pose"),
    [
        (
            replace(PAIR, verdict="collision", colliders="collision", witness=WITNESS),
            f"they collide: {PRESSES}slide=0.05",
            "shorten the limits to asset.safe_limits(), or move the pivot",
            {"slide": 0.1},
        ),
        (
            replace(PAIR, colliders="collision", witness=replace(WITNESS, first_contact={"slide": 0.0})),
            f"only their colliders collide, not their solids: {PRESSES}rest",
            f"{AT_REST}; or give their solids colliders or covers that stay closer to them",
            {"slide": 0.1},
        ),
        (
            replace(
                PAIR, verdict="not proven", colliders="not proven", open_cells=(OPEN,), open_fraction=0.02
            ),
            f"not proven in 2 % of their joint space, such as {REGION}",
            CLEARANCE,
            {"slide": pytest.approx(0.15)},
        ),
        (
            replace(PAIR, colliders="not proven", open_fraction=0.5),
            "not proven for their colliders in 50 % of their joint space",
            CLEARANCE,
            {},
        ),
    ],
)
def test_a_pair_that_is_not_proven_tells_where_and_what_to_do(with_certificate, pair, message, hint, pose):
    (fault,) = with_certificate(pair).faults
    assert (fault.link, fault.message, fault.hint, fault.pose) == ("body, drawer", message, hint, pose)
    assert fault.value == (pair.witness.depth if pair.witness else pair.open_fraction)


def test_what_the_rechecker_finds_is_a_fault(with_certificate):
    found = Finding("certificate", "leaf 3 does not hold", link="body, drawer", value=-0.001, unit="m")
    with_certificate.rechecked.return_value = [found]
    assert with_certificate(PAIR).faults == (found,)


def test_a_stand_that_collides_fails_with_its_witness():
    asset = stand.generate(0, gap=-0.001, on_collision="keep")
    found = judge(asset)
    assert set(found) == {"certificate"}
    assert "link body, drawer: they collide: " in found["certificate"][0]
