"""All public fittings: each is installed with its defaults, moves in its range, and is proven."""

import inspect
import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from functools import cache
from typing import Any, Literal, get_args, get_origin, get_type_hints

import numpy as np
import pytest

from artgen import Body, Region, X, details, fittings, material, part
from artgen.asset import Asset
from artgen.errors import AssetError, BuildError
from artgen.generator import Generator
from artgen.graph import evaluate
from support.lines import place_of

NAMES = [name for name in fittings.__all__ if name not in ("FIT", "Fitting")]
PANEL = Region((-0.3, 0.3), (0.0, 0.04), (-0.2, 0.2))
HOSTS = {
    "pocket_handle": PANEL.with_(x=(-0.3, 0.0)),
    "edge_pull": PANEL.with_(z=(-0.2, 0.0)),
    "cam_lock": PANEL.with_(y=(0.0, 0.018)),
    "deadbolt": PANEL.with_(x=(-0.2, 0.06)),
    "hinge": PANEL.with_(x=(-0.3, -0.002)),
}
"""Hosts of fittings that belong at an edge, or on a panel of their thickness."""

MASSES: dict[str, tuple[float, float]] = {
    "bar_handle": (0.05, 0.6),
    "cam_lock": (0.02, 0.12),
    "caster": (0.05, 0.4),
    "cup_pull": (0.03, 0.25),
    "deadbolt": (0.2, 1.0),
    "dial": (0.005, 0.06),
    "display": (0.0, 0.0),
    "drawer_runners": (1.0, 5.0),
    "edge_pull": (0.01, 0.1),
    "foot": (0.005, 0.1),
    "hinge": (0.05, 0.3),
    "knob": (0.02, 0.2),
    "knob_set": (0.2, 1.2),
    "latch": (0.01, 0.15),
    "lever_set": (0.4, 1.4),
    "logo": (0.0, 0.0),
    "pocket_handle": (0.01, 0.4),
    "push_button": (0.0005, 0.01),
    "recessed_handle": (0.05, 0.9),
}
"""Lowest and highest masses of real products [kg]."""

FORCES = {
    "push_button": ("button_slide", 0.6, 3.0),
    "latch": ("latch_slide", 2.5, 6.0),
    "lever_set": ("handle_turn", 0.55 * 1.3, 1.3),
    "knob_set": ("handle_turn", 0.55 * 0.6, 0.6),
}
"""Forces of springs at rest and at the limit [N or N m]."""

JOINTS = {
    "cam_lock": {"lock_turn"},
    "caster": {"caster_swivel", "caster_roll"},
    "deadbolt": {"lock_turn", "deadbolt_slide"},
    "dial": {"dial_turn"},
    "drawer_runners": {"drawer_slide"},
    "hinge": {"leaf_hinge"},
    "knob_set": {"handle_turn"},
    "latch": {"latch_slide"},
    "lever_set": {"handle_turn"},
    "push_button": {"button_slide"},
}


def host(name: str) -> Body:
    return part(HOSTS.get(name, PANEL).box(), "panel", material("oak"))


def asset_of(body: Body) -> Asset:
    return Asset.from_tree(evaluate(body).value, "made", "test")


@cache
def installed(name: str) -> Asset:
    return asset_of(host(name).install(getattr(fittings, name)()))


def options(module: Any, names: Iterable[str]) -> Iterator[tuple[Callable[..., Any], str]]:
    """Yield each function with the name of each of its parameters whose type has literals."""
    for name in names:
        function = getattr(module, name)
        for parameter, hint in get_type_hints(function).items() if inspect.isfunction(function) else ():
            if any(get_origin(each) is Literal for each in (hint, *get_args(hint))):
                yield function, parameter


OPTIONS = [*options(fittings, NAMES), (details.foot, "style"), (details.pointer, "style")]


@pytest.mark.parametrize(("function", "parameter"), OPTIONS)
def test_an_option_that_does_not_exist_is_named(function: Callable[..., Any], parameter: str) -> None:
    needed = [each for each in inspect.signature(function).parameters.values() if each.default is each.empty]
    with pytest.raises(BuildError, match=r"(needs one of|cannot shine in) .*'elaborate'.*\n  at .*test_f"):
        function(*(0.02 for _ in needed), **{parameter: "elaborate"})


@pytest.mark.parametrize(
    ("name", "wrong", "message"),
    [
        ("display", {"text": 1230}, "display(..., text=...) needs a str, got 1230"),
        ("logo", {"brand": 5}, "logo(..., brand=...) needs a str, got 5"),
        ("push_button", {"finish": "abs"}, "finish=...) needs a Material, got 'abs'; write material('abs')"),
        ("push_button", {"icon": 5}, "push_button(..., icon=...) needs a str or a Profile, got 5"),
        ("push_button", {"travel": 0}, "push_button(..., travel=...) must be above 0, got 0"),
        ("dial", {"limits": 2.4}, "needs 2 values of Float or None, got 2.4; write the lower and the upper"),
        ("dial", {"icons": "fan"}, "dial(..., icons=...) needs a sequence of str, got 'fan'"),
        ("dial", {"clicks": 1}, "dial(..., clicks=...) is 0 or at least 2, got 1"),
        ("dial", {"clicks": -3}, "dial(..., clicks=...) is 0 or at least 2, got -3"),
        ("hinge", {"levels": 1}, "hinge(..., levels=...) needs a sequence of Float, got 1"),
        ("hinge", {"leaf": 5}, "hinge(..., leaf=...) needs a Body or None, got 5"),
        ("latch", {"throw": 0.0}, "latch(..., throw=...) must be above 0, got 0.0"),
        ("lever_set", {"limit": 0}, "lever_set(..., limit=...) must be above 0, got 0"),
        ("knob_set", {"limit": -1}, "knob_set(..., limit=...) must be above 0, got -1"),
        ("foot", {"height": 0}, "foot(..., height=...) must be above 0, got 0"),
        ("caster", {"swivel": "no"}, "caster(..., swivel=...) needs a Bool, got 'no'"),
    ],
)
def test_a_wrong_argument_is_named_at_the_line_of_the_author(
    name: str, wrong: dict[str, Any], message: str
) -> None:
    with pytest.raises(BuildError, match=rf"{re.escape(message)}.*\n  at {re.escape(__file__)}:\d+$"):
        getattr(fittings, name)(**wrong)


@pytest.mark.parametrize("name", NAMES)
def test_a_fitting_is_installed_with_its_defaults_and_is_proven(name: str) -> None:
    made = installed(name)
    assert made.links[0].name == "panel"
    assert {joint.name for joint in made.joints} == JOINTS.get(name, set())
    certificate = made.certify()
    assert certificate.proven, certificate


@pytest.mark.parametrize("name", JOINTS)
def test_joints_move_their_links(name: str) -> None:
    made = installed(name)
    for joint in made.free_joints:
        low, high = joint.limits or (0.0, 1.0)
        start, end = (made.pose({joint.name: q})[joint.child] for q in (low, high))
        assert np.abs(start - end).max() > 1e-3
        assert joint.effort > joint.friction > 0.0


@pytest.mark.parametrize("name", NAMES)
def test_a_hand_finds_a_place_on_what_it_uses(name: str) -> None:
    made = installed(name)
    hands = [hold for link in made.links for hold in (*link.grasps, *link.pushes)]
    assert bool(hands) == (name not in ("display", "foot", "hinge", "logo"))


@pytest.mark.parametrize("name", NAMES)
def test_copies_have_their_own_names_and_images_are_proven(name: str) -> None:
    fitting = getattr(fittings, name)()
    image = asset_of(host(name).mirror(X).install(fitting.mirror(X).suffixed("_1")))
    assert {joint.name for joint in image.joints} == {f"{each}_1" for each in JOINTS.get(name, ())}
    assert image.certify().proven
    if name not in HOSTS and name != "drawer_runners":  # a copy of both beside each other
        both = host(name).install(fitting.suffixed("_0"), at=(-0.15, 0.0, 0.0))
        pair = asset_of(both.install(fitting.suffixed("_1"), at=(0.15, 0.0, 0.0)))
        assert len(pair.joints) == 2 * len(JOINTS.get(name, ()))


NAMED = [name for name in NAMES if "name" in inspect.signature(getattr(fittings, name)).parameters]


@pytest.mark.parametrize("name", NAMED)
def test_a_name_of_its_own_names_all_that_a_fitting_adds(name: str) -> None:
    one, two = (asset_of(host(name).install(getattr(fittings, name)(name=each))) for each in ("one", "two"))

    def names(asset: Asset) -> set[str]:
        hands = {hold.name for link in asset.links for hold in (*link.grasps, *link.pushes)}
        return hands | {joint.name for joint in asset.joints} | {link.name for link in asset.links[1:]}

    assert not names(one) & names(two)


@pytest.mark.parametrize("name", NAMES)
def test_masses_are_those_of_products(name: str) -> None:
    whole = replace(getattr(fittings, name)(), cut=None)
    more = sum(link.mass_properties.mass for link in asset_of(host(name).install(whole)).links)
    low, high = MASSES[name]
    mass = more - asset_of(host(name)).links[0].mass_properties.mass
    if whole.cut is None and name in ("pocket_handle", "recessed_handle"):
        mass = evaluate(whole.body.mass()).value
    assert low - 1e-9 <= mass <= high + 1e-9, f"{name}: {mass:.4g} kg"


@pytest.mark.parametrize("name", FORCES)
def test_forces_are_those_of_the_documentation(name: str) -> None:
    joint_name, preload, force = FORCES[name]
    joint = installed(name).joint(joint_name)
    assert joint.stiffness * (joint.limits[0] - joint.rest) == pytest.approx(preload)
    assert joint.stiffness * (joint.limits[1] - joint.rest) == pytest.approx(force)


@pytest.mark.parametrize(
    "name",
    ["cam_lock", "deadbolt", "drawer_runners", "hinge", "knob_set", "latch", "lever_set", "push_button"],
)
def test_a_fitting_without_its_hole_is_refused(name: str) -> None:
    fitting = replace(getattr(fittings, name)(), cut=None)
    assert not asset_of(host(name).install(fitting)).certify().proven


def test_a_hinge_carries_a_leaf() -> None:
    door = part(Region((0.002, 0.3), (0.0, 0.04), (-0.2, 0.2)).box(), "door", material("walnut"))
    made = asset_of(host("hinge").install(fittings.hinge(door, levels=(-0.15, 0.15), name="door")))
    assert made.joint("door_hinge").child == "door"
    assert made.certify().proven


def test_a_fixed_caster_rolls_only() -> None:
    made = asset_of(host("caster").install(fittings.caster(swivel=False)))
    assert [joint.name for joint in made.joints] == ["caster_roll"]
    assert made.certify().proven


@pytest.mark.parametrize("lock", ["turn", "push"])
def test_a_knob_set_has_a_privacy_lock(lock: str) -> None:
    made = asset_of(host("knob_set").install(fittings.knob_set(lock=lock)))
    assert [joint.name for joint in made.joints] == ["handle_turn", f"lock_{lock}"]
    assert made.certify().proven


@pytest.mark.parametrize("style", ["numbers", "band", "icons", None])
def test_a_dial_has_a_scale_over_its_range(style: str | None) -> None:
    dial = fittings.dial(scale=style, icons=("power", "fan", "light"), limits=None)
    made = asset_of(host("dial").install(dial))
    assert made.joint("dial_turn").limits is None
    assert ("print" in made.links[0].labels) == (style is not None)


def test_a_fitting_without_declared_labels_names_all_of_them_and_the_line_of_its_caller() -> None:
    def toy() -> Body:
        host = part(PANEL.box(), "panel", material("enamel_white"))
        return host.install(fittings.push_button())  # marker: install

    with pytest.raises(AssetError) as caught:
        Generator(toy, labels=("panel",)).generate(0)
    assert all(repr(label) in str(caught.value) for label in ("bezel", "button", "print"))
    assert "Nor does it declare" in str(caught.value)
    assert place_of(__file__, "marker: install") in str(caught.value)
