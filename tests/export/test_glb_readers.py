"""Other people's readers of GLB files: the Khronos validator, three.js in Chromium, trimesh and pygltflib.

The first two are npm packages: run `npm ci` in scripts/gltf_check, or name their node_modules in
ARTGEN_NODE_MODULES.
"""

import io
import json
import os
import shutil
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
import trimesh
from PIL import Image

from artgen.asset import Asset, Link, Piece, Shape, Tree
from artgen.asset.surface import texture_coordinates
from artgen.catalog import categories, find
from artgen.colliders import Convex, Exact
from artgen.export import write_glb
from artgen.materials import Material, material
from artgen.materials.textures import RECIPES, Pattern, Recipe, maps
from support.cases import some
from support.textured import recipes, textured

SCRIPTS = Path(__file__).parents[2] / "scripts" / "gltf_check"
MODULES = Path(os.environ.get("ARTGEN_NODE_MODULES") or SCRIPTS / "node_modules")
SIZE = 256


def node(script: str, *arguments: str, package: str) -> str:
    """What a script of `scripts/gltf_check` prints; skips the test where it cannot run."""
    program = shutil.which("node")
    if program is None:
        pytest.skip("node is not installed")
    if not (MODULES / package).is_dir():
        pytest.skip(f"npm package {package} is not in {MODULES}: run `npm ci` in scripts/gltf_check")
    environment = {**os.environ, "ARTGEN_NODE_MODULES": str(MODULES)}
    command = [program, str(SCRIPTS / script), *arguments]
    done = subprocess.run(command, capture_output=True, text=True, check=False, env=environment, timeout=300)
    assert done.returncode == 0, done.stderr
    assert not done.stderr, done.stderr
    return done.stdout


@pytest.fixture(scope="module", autouse=True)
def registered_recipes() -> Iterator[None]:
    with recipes(), pytest.MonkeyPatch.context() as patch:
        patch.setitem(RECIPES, "test_dome", Recipe("test_dome", (0.5, 0.5, 0.5), _dome, (0.4, 0.4)))
        yield


def _dome(stream: np.random.Generator, size: int) -> Pattern:
    """One dome in the middle of the tile."""
    across = (np.arange(size) + 0.5) / size - 0.5
    square = across[:, None] ** 2 + across**2
    return Pattern(None, np.zeros((size, size)), None, 0.3 * np.sqrt(np.maximum(0.16 - square, 0.0)))


def write(directory: Path, asset: Asset, textures: int = SIZE) -> Path:
    path = directory / f"{asset.name}.glb"
    path.write_bytes(write_glb(asset, textures).files[path.name])
    return path


def problems(paths: list[Path]) -> list[str]:
    """What the validator has to say of files, hints included."""
    reports = json.loads(node("validate.mjs", *map(str, paths), package="gltf-validator"))
    assert len(reports) == len(paths)
    return [f"{report['path']}: {each}" for report in reports for each in report["issues"]["messages"]]


def test_validator_has_nothing_to_say(tmp_path: Path) -> None:
    assets = [find(category).generate(0, certify=False) for category in categories()[::3]]
    assert problems([write(tmp_path, asset) for asset in assets]) == []


def test_validator_has_nothing_to_say_of_hand_made_assets(asset: Asset, tmp_path: Path) -> None:
    assert problems([write(tmp_path, asset), write(tmp_path, textured())]) == []


def test_validator_sees_a_fault(cabinet: Asset, tmp_path: Path) -> None:
    path = write(tmp_path, cabinet)
    path.write_bytes(path.read_bytes().replace(b'"VEC3"', b'"VEC2"', 1))
    assert any("ACCESSOR" in each for each in problems([path]))


def test_trimesh_finds_every_surface_in_its_place_and_color(asset: Asset) -> None:
    scene = trimesh.load_scene(
        io.BytesIO(write_glb(asset).files[f"{asset.name}.glb"]), file_type="glb", process=False
    )
    upright = np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])
    poses, found = asset.pose(), []
    for node_name in scene.graph.nodes_geometry:
        transform, name = scene.graph[node_name]
        mesh = scene.geometry[name]
        found.append(
            (
                (mesh.vertices @ transform[:3, :3].T + transform[:3, 3]) @ upright.T,
                mesh.visual.material.name,
                np.array(mesh.visual.material.baseColorFactor) / 255,
            )
        )
    surfaces = [(link.name, surface) for link in asset.links for surface in link.surfaces]
    assert len(found) == len(surfaces)
    for link, surface in surfaces:
        pose = poses[link]
        place = surface.mesh.vertices @ pose[:3, :3].T + pose[:3, 3]
        stuff = surface.material
        color = [*stuff.base_color, stuff.opacity]
        assert any(
            len(vertices) == len(place)
            and np.abs(vertices - place).max() < 1e-6
            and (name, pytest.approx(color, abs=0.6 / 255)) == (stuff.name, rgba)
            for vertices, name, rgba in found
        ), surface.name


def test_trimesh_reads_the_maps() -> None:
    asset = textured()
    scene = trimesh.load_scene(io.BytesIO(write_glb(asset, SIZE).files["textured.glb"]), file_type="glb")
    stuff = {mesh.visual.material.name: mesh.visual.material for mesh in scene.geometry.values()}
    board = next(each for each in asset.materials if each.name == "board")
    picture = np.asarray(stuff["board"].baseColorTexture, float)
    assert np.abs(picture - maps(board, SIZE).albedo).mean() < 4.0
    assert stuff["board"].normalTexture.size == (SIZE, SIZE)
    assert stuff["lamp"].emissiveFactor == pytest.approx([0.2, 0.8, 0.1])


def test_pygltflib_reads_the_file(cabinet: Asset, tmp_path: Path) -> None:
    pygltflib = pytest.importorskip("pygltflib", reason="pygltflib is not installed")
    model = pygltflib.GLTF2().load(str(write(tmp_path, cabinet)))
    names = {each.name for each in model.nodes}
    assert {link.name for link in cabinet.links} <= names
    assert [each.name for each in model.animations] == [joint.name for joint in cabinet.free_joints]


@dataclass(frozen=True)
class Camera:
    """A camera in asset coordinates, upright [m, degrees, pixels]."""

    eye: tuple[float, float, float]
    target: tuple[float, float, float]
    fov: float = 24.0
    size: int = 200

    def to_data(self) -> dict:
        turned = {name: [x, z, -y] for name, (x, y, z) in {"eye": self.eye, "target": self.target}.items()}
        return {**turned, "fov": self.fov, "width": self.size, "height": self.size}

    def pixels(self, points: np.ndarray) -> np.ndarray:
        """Column and row at which points are seen, shape (n, 2)."""
        forward = np.subtract(self.target, self.eye)
        forward = forward / np.linalg.norm(forward)
        right = np.cross(forward, (0.0, 0.0, 1.0))
        right /= np.linalg.norm(right)
        rays = points - self.eye
        scale = self.size / 2 / np.tan(np.radians(self.fov) / 2) / (rays @ forward)
        return self.size / 2 + np.column_stack(
            [rays @ right * scale, -(rays @ np.cross(right, forward)) * scale]
        )


def drawn(directory: Path, views: list[dict]) -> list[np.ndarray]:
    """Pictures of views by three.js; skips the test where it cannot run."""
    if not (os.environ.get("ARTGEN_CHROMIUM") or shutil.which("chromium") or shutil.which("google-chrome")):
        pytest.skip("chromium is not installed")
    if not (MODULES / "three").is_dir():
        pytest.skip(f"npm package three is not in {MODULES}: run `npm ci` in scripts/gltf_check")
    paths = [directory / f"view_{number}.png" for number in range(len(views))]
    views = [{**view, "out": str(path)} for view, path in zip(views, paths, strict=True)]
    (directory / "views.json").write_text(json.dumps(views), encoding="utf-8")
    node("render.mjs", str(directory / "views.json"), package="puppeteer-core")
    return [np.asarray(Image.open(path).convert("RGB"), float) for path in paths]


PICTURE = material("oak").with_(name="picture", texture="test_picture", base_color=(0.3, 0.3, 0.3))
DOME = Material("dome", (0.5, 0.5, 0.5), specular_roughness=1.0, texture="test_dome")
ABOVE = Camera((1.0, -2.0, 2.0), (0.0, 0.1, 0.7), 40.0)
OPEN = {"lid_hinge": 1.4, "lever_turn": 0.8}

FRONT = Camera((0.0, -2.0, 0.5), (0.0, 0.0, 0.5))
_FRAMES = {
    "upright": (1, 0, 0, 1),
    "turned": (0, 1, -1, 0),
    "mirrored": (-1, 0, 0, 1),
    "upside down": (1, 0, 0, -1),
}


def plate(name: str, stuff: Material, frame: tuple[int, int, int, int]) -> Asset:
    """An upright plate of 0.6 m that faces the front, with u = a x + b z and v = c x + d z there."""
    corners = np.array([[x, y, z] for x in (-0.3, 0.3) for y in (0.0, 0.02) for z in (0.2, 0.8)])
    triangles = np.array(
        [[0, 4, 5], [0, 5, 1], [6, 2, 3], [6, 3, 7], [2, 0, 1], [2, 1, 3], [4, 6, 7], [4, 7, 5],
         [1, 5, 7], [1, 7, 3], [2, 6, 4], [2, 4, 0]]
    )  # fmt: skip
    points = corners[triangles].reshape(-1, 3)
    normals = np.cross(points[1::3] - points[::3], points[2::3] - points[::3]).repeat(3, axis=0)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    a, b, c, d = frame
    x, z = points[:, 0], points[:, 2] - 0.5
    uvs = np.column_stack([a * x + b * z, c * x + d * z])
    pose = np.eye(4)
    pose[:3, 3] = (0.0, 0.01, 0.5)
    pieces = Exact((Convex("box", pose, (0.6, 0.02, 0.6), np.zeros((0, 3))),))
    shape = Shape.from_mesh(points, normals, uvs, np.arange(36).reshape(-1, 3), pieces)
    return Asset.from_tree(Tree(Link("plate", "plate", (Piece("plate", stuff, shape),))), name, "plate")


def front_coordinates(asset: Asset, points: np.ndarray) -> np.ndarray:
    """Texture coordinates of points on the front of a plate, which are linear in x and z there."""
    (surface,) = asset.links[0].surfaces
    front = surface.mesh.normals[:, 1] < -0.9
    known = np.column_stack([surface.mesh.vertices[front][:, [0, 2]], np.ones(front.sum())])
    law, *_ = np.linalg.lstsq(known, texture_coordinates(surface.mesh, surface.material)[front])
    return np.column_stack([points[:, [0, 2]], np.ones(len(points))]) @ law


@pytest.fixture(scope="module")
def pictures(tmp_path_factory: pytest.TempPathFactory, cabinet: Asset) -> dict[str, np.ndarray]:
    """All pictures of this module, which share one start of the browser."""
    directory = tmp_path_factory.mktemp("pictures")
    views: dict[str, dict] = {}
    for name, frame in _FRAMES.items():
        file = name.replace(" ", "_")
        path = write(directory, plate(f"colors_{file}", PICTURE, frame))
        views[f"colors {name}"] = {"glb": str(path), **FRONT.to_data(), "unlit": True}
        path = write(directory, plate(f"dome_{file}", DOME, frame))
        for side, light in {"above": (0, 1, 1), "right": (1, 0, 1)}.items():
            views[f"dome {name} {side}"] = {"glb": str(path), **FRONT.to_data(), "light": light}
    path = str(write(directory, cabinet, 0))
    seen = {"glb": path, **ABOVE.to_data(), "unlit": True, "background": 0x0000FF}
    views["cabinet rest"] = seen
    views["cabinet posed"] = {**seen, "positions": OPEN}
    # the lever takes half a second, then comes a pause, and the lid takes a second
    views["cabinet animated"] = {**seen, "animation": "lid_hinge", "time": 1.7}
    return dict(zip(views, drawn(directory, list(views.values())), strict=True))


@pytest.mark.parametrize("name", some(_FRAMES, 2))
def test_three_draws_every_color_where_the_texture_coordinates_say(
    pictures: dict[str, np.ndarray], name: str
) -> None:
    asset = plate("colors", PICTURE, _FRAMES[name])
    points = np.random.default_rng(0).uniform((-0.29, 0, 0.21), (0.29, 0, 0.79), (400, 3))
    u, v = (front_coordinates(asset, points) % 1.0).T
    # near the borders of the picture's quarters a pixel has two colors
    plain = (np.abs(u * 2 - np.rint(u * 2)) > 0.1) & (np.abs(v * 2 - np.rint(v * 2)) > 0.1)
    assert plain.sum() > 100
    albedo = maps(PICTURE, SIZE).albedo
    expected = albedo[((1 - v[plain]) * SIZE).astype(int), (u[plain] * SIZE).astype(int)]
    column, row = FRONT.pixels(points[plain]).astype(int).T
    assert np.abs(pictures[f"colors {name}"][row, column] - expected).max() < 16.0


@pytest.mark.parametrize("name", _FRAMES)
def test_three_lights_a_dome_from_where_the_light_is(pictures: dict[str, np.ndarray], name: str) -> None:
    """So normal maps stand out of the surface however they are turned on it."""
    asset = plate("dome", DOME, _FRAMES[name])
    points = np.random.default_rng(0).uniform((-0.29, 0, 0.21), (0.29, 0, 0.79), (4000, 3))
    from_center = (front_coordinates(asset, points) % 1.0 - 0.5) * 0.4
    a, b, c, d = _FRAMES[name]
    to_side = np.linalg.inv([[a, b], [c, d]]) @ from_center.T  # in x and z
    column, row = FRONT.pixels(points).astype(int).T
    for along, side in enumerate(("right", "above")):
        brightness = pictures[f"dome {name} {side}"].mean(axis=2)[row, column]
        slope = (np.abs(to_side[along]) > 0.06) & (np.linalg.norm(from_center, axis=1) < 0.13)
        bright = brightness[slope & (to_side[along] > 0)].mean()
        dark = brightness[slope & (to_side[along] < 0)].mean()
        assert bright > 1.5 * dark, side


def test_three_poses_and_animates_as_the_asset_does(pictures: dict[str, np.ndarray], cabinet: Asset) -> None:
    rest, posed, animated = (pictures[f"cabinet {name}"] for name in ("rest", "posed", "animated"))
    lid = cabinet.link("lid").surfaces[0].mesh.vertices
    moved = cabinet.pose(OPEN)["lid"]
    corners = lid @ moved[:3, :3].T + moved[:3, 3]
    middle = corners.mean(axis=0, keepdims=True)
    column, row = ABOVE.pixels(middle).astype(int)[0]
    oak = np.array(material("oak").base_color)
    expected = 255 * (1.055 * oak ** (1 / 2.4) - 0.055)
    for picture in (posed, animated):
        assert np.abs(picture[row, column] - expected).max() < 3.0
        assert np.abs(rest[row, column] - picture[row, column]).max() > 50.0
    assert (np.abs(posed - animated).max(axis=2) > 8.0).mean() < 0.01
