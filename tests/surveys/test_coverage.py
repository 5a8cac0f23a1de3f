"""Coverage by draws: options, ranges and their parts, and the page."""

import subprocess
import sys
from pathlib import Path
from typing import Literal

import pytest
from surveys.coverage import BINS, LEAST_BINS, coverage, demanded
from surveys.pages import coverage_page

from artgen.generator import Generator, generator, one_of, shades
from artgen.materials import Material, material
from artgen.nodes.body import part
from artgen.nodes.handles import Body, Float, Solid
from artgen.nodes.primitive import box, sphere
from artgen.sampling import by, choice, count, fixed, loguniform, uniform

ROOT = Path(__file__).parents[2]


@generator
def ball(*, radius: Float = uniform(0.01, 0.02, "m")) -> Solid:
    return sphere(radius)


@generator
def block(*, side: Float = loguniform(0.01, 0.02, "m"), bevels: int = count(1, 3)) -> Solid:
    return box(side, side, side)


@generator
def thing(
    *,
    style: Literal["round", "square", "none"] = choice("round", "square", "none", weights=(3, 2, 0)),
    rare: bool = choice(False, True, weights=(0.999999, 0.000001)),
    length: Float = by(
        "style", round=uniform(0.1, 0.2), square=choice(0.3, 0.4), otherwise=uniform(1, 2), unit="m"
    ),
    model: int = count(100, 999),
    metal: Material = shades("brass", "chrome", color=0.1),
    maker: str = "nobody",
    gap: Float = fixed(0.003, "m"),
    knob: Generator = by("style", round=one_of(ball), square=one_of(ball, block), none=block),
) -> Body:
    return part(knob(), "knob", material("oak"))


def test_options_are_counted_and_missing_ones_listed() -> None:
    found = coverage(thing, 200)
    styles = found.options["style"].counts
    assert set(styles) == {"round", "square"}  # what has no weight cannot be drawn
    assert sum(styles.values()) == 200
    assert found.options["rare"].counts == {"False": 200, "True": 0}
    assert found.missing == ("rare = True",)
    assert found.faults == ("rare is never True",)
    assert set(found.options["metal"].counts) == {"brass", "chrome"}  # not the name of each shade
    assert not found.options["maker"].varies
    assert found.options["maker"].counts == {"nobody": 200}


def test_parameters_of_chosen_generators_are_counted_where_they_are_drawn() -> None:
    found = coverage(thing, 200)
    knobs = found.options["knob"].counts
    assert found.spreads["knob.ball.radius", ""].drawn == knobs["ball"] > 0
    assert sum(found.options["knob.block.bevels"].counts.values()) == knobs["block"] > 0


def test_each_case_of_a_range_has_its_own_parts() -> None:
    found = coverage(thing, 200)
    lengths = {branch: spread for (name, branch), spread in found.spreads.items() if name == "length"}
    assert set(lengths) == {"style=round", "style=otherwise"}
    spread = lengths["style=round"]
    assert spread.drawn == found.options["style"].counts["round"]
    assert (spread.low, spread.high, spread.unit) == (0.1, 0.2, "m")
    assert 0.1 <= spread.least < 0.11
    assert 0.19 < spread.most <= 0.2
    assert spread.hit == BINS
    assert found.options["length"].counts == {
        "0.3": pytest.approx(40, abs=20),
        "0.4": pytest.approx(40, abs=20),
    }
    assert lengths["style=otherwise"].drawn == 0
    assert lengths["style=otherwise"].filled  # it was never asked for


def test_many_whole_numbers_are_a_range() -> None:
    spread = coverage(thing, 200).spreads["model", ""]
    assert (spread.low, spread.high, spread.hit) == (100, 999, BINS)


def test_a_range_that_is_not_filled_is_listed() -> None:
    @generator
    def crowded(*, width: Float = loguniform(0.001, 1000.0, "m")) -> Body:
        return part(box(width, 1, 1), "block", material("oak"))

    found = coverage(crowded, 60)
    assert found.unfilled
    assert "width: " in found.unfilled[0]
    assert "of 10 parts of 0.001 to 1000 in 60 draws" in found.unfilled[0]
    assert found.faults == found.unfilled


def test_few_draws_have_to_reach_fewer_parts() -> None:
    assert [demanded(0), demanded(1)] == [0, 1]
    assert demanded(500) == demanded(5000) == LEAST_BINS
    asked = [demanded(drawn) for drawn in range(80)]
    assert asked == sorted(asked)
    assert all(least <= drawn for drawn, least in enumerate(asked))
    assert 5 <= demanded(20) <= 7


def test_the_page_has_a_row_for_each_varying_parameter() -> None:
    found = coverage(thing, 50)
    page = coverage_page([found])
    assert "## thing" in page
    assert "- Options that never occur: `rare = True`" in page
    assert f"| `style` | round {found.options['style'].counts['round']}, square " in page
    assert "| `length` | style=round | 0.1 to 0.2 m | " in page
    assert "| `length` | style=otherwise | 1 to 2 m | 0 | nothing | 0 of 10 |" in page
    assert "`maker`" not in page
    assert "`gap`" not in page


@pytest.mark.long
def test_the_script_writes_the_page(tmp_path) -> None:
    out = tmp_path / "coverage.md"
    done = subprocess.run(
        [sys.executable, ROOT / "scripts" / "coverage_table.py", "--seeds", "40", "--out", out],
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )
    assert done.returncode == 1  # 40 seeds have not everything
    assert "door: " in done.stderr
    assert "## handle" in out.read_text()
