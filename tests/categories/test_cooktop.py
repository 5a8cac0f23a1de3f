"""The category `cooktop`: gas dials have to be pushed in, one dial for each burner, grates come off."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from manifold3d import Manifold, OpType

from artgen import Asset, InfeasibleError
from artgen.categories.cooktop import cooktop
from artgen.categories.cooktop.dials import SWEEP
from artgen.categories.shared.cooktops import COLUMNS
from artgen.graph import Cache
from support.cases import some

KINDS = ("gas", "radiant", "coil", "induction")


def made(seed: int, **overrides: object) -> Asset:
    return cooktop.generate(seed, cache=Cache(), certify=False, **overrides)


def overlap(asset: Asset, link: str, **q: float) -> float:
    """Return the volume that a link has in common with the base at a pose [m3]."""
    placed = []
    for name in (link, asset.links[0].name):
        pieces = [piece.shape.manifold for piece in asset.link(name).pieces if not piece.visual]
        placed.append(Manifold.batch_boolean(pieces, OpType.Add).transform(asset.pose(q)[name][:3, :4]))
    return float((placed[0] ^ placed[1]).volume())


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_is_proven_free_of_collisions(kind: str) -> None:
    asset = cooktop.generate(3, cache=Cache(), on_collision="fail", burner=kind)
    assert asset.certificate is not None
    assert asset.certificate.proven


@pytest.mark.parametrize(("burners", "rows"), sorted(COLUMNS))
@pytest.mark.parametrize("more", some([0, 1, 2], 3))
def test_there_is_a_dial_for_each_burner_and_up_to_two_more(burners: int, rows: int, more: int) -> None:
    asset = made(1, burner="induction", burners=burners, rows=rows, dials=burners + more, dials_at="front")
    own = [link.name for link in asset.links if link.label == "burner_dial"]
    assert own == [f"burner_dial_{number}" for number in range(burners)]
    others = [link.name for link in asset.links if link.label == "dial"]
    assert others == ["timer_dial", "fan_dial"][:more]


def test_three_dials_more_than_burners_are_refused() -> None:
    with pytest.raises(InfeasibleError, match="dials must be from the number of burners to two more"):
        made(0, burners=4, dials=7)


@pytest.mark.parametrize(("burners", "rows"), [(2, 2), (5, 1), (6, 1)])
def test_burners_in_other_rows_are_refused(burners: int, rows: int) -> None:
    with pytest.raises(InfeasibleError, match="3 or 4 one or two, 5 or 6 two: set rows or burners"):
        made(0, burners=burners, rows=rows)


def test_a_gas_dial_turns_only_while_it_is_pushed_in() -> None:
    asset = made(2, burner="gas", burners=4, rows=2)
    push, turn = asset.joint("burner_dial_push_1"), asset.joint("burner_dial_turn_1")
    assert (push.parent, push.child) == (turn.parent, turn.child)
    assert turn.limits == pytest.approx((0.0, SWEEP))
    travel = push.limits[1]
    assert 0.003 <= travel <= 0.004
    assert asset.blocked({turn.name: 0.5}) == (turn.name,)
    assert asset.blocked({turn.name: 0.5, "burner_dial_push_0": travel}) == (turn.name,)
    assert asset.blocked({turn.name: 0.5, push.name: travel}) == ()


@pytest.mark.parametrize("seed", range(3))
def test_the_pin_of_a_tap_stands_in_the_way_and_lets_the_disc_pass_below(seed: int) -> None:
    asset = made(seed, burner="gas", burners=3)
    travel = asset.parameters["push_travel"]
    assert overlap(asset, "burner_dial_0") == 0.0
    for turn in (0.1, 1.0, 2.5, SWEEP):
        assert overlap(asset, "burner_dial_0", burner_dial_turn_0=turn) > 0.0
        pushed = {"burner_dial_turn_0": turn, "burner_dial_push_0": travel}
        assert overlap(asset, "burner_dial_0", **pushed) == 0.0
    # turned, it cannot come out by more than the clearance under the pin
    out = {"burner_dial_turn_0": 2.0, "burner_dial_push_0": travel - 0.0003}
    assert overlap(asset, "burner_dial_0", **out) > 0.0


def test_the_spring_of_a_tap_lifts_the_dial() -> None:
    for seed in range(4):
        asset = made(seed, burner="gas")
        push = asset.joint("burner_dial_push_0")
        weight = 9.81 * asset.link("burner_dial_0").mass_properties.mass
        at_rest = -push.stiffness * push.rest
        assert at_rest > weight + push.friction
        assert push.stiffness * (push.limits[1] - push.rest) == pytest.approx(asset.parameters["push_force"])


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind != "gas"])
def test_electric_dials_turn_freely_clockwise(kind: str) -> None:
    asset = made(4, burner=kind)
    turn = asset.joint("burner_dial_turn_0")
    assert turn.needs is None
    np.testing.assert_allclose(turn.axis, (0.0, 0.0, -1.0))
    assert not [joint for joint in asset.joints if "push" in joint.name]


@pytest.mark.parametrize("style", ["continuous", "single", "diagonal"])
def test_grates_rest_on_the_plate_over_every_burner(style: str) -> None:
    asset = made(5, burner="gas", burners=5, grate=style)
    plate = asset.parameters["height"]
    grates = [link for link in asset.links if link.label == "grate"]
    assert len(grates) == (3 if style == "continuous" else 5)
    for number, link in enumerate(grates):
        low, high = link.bounds()
        assert 0.0 < low[2] - plate < 0.0005
        assert high[2] - plate == pytest.approx(0.043)
        assert 0.5 < link.mass_properties.mass < 4.0  # a hand lifts it
        assert asset.joint(f"grate_lift_{number}").limits == pytest.approx((0.0, 0.10))


@settings(max_examples=10, deadline=None)
@given(seed=st.integers(0, 10_000), kind=st.sampled_from(KINDS))
def test_any_seed_can_be_built_within_the_budget(seed: int, kind: str) -> None:
    asset = made(seed, burner=kind)
    counts = [len(link.colliders) for link in asset.links]
    assert max(counts) <= 64
    assert sum(counts) < 200
    assert 5.0 <= asset.mass_properties().mass <= 20.0
