"""The same asset looks the same in every format, as readers find it that are not artgen's."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import artgen
from artgen.asset import Asset
from artgen.generator import generator
from artgen.materials import Material, material
from artgen.materials.textures import RECIPES, Pattern, Recipe
from artgen.nodes.body import part
from artgen.nodes.handles import Body
from artgen.nodes.joint import Prismatic, Revolute
from artgen.nodes.primitive import box, cylinder, sphere
from artgen.nodes.vector import Y, Z
from support.cases import some
from support.looks import LEVELS, Hits, Part, View, constant, expected_view, random_rays
from support.looks_readers import read_views

SIZE = 256
RAYS = 300
NEAR = 1e-4  # [m]
LOSSY = {"trimesh glb", "gltf"}  # their maps are JPEG
TILE = (0.2, 0.25)
LEAST, SPAN = 0.15, 0.7  # of the red and green gradients


def _letter(stream: np.random.Generator, size: int) -> Pattern:
    """A picture that no turn or reflection leaves as it is: red grows to the right, green upwards; an F."""
    column, row = np.meshgrid(*[(np.arange(size) + 0.5) / size] * 2)
    u, v = column, 1.0 - row
    stem = (u > 0.3) & (u < 0.42) & (v > 0.2) & (v < 0.8)
    bars = (u > 0.3) & (u < 0.7) & (((v > 0.68) & (v < 0.8)) | ((v > 0.45) & (v < 0.55)))
    encoded = np.stack([LEAST + SPAN * u, LEAST + SPAN * v, np.where(stem | bars, 0.8, 0.3)], axis=-1)
    albedo = ((encoded + 0.055) / 1.055) ** 2.4
    roughness = 0.2 * (u - 0.5) + 0.05 * (v - 0.5)
    return Pattern(albedo, roughness, np.clip(v, 0.0, 1.0), 0.002 * np.sin(2.0 * np.pi * (u + 2.0 * v)))


MEAN = tuple(_letter(np.random.default_rng(0), 64).albedo.mean(axis=(0, 1)))
LETTER = Recipe("looks_letter", MEAN, _letter, TILE)
PICTURE = Material("picture", MEAN, specular_roughness=0.5, texture=LETTER.name)


@pytest.fixture(autouse=True)
def letter(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let materials have the picture."""
    monkeypatch.setitem(RECIPES, LETTER.name, LETTER)
    monkeypatch.setenv("ARTGEN_CACHE", "off")  # whose pictures are known by their names


@generator
def samples() -> Body:
    """Boxes and round things of materials that have something special each, some of them movable."""
    tinted = PICTURE.with_(name="tinted", base_color=tuple(channel * 0.6 for channel in MEAN))
    rough = PICTURE.with_(name="rough", specular_roughness=0.7, tile=(0.1, 0.3))
    turned = PICTURE.with_(name="turned", turned=True)
    lamp = Material("lamp", (0.9, 0.8, 0.4), emission=(1.0, 0.7, 0.3))
    lacquer = material("oak").with_(name="lacquer", texture="flat", coat_weight=0.8)
    board = box(0.5, 0.06, 0.7, bevel=0.004)
    body = part(board, "board", PICTURE)
    flap = part(box(0.3, 0.04, 0.12).at(0, -0.2, 0), "flap", turned)
    flap = flap.attach(part(sphere(0.05).at(0, -0.4, 0), "knob", lamp), Revolute("spin", axis=Y, limits=None))
    body = body.attach(flap, Revolute("tilt", axis=Z, limits=(0.2, 1.0)))
    slider = part(cylinder(0.06, 0.3, axis=Y).at(0.5, 0, 0), "rod", tinted)
    body = body.attach(slider, Prismatic("slide", axis=Z, limits=(-0.1, 0.2)))
    pane = part(box(0.2, 0.004, 0.3).at(0.5, 0, 0.5), "pane", material("glass"))
    body = body.attach(pane, Prismatic("lift", axis=Z, limits=(0.0, 0.2)))
    post = part(box(0.05, 0.05, 0.8).at(-0.5, 0, 0), "post", rough)
    body = body.attach(post, Revolute("fixed", axis=Z, limits=(0.4, 0.4)))
    return body.attach(
        part(box(0.1, 0.1, 0.4).at(-0.5, 0.3, 0), "beam", lacquer), Prismatic("push", axis=Y, limits=(0, 0.1))
    )


def exported(asset: Asset, directory: Path, textures: int = SIZE) -> list[View]:
    asset.export(directory, formats=("urdf", "mjcf", "usd", "glb"), textures=textures)
    return read_views(asset, directory)


def check_views(expected: View, views: Sequence[View], seed: int) -> None:
    """Assert that rays hit the same places of a view and of others, and find them shaded alike."""
    rays = random_rays(expected, RAYS, seed)
    want = expected.cast(*rays)
    rows = np.flatnonzero(want.part >= 0)
    rows = rows[expected.clear(want.points[rows])]
    assert len(rows) > RAYS / 2
    for view in views:
        check_view(expected, want, view, rays, rows)


def check_view(
    expected: View, want: Hits, found: View, rays: tuple[np.ndarray, np.ndarray], rows: np.ndarray
) -> None:
    """Assert that some rays hit what they are wanted to, from outside."""
    reader, (origins, directions) = found.name, rays
    got = found.cast(origins, directions)
    missed = rows[got.part[rows] < 0]
    assert not len(missed), f"{reader}: nothing at {want.points[missed[:3]].round(4)}"
    names = [
        [view.parts[number].link for number in hits.part[rows]]
        for view, hits in ((expected, want), (found, got))
    ]
    assert names[0] == names[1], f"{reader}: rays hit other links"
    apart = np.linalg.norm(want.points[rows] - got.points[rows], axis=1)
    assert apart.max() < NEAR, (
        f"{reader}: {1e3 * apart.max():.2f} mm apart at {want.points[rows[apart.argmax()]]}"
    )
    facing = (got.faces[rows] * directions[rows]).sum(axis=1)
    assert facing.max() < 0.0, f"{reader}: {(facing >= 0).sum()} faces are inside out"
    turned = np.abs(want.normals[rows] - got.normals[rows]).max()
    assert turned < 2e-3, f"{reader}: shading normals differ by {turned:.4f}"
    lit = (got.normals[rows] * got.faces[rows]).sum(axis=1)
    assert lit.min() > 0.0, f"{reader}: a shading normal looks inward"
    for name in LEVELS:
        check_levels(
            f"{reader}: {name}", want.looks[name][rows], got.looks[name][rows], lossy=reader in LOSSY
        )


def check_levels(what: str, want: np.ndarray, got: np.ndarray, *, lossy: bool) -> None:
    """Assert that grey levels agree: to rounding, or in JPEG files to what that compression loses."""
    difference = np.abs(want - got)
    worst = int(difference.max(axis=1).argmax())
    assert difference.max() <= (48.0 if lossy else 1.0), f"{what} is {got[worst]} instead of {want[worst]}"
    # trimesh rounds plain colors to whole grey levels
    assert difference.mean() <= (3.0 if lossy else 0.5), (
        f"{what} is off by {difference.mean():.2f} on average"
    )


@pytest.mark.parametrize("textures", [0, SIZE])
def test_samples_look_the_same_everywhere(textures: int, tmp_path: Path) -> None:
    asset = samples.generate(seed=1, certify=False)
    views = exported(asset, tmp_path / "asset", textures)
    expected = expected_view(asset, textures)
    assert {view.name for view in views} == {"yourdfpy", "mujoco", "usd", "trimesh glb", "gltf"}
    check_views(expected, views, 3)


@pytest.mark.parametrize(
    ("category", "seed"), some([("door", 3), ("door", 7), ("handle", 1), ("handle", 4)], 4)
)
def test_products_look_the_same_everywhere(category: str, seed: int, tmp_path: Path) -> None:
    asset = artgen.generate(category, seed=seed, certify=False)
    views = exported(asset, tmp_path / "asset")
    expected = expected_view(asset, SIZE)
    check_views(expected, views, seed)


def _changed(view: View, **change: Callable[[Part], object]) -> View:
    """Return the view with some fields of every part replaced by what functions make of it."""
    parts = [replace(each, **{name: make(each) for name, make in change.items()}) for each in view.parts]
    return View("a reader", parts)


FAULTS: dict[str, tuple[dict[str, Callable[[Part], object]], str]] = {
    "moved": ({"corners": lambda each: each.corners + 2e-4}, r"0\.\d+ mm apart|nothing at|other links"),
    "inside out": ({"corners": lambda each: each.corners[:, ::-1]}, "faces are inside out"),
    "other link": ({"link": lambda each: "elsewhere"}, "rays hit other links"),
    "flat": ({"normals": lambda each: np.roll(each.normals, 1, axis=2)}, "shading normals differ"),
    "mirrored": ({"uvs": lambda each: each.uvs * [-1.0, 1.0]}, "color is .* instead of"),
    "upside down": ({"uvs": lambda each: each.uvs * [1.0, -1.0]}, "color is .* instead of"),
    "too large": ({"uvs": lambda each: 0.9 * each.uvs}, "color is .* instead of"),
    "too dark": (
        {"look": lambda each: replace(each.look, color=replace(each.look.color, factor=np.full(3, 0.5)))},
        "color is .* instead of",
    ),
    "glossy": (
        {"look": lambda each: replace(each.look, roughness=constant(0.0))},
        "roughness is .* instead of",
    ),
    "opaque": ({"look": lambda each: replace(each.look, opacity=constant(1.0))}, "opacity is .* instead of"),
    "unlit": ({"look": lambda each: replace(each.look, emission=constant(0.0))}, "emission is .* instead of"),
    "even": (
        {"look": lambda each: replace(each.look, normal=constant(0.5, 0.5, 1.0))},
        "normal is .* instead of",
    ),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_a_view_with_a_fault_is_refused(fault: str) -> None:
    change, message = FAULTS[fault]
    expected = expected_view(samples.generate(seed=1, certify=False), SIZE)
    check_views(expected, [_changed(expected)], 3)
    with pytest.raises(AssertionError, match=message):
        check_views(expected, [_changed(expected, **change)], 3)


FACES = [(axis, sign) for axis in range(3) for sign in (-1.0, 1.0)]


@pytest.mark.parametrize("turned", [False, True])
def test_pictures_are_upright_and_repeat_at_their_metric_size(
    tmp_path: Path,
    turned: bool,  # noqa: FBT001
) -> None:
    """Rays along each face of a box read off the picture where they are in it, without artgen's sums."""
    size = np.array([0.5, 0.3, 0.9])

    @generator
    def crate() -> Body:
        return part(box(*size), "crate", PICTURE.with_(name="crate_picture", turned=turned))

    for view in exported(crate.generate(seed=1), tmp_path / "asset"):
        for axis, sign in FACES:
            normal = sign * np.eye(3)[axis]
            up = np.eye(3)[2 if axis < 2 else 0]  # along the longest side of the face
            right = np.cross(up, normal)
            if turned:
                up, right = -right, up
            for along, tile, channel in ((right, TILE[0], 0), (up, TILE[1], 1)):
                place = f"{view.name}, side {normal}, {'right' if channel == 0 else 'up'}"
                reach = float(np.abs(along) @ size)
                steps = np.linspace(-0.45, 0.45, 97) * reach
                origins = 2.0 * normal + steps[:, None] * along + 0.01
                hits = view.cast(origins, np.broadcast_to(-normal, origins.shape).copy())
                assert (hits.part >= 0).all(), place
                share = (hits.looks["color"][:, channel] / 255.0 - LEAST) / SPAN
                advance = np.diff(share)
                inside = (np.minimum(share[1:], share[:-1]) > 0.05) & (
                    np.maximum(share[1:], share[:-1]) < 0.95
                )
                assert inside.sum() > 20, place
                found = advance[inside].sum() / inside.sum() / (steps[1] - steps[0])
                assert found == pytest.approx(1.0 / tile, rel=0.05), (
                    f"{place}: {found:.2f} repeats in a metre"
                )
