"""What is special to windows: locks that hold, sashes that stay, panels that pass each other, counts."""

import numpy as np
import pytest

from artgen import generate
from artgen.asset import Asset
from artgen.errors import InfeasibleError


def window(seed: int = 4, **overrides: object) -> Asset:
    return generate("window", seed, certify=False, **overrides)


@pytest.mark.parametrize("opens", ["inwards", "outwards"])
def test_a_lever_slides_cams_out_of_their_keeps(opens: str) -> None:
    asset = window(style="casement", layout="single", opens=opens, lever_turn="quarter", shutters="none")
    ajar = {"pane_hinge": 0.01}
    assert asset.blocked(ajar)
    assert not asset.blocked({**ajar, "handle_turn": 1.5})
    assert not asset.blocked({"pane_hinge": 0.6})  # once open, the lever may be turned back
    bolt = asset.joint("bolt_slide")
    assert bolt.follows is not None
    assert bolt.follows.leader == "handle_turn"
    assert bolt.follows.ratio * 1.57 == pytest.approx(0.016)
    # the cams stand behind the keeps: the sash strikes them within a degree
    assert min(asset.clearance({"pane_hinge": 0.012}).values()) <= 0.0


@pytest.mark.parametrize(("opens", "way"), [("inwards", 1.0), ("outwards", -1.0)])
def test_a_casement_opens_to_its_side(opens: str, way: float) -> None:
    asset = window(style="casement", layout="single", opens=opens, shutters="none")
    pane = asset.link("pane")
    center = np.append(pane.mass_properties.center, 1.0)
    moved = asset.pose({"pane_hinge": 0.5, "handle_turn": 1.5})["pane"] @ center
    assert way * (moved[1] - center[1]) > 0.1


def test_hands_of_a_row_alternate_or_are_the_same() -> None:
    for hands, expected in (("same", {1}), ("opposite", {1, -1})):
        asset = window(style="casement", layout="row", hands=hands)
        axes = {round(asset.joint(f"pane_hinge_{number}").axis[2]) for number in range(4)}
        assert len(axes) == len(expected)


def test_levers_of_sashes_that_open_towards_each_other_do_not_meet() -> None:
    row = {"style": "casement", "layout": "row", "opens": "inwards", "hands": "opposite"}
    tight = {**row, "width": 1.85, "lever_length": 0.135, "kind": "wood", "swing": 1.41}
    handles = {"handle_1", "handle_2"}
    asset = window(**tight)
    half = {
        f"{name}_{number}": at
        for name, at in (("pane_hinge", 1.41), ("handle_turn", 1.57))
        for number in (1, 2)
    }
    found = {frozenset(pair): distance for pair, distance in asset.clearance(half).items()}
    assert 0.0 < found[frozenset(handles)] < 0.02
    with pytest.raises(InfeasibleError, match=r"would collide: lower swing or lever_length"):
        window(**{**tight, "swing": 1.45})
    assert window(**{**tight, "swing": 1.45, "lever_length": 0.105, "width": 2.2})


def test_an_awning_hangs_at_its_top_and_is_light_enough_to_lift() -> None:
    asset = window(style="awning", stay="friction", width=1.1, height=0.75)
    hinge = asset.joint("pane_hinge")
    assert abs(hinge.axis[0]) == pytest.approx(1.0)
    pane = asset.link("pane")
    assert hinge.pivot[2] > pane.bounds()[1, 2] - 0.02
    weight = 9.81 * sum(asset.link(name).mass_properties.mass for name in ("pane", "handle", "bolt"))
    arm = hinge.pivot[2] - pane.mass_properties.center[2]
    load = weight * arm * np.sin(hinge.limits[1])
    assert hinge.friction == pytest.approx(1.15 * load, rel=0.05)  # it stays wherever it is left
    assert (hinge.friction + load) / (2.0 * arm) < 60.0


def test_an_awning_without_a_stay_falls_shut() -> None:
    hinge = window(style="awning", stay="none").joint("pane_hinge")
    assert hinge.friction < 0.5


def test_balances_carry_hung_sashes() -> None:
    asset = window(style="double_hung", shutters="none")
    for name in ("lower", "upper"):
        joint = asset.joint(f"pane_slide_{name}")
        carried = {f"pane_{name}", "lock"} if name == "lower" else {f"pane_{name}"}
        weight = 9.81 * sum(asset.link(link).mass_properties.mass for link in carried)
        for at in joint.limits:
            left = weight * -joint.axis[2] + joint.stiffness * (joint.rest - at)
            assert abs(left) < joint.friction


def test_a_sash_lock_holds_both_hung_sashes() -> None:
    asset = window(style="double_hung", shutters="none")
    for name in ("pane_slide_lower", "pane_slide_upper"):
        assert asset.blocked({name: 0.05})
        assert not asset.blocked({name: 0.05, "lock_turn": 2.0})
    assert asset.joint("lock_turn").limits == pytest.approx((0.0, np.pi))


@pytest.mark.parametrize(("layout", "moving"), [("pair", 1), ("row", 2)])
def test_panels_slide_past_fixed_ones(layout: str, moving: int) -> None:
    asset = window(style="sliding", layout=layout, slides="one", shutters="none")
    slides = [joint for joint in asset.joints if joint.name.startswith("pane_slide")]
    assert len(slides) == moving
    width = asset.parameters["width"]
    for joint in slides:
        sash = np.ptp(asset.link(joint.child).bounds()[:, 0])
        assert 0.6 * sash < joint.limits[1] < sash
        assert joint.limits[1] < width / (2 * moving)
        assert asset.blocked({joint.name: 0.01})


@pytest.mark.parametrize("hand", ["left", "right"])
def test_two_panels_pass_each_other_and_one_lock_holds_both(hand: str) -> None:
    asset = window(style="sliding", layout="pair", slides="both", hand=hand, shutters="none")
    inner, outer = asset.joint("pane_slide_0"), asset.joint("pane_slide_1")
    assert inner.axis[0] == -outer.axis[0] == pytest.approx(1.0 if hand == "left" else -1.0)
    for slide in (inner, outer):
        assert asset.blocked({slide.name: 0.05})
        assert not asset.blocked({slide.name: 0.05, "lock_turn": 2.0})
        sash = np.ptp(asset.link(slide.child).bounds()[:, 0])
        assert slide.limits[1] > 0.7 * sash
    # each runs in a track of its own, so that they are never in each other's way
    assert asset.link("pane_1").bounds()[1, 1] < asset.link("pane_0").bounds()[0, 1] + 0.001
    for travels in ((1.0, 1.0), (1.0, 0.0), (0.0, 1.0), (0.5, 0.5)):
        at = {
            slide.name: share * slide.limits[1] for slide, share in zip((inner, outer), travels, strict=True)
        }
        assert min(asset.clearance({**at, "lock_turn": np.pi}).values()) > 0.0


@pytest.mark.parametrize(("layout", "panes"), [("single", 1), ("pair", 2), ("row", 4), ("cross", 4)])
def test_panes_and_bars_are_counted(layout: str, panes: int) -> None:
    asset = window(style="casement", layout=layout, columns=2, rows=1, shutters="none")
    sashes = [link for link in asset.links if link.name.startswith("pane")]
    assert len(sashes) == panes
    for sash in sashes:
        assert [piece.label for piece in sash.pieces if not piece.visual].count("glass") == 1


def test_shutters_hang_in_front_of_the_window() -> None:
    asset = window(style="double_hung", shutters="louvred")
    frame = asset.link("frame").bounds()
    for side in ("left", "right"):
        leaf = asset.link(f"shutter_{side}").bounds()
        assert leaf[1, 1] < 0.0
        hinge = asset.joint(f"shutter_hinge_{side}")
        assert hinge.limits[1] > 1.5
        assert frame[0, 0] - 0.001 < leaf[0, 0]
        assert leaf[1, 0] < frame[1, 0] + 0.001


@pytest.mark.parametrize("slides", ["one", "both"])
def test_a_pull_in_a_low_window_ends_below_the_strip_at_the_head(slides: str) -> None:
    low = {"style": "sliding", "layout": "pair", "slides": slides, "kind": "pvc", "height": 0.45}
    asset = window(**low, bar=0.165)
    found = {frozenset(pair): distance for pair, distance in asset.clearance({}).items()}
    pane = "pane" if slides == "one" else "pane_0"
    assert found[frozenset({"frame", pane})] > 0.0
    if slides == "one":
        with pytest.raises(InfeasibleError, match=r"between its latch and the strip at the head: lower bar"):
            window(**low, bar=0.18)


@pytest.mark.long
def test_a_sash_has_room_for_what_holds_it_and_for_its_lever() -> None:
    cross = {"style": "casement", "layout": "cross", "opens": "outwards", "kind": "pvc", "upper": 0.26}
    for height in (0.45, 1.05):
        with pytest.raises(InfeasibleError, match=r"no room for its hinges and for two keeps: raise height"):
            window(**cross, height=height, lever_length=0.09)
    assert window(**cross, height=1.11, lever_length=0.11)
    with pytest.raises(InfeasibleError, match=r"would strike the frame .* lower lever_length"):
        window(**cross, height=1.11, lever_length=0.12)
    assert window(**{**cross, "opens": "inwards"}, height=1.11, lever_length=0.12)
    with pytest.raises(InfeasibleError, match=r"no room for its hinges .* width of an awning"):
        window(style="awning", width=0.4, kind="pvc", lever_length=0.09)


def test_a_narrow_sash_swings_its_lever_and_lock_past_the_frame() -> None:
    single = {"style": "casement", "layout": "single", "lever": "straight", "lever_length": 0.1}
    for kind, words in (("pvc", r"the lock of a narrow sash"), ("aluminium", r"the lever of a narrow sash")):
        narrow = {**single, "kind": kind, "opens": "outwards"}
        with pytest.raises(InfeasibleError, match=f"{words} .* raise width, or height of an awning"):
            window(**narrow, width=0.4)
        asset = generate("window", 4, **narrow, width=0.42, on_collision="fail")
        assert asset.certificate is not None
    assert window(**single, kind="aluminium", opens="inwards", width=0.4)
