"""The joints of a body, read from its graph."""

import pytest

from artgen import Body, Graph, Prismatic, Revolute, X, Z, box, material, part, row, weld
from artgen.errors import BuildError
from artgen.generator import category
from artgen.nodes.vector import points
from support.joint_outline import PlannedJoint, joints_of

OAK = material("oak")


def block(name: str) -> Body:
    return part(box(0.1, 0.1, 0.1), name, OAK)


def names(body: Body) -> list[str]:
    return [joint.name for joint in joints_of(Graph(body))]


def test_joints_come_in_order_from_the_base_with_what_they_can_do() -> None:
    hinge = Revolute("lid_hinge", axis=X, limits=(0.0, 1.0))
    spin = Revolute("knob_turn", axis=Z, limits=None)
    rod = Prismatic("rod_slide", axis=Z, follows=0.02 * hinge + 0.1)
    lock = Prismatic("lock_slide", axis=X, limits=(0.0, 0.01), needs=hinge > 0.5)
    lid = block("lid").attach(block("knob"), spin)
    body = block("body").attach(lid, hinge).attach(block("rod"), rod).attach(block("lock"), lock)
    assert joints_of(Graph(body)) == (
        PlannedJoint("lid_hinge", "revolute", unlimited=False, follows="", needs=False),
        PlannedJoint("knob_turn", "revolute", unlimited=True, follows="", needs=False),
        PlannedJoint("rod_slide", "prismatic", unlimited=False, follows="lid_hinge", needs=False),
        PlannedJoint("lock_slide", "prismatic", unlimited=False, follows="", needs=True),
    )


@pytest.mark.parametrize(
    ("at", "count"),
    [
        ([(0, 0, 1), (0, 0, 2)], 2),
        (points((0, 0, 1), (0, 0, 2), (0, 0, 3)) + (0, 1, 0), 3),
        (row((0, 0, 1), (0, 0, 1), 4), 4),
    ],
)
def test_a_repeat_counts_its_points(at, count: int) -> None:
    press = Prismatic("button_slide", axis=Z, limits=(0.0, 0.003))
    body = block("panel").repeat(block("button"), press, at=at)
    assert names(body) == [f"button_slide_{index}" for index in range(count)]


def test_a_suffix_renames_a_joint_and_who_follows_it_but_not_a_leader_outside() -> None:
    pedal = Revolute("pedal", axis=X, limits=(0.0, 0.3))
    lid = Revolute("lid", axis=X, follows=pedal)
    latch = Prismatic("latch", axis=Z, follows=0.01 * lid)
    flap = block("bin").attach(block("lid").attach(block("latch"), latch), lid)
    found = {joint.name: joint.follows for joint in joints_of(Graph(flap.suffixed("_left")))}
    assert found == {"lid_left": "pedal", "latch_left": "lid_left"}


def test_welded_bodies_keep_their_joints() -> None:
    one = block("a").attach(block("b"), Prismatic("slide_b", axis=X, limits=(0.0, 0.1)))
    other = block("c").attach(block("d"), Prismatic("slide_d", axis=X, limits=(0.0, 0.1)))
    assert names(weld(one, other).at(0.0, 0.0, 1.0)) == ["slide_b", "slide_d"]


def test_equal_bodies_that_are_written_twice_each_have_their_joints() -> None:
    def leaf(tail: str) -> Body:
        return block("a").attach(block("b"), Prismatic("slide", axis=X, limits=(0.0, 0.1))).suffixed(tail)

    assert names(weld(block("frame"), leaf("_0"), leaf("_1"))) == ["slide_0", "slide_1"]


@pytest.mark.parametrize("joints", [(3, 2), (-1, 2)])
def test_a_category_cannot_claim_what_is_no_range(joints: tuple[int, int]) -> None:
    message = r"is not allowed: give the least and the largest joint count, in this order\n  at .*"
    with pytest.raises(BuildError, match=rf"joints=\(.*\) {message}test_joint_outline\.py"):
        category(labels=("a",), joints=joints)
