"""Reading of USD: bodies, joints, colliders, what a file excludes, hostile files, and repaired copies."""

import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from pxr import Sdf, UsdUtils

from artgen import generate
from artgen.colliders import Convex
from artgen.errors import AssetError
from artgen.referee import usd
from artgen.referee.model import MOST_BODIES, ForeignBody, ForeignModel, Meshes
from artgen.referee.usd import model_of, read_usd, repaired_usd
from support.foreign_cabinet import cabinet

_HEAD = 'metersPerUnit = 1\nupAxis = "Z"\ndefaultPrim = "top"'
_RIGID, _COLLIDES, _MESHED = "PhysicsRigidBodyAPI", "PhysicsCollisionAPI", "PhysicsMeshCollisionAPI"


def write(folder: Path, text: str, *, head: str = _HEAD, name: str = "a.usda") -> Path:
    path = folder / name
    path.write_text(f'#usda 1.0\n(\n{head}\n)\ndef Xform "top" {{\n{text}\n}}\n', encoding="utf-8")
    return path


def read(path: Path, meshes: Meshes = "hull", root: Path | None = None) -> ForeignModel:
    return model_of(path, meshes, root or path.parent)


def prim(kind: str, name: str, inner: str = "", *schemas: str, at: Any = (0, 0, 0), more: str = "") -> str:
    quoted = ", ".join(f'"{each}"' for each in schemas)
    applied = f"prepend apiSchemas = [{quoted}]" if schemas else ""
    place = f"double3 xformOp:translate = {tuple(at)}\n"
    order = 'uniform token[] xformOpOrder = ["xformOp:translate"]\n' if "xformOpOrder" not in inner else ""
    moved = (place + order) if any(at) else ""
    return f'def {kind} "{name}" ({applied} {more}) {{\n{moved}{inner}\n}}\n'


def cube(name: str = "box", at: Any = (0, 0, 0), inner: str = "") -> str:
    return prim("Cube", name, f"double size = 0.2\n{inner}", _COLLIDES, at=at)


def body(name: str, at: Any = (0, 0, 0), inner: str | None = None, *schemas: str) -> str:
    return prim("Xform", name, cube(f"{name}_box") if inner is None else inner, _RIGID, *schemas, at=at)


def base() -> str:
    return body("base", (0, 0, 0), "bool physics:kinematicEnabled = 1\n" + cube("base_box"))


def joint(kind: str, name: str, one: str, two: str, inner: str = "", *schemas: str) -> str:
    ends = [f"rel physics:body{n} = </top/{each}>" for n, each in enumerate((one, two)) if each]
    return prim(f"Physics{kind}Joint", name, "\n".join([*ends, inner]), *schemas)


def limits(low: float, high: float, axis: str = "Z") -> str:
    ends = f"float physics:lowerLimit = {low}\nfloat physics:upperLimit = {high}"
    return f'uniform token physics:axis = "{axis}"\n{ends}\n'


def at(one: Any, two: Any) -> str:
    return f"point3f physics:localPos0 = {tuple(one)}\npoint3f physics:localPos1 = {tuple(two)}\n"


def of(model: ForeignModel, name: str) -> ForeignBody:
    return next(each for each in model.bodies if each.name == name)


def only(model: ForeignModel) -> Convex:
    (found,) = (geom.convex for each in model.bodies for geom in each.geoms)
    return found


def refused(path: Path, message: str, root: Path | None = None) -> None:
    with pytest.raises(AssetError, match=message) as caught:
        read(path, root=root)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("category", ["cabinet", "door", "faucet", "pepper_grinder", "toaster", "trashcan"])
def test_exports_of_artgen_read_back_equal_the_asset(category: str, tmp_path: Path) -> None:
    asset = generate(category, 3, certify=False)
    asset.export(tmp_path, formats=("usd",))
    model = read(tmp_path / f"{category}_3.usda")
    found = {each.name: each for body in model.bodies for each in body.joints}
    moving = {each.name: each for each in asset.joints if not each.locked}
    assert found.keys() == moving.keys()
    for name, step in moving.items():
        assert found[name].kind == step.kind
        assert np.allclose(found[name].axis, step.axis, atol=1e-6)
        assert np.allclose(np.cross(found[name].pivot - step.pivot, step.axis), 0.0, atol=1e-6)
        if step.limits is None:
            assert found[name].limits is None
        else:
            assert found[name].limits == pytest.approx(step.limits, rel=1e-6, abs=1e-7)
        one, two = found[name].follows, step.follows
        assert (one is None) == (two is None)
        if one is not None and two is not None:
            assert one.leader == two.leader
            assert one.ratio == pytest.approx(two.ratio, rel=1e-6)
            assert one.offset == pytest.approx(two.offset, abs=1e-6)
    for link in asset.links:
        read_back = [geom.convex for geom in of(model, link.name).geoms]
        assert len(read_back) == len(link.colliders)
        ours = sorted(each.convex.bounds().ravel().tolist() for each in link.colliders)
        theirs = sorted(each.bounds().ravel().tolist() for each in read_back)
        assert np.allclose(np.sum(ours, axis=0), np.sum(theirs, axis=0), atol=1e-4)
    assert not model.notes
    assert not model.restricted


def test_units_become_meters_and_y_becomes_z(tmp_path: Path) -> None:
    text = cube("c", (100, 200, 300)).replace("size = 0.2", "size = 20")
    convex = only(read(write(tmp_path, text, head='metersPerUnit = 0.01\nupAxis = "Y"')))
    assert convex.kind == "box"
    assert np.allclose(convex.pose[:3, 3], (1.0, -3.0, 2.0))
    assert np.allclose(convex.size, 0.2)
    assert np.allclose(only(read(write(tmp_path, text, head=""))).size, 0.2), "centimeters by default"
    refused(write(tmp_path, text, head="metersPerUnit = 0"), "metersPerUnit is 0; give a positive number")


def test_a_hinge_has_degrees_and_a_slide_units(tmp_path: Path) -> None:
    text = base() + body("door", (0, 100, 0)) + body("tray")
    text += joint("Revolute", "hinge", "base", "door", limits(-90, 45, "X") + at((0, 100, 0), (0, 0, 0)))
    text += joint("Prismatic", "slide", "tray", "base", limits(-10, 40, "Y"))
    model = read(write(tmp_path, text, head='metersPerUnit = 0.01\nupAxis = "Z"'))
    (hinge,), (slide,) = of(model, "door").joints, of(model, "tray").joints
    assert (hinge.name, hinge.kind, slide.kind) == ("hinge", "revolute", "prismatic")
    assert hinge.limits == pytest.approx((-math.pi / 2, math.pi / 4))
    assert slide.limits == pytest.approx((-0.1, 0.4))
    assert np.allclose(hinge.axis, (1, 0, 0))
    assert np.allclose(hinge.pivot, (0, 1, 0))
    assert np.allclose(slide.axis, (0, -1, 0)), "the child is the first body"
    assert (of(model, "base").parent, of(model, "door").parent) == ("", "base")


def test_limits_that_are_missing_or_far_are_none(tmp_path: Path) -> None:
    text = base() + "".join(body(name) for name in "abc")
    text += joint("Revolute", "endless", "base", "a")
    text += joint("Revolute", "far", "base", "b", limits(-1e8, 1e8))
    text += joint("Prismatic", "half", "base", "c", "float physics:lowerLimit = 0")
    model = read(write(tmp_path, text))
    assert [of(model, name).joints[0].limits for name in "abc"] == [None] * 3
    assert model.notes == ("joints with one limit only are judged without limits (1): half",)


@pytest.mark.parametrize(
    ("free", "kind", "apart"),
    [
        ({"rotY": (-90, 90)}, "revolute", ""),
        ({"transX": (0, 0.5)}, "prismatic", ""),
        ({}, "", ""),
        ({"rotX": None, "rotY": None}, "", "joint of 2 axes 'any'"),
        (dict.fromkeys(("transX", "transY", "transZ", "rotX", "rotY", "rotZ")), "", "free joint 'any'"),
    ],
)
def test_a_generic_joint_is_what_its_limits_leave(
    free: dict[str, Any], kind: str, apart: str, tmp_path: Path
) -> None:
    ends = dict.fromkeys(("transX", "transY", "transZ", "rotX", "rotZ"), (1, -1)) | {"rotY": (0, 0)} | free
    known = {axis: each for axis, each in ends.items() if each}
    inner = "".join(
        f"float limit:{axis}:physics:low = {low}\nfloat limit:{axis}:physics:high = {high}\n"
        for axis, (low, high) in known.items()
    )
    text = base() + body("b") + joint("", "any", "base", "b", inner, *(f"PhysicsLimitAPI:{a}" for a in known))
    found = of(read(write(tmp_path, text)), "b")
    assert [each.kind for each in found.joints] == ([kind] if kind else [])
    assert found.apart == apart
    if kind:
        assert found.joints[0].limits == pytest.approx(
            (-math.pi / 2, math.pi / 2) if "rotY" in free else (0, 0.5)
        )
        assert np.allclose(found.joints[0].axis, (0, 1, 0) if "rotY" in free else (1, 0, 0))


def test_other_joints_weld_part_or_are_noted(tmp_path: Path) -> None:
    text = base() + "".join(body(name) for name in ("welded", "ball", "held", "off"))
    text += joint("Fixed", "weld", "base", "welded") + joint("Spherical", "neck", "base", "ball")
    text += joint("Distance", "rope", "base", "held")
    text += joint("Fixed", "loose", "base", "off", "bool physics:jointEnabled = 0")
    text += prim("PhysxPhysicsGearJoint", "gear")
    model = read(write(tmp_path, text))
    assert (of(model, "welded").parent, of(model, "welded").joints, of(model, "welded").apart) == (
        "base",
        (),
        "",
    )
    assert (of(model, "ball").parent, of(model, "ball").apart) == ("base", "ball joint 'neck'")
    assert of(model, "held").apart == "free body 'held'"
    assert of(model, "off").apart == "free body 'off'"
    assert "distance joints are not judged (1): rope" in model.notes
    assert any("types that OpenUSD does not know are not judged (1): gear" in note for note in model.notes)


def test_the_world_holds_static_colliders_and_bodies_that_nothing_moves(tmp_path: Path) -> None:
    off = "bool physics:rigidBodyEnabled = 0\n" + cube("off_box")
    text = (
        cube("floor")
        + prim("Xform", "shelf", cube("board"))
        + body("off", (0, 0, 0), off)
        + body("a")
        + body("b")
    )
    text += joint("Revolute", "h", "", "a", limits(0, 9)) + joint("Revolute", "k", "shelf", "b", limits(0, 9))
    text += joint("Fixed", "useless", "shelf", "floor")
    model = read(write(tmp_path, text))
    assert sorted(geom.name for geom in of(model, "world").geoms) == ["board", "floor", "off_box"]
    assert [(each.name, each.parent, len(each.joints)) for each in model.bodies] == [
        ("world", "", 0), ("a", "", 1), ("b", "", 1),
    ]  # fmt: skip
    assert model.notes == ("joints between bodies that are fixed to each other are ignored (1): useless",)


def test_the_root_of_a_free_tree_is_that_of_its_articulation(tmp_path: Path) -> None:
    chain = joint("Revolute", "h", "a", "b", limits(0, 9)) + joint("Revolute", "k", "b", "c", limits(0, 9))
    plain = read(write(tmp_path, body("b") + body("a") + body("c") + chain))
    assert [(each.name, each.parent, each.apart) for each in plain.bodies] == [
        ("a", "", "free body 'a'"), ("b", "a", ""), ("c", "b", ""),
    ]  # fmt: skip
    rooted = body("a") + body("b") + body("c", (0, 0, 0), None, "PhysicsArticulationRootAPI")
    model = read(write(tmp_path, rooted + chain))
    assert [(each.name, each.parent) for each in model.bodies] == [("c", ""), ("b", "c"), ("a", "b")]
    assert np.allclose(of(model, "b").joints[0].axis, (0, 0, -1))


def test_bodies_return_from_the_authored_pose_to_position_0(tmp_path: Path) -> None:
    turned = 'double xformOp:rotateZ = 90\nuniform token[] xformOpOrder = ["xformOp:rotateZ"]\n' + cube(
        "d", (1, 0, 0)
    )
    text = (
        base()
        + prim("Xform", "door", turned, _RIGID)
        + joint("Revolute", "h", "base", "door", limits(0, 120))
    )
    text += body("knob", (0.1, 1.5, 0)) + joint(
        "Prismatic", "s", "door", "knob", limits(0, 2, "X") + at((1, 0, 0), (0, 0, 0))
    ).replace(
        "rel physics:body1", "quatf physics:localRot1 = (0.7071068, 0, 0, 0.7071068)\nrel physics:body1"
    )
    model = read(write(tmp_path, text))
    door, knob = of(model, "door").geoms[0].convex, of(model, "knob")
    assert np.allclose(door.pose[:3, 3], (1, 0, 0), atol=1e-6), "the door was open by 90 degrees"
    assert np.allclose(knob.joints[0].axis, (1, 0, 0), atol=1e-6)
    assert np.allclose(knob.geoms[0].convex.pose[:3, 3], (1, 0, 0), atol=1e-6)
    assert model.notes == ("bodies are placed where the frames of their joints meet (1): knob",)


def test_a_scaled_body_scales_the_frames_of_its_joints(tmp_path: Path) -> None:
    scaled = 'double3 xformOp:scale = (2, 2, 2)\nuniform token[] xformOpOrder = ["xformOp:scale"]\n'
    text = base() + prim("Xform", "arm", scaled + cube("c", (0.5, 0, 0)), _RIGID)
    text += joint("Revolute", "h", "base", "arm", limits(0, 9) + at((1, 0, 0), (0.5, 0, 0)))
    model = read(write(tmp_path, text))
    assert np.allclose(of(model, "arm").joints[0].pivot, (1, 0, 0))
    assert np.allclose(of(model, "arm").geoms[0].convex.size, 0.4)
    assert not model.notes


def test_nested_bodies_are_bodies_of_their_own(tmp_path: Path) -> None:
    text = base() + body("outer", (1, 0, 0), cube("o") + body("inner", (1, 0, 0)))
    text += joint("Revolute", "h", "base", "outer", limits(0, 9) + at((1, 0, 0), (0, 0, 0)))
    text += joint("Revolute", "k", "outer", "outer/inner", limits(0, 9) + at((1, 0, 0), (0, 0, 0)))
    model = read(write(tmp_path, text))
    assert [geom.name for geom in of(model, "outer").geoms] == ["o"]
    assert of(model, "inner").parent == "outer"
    assert np.allclose(of(model, "inner").joints[0].pivot, (2, 0, 0))


def test_a_loop_keeps_its_tree_and_restricts_its_joints(tmp_path: Path) -> None:
    text = base() + "".join(body(name) for name in "abc")
    for name, one, two in (("h", "base", "a"), ("k", "base", "b"), ("z", "base", "c")):
        text += joint("Revolute", name, one, two, limits(0, 9))
    cut = text + joint("Revolute", "cut", "a", "b", limits(0, 9) + "bool physics:excludeFromArticulation = 1")
    model = read(write(tmp_path, cut))
    assert [of(model, name).parent for name in "abc"] == ["base"] * 3
    assert model.restricted == dict.fromkeys(("h", "k"), "loop that joint 'cut' closes")
    assert model.notes == ("joints close loops and are not judged; poses that they forbid are (1): cut",)
    model = read(write(tmp_path, text + joint("Distance", "rope", "b", "c")))
    assert model.restricted == dict.fromkeys(("k", "z"), "distance joint 'rope'")
    early = joint("Spherical", "early", "base", "a") + text
    assert read(write(tmp_path, early)).restricted == {"h": "loop that joint 'early' closes"}


def _mimic(inner: str, *schemas: str) -> str:
    text = base() + body("a") + body("b")
    text += joint("Revolute", "lead", "base", "a", limits(0, 90))
    return text + joint("Prismatic", "follow", "base", "b", limits(0, 9) + inner, *schemas)


def test_couplings_of_three_simulators_in_si(tmp_path: Path) -> None:
    lead = "</top/lead>"
    physx = f"rel physxMimicJoint:rotX:referenceJoint = {lead}\nfloat physxMimicJoint:rotX:gearing = -2\n"
    physx += "float physxMimicJoint:rotX:offset = 3\n"
    newton = f"rel newton:mimicJoint = {lead}\nfloat newton:mimicCoef1 = 0.5\nfloat newton:mimicCoef0 = 4\n"
    mujoco = f"rel mjc:target = {lead}\ndouble mjc:coef1 = 0.25\ndouble mjc:coef0 = 0.125\n"
    head = 'metersPerUnit = 0.01\nupAxis = "Z"'
    for inner, schemas, ratio, offset in (
        (physx, ("PhysxMimicJointAPI:rotX",), 2 * 0.01 * 180 / math.pi, -0.03),
        (newton, (), 0.5, 0.04),
        (mujoco, (), 0.25, 0.125),
    ):
        model = read(write(tmp_path, _mimic(inner, *schemas), head=head))
        follows = of(model, "b").joints[0].follows
        assert follows is not None
        assert follows.leader == "lead"
        assert follows.ratio == pytest.approx(ratio)
        assert follows.offset == pytest.approx(offset)
    off = read(write(tmp_path, _mimic(newton + "bool newton:mimicEnabled = 0\n")))
    assert of(off, "b").joints[0].follows is None


@pytest.mark.parametrize("target", ["</top/none>", "</top/follow>", "</top/lead>\ndouble mjc:coef2 = 1"])
def test_a_coupling_that_cannot_be_said_restricts_its_joint(target: str, tmp_path: Path) -> None:
    model = read(write(tmp_path, _mimic(f"rel mjc:target = {target}\n")))
    assert of(model, "b").joints[0].follows is None
    assert model.restricted == {"follow": f"coupling to {re.findall(r'[a-z]+', target)[1]!r}"}


def test_couplings_in_a_circle_leave_one_leader(tmp_path: Path) -> None:
    text = _mimic("rel newton:mimicJoint = </top/lead>\n")
    text = text.replace('"lead" ( ) {', '"lead" ( ) {\nrel newton:mimicJoint = </top/follow>')
    model = read(write(tmp_path, text))
    assert of(model, "a").joints[0].follows is not None
    assert model.restricted == {"follow": "coupling to 'lead'"}


def test_joints_exclude_their_bodies_unless_they_say_otherwise(tmp_path: Path) -> None:
    text = base() + body("a") + body("b") + prim("Xform", "wall", cube("w")) + cube("v") + body("c")
    text += joint("Revolute", "h", "base", "a", limits(0, 9))
    text += joint("Revolute", "k", "base", "b", limits(0, 9) + "bool physics:collisionEnabled = 1")
    text += joint("Revolute", "m", "wall", "c", limits(0, 9))
    model = read(write(tmp_path, text))
    reason = "joint 'h' disables collision between its bodies"
    assert model.excluded == {frozenset(("base", "a")): reason}
    assert model.exempt == {frozenset(("w", "c_box"))}, "of the world, only what the joint names"


def test_filtered_pairs_of_bodies_and_colliders(tmp_path: Path) -> None:
    filters = "rel physics:filteredPairs = [</top/b>, </top/c/c1>]\n"
    text = body("a", (0, 0, 0), filters + cube("a1") + cube("a2"), "PhysicsFilteredPairsAPI") + body("b")
    text += body("c", (0, 0, 0), cube("c1") + cube("c2"))
    model = read(write(tmp_path, text))
    assert model.excluded == {frozenset(("a", "b")): "filtered pairs of 'a'"}
    assert model.exempt == {frozenset(("a1", "c1")), frozenset(("a2", "c1"))}
    assert not read(write(tmp_path, text.replace(', "PhysicsFilteredPairsAPI"', ""))).excluded, "not applied"


def test_collision_groups(tmp_path: Path) -> None:
    def group(name: str, members: str, filtered: str) -> str:
        inner = (
            f"rel collection:colliders:includes = [{members}]\nrel physics:filteredGroups = [{filtered}]\n"
        )
        return prim("PhysicsCollisionGroup", name, inner, "CollectionAPI:colliders")

    text = body("a") + body("b", (0, 0, 0), cube("b1") + cube("b2")) + body("c")
    text += group("g", "</top/a>", "</top/h>") + group("h", "</top/b/b1>, </top/c>", "")
    model = read(write(tmp_path, text))
    assert model.excluded == {frozenset(("a", "c")): "collision groups"}
    assert model.exempt == {frozenset(("a_box", "b1"))}


def test_an_articulation_without_self_collisions(tmp_path: Path) -> None:
    text = body("a") + body("b") + body("c") + body("d") + joint("Fixed", "f", "b", "c")
    text += joint("Revolute", "h", "a", "b", limits(0, 9) + "bool physics:collisionEnabled = 1")
    text = text.replace(
        "rel physics:body0 = </top/b>", "bool physics:collisionEnabled = 1\nrel physics:body0 = </top/b>"
    )
    off = "bool physxArticulation:enabledSelfCollisions = 0\n"
    root = text.replace(
        f'"a" (prepend apiSchemas = ["{_RIGID}"] ) {{',
        f'"a" (prepend apiSchemas = ["{_RIGID}", "PhysicsArticulationRootAPI"] ) {{ {off}',
    )
    assert root != text
    assert not read(write(tmp_path, text)).excluded
    pairs = {frozenset(each) for each in ("ab", "ac", "bc")}
    assert read(write(tmp_path, root)).excluded == dict.fromkeys(
        pairs, "articulation 'a' has no self-collisions"
    )


def _scaled(x: float, y: float, z: float) -> str:
    return f'double3 xformOp:scale = ({x}, {y}, {z})\nuniform token[] xformOpOrder = ["xformOp:scale"]\n'


@pytest.mark.parametrize(
    ("kind", "inner", "shape", "half"),
    [
        ("Cube", "double size = 2\n" + _scaled(1, 2, 3), "box", (1, 2, 3)),
        ("Cube", "", "box", (1, 1, 1)),
        ("Sphere", "double radius = 2\n" + _scaled(2, 2, 2), "sphere", (4, 4, 4)),
        ("Sphere", _scaled(1, 2, 3), "hull", (1, 2, 3)),
        ("Cylinder", 'double radius = 1\ndouble height = 6\ntoken axis = "X"', "cylinder", (3, 1, 1)),
        ("Cylinder", _scaled(3, 3, 1), "cylinder", (3, 3, 1)),
        ("Capsule", 'double radius = 1\ndouble height = 2\ntoken axis = "Y"', "capsule", (1, 2, 1)),
        ("Cone", "double radius = 1\ndouble height = 4", "hull", (1, 1, 2)),
        (
            "Capsule_1",
            "double radiusTop = 1\ndouble radiusBottom = 1\ndouble height = 2",
            "capsule",
            (1, 1, 2),
        ),
        ("Cylinder_1", "double radiusTop = 1\ndouble radiusBottom = 2\ndouble height = 2", "hull", (2, 2, 1)),
    ],
)
def test_primitives(kind: str, inner: str, shape: str, half: Any, tmp_path: Path) -> None:
    model = read(write(tmp_path, prim(kind, "c", inner, _COLLIDES)))
    convex = only(model)
    assert convex.kind == shape
    assert np.allclose(convex.bounds(), (-np.array(half), half), rtol=5e-3 if shape == "hull" else 1e-9)
    if kind == "Cone":
        assert math.pi * 4 / 3 <= convex.volume <= 1.005 * math.pi * 4 / 3
    assert len(model.notes) == ((kind, shape) == ("Sphere", "hull")), "a stretched ball is noted"


def test_a_quaternion_of_single_precision_keeps_a_cylinder(tmp_path: Path) -> None:
    inner = "quatf xformOp:orient = (0.7071069, 0.7071067, 0, 0)\nfloat3 xformOp:scale = (1.1, 1.1, 1.1)\n"
    inner += 'uniform token[] xformOpOrder = ["xformOp:orient", "xformOp:scale"]\n'
    convex = only(read(write(tmp_path, prim("Cylinder", "c", inner, _COLLIDES))))
    assert convex.kind == "cylinder"
    assert np.allclose(np.abs(convex.pose[:3, 2]), (0, 1, 0), atol=1e-6)


_BLOCK = [(0, 0, 0), (1, 0, 0), (1, 2, 0), (0, 2, 0), (0, 0, 3), (1, 0, 3), (1, 2, 3), (0, 2, 3)]
_QUADS = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
_SIDE = [(0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3)]
_ELL = [(x, y, z) for z in (0, 1) for x, y in _SIDE]
_ELL_FACES = [
    (5, 4, 3, 2, 1, 0),
    (6, 7, 8, 9, 10, 11),
    *((k, (k + 1) % 6, (k + 1) % 6 + 6, k + 6) for k in range(6)),
]


def mesh(points: Any, faces: Any, approximation: str = "", inner: str = "") -> str:
    corners = [corner for face in faces for corner in face]
    text = f"point3f[] points = {[tuple(map(float, each)) for each in points]}\n"
    text += f"int[] faceVertexCounts = {[len(face) for face in faces]}\nint[] faceVertexIndices = {corners}\n"
    schemas = [_COLLIDES] + [_MESHED] * bool(approximation)
    if approximation:
        text += f'uniform token physics:approximation = "{approximation}"\n'
    return prim("Mesh", "m", text + inner, *schemas)


def test_meshes_become_hulls_as_the_file_or_the_caller_says(tmp_path: Path) -> None:
    block = read(write(tmp_path, mesh(_BLOCK, _QUADS, inner=_scaled(1, 1, -1))))
    assert (only(block).kind, block.notes) == ("box", ())
    assert only(block).volume == pytest.approx(6.0)
    for approximation, noted in (
        ("", True),
        ("none", True),
        ("convexDecomposition", True),
        ("convexHull", False),
    ):
        model = read(write(tmp_path, mesh(_ELL, _ELL_FACES, approximation)))
        assert only(model).volume == pytest.approx(7.0)
        assert (
            model.notes == ("1 mesh ('m'): not convex: taken as hulls, as most simulators take them",) * noted
        )
    assert only(read(write(tmp_path, mesh(_ELL, _ELL_FACES, "convexHull")), "coacd")).volume > 6.9
    model = read(write(tmp_path, mesh(_ELL, _ELL_FACES, inner=_scaled(1, -1, 1))), "coacd")
    pieces = model.bodies[0].geoms
    assert [geom.name for geom in pieces] == ["m/0", "m/1"]
    assert sum(geom.convex.volume for geom in pieces) == pytest.approx(5.0, rel=0.05)


def test_meshes_with_bounds(tmp_path: Path) -> None:
    bounds = only(read(write(tmp_path, mesh(_ELL, _ELL_FACES, "boundingCube", _scaled(1, 1, 2)))))
    assert bounds.kind == "box"
    assert bounds.volume == pytest.approx(18.0)
    ball = only(read(write(tmp_path, mesh(_BLOCK, _QUADS, "boundingSphere"))))
    assert ball.kind == "sphere"
    assert ball.size == pytest.approx((math.sqrt(14) / 2,))
    assert np.allclose(ball.pose[:3, 3], (0.5, 1, 1.5))


def test_what_is_not_judged_is_noted(tmp_path: Path) -> None:
    flat = mesh([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])
    text = flat + prim("Plane", "ground", "", _COLLIDES) + prim("Xform", "group", cube("inside"), _COLLIDES)
    text += prim("PointInstancer", "many", cube("seed")) + prim(
        "Mesh", "cloth", "", _COLLIDES, "PhysxClothAPI"
    )
    text += prim("Cube", "off", "bool physics:collisionEnabled = 0", _COLLIDES) + prim(
        "Cube", "zero", _scaled(0, 1, 1), _COLLIDES
    )
    text += body("seen", (0, 0, 0), prim("Cube", "skin")) + body("empty", (0, 0, 0), "")
    model = read(write(tmp_path, text))
    assert [geom.name for each in model.bodies for geom in each.geoms] == ["inside"]
    for start, name in (
        ("colliders of the type Plane are", "ground"),
        ("colliders of the type Xform are not judged", "group"), ("point instancers are not judged", "many"),
        ("soft bodies and particles are not judged", "cloth"), ("bodies without a collider are", "seen"),
    ):  # fmt: skip
        assert any(note.startswith(start) and note.endswith(f"(1): {name}") for note in model.notes), start
    assert "1 mesh ('m'): flat: not judged" in model.notes


def test_instances_have_colliders_with_paths_as_names(tmp_path: Path) -> None:
    write(tmp_path, cube("part"), name="part.usda")
    text = "".join(
        prim("Xform", name, "", at=(n, 0, 0), more="references = @./part.usda@\ninstanceable = true")
        for n, name in enumerate("ab")
    )
    model = read(write(tmp_path, text))
    assert [geom.name for geom in model.bodies[0].geoms] == ["/top/a/part", "/top/b/part"]
    assert [geom.convex.pose[0, 3] for geom in model.bodies[0].geoms] == [0.0, 1.0]


def test_names_that_are_not_unique_become_paths(tmp_path: Path) -> None:
    text = base() + "".join(prim("Xform", group, body("door") + body("world")) for group in "pq")
    text += joint("Revolute", "h", "base", "p/door", limits(0, 9)) + prim(
        "Scope", "s", joint("Revolute", "h", "base", "q/door", limits(0, 9))
    )
    model = read(write(tmp_path, text + body("solo")))
    names = {"base", "solo", *(f"/top/{group}/{name}" for group in "pq" for name in ("door", "world"))}
    assert {each.name for each in model.bodies} == names
    assert of(model, "/top/q/door").joints[0].name == "/top/s/h"


def test_a_package_is_read(tmp_path: Path) -> None:
    inner = write(tmp_path, cube("part"), name="part.usda")
    outer = write(tmp_path, prim("Xform", "a", more=f"references = @./{inner.name}@"))
    assert UsdUtils.CreateNewUsdzPackage(str(outer), str(tmp_path / "a.usdz"))
    inner.unlink()
    assert [geom.name for geom in read(tmp_path / "a.usdz").bodies[0].geoms] == ["part"]


def test_layers_outside_the_root_are_refused(tmp_path: Path) -> None:
    folder = tmp_path / "in"
    folder.mkdir()
    secret = write(tmp_path, cube("part"), name="part.usda")
    (folder / "link.usda").symlink_to(secret)
    for kind in ("references", "payload"):
        for name in ("../part.usda", str(secret), "./link.usda"):
            path = write(folder, prim("Xform", "a", more=f"{kind} = @{name}@"))
            refused(path, "outside .*/in, from which files may be read; give --root DIR to allow it")
            assert len(read(path, root=tmp_path).bodies[0].geoms) == 1
    path = write(folder, "", head="subLayers = [@../part.usda@]")
    refused(path, "the layer '../part.usda' of 'a.usda' is '.*', which is outside")
    write(folder, prim("Xform", "b", more="references = @../part.usda@"), name="b.usda")
    refused(
        write(folder, prim("Xform", "a", more="references = @./b.usda@")),
        "the layer '../part.usda' of 'b.usda' is",
    )


@pytest.mark.parametrize(
    "name",
    ["http://x.org/a.usda", "https://x.org/a.usda", "omniverse://x/a.usda", "file:///etc/a.usda", '`"${A}"`'],
)
def test_layers_from_elsewhere_are_refused(name: str, tmp_path: Path) -> None:
    refused(
        write(tmp_path, prim("Xform", "a", more=f"references = @{name}@")),
        "is no path of a file; copy it to one",
    )


def test_missing_and_damaged_layers_are_refused(tmp_path: Path) -> None:
    refused(write(tmp_path, prim("Xform", "a", more="references = @./no.usda@")), "no.usda'.* does not exist")
    refused(write(tmp_path, prim("Xform", "a", more="references = @.@")), "no regular file")
    (tmp_path / "bad.usda").write_text("#usda 1.0\ndef {")
    refused(write(tmp_path, "", head="subLayers = [@./bad.usda@]"), "'bad.usda' cannot be read as USD")
    for name, data in (
        ("a.usda", b""),
        ("a.usdc", b"PXR-USDC" + bytes(80)),
        ("a.usdz", b"PK"),
        ("a.usd", b"\0"),
    ):
        (tmp_path / name).write_bytes(data)
        refused(tmp_path / name, f"{name}' cannot be read as USD; export it again")
    clips = "clips = { dictionary default = { asset[] assetPaths = [@/etc/x.usd@] } }"
    refused(write(tmp_path, prim("Xform", "a", more=clips)), "/top/a has value clips, which are not read")


def test_errors_of_composition_are_noted(tmp_path: Path) -> None:
    write(tmp_path, cube("part"), head="", name="part.usda")
    model = read(write(tmp_path, cube() + prim("Xform", "a", more="references = @./part.usda@</none>")))
    assert any(note.startswith("OpenUSD composes it with 1 errors: ") for note in model.notes)
    loop = prim("Xform", "a", more="references = @./a.usda@</top/a>")
    assert any("OpenUSD composes it with" in note for note in read(write(tmp_path, cube() + loop)).notes)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (joint("Revolute", "j", "base", "no"), "j: its body1 is /top/no, which is no prim"),
        (joint("Revolute", "j", "base", "a", limits(9, -9)), "j: its limits are 9 and -9; give the lower"),
        (joint("Revolute", "j", "base", "a", limits(math.nan, 9)), "j: its limits are nan and 9"),
        (joint("Revolute", "j", "base", "a", limits(0, 9, "W")), "its axis is 'W'; give X, Y or Z"),
        (joint("Fixed", "j", "base", "a", "quatf physics:localRot0 = (0, 0, 0, 0)"), "rotation other than 0"),
        (joint("Fixed", "j", "base", "a", "point3f physics:localPos0 = (nan, 0, 0)"), "give finite numbers"),
        (joint("Fixed", "j", "base", "a").replace("</top/a>", "[</top/a>, </top/base>]"), "names 2 prims"),
        (prim("Sphere", "s", "double radius = -1", _COLLIDES), "Sphere /top/s: its radius is -1; give"),
        (prim("Cylinder", "s", "double height = inf", _COLLIDES), "its height is inf; give"),
        (prim("Cone", "s", 'token axis = "Q"', _COLLIDES), "its axis is 'Q'"),
        (prim("Cube", "s", "double size = 1e9", _COLLIDES), "it reaches beyond 1e\\+06 m; reduce it"),
        (prim("Cube", "s", "", _COLLIDES, at=(math.nan, 0, 0)), "its transform has numbers that are"),
        (mesh([(0, 0, math.nan)], [(0, 0, 0)]), "m: its points are missing or not finite"),
        (mesh([], [(0, 1, 2)]), "m: its points are missing"),
        (mesh(_BLOCK, [(0, 1, 99)]), "m: a face has the vertex 99 of 8"),
        (mesh(_BLOCK, [(0, 1, -1)]), "m: a face has the vertex -1 of 8"),
        (mesh(_BLOCK, _QUADS).replace("[4, 4,", "[4, 5,"), "m: its faces need 25 vertices, but it names 24"),
    ],
)  # fmt: skip
def test_wrong_numbers_and_names_give_one_clear_error(text: str, message: str, tmp_path: Path) -> None:
    refused(write(tmp_path, base() + body("a") + text), f"^a.usda: .*{message}")


def test_too_many_bodies_and_prims_are_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = "".join(body(f"b{number}", (0, 0, 0), "") for number in range(MOST_BODIES + 1))
    refused(write(tmp_path, text), f"has {MOST_BODIES + 1} bodies; at most {MOST_BODIES} are read")
    monkeypatch.setattr(usd, "_MOST_PRIMS", 100)
    refused(tmp_path / "a.usda", "with its instances, it has more than 100 prims")


@pytest.mark.long
def test_a_process_of_its_own_survives_hostile_files(tmp_path: Path) -> None:
    model = read_usd(cabinet("usd", tmp_path), root=tmp_path)
    assert [each.name for each in model.bodies] == ["case", "door", "drawer"]
    deep = "".join('def Xform "x" {\n' for _ in range(5_000)) + cube() + "}\n" * 5_000
    try:
        assert len(read_usd(write(tmp_path, deep), root=tmp_path).bodies) == 1
    except AssetError as error:
        assert "OpenUSD does not read it" in str(error)  # noqa: PT017 - both are right


def test_instances_of_instances_end(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = prim("Xform", "l0", cube())
    for level in range(1, 12):
        more = f"instanceable = true\nreferences = </top/l{level - 1}>"
        text += prim("Xform", f"l{level}", "".join(prim("Xform", name, more=more) for name in "abcd"))
    monkeypatch.setattr(usd, "_MOST_PRIMS", 3_000)
    refused(write(tmp_path, text), "with its instances, it has more than 3000 prims")


def test_a_repaired_copy_changes_limits_only(tmp_path: Path) -> None:
    locked = "".join(
        f"float limit:{axis}:physics:low = 1\nfloat limit:{axis}:physics:high = -1\n"
        for axis in ("transY", "transZ", "rotX", "rotY", "rotZ")
    )
    schemas = [f"PhysicsLimitAPI:{axis}" for axis in ("transY", "transZ", "rotX", "rotY", "rotZ")]
    text = base() + "".join(body(name) for name in "abc")
    text += joint("Revolute", "h", "base", "a", limits(-90, 90)) + joint(
        "Prismatic", "s", "base", "b", limits(0, 50)
    )
    text += joint(
        "",
        "g",
        "base",
        "c",
        locked + "float limit:transX:physics:high = 9",
        *schemas,
        "PhysicsLimitAPI:transX",
    )
    path = write(tmp_path, text, head='metersPerUnit = 0.01\nupAxis = "Y"')
    original = read(path)
    for name in ("copy.usda", "copy.usdc", "copy.usd"):
        repaired_usd(path, {"h": (-0.5, 0.25), "s": (0.125, 0.125), "g": (0.0, 0.05)}, tmp_path / name)
        model = read(tmp_path / name)
        assert of(model, "a").joints[0].limits == pytest.approx((-0.5, 0.25))
        assert of(model, "b").joints[0].limits == pytest.approx((0.125, 0.125))
        assert of(model, "b").joints[0].locked
        assert of(model, "c").joints[0].limits == pytest.approx((0.0, 0.05))
        assert np.allclose(of(model, "a").joints[0].axis, of(original, "a").joints[0].axis)
        assert np.allclose(
            of(model, "c").geoms[0].convex.bounds(), of(original, "c").geoms[0].convex.bounds()
        )
    assert Sdf.Layer.FindOrOpen(str(tmp_path / "copy.usda")).subLayerPaths == ["./a.usda"]
    assert read(path).bodies[1].joints[0].limits == original.bodies[1].joints[0].limits
    with pytest.raises(AssetError, match=r"is no package; name it \.usda"):
        repaired_usd(path, {}, tmp_path / "copy.usdz")


def test_a_joint_in_an_instance_is_repaired(tmp_path: Path) -> None:
    part = body("a") + body("b") + joint("Revolute", "h", "a", "b", limits(0, 90))
    write(tmp_path, part, name="part.usda")
    path = write(tmp_path, prim("Xform", "i", more="references = @./part.usda@\ninstanceable = true"))
    repaired_usd(path, {"h": (0.0, 0.5)}, tmp_path / "copy.usda")
    assert of(read(tmp_path / "copy.usda"), "b").joints[0].limits == pytest.approx((0.0, 0.5))
