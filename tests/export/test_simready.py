"""The SimReady layout as pxr reads it back, and as NVIDIA's validator judges it."""

import json
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ET
from collections.abc import Mapping
from dataclasses import replace
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from pxr import Gf, Sdr, Usd, UsdGeom, UsdPhysics, UsdShade, UsdValidation

import artgen
from artgen.asset import Asset
from artgen.asset.files import main_files
from artgen.export.files import encode
from artgen.export.mjcf import write_mjcf
from artgen.export.thumbnail import NOTHING, rasterize, thumbnail, weights
from support.cases import some
from support.textured import recipes, textured

ASSETS = ("cabinet", "free_cabinet", "nested", "textured")
VARIANTS = ("PhysX", "Newton", "MuJoCo")
PREFIXES = {"PhysX": ("Physx", "physx"), "Newton": ("Newton", "newton:"), "MuJoCo": ("Mjc", "mjc:")}
VALIDATOR = shutil.which("simready-validate", path=f"{Path(sys.executable).parent}") or shutil.which(
    "simready-validate"
)


@pytest.fixture(scope="module")
def exported(tmp_path_factory, cabinet, free_cabinet, nested) -> Mapping[str, tuple[Asset, Path]]:
    """Every asset with the file that is opened, in a directory of any name."""
    result = {}
    with recipes():
        for name, asset in zip(ASSETS, (cabinet, free_cabinet, nested, textured()), strict=True):
            directory = tmp_path_factory.mktemp("any")
            asset.export(directory, layout="simready", textures=256 * (name == "textured"))
            result[name] = (asset, directory / main_files(directory)["usd"])
    return result


def _opened(path: Path, variant: str = "") -> Usd.Stage:
    stage = Usd.Stage.Open(str(path))
    with Usd.EditContext(stage, stage.GetSessionLayer()):
        if variant:
            stage.GetDefaultPrim().GetVariantSet(variant).SetVariantSelection("Enabled")
    return stage


def _joint(stage: Usd.Stage, name: str) -> Usd.Prim:
    return stage.GetDefaultPrim().GetPrimAtPath(f"joints/{name}")


def _words(stage: Usd.Stage) -> set[str]:
    """Return whose words are on a stage."""
    names = set()
    for prim in stage.Traverse():
        schemas = prim.GetMetadata("apiSchemas")
        names |= set(schemas.GetAddedOrExplicitItems()) if schemas else set()
        names |= {str(name) for name in prim.GetAuthoredPropertyNames()}
    return {who for who, starts in PREFIXES.items() if any(name.startswith(starts) for name in names)}


@pytest.mark.parametrize("name", ASSETS)
@pytest.mark.parametrize("variant", ["", *VARIANTS])
def test_each_simulator_sees_its_own_words_alone(exported, name, variant):
    _, path = exported[name]
    assert _words(_opened(path, variant)) == ({variant} if variant else set())


@pytest.mark.parametrize("name", ASSETS)
@pytest.mark.parametrize("variant", ["", *VARIANTS])
def test_no_validator_finds_anything(exported, name, variant):
    _, path = exported[name]
    stage = _opened(path, variant)
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    found = list(UsdValidation.ValidationContext(validators).Validate(stage))
    if not Sdr.Registry().GetShaderNodeByIdentifier("ND_open_pbr_surface_surfaceshader"):
        # usd-core has no MaterialX, so that it knows none of its nodes
        found = [error for error in found if "shaderId 'ND_" not in error.GetMessage()]
    assert [error.GetMessage() for error in found] == []


@pytest.mark.parametrize("name", ASSETS)
def test_neutral_stage_is_the_flat_one_without_the_simulators_words(exported, name, tmp_path):
    asset, path = exported[name]
    with recipes():
        asset.export(tmp_path / "flat", formats="usd", textures=0)
    flat, stage = _opened(tmp_path / "flat" / f"{asset.name}.usda"), _opened(path)
    theirs = tuple(start for starts in PREFIXES.values() for start in starts)

    def physics(of: Usd.Stage) -> dict[str, dict[str, object]]:
        return {
            str(prim.GetPath()): {
                str(each.GetName()): each.Get()
                for each in prim.GetAuthoredAttributes()
                if each.GetName().startswith(("physics:", "drive:", "xformOp", "points", "semantics:"))
                and not each.GetName().startswith(theirs)
            }
            for prim in of.Traverse()
            if prim.IsA(UsdGeom.Xformable) or prim.IsA(UsdPhysics.Joint)
        }

    assert physics(stage) == physics(flat)


@pytest.mark.parametrize("name", ASSETS)
def test_metadata_are_of_the_asset_and_have_no_date(exported, name):
    asset, path = exported[name]
    stage = _opened(path)
    found = stage.GetRootLayer().customLayerData["SimReady_Metadata"]
    bodies = [prim for prim in stage.Traverse() if prim.HasAPI(UsdPhysics.RigidBodyAPI)]
    masses = [UsdPhysics.MassAPI(prim).GetMassAttr().Get() for prim in bodies]
    cache = UsdGeom.BBoxCache(Usd.TimeCode.Default(), [UsdGeom.Tokens.default_])
    box = cache.ComputeWorldBound(stage.GetDefaultPrim()).ComputeAlignedRange()
    assert found["rigid_body_count"] == len(bodies)
    assert found["mass"] == pytest.approx(sum(masses), rel=1e-5)
    # a box around turned boxes is no smaller than one around the faces themselves
    assert (np.array(found["asset_extents"]) <= np.array(box.GetSize()) + 1e-5).all()
    assert found["asset_extents"] == pytest.approx(np.array(box.GetSize()), rel=0.2)
    assert found["asset_name"] == asset.name
    assert found["qcode"].startswith("Q")
    assert f"seed={asset.seed}" in found["source_file"]
    assert not any(digit.isdigit() for digit in found["usd_date_generated"])
    for variant in VARIANTS:
        entry = found["Variants"]["Physics"][variant]
        assert entry["prim"] == str(stage.GetDefaultPrim().GetPath())


@pytest.mark.parametrize("name", ["cabinet", "nested"])
def test_mujocos_variant_says_what_the_mjcf_says(exported, name):
    asset, path = exported[name]
    stage = _opened(path, "MuJoCo")
    root = ET.fromstring(write_mjcf(asset).files[f"{asset.name}.xml"])
    common = root.find("default/default/joint")
    assert common is not None

    def numbers(text: str) -> list[float]:
        return [float(word) for word in text.split()]

    for element in root.iter("joint"):
        if "type" not in element.attrib:
            continue
        prim = _joint(stage, element.attrib["name"])
        units = 180.0 / np.pi if element.attrib["type"] == "hinge" else 1.0
        said = {**common.attrib, **element.attrib}
        for key in ("armature", "damping", "frictionloss", "stiffness"):
            assert prim.GetAttribute(f"mjc:{key}").Get() == pytest.approx(float(said.get(key, 0.0)))
        for key in ("ref", "springref"):
            value = prim.GetAttribute(f"mjc:{key}").Get() or 0.0
            assert value == pytest.approx(float(said.get(key, 0.0)) * units)
        ends = [prim.GetAttribute(f"mjc:actuatorfrcrange:{end}").Get() for end in ("min", "max")]
        assert ends == pytest.approx(numbers(said["actuatorfrcrange"]))
        for key in ("solreflimit", "solreffriction", "solimpfriction"):
            wanted = numbers(said[key])
            assert list(prim.GetAttribute(f"mjc:{key}").Get())[: len(wanted)] == pytest.approx(wanted)
        # MuJoCo's words replace the drive: whoever reads both must not have two springs
        drive = UsdPhysics.DriveAPI(prim, "angular" if units != 1.0 else "linear")
        assert not drive or (drive.GetStiffnessAttr().Get(), drive.GetDampingAttr().Get()) == (0.0, 0.0)
    for element in root.iter("equality"):
        for equality in element:
            prim = _joint(stage, equality.attrib["joint1"])
            coefficients = [prim.GetAttribute(f"mjc:coef{power}").Get() for power in (0, 1)]
            assert coefficients == pytest.approx(numbers(equality.attrib["polycoef"])[:2])
            assert list(prim.GetAttribute("mjc:solref").Get()) == numbers(equality.attrib["solref"])


def test_mujocos_contacts_are_as_stiff_as_in_the_mjcf(exported):
    asset, path = exported["cabinet"]
    root = ET.fromstring(write_mjcf(asset).files[f"{asset.name}.xml"])
    (geom,) = root.findall("default/default/default[@class='cabinet_7_collision']/geom")
    stage = _opened(path, "MuJoCo")
    colliders = [prim for prim in stage.Traverse() if prim.HasAPI(UsdPhysics.CollisionAPI)]
    assert len(colliders) == sum(len(link.colliders) for link in asset.links)
    for prim in colliders:
        for key in ("solref", "solimp"):
            wanted = [float(word) for word in geom.attrib[key].split()]
            assert list(prim.GetAttribute(f"mjc:{key}").Get())[: len(wanted)] == pytest.approx(wanted)


def test_couplings_are_in_every_simulators_variant(exported):
    asset, path = exported["cabinet"]
    coupling = asset.joint("bolt_slide").follows
    assert coupling is not None
    for variant, relation in (
        ("PhysX", "physxMimicJoint:rotX:referenceJoint"),
        ("Newton", "newton:mimicJoint"),
        ("MuJoCo", "mjc:target"),
    ):
        stage = _opened(path, variant)
        prim = _joint(stage, "bolt_slide")
        leader = _joint(stage, coupling.leader).GetPath()
        assert prim.GetRelationship(relation).GetTargets() == [leader]
    stage = _opened(path, "Newton")
    newton = _joint(stage, "bolt_slide")
    assert newton.GetAttribute("newton:mimicCoef1").Get() == pytest.approx(coupling.ratio)
    assert newton.GetAttribute("newton:mimicCoef0").Get() == pytest.approx(coupling.offset)


@pytest.mark.parametrize("name", ASSETS)
def test_openpbr_looks_as_the_preview(exported, name):
    asset, path = exported[name]
    stage = _opened(path)
    seen = {surface.material.name for link in asset.links for surface in link.surfaces}
    for stuff in asset.materials:
        prim = stage.GetDefaultPrim().GetPrimAtPath(f"Looks/{stuff.name}")
        material = UsdShade.Material(prim)
        preview = material.ComputeSurfaceSource()[0]
        openpbr = UsdShade.Shader(prim.GetPrimAtPath("openpbr"))
        assert openpbr.GetShaderId() == "ND_open_pbr_surface_surfaceshader"
        names = {
            "diffuseColor": "base_color", "roughness": "specular_roughness", "metallic": "base_metalness",
            "clearcoat": "coat_weight", "clearcoatRoughness": "coat_roughness", "ior": "specular_ior",
        }  # fmt: skip
        for theirs, ours in names.items():
            first, second = preview.GetInput(theirs), openpbr.GetInput(ours)
            assert bool(first.GetConnectedSources()[0]) == bool(second.GetConnectedSources()[0])
            if not first.GetConnectedSources()[0]:
                assert second.Get() == pytest.approx(first.Get())
            else:
                first, second = (
                    UsdShade.Shader(each.GetConnectedSources()[0][0].source).GetInput("file")
                    for each in (first, second)
                )
                assert second.Get().resolvedPath == first.Get().resolvedPath != ""
                space = "srgb_texture" if theirs == "diffuseColor" else "none"
                assert second.GetAttr().GetColorSpace() == space
        assert prim.HasAttribute("omni:simready:nonvisual:base") == (stuff.name in seen)


def test_files_lie_as_the_profile_wants(cabinet):
    files = encode(cabinet, layout="simready", textures=0)
    main = json.loads(files["asset.json"])["formats"]["usd"]["main"]
    root, folder, name = main.split("/")
    assert root in name
    beside = [path for path in files if path.startswith(f"{root}/{folder}/") and path.count("/") == 2]
    assert beside == [main]
    assert f"{root}/{folder}/.thumbs/256x256/{name}.png" in files
    assert b"faceVertexIndices" not in b"".join(v for k, v in files.items() if k.endswith(".usda"))
    assert len(files[main]) < 4000


def test_losses_name_the_variants(cabinet):
    record = json.loads(encode(cabinet, layout="simready", textures=0)["asset.json"])
    losses = {loss["feature"]: loss["instead"] for loss in record["formats"]["usd"]["losses"]}
    for feature in ("joint friction", "joint armature", "joint velocity limit", "joint coupling"):
        assert "variant" in losses[feature]


def test_picture_shows_the_asset(cabinet):
    content = encode(cabinet, layout="simready", textures=0)[
        "cabinet_7/usd/.thumbs/256x256/cabinet_7.usda.png"
    ]
    with Image.open(BytesIO(content)) as image:
        assert image.size == (256, 256)
        pixels = np.asarray(image, float)
    border = np.concatenate([pixels[0], pixels[-1], pixels[:, 0]])
    assert border.min() > 130.0  # a bright floor
    drawn = np.abs(pixels - pixels[:1]).max(axis=2) > 40.0
    rows, columns = np.nonzero(drawn)
    assert 0.7 < max(np.ptp(rows), np.ptp(columns)) / 256.0 < 1.0
    assert len(np.unique(pixels.reshape(-1, 3), axis=0)) > 200


def test_picture_does_not_depend_on_rounding_noise(cabinet):
    """Another machine rounds in the last digit; the picture is the same."""

    def nudged(asset: Asset, size: float) -> Asset:
        links = []
        for link in asset.links:
            surfaces = tuple(
                replace(each, mesh=replace(each.mesh, vertices=each.mesh.vertices + size))
                for each in link.surfaces
            )
            copy = replace(link)
            vars(copy)["surfaces"] = surfaces
            links.append(copy)
        return replace(asset, links=tuple(links))

    assert (thumbnail(nudged(cabinet, 1e-14)) == thumbnail(cabinet)).all()


@pytest.mark.parametrize("seed", some(range(8), 2))
def test_rasterizer_finds_the_nearest_triangle(seed):
    generator = np.random.default_rng(seed)
    size, count = 24, 40
    corners = generator.uniform(-4.0, size + 4.0, (count, 3, 3))
    corners[:, :, 2] = generator.uniform(0.0, 10.0, (count, 1))  # parallel to the picture
    corners[:, :, :2] = np.rint(corners[:, :, :2] * 16.0) / 16.0
    seen = rasterize(corners, size)
    for row in range(size):
        for column in range(size):
            middle = np.array([column + 0.5, row + 0.5])
            best, owner = np.inf, NOTHING
            for number, triangle in enumerate(corners):
                sides = np.roll(triangle[:, :2], -1, axis=0) - triangle[:, :2]
                away = middle - triangle[:, :2]
                cross = sides[:, 0] * away[:, 1] - sides[:, 1] * away[:, 0]
                if (cross >= 0.0).all() and cross.sum() > 0.0 and triangle[0, 2] < best:
                    best, owner = triangle[0, 2], number
            assert seen.owner[row, column] == owner
            assert seen.depth[row, column] == pytest.approx(best)


def test_weights_give_the_point_back():
    generator = np.random.default_rng(3)
    triangle = np.array([[0.0, 0.0, 1.0], [10.0, 0.0, 2.0], [0.0, 10.0, 3.0]])
    share = generator.dirichlet([1.0] * 3, 20)
    points = share @ triangle
    found = weights(np.broadcast_to(triangle, (20, 3, 3)), points[:, 0] - 0.5, points[:, 1] - 0.5)
    assert found == pytest.approx(share)


@pytest.mark.skipif(VALIDATOR is None, reason="needs simready-validate: pip install artgen[test]")
def test_profile_is_passed_with_all_but_mdl(exported, tmp_path):
    handle = artgen.generate("handle", seed=2, certify=False)
    handle.export(tmp_path / "x", layout="simready", textures=0)
    assets = {
        str(tmp_path / "x" / main_files(tmp_path / "x")["usd"]): handle,
        **{str(path): asset for asset, path in exported.values()},
    }
    (tmp_path / "list.txt").write_text("\n".join(assets))
    command = [str(VALIDATOR), "--profile", "Robotics-Prop", "--version", "4.0.0", "--asset_list"]
    done = subprocess.run([*command, str(tmp_path / "list.txt")], capture_output=True, text=True, check=False)
    reports = (done.stdout + done.stderr).split("Asset: ")[1:]
    assert len(reports) == len(assets), done.stderr
    for report, (path, asset) in zip(reports, assets.items(), strict=True):
        assert Path(path).name in report
        assert "[PASSED] Robotics-Prop v4.0.0" in report, report
        unmet = {line.partition(":")[0].strip() for line in report.splitlines() if "unmet" in line}
        # what nobody takes hold of has no grasp line
        grasped = any(link.grasps for link in asset.links)
        assert unmet == {"FET_006_MDL"} | (set() if grasped else {"FET_005_STANDARD"}), report


def test_grasp_lines_cross_what_the_fingers_hold(exported):
    asset, path = exported["cabinet"]
    stage = _opened(path)
    lines = [prim for prim in stage.Traverse() if prim.GetTypeName() == "BasisCurves"]
    assert [prim.GetName() for prim in lines] == ["grasp_identifier_lid_edge"]
    matrix = UsdGeom.Xformable(lines[0]).ComputeLocalToWorldTransform(Usd.TimeCode.Default())
    ends = [np.array(matrix.Transform(Gf.Vec3d(point))) for point in lines[0].GetAttribute("points").Get()]
    (grasp,) = asset.link("lid").grasps
    assert np.linalg.norm(ends[1] - ends[0]) == pytest.approx(grasp.width)
    assert 0.5 * (ends[0] + ends[1]) == pytest.approx(grasp.frame[:3, 3], abs=1e-6)
    assert (ends[1] - ends[0]) / grasp.width == pytest.approx(grasp.frame[:3, 0], abs=1e-5)
