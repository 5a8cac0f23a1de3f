"""`artgen check`: proof, validation and a picture of one asset, while an author writes its category."""

import pytest
from PIL import Image

from artgen.commands import checks
from artgen.generator import CATEGORIES
from support.exports import stand


@pytest.fixture
def check(artgen_command, monkeypatch):
    """Run `artgen check stand`; returns the result, with the lines that it printed."""
    monkeypatch.setitem(CATEGORIES, "stand", stand)
    monkeypatch.setattr(checks, "_PIXELS", 16)

    def run(*arguments):
        done = artgen_command("check", "stand", *arguments)
        return done, [" ".join(line.split()) for line in done.out.splitlines()]

    return run


def test_a_good_draft_has_a_table_and_a_picture_closed_and_open(check, tmp_path):
    done, lines = check("--seed", "2")
    assert (done.code, done.err) == (0, "")
    assert lines[:2] == ["stand_2, seed 2", "check result detail"]
    states = {line.split()[0]: line.split()[1] for line in lines[2:13]}
    assert (states["certificate"], states["tree"], states["behavior"]) == ("passed", "passed", "passed")
    assert lines[-1] == "picture: stand_2_check.png"
    with Image.open(tmp_path / "stand_2_check.png") as picture:
        assert picture.size == (32, 16)
    assert [path.name for path in tmp_path.iterdir()] == ["stand_2_check.png"]


def test_a_collision_is_the_first_line_and_in_the_picture(check, tmp_path):
    (tmp_path / "out").mkdir()
    done, lines = check("--set", "gap=-0.005", "--out", "out")
    assert (done.code, done.err) == (1, "")
    assert lines[0].startswith("body and drawer collide at slide=")
    assert any(line.startswith("fault certificate: link body, drawer: they collide") for line in lines)
    assert "behavior skipped not simulated, because its links are not proven apart" in lines
    with Image.open(tmp_path / "out/stand_0_check.png") as picture:
        assert picture.size == (48, 16)


DRAWS = """
import random
import artgen as ag


@ag.category(labels=("seat",))
def stool(width: ag.Float = ag.uniform(0.3, 0.4)):
    return ag.part(ag.box(width, 0.3, random.uniform(0.2, 0.4)), "seat", ag.material("oak"))
"""


@pytest.mark.parametrize("source", ["random.uniform", "np.random.uniform", "SIZE * random.uniform"])
def test_a_draw_outside_of_the_signature_is_a_fault_with_its_line(
    source, artgen_command, monkeypatch, tmp_path
):
    monkeypatch.setattr(checks, "_PIXELS", 16)
    text = DRAWS.replace("random.uniform", source).replace(
        "import random", "import random\nimport numpy as np"
    )
    (tmp_path / "stool.py").write_text(text + "\n\nSIZE = 1.0\n")
    done = artgen_command("check", str(tmp_path / "stool.py"))
    assert done.code == 1
    assert f"box at {tmp_path / 'stool.py'}:9 differs: z was 0." in done.out
    assert "draw numbers in the signature, such as width: Float = uniform(0.1, 0.2)" in done.out


def test_a_draw_at_import_is_a_fault(artgen_command, monkeypatch, tmp_path):
    monkeypatch.setattr(checks, "_PIXELS", 16)
    text = DRAWS.replace("random.uniform(0.2, 0.4)", "HIGH").replace(
        "\n\n@", "\n\nHIGH = random.uniform(0.2, 0.4)\n\n@"
    )
    (tmp_path / "stool.py").write_text(text)
    done = artgen_command("check", str(tmp_path / "stool.py"))
    assert (done.code, "the same seed gives another asset" in done.out) == (1, True)


def test_a_time_limit_ends_the_proof(check):
    done, lines = check("--seconds", "1e-9")
    assert done.code == 1
    assert lines[0].startswith(
        "body and drawer: not proven after 1e-09 s: body and drawer, with slide in 0..0.2"
    )
    assert any(
        "not proven after 1e-09 s, such as slide in 0..0.2, for body and drawer" in line for line in lines
    )
