"""The proof covers the curved motion of closed chains: sampled states agree with it, and files keep it."""

from dataclasses import replace

import numpy as np
import pytest

from artgen._names import ByName
from artgen.materials import material
from artgen.nodes.body import part, weld
from artgen.nodes.primitive import box, cylinder
from artgen.nodes.vector import Y
from artgen.proof.certify import certify
from artgen.proof.paths import Space
from artgen.proof.recheck import recheck
from support.brute import overlaps
from support.linkages import PLACES, four_bar, gap, made, slider_crank


def poses(asset, count=240):
    low, high = asset.joints["crank_turn"].limits or (-np.pi, np.pi)
    return [{"crank_turn": float(at)} for at in np.linspace(low, high, count)]


@pytest.mark.parametrize("body", [four_bar(), slider_crank()], ids=["four-bar", "slider-crank"])
def test_no_sampled_state_of_a_proven_chain_overlaps(body):
    linkage = made(body)
    certificate = certify(linkage, measure=True)
    assert certificate.proven
    assert overlaps(linkage, poses(linkage)) == []
    assert recheck(linkage, certificate) == []
    guaranteed = [pair.guaranteed for pair in certificate.pairs]
    assert min(guaranteed) == pytest.approx(0.001, rel=0.05)  # layers of 5 mm in steps of 6 mm


def with_post(place):
    """Return a four-bar with a post on its ground, in the layer of the rod."""
    post = part(box(0.004, 0.018, 0.004).at(place[0], -0.006, place[1]), "post", material("brass"))
    body = four_bar(limits=(-1.2, 1.2))
    return made(weld(body, post))


def rod_end(asset, at):
    """Return where a point on the rod is while the crank is at an angle."""
    point = np.array([0.05, 0.0, 0.05, 1.0])
    return (asset.pose({"crank_turn": at})["rod"] @ point)[[0, 2]]


def test_a_post_is_met_in_the_middle_of_the_motion_only_if_it_stands_in_its_way():
    plain = made(four_bar(limits=(-1.2, 1.2)))
    inside = rod_end(plain, 0.37)
    struck = with_post(inside)
    brute = {(a, b) for _, a, b, _ in overlaps(struck, poses(struck))}
    certificate = certify(struck)
    assert {pair.links for pair in certificate.failures} == brute
    witness = next(pair.witness for pair in certificate.failures if pair.links == ("ground", "rod"))
    assert overlaps(struck, [witness.pose], pairs=[("ground", "rod")])
    away = with_post((0.05, -0.05))
    assert certify(away).proven
    assert overlaps(away, poses(away)) == []


@pytest.mark.parametrize("layers", [{"rod": 1}, {"rocker": 0}])
def test_bars_in_one_layer_collide(layers):
    flat = made(four_bar(limits=(-0.6, 0.6), layers=layers))
    failed = {pair.links for pair in certify(flat).failures}
    assert failed == {(a, b) for _, a, b, _ in overlaps(flat, poses(flat))}
    assert failed


def test_a_stored_proof_does_not_hold_for_another_law():
    linkage = with_post(rod_end(made(four_bar(limits=(-1.2, 1.2))), 0.37) + [0.0, 0.025])
    certificate = certify(linkage)
    assert certificate.proven
    law = linkage.joints["rod_turn"].follows
    assert recheck(linkage, certificate) == []
    steeper = replace(linkage.joints["rod_turn"], follows=law.then(2.0, 0.0))
    joints = ByName(steeper if joint.name == "rod_turn" else joint for joint in linkage.joints)
    mutated = replace(linkage, joints=joints)
    assert gap(mutated, {"crank_turn": 0.5}) > 0.001
    assert recheck(mutated, certificate)


def test_paths_have_the_laws_of_closed_chains():
    linkage = made(four_bar(limits=(-0.5, 0.5)))
    path = next(path for path in Space(linkage).joint_paths() if path.links == ("rod", "rocker"))
    assert path.variables == ("crank_turn",)
    (step,), (law,) = path.steps, path.followers  # through the pin
    np.testing.assert_allclose(step.pivot, linkage.loops[0].point)
    for at in (-0.4, 0.0, 0.3):
        poses = linkage.pose({"crank_turn": at})
        relative = np.linalg.inv(poses["rod"]) @ poses["rocker"]
        np.testing.assert_allclose(step.motion(law.at(at)), relative, atol=1e-9)
    path = next(path for path in Space(linkage).joint_paths() if path.links == ("crank", "rocker"))
    assert [law.curve is None for law in path.followers] == [True, False]


def pinned(clearance):
    """Return a four-bar whose rod carries a pin in a hole of the rocker, with a clearance [m]."""
    x, z = PLACES[2]
    pin = part(cylinder(0.003, 0.012, axis=Y).at(x, -0.009, z), "pin", material("brass"))
    hole = cylinder(0.003 + clearance, 0.02, axis=Y).at(x, 0, z)
    return made(four_bar(limits=(-1.0, 1.0), pin=pin, hole=hole))


def test_a_pin_turns_in_its_hole_and_collides_in_a_tight_one():
    loose, tight = pinned(0.0003), pinned(-0.0001)
    certificate = certify(loose)
    assert certificate.proven
    assert recheck(loose, certificate) == []
    assert {pair.links for pair in certify(tight).failures} == {("rod", "rocker")}
