"""Sets of images: the COCO annotations agree with independent rays against the exported asset."""

import json
import shutil
from collections.abc import Iterator
from contextlib import redirect_stdout
from dataclasses import replace
from io import StringIO
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from artgen.asset import Asset
from artgen.asset.record import rounded
from artgen.dataset import Dataset, generate_many
from artgen.dataset.plan import Item
from artgen.errors import ExportError
from artgen.images import ImagePlan
from support.digests import digests
from support.pixels import Solid

# pycocotools decodes masks in a way that NumPy is about to drop
pytestmark = pytest.mark.filterwarnings("ignore:__array__ implementation:DeprecationWarning")

PARTS = ("train", "val", "test")


@pytest.fixture(scope="module")
def coco(image_set: Path) -> dict[str, Any]:
    """The files of COCO as pycocotools reads them."""
    from pycocotools.coco import COCO

    with redirect_stdout(StringIO()):
        return {part: COCO(str(image_set / f"{part}.json")) for part in PARTS}


@pytest.fixture(scope="module")
def assets(image_plan: ImagePlan) -> dict[str, Asset]:
    return {item.name: image_plan.draw(item) for item in image_plan.items()}


@pytest.fixture(scope="module")
def solids(assets: dict[str, Asset], tmp_path_factory: pytest.TempPathFactory) -> dict[str, Solid]:
    folder = tmp_path_factory.mktemp("exports")
    return {
        name: Solid(asset.export(folder / name, formats=("urdf",), textures=0))
        for name, asset in assets.items()
    }


def images(coco: dict[str, Any]) -> Iterator[tuple[Any, dict[str, Any]]]:
    for part in coco.values():
        for image in part.dataset["images"]:
            yield part, image


def parts_of(part: Any, image: dict[str, Any]) -> list[tuple[dict[str, Any], str, np.ndarray]]:
    """Each annotation of an image with its label and its mask."""
    found = part.loadAnns(part.getAnnIds(imgIds=image["id"]))
    return [(each, part.cats[each["category_id"]]["name"], part.annToMask(each) > 0) for each in found]


@pytest.mark.long
def test_every_picture_is_listed_once_and_exists(coco, image_set: Path, image_plan: ImagePlan) -> None:
    listed = [image for _, image in images(coco)]
    assert len({image["id"] for image in listed}) == len({image["file_name"] for image in listed}) == 10
    for image in listed:
        shown = np.array(Image.open(image_set / image["file_name"]))
        assert shown.shape == (image["height"], image["width"], 3) == (192, 192, 3)
        assert shown.std() > 5  # something is to be seen
    masks = [mask["id"] for part in coco.values() for mask in part.dataset["annotations"]]
    assert len(set(masks)) == len(masks) > 40


def test_no_asset_and_no_seed_is_in_two_parts(coco) -> None:
    seeds = {name: {image["seed"] for image in part.dataset["images"]} for name, part in coco.items()}
    assert {name: len(each) for name, each in seeds.items()} == {"train": 1, "val": 1, "test": 1}
    assert set.union(*seeds.values()) == {0, 1, 2}


def test_a_mask_shows_one_part_of_one_link_and_masks_do_not_overlap(coco, assets) -> None:
    for part, image in images(coco):
        found = parts_of(part, image)
        assert found
        assert len({(each["link"], label) for each, label, _ in found}) == len(found)
        assert sum(mask.astype(int) for *_, mask in found).max() == 1
        asset = assets[image["asset"]]
        for each, label, mask in found:
            assert label in {surface.label for surface in asset.link(each["link"]).surfaces}
            rows, columns = np.nonzero(mask)
            assert each["area"] == len(rows) > 0
            low = columns.min(), rows.min()
            assert each["bbox"] == [*low, columns.max() + 1 - low[0], rows.max() + 1 - low[1]]


def test_a_thousand_random_pixels_agree_with_rays_against_the_export(coco, solids, image_set: Path) -> None:
    draw = np.random.default_rng(10)
    checked = doubtful = 0
    for part, image in images(coco):
        found = parts_of(part, image)
        seen = sum(mask for *_, mask in found) > 0
        rows, columns = np.nonzero(seen)
        some = draw.integers(len(rows), size=83)
        pixels = np.vstack([np.column_stack([columns[some], rows[some]]), draw.integers(192, size=(20, 2))])
        depths = image["depth_scale"] * np.array(Image.open(image_set / image["depth_file"]), float)
        rays, far = solids[image["asset"]].seen(image, pixels + 0.5)
        for (x, y), message, depth in zip(pixels, rays, far, strict=True):
            shown = [(each["link"], label) for each, label, mask in found if mask[y, x]] or [("", "")]
            checked += 1
            if shown[0] == message:
                assert depths[y, x] == pytest.approx(depth if message[0] else 0.0, abs=2e-4)
                continue
            doubtful += 1  # an edge that runs through the middle of the pixel
            around = np.array([x, y]) + 0.5 + draw.uniform(-0.05, 0.05, (32, 2))
            assert shown[0] in solids[image["asset"]].seen(image, around)[0]
    assert checked == 1030
    assert doubtful <= 5


def test_joints_are_in_camera_coordinates(coco, assets, solids) -> None:
    moved = 0
    for part, image in images(coco):
        frames = solids[image["asset"]].urdf
        frames.update_cfg({name: image["joints"][name] for name in frames.actuated_joint_names})
        camera = np.array(image["extrinsics"])
        for each, _, _ in parts_of(part, image):
            for joint in each["joints"]:
                moved += 1
                # of two joints between the same links, the first one moves a small link of URDF's own
                pose = camera @ frames.get_transform(frames.joint_map[joint["name"]].child)
                assert joint["parent"] == assets[image["asset"]].joint(joint["name"]).parent
                assert joint["value"] == image["joints"][joint["name"]]
                assert joint["type"] == frames.joint_map[joint["name"]].type
                axis = pose[:3, :3] @ frames.joint_map[joint["name"]].axis
                assert joint["axis"] == pytest.approx(axis, abs=1e-6)
                if joint["type"] == "revolute":  # the origin of a frame lies on the joint's axis
                    assert joint["origin"] == pytest.approx(pose[:3, 3], abs=1e-6)
    assert moved > 15


def test_normals_face_the_camera(coco, image_set: Path) -> None:
    for part, image in images(coco):
        normals = np.array(Image.open(image_set / image["normals_file"]), float) / 127.5 - 1.0
        seen = sum(mask for *_, mask in parts_of(part, image)) > 0
        assert np.linalg.norm(normals[seen], axis=1) == pytest.approx(1.0, abs=0.02)
        column, row = np.meshgrid(np.arange(192) + 0.5, np.arange(192) + 0.5)
        pixels = np.stack([column, row, np.ones_like(row)], axis=-1)
        rays = pixels @ np.linalg.inv(np.array(image["intrinsics"])).T
        away = (normals * rays).sum(axis=-1)[seen]
        assert (away < 0.1).mean() > 0.98  # smooth normals turn away a little at outlines


@pytest.mark.long
def test_an_interrupted_set_gets_the_same_pictures(
    image_set: Path, image_plan: ImagePlan, tmp_path: Path
) -> None:
    folder = tmp_path / "set"
    shutil.copytree(image_set, folder)
    shutil.rmtree(folder / "plier" / "plier_1")
    (folder / "train.json").unlink()
    assert generate_many(image_plan, folder, jobs=1).made == 1
    assert digests(folder) == digests(image_set)
    with pytest.raises(ExportError, match="holds a dataset with images = 2, not 3: use the same options"):
        generate_many(replace(image_plan, images=3), folder)
    with pytest.raises(ExportError, match="has format 'artgen-images-1', not 'artgen-dataset-1'"):
        Dataset(folder)


def test_the_record_of_an_asset_is_next_to_its_pictures(image_set: Path, assets) -> None:
    for name, asset in assets.items():
        data = json.loads((image_set / asset.category / name / "asset.json").read_text())
        assert data["parameters"] == json.loads(json.dumps(rounded(asset.parameters)))


def test_pictures_of_a_room_name_the_asset_of_each_part(tmp_path: Path, opengl: None) -> None:
    plan = ImagePlan(("hall",), 1, 1, detail="low", images=2, size=128, samples=1, texture_size=0, depth=True)
    assert generate_many(plan, tmp_path / "set", jobs=1).failed == ()
    room = plan.draw(Item("hall", 1))
    known = {each.name: each for each in room.placed}
    data = json.loads((tmp_path / "set" / "train.json").read_text())
    names = {each["id"]: each["name"] for each in data["categories"]}
    assert len(data["annotations"]) > 6
    for each in data["annotations"]:
        assert names[each["category_id"]] in room.labels
        if not each["placed"]:
            assert (each["link"], each["joints"]) == ("room", [])
            continue
        own = each["link"].removeprefix(f"{each['placed']}_")
        assert f"{each['placed']}_{own}" == each["link"]
        assert each["placed"] in known
        assert not any(joint["name"].endswith("_place") for joint in each["joints"])
    moving = [each for each in data["annotations"] if each["joints"]]
    assert moving
    for image in data["images"]:
        q = {joint.name: image["joints"][joint.name] for joint in room.free_joints}
        assert not room.blocked(q)
        depth = np.array(Image.open(tmp_path / "set" / image["depth_file"])) * image["depth_scale"]
        assert depth[depth > 0].min() > 0.05
