"""Reading of USD: random trees against their construction, links, odd values, and repaired limits."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from pxr import Gf, Usd, UsdGeom, UsdPhysics
from scipy.spatial.transform import Rotation

from artgen.errors import AssetError, ExportError
from artgen.referee.model import ForeignModel
from artgen.referee.usd import model_of, repaired_usd

_HEAD = '#usda 1.0\n(\nmetersPerUnit = 1\nupAxis = "Z"\ndefaultPrim = "top"\n)\n'
_CUBE = 'def Cube "box" (prepend apiSchemas = ["PhysicsCollisionAPI"]) {\n}\n'
_ENDS = "rel physics:body0 = </top/base>\nrel physics:body1 = </top/arm>\n"
_LIMITS = "float physics:lowerLimit = 0\nfloat physics:upperLimit = 90\n"
_HINGE = f'def PhysicsRevoluteJoint "hinge" {{\n{_ENDS}{_LIMITS}}}\n'
_BODIES = "".join(
    f'def Xform "{name}" (prepend apiSchemas = ["PhysicsRigidBodyAPI"]) {{\n{inner}{_CUBE}}}\n'
    for name, inner in (("base", "bool physics:kinematicEnabled = 1\n"), ("arm", ""))
)


def write(path: Path, text: str) -> Path:
    path.write_text(f'{_HEAD}def Xform "top" {{\n{text}\n}}\n', encoding="utf-8")
    return path


def read(path: Path) -> ForeignModel:
    return model_of(path, "hull", path.parent)


def pose(random: np.random.Generator, turn: Any = None, at: Any = None) -> Any:
    result = np.eye(4)
    result[:3, :3] = Rotation.random(rng=random).as_matrix() if turn is None else turn.as_matrix()
    result[:3, 3] = random.normal(size=3) if at is None else at
    return result


def random_stage(path: Path, random: np.random.Generator) -> dict[str, float]:
    """Write a tree of bodies in a random pose, and return the positions of its joints [rad or units]."""
    stage = Usd.Stage.CreateNew(str(path))
    UsdGeom.SetStageMetersPerUnit(stage, float(random.choice([1.0, 0.01])))
    UsdGeom.SetStageUpAxis(stage, str(random.choice(["Y", "Z"])))
    top, count = UsdGeom.Xform.Define(stage, "/top"), int(random.integers(2, 8))
    top.MakeMatrixXform().Set(Gf.Matrix4d(*pose(random).T.ravel().tolist()))
    fixed, q, places, scales = int(random.integers(2 * count)), {}, [pose(random)], random.choice([1, 2], 8)
    for number in range(count):
        if number:
            parent, axis = int(random.integers(number)), int(random.integers(3))
            kind, position = str(random.choice(["Revolute", "Prismatic", "Fixed", ""])), random.uniform(-2, 2)
            turns, moves = kind in ("Revolute", ""), kind == "Prismatic"
            step = pose(random, Rotation.from_rotvec(turns * position * np.eye(3)[axis]), (0, 0, 0))
            step[axis, 3] = moves * position
            frames, names = [pose(random), pose(random)], [parent, number]
            if random.random() < 0.5:  # the child is the first body
                places.append(places[parent] @ frames[1] @ np.linalg.inv(step) @ np.linalg.inv(frames[0]))
                names.reverse()
            else:
                places.append(places[parent] @ frames[0] @ step @ np.linalg.inv(frames[1]))
            joint = getattr(UsdPhysics, f"{kind}Joint").Define(stage, f"/top/j{number}")
            for end, (name, frame) in enumerate(zip(names, frames, strict=True)):
                x, y, z, w = Rotation.from_matrix(frame[:3, :3]).as_quat().tolist()
                at = (frame[:3, 3] / scales[name]).tolist()
                getattr(joint, f"CreateBody{end}Rel")().SetTargets([f"/top/b{name}"])
                getattr(joint, f"CreateLocalPos{end}Attr")(Gf.Vec3f(*at))
                getattr(joint, f"CreateLocalRot{end}Attr")(Gf.Quatf(w, x, y, z))
            if kind in ("Revolute", "Prismatic"):
                joint.CreateAxisAttr("XYZ"[axis])
            for each in ("transX", "transY", "transZ", "rotX", "rotY", "rotZ") if not kind else ():
                if each != "rot" + "XYZ"[axis]:
                    limit = UsdPhysics.LimitAPI.Apply(joint.GetPrim(), each)
                    limit.CreateLowAttr(1.0)
                    limit.CreateHighAttr(-1.0)
            if kind != "Fixed":
                q[f"j{number}"] = float(position)
        body = UsdGeom.Xform.Define(stage, f"/top/b{number}")
        matrix = places[number] @ np.diag([*[scales[number]] * 3, 1.0])
        body.MakeMatrixXform().Set(Gf.Matrix4d(*matrix.T.ravel().tolist()))
        UsdPhysics.RigidBodyAPI.Apply(body.GetPrim()).CreateKinematicEnabledAttr(number == fixed)
        cube = UsdGeom.Cube.Define(stage, f"/top/b{number}/c{number}")
        UsdPhysics.CollisionAPI.Apply(cube.GetPrim())
        cube.AddTranslateOp().Set(Gf.Vec3d(*random.normal(size=3).tolist()))
    stage.GetRootLayer().Save()
    return q


@pytest.mark.parametrize("seed", range(25))
def test_joints_take_bodies_back_to_the_pose_in_the_file(seed: int, tmp_path: Path) -> None:
    q = random_stage(tmp_path / "tree.usda", np.random.default_rng(seed))
    stage, model = Usd.Stage.Open(str(tmp_path / "tree.usda")), read(tmp_path / "tree.usda")
    unit = UsdGeom.GetStageMetersPerUnit(stage)
    turn = np.eye(3) if UsdGeom.GetStageUpAxis(stage) == "Z" else np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]])
    joints = [joint for body in model.bodies for joint in body.joints]
    assert {joint.name for joint in joints} == q.keys()
    motions, cache = {"": np.eye(4)}, UsdGeom.XformCache()
    for body in model.bodies:
        motion = motions[body.parent]
        for joint in body.joints:
            scale = unit if joint.kind == "prismatic" else 1.0
            motion = motion @ joint.motion(scale * q[joint.name])
        motions[body.name] = motion
        (geom,) = body.geoms
        placed = cache.GetLocalToWorldTransform(stage.GetPrimAtPath(f"/top/{body.name}/{geom.name}"))
        expected = unit * turn @ np.array(placed).T[:3, 3]
        assert np.allclose((motion @ geom.convex.pose)[:3, 3], expected, atol=1e-5 * unit)
    assert not model.notes


def test_a_layer_behind_a_link_is_checked_where_openusd_looks_for_it(tmp_path: Path) -> None:
    root, secret = tmp_path / "root", tmp_path / "secret.usda"
    (root / "sub" / "deep").mkdir(parents=True)
    write(secret, _CUBE)
    (root / "link").symlink_to(root / "sub" / "deep")
    for text, innocent in (("./x.usda", "sub/x.usda"), ("../x.usda", "sub/x.usda")):
        inner = root / "sub" / ("real.usda" if text == "./x.usda" else "deep/real.usda")
        write(inner, f'def Xform "a" (references = @{text}@) {{\n}}\n')
        write(root / innocent, "")
    (root / "real.usda").symlink_to(root / "sub" / "real.usda")
    (root / "x.usda").symlink_to(secret)
    for name in ("real.usda", "link/real.usda"):
        path = write(root / "a.usda", f'def Xform "a" (references = @./{name}@) {{\n}}\n')
        with pytest.raises(AssetError, match=r"x.usda' of 'real.usda' .* is outside .*give --root DIR"):
            read(path)
        assert model_of(path, "hull", tmp_path).bodies


def test_odd_values_are_named(tmp_path: Path) -> None:
    path = write(tmp_path / "a.usda", _CUBE)
    path.write_text(path.read_text().replace('"Z"', '"X"'))
    with pytest.raises(AssetError, match=r"^a.usda: upAxis is 'X'; give Y or Z"):
        read(path)
    for inner in ('string physics:lowerLimit = "x"\n', "float3 physics:localRot0 = (1, 2, 3)\n"):
        text = _BODIES + _HINGE.replace(_LIMITS, inner)
        with pytest.raises(AssetError, match=r"^a.usda: an attribute has a value of a wrong type") as caught:
            read(write(path, text))
        assert "\n" not in str(caught.value)


def test_triggers_and_stretched_round_colliders_are_noted(tmp_path: Path) -> None:
    trigger = _CUBE.replace('["', '["PhysxTriggerAPI", "')
    scale = 'float3 xformOp:scale = (1, 2, 3)\nuniform token[] xformOpOrder = ["xformOp:scale"]\n'
    ball = _CUBE.replace("Cube", "Sphere").replace("box", "ball").replace("{\n", "{\n" + scale)
    model = read(write(tmp_path / "a.usda", trigger + ball))
    assert [geom.name for body in model.bodies for geom in body.geoms] == ["ball"]
    assert [note.rpartition(" ")[2] for note in model.notes] == ["box", "ball"]
    assert model.notes[0].startswith("trigger volumes, which nothing touches, are not judged")
    assert "keep them round, with the largest scale" in model.notes[1]


def test_a_fixed_joint_wins_over_a_hinge_of_the_same_bodies(tmp_path: Path) -> None:
    text = _BODIES + _HINGE + f'def PhysicsFixedJoint "weld" {{\n{_ENDS}}}\n'
    model = read(write(tmp_path / "a.usda", text))
    assert [body.joints for body in model.bodies] == [(), ()]
    assert not model.restricted
    assert model.notes == ("joints between bodies that are fixed to each other are ignored (1): hinge",)


@pytest.mark.parametrize(
    ("limits", "name", "message"),
    [
        ({"hing": (0.0, 1.0)}, "b.usda", "a.usda has no joint 'hing' with limits. Did you mean 'hinge'?"),
        ({"hinge": (1.0, 0.0)}, "b.usda", "joint 'hinge' cannot have the limits 1, 0"),
        ({"hinge": (0.0, np.nan)}, "b.usda", "joint 'hinge' cannot have the limits 0, nan"),
        ({"hinge": (0.0, 1.0)}, "a.usda", "another file in the folder of"),
        ({"hinge": (0.0, 1.0)}, "no/b.usda", "another file in the folder of"),
    ],
)
def test_impossible_repairs_are_refused(limits: Any, name: str, message: str, tmp_path: Path) -> None:
    path = write(tmp_path / "a.usda", _BODIES + _HINGE)
    before = path.read_text()
    with pytest.raises(AssetError) as caught:
        repaired_usd(path, limits, tmp_path / name)
    assert message in str(caught.value)
    assert path.read_text() == before


def test_a_repaired_limit_never_exceeds_what_was_proven(tmp_path: Path) -> None:
    path = write(tmp_path / "a.usda", _BODIES + _HINGE)
    for low, high in np.random.default_rng(0).uniform((-3.0, 0.1), (-0.1, 3.0), (20, 2)).tolist():
        for name in ("b.usda", "b.usdc"):
            repaired_usd(path, {"hinge": (low, high)}, tmp_path / name)
            (found,) = read(tmp_path / name).bodies[1].joints
            assert found.limits is not None
            assert low - 1e-15 <= found.limits[0] <= low + 1e-6
            assert high - 1e-6 <= found.limits[1] <= high + 1e-15
    repaired_usd(path, {"hinge": (0.3, 0.3)}, tmp_path / "b.usda")
    assert read(tmp_path / "b.usda").bodies[1].joints[0].locked
    (tmp_path / "c.usda").mkdir()
    with pytest.raises(ExportError, match=r"cannot write .*c.usda"):
        repaired_usd(path, {"hinge": (0.0, 1.0)}, tmp_path / "c.usda")
