"""The judgment of files of other tools: verdicts, witnesses, pictures, repairs and limits."""

import json
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from artgen.errors import AssetError, ExportError, ParameterError
from artgen.referee import certify
from support.foreign_cabinet import FAULTS, FORMATS, cabinet

# MJCF: parents and children do not collide by default
_ALL_PAIRS = '<option><flag filterparent="disable"/></option>'


def _extra(form: str) -> str:
    return _ALL_PAIRS if form == "mjcf" else ""


@pytest.mark.parametrize("form", FORMATS)
def test_a_sound_cabinet_is_proven_and_the_proof_is_rechecked(form: str, tmp_path: Path) -> None:
    judgment = certify(cabinet(form, tmp_path, extra=_extra(form)))
    assert judgment.verdict == judgment.verdict_with_excluded == "proven"
    assert judgment.rechecked
    assert (judgment.links, judgment.joints, judgment.colliders) == (3, 2, 6)
    assert len(judgment.pairs) == 3
    assert f"{judgment.path}: proven (3 links, 2 joints, 6 colliders" in str(judgment)


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("fault", FAULTS)
def test_a_planted_fault_is_found(form: str, fault: str, tmp_path: Path) -> None:
    judgment = certify(cabinet(form, tmp_path, extra=_extra(form), **{fault: FAULTS[fault]}))
    assert judgment.verdict == "collision"
    guilty = {"hinge": "door", "leaf_": "door", "shelf": "drawer"}.get(fault[:5], "drawer")
    pair = judgment.failures[0]
    assert guilty in pair.result.links
    witness = pair.result.witness
    assert witness is not None
    assert witness.depth > 1e-4
    assert set(witness.pose) <= {"hinge", "slide"}
    assert "collide at" in str(pair)


@pytest.mark.parametrize(("own", "verdict"), [(1.5, "collision"), (1.2, "collision"), (0.2, "not proven")])
def test_a_collision_beyond_the_limits_of_a_coupled_joint_is_not_proven(
    own: float, verdict: str, tmp_path: Path
) -> None:
    def link(name: str, z: float, size: str) -> str:
        shape = f'<origin xyz="0 0 {z}"/><geometry><box size="{size}"/></geometry>'
        return f'<link name="{name}"><collision>{shape}</collision></link>'

    def joint(name: str, child: str, place: str, most: float, more: str = "") -> str:
        ends = f'<parent link="base"/><child link="{child}"/><origin xyz="{place}"/><axis xyz="0 1 0"/>'
        limit = f'<limit lower="-{most}" upper="{most}" effort="1" velocity="1"/>'
        return f'<joint name="{name}" type="revolute">{ends}{limit}{more}</joint>'

    links = [link("base", 0, ".2 .2 .2"), link("arm", 0.12, ".08 .08 .2"), link("dial", 0, ".02 .02 .02")]
    joints = [
        joint("h", "arm", ".15 0 .12", 1.5),  # the arm touches the base at -1.11
        joint("k", "dial", "0 0 .5", own, '<mimic joint="h"/>'),
    ]
    file = tmp_path / "arm.urdf"
    file.write_text(f'<robot name="arm">{"".join((*links, *joints))}</robot>')
    judgment = certify(file)
    assert judgment.verdict == verdict
    assert ("for the limits of 'k' may forbid this pose" in str(judgment)) == (verdict == "not proven")


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("fault", ["hinge_low", "drawer_low", "hinge_axis"])
def test_a_repaired_copy_is_proven(form: str, fault: str, tmp_path: Path) -> None:
    judgment = certify(cabinet(form, tmp_path, extra=_extra(form), **{fault: FAULTS[fault]}))
    copy = judgment.repair()
    assert copy.name.startswith("cabinet.repaired")
    repaired = certify(copy)
    assert repaired.verdict == "proven"
    assert (repaired.links, repaired.joints, repaired.colliders) == (3, 2, 6)
    ranges = {
        joint.name: joint.limits for tree in repaired.trees for joint in tree.asset.joints if joint.limits
    }
    other, width = ("slide", 0.4) if fault.startswith("hinge") else ("hinge", 1.9)
    assert np.ptp(ranges[other]) == pytest.approx(width, abs=1e-3), "the sound joint keeps its range"
    if fault != "hinge_axis":
        narrowed, width = ("hinge", 1.9) if other == "slide" else ("slide", 0.4)
        assert np.ptp(ranges[narrowed]) == pytest.approx(width, abs=0.01)


def test_no_limits_mend_an_overlap_at_rest(tmp_path: Path) -> None:
    judgment = certify(cabinet("mjcf", tmp_path, extra=_ALL_PAIRS, shelf=0.63))
    with pytest.raises(AssetError, match="no joint limits mend asset 'cabinet': with those that are left"):
        judgment.repair()


def test_a_copy_lies_beside_the_file(tmp_path: Path) -> None:
    judgment = certify(cabinet("mjcf", tmp_path, extra=_ALL_PAIRS, drawer_low=-0.05))
    (tmp_path / "other").mkdir()
    for out in (judgment.path, tmp_path / "other" / "copy.xml"):
        with pytest.raises(ExportError, match=r"name another file in .*, where the meshes are found"):
            judgment.repair(out)


def test_the_repair_of_a_package_is_a_layer_beside_it(tmp_path: Path) -> None:
    from pxr import UsdUtils

    package = tmp_path / "cabinet.usdz"
    assert UsdUtils.CreateNewUsdzPackage(str(cabinet("usd", tmp_path, drawer_low=-0.05)), str(package))
    copy = certify(package).repair()
    assert copy.name == "cabinet.repaired.usda"
    assert certify(copy).verdict == "proven"


def test_pairs_that_the_file_excludes_have_a_verdict_of_their_own(tmp_path: Path) -> None:
    judgment = certify(
        cabinet(
            "mjcf", tmp_path, extra='<contact><exclude body1="case" body2="door"/></contact>', hinge_low=-0.2
        )
    )
    assert (judgment.verdict, judgment.verdict_with_excluded) == ("proven", "collision")
    (pair,) = judgment.failures
    assert pair.excluded == "<exclude>"
    assert "with the pairs that the file excludes: collision" in str(judgment)
    assert "[the file excludes this pair: <exclude>]" in str(judgment)


def test_the_picture_shows_the_pair_in_red_and_blue(tmp_path: Path) -> None:
    judgment = certify(cabinet("mjcf", tmp_path, extra=_ALL_PAIRS, hinge_low=-0.2))
    pair = judgment.picture(tmp_path / "witness.png", size=128)
    assert "door" in pair.result.links
    with Image.open(tmp_path / "witness.png") as image:
        red, _, blue = np.moveaxis(np.asarray(image.convert("RGB"), float), 2, 0)
    assert (red > blue + 60).mean() > 0.02
    assert (blue > red + 60).mean() > 0.02


def test_a_proven_file_has_no_picture(tmp_path: Path) -> None:
    with pytest.raises(AssetError, match="no pair collides; there is nothing to draw"):
        certify(cabinet("mjcf", tmp_path)).picture(tmp_path / "no.png")


def test_a_time_limit_leaves_pairs_open_and_says_so(tmp_path: Path) -> None:
    judgment = certify(cabinet("mjcf", tmp_path, extra=_ALL_PAIRS), seconds=1e-9)
    assert judgment.verdict == "not proven"
    assert all(pair.seconds == 1e-9 for pair in judgment.failures)
    assert "not proven after 1e-09 s" in str(judgment)


def test_the_data_hold_everything(tmp_path: Path) -> None:
    judgment = certify(cabinet("mjcf", tmp_path, extra=_ALL_PAIRS, hinge_low=-0.2))
    data = json.loads(json.dumps(judgment.to_data()))
    assert data["verdict"] == "collision"
    assert {pair["verdict"] for pair in data["pairs"]} == {"collision", "proven"}
    witness = next(pair["witness"] for pair in data["pairs"] if pair["witness"])
    assert set(witness) >= {"pose", "depth", "place", "labels"}


def test_a_tampered_proof_is_refuted_by_the_recheck(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from artgen.proof import certify as proof

    real = proof._rows
    monkeypatch.setattr(proof, "_rows", lambda search: real(search)[:-1])
    judgment = certify(cabinet("mjcf", tmp_path, extra=_ALL_PAIRS))
    assert not judgment.rechecked
    assert "the recheck refutes" in str(judgment)


def test_wrong_arguments_give_one_line(tmp_path: Path) -> None:
    path = cabinet("mjcf", tmp_path)
    with pytest.raises(ExportError, match="there is no file"):
        certify(tmp_path / "none.urdf")
    with pytest.raises(ParameterError, match=r"its name must end in \.urdf, \.xml"):
        certify(tmp_path / "cabinet.stl")
    with pytest.raises(ParameterError, match="meshes must be hull or coacd, got 'box'"):
        certify(path, meshes="box")  # type: ignore[arg-type]
    with pytest.raises(ParameterError, match="seconds must be a positive number"):
        certify(path, seconds=0.0)
    with pytest.raises(ParameterError, match=r"total must be a positive number \[s\], got 'a'"):
        certify(path, total="a")  # type: ignore[arg-type]
    with pytest.raises(ParameterError, match="path = None is not allowed"):
        certify(None)  # type: ignore[arg-type]


def test_the_first_collision_decides_and_the_other_pairs_stay_open(tmp_path: Path) -> None:
    path = cabinet("urdf", tmp_path, hinge_low=FAULTS["hinge_low"], drawer_low=FAULTS["drawer_low"])
    every, first = certify(path), certify(path, first=True)
    assert every.verdict == first.verdict == "collision"
    found = [pair for pair in first.pairs if pair.verdict == "collision"]
    assert len(found) == 1 < sum(pair.verdict == "collision" for pair in every.pairs)
    left = [pair.result for pair in first.pairs if pair.verdict == "not proven"]
    assert len(left) == 2
    assert all(pair.open_fraction == 1.0 for pair in left)
    assert "  2 pairs are left open: the first collision decides, or the time was over" in str(first)
    assert "left open" not in str(every)
    sound = certify(cabinet("urdf", tmp_path), first=True)
    assert sound.verdict == "proven"
    assert sound.rechecked


def test_collisions_are_found_along_unlimited_slides(tmp_path: Path) -> None:
    box = '<geom name="{}" type="box" size=".1 .1 .1"/>'
    slide = '<joint name="slide" type="slide" axis="1 0 0"/>'
    path = tmp_path / "slide.xml"
    path.write_text(
        f"<mujoco><worldbody>{box.format('fixed')}<body name='sled' pos='1 0 0'>{slide}{box.format('moved')}"
        "</body></worldbody></mujoco>"
    )
    pair = certify(path, first=True).failures[0]
    assert pair.result.witness is not None
    assert abs(pair.result.witness.pose["slide"] + 1.0) < 0.2


def test_no_pair_is_examined_after_the_total_time(tmp_path: Path) -> None:
    judgment = certify(cabinet("urdf", tmp_path, hinge_low=FAULTS["hinge_low"]), total=1e-6)
    assert judgment.verdict == "not proven"
    assert [pair.result.open_fraction for pair in judgment.pairs] == [1.0] * 3
