"""Bodies: parts, welds, joints between them, copies and motions."""

import numpy as np
import pytest

from artgen.asset import Asset
from artgen.errors import AssetError, BuildError, EvaluationError
from artgen.graph import evaluate
from artgen.materials import material
from artgen.nodes.body import detail, part, weld
from artgen.nodes.fitting import Fitting
from artgen.nodes.grasp_frames import frame
from artgen.nodes.handles import Body, Float
from artgen.nodes.joint import Prismatic, Revolute
from artgen.nodes.primitive import box, cylinder
from artgen.nodes.vector import X, Y, Z, ring_points, row
from support.lines import place_of

OAK, STEEL, GLASS = material("oak"), material("steel"), material("glass")


def block(label="block", **options):
    return part(box(0.1, 0.1, 0.1), label, OAK, **options)


def turn(name="turn", **options):
    return Revolute(name, **{"axis": Z, "limits": (0.0, 1.0)} | options)


def value(handle, **parameters):
    return evaluate(handle, parameters).value


def asset(body, **parameters):
    return Asset.from_tree(value(body, **parameters), "made", "test")


def test_a_part_is_one_link_with_mass():
    link = value(part(box(1.0, 0.5, 0.1), "leaf", OAK, name="left_leaf")).link
    assert (link.name, link.label, link.labels) == ("left_leaf", "leaf", ("leaf",))
    assert link.mass_properties.mass == pytest.approx(0.05 * OAK.density)


@pytest.mark.parametrize("suffix", ["-1", " x"])
def test_a_suffix_that_cannot_end_a_name_is_refused(suffix):
    words = f"suffix {suffix!r} cannot end a name; use letters, digits and _, at most 100, such as '_left'"
    with pytest.raises(BuildError, match=words):
        block().suffixed(suffix)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: block("my leaf"), "label 'my leaf' is no identifier; use letters, digits and _"),
        (lambda: block(""), "label '' is no identifier"),
        (lambda: block("leaf", name="1st"), "link name '1st' is no identifier"),
        (lambda: block(name="world"), "link name 'world' is the fixed frame in MJCF and URDF; use another"),
        (lambda: block("leaf", grasp_width=0.0), "grasp_width must be positive, got 0 m"),
        (lambda: detail(box(1.0, 1.0, 1.0), "a b", OAK), "label 'a b' is no identifier"),
        (weld, "weld needs at least one body"),
        (lambda: block("a").attach(block("b")), "attach needs at least one joint; weld joins bodies rigidly"),
        (lambda: block("a").repeat(block("b"), at=[(0, 0, 0)]), "repeat needs at least one joint"),
        (lambda: block().rotate((0, 0, 0), 1.0), "a vector of length zero has no direction"),
    ],
)
def test_impossible_bodies_are_refused(make, message):
    with pytest.raises(EvaluationError) as caught:
        value(make())
    assert message in str(caught.value)
    assert f"\n  at {__file__}:" in str(caught.value)


def test_a_label_twice_says_how_to_mend_it():
    body = block("base").attach(block("door"), turn("left"))
    body = body.attach(block("door"), turn("right"))  # marker: twice
    with pytest.raises(EvaluationError) as caught:
        value(body)
    assert (
        "the link name 'door' is used twice; give one part(...) another label, or the same label and a name"
        in str(caught.value)
    )
    assert place_of(__file__, "marker: twice") in str(caught.value)


def test_the_same_label_with_another_name_is_fine():
    body = block("base").attach(block("door"), turn("left"))
    made = asset(body.attach(block("door", name="door_right"), turn("right")))
    assert [link.name for link in made.links] == ["base", "door", "door_right"]
    assert [link.label for link in made.links] == ["base", "door", "door"]


def test_a_joint_name_twice_says_how_to_mend_it():
    body = block("base").attach(block("a"), turn("hinge")).attach(block("b"), turn("hinge"))
    with pytest.raises(
        EvaluationError, match="the joint name 'hinge' is used twice; give one joint another name"
    ):
        value(body)


def test_a_grasp_name_twice_says_how_to_mend_it():
    grasp = frame((0, 0, 0))
    with pytest.raises(
        EvaluationError, match=r"grasp name 'a_grasp' is used twice; .* a name of its own \(name=...\)"
    ):
        value(weld(block("a", grasp=grasp), block("a", grasp=grasp)))
    assert value(weld(block("a", grasp=grasp), block("a", name="b", grasp=grasp)))


def test_welded_solids_stay_apart_but_make_one_link():
    made = value(
        weld(part(box(1.0, 1.0, 1.0), "case", STEEL), part(box(0.5, 2.0, 0.1).at(2.0), "pane", GLASS))
    )
    assert made.link.name == "case"
    assert made.link.labels == ("case", "pane")
    assert [piece.material.name for piece in made.link.pieces] == ["steel", "glass"]


def test_where_welded_solids_overlap_the_volume_counts_once():
    # two unit cubes that share half of their volume, and a third inside the first
    first, second = part(box(1.0, 1.0, 1.0), "a", STEEL), part(box(1.0, 1.0, 1.0).at(0.5), "b", OAK)
    inside = part(box(0.2, 0.2, 0.2), "c", GLASS)
    properties = value(weld(first, second, inside)).link.mass_properties
    assert properties.mass == pytest.approx(STEEL.density + 0.5 * OAK.density)
    center = 0.5 * OAK.density * 0.75 / properties.mass
    assert properties.center == pytest.approx([center, 0.0, 0.0])


def test_welding_in_another_order_gives_the_overlap_to_another():
    first, second = part(box(1.0, 1.0, 1.0), "a", STEEL), part(box(1.0, 1.0, 1.0).at(0.5), "b", OAK)
    assert value(weld(second, first)).link.mass_properties.mass == pytest.approx(
        OAK.density + 0.5 * STEEL.density
    )


def test_a_weld_keeps_what_is_joined_to_its_bodies():
    first = block("a").attach(block("x"), turn("t1"))
    second = block("b").attach(block("y"), turn("t2"))
    made = asset(weld(first, second))
    assert [link.name for link in made.links] == ["a", "x", "y"]
    assert [(joint.parent, joint.child) for joint in made.joints] == [("a", "x"), ("a", "y")]


def test_details_are_seen_but_have_neither_mass_nor_collider():
    plain = value(part(box(1.0, 1.0, 1.0), "case", STEEL)).link
    seen = value(
        weld(part(box(1.0, 1.0, 1.0), "case", STEEL), detail(box(9.0, 9.0, 9.0), "print", GLASS))
    ).link
    assert seen.mass_properties.mass == plain.mass_properties.mass
    assert len(seen.colliders) == len(plain.colliders)
    assert "glass" in {surface.material.name for surface in seen.surfaces}


def test_a_link_of_details_only_is_refused():
    body = block().attach(detail(box(1.0, 1.0, 1.0), "print", GLASS), turn())
    with pytest.raises(
        AssetError, match="link 'print' consists of details only, which have no mass; weld them"
    ):
        asset(body)


def test_grasps_go_along_with_their_part():
    grasp = frame((0.5, 0, 0), approach=(0, 2, 0), closing=(0, 1, 1))
    body = part(box(1.0, 1.0, 1.0), "bar", OAK, grasp=grasp, grasp_width=0.05)
    (made,) = value(body).link.grasps
    assert (made.name, made.width) == ("bar_grasp", 0.05)
    assert made.frame[:3, 2] == pytest.approx([0, 1, 0])
    assert made.frame[:3, 0] == pytest.approx([0, 0, 1])
    assert made.frame[:3, 3] == pytest.approx([0.5, 0, 0])
    (turned,) = value(body.rotate(Z, np.pi / 2).at(0, 0, 1)).link.grasps
    assert turned.frame[:3, 3] == pytest.approx([0, 0.5, 1])
    assert turned.frame[:3, 2] == pytest.approx([-1, 0, 0])
    (mirrored,) = value(body.mirror(X)).link.grasps
    assert mirrored.frame[:3, 3] == pytest.approx([-0.5, 0, 0])
    assert np.linalg.det(mirrored.frame[:3, :3]) == pytest.approx(1.0)


def test_several_grasps_are_numbered():
    body = block("bar", grasp=(frame((0, 0, 0)), frame((1, 0, 0))))
    assert [grasp.name for grasp in value(body.suffixed("_a")).link.grasps] == [
        "bar_grasp_0_a",
        "bar_grasp_1_a",
    ]


def test_a_grasp_needs_two_directions():
    with pytest.raises(EvaluationError, match="must lie across the approach"):
        value(block(grasp=frame((0, 0, 0), approach=Y, closing=Y)))


def test_several_joints_between_one_pair_act_in_order():
    slide = Prismatic("slide", axis=X, limits=(0.0, 1.0))
    made = asset(block("base").attach(block("dial"), slide, turn("spin", pivot=(1, 0, 0))))
    assert [(joint.parent, joint.child) for joint in made.joints] == [("base", "dial")] * 2
    moved = made.pose({"slide": 0.5, "spin": 1.0})["dial"] @ np.array([2.0, 0.0, 0.0, 1.0])
    # the slide is nearer to the base: it carries the axis of the turn along
    assert moved[:3] == pytest.approx([0.5 + 1 + np.cos(1.0), np.sin(1.0), 0.0])


def test_children_move_with_their_parents():
    arm = block("arm").attach(block("hand"), turn("wrist", pivot=(1, 0, 0)))
    made = asset(block("base").attach(arm, turn("shoulder")))
    pose = made.pose({"shoulder": np.pi / 4})
    assert pose["hand"] == pytest.approx(pose["arm"])
    assert made.pose()["hand"] == pytest.approx(np.eye(4))


def test_repeat_makes_a_suffixed_copy_at_each_point():
    body = block("panel").repeat(
        block("knob"), turn("spin", pivot=(0, 0, 1)), at=row((0, 0, 0), (2, 0, 0), 3)
    )
    made = asset(body)
    assert [link.name for link in made.links] == ["panel", "knob_0", "knob_1", "knob_2"]
    assert {link.label for link in made.links[1:]} == {"knob"}
    assert [joint.name for joint in made.joints] == ["spin_0", "spin_1", "spin_2"]
    assert made.joint("spin_2").pivot.tolist() == [4, 0, 1]
    assert made.link("knob_1").bounds().mean(axis=0) == pytest.approx([2, 0, 0])


def test_repeat_renames_references_within_the_copy_and_no_others():
    outside = turn("main")
    button = Prismatic("press", axis=Z, limits=(0, 0.01), needs=outside > 0.5)
    latch = Revolute("latch", axis=Z, follows=2 * button)
    child = block("button").attach(block("latch"), latch)
    body = block("panel").attach(block("door"), outside).repeat(child, button, at=row((0, 0, 0), X, 2))
    made = asset(body)
    assert made.joint("latch_1").follows.leader == "press_1"
    assert made.joint("press_1").needs.condition.joints() == ("main",)


def test_repeats_within_repeats():
    key = block("key")
    line = block("line").repeat(key, turn("press"), at=row((0, 0, 0), X, 2))
    made = asset(block("panel").repeat(line, turn("fold"), at=row((0, 0, 0), Y, 2)))
    assert [link.name for link in made.links] == [
        "panel", "line_0", "key_0_0", "key_1_0", "line_1", "key_0_1", "key_1_1",
    ]  # fmt: skip


def test_repeat_is_one_node_and_the_child_is_made_once():
    body = block("panel").repeat(
        part(box(Float.parameter("a"), 1.0, 1.0), "key", OAK), turn(), at=row(X, Y, 20)
    )
    result = evaluate(body, {"a": 1.0})
    assert (result.runs["box"], result.runs["repeat"]) == (2, 1)


def motion_of(body, move):
    """Return where the tip of the link `door` goes, before and after `move` is applied to the body."""
    tip = np.array([0.3, -0.2, 0.7, 1.0])
    still, moved = asset(body), asset(move(body))
    q = {"hinge": 0.6, "slide": 0.2}
    return still.pose(q)["door"] @ tip, moved.pose(q)["door"], tip


MOVES = {
    "mirror": (lambda body: body.mirror((1, 2, 0)), None),
    "rotate": (lambda body: body.rotate((1, 1, 0), 0.7, about=(0, 0, 1)), None),
    "at": (lambda body: body.at(1, 2, 3), None),
}


@pytest.mark.parametrize("name", MOVES)
def test_a_moved_body_moves_like_its_image(name):
    move = MOVES[name][0]
    hinge = turn("hinge", axis=(0, 1, 1), pivot=(1, 0, 0.5))
    body = block("base").attach(block("door"), Prismatic("slide", axis=(1, 0, 2), limits=(0, 1)), hinge)
    # the map itself, from the images of four points of a part that is carried along
    corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
    grasps = part(box(0.1, 0.1, 0.1), "mark", OAK, grasp=[frame(corner) for corner in corners])
    images = np.array([grasp.frame[:3, 3] for grasp in value(move(grasps)).link.grasps])
    matrix = np.eye(4)
    matrix[:3, :3] = (images[1:] - images[0]).T
    matrix[:3, 3] = images[0]
    goes, pose, tip = motion_of(body, move)
    assert pose @ (matrix @ tip) == pytest.approx(matrix @ goes)


def test_a_mirrored_hinge_turns_the_other_way():
    hinge = turn("hinge", pivot=(1, 0, 0))
    mirrored = asset(block("base").attach(block("door"), hinge).mirror(X)).joint("hinge")
    assert mirrored.axis.tolist() == [0, 0, -1]
    assert mirrored.pivot.tolist() == [-1, 0, 0]
    slide = Prismatic("slide", axis=X, limits=(0, 1))
    assert asset(block("base").attach(block("box"), slide).mirror(X)).joint("slide").axis.tolist() == [
        -1,
        0,
        0,
    ]


def test_suffixes_reach_links_joints_and_grasps():
    body = block("a", grasp=frame((0, 0, 0))).attach(block("b"), turn("t"))
    made = asset(body.suffixed("_left"))
    assert [link.name for link in made.links] == ["a_left", "b_left"]
    assert made.joints[0].name == "t_left"
    assert made.links[0].grasps[0].name == "a_grasp_left"
    assert made.links[0].label == "a"


def test_methods_record_the_operations():
    a, b, t, at = block("a"), block("b"), turn(), row(X, Y, 2)
    assert (
        Body.record("attach", parent=a, child=b, joints=(t,), at=(0.0, 0.0, 0.0)).node.key
        == a.attach(b, t).node.key
    )
    assert (
        Body.record("repeat", parent=a, child=b, joints=(t,), at=at, around=None).node.key
        == a.repeat(b, t, at=at).node.key
    )


def test_bodies_do_not_combine_like_solids():
    with pytest.raises(BuildError, match=r"bodies have no \|.*weld\(a, b\) joins bodies"):
        block("a") | block("b")
    with pytest.raises(BuildError, match=r"weld\(..., bodies=...\) needs a Body, got a Solid handle"):
        weld(block("a"), box(1.0, 1.0, 1.0))


def test_repeat_turns_copies_with_their_joints_around_an_axis() -> None:
    arm = part(box(0.1, 0.02, 0.02).at(x=0.06), "arm", OAK)
    hinge = Revolute("hinge", axis=X, pivot=(0.02, 0, 0), limits=(0, 1))
    tree = value(block("hub").repeat(arm, hinge, at=ring_points((0, 0, 1), 0.5, count=4), around=Z))
    second = tree.branches[1]
    np.testing.assert_allclose(second.joints[0].axis, (0, 1, 0), atol=1e-12)
    np.testing.assert_allclose(second.joints[0].pivot, (0, 0.52, 1), atol=1e-12)
    bounds = second.tree.link.pieces[0].shape.bounds()
    np.testing.assert_allclose(bounds, [(-0.01, 0.51, 0.99), (0.01, 0.61, 1.01)], atol=1e-9)
    assert [branch.tree.link.name for branch in tree.branches] == [f"arm_{index}" for index in range(4)]


def test_repeat_takes_a_fitting_with_its_joints_and_holes() -> None:
    board = part(box(0.4, 0.4, 0.02), "board", OAK)
    pin = part(cylinder(0.004, 0.02, axis=Z).at(z=0.015), "pin", OAK)
    slide = Prismatic("slide", axis=Z, limits=(0, 0.01))
    fitting = Fitting.moving(pin, slide, cut=cylinder(0.005, 0.03))
    tree = value(board.repeat(fitting, at=ring_points((0, 0, 0), 0.1, count=3), around=Z))
    assert [joint.name for joint in tree.joints()] == ["slide_0", "slide_1", "slide_2"]
    hole = 0.4 * 0.4 * 0.02 - tree.link.pieces[0].shape.manifold.volume()
    assert hole == pytest.approx(3 * np.pi * 0.005**2 * 0.02, rel=0.05)
    with pytest.raises(BuildError, match="a fitting has its own joints; leave joints out"):
        board.repeat(fitting, slide, at=[(0, 0, 0)])


def test_copies_on_the_axis_of_the_turn_have_no_direction() -> None:
    with pytest.raises(EvaluationError, match=r"point 1 of at= lies on the axis around="):
        value(block("a").repeat(block("b"), turn("c"), at=[(1, 0, 0), (0, 0, 0), (-1, 0, 0)], around=Z))


NAMED = [("drawer", "drawer"), ("drawer_2", "drawer"), ("tray", "handle")]


@pytest.mark.parametrize(("name", "label"), NAMED)
def test_a_link_has_the_label_of_its_name_if_one_of_its_solids_has_it(name: str, label: str) -> None:
    steel = material("steel")
    handle = part(box(0.1, 0.02, 0.02), "handle", steel, name=name)
    made = asset(weld(handle, part(box(0.3, 0.3, 0.1).at(y=0.15), "drawer", steel)))
    link = made.links[0]
    assert (link.name, link.label) == (name, label)
    assert link.labels == tuple(dict.fromkeys((label, "handle", "drawer")))
