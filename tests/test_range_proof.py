"""Range proofs: what is counted, what attains the smallest clearance, and what the command prints."""

import json
import math

import pytest

from artgen import range_proof
from artgen.asset import Asset
from artgen.asset.certificate import Certificate, OpenCell, PairResult
from artgen.cli import main
from artgen.errors import InfeasibleError, ParameterError
from artgen.generator import CATEGORIES, generator
from artgen.nodes.body import part
from artgen.nodes.handles import Body, Float
from artgen.nodes.primitive import box
from artgen.range_proof import RangeProof, prove_range
from artgen.sampling import uniform
from support.generators import OAK, chest

# the first samples of seed 80 are clear of the low end
REACHES = {"gap": uniform(-0.0002, 0.004)}


def test_a_sound_range_is_proven_throughout():
    proof = prove_range(chest, 10)
    assert proof.sound
    assert proof.fraction == 1.0
    assert (proof.tried, proof.samples, proof.corners, proof.feasible) == (14, 10, 4, 14)
    assert proof.counts == {"proven": 14, "collision": 0, "not proven": 0, "error": 0, "infeasible": 0}
    assert proof.failures == ()


def test_the_smallest_clearance_is_found_with_what_attains_it():
    least = prove_range(chest, 10).clearance
    assert least.guaranteed <= 0.001 + 1e-9
    assert least.found >= 0.001 - 1e-9
    assert 0.00075 < least.bound <= least.guaranteed
    assert least.found - least.guaranteed < 0.00025
    assert set(least.links) == {"box", "drawer"}
    assert least.origin.startswith("corner ")
    assert least.parameters["gap"] == 0.001
    assert set(least.parameters) == {"gap", "depth", "least", "stroke", "place"}
    asset = chest.generate(0, certify=False, **least.parameters)
    assert asset.positions(least.positions) == dict(least.positions)
    without = prove_range(chest, 10, corners=False)
    smallest = min((chest.sample(seed)["gap"], seed) for seed in range(10))
    assert without.clearance.origin == f"seed {smallest[1]}"
    assert without.clearance.parameters["gap"] == smallest[0]
    assert (without.tried, without.corners) == (10, 0)


def test_a_collision_at_the_corner_is_found_where_samples_miss_it():
    assert prove_range(chest, 10, seed=80, corners=False, overrides=REACHES).sound
    proof = prove_range(chest, 10, seed=80, overrides=REACHES)
    assert not proof.sound
    assert proof.counts["collision"] == 2
    assert proof.fraction == 12 / 14
    for failure in proof.failures:
        assert failure.outcome == "collision"
        assert failure.parameters["gap"] == -0.0002
        assert "box and drawer collide at slide=" in failure.message
    assert {failure.parameters["depth"] for failure in proof.failures} == {0.2, 0.3}
    assert proof.clearance.guaranteed > 0.0


def test_the_parameters_of_a_failure_make_it_again():
    failure = prove_range(chest, 0, overrides=REACHES).failures[0]
    asset = chest.generate(0, certify=False, **failure.parameters)
    assert asset.parameters == failure.parameters
    assert not asset.certify().proven


def test_the_tolerance_has_to_be_proven():
    assert not prove_range(chest, 0, tolerance=0.0011).sound
    assert prove_range(chest, 0, tolerance=0.0009).sound


def test_what_a_requirement_rules_out_is_no_failure():
    proof = prove_range(chest, 5, overrides={"least": 0.25})
    assert proof.counts["infeasible"] == 2  # the corners with a depth of 0.2 m
    assert proof.counts["proven"] == 7
    assert proof.sound
    assert proof.feasible == 7
    assert "; 2 infeasible" in str(proof)


def test_samples_are_the_first_feasible_draws_of_their_seeds():
    proof = prove_range(chest, 6, seed=3, overrides={"least": 0.28}, corners=False)
    made = [chest.generate(seed, least=0.28, certify=False) for seed in range(3, 9)]
    assert any(asset.attempt for asset in made)
    assert proof.clearance.parameters["gap"] == min(asset.parameters["gap"] for asset in made)


@pytest.mark.parametrize(
    ("given", "draws"),
    [
        ({"samples": 500}, 1000),
        ({"samples": 2}, 204),
        ({"samples": 0}, 4),
        ({"samples": 1, "corners": False}, 100),
    ],
)
def test_a_category_that_is_never_feasible_is_one_error(given, draws):
    with pytest.raises(InfeasibleError) as caught:
        prove_range(chest, **given, overrides={"least": 0.5})
    message = str(caught.value)
    assert message.startswith(f"chest: none of the first {draws} draws is feasible; the last: ")
    assert "the drawer is too short" in message


def test_a_corner_that_cannot_be_made_is_a_failure():
    proof = prove_range(chest, 3, overrides={"stroke": uniform(-0.001, 0.1)})
    assert proof.counts["error"] == 4
    failure = proof.failures[0]
    assert failure.outcome == "error"
    assert "sqrt" in failure.message
    assert failure.parameters["stroke"] == -0.001
    assert not proof.sound


def test_only_the_first_failures_are_described():
    proof = prove_range(chest, 20, overrides={"gap": uniform(-0.02, 0.004)})
    assert len(proof.failures) == 10
    assert str(proof).endswith(f"\nand {proof.counts['collision'] - 10} more that are not proven")
    assert proof.counts["collision"] > 10


def test_samples_that_all_fail_alike_end_the_proof():
    told = []
    proof = prove_range(chest, 500, overrides={"gap": uniform(-0.01, -0.001)}, failed=told.append)
    assert (proof.samples, proof.corners, proof.counts["collision"]) == (5, 0, 5)
    assert proof.fraction == 0.0
    assert proof.clearance is None
    assert str(proof).endswith("\nstopped early: the first 5 of 504 all fail alike")
    assert tuple(told) == proof.failures


def test_the_first_failure_may_end_the_proof():
    proof = prove_range(chest, 2, overrides=REACHES, seed=80, fail_fast=True)
    assert (proof.samples, proof.corners, proof.stopped) == (2, 1, "corner 0 fails")
    assert proof.to_data()["stopped"] == "corner 0 fails"


def test_a_time_limit_of_a_sample_names_the_pieces_and_goes_on():
    proof = prove_range(chest, 3, seconds=1e-9, corners=False)
    assert proof.counts["not proven"] == 3
    message = "box and drawer: not proven after 1e-09 s: box and drawer, with slide in 0..0.1"
    assert proof.failures[0].message == message


def known(guaranteed, found, verdict="proven", slack=0.01):
    """Return a search that knows the clearances by the gap; it measures them with some slack."""

    def certify(asset, tolerance=0.0, *, measure=False, seconds=math.inf):
        gap = round(1e3 * asset.parameters["gap"])
        cells = (OpenCell({"slide": (0.0, 0.1)}, ("box", "drawer"), 0.001),)
        certify.measured += [gap] if measure else []
        pair = PairResult(
            ("box", "drawer"),
            ("slide",),
            verdict,
            verdict,
            guaranteed=(found[gap] - slack if measure else guaranteed[gap]) if verdict == "proven" else None,
            found=found[gap] if measure else None,
            found_at={"slide": 0.1} if measure else {},
            open_cells=cells if verdict != "proven" else (),
            open_fraction=1.0,
        )
        return Certificate(tolerance, (pair,))

    certify.measured = []
    return certify


def test_the_smallest_clearance_is_not_the_loosest_bound(monkeypatch):
    # with a gap of 1 mm little is guaranteed before the measurement, but with 2 mm they come closer
    certify = known(guaranteed={1: 0.1, 2: 0.2, 3: 0.6, 4: 0.9}, found={1: 2.0, 2: 0.5, 3: 5.0, 4: 5.0})
    monkeypatch.setattr(Asset, "certify", certify)
    values = [{"gap": uniform(0.001, 0.002), "depth": 0.2}, {"gap": uniform(0.003, 0.004), "depth": 0.2}]
    least = prove_range(chest, 0, overrides=values[0]).clearance
    assert certify.measured == [1, 2]
    assert (least.parameters["gap"], least.found) == (0.002, 0.5)
    assert least.guaranteed == pytest.approx(0.49)
    assert least.positions == {"slide": 0.1}


def test_what_is_guaranteed_holds_for_all_that_are_proven(monkeypatch):
    certify = known(guaranteed={1: 0.1, 2: 0.2}, found={1: 2.0, 2: 0.5}, slack=1.75)
    monkeypatch.setattr(Asset, "certify", certify)
    overrides = {"gap": uniform(0.001, 0.002), "depth": 0.2}
    least = prove_range(chest, 0, overrides=overrides).clearance
    assert least.found == 0.5
    assert least.guaranteed == -1.25
    assert least.bound == 0.2  # 1 mm guarantees 0.25 when it is measured; 2 mm no more than before
    # where not all can be measured, the rest may come as close as was guaranteed before
    monkeypatch.setattr(range_proof, "_MOST_MEASURED", 1)
    least = prove_range(chest, 0, overrides=overrides).clearance
    assert (least.found, least.guaranteed, least.bound) == (2.0, 0.25, 0.2)


def test_a_bound_that_was_not_measured_counts_in_the_guarantee(monkeypatch):
    certify = known(guaranteed={1: 0.1, 2: 0.495}, found={1: 0.5, 2: 9.0})
    monkeypatch.setattr(Asset, "certify", certify)
    least = prove_range(chest, 0, overrides={"gap": uniform(0.001, 0.002), "depth": 0.2}).clearance
    assert certify.measured == [1, 2]  # 2 mm may come closer than 0.5
    assert (least.parameters["gap"], least.found) == (0.001, 0.5)
    certify = known(guaranteed={1: 0.1, 2: 0.501}, found={1: 0.5, 2: 9.0})
    monkeypatch.setattr(Asset, "certify", certify)
    least = prove_range(chest, 0, overrides={"gap": uniform(0.001, 0.002), "depth": 0.2}).clearance
    assert certify.measured == [1]  # 2 mm cannot
    assert least.guaranteed == pytest.approx(0.49)


def test_not_proven_is_counted_apart_and_is_no_success(monkeypatch):
    monkeypatch.setattr(Asset, "certify", known({}, {}, "not proven"))
    proof = prove_range(chest, 2)
    assert proof.counts["not proven"] == 5
    assert not proof.sound
    assert proof.fraction == 0.0
    assert "not proven in 100 % of their joint space" in proof.failures[0].message
    assert "5 neither collide nor are proven" in str(proof)


def test_what_does_not_move_has_no_clearance():
    @generator
    def brick(*, width: Float = uniform(0.1, 0.2, "m")) -> Body:
        return part(box(width, 0.1, 0.1), "brick", OAK)

    proof = prove_range(brick, 3)
    assert proof.sound
    assert proof.clearance is None
    assert str(proof) == "brick: 100.0 % proven, 5 of 5 (3 samples, 2 corners)"


def test_progress_is_told_after_each():
    told = []
    prove_range(chest, 3, progress=lambda done, total: told.append((done, total)))
    assert told == [(done, 7) for done in range(1, 8)]


def test_the_data_are_complete_and_the_same_again():
    overrides = REACHES | {"stroke": 0.09}
    proof = prove_range(chest, 4, seed=80, overrides=overrides, tolerance=1e-5)
    data = json.loads(json.dumps(proof.to_data()))
    assert data == prove_range(chest, 4, seed=80, overrides=overrides, tolerance=1e-5).to_data()
    assert (data["category"], data["seed"], data["samples"], data["corners"]) == ("chest", 80, 4, 4)
    assert data["overrides"] == {"gap": "uniform(-0.0002, 0.004)", "stroke": "0.09"}
    assert data["tolerance"] == 1e-5
    assert data["tried"] == 8
    assert sum(data["counts"].values()) == 8
    assert data["fraction"] == proof.fraction
    assert data["clearance"]["parameters"] == proof.clearance.parameters
    assert [failure["origin"] for failure in data["failures"]] == [each.origin for each in proof.failures]
    assert data["failures"][0]["parameters"]["gap"] == -0.0002


def test_nearly_all_is_not_told_as_all():
    counts = {"proven": 2999, "collision": 0, "not proven": 1, "error": 0, "infeasible": 0}
    proof = RangeProof("chest", 0, 0.0, {}, 3000, 0, counts, None, ())
    assert str(proof).startswith("chest: 99.9 % proven, 2999 of 3000 ")
    assert not proof.sound


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"samples": -1}, "samples must be a whole number that is not negative, got -1"),
        ({"samples": 1.5}, "samples must be a whole number that is not negative, got 1.5"),
        ({"seconds": 0}, "seconds = 0 is not allowed: it is a time limit, a number above 0"),
        ({"samples": 0, "corners": False}, "samples = 0 leaves nothing of chest to certify"),
        (
            {"samples": 0, "overrides": {"gap": 0.002, "depth": 0.2}},
            "leaves nothing of chest to certify; no number of it varies, so that there are no corners",
        ),
        ({"seed": -1}, "seed must be a whole number that is not negative, got -1"),
        ({"tolerance": -1.0}, "tolerance = -1.0 is not allowed"),
        ({"overrides": {"gapp": 1.0}}, "chest has no parameter 'gapp'. Did you mean 'gap'?"),
        ({"category": "chset"}, "there is no category 'chset'"),
        ({"corners": "no"}, "corners = 'no' is not allowed: it must be True or False"),
        ({"fail_fast": 1}, "fail_fast = 1 is not allowed: it must be True or False"),
        ({"category": 3}, "prove_range takes the name of a category or a generator, got 3"),
    ],
)
def test_wrong_input_is_refused(given, message):
    with pytest.raises(ParameterError) as caught:
        prove_range(**({"category": chest} | given))
    assert message in str(caught.value)


@pytest.fixture
def command(capsys, tmp_path, monkeypatch):
    """Run `artgen certify chest` in an empty directory; returns the exit code, stdout and stderr."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setitem(CATEGORIES, "chest", chest)

    def run(*arguments):
        with pytest.raises(SystemExit) as ended:
            main(["certify", *arguments])
        printed = capsys.readouterr()
        return int(ended.value.code or 0), printed.out, printed.err

    return run


def test_the_command_prints_the_fraction_the_clearance_and_what_attains_it(command, tmp_path):
    code, out, err = command("chest", "--samples", "4", "--corners", "--seed", "3", "--json", "proof.json")
    assert (code, err) == (0, "")
    lines = out.splitlines()
    assert lines[0] == "chest: 100.0 % proven, 8 of 8 (4 samples, 4 corners)"
    assert lines[1].startswith("smallest clearance: ")
    assert " mm, box and drawer of corner " in lines[1]
    assert " at slide=" in lines[1]
    assert "; all keep 0.99" in lines[1] or "; all keep 1.000 mm" in lines[1]
    assert "gap=0.001, depth=" in lines[2]
    data = json.loads((tmp_path / "proof.json").read_text())
    assert data == prove_range(chest, 4, seed=3).to_data()


def test_the_command_fails_where_a_sample_does(command):
    code, out, err = command(
        *("chest", "--samples", "2", "--corners"), *("--set", "gap=uniform(-0.0002, 0.004)", "--seed", "80")
    )
    assert code == 1
    assert err.startswith("first failure: corner 0: box and drawer collide at slide=")
    assert err.count("\n") == 1
    assert out.startswith("chest: 66.7 % proven, 4 of 6 (2 samples, 4 corners); 2 collide\n")
    assert "\ncorner 0: box and drawer collide at slide=" in out
    code, out, _ = command(
        *("chest", "--samples", "2", "--set", "gap=uniform(-0.0002, 0.004)", "--seed", "80")
    )
    assert (code, out.count("\n")) == (0, 3)
    code, _, _ = command("chest", "--samples", "0", "--tolerance", "0.0011")
    assert code == 1


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["chset"], "there is no category 'chset'"),
        (["chest", "--samples", "-1"], "samples must be a whole number"),
        (["chest", "--samples", "few"], "'--samples'"),
        (["chest", "--tolerance", "-1"], "tolerance = -1.0 is not allowed"),
        (["chest", "--set", "gapp=1"], "chest has no parameter 'gapp'"),
        (["chest", "--set", "gap"], "'gap' is no override"),
        (["chest", "--set", "least=0.5"], "none of the first 1000 draws is feasible"),
        (
            ["chest", "--json", "nowhere/proof.json"],
            "cannot write nowhere/proof.json: give a file in a directory",
        ),
        (["chest", "--json", "."], "cannot write .: give a file in a directory that exists"),
        ([], "Missing argument"),
    ],
)
def test_wrong_input_of_the_command_is_one_line(command, arguments, message, tmp_path):
    code, out, err = command(*arguments)
    assert (code, out) == (2, "")
    assert err.startswith("error: ")
    assert err.count("\n") == 1
    assert message in err
    assert not list(tmp_path.iterdir())
