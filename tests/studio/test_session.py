"""The studio without a browser: what is set, what is shown, what joints do, and what is told."""

import ast
import shutil
import time
from pathlib import Path

import numpy as np
import pytest

import artgen
from artgen.catalog import load_file
from artgen.errors import ExportError, ParameterError
from artgen.studio import Session
from artgen.studio.app import Prover
from artgen.studio.controls import StudioControl
from artgen.studio.stage import placed

CRATE = Path(__file__).parent.parent / "support" / "crate.py"


@pytest.fixture
def session() -> Session:
    made = Session(str(CRATE), seed=1)
    assert made.evaluate(), made.error
    return made


@pytest.fixture
def edited(tmp_path: Path) -> Session:
    """A session of a file that a test may edit."""
    made = Session(str(shutil.copy(CRATE, tmp_path / "mine.py")), seed=1)
    assert made.evaluate(), made.error
    return made


def control(session: Session, short: str) -> StudioControl:
    return next(found for found in session.controls() if found.short == short)


def edit(session: Session, old: str, new: str) -> None:
    text = session.path.read_text()
    assert old in text
    session.path.write_text(text.replace(old, new))


def test_each_parameter_has_the_control_of_its_kind(session: Session) -> None:
    width, wall, finish = (control(session, name) for name in ("width", "wall", "finish"))
    assert (width.kind, width.low, width.high, width.unit) == ("slider", 0.2, 0.6, "m")
    assert width.hint == "uniform(0.3, 0.4) m; allowed: 0.2 to 0.6"
    assert width.step == 0.001
    assert (wall.kind, wall.value) == ("number", 0.3)
    assert wall.hint.startswith("how far the wall behind the crate is away")
    assert (finish.kind, finish.options) == ("menu", ("plain", "raised"))
    assert control(session, "handle").options == ("knob", "bar")


def test_the_largest_category_has_a_control_for_every_parameter() -> None:
    found = Session("door", seed=3)
    assert found.evaluate()
    controls = found.controls()
    assert [each.short for each in controls if each.name.count(".") == 0] == list(found.generator.own)
    assert {each.short for each in controls} == set(found.asset.parameters)
    assert {each.kind for each in controls} == {"menu", "slider", "checkbox"}
    assert next(each for each in controls if each.short == "finish").value == found.asset.parameters["finish"]


def test_a_choice_brings_the_parameters_of_what_is_chosen(session: Session) -> None:
    session.set("handle", "bar")
    session.set("handle.bar.length", 0.08)
    assert session.evaluate()
    assert control(session, "handle.length").name == "handle.bar.length"
    session.set("handle", "knob")
    assert session.evaluate(), session.error
    assert control(session, "handle.across").value == session.asset.parameters["handle.across"]
    assert "handle.length" not in session.asset.parameters
    session.set("handle", "bar")  # what was set of it waited
    assert session.evaluate()
    assert session.asset.parameters["handle.length"] == 0.08


def test_what_is_set_shifts_nothing_else_and_reset_lets_it_go(session: Session) -> None:
    drawn = dict(session.asset.parameters)
    session.set("width", 0.45)
    assert session.evaluate()
    assert dict(session.asset.parameters) == {**drawn, "width": 0.45}
    assert session.is_set(control(session, "width"))
    session.resample(2)
    assert session.evaluate()
    assert session.asset.parameters["width"] == 0.45
    assert session.asset.parameters["swing"] != drawn["swing"]
    session.resample(1)
    session.reset()
    assert session.evaluate()
    assert dict(session.asset.parameters) == drawn


@pytest.mark.parametrize(
    ("width", "reason"),
    [(0.57, "no lid is that wide"), (0.7, "width = 0.7 is out of range: 0.2 to 0.6 m is allowed")],
)
def test_a_value_that_cannot_be_leaves_the_last_asset(session: Session, width: float, reason: str) -> None:
    before = session.asset
    session.set("width", width)
    assert not session.evaluate()
    assert session.error.startswith(reason)
    assert session.asset is before
    assert "width" not in session.python()
    session.set("width", 0.35)
    assert session.evaluate()
    assert not session.error


def test_a_kernel_that_fails_is_told_with_the_authors_line(session: Session) -> None:
    session.set("handle", "bar")
    session.set("handle.bar.length", -0.1)
    assert not session.evaluate()
    line = 1 + CRATE.read_text().splitlines().index(
        '    return part(box(length, 0.02, 0.03), "handle", material("steel"))'
    )
    assert f"crate.py:{line}" in session.error
    assert session.asset is not None


def test_unknown_overrides_are_refused_at_once() -> None:
    with pytest.raises(ParameterError, match="Did you mean 'width'"):
        Session(str(CRATE), seed=1, overrides={"widht": 0.4})


def test_a_dependency_holds_a_joint_until_it_is_met(session: Session) -> None:
    assert session.move("lid_hinge", 0.8) == 0.0
    assert session.blocked == "lid_hinge is blocked: it needs bolt_slide > 0.03"
    session.move("bolt_slide", 0.04)
    assert session.blocked == ""
    assert session.move("lid_hinge", 0.8) == 0.8
    assert session.asset.positions(session.q)["flag_slide"] == pytest.approx(0.016)
    # the bolt goes no farther back than the open lid lets it
    assert session.move("bolt_slide", 0.0) == pytest.approx(0.03, abs=1e-6)
    assert session.blocked == "bolt_slide is blocked: lid_hinge needs bolt_slide > 0.03"
    assert not session.asset.blocked(session.q)


def test_joints_stay_where_they_are_when_a_parameter_changes(session: Session) -> None:
    session.move("bolt_slide", 0.04)
    session.move("lid_hinge", 5.0)
    assert session.q["lid_hinge"] == session.asset.joint("lid_hinge").limits[1]
    session.set("swing", 0.6)
    assert session.evaluate()
    assert session.q["lid_hinge"] == 0.6
    lid = next(joint for joint in session.joints() if joint.name == "lid_hinge")
    assert (lid.value, lid.high, lid.unit) == (0.6, 0.6, "rad")
    assert "needs bolt_slide > 0.03" in lid.hint
    assert next(joint for joint in session.joints() if joint.name == "flag_slide").follows


def test_a_joints_limit_changes_the_looks_of_no_link(session: Session) -> None:
    before = {link.name: placed(link) for link in session.asset.links}
    session.set("swing", 1.5)
    assert session.evaluate()
    for link in session.asset.links:
        assert placed(link).key == before[link.name].key
    session.set("width", control(session, "width").value + 0.01)
    assert session.evaluate()
    changed = {link.name: placed(link) for link in session.asset.links}
    assert changed["crate"].key != before["crate"].key
    # bolt and flag are only carried along
    for name in ("bolt", "flag"):
        assert changed[name].key == before[name].key
        shift = np.abs(changed[name].offset - before[name].offset)
        assert shift == pytest.approx([0.005, 0.0, 0.0])
        moved = changed[name].link.bounds() + changed[name].offset
        assert moved == pytest.approx(session.asset.link(name).bounds())


def test_the_certificate_is_made_elsewhere_and_names_the_worst_pose(session: Session) -> None:
    prover = Prover()
    session.set("swing", 2.0)
    session.set("wall", 0.05)
    assert session.evaluate()
    try:
        prover.start(session.task())
        end = time.monotonic() + 60.0
        while (ending := prover.poll()) is None:
            assert time.monotonic() < end, "no certificate within a minute"
            time.sleep(0.02)
        assert ending.state == "done", ending.message
        session.certified(ending.value)
        assert not session.asset.certificate.proven
        worst = session.collisions[0]
        assert set(worst.links) == {"crate", "lid"}
        session.pose(worst.witness.pose)
        assert session.q["lid_hinge"] > 1.0
        assert 'on_collision="keep"' in session.python()
        # one that was begun is given up when it is outdated
        prover.start(session.task())
        prover.cancel()
        assert prover.poll() is None
    finally:
        prover.close()


def test_what_is_copied_makes_the_same_asset(session: Session) -> None:
    session.set("handle", "bar")
    session.set("handle.bar.length", 0.09)
    assert session.evaluate()
    text = session.python()
    ast.parse(text)
    assert text.splitlines()[-1] == (
        f"asset = catalog.load_file({str(CRATE)!r}).generate("
        "seed=1, handle='bar', handle__length=0.09, certify=False)"
    )
    again = load_file(CRATE).generate(seed=1, handle="bar", handle__length=0.09, certify=False)
    assert dict(again.parameters) == dict(session.asset.parameters)
    named = Session("drawer", seed=2, overrides={"width": artgen.uniform(0.5, 0.6)})
    assert named.evaluate()
    width = named.asset.parameters["width"]
    assert named.python().splitlines()[-1] == (
        f'asset = artgen.generate("drawer", seed=2, width={width!r}, certify=False)'
    )


def test_a_saved_file_is_loaded_again_and_keeps_what_is_set(edited: Session) -> None:
    edited.set("width", 0.25)
    assert not edited.saved()
    edit(edited, '"m", within=(0.2, 0.6))', '"m", within=(0.2, 0.5))')
    assert edited.saved()
    assert not edited.saved()
    assert edited.reload()
    assert edited.evaluate()
    assert control(edited, "width").high == 0.5
    assert edited.asset.parameters["width"] == 0.25
    edit(edited, "swing: Float", "turn: Float")
    edit(edited, "limits=(0, swing)", "limits=(0, turn)")
    edited.set("swing", 1.1)
    assert edited.reload()
    assert edited.evaluate(), edited.error
    assert edited.overrides == {"width": 0.25}


@pytest.mark.parametrize(
    ("old", "new", "reason"),
    [
        ("plate = box(width", "plate = = box(width", "invalid syntax"),
        ("def crate(", "def crate((", "was never closed"),
        ("plate = box(width, 0.29", "plate = bax(width, 0.29", "bax"),
        ("swing: Float = uniform(1.0, 1.2", "swing: Float = uniform(1.3, 1.2", "low exceeds high"),
    ],
)
def test_a_fault_in_the_file_is_told_with_its_line(edited: Session, old: str, new: str, reason: str) -> None:
    before = edited.asset
    text = edited.path.read_text()
    number = 1 + next(index for index, each in enumerate(text.splitlines()) if old in each)
    edit(edited, old, new)
    assert not (edited.reload() and edited.evaluate())
    assert reason in edited.error
    assert f"mine.py:{number}" in edited.error
    assert edited.asset is before
    edit(edited, new, old)
    assert edited.reload()
    assert edited.evaluate()
    assert edited.error == ""


def test_an_asset_is_exported_as_it_is_shown(session: Session, tmp_path: Path) -> None:
    session.set("width", 0.33)
    assert session.evaluate()
    folder = session.export(tmp_path / "crate", ("urdf", "glb"))
    assert {path.suffix for path in folder.iterdir() if path.is_file()} == {".urdf", ".glb", ".json"}
    assert artgen.Asset.load(folder).parameters["width"] == 0.33
    with pytest.raises(ParameterError, match="no format is selected"):
        session.export(tmp_path / "crate", ())
    with pytest.raises(ParameterError, match="no folder is given"):
        session.export(" ", ("urdf",))
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / "mine.txt").write_text("keep")
    with pytest.raises(ExportError, match="other"):
        session.export(tmp_path / "other", ("urdf",))
