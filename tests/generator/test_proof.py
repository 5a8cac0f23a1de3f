"""Generation proves its samples: what is redrawn, refused, kept or let through unproven."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from time import sleep

import pytest

from artgen.asset import Asset
from artgen.asset.certificate import Certificate, PairResult, Witness
from artgen.errors import AssetError, BuildError, CheckError, InfeasibleError, ParameterError
from artgen.generator import generator
from artgen.materials import material
from artgen.nodes.body import part
from artgen.nodes.handles import Body, Float
from artgen.nodes.joint import Prismatic, Revolute
from artgen.nodes.primitive import box
from artgen.nodes.scalar import require
from artgen.nodes.vector import X, Y
from artgen.proof import certify as proof
from artgen.sampling import choice, uniform

OAK = material("oak")
REST = {"slide": 0.0}
HIT = Witness({"slide": 0.25}, {"slide": 0.125}, 0.003, 1e-6, (0.0, 0.0, 0.5), ("drawer", "box"))


@generator
def chest(*, gap: Float = uniform(-0.01, 0.01, "m", within=(-0.1, 0.1))) -> Body:
    """A block between two walls, which it overlaps where the gap is negative."""
    wall = box(0.01, 0.2, 0.1)
    walls = wall.at(0.055 + gap) | wall.at(-0.055 - gap)
    drawer = part(box(0.1, 0.2, 0.1), "drawer", OAK)
    return part(walls, "box", OAK).attach(drawer, Prismatic("slide", axis=-Y, limits=(0.0, 0.1)))


def certificate(asset, tolerance):
    """Tell of a chest what is known of it without any search."""
    if len(asset.links) < 2:
        return Certificate(tolerance, ())
    gap = asset.parameters["gap"]
    if gap > tolerance:
        pair = PairResult(("box", "drawer"), ("slide",), "proven", "proven", guaranteed=gap)
    else:
        pair = PairResult(("box", "drawer"), ("slide",), "collision", "collision", witness=HIT)
    return Certificate(tolerance, (pair,))


@pytest.fixture
def searches(monkeypatch):
    """Put the known answer in the place of the search; returns the assets and tolerances it was asked for."""
    asked = []

    def certify(asset, tolerance=0.0, *, measure=False):
        asked.append((asset, tolerance))
        return certificate(asset, tolerance)

    monkeypatch.setattr(Asset, "certify", certify, raising=False)
    return asked


def first_attempts(sign):
    """Return the seeds whose first draw has a gap of that sign."""
    return [seed for seed in range(20) if sign * chest.sample(seed)["gap"] > 0]


def test_a_proven_sample_is_certified_once_and_kept(searches):
    seed = first_attempts(+1)[0]
    asset = chest.generate(seed, tolerance=1e-6)
    assert searches == [(asset, 1e-6)]
    assert asset.attempt == 0


def test_a_colliding_sample_is_drawn_again(searches):
    seed = first_attempts(-1)[0]
    asset = chest.generate(seed)
    assert asset.parameters["gap"] > 0.0
    assert asset.attempt == len(searches) - 1 > 0
    draws = [chest.sample(seed, attempt=attempt)["gap"] for attempt in range(asset.attempt + 1)]
    assert [asked.parameters["gap"] for asked, _ in searches] == draws
    assert all(gap < 0.0 for gap in draws[:-1])


def test_samples_that_all_collide_are_one_error_with_the_witness(searches):
    with pytest.raises(InfeasibleError) as caught:
        chest.generate(0, attempts=5, gap=uniform(-0.01, -0.005))
    message = str(caught.value)
    assert message.startswith(
        "chest: none of 5 draws for seed 0 is feasible; the last: not proven: 1 of 1 pair fails\n"
        "  box and drawer collide at slide=0.25: drawer presses 3.000 mm into box at (0.000, 0.000, 0.500) m"
    )
    assert len(searches) == 5


def test_draws_that_all_fail_alike_are_five(searches):
    with pytest.raises(InfeasibleError) as caught:
        chest.generate(0, gap=uniform(-0.01, -0.005))
    message = str(caught.value)
    assert message.startswith(
        "chest: every draw fails alike (5 were tried for seed 0): not proven: 1 of 1 pair fails\n"
        "  box and drawer collide at slide=0.25: drawer presses 3.000 mm into box"
    )
    assert len(searches) == 5


def test_draws_that_fail_differently_go_on(searches, monkeypatch):
    fail = Asset.certify

    def certify(asset, tolerance=0.0, **options):
        found = fail(asset, tolerance)
        labels = ("drawer", "box") if asset.attempt != 3 else ("drawer", "lid")
        pairs = [replace(pair, witness=replace(HIT, labels=labels)) for pair in found.pairs]
        return replace(found, pairs=tuple(pairs))

    monkeypatch.setattr(Asset, "certify", certify)
    with pytest.raises(
        InfeasibleError, match="none of 100 draws for seed 0 is feasible; the last: not proven"
    ):
        chest.generate(0, gap=uniform(-0.01, -0.005))
    assert len(searches) == 100


def test_a_requirement_may_rule_out_more_draws_than_a_collision():
    @generator
    def never(*, gap: Float = uniform(0.0, 1.0, "m")) -> Body:
        body = part(box(0.1, 0.1, 0.1), "box", OAK)
        return body.require(gap > 2.0, "the gap is too small")

    with pytest.raises(InfeasibleError, match=r"every draw fails alike \(25 were tried .*too small"):
        never.generate(0)
    with pytest.raises(InfeasibleError, match="none of 30 draws for seed 0 is feasible"):
        never.generate(0, attempts=30)


def test_a_certificate_is_made_when_it_is_needed(monkeypatch):
    asset = chest.generate(4, gap=0.005, certify="later")
    assert "not certified" in repr(asset)
    assert "not certified yet" in str(asset)
    assert asset.certified_later
    made, prove = [], proof.certify

    def certify(asset, *arguments, **options):
        made.append(asset)
        sleep(0.05)
        return prove(asset, *arguments, **options)

    monkeypatch.setattr(proof, "certify", certify)
    with ThreadPoolExecutor(4) as threads:
        found = list(threads.map(lambda _: asset.certificate, range(4)))
    assert made == [asset]
    assert found[0].proven
    assert not asset.certified_later
    assert all(each is found[0] for each in found)
    assert chest.generate(4, gap=0.005, certify="later").to_data() == chest.generate(4, gap=0.005).to_data()


def test_a_collision_that_is_found_later_is_an_error_each_time(tmp_path):
    asset = chest.generate(4, gap=-0.001, certify="later")
    for _ in range(2):
        with pytest.raises(CheckError, match="chest_4: not proven: 1 of 1 pair fails") as caught:
            _ = asset.certificate
        assert "give the parts more clearance" in str(caught.value)
    with pytest.raises(CheckError, match="chest_4: not proven"):
        asset.export(tmp_path / "chest")
    assert not list(tmp_path.iterdir())
    assert not asset.certify().proven
    assert asset.certificate is not None
    kept = chest.generate(4, gap=-0.001, certify="later", on_collision="keep")
    assert not kept.certificate.proven


def test_the_same_sample_is_not_tried_again(searches):
    with pytest.raises(InfeasibleError, match="none of 100 draws"):
        chest.generate(0, gap=choice(-0.01, -0.005))
    assert sorted(asked.parameters["gap"] for asked, _ in searches) == [-0.01, -0.005]


def test_a_collision_may_be_a_failure(searches):
    with pytest.raises(CheckError) as caught:
        chest.generate(4, gap=-0.001, on_collision="fail")
    witness, _, remedy = str(caught.value).rpartition("\n")
    assert witness == f"chest_4: {certificate(searches[0][0], 0.0)}"
    assert "while generating chest from seed 4, attempt 0" in caught.value.__notes__
    assert 'on_collision="keep"' in remedy
    assert "safe_limits()" in remedy


def test_a_failure_draws_an_infeasible_sample_again_all_the_same(searches):
    @generator
    def picky(*, gap: Float = uniform(-0.01, 0.01, "m")) -> Body:
        body = part(box(0.1, 0.1, 0.1), "box", OAK)
        body = body.attach(part(box(0.1, 0.1, 0.1).at(1.0), "drawer", OAK), Prismatic("slide", axis=Y))
        return require(body, gap > 0.0, "the gap must be positive")

    for seed in range(5):
        assert picky.generate(seed, on_collision="fail").parameters["gap"] > 0.0
    assert len(searches) == 5


def test_a_colliding_sample_may_be_kept(searches):
    asset = chest.generate(4, gap=-0.001, on_collision="keep")
    assert (asset.attempt, asset.parameters["gap"]) == (0, -0.001)
    assert len(searches) == 1


def test_the_proof_may_be_left_out(searches):
    asset = chest.generate(4, gap=-0.001, certify=False)
    assert asset.parameters["gap"] == -0.001
    assert not searches


def test_the_tolerance_decides(searches):
    assert chest.generate(0, gap=0.002, tolerance=0.001, on_collision="fail")
    with pytest.raises(CheckError):
        chest.generate(0, gap=0.002, tolerance=0.003, on_collision="fail")


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"certify": 1}, "certify = 1 is not allowed: it must be True, False or 'later'"),
        (
            {"tolerance": -0.001},
            "tolerance = -0.001 is not allowed: it is the clearance to prove, a number of",
        ),
        ({"tolerance": float("nan")}, "tolerance = nan is not allowed"),
        ({"tolerance": float("inf")}, "tolerance = inf is not allowed"),
        ({"tolerance": "1 mm"}, "tolerance = '1 mm' is not allowed"),
        ({"tolerance": True}, "tolerance = True is not allowed"),
        (
            {"on_collision": "ignore"},
            "on_collision = 'ignore' is not allowed: it must be one of 'redraw', 'fail', 'keep'",
        ),
        ({"on_collision": ["keep"]}, "on_collision = ['keep'] is not allowed"),
    ],
)
def test_other_options_are_refused_before_anything_is_drawn(wrong, message, searches):
    for ask in (chest.generate, chest.evaluate):
        with pytest.raises(ParameterError) as caught:
            ask(0, **wrong)
        assert message in str(caught.value)
    assert not searches


@pytest.mark.parametrize("name", ["certify", "tolerance", "on_collision"])
def test_options_are_no_names_of_parameters(name):
    namespace = {"Float": Float, "Body": Body, "uniform": uniform}
    exec(f"def shelf(*, {name}: Float = uniform(0.0, 1.0)) -> Body: ...", namespace)  # noqa: S102 - its own text
    with pytest.raises(BuildError, match=f"'{name}' is reserved for generate"):
        generator(namespace["shelf"])


proves = pytest.mark.skipif(not hasattr(Asset, "certify"), reason="nothing proves assets yet")


@proves
def test_generation_proves_by_default():
    for seed in range(3):
        asset = chest.generate(seed)
        assert asset.parameters["gap"] > 0.0
        assert asset.certificate.proven
        assert asset.certificate.clearance.guaranteed <= asset.parameters["gap"]
    assert chest.generate(0, certify=False).certificate is None
    kept = chest.generate(0, gap=-0.001, on_collision="keep")
    assert [pair.verdict for pair in kept.certificate.pairs] == ["collision"]
    with pytest.raises(CheckError, match="box and drawer collide at"):
        chest.generate(0, gap=-0.001, on_collision="fail")


@proves
def test_what_does_not_move_is_proven():
    @generator
    def brick(*, width: Float = uniform(0.1, 0.2, "m")) -> Body:
        return part(box(width, 0.1, 0.1), "brick", OAK)

    assert brick.generate(0, on_collision="fail").certificate.proven


def test_a_joint_that_could_never_move_is_refused_with_the_authors_line():
    @generator
    def oven() -> Body:
        door = part(box(0.5, 0.02, 0.4).at(0, -0.3), "door", OAK)
        rack = part(box(0.1, 0.1, 0.1).at(0, 0.5), "rack", OAK)
        hinge = Revolute("hinge", axis=X, pivot=(0, -0.3, -0.2), limits=(0, 1.5))
        slide = Prismatic("slide", axis=Y, limits=(0, 0.2), needs=hinge > 2.0)
        return part(box(0.5, 0.4, 0.4), "body", OAK).attach(door, hinge).attach(rack, slide)

    line = oven.function.__code__.co_firstlineno + 5
    with pytest.raises(AssetError) as caught:
        oven.generate(0)
    text = str(caught.value)
    assert text.startswith("joint 'slide' needs hinge > 2, but hinge ranges from 0 to 1.5: it could never")
    assert text.endswith(f"test_proof.py:{line}")
