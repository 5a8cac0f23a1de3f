"""Closed chains: the joints that a pin determines follow the input along one branch."""

import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from artgen.errors import AssetError, EvaluationError
from artgen.graph import Graph
from artgen.nodes.handles import Float
from artgen.nodes.joint import Prismatic, Revolute
from artgen.nodes.vector import X, Y, Z
from support.linkages import PLACES, bar, four_bar, gap, made, slider_crank, turn

PARALLEL = ((0.0, 0.0), (0.0, 0.05), (0.12, 0.05), (0.12, 0.0))
FLAT = ((0.0, 0.0), (0.0, 0.08), (0.06, 0.09), (0.12, 0.0))  # its crank does not come round
places = st.tuples(st.floats(-0.05, 0.15), st.floats(-0.05, 0.15))


@settings(max_examples=25, deadline=None)
@given(places, places, st.floats(0.05, 0.2), st.floats(-1.5, -0.1), st.floats(0.1, 1.5))
def test_the_chain_is_closed_and_its_joints_move_continuously(a, b, width, low, high):
    try:
        linkage = made(four_bar(((0.0, 0.0), a, b, (width, 0.0)), limits=(low, high)))
    except EvaluationError:
        assume(False)
    assume(linkage.loops)
    laws = [linkage.joints[name].follows for name in ("rod_turn", "rocker_turn")]
    inputs = np.linspace(low, high, 37)
    assert max(gap(linkage, {"crank_turn": at}) for at in inputs) < 1e-9
    for law in laws:
        assert law.at(0.0) == pytest.approx(0.0, abs=1e-9)
        steps = np.abs(np.diff(law.positions(inputs)))
        assert (steps <= law.steepest * np.diff(inputs) + 1e-12).all()


def test_a_slider_crank_moves_as_its_formula_says():
    linkage = made(slider_crank(0.03, 0.1))
    for angle in np.linspace(-9.0, 9.0, 19):
        along = 0.03 * math.cos(angle) + math.sqrt(0.1**2 - (0.03 * math.sin(angle)) ** 2)
        found = linkage.positions({"crank_turn": angle})
        assert found["slide"] == pytest.approx(along - 0.13, abs=1e-9)
        assert math.sin(found["rod_turn"] + angle) == pytest.approx(-0.3 * math.sin(angle), abs=1e-9)
    low, high = linkage.joints["slide"].limits
    assert (low, high) == pytest.approx((-0.06, 0.0), abs=1e-9)


def test_a_joint_that_turns_back_has_the_limits_of_its_motion():
    linkage = made(four_bar())
    low, high = linkage.joints["rocker_turn"].limits
    reached = linkage.valid_states.positions(np.linspace(-np.pi, np.pi, 20001)[:, None])[:, 2]
    assert (low, high) == pytest.approx((reached.min(), reached.max()), abs=1e-7)
    assert low <= reached.min()
    assert reached.max() <= high
    assert linkage.joints["rod_turn"].limits is None  # it turns once against the crank
    assert linkage.joints["rod_turn"].follows.gain == pytest.approx(-math.tau)


def test_a_dead_point_is_an_error_with_the_joint_and_the_angle():
    with pytest.raises(EvaluationError, match=r"does not close beyond crank_turn = .* dead point") as caught:
        made(four_bar(FLAT, limits=(-3.0, 3.0)))
    angle = float(str(caught.value).partition("crank_turn = ")[2].split()[0])
    # rod and rocker are in line where the end of the crank is as far from the rocker's pivot as both reach
    crank, rod, rocker = 0.08, math.hypot(0.06, 0.01), math.hypot(0.06, 0.09)
    cosine = (crank**2 + 0.12**2 - (rod + rocker) ** 2) / (2 * crank * 0.12)
    dead = math.pi / 2 - math.acos(cosine)
    assert dead < angle < dead + 0.001
    made(four_bar(FLAT, limits=(angle + 0.02, 0.0)))


def test_a_parallelogram_has_plain_couplings():
    linkage = made(four_bar(PARALLEL, limits=(-1.0, 1.0)))
    assert linkage.loops == ()
    laws = {name: linkage.joints[name].follows for name in ("rod_turn", "rocker_turn")}
    assert [(law.ratio, law.offset, law.curve) for law in laws.values()] == [
        (-1.0, 0.0, None),
        (1.0, 0.0, None),
    ]


def test_intervals_contain_the_motion():
    law = made(four_bar()).joints["rocker_turn"].follows.then(-2.0, 0.1)
    draw = np.random.default_rng(0)
    low = draw.uniform(-3.1, 3.0, 200)
    high = np.minimum(low + 10 ** draw.uniform(-4, 0.5, 200), 3.14)
    middle, half = law.interval(low, high)
    inside = law.positions(low + (high - low) * np.linspace(0, 1, 101)[:, None])
    assert (np.abs(inside - middle) <= half + 1e-12).all()
    assert (half <= law.steepest * (high - low)).all()
    slopes = [law.slope(at) for at in low[:20]]
    rises = (law.positions(low[:20] + 1e-6) - law.positions(low[:20] - 1e-6)) / 2e-6
    np.testing.assert_allclose(slopes, rises, atol=1e-7)


def test_chains_move_turn_and_repeat_with_their_bodies():
    def poses(body, name=""):
        asset = made(body)
        assert gap(asset, {f"crank_turn{name}": 0.7, **({"crank_turn_1": 0.4} if name else {})}) < 1e-9
        return asset

    body = four_bar(limits=(-1.0, 1.0))
    poses(body.at(0.1, 0.2, 0.3).rotate(Z, 0.5))
    mirrored = poses(body.mirror(X))
    assert mirrored.loops[0].point[0] == pytest.approx(-0.1)
    plate = bar("plate", (0, -0.1), (0.5, -0.1), 4)
    stand = Prismatic("stand", axis=Z, limits=(0.0, 0.1))
    row = poses(plate.repeat(body, stand, at=[(0, 0, 0), (0.3, 0, 0)]), "_0")
    assert [loop.links for loop in row.loops] == [("rod_0", "rocker_0"), ("rod_1", "rocker_1")]
    assert [loop.joint for loop in row.loops] == ["crank_turn_0", "crank_turn_1"]


def test_a_chain_on_top_of_a_chain_has_the_same_input():
    second, pivot = (0.16, 0.06), (0.2, 0.0)
    body = four_bar(limits=(-0.5, 0.5))
    link = bar("link", PLACES[2], second, 3)
    crank_turn = turn("crank_turn", PLACES[0])
    slow = turn("arm_turn", pivot)
    body = body.attach(bar("arm", pivot, second, 2).attach(link, turn("link_turn", second)), slow)
    body = body.loop("link", "rocker", at=(PLACES[2][0], 0, PLACES[2][1]), axis=Y, driver=crank_turn)
    six = made(body)
    assert len(six.loops) == 2
    assert len(six.free_joints) == 1
    assert max(gap(six, {"crank_turn": at}) for at in np.linspace(-0.5, 0.5, 11)) < 1e-9


def test_a_loop_is_a_node_like_any_other():
    body = four_bar(limits=(0.0, Float.parameter("open")))
    assert made(body, open=0.5).joints["crank_turn"].limits == (0.0, 0.5)
    copy = Graph.from_json(Graph(body).to_json())
    assert copy.evaluate({"open": 0.5}).value.loops[0].joint == "crank_turn"


def chain(driver="crank_turn", a="rod", b="rocker", axis=Y, rocker=None, rod=None):
    o, first, second, c = PLACES
    crank_turn = turn("crank_turn", o, limits=(0.0, 0.5))
    rod_turn = turn("rod_turn", first) if rod is None else rod
    crank = bar("crank", o, first, 1).attach(bar("rod", first, second, 2), rod_turn)
    body = bar("ground", o, c, 0).attach(crank, crank_turn)
    body = body.attach(bar("rocker", c, second, 1), turn("rocker_turn", c) if rocker is None else rocker)
    return body.loop(a, b, at=(second[0], 0, second[1]), axis=axis, driver=turn(driver, o))


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"a": "rood"}, "joins 'rood', which is no link of this body. Did you mean 'rod'?"),
        (
            {"driver": "crank"},
            "the input 'crank' of the loop is not attached yet. Did you mean 'crank_turn'?",
        ),
        ({"axis": Z}, "joint 'crank_turn' turns about another direction than the pin"),
        ({"rocker": Prismatic("slide", axis=Y)}, "joint 'slide' slides along the pin"),
        (
            {"a": "crank"},
            "determines two joints of a closed chain beside its input; this one has 'rocker_turn'",
        ),
        ({"rocker": turn("rocker_turn", PLACES[3], limits=(0, 1))}, "gets its range from the loop"),
        ({"rod": turn("rod_turn", PLACES[2])}, "the loop is at a dead point at rest"),
        ({"driver": "rocker_turn"}, "joint 'crank_turn' gets its range from the loop; leave its limits out"),
    ],
)
def test_chains_that_cannot_be_solved_are_refused(options, message):
    if options.get("driver") == "rocker_turn":
        options = {**options, "rocker": turn("rocker_turn", PLACES[3], limits=(0.0, 0.1))}
    with pytest.raises(EvaluationError) as caught:
        made(chain(**options))
    assert message in str(caught.value).replace("\n", " ")
    assert f"\n  at {__file__}:" in str(caught.value)


def test_conditions_are_on_the_input():
    body = four_bar(limits=(0.0, 0.5))
    needs = Revolute("rocker_turn", axis=Y) > 0.1
    flap = Revolute("flap_turn", axis=Y, limits=(0, 1), needs=needs)
    with pytest.raises(AssetError, match="put the condition on its input 'crank_turn'"):
        made(body.attach(bar("flap", (0, -0.1), (0.1, -0.1), 0), flap))
