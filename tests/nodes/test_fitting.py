"""Fittings: parts that a host takes over with their joints and the hole that they need."""

import doctest

import numpy as np
import pytest

import artgen
from artgen import feel
from artgen.asset import Asset
from artgen.errors import BuildError, EvaluationError
from artgen.graph import evaluate
from artgen.materials import material
from artgen.nodes.body import detail, part, weld
from artgen.nodes.fitting import Fitting
from artgen.nodes.handles import Float
from artgen.nodes.joint import Prismatic, Revolute, Spring
from artgen.nodes.primitive import box, cylinder
from artgen.nodes.vector import X, Y, Z

ABS = material("abs")


def asset(body):
    return Asset.from_tree(evaluate(body).value, "made", "test")


def panel():
    return part(box(0.1, 0.012, 0.05).at(y=0.006), "panel", ABS)


def button():
    cap = part(cylinder(0.006, 0.010, axis=Y).at(y=0.001), "button", ABS)
    plate = detail(box(0.02, 0.001, 0.02).at(y=-0.0004), "plate", material("steel"))
    slide = Prismatic("slide", axis=Y, limits=(0, 0.002), spring=Spring(preload=0.6, force=3.0))
    return Fitting.moving(cap, slide, fixed=plate, cut=cylinder(0.0065, 0.1, axis=Y))


def test_the_example_of_the_class_runs():
    names = {name: getattr(artgen, name) for name in artgen.__all__} | {"Fitting": Fitting}
    *before, last = doctest.DocTestParser().get_examples(Fitting.__doc__)
    for line in before:
        exec(line.source, names)  # noqa: S102
    made = asset(eval(last.source, names))  # noqa: S307
    assert [joint.name for joint in made.joints] == ["button_slide_0", "button_slide_1"]
    assert made.certify().proven


def test_a_host_takes_over_plate_joint_and_hole():
    made = asset(panel().install(button(), at=(0.02, 0.0, 0.01)))
    assert made.link("panel").labels == ("panel", "plate")
    joint = made.joint("slide")
    assert (joint.parent, joint.child) == ("panel", "button")
    assert joint.pivot == pytest.approx([0.02, 0.0, 0.01])
    volume = 0.1 * 0.012 * 0.05
    hole = np.pi * 0.0065**2 * 0.012
    left = made.link("panel").pieces[0].shape.manifold.volume()
    assert volume - left == pytest.approx(hole, rel=0.04)  # the facets of the cutter lie within its radius
    assert made.certify().proven


def test_a_fitting_without_fixed_parts_adds_none():
    knob = part(cylinder(0.01, 0.01, axis=Y).at(y=-0.006), "knob", ABS)
    fitting = Fitting.moving(knob, Revolute("turn", axis=Y, limits=(0, 2)))
    made = asset(panel().install(fitting, at=(0.03, 0.0, 0.0)).install(fitting.suffixed("_1")))
    assert [link.name for link in made.links] == ["panel", "knob", "knob_1"]
    assert len(made.link("panel").pieces) == 1


def test_a_fitting_turns_and_has_an_image():
    turned = button().rotate(Z, np.pi / 2)  # on the face that faces +x
    made = asset(part(box(0.02, 0.1, 0.1).at(-0.01), "panel", ABS).install(turned, at=(0.0, 0.01, 0.0)))
    assert made.joint("slide").axis == pytest.approx([-1.0, 0.0, 0.0])
    assert made.certify().proven
    image = asset(panel().install(button().at(0.02).mirror(X)))
    assert image.joint("slide").pivot == pytest.approx([-0.02, 0.0, 0.0])


def test_a_cut_removes_contained_pieces_and_refuses_to_remove_all():
    lamp = part(box(0.01, 0.01, 0.01), "lamp", ABS)
    body = evaluate(weld(panel(), lamp.at(y=0.006)).cut(box(0.02, 0.02, 0.02).at(y=0.006))).value
    assert [piece.label for piece in body.link.pieces] == ["panel"]
    with pytest.raises(EvaluationError, match="nothing is left of 'panel'"):
        evaluate(panel().cut(box(1, 1, 1)))


def test_attach_at_moves_child_and_pivot_together():
    dial = part(cylinder(0.01, 0.01, axis=Y).at(y=-0.006), "dial", ABS)
    turn = Revolute("turn", axis=Y, limits=(0, 2))
    moved = asset(panel().attach(dial, turn, at=(0.02, 0.0, 0.01)))
    apart = asset(
        panel().attach(
            dial.at(0.02, 0.0, 0.01), Revolute("turn", axis=Y, pivot=(0.02, 0, 0.01), limits=(0, 2))
        )
    )
    assert moved.to_json() == apart.to_json()


def test_a_pair_has_mirrored_links_and_joints():
    leaf = part(box(0.04, 0.005, 0.05).at(0.025, -0.004), "leaf", ABS)
    hinge = Revolute("hinge", axis=Z, pivot=(0.045, -0.0065, 0), limits=(0, 1.5))
    made = asset(panel().attach_pair(leaf, hinge))
    right, left = made.joint("hinge_right"), made.joint("hinge_left")
    assert right.pivot == pytest.approx([0.045, -0.0065, 0.0])
    assert left.pivot == pytest.approx([-0.045, -0.0065, 0.0])
    assert left.axis == pytest.approx(-right.axis)
    assert made.certify().proven
    with pytest.raises(EvaluationError, match="attach_pair needs at least one joint"):
        evaluate(panel().attach_pair(leaf))


def test_several_solids_make_one_part_with_the_grasps_on_the_first():
    bar, foot = box(0.1, 0.01, 0.01), box(0.01, 0.03, 0.01).at(y=0.015)
    both = evaluate(part([bar, foot], "handle", ABS, grasp=artgen.grasp_on(bar))).value.link
    assert [piece.label for piece in both.pieces] == ["handle", "handle"]
    assert both.grasps[0].width == pytest.approx(0.02)
    print_ = evaluate(detail([bar.at(z=1), foot], "print", ABS, reads=X)).value.link
    assert print_.pieces[0].reading.about[2] == pytest.approx(0.5025, abs=0.01)


def test_a_spring_by_its_forces_has_their_stiffness_and_rest():
    joint = evaluate(
        Prismatic("slide", axis=Y, limits=(0, 0.003), spring=Spring(preload=0.6, force=3.0), feel=feel.SWITCH)
    ).value
    assert joint.stiffness * (0.003 - joint.rest) == pytest.approx(3.0)
    assert joint.stiffness * (0.0 - joint.rest) == pytest.approx(0.6)
    assert (joint.damping, joint.friction, joint.effort) == (6.0, 0.1, 12.0)
    firm = evaluate(Prismatic("slide", axis=Y, limits=(0, 0.1), feel=feel.SWITCH, friction=0.4)).value
    assert (firm.friction, firm.armature, firm.velocity) == (0.4, 0.03, 1.0)


def test_a_spring_takes_values_that_are_not_known_yet():
    stiffness = Float.parameter("stiffness")
    joint = Prismatic("slide", axis=Y, limits=(0, 0.1), spring=Spring(stiffness=stiffness, rest=-0.01))
    made = evaluate(joint, {"stiffness": 40.0}).value
    assert (made.stiffness, made.rest) == (40.0, -0.01)


@pytest.mark.parametrize(
    ("given", "got"),
    [
        ({}, "neither"),
        ({"preload": 1.0}, "preload"),
        ({"preload": 1, "stiffness": 3}, "preload and stiffness"),
        ({"preload": 1.0, "force": 2.0, "stiffness": 3.0}, "preload and force and stiffness"),
    ],
)
def test_a_spring_is_given_in_one_way(given, got):
    words = f"forces at both limits or a stiffness, got {got}; preload and force exclude stiffness and rest"
    with pytest.raises(BuildError, match=words):
        Spring(**given)


@pytest.mark.parametrize(("preload", "force"), [(3, 1), (2.0, 2.0), (Float(3.0), 1)])
def test_the_force_of_a_spring_grows(preload, force):
    words = (
        r"Spring\(preload=\d, force=\d\) has no stiffness: force, at the upper limit, must be above preload"
    )
    with pytest.raises(BuildError, match=words):
        Spring(preload=preload, force=force)


def test_a_spring_whose_drawn_force_does_not_grow_is_refused():
    spring = Spring(preload=3.0, force=Float.parameter("force"))
    joint = Prismatic("slide", axis=Y, limits=(0, 0.1), spring=spring)
    words = "stiffness -20 must not be negative; the force of a Spring must be above its preload"
    with pytest.raises(EvaluationError, match=words):
        evaluate(joint, {"force": 1.0})


def test_a_joint_without_limits_has_no_forces_at_them():
    with pytest.raises(BuildError, match="a joint without limits has no forces at its limits"):
        Revolute("turn", axis=Z, spring=Spring(preload=1.0, force=2.0))


@pytest.mark.parametrize(
    "name", [name for name in feel.__all__ if isinstance(getattr(feel, name), feel.Feel)]
)
def test_presets_of_feel_make_joints(name):
    preset = getattr(feel, name)
    joint = evaluate(Revolute("turn", axis=Z, limits=(0, 1), feel=preset)).value
    assert (joint.damping, joint.friction) == (preset.damping, preset.friction)
    assert joint.effort > joint.friction
