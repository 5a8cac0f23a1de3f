"""Contacts by design: which links they name, how they follow copies, and what is refused."""

import pytest

from artgen.asset import AllowedContact, Asset, Branch, Tree
from artgen.asset import AssetCondition as Condition
from artgen.errors import AssetError, BuildError, EvaluationError
from artgen.generator import generator
from artgen.graph import evaluate
from artgen.materials import material
from artgen.nodes.body import detail, part, weld
from artgen.nodes.handles import Body, Float
from artgen.nodes.joint import Prismatic, Revolute
from artgen.nodes.primitive import box
from artgen.nodes.vector import X, Z
from artgen.sampling import uniform
from support.lines import place_of

OAK, RUBBER = material("oak"), material("rubber")
hinge = Revolute("hinge", axis=Z, limits=(0.0, 1.0))
WHY = "the gasket is squeezed"


def block(label="block", **options):
    return part(box(0.1, 0.1, 0.1), label, OAK, **options)


def fridge(*, name="door", joint=hinge):
    """A body with a door, which carries a gasket and a print that is only seen."""
    gasket = part(box(0.1, 0.01, 0.1).at(0, 0.05), "gasket", RUBBER)
    print_ = detail(box(0.1, 0.001, 0.1), "print", RUBBER)
    door = weld(block("leaf", name=name), gasket, print_)
    return block("body").attach(door, joint)


def contacts(handle, **parameters):
    return tuple(evaluate(handle, parameters).value.all_contacts())


def links(handle):
    return [contact.links for contact in contacts(handle)]


def asset(handle):
    return Asset.from_tree(evaluate(handle).value, "made", "test")


def test_a_contact_names_links_labels_depth_region_and_reason():
    made = fridge().allow_contact("gasket", "body", depth=0.0012, when=hinge < 0.02, reason=f" {WHY}\n")
    (contact,) = contacts(made)
    below = Condition("below", "hinge", 0.02)
    assert contact == AllowedContact(("door", "body"), ("gasket", "body"), 0.0012, WHY, below)
    assert asset(made).contacts == (contact,)
    assert str(contact) == f"door/gasket may press 1.2 mm into body/body where hinge < 0.02: {WHY}"


def test_depth_and_region_may_be_drawn():
    depth, angle = Float.parameter("depth"), Float.parameter("angle")
    made = fridge().allow_contact("gasket", "body", depth=depth, when=hinge < 2.0 * angle, reason=WHY)
    (contact,) = contacts(made, depth=0.002, angle=0.03)
    assert (contact.depth, contact.when) == (0.002, Condition("below", "hinge", 0.06))


def test_an_order_of_declarations_is_kept():
    made = fridge().allow_contact("leaf", "body", depth=0, reason="one")
    made = made.allow_contact("body", "gasket", depth=0, reason="two")
    assert [contact.reason for contact in contacts(made)] == ["one", "two"]
    assert links(made) == [("door", "body"), ("body", "door")]


def test_a_label_on_several_links_means_all_of_them():
    body = block("body")
    for name in ("left", "right"):
        body = body.attach(block("leaf", name=name), Revolute(f"{name}_hinge", axis=Z, limits=(0, 1)))
    every = body.allow_contact("leaf", "body", depth=0, reason=WHY)
    assert links(every) == [("left", "body"), ("right", "body")]
    one = body.allow_contact("right/leaf", "body", depth=0, reason=WHY)
    assert links(one) == [("right", "body")]
    leaves = body.allow_contact("leaf", "leaf", depth=0, reason="an astragal")
    assert links(leaves) == [("left", "right")]


def test_the_function_is_the_method():
    made = fridge().allow_contact("gasket", "body", depth=0.001, when=hinge < 0.1, reason=WHY)
    method = fridge().allow_contact("gasket", "body", depth=0.001, when=hinge < 0.1, reason=WHY)
    assert made.node.key == method.node.key


@pytest.mark.parametrize(
    "move",
    [
        lambda body: body.at(1.0, 0.0, 0.0),
        lambda body: body.rotate(X, 0.5),
        lambda body: body.mirror(X),
        lambda body: body.attach(block("foot"), Prismatic("slide", axis=Z, limits=(0, 0.1))),
        lambda body: weld(body, part(box(0.2, 0.2, 0.01), "plate", OAK)),
        lambda body: body.repeat(
            block("foot"), Prismatic("slide", axis=Z, limits=(0, 0.1)), at=[(0, 0, 0), (1, 0, 0)]
        ),
    ],
)
def test_contacts_come_along(move):
    made = fridge().allow_contact("gasket", "body", depth=0.001, when=hinge < 0.1, reason=WHY)
    assert contacts(move(made)) == contacts(made)
    assert asset(move(made)).contacts == contacts(made)


def test_names_of_moved_links_are_found_without_moving_their_pieces():
    made = fridge().at(1.0, 0.0, 0.0).suffixed("_left")
    tree = evaluate(made.allow_contact("gasket", "body", depth=0, reason=WHY)).value
    assert [contact.links for contact in tree.contacts] == [("door_left", "body_left")]
    assert all("_moved" not in vars(link.pieces) for link in tree.links())


def test_a_suffix_renames_links_and_joints():
    made = fridge().allow_contact("gasket", "body", depth=0.001, when=hinge < 0.1, reason=WHY)
    (contact,) = contacts(made.suffixed("_left"))
    assert contact.links == ("door_left", "body_left")
    assert contact.labels == ("gasket", "body")
    assert contact.when == Condition("below", "hinge_left", 0.1)


def test_each_copy_has_contacts_of_its_own():
    made = fridge().allow_contact("gasket", "body", depth=0.001, when=hinge < 0.1, reason=WHY)
    slide = Prismatic("slide", axis=X, limits=(0.0, 0.1))
    rack = asset(block("rack").repeat(made, slide, at=[(0, 0, 0), (1, 0, 0)]))
    assert [contact.links for contact in rack.contacts] == [("door_0", "body_0"), ("door_1", "body_1")]
    assert [contact.when.joint for contact in rack.contacts] == ["hinge_0", "hinge_1"]


def test_welded_links_take_the_name_of_the_first():
    first = block("shell").attach(block("body", name="inner"), Revolute("turn", axis=Z, limits=(0, 1)))
    first = first.allow_contact("shell", "body", depth=0, reason="first")
    second = fridge().allow_contact("gasket", "body", depth=0.001, reason="second")
    made = weld(first, second)
    assert links(made) == [("shell", "inner"), ("door", "shell")]
    assert asset(made).contacts == contacts(made)


def test_welding_renames_the_welded_link_only():
    # the link that is welded on has the name of a link which the first body carries on a joint
    first = block("shell").attach(block("leaf", name="body"), Revolute("turn", axis=Z, limits=(0, 1)))
    first = first.allow_contact("leaf", "shell", depth=0, reason="first")
    second = fridge().allow_contact("gasket", "body", depth=0.001, reason="second")
    assert links(weld(first, second)) == [("body", "shell"), ("door", "shell")]


REFUSED = [
    ({"a": "gaskett"}, "no solid of this body is labelled 'gaskett'. Did you mean 'gasket'?"),
    ({"a": "print"}, "no solid of this body is labelled 'print'. Allowed: body, gasket, leaf."),
    ({"a": "dor/gasket"}, "'dor/gasket': this body has no link 'dor'. Did you mean 'door'?"),
    ({"b": "door/body"}, "'door/body': link 'door' has no solid labelled 'body'. Allowed: gasket, leaf."),
    (
        {"a": "door"},
        "'door' is a link, and contacts are declared per labelled piece; write 'door/leaf' or 'door/gasket'",
    ),
    (
        {"b": "leaf"},
        (
            "'gasket' and 'leaf' are both on link 'door' and on no other; "
            "pieces of one link never move against each other: name pieces of two links"
        ),
    ),
    ({"depth": -0.001}, "depth must not be negative, got -0.001 m; 0 allows them to touch"),
]


@pytest.mark.parametrize(("wrong", "message"), REFUSED)
def test_what_cannot_be_a_contact_is_refused_with_its_line(wrong, message):
    given = {"a": "gasket", "b": "body", "depth": 0.001, "reason": WHY} | wrong
    made = fridge().allow_contact(given.pop("a"), given.pop("b"), **given)  # marker: refused
    with pytest.raises(EvaluationError) as caught:
        evaluate(made)
    assert (
        str(caught.value) == f"allow_contact failed: {message}\n  at {place_of(__file__, 'marker: refused')}"
    )


@pytest.mark.parametrize("given", [{}, {"reason": ""}, {"reason": " \n"}, {"reason": None}])
def test_a_contact_needs_a_reason(given):
    with pytest.raises(BuildError) as caught:
        fridge().allow_contact("gasket", "body", depth=0.001, **given)  # marker: no reason
    assert "allow_contact('gasket', 'body') gives no reason" in str(caught.value)
    assert f"\n  at {place_of(__file__, 'marker: no reason')}\n" in str(caught.value)
    assert 'reason="' in str(caught.value)


def test_a_recorded_contact_needs_a_reason_too():
    recorded = Body.record(
        "allow_contact", body=fridge(), a="gasket", b="body", depth=0.0, reason=" ", when=None
    )
    with pytest.raises(EvaluationError, match="the contact of 'gasket' with 'body' has no reason"):
        evaluate(recorded)


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"when": (hinge < 0.1).until(0.2)}, "allow_contact(..., when=...) needs a Condition or None"),
        ({"depth": "1 mm"}, "allow_contact(..., depth=...) needs a Float, got '1 mm'"),
        ({"reason": 3}, "allow_contact(..., reason=...) needs a str, got 3"),
    ],
)
def test_other_types_are_refused(wrong, message):
    with pytest.raises(BuildError) as caught:
        fridge().allow_contact("gasket", "body", **({"depth": 0.001, "reason": WHY} | wrong))
    assert message in str(caught.value)


def with_drawer(when):
    drawer = Prismatic("drawer", axis=X, limits=(0.0, 0.1))
    made = fridge().attach(block("tray"), drawer)
    return made.allow_contact("gasket", "body", depth=0.001, when=when, reason=WHY)


@pytest.mark.parametrize(
    ("joint", "message"),
    [
        ("hing", "but 'hing' is not a joint of this asset. Did you mean 'hinge'? Between them are: hinge."),
        ("drawer", "but 'drawer' does not move one against the other. Between them are: hinge."),
    ],
)
def test_a_region_speaks_of_joints_between_the_links(joint, message):
    other = Prismatic(joint, axis=X, limits=(0.0, 0.1))
    with pytest.raises(AssetError) as caught:
        asset(with_drawer((hinge < 0.1) & (other < 0.25)))
    assert "the contact of door/gasket with body/body is allowed where (hinge < 0.1) & (" in str(caught.value)
    assert message in str(caught.value)
    assert caught.value.joint == joint


def test_a_joint_above_both_links_moves_neither_against_the_other():
    made = block("cart").attach(
        fridge().allow_contact("gasket", "body", depth=0, when=Revolute("roll", axis=X) < 1.0, reason=WHY),
        Revolute("roll", axis=X, limits=(0.0, 2.0)),
    )
    with pytest.raises(AssetError, match="'roll' does not move one against the other"):
        asset(made)


def test_links_that_touch_through_their_parent_may_speak_of_both_joints():
    body = block("body")
    joints = [Revolute(f"{name}_hinge", axis=Z, limits=(0, 1)) for name in ("left", "right")]
    for name, joint in zip(("left", "right"), joints, strict=True):
        body = body.attach(block("leaf", name=name), joint)
    made = body.allow_contact(
        "leaf", "leaf", depth=0, when=(joints[0] < 0.1) & (joints[1] < 0.1), reason="an astragal"
    )
    assert len(asset(made).contacts) == 1


def test_a_leader_moves_what_its_followers_carry():
    pedal = Revolute("pedal", axis=X, limits=(0.0, 0.3))
    lid = Revolute("hinge", axis=Z, follows=2.0 * pedal)
    made = fridge(joint=lid).attach(block("arm"), pedal)
    made = made.allow_contact("gasket", "body", depth=0.001, when=pedal < 0.01, reason=WHY)
    assert len(asset(made).contacts) == 1


def test_a_generator_names_the_line_of_a_wrong_region():
    @generator
    def cupboard(*, width: Float = uniform(0.1, 0.2, "m")) -> Body:
        other = Revolute("hinges", axis=X, limits=(0.0, 0.1))
        made = fridge()
        made = made.allow_contact("leaf", "body", depth=width, when=hinge < 0.1, reason=WHY)
        return made.allow_contact("gasket", "body", depth=0, when=other < 0.1, reason=WHY)  # marker: region

    with pytest.raises(AssetError) as caught:
        cupboard.generate(0)
    assert f"\n  at {place_of(__file__, 'marker: region')}" in str(caught.value)


def test_a_tree_made_by_hand_is_held_to_its_joints():
    tree = evaluate(fridge()).value
    stray = AllowedContact(("door", "body"), ("leaf", "body"), 0.0, WHY, Condition("below", "lid", 0.1))
    nested = Tree(tree.link, tuple(Branch(each.joints, each.tree) for each in tree.branches), (stray,))
    with pytest.raises(AssetError, match="'lid' is not a joint of this asset"):
        Asset.from_tree(nested, "made", "test")
    astray = AllowedContact(("lid", "body"), ("leaf", "body"), 0.0, WHY)
    with pytest.raises(AssetError, match="a contact names the link 'lid', which is not a link of this asset"):
        Asset.from_tree(Tree(tree.link, tree.branches, (astray,)), "made", "test")


def test_contacts_are_written_and_read_back(tmp_path):
    made = fridge().allow_contact("gasket", "body", depth=0.0012, when=hinge < 0.02, reason=WHY)
    made = asset(made.allow_contact("leaf", "body", depth=0, reason="they touch"))
    loaded = Asset.load(made.export(tmp_path / "made", formats=("urdf",)))
    assert loaded.contacts == made.contacts
    assert loaded.to_data()["contacts"] == [contact.to_data() for contact in made.contacts]


def test_an_asset_of_before_there_were_contacts_has_none(tmp_path):
    made = asset(fridge())
    path = tmp_path / "asset.json"
    data = made.to_json()
    assert '"contacts": []' in data
    path.write_text(data.replace('"contacts": []', '"later": []'))
    assert Asset.load(path).contacts == ()
