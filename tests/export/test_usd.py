"""USD as pxr reads it back, against the asset."""

import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from PIL import Image
from pxr import Gf, Usd, UsdGeom, UsdPhysics, UsdSemantics, UsdShade, UsdValidation

from artgen.asset import Asset, Push
from artgen.asset import AssetJoint as Joint
from artgen.asset.surface import texture_coordinates
from artgen.colliders import Convex
from artgen.export.frames import chain
from artgen.export.meshes import display_color
from artgen.export.usd import write_usd
from artgen.export.usd.joints import _turn_from_x
from artgen.export.usd.layer import THING, quatf
from artgen.materials import Material
from artgen.materials.substance import substance_of
from support.textured import BOARD, LAMP, PANE, PLATE, TURNED, picture, recipes, textured

Array = NDArray[np.float64]

ASSETS = ("cabinet", "free_cabinet", "nested", "textured")

anew = settings(max_examples=15, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])


@pytest.fixture(scope="module", autouse=True)
def registered_recipes():
    with recipes():
        yield


@pytest.fixture(scope="module")
def stages(tmp_path_factory, cabinet, free_cabinet, nested) -> dict[str, tuple[Asset, Usd.Stage]]:
    """Every asset with its stage, opened from files."""
    result = {}
    for name, asset in zip(ASSETS, (cabinet, free_cabinet, nested, textured()), strict=True):
        result[name] = (asset, _opened(asset, tmp_path_factory.mktemp(name), 256 * (name == "textured")))
    return result


def _opened(asset: Asset, directory: Path, textures: int = 0) -> Usd.Stage:
    for name, content in write_usd(asset, textures).files.items():
        (directory / name).parent.mkdir(parents=True, exist_ok=True)
        (directory / name).write_bytes(content)
    return Usd.Stage.Open(str(directory / f"{asset.name}.usda"))


def _prim(stage: Usd.Stage, path: str) -> Usd.Prim:
    prim = stage.GetDefaultPrim().GetPrimAtPath(path)
    assert prim, f"no prim {path}"
    return prim


def _joint(stage: Usd.Stage, name: str) -> Usd.Prim:
    return _prim(stage, f"joints/{name}")


def _value(prim: Usd.Prim, name: str) -> object:
    attribute = prim.GetAttribute(name)
    assert attribute.HasAuthoredValue(), f"{prim.GetPath()} has no {name}"
    return attribute.Get()


def _matrix(matrix: Gf.Matrix4d) -> Array:
    return np.array(matrix).T


def _placement(prim: Usd.Prim) -> Array:
    return _matrix(UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(Usd.TimeCode.Default()))


def _frame(position: Gf.Vec3f, turn: Gf.Quatf) -> Array:
    result = np.eye(4)
    result[:3, :3] = _matrix(Gf.Matrix4d().SetRotate(Gf.Quatd(turn)))[:3, :3]
    result[:3, 3] = position
    return result


def _moved(joint: UsdPhysics.Joint, position: float) -> Array:
    """Return the child in the parent as a simulator computes it: along or about x of the joint's frame."""
    motion = np.eye(4)
    if joint.GetPrim().IsA(UsdPhysics.RevoluteJoint):
        angle = np.radians(position)
        motion[1:3, 1:3] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
    elif joint.GetPrim().IsA(UsdPhysics.PrismaticJoint):
        motion[0, 3] = position
    first = _frame(joint.GetLocalPos0Attr().Get(), joint.GetLocalRot0Attr().Get())
    second = _frame(joint.GetLocalPos1Attr().Get(), joint.GetLocalRot1Attr().Get())
    return first @ motion @ np.linalg.inv(second)


def _simulated(stage: Usd.Stage, q: dict[str, float]) -> dict[str, Array]:
    """Return the pose of every body from the joints alone; q in degrees and metres."""
    bodies: dict[str, Array] = {}
    for prim in _prim(stage, "joints").GetChildren():
        joint = UsdPhysics.Joint(prim)
        parents, children = joint.GetBody0Rel().GetTargets(), joint.GetBody1Rel().GetTargets()
        if not parents:
            bodies[children[0].name] = _frame(joint.GetLocalPos0Attr().Get(), joint.GetLocalRot0Attr().Get())
            continue
        parent = bodies.setdefault(parents[0].name, np.eye(4))
        bodies[children[0].name] = parent @ _moved(joint, q.get(prim.GetName(), 0.0))
    return bodies


def _units(joint: Joint) -> float:
    return 180.0 / np.pi if joint.kind == "revolute" else 1.0


def _origin(asset: Asset, link: str) -> Array:
    result = np.eye(4)
    result[:3, 3] = asset.origin(link)
    return result


@pytest.mark.parametrize("name", ASSETS)
def test_no_validator_finds_anything(stages, name, capfd):
    _, stage = stages[name]
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    assert len(validators) > 20
    errors = UsdValidation.ValidationContext(validators).Validate(stage)
    assert [error.GetMessage() for error in errors] == []
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("name", ASSETS)
@given(data=st.data())
@anew
def test_bodies_stand_where_the_asset_puts_them(stages, name, data):
    asset, stage = stages[name]
    q = {
        joint.name: data.draw(st.floats(*(joint.limits or (-6.0, 6.0))), label=joint.name)
        for joint in asset.free_joints
    }
    positions = asset.positions(q)
    bodies = _simulated(stage, {n: p * _units(asset.joint(n)) for n, p in positions.items()})
    for link, displacement in asset.pose(q).items():
        assert bodies[link] == pytest.approx(displacement @ _origin(asset, link), abs=1e-6)


@pytest.mark.parametrize("name", ASSETS)
def test_bodies_are_placed_as_the_asset_stands(stages, name):
    asset, stage = stages[name]
    for link, displacement in asset.pose().items():
        prim = _prim(stage, link)
        assert _placement(prim) == pytest.approx(displacement @ _origin(asset, link), abs=1e-12)
        assert list(_value(prim, "xformOpOrder")) == ["xformOp:translate", "xformOp:orient"]
    between = [segment.child for segment in chain(asset) if segment.child.link is None]
    for frame in between:
        assert _placement(_prim(stage, frame.name)) == pytest.approx(frame.placement, abs=1e-12)


@pytest.mark.parametrize("name", ASSETS)
def test_mass_properties_are_the_assets(stages, name):
    asset, stage = stages[name]
    for link in asset.links:
        mass = UsdPhysics.MassAPI(_prim(stage, link.name))
        expected = link.mass_properties
        axes = _matrix(Gf.Matrix4d().SetRotate(Gf.Quatd(mass.GetPrincipalAxesAttr().Get())))[:3, :3]
        inertia = axes @ np.diag(mass.GetDiagonalInertiaAttr().Get()) @ axes.T
        assert mass.GetMassAttr().Get() == pytest.approx(expected.mass, rel=1e-6)
        assert mass.GetCenterOfMassAttr().Get() + asset.origin(link.name) == pytest.approx(
            expected.center, abs=1e-6
        )
        assert inertia == pytest.approx(expected.inertia, abs=1e-6 * np.abs(expected.inertia).max())


def test_bodies_between_joints_are_light_and_valid(stages):
    _, stage = stages["cabinet"]
    mass = UsdPhysics.MassAPI(_prim(stage, "knob_knob_slide"))
    assert 0.0 < mass.GetMassAttr().Get() < 1e-4
    low, middle, high = sorted(mass.GetDiagonalInertiaAttr().Get())
    assert 0.0 < high <= low + middle


def test_several_joints_act_in_order_parent_first(stages):
    _, stage = stages["cabinet"]
    slide, turn = (UsdPhysics.Joint(_joint(stage, name)) for name in ("knob_slide", "knob_turn"))
    assert [path.name for path in slide.GetBody0Rel().GetTargets()] == ["body"]
    assert slide.GetBody1Rel().GetTargets() == turn.GetBody0Rel().GetTargets()
    assert [path.name for path in turn.GetBody1Rel().GetTargets()] == ["knob"]


@pytest.mark.parametrize("name", ASSETS)
def test_limits_are_in_degrees_and_metres(stages, name):
    asset, stage = stages[name]
    coupled = {joint.name for joint in asset.joints if joint.follows is not None}
    coupled |= {joint.follows.leader for joint in asset.joints if joint.follows is not None}
    for joint in asset.joints:
        prim = _joint(stage, joint.name)
        if joint.locked:
            assert prim.IsA(UsdPhysics.FixedJoint)
        elif joint.limits is not None:
            ends = [_value(prim, "physics:lowerLimit"), _value(prim, "physics:upperLimit")]
            assert ends == pytest.approx(np.array(joint.limits) * _units(joint), rel=1e-6, abs=1e-9)
            assert _value(prim, "physics:axis") == "X"
        elif joint.name in coupled:
            assert _value(prim, "physics:upperLimit") > 360.0 * 1e4
        else:
            assert prim.GetAttribute("physics:lowerLimit").Get() == -np.inf
            assert prim.GetAttribute("physics:upperLimit").Get() == np.inf


def test_springs_and_friction_are_per_degree(stages):
    asset, stage = stages["cabinet"]
    joint, prim = asset.joint("lid_hinge"), _joint(stage, "lid_hinge")
    drive = UsdPhysics.DriveAPI(prim, "angular")
    assert drive.GetTypeAttr().Get() == "force"
    assert drive.GetStiffnessAttr().Get() == pytest.approx(np.radians(joint.stiffness))
    assert drive.GetDampingAttr().Get() == pytest.approx(np.radians(joint.damping))
    assert drive.GetTargetPositionAttr().Get() == pytest.approx(np.degrees(joint.rest))
    for instance in ("physxJointAxis:angular:staticFrictionEffort", "newton:friction"):
        assert _value(prim, instance) == pytest.approx(joint.friction)
    for instance in ("physxJointAxis:angular:armature", "newton:armature"):
        assert _value(prim, instance) == pytest.approx(joint.armature)
    for instance in ("physxJointAxis:angular:maxJointVelocity", "newton:velocityLimit"):
        assert _value(prim, instance) == pytest.approx(np.degrees(joint.velocity))
    slide = UsdPhysics.DriveAPI(_joint(stage, "knob_slide"), "linear")
    assert slide.GetDampingAttr().Get() == pytest.approx(asset.joint("knob_slide").damping)


@pytest.mark.parametrize(
    ("changes", "bounded"),
    [
        ({"stiffness": 10.0, "rest": -0.6, "limits": (0.0, 1.4), "effort": 21.0}, True),
        ({"stiffness": 10.0, "rest": -0.6, "limits": (0.0, 1.4), "effort": 19.0}, False),
        ({"stiffness": 10.0, "limits": None}, False),
        ({"stiffness": 0.0, "damping": 2.0, "velocity": 10.0, "effort": 19.0}, False),
        ({"stiffness": 0.0, "damping": 0.0, "effort": 0.001}, True),
    ],
)
def test_effort_never_weakens_the_joints_own_spring(tmp_path, cabinet, changes, bounded):
    clean = {"damping": 0.0, "needs": None} | changes
    joints = tuple(
        replace(joint, **clean) if joint.name == "lid_hinge" else joint for joint in cabinet.joints
    )
    asset = replace(cabinet, joints=joints)
    stage = _opened(asset, tmp_path)
    drive = UsdPhysics.DriveAPI(_joint(stage, "lid_hinge"), "angular")
    expected = clean.get("effort", 40.0) if bounded else np.inf
    assert drive.GetMaxForceAttr().Get() == pytest.approx(expected)
    lost = [loss.where for loss in write_usd(asset).losses if loss.feature == "joint effort"]
    assert lost == ([] if bounded else ["lid_hinge"])


def test_coupling_of_a_slide_with_a_rotation_is_in_each_simulators_units(stages):
    asset, stage = stages["cabinet"]
    prim, coupling = _joint(stage, "bolt_slide"), asset.joint("bolt_slide").follows
    schemas = prim.GetMetadata("apiSchemas").GetAddedOrExplicitItems()
    assert "NewtonMimicAPI" not in schemas  # PhysX and Newton would read it in different units
    # PhysX holds 0 for the sum of the slide, the geared turn in degrees and the offset
    degrees = 30.0
    expected = coupling.ratio * np.radians(degrees) + coupling.offset
    gearing, offset = (_value(prim, f"physxMimicJoint:rotX:{name}") for name in ("gearing", "offset"))
    assert -gearing * degrees - offset == pytest.approx(expected)
    assert _value(prim, "mjc:coef1") == coupling.ratio
    assert _value(prim, "mjc:coef0") == coupling.offset
    for name in ("physxMimicJoint:rotX:referenceJoint", "mjc:target"):
        assert prim.GetRelationship(name).GetTargets() == [_joint(stage, "lever_turn").GetPath()]
    assert not prim.HasAPI(UsdPhysics.DriveAPI)


def test_coupling_of_two_rotations_reads_the_same_in_both_schemas(stages):
    asset, stage = stages["nested"]
    prim, coupling = _joint(stage, "spin"), asset.joint("spin").follows
    assert _value(prim, "newton:mimicCoef1") == coupling.ratio
    assert _value(prim, "newton:mimicCoef0") == pytest.approx(np.degrees(coupling.offset))
    assert _value(prim, "physxMimicJoint:rotX:gearing") == -coupling.ratio
    assert _value(prim, "physxMimicJoint:rotX:offset") == pytest.approx(-np.degrees(coupling.offset))
    for name in ("physxMimicJoint:rotX:referenceJoint", "newton:mimicJoint"):
        assert prim.GetRelationship(name).GetTargets() == [_joint(stage, "wrist").GetPath()]


def test_joints_that_do_not_stand_at_zero_say_where_they_stand(stages):
    asset, stage = stages["nested"]
    assert _value(_joint(stage, "swing"), "state:angular:physics:position") == pytest.approx(np.degrees(0.2))
    assert _value(_joint(stage, "spin"), "state:angular:physics:position") == pytest.approx(np.degrees(0.1))
    assert not _joint(stage, "wrist").GetAttribute("state:angular:physics:position")
    assert asset.positions()["wrist"] == 0.0


@pytest.mark.parametrize(("name", "fixed"), [("cabinet", True), ("free_cabinet", False)])
def test_base_is_fixed_or_free(stages, name, fixed):
    _, stage = stages[name]
    roots = [prim for prim in stage.Traverse() if prim.HasAPI(UsdPhysics.ArticulationRootAPI)]
    assert [prim.GetName() for prim in roots] == ["cabinet_7" if fixed else "body"]
    joint = stage.GetDefaultPrim().GetPrimAtPath("joints/root_joint")
    assert bool(joint) == fixed
    if fixed:
        assert joint.IsA(UsdPhysics.FixedJoint)
        assert UsdPhysics.Joint(joint).GetBody0Rel().GetTargets() == []


def _assert_same_convex(prim: Usd.Prim, convex: Convex, origin: Array) -> None:
    pose = np.linalg.inv(_placement(prim.GetParent())) @ _placement(prim)
    pose[:3, 3] += origin
    if convex.kind == "hull":
        points = np.array(_value(prim, "points")) @ pose[:3, :3].T + pose[:3, 3]
        assert sorted(map(tuple, points.round(6))) == sorted(map(tuple, convex.points.round(6)))
        assert _value(prim, "physics:approximation") == "convexHull"
        return
    scale = np.linalg.norm(pose[:3, :3], axis=0)
    pose[:3, :3] /= scale
    assert pose == pytest.approx(convex.pose, abs=1e-9)
    assert scale == pytest.approx(convex.size if convex.kind == "box" else (1.0, 1.0, 1.0))
    fields = {"box": (), "sphere": ("radius",)}.get(convex.kind, ("radius", "height"))
    assert tuple(_value(prim, field) for field in fields) == (convex.size if fields else ())
    assert prim.GetTypeName() == {"box": "Cube"}.get(convex.kind, convex.kind.capitalize())


@pytest.mark.parametrize("name", ASSETS)
def test_colliders_are_the_links(stages, name):
    asset, stage = stages[name]
    for link in asset.links:
        prims = _prim(stage, f"{link.name}/collisions").GetChildren()
        prims = sorted(prims, key=lambda prim: int(prim.GetName().split("_")[-1]))
        assert len(prims) == len(link.colliders)
        for prim, collider in zip(prims, link.colliders, strict=True):
            _assert_same_convex(prim, collider.convex, asset.origin(link.name))
            extent = UsdGeom.Boundable.ComputeExtentFromPlugins(UsdGeom.Boundable(prim), 0.0)
            assert np.array(_value(prim, "extent")) == pytest.approx(np.array(extent), abs=1e-6)
            assert prim.HasAPI(UsdPhysics.CollisionAPI)
            assert UsdGeom.Imageable(prim).ComputePurpose() == "guide"
            bound, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial("physics")
            friction = UsdPhysics.MaterialAPI(bound.GetPrim()).GetDynamicFrictionAttr().Get()
            assert friction == pytest.approx(collider.material.friction)


def test_hull_colliders_are_closed_and_outward(stages):
    asset, stage = stages["cabinet"]
    mesh = UsdGeom.Mesh(_prim(stage, "lid/collisions/hull_0"))
    points = np.array(mesh.GetPointsAttr().Get(), float)
    triangles = np.array(mesh.GetFaceVertexIndicesAttr().Get()).reshape(-1, 3)
    edges = {tuple(edge) for turn in ([0, 1], [1, 2], [2, 0]) for edge in triangles[:, turn].tolist()}
    assert {(b, a) for a, b in edges} == edges
    a, b, c = (points[triangles[:, corner]] for corner in range(3))
    volume = np.einsum("ij,ij->", a, np.cross(b, c)) / 6.0
    assert volume == pytest.approx(0.6 * 0.4 * 0.02, rel=1e-5)
    normals = np.array(mesh.GetNormalsAttr().Get())
    assert mesh.GetNormalsInterpolation() == "uniform"
    assert np.einsum("ij,ij->i", normals, np.cross(b - a, c - a)).min() > 0.0
    assert asset.link("lid").colliders[0].convex.kind == "hull"


@pytest.mark.parametrize("name", ASSETS)
def test_visuals_are_the_surfaces(stages, name):
    asset, stage = stages[name]
    for link in asset.links:
        for surface in link.surfaces:
            prim = _prim(stage, f"{link.name}/visuals/{surface.name}")
            mesh = UsdGeom.Mesh(prim)
            points = np.array(mesh.GetPointsAttr().Get()) + asset.origin(link.name)
            assert points == pytest.approx(surface.mesh.vertices, abs=1e-6)
            assert np.array(mesh.GetNormalsAttr().Get()) == pytest.approx(surface.mesh.normals, abs=1e-6)
            corners = np.array(mesh.GetFaceVertexIndicesAttr().Get())
            assert (corners == surface.mesh.triangles.ravel()).all()
            st_primvar = UsdGeom.PrimvarsAPI(prim).GetPrimvar("st")
            assert st_primvar.IsIndexed()
            assert np.array(st_primvar.ComputeFlattened()) == pytest.approx(
                texture_coordinates(surface.mesh, surface.material), rel=1e-6, abs=1e-6
            )
            assert mesh.GetSubdivisionSchemeAttr().Get() == "none"
            assert UsdSemantics.LabelsAPI(prim, "part").GetLabelsAttr().Get() == [surface.label]
            material, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()
            assert material.GetPrim().GetName() == surface.material.name


def test_materials_look_as_the_assets(stages):
    asset, stage = stages["cabinet"]
    for material in asset.materials:
        surface = UsdShade.Material(_prim(stage, f"looks/{material.name}")).ComputeSurfaceSource()[0]
        inputs = {item.GetBaseName(): item.Get() for item in surface.GetInputs()}
        assert surface.GetIdAttr().Get() == "UsdPreviewSurface"
        assert inputs["diffuseColor"] == pytest.approx(material.base_color)
        assert inputs["emissiveColor"] == pytest.approx(material.emission)
        assert inputs["roughness"] == pytest.approx(material.specular_roughness)
        assert inputs["metallic"] == pytest.approx(material.base_metalness)
        assert inputs["opacity"] == pytest.approx(material.opacity)


def _inputs(stage: Usd.Stage, stuff: Material) -> dict[str, UsdShade.Shader | object]:
    """Return each input of a material's surface: its value, or the shader that it is connected to."""
    surface = UsdShade.Material(_prim(stage, f"looks/{stuff.name}")).ComputeSurfaceSource()[0]
    found = {}
    for item in surface.GetInputs():
        source = item.GetConnectedSources()[0]
        found[item.GetBaseName()] = UsdShade.Shader(source[0].source) if source else item.Get()
    return found


def _read(shader: UsdShade.Shader) -> dict[str, object]:
    return {item.GetBaseName(): item.Get() for item in shader.GetInputs()}


def test_maps_are_read_at_the_texture_coordinates_in_their_color_space(stages):
    _, stage = stages["textured"]
    expected = {
        BOARD: {"diffuseColor", "normal", "roughness"},
        TURNED: {"diffuseColor", "normal", "roughness"},
        PLATE: {"roughness", "metallic"},
        PANE: {"roughness"},
        LAMP: set(),
    }
    for stuff, mapped in expected.items():
        inputs = _inputs(stage, stuff)
        shaders = {name: each for name, each in inputs.items() if isinstance(each, UsdShade.Shader)}
        assert set(shaders) == mapped, stuff.name
        for name, shader in shaders.items():
            found = _read(shader)
            assert shader.GetIdAttr().Get() == "UsdUVTexture"
            assert Path(found["file"].resolvedPath).is_file()
            assert found["file"].path.startswith("./meshes/textures/")
            assert (found["wrapS"], found["wrapT"]) == ("repeat", "repeat")
            assert found["sourceColorSpace"] == ("sRGB" if name == "diffuseColor" else "raw")
            assert (found.get("scale"), found.get("bias")) == (
                ((2, 2, 2, 1), (-1, -1, -1, 0)) if name == "normal" else (None, None)
            )
            (reader,), _ = shader.GetInput("st").GetConnectedSources()
            assert _read(UsdShade.Shader(reader.source))["varname"] == "st"
            with Image.open(found["file"].resolvedPath) as image:
                assert image.size == (256, 256)


def test_numbers_stand_where_there_is_no_map(stages):
    _, stage = stages["textured"]
    for stuff in (PLATE, PANE, LAMP):
        inputs = _inputs(stage, stuff)
        assert inputs["diffuseColor"] == pytest.approx(stuff.base_color)
        assert inputs["emissiveColor"] == pytest.approx(stuff.emission)
        assert inputs["clearcoat"] == pytest.approx(stuff.coat_weight)
        assert inputs["clearcoatRoughness"] == pytest.approx(stuff.coat_roughness)
        assert inputs["opacity"] == pytest.approx(stuff.opacity)
        assert inputs["ior"] == pytest.approx(1.5)
    assert _inputs(stage, LAMP)["roughness"] == pytest.approx(LAMP.specular_roughness)
    assert _inputs(stage, PANE)["metallic"] == 0.0


@pytest.mark.parametrize(("link", "stuff"), [("board", BOARD), ("plank", TURNED)])
def test_picture_is_upright_and_in_scale(stages, link, stuff):
    """A metre along the grain of a face is one repeat of v for each length of the tile, whatever the face."""
    asset, stage = stages["textured"]
    mesh = UsdGeom.Mesh(_prim(stage, f"{link}/visuals/{link}_{stuff.name}"))
    st_primvar = UsdGeom.PrimvarsAPI(mesh.GetPrim()).GetPrimvar("st").ComputeFlattened()
    corners = np.array(mesh.GetFaceVertexIndicesAttr().Get()).reshape(-1, 3)
    points, found = np.array(mesh.GetPointsAttr().Get(), float), np.array(st_primvar, float)
    # the tile's area and each triangle's own say how many repeats it has
    edges = points[corners[:, 1:]] - points[corners[:, :1]]
    areas = np.linalg.norm(np.cross(edges[:, 0], edges[:, 1]), axis=1)
    across, along = (found[corners[:, 1:]] - found[corners[:, :1]]).transpose(1, 0, 2)
    repeats = np.abs(across[:, 0] * along[:, 1] - across[:, 1] * along[:, 0])
    tile = stuff.tile or (0.25, 0.5)
    broad = areas > 0.1 * areas.max()
    assert repeats[broad] * tile[0] * tile[1] == pytest.approx(areas[broad], rel=0.02)
    assert asset.link(link).surfaces[0].material == stuff
    with Image.open(_read(_inputs(stage, stuff)["diffuseColor"])["file"].resolvedPath) as image:
        pixels = np.asarray(image)
    for u, v in ((0.2, 0.3), (0.7, 0.3), (0.2, 0.8), (0.7, 0.8)):  # v is 0 at the lowest row
        wanted = np.array(display_color(picture(u, v, stuff))) * 255.0
        assert pixels[int((1.0 - v) * 256), int(u * 256)] == pytest.approx(wanted, abs=1.01)


def test_losses_name_transmission_but_no_coat():
    lost = {loss.feature: loss.where for loss in write_usd(textured(), 256).losses}
    assert lost["transmission"] == "pane"
    assert not {"coat", "texture"} & set(lost)


def test_root_has_units_labels_and_origin(stages):
    asset, stage = stages["cabinet"]
    root = stage.GetDefaultPrim()
    assert UsdGeom.GetStageUpAxis(stage) == "Z"
    assert UsdGeom.GetStageMetersPerUnit(stage) == 1.0
    assert UsdPhysics.GetStageKilogramsPerUnit(stage) == 1.0
    assert Usd.ModelAPI(root).GetKind() == "component"
    assert UsdSemantics.LabelsAPI(root, "category").GetLabelsAttr().Get() == ["cabinet"]
    assert UsdSemantics.LabelsAPI(_prim(stage, "lid"), "part").GetLabelsAttr().Get() == ["lid"]
    made = root.GetCustomDataByKey("artgen")
    assert made == {
        "attempt": 0,
        "category": "cabinet",
        "parameters": {"hand": "left", "width": 0.6},
        "seed": 7,
        "version": "1.0",
    }
    assert asset.seed == made["seed"]


def test_parameters_of_any_type_survive(tmp_path, nested):
    parameters = {
        "handle.length": 0.3,
        "count": 3,
        "open": True,
        "offsets": (1, 2.5),
        "absent": None,
        "rows": ["a", 1],
        "inner": {"x": 1.0},
        "large": 2**70,
    }
    stage = _opened(replace(nested, parameters=parameters, seed=2**70), tmp_path)
    made = stage.GetDefaultPrim().GetCustomData()["artgen"]
    assert made["seed"] == str(2**70)
    assert list(made["parameters"].pop("offsets")) == [1.0, 2.5]
    assert made["parameters"] == {
        "handle.length": 0.3,
        "count": 3,
        "open": True,
        "rows": '["a", 1]',
        "inner": {"x": 1.0},
        "large": str(2**70),
    }


def test_grasps_are_frames_on_their_links(stages):
    asset, stage = stages["cabinet"]
    (grasp,) = asset.link("lid").grasps
    prim = _prim(stage, f"lid/grasps/{grasp.name}")
    assert _placement(prim) == pytest.approx(grasp.frame, abs=1e-12)
    assert prim.GetCustomData()["artgen"]["width"] == grasp.width
    assert UsdGeom.Imageable(prim).ComputePurpose() == "guide"


def test_names_never_clash_with_those_of_the_layout(tmp_path, cabinet):
    names = {"lid": "joints", "dial": "looks"}
    renamed = tuple(replace(link, name=names.get(link.name, link.name)) for link in cabinet.links)
    joints = tuple(
        replace(
            joint,
            child=names.get(joint.child, joint.child),
            name="root_joint" if joint.name == "dial_turn" else joint.name,
        )
        for joint in cabinet.joints
    )
    stage = _opened(replace(cabinet, links=renamed, joints=joints), tmp_path)
    assert _prim(stage, "joints").HasAPI(UsdPhysics.RigidBodyAPI)
    assert _prim(stage, "looks").HasAPI(UsdPhysics.RigidBodyAPI)
    assert _prim(stage, "joints_/root_joint").IsA(UsdPhysics.RevoluteJoint)
    assert _prim(stage, "joints_/root_joint_").IsA(UsdPhysics.FixedJoint)
    errors = UsdValidation.ValidationContext(
        UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    ).Validate(stage)
    assert [error.GetMessage() for error in errors] == []


def test_meshes_are_binary_and_the_rest_is_light(cabinet):
    files = write_usd(cabinet).files
    assert set(files) == {"cabinet_7.usda", "cabinet_7_geometry.usdc"}
    assert files["cabinet_7_geometry.usdc"].startswith(b"PXR-USDC")
    assert b"faceVertexIndices" not in files["cabinet_7.usda"]


def test_losses_name_what_usd_cannot_say(cabinet, nested):
    losses = {loss.feature: loss for loss in write_usd(cabinet).losses}
    assert losses["joint dependency"].where == "lid_hinge"
    assert losses["joint coupling"].where == "bolt_slide"
    assert losses["joint armature"].where == "lid_hinge"
    assert losses["several joints between two links"].where == "knob_knob_slide"
    assert "foot_lock" not in losses["joint velocity limit"].where
    lost = {loss.feature: loss.where for loss in write_usd(nested).losses}
    assert lost["coupling without limits"] == "wrist, spin"
    assert lost["joint that does not stand at 0"] == "swing, spin"


@pytest.mark.parametrize("ratio", [2.0, 1 / 12, -1 / 720])
def test_a_slow_follower_without_limits_has_none_that_count(nested, tmp_path, ratio):
    spin = nested.joint("spin")
    slow = replace(spin, follows=replace(spin.follows, ratio=ratio))
    asset = replace(nested, joints=tuple(slow if each is spin else each for each in nested.joints))
    stage = _opened(asset, tmp_path)
    for name in ("wrist", "spin"):
        joint = UsdPhysics.RevoluteJoint(_prim(stage, f"joints/{name}"))
        low, high = joint.GetLowerLimitAttr().Get(), joint.GetUpperLimitAttr().Get()
        assert low < -1e5 * 180 / np.pi
        assert high > 1e5 * 180 / np.pi


def test_bytes_do_not_depend_on_the_process():
    program = (
        "import hashlib, conftest; from artgen.export.usd import write_usd\n"
        "files = write_usd(conftest.make_cabinet()).files\n"
        "print([(name, hashlib.sha256(files[name]).hexdigest()) for name in sorted(files)])"
    )
    here = Path(__file__).parent
    path = os.pathsep.join([str(here), *filter(None, sys.path)])
    outputs = {
        subprocess.run(
            [sys.executable, "-c", program],
            env={**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": path},
            cwd=here,
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for seed in ("1", "2")
    }
    assert len(outputs) == 1
    assert "usdc" in outputs.pop()


@given(st.tuples(*[st.floats(-1.0, 1.0)] * 4).filter(lambda q: np.linalg.norm(q) > 0.1))
def test_quaternions_turn_as_their_matrices(values):
    w, x, y, z = np.array(values) / np.linalg.norm(values)
    turn = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )
    found = _frame(Gf.Vec3f(0.0), quatf(turn))[:3, :3]
    assert found == pytest.approx(turn, abs=1e-6)


@given(
    st.tuples(st.floats(-1.0, 1.0), st.floats(-1.0, 1.0), st.floats(-1.0, 1.0)).filter(
        lambda axis: np.linalg.norm(axis) > 0.1
    ),
    st.sampled_from([1.0, 1e-4, 1e-6, 1e-9, 1e-17, 0.0]),
)
def test_joint_frames_turn_x_to_any_axis(values, flatness):
    axis = np.array(values) * [1.0, flatness, flatness]
    axis = axis / np.linalg.norm(axis) if np.linalg.norm(axis) > 0.0 else np.array([-1.0, 0.0, 0.0])
    turn = _turn_from_x(axis)
    assert turn[:, 0] == pytest.approx(axis, abs=1e-14)
    assert turn @ turn.T == pytest.approx(np.eye(3), abs=1e-14)
    assert np.linalg.det(turn) == pytest.approx(1.0)


def test_labels_carry_wikidata_codes(stages):
    asset, stage = stages["cabinet"]
    root = stage.GetDefaultPrim()
    assert list(UsdSemantics.LabelsAPI(root, "wikidata_qcode").GetLabelsAttr().Get()) == [THING]
    for stuff in asset.materials:
        prim = _prim(stage, f"looks/{stuff.name}")
        substance = substance_of(stuff)
        labels = list(UsdSemantics.LabelsAPI(prim, "material").GetLabelsAttr().Get())
        assert labels == [substance.name, substance.code]


def test_doors_are_wikidatas_doors(tmp_path, cabinet):
    stage = _opened(replace(cabinet, category="door"), tmp_path)
    labels = UsdSemantics.LabelsAPI(stage.GetDefaultPrim(), "wikidata_qcode").GetLabelsAttr().Get()
    assert list(labels) == ["Q36794"]


def test_sensors_know_the_materials_that_are_seen(stages):
    asset, stage = stages["textured"]
    for stuff in asset.materials:
        prim = _prim(stage, f"looks/{stuff.name}")
        said = [_value(prim, f"omni:simready:nonvisual:{key}") for key in ("base", "coating", "attributes")]
        assert said[0] == substance_of(stuff).sensed
        assert ("visually_transparent" in said[2]) == (stuff == PANE)
        assert ("emissive" in said[2]) == (stuff == LAMP)


@pytest.mark.parametrize("name", ASSETS)
def test_viewers_without_materials_show_the_colors(stages, name):
    asset, stage = stages[name]
    for link in asset.links:
        for surface in link.surfaces:
            prim = _prim(stage, f"{link.name}/visuals/{surface.name}")
            primvars = UsdGeom.PrimvarsAPI(prim)
            (color,) = primvars.GetPrimvar("displayColor").Get()
            assert color == pytest.approx(surface.material.base_color)
            opacity = primvars.GetPrimvar("displayOpacity").Get() or [1.0]
            assert list(opacity) == pytest.approx([surface.material.opacity])


def test_pushes_and_grasps_say_what_they_move(tmp_path, cabinet):
    frame = _frame(Gf.Vec3f(0.0, -0.25, 0.5), Gf.Quatf(0.6, 0.8, 0.0, 0.0)).round(6)
    links = tuple(
        replace(link, pushes=(Push("lid_press", frame),)) if link.name == "lid" else link
        for link in cabinet.links
    )
    stage = _opened(replace(cabinet, links=links), tmp_path)
    push, grasp = _prim(stage, "lid/pushes/lid_press"), _prim(stage, "lid/grasps/lid_edge")
    assert _placement(push) == pytest.approx(frame, abs=1e-12)
    for prim, kind in ((push, "push"), (grasp, "grasp")):
        said = prim.GetCustomData()["artgen"]
        assert (said["kind"], list(said["joints"])) == (kind, ["lid_hinge"])
    assert "width" not in push.GetCustomData()["artgen"]
    assert UsdGeom.Imageable(push).ComputePurpose() == "guide"


@pytest.mark.parametrize("name", ASSETS)
def test_articulation_and_bodies_move_as_in_mjcf(stages, name):
    """Parts collide with each other, and nothing but joints slows them."""
    _, stage = stages[name]
    (root,) = (prim for prim in stage.Traverse() if prim.HasAPI(UsdPhysics.ArticulationRootAPI))
    assert _value(root, "physxArticulation:enabledSelfCollisions") is True
    assert _value(root, "newton:selfCollisionEnabled") is True
    for prim in stage.Traverse():
        if prim.HasAPI(UsdPhysics.RigidBodyAPI):
            assert _value(prim, "physxRigidBody:angularDamping") == 0.0


def test_mujocos_words_stand_beside_the_others_but_for_springs(stages):
    asset, stage = stages["cabinet"]
    joint, prim = asset.joint("lid_hinge"), _joint(stage, "lid_hinge")
    assert _value(prim, "mjc:frictionloss") == joint.friction
    assert _value(prim, "mjc:armature") == joint.armature
    assert _value(prim, "mjc:actuatorfrcrange:max") == joint.effort
    # Newton would add them to the drive
    assert not prim.GetAttribute("mjc:stiffness")
    assert not prim.GetAttribute("mjc:damping")
    for collider in _prim(stage, "lid/collisions").GetChildren():
        schemas = collider.GetMetadata("apiSchemas").GetAddedOrExplicitItems()
        assert {"MjcCollisionAPI", "NewtonMeshCollisionAPI", "PhysicsMeshCollisionAPI"} <= set(schemas)
