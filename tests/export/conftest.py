"""Assets made by hand, without the graph: every feature that a format has, or has not, a word for."""

from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray

from artgen.asset import Asset, Branch, Grasp, Link, Piece, Shape, Tree
from artgen.asset import AssetCondition as Condition
from artgen.asset import AssetCoupling as Coupling
from artgen.asset import AssetDependency as Dependency
from artgen.asset import AssetJoint as Joint
from artgen.colliders import Convex, Exact
from artgen.materials import Material, material

Array = NDArray[np.float64]

X, Y, Z = np.eye(3)


def turned(axis: Array, angle: float, offset: Array | tuple[float, float, float] = (0, 0, 0)) -> Array:
    """Return a rigid transform, shape (4, 4)."""
    cross = np.cross(np.eye(3), np.asarray(axis))
    result = np.eye(4)
    result[:3, :3] += np.sin(angle) * cross + (1 - np.cos(angle)) * (cross @ cross)
    result[:3, 3] = offset
    return result


def box_convex(size: tuple[float, float, float], pose: Array) -> Convex:
    """Return a box collider."""
    return Convex("box", pose, tuple(map(float, size)), np.zeros((0, 3)))


def hull_convex(points: Array) -> Convex:
    """Return a hull collider."""
    return Convex("hull", np.eye(4), (), np.asarray(points, float))


def box_shape(
    size: tuple[float, float, float],
    center: tuple[float, float, float],
    convexes: tuple[Convex, ...] = (),
    pose: Array | None = None,
) -> Shape:
    """Return a sharp box with flat normals, seen by simulators as `convexes` (by default as itself)."""
    pose = turned(Z, 0.0, center) if pose is None else pose
    vertices, normals, uvs, triangles = [], [], [], []
    for axis in range(3):
        for sign in (-1.0, 1.0):
            u, v = (axis + 1) % 3, (axis + 2) % 3
            corners = np.zeros((4, 3))
            corners[:, axis] = sign
            corners[:, u] = [-1, 1, 1, -1]
            corners[:, v] = [-1, -1, 1, 1]
            first = len(vertices)
            half = np.array(size) / 2
            vertices += list(corners * half)
            uvs += list((corners * half)[:, [u, v]])
            normals += [sign * np.eye(3)[axis]] * 4
            face = [[0, 1, 2], [0, 2, 3]] if sign > 0 else [[0, 2, 1], [0, 3, 2]]
            triangles += [[first + index for index in corner] for corner in face]
    return Shape.from_mesh(
        np.array(vertices) @ pose[:3, :3].T + pose[:3, 3],
        np.array(normals) @ pose[:3, :3].T,
        np.array(uvs),
        np.array(triangles),
        Exact(convexes or (box_convex(size, pose),)),
    )


def box_link(
    name: str,
    size: tuple[float, float, float],
    center: tuple[float, float, float],
    what: Material | str = "oak",
    convexes: tuple[Convex, ...] = (),
    grasps: tuple[Grasp, ...] = (),
) -> Link:
    """Return a link that is one box."""
    stuff = material(what) if isinstance(what, str) else what
    return Link(name, name, (Piece(name, stuff, box_shape(size, center, convexes)),), grasps)


def _cabinet_base() -> Link:
    walls = (
        ((0.02, 0.4, 0.6), (-0.29, 0.0, 0.3)),
        ((0.02, 0.4, 0.6), (0.29, 0.0, 0.3)),
        ((0.56, 0.02, 0.6), (0.0, 0.19, 0.3)),
        ((0.56, 0.38, 0.02), (0.0, -0.01, 0.01)),
        ((0.56, 0.38, 0.02), (0.0, -0.01, 0.59)),
    )
    pieces = [Piece("body", material("oak"), box_shape(size, center)) for size, center in walls]
    tilted = turned(Z, 0.3, (0.0, 0.22, 0.3)) @ turned(X, 0.2)
    pieces.append(Piece("window", material("glass"), box_shape((0.2, 0.01, 0.2), (0, 0, 0), pose=tilted)))
    return Link("body", "body", tuple(pieces))


def _lid() -> Link:
    corners = np.array(
        [[x, y, z] for x in (-0.3, 0.3) for y in (-0.2, 0.2) for z in (0.61, 0.63)], dtype=float
    )
    grasp = Grasp("lid_edge", turned(X, 2.2, (0.0, -0.2, 0.62)), 0.05)
    return box_link("lid", (0.6, 0.4, 0.02), (0, 0, 0.62), convexes=(hull_convex(corners),), grasps=(grasp,))


def _round_links() -> tuple[Link, Link, Link]:
    none = np.zeros((0, 3))
    dial = box_link(
        "dial",
        (0.03, 0.02, 0.03),
        (-0.2, -0.215, 0.5),
        "abs",
        (Convex("cylinder", turned(X, np.pi / 2, (-0.2, -0.215, 0.5)), (0.03, 0.02), none),),
    )
    knob = box_link(
        "knob", (0.02, 0.02, 0.02), (0.0, -0.3, 0.5), "steel",
        (Convex("sphere", turned(Z, 0.0, (0.0, -0.3, 0.5)), (0.02,), none),),
    )  # fmt: skip
    bolt = box_link(
        "bolt",
        (0.08, 0.014, 0.014),
        (0.2, -0.23, 0.5),
        "steel",
        (Convex("capsule", turned(Y, np.pi / 2, (0.2, -0.23, 0.5)), (0.01, 0.06), none),),
    )
    return dial, knob, bolt


def cabinet_tree() -> Tree:
    """Return a cabinet that needs every word of the formats."""
    dial, knob, bolt = _round_links()
    hinge = Joint(
        "lid_hinge", "revolute", -X, np.array([0.1, 0.2, 0.61]), (0.0, 1.4),
        stiffness=1.5, damping=0.2, friction=0.1, rest=-0.3, armature=0.002, effort=40.0, velocity=3.0,
        needs=Dependency(Condition("above", "lever_turn", 0.4), until=0.2),
    )  # fmt: skip
    dial_turn = Joint("dial_turn", "revolute", Y, np.array([-0.2, -0.2, 0.5]), None, friction=0.02)
    slant = np.array([0.6, 0.0, 0.8])
    slide = Joint("knob_slide", "prismatic", -Y, np.array([0.0, -0.2, 0.5]), (0.0, 0.05), damping=2.0)
    turn = Joint("knob_turn", "revolute", slant, np.array([0.0, -0.25, 0.45]), (-1.0, 1.0), stiffness=0.3)
    lever = box_link("lever", (0.02, 0.02, 0.12), (0.15, -0.23, 0.42), "satin_nickel")
    lever_turn = Joint("lever_turn", "revolute", Y, np.array([0.15, -0.2, 0.47]), (0.0, 0.8), stiffness=2.0)
    bolt_slide = Joint(
        "bolt_slide", "prismatic", X, np.array([0.2, -0.23, 0.5]),
        follows=Coupling("lever_turn", -0.02, 0.005),
    )  # fmt: skip
    foot = box_link("foot", (0.05, 0.05, 0.1), (0.2, 0.1, -0.05), "rubber")
    foot_lock = Joint("foot_lock", "revolute", Z, np.array([0.2, 0.1, 0.0]), (0.4, 0.4))
    tray = box_link("tray", (0.3, 0.3, 0.02), (0.0, 0.0, 0.2), "steel")
    tray_slide = Joint("tray_slide", "prismatic", -Y, np.array([0.0, 0.0, 0.2]), (0.02, 0.2), friction=1.0)
    return Tree(
        _cabinet_base(),
        (
            Branch((hinge,), Tree(_lid())),
            Branch((dial_turn,), Tree(dial)),
            Branch((slide, turn), Tree(knob)),
            Branch((lever_turn,), Tree(lever)),
            Branch((bolt_slide,), Tree(bolt)),
            Branch((foot_lock,), Tree(foot)),
            Branch((tray_slide,), Tree(tray)),
        ),
    ).checked()


def make_cabinet(**fields: object) -> Asset:
    """Return the cabinet as an asset."""
    chosen: dict[str, object] = {
        "seed": 7,
        "parameters": {"width": 0.6, "hand": "left"},
        "labels": ("body", "lid"),
        "version": "1.0",
    }
    return Asset.from_tree(cabinet_tree(), "cabinet_7", "cabinet", **{**chosen, **fields})


def make_nested() -> Asset:
    """Return a chain: three joints on one pair (the middle one locked), each link off the last one's axes.

    The middle joint is locked away from 0, one joint cannot stand at 0, an unlimited one leads another,
    and one link is named like the body between two joints would be.
    """
    stand = box_link("stand", (0.2, 0.2, 0.1), (0, 0, 0.05))
    arm = box_link("arm", (0.05, 0.05, 0.3), (0.1, 0.05, 0.3), "aluminium")
    hand = box_link("arm_reach", (0.1, 0.02, 0.05), (0.2, 0.1, 0.5), "abs")
    wheel = box_link("wheel", (0.02, 0.1, 0.1), (-0.2, 0.1, 0.5), "rubber")
    tilted = np.array([1.0, 2.0, -2.0]) / 3.0
    joints = (
        Joint("reach", "prismatic", tilted, np.array([0.1, 0.0, 0.1]), (-0.1, 0.3)),
        Joint("set", "revolute", Y, np.array([0.3, 0.0, 0.1]), (0.7, 0.7)),
        Joint("swing", "revolute", tilted, np.array([0.1, 0.05, 0.15]), (0.2, 1.2), rest=0.5, stiffness=4.0),
    )
    wrist = Joint("wrist", "revolute", X, np.array([0.15, 0.1, 0.5]), None)
    spin = Joint("spin", "revolute", X, np.array([-0.2, 0.1, 0.5]), follows=Coupling("wrist", 2.0, 0.1))
    return Asset.from_tree(
        Tree(
            stand, (Branch(joints, Tree(arm, (Branch((wrist,), Tree(hand)), Branch((spin,), Tree(wheel))))),)
        ),
        "arm_1",
        "arm",
        seed=1,
    )


@pytest.fixture(scope="session")
def cabinet() -> Asset:
    """A fixed cabinet with everything on it."""
    return make_cabinet()


@pytest.fixture(scope="session")
def free_cabinet() -> Asset:
    """The cabinet on a free base."""
    return make_cabinet(base="free")


@pytest.fixture(scope="session")
def nested() -> Asset:
    """A chain with several joints on one pair of links."""
    return make_nested()


@pytest.fixture(scope="session", params=["cabinet", "free_cabinet", "nested"])
def asset(request: pytest.FixtureRequest) -> Asset:
    """Each of the assets in turn."""
    result: Asset = request.getfixturevalue(request.param)
    return result


@pytest.fixture(scope="session")
def draw_positions() -> Callable[[Asset, int], dict[str, float]]:
    """Return a function that draws positions of an asset's free joints from a seed."""

    def draw(asset: Asset, seed: int) -> dict[str, float]:
        generator = np.random.default_rng(seed)
        result = {}
        for joint in asset.free_joints:
            low, high = joint.limits or (-6.0, 6.0)
            result[joint.name] = float(generator.uniform(low, high))
        return result

    return draw


@pytest.fixture(scope="session")
def make_asset() -> Callable[[str], Asset]:
    """Return a function that makes one of the assets anew."""
    makers: dict[str, Callable[[], Asset]] = {
        "cabinet": make_cabinet,
        "free_cabinet": lambda: make_cabinet(base="free"),
        "nested": make_nested,
    }
    return lambda name: makers[name]()
