"""What is special to pepper mills: what turns without end, what it turns, and the room that it has."""

from functools import lru_cache
from typing import Any, get_args

import numpy as np
import pytest

from artgen.asset import Asset, Link
from artgen.categories.pepper_grinder import pepper_grinder
from artgen.categories.pepper_grinder.forms import BodyForm, Top
from artgen.errors import InfeasibleError
from artgen.graph import Cache

HEADS = ("bulb", "disc", "ball")


@lru_cache(maxsize=64)
def _drawn(seed: int, more: tuple[tuple[str, Any], ...]) -> Asset:
    return pepper_grinder.generate(seed, cache=Cache(), certify=False, **dict(more))


def drawn(seed: int, **more: Any) -> Asset:
    return _drawn(seed, tuple(more.items()))


def link(asset: Asset, name: str) -> Link:
    return next(each for each in asset.links if each.name == name)


def piece(of: Link, label: str) -> Any:
    return next(each for each in of.pieces if each.label == label and not each.visual)


@pytest.mark.parametrize("top", HEADS)
def test_a_head_turns_without_end_and_takes_the_burr_along(top: str) -> None:
    asset = drawn(1, style="cylinder", build="wood", top=top)
    (turn,) = asset.free_joints
    assert turn.name == "top_turn"
    assert turn.limits is None
    assert turn.axis.tolist() == [0.0, 0.0, 1.0]
    assert turn.stiffness == 0.0
    head = link(asset, "top")
    assert {"shaft", "burr", "finial"} <= set(head.labels)
    assert piece(head, "burr").shape.bounds()[0, 2] < 0.004, "the burr is not seen from below"


def test_a_crank_turns_the_burr_and_its_knob_spins_on_its_own_pin() -> None:
    asset = drawn(2, style="barrel", build="wood", top="crank")
    assert [joint.name for joint in asset.free_joints] == ["crank_turn", "knob_spin"]
    assert all(joint.limits is None for joint in asset.free_joints)
    spin = asset.joint("knob_spin")
    assert asset.joint("crank_turn").child == spin.parent
    reach = float(asset.parameters["crank_reach"])
    assert np.hypot(*spin.pivot[:2]) == pytest.approx(reach)
    turned = asset.pose({"crank_turn": np.pi / 2.0})["knob"]
    assert (turned[:3, :3] @ spin.pivot + turned[:3, 3])[:2] == pytest.approx([reach, 0.0])
    assert "burr" in link(asset, "crank").labels


@pytest.mark.parametrize("style", get_args(BodyForm))
@pytest.mark.long
def test_every_body_carries_every_head_with_a_hair_of_room(style: str) -> None:
    for top in get_args(Top):
        asset = drawn(3, style=style, build="wood", top=top)
        gap = asset.clearance({})
        name = "crank" if top == "crank" else "top"
        found = min(length for pair, length in gap.items() if set(pair) == {"body", name})
        assert 0.0003 <= found <= 0.0006, f"{style} with {top}: {1e3 * found:.2f} mm"


def test_a_clear_mill_shows_what_is_in_it() -> None:
    asset = drawn(4, style="cylinder", build="clear", top="disc")
    body = asset.links[0]
    heap = piece(body, "peppercorns")
    seen = [each for each in body.pieces if each.label == "peppercorns" and each.visual]
    assert len(seen) >= 2
    wall = next(each for each in body.pieces if each.material.name == "clear_tube")
    assert wall.material.opacity < 0.6
    assert heap.shape.bounds()[1, 0] < wall.shape.bounds()[1, 0] - 0.0028
    assert all(
        "peppercorns" not in drawn(4, style=style, build="wood").links[0].labels
        for style in ("cone", "spool")
    )


def test_the_mill_is_as_heavy_as_its_wood() -> None:
    light, heavy = (
        drawn(5, style="classic", top="bulb", build="wood", size="kitchen", height=height).mass
        for height in (0.19, 0.26)
    )
    assert 0.1 < light < heavy < 0.5


@pytest.mark.parametrize("top", ["bulb", "ball", "crank"])
def test_a_letter_is_printed_on_a_flat_head_only(top: str) -> None:
    with pytest.raises(InfeasibleError, match=f"mark=letter needs the flat head of top=disc, not top={top}"):
        drawn(6, style="tower", build="wood", top=top, mark="letter")
    head = link(drawn(6, style="tower", build="wood", top="disc", mark="letter"), "top")
    assert "print" in head.labels
