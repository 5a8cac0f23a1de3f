"""Read what `artgen images` writes as examples of parts, and measure masks by COCO's average precision.

Needs `artgen[images]`, for pycocotools; no torch.
"""

import contextlib
import difflib
import io
from collections import defaultdict
from collections.abc import Sequence
from collections.abc import Set as AbstractSet
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image
from pycocotools import mask as rle
from pycocotools.coco import COCO
from pycocotools.cocoeval import COCOeval
from scipy import ndimage

Array = NDArray[Any]
Instance = tuple[int, float, Array]
"""Class from 1 on, score, and mask, shape (height, width)."""
Box = tuple[float, float, float, float]
"""Left, top, right and bottom [pixels]."""

PARTS: dict[str, dict[str, tuple[str, ...]]] = {
    "door": {"frame": ("frame",), "body": ("door",), "handle": ("handle",)},
    "toaster": {"body": ("body",), "lever": ("lever",), "knob": ("knob",), "button": ("button",)},
    "refrigerator": {"body": ("body",), "door": ("door", "freezer_door")},
    "dishwasher": {
        "body": ("body",),
        "door": ("door",),
        "shelf": ("rack", "cup_shelf", "cutlery_basket"),
        "button": ("button",),
        "knob": ("knob",),
    },
    "lamp": {
        "base": ("base", "foot"),
        "rod": ("pole", "swivel", "slider", "arm_lower", "arm_upper"),
        "head": ("shade", "socket", "bulb", "harp", "finial"),
        "switch": ("switch", "button", "rocker", "dial", "pull_chain"),
    },
}
"""Labels of each part, by category; any other label is of the first part here that its link has a label of.

In other categories each label is a part.
"""

NO_PART = ("cord", "hose")

HANDLE_LIKE = ("handle", "lever", "knob", "button", "switch")
"""Parts that a hand acts on."""

SMALLEST = 4e-4
"""Share of the pixels of an image below which a part is not asked for: 10 x 10 pixels of 512 x 512."""

_BLUR = 1.5  # of the votes for centres [cells]
_CELLS = 160  # that the votes are counted in, on a side
_LEAST = 12  # pixels of an instance
_MOST = 20  # instances of a class in an image


class PartImages:
    """The images of a split, with an instance mask for each part of each link.

    Attributes:
        classes: Names such as `door/handle`; class 0 is the background, so theirs begin with 1.
        other: The class after them: of what is on an asset and of no part, or of one that is not wanted.
        images: COCO's records of the images.
        truth: The parts as COCO's ground truth.
    """

    def __init__(self, folder: Path, split: str, parts: Sequence[str] = ()) -> None:
        file = folder / f"{split}.json"
        if not file.is_file():
            raise SystemExit(f"error: there is no {file}; make it with: artgen images door --out {folder}")
        self.folder = folder
        with contextlib.redirect_stdout(io.StringIO()):  # pycocotools prints how it gets on
            coco = COCO(file)
        self.images: list[dict[str, Any]] = list(coco.imgs.values())
        if not self.images:
            raise SystemExit(f"error: {file} has no images; make more assets, so that each split has some")
        self._labels = {each["id"]: (each["supercategory"], each["name"]) for each in coco.cats.values()}
        on_link: dict[tuple[str, str], set[str]] = defaultdict(set)
        for each in coco.anns.values():
            on_link[self._place(coco, each)].add(self._labels[each["category_id"]][1])
        self._parts = {
            each["id"]: part_of(*self._labels[each["category_id"]], on_link[self._place(coco, each)])
            for each in coco.anns.values()
        }
        names = dict.fromkeys(part_of(*each, {each[1]}) for each in self._labels.values())
        self.classes = chosen(tuple(name for name in names if name), parts)
        self.other = len(self.classes) + 1
        self._annotations = {each["id"]: self._merged(coco, each["id"]) for each in self.images}
        self.truth = ground_truth(self.images, self._annotations, self.classes)

    def __len__(self) -> int:
        return len(self.images)

    @staticmethod
    def _place(coco: COCO, annotation: dict[str, Any]) -> tuple[str, str]:
        """Return asset and link of an annotation."""
        return coco.imgs[annotation["image_id"]]["asset"], annotation["link"]

    def _merged(self, coco: COCO, image: int) -> list[dict[str, Any]]:
        """Return an annotation for each part of each link in an image, of those for its labels."""
        numbers = {name: number for number, name in enumerate(self.classes, 1)}
        groups: dict[tuple[int, str], list[Any]] = defaultdict(list)
        for each in coco.imgToAnns[image]:
            groups[numbers.get(self._parts[each["id"]], self.other), each["link"]].append(coco.annToRLE(each))
        return [{"class": number, "rle": rle.merge(masks)} for (number, _), masks in groups.items()]

    def picture(self, index: int) -> Image.Image:
        """Open an image."""
        return Image.open(self.folder / self.images[index]["file_name"]).convert("RGB")

    def masks(self, index: int) -> list[tuple[int, Array]]:
        """Return the class and the mask of each part in an image, without what is of no part."""
        found = self._annotations[self.images[index]["id"]]
        return [(each["class"], rle.decode(each["rle"]) > 0) for each in found if each["class"] != self.other]

    def whole(self, index: int) -> Box:
        """Return the box of a whole image."""
        return 0.0, 0.0, float(self.images[index]["width"]), float(self.images[index]["height"])

    def view(self, index: int, rng: np.random.Generator) -> Box:
        """Draw a box: most of an image, or about as much as the asset takes."""
        _, _, width, height = self.whole(index)
        if rng.random() < 0.35:
            zoom = rng.uniform(0.8, 1.0)
            left, top = rng.uniform(0.0, 1.0 - zoom, 2) * (width, height)
            return left, top, left + zoom * width, top + zoom * height
        boxes = np.array([rle.toBbox(each["rle"]) for each in self._annotations[self.images[index]["id"]]])
        low, high = boxes[:, :2].min(0), (boxes[:, :2] + boxes[:, 2:]).max(0)
        around = (low, high) + rng.normal(0.0, 0.04, (2, 2)) * (high - low)
        return square((*around[0], *around[1]), (width, height), rng.uniform(0.0, 0.3))

    def example(self, index: int, size: int, box: Box | None = None) -> tuple[Array, ...]:
        """Return an image and what a network is to say of it, in a square.

        Args:
            index: Which image.
            size: Pixels on a side.
            box: Left, top, right and bottom of what is shown [pixels]; by default all.

        Returns:
            The image, shape (size, size, 3), uint8; the class of each pixel; and the way from each pixel to
            the centre of its instance, shape (2, size, size) [sides of the square], NaN where there is none.
        """
        left, top, right, bottom = box = self.whole(index) if box is None else box
        image = np.array(self.picture(index).resize((size, size), Image.Resampling.BILINEAR, box, 2.0))
        middle = (np.arange(size) + 0.5) / size
        rows, columns = ((a + middle * (b - a)).astype(int) for a, b in ((top, bottom), (left, right)))
        classes = np.zeros((size, size), np.uint8)
        offsets = np.full((2, size, size), np.nan, np.float32)
        for each in self._annotations[self.images[index]["id"]]:
            y, x = np.nonzero(rle.decode(each["rle"])[np.ix_(rows, columns)])
            if len(y) == 0:
                continue
            classes[y, x] = each["class"]
            if each["class"] != self.other:
                offsets[:, y, x] = (np.array((y.mean(), x.mean()))[:, None] - (y, x)) / size
        return image, classes, offsets

    def frequencies(self) -> Array:
        """Return which share of the pixels is of each class, shape (2 + classes,)."""
        areas = np.zeros(2 + len(self.classes))
        for each in self.images:
            areas[0] += each["width"] * each["height"]
            for found in self._annotations[each["id"]]:
                area = float(rle.area(found["rle"]))
                areas[0] -= area
                areas[found["class"]] += area
        return areas / areas.sum()


def part_of(category: str, label: str, on_link: AbstractSet[str]) -> str:
    """Return the part that a label is of, such as `door/handle`; empty if it is of none.

    Args:
        category: Of the asset.
        label: The label.
        on_link: Labels of its link.
    """
    if category not in PARTS:
        return f"{category}/{label}"
    parts = {part: {*labels} for part, labels in PARTS[category].items()}
    of_label = [part for part, labels in parts.items() if label in labels]
    of_link = [part for part, labels in parts.items() if labels & on_link and label not in NO_PART]
    return next((f"{category}/{part}" for part in of_label + of_link), "")


def chosen(classes: tuple[str, ...], wanted: Sequence[str]) -> tuple[str, ...]:
    """Return the wanted classes, which may be named in full or by the part alone; all if none is named."""
    for name in wanted:
        if not any(name in (each, each.partition("/")[2]) for each in classes):
            near = difflib.get_close_matches(name, classes, 1, 0.3)
            hint = f"did you mean {near[0]!r}?" if near else f"there are {', '.join(classes)}"
            raise SystemExit(f"error: no part {name!r} in these images; {hint}")
    return tuple(each for each in classes if not wanted or {each, each.partition("/")[2]} & {*wanted})


def square(box: Box, size: tuple[float, float], margin: float) -> Box:
    """Return the square around a box with a margin, a share of its side, as far as it fits into an image."""
    side = min((1.0 + margin) * max(box[2] - box[0], box[3] - box[1]), *size)
    left, top = (
        float(np.clip((a + b - side) / 2.0, 0.0, most - side))
        for a, b, most in ((box[0], box[2], size[0]), (box[1], box[3], size[1]))
    )
    return left, top, left + side, top + side


def changed(example: tuple[Array, ...], rng: np.random.Generator) -> tuple[Array, ...]:
    """Return an example with another brightness, contrast and tint, and half of the time its mirror image."""
    image, classes, offsets = example
    gain, shift = rng.uniform(0.7, 1.3) * rng.uniform(0.92, 1.08, 3), rng.uniform(-20.0, 20.0)
    image = np.clip(image * gain + shift, 0.0, 255.0).astype(np.uint8)
    if rng.random() < 0.5:
        image, classes, offsets = image[:, ::-1], classes[:, ::-1], offsets[:, :, ::-1] * [[[1.0]], [[-1.0]]]
    return np.ascontiguousarray(image), np.ascontiguousarray(classes), offsets.astype(np.float32)


def ground_truth(
    images: list[dict[str, Any]], annotations: dict[int, list[dict[str, Any]]], classes: Sequence[str]
) -> COCO:
    """Return the parts as pycocotools wants them."""
    truth = COCO()
    found = [
        {"image_id": image, "category_id": each["class"], "segmentation": each["rle"], "iscrowd": 0}
        | {"area": float(rle.area(each["rle"])), "bbox": rle.toBbox(each["rle"]).tolist()}
        for image, several in annotations.items()
        for each in several
        if each["class"] <= len(classes)
    ]
    truth.dataset = {
        "images": images,
        "categories": [{"id": number, "name": name} for number, name in enumerate(classes, 1)],
        "annotations": [{"id": number, **each} for number, each in enumerate(found, 1)],
    }
    with contextlib.redirect_stdout(io.StringIO()):
        truth.createIndex()
    return truth


def instances(probabilities: Array, offsets: Array) -> list[Instance]:
    """Tell instances apart: pixels of a class that point to the same centre are of one.

    Args:
        probabilities: Of each class in each pixel, shape (2 + classes, height, width).
        offsets: From each pixel to the centre of its instance, shape (2, height, width) [heights and widths].
    """
    best = probabilities.argmax(0)
    found: list[Instance] = []
    for number in np.unique(best[(best > 0) & (best < len(probabilities) - 1)]):
        regions, count = ndimage.label(best == number)
        y, x = np.nonzero(regions)
        votes = np.stack((y, x)) + offsets[:, y, x] * np.array(best.shape)[:, None]
        areas = np.bincount(regions.ravel(), minlength=count + 1)
        reach = 2.0 + 0.35 * np.sqrt(areas[regions[y, x]])  # large parts point less precisely
        for members in _gathered(votes, reach, best.shape):
            mask = np.zeros(best.shape, bool)
            mask[y[members], x[members]] = True
            found.append((int(number), float(probabilities[number][mask].mean()), mask))
    return found


def _gathered(votes: Array, reach: Array, shape: tuple[int, ...]) -> list[Array]:
    """Group votes for centres, shape (2, n): around the place with most, then around that of the rest."""
    cells = np.clip(votes / np.array(shape)[:, None] * _CELLS, 0, _CELLS - 1).astype(int)
    left, groups = np.arange(votes.shape[1]), []
    while len(left) >= _LEAST and len(groups) < _MOST:
        heat = np.zeros((_CELLS, _CELLS), np.float32)
        np.add.at(heat, tuple(cells[:, left]), 1.0)
        peak = np.unravel_index(ndimage.gaussian_filter(heat, _BLUR).argmax(), heat.shape)
        centre = (np.array(peak) + 0.5) / _CELLS * shape
        near = np.hypot(*(votes[:, left] - centre[:, None])) < reach[left]
        if not near.any():
            break
        if near.sum() >= _LEAST:
            groups.append(left[near])
        left = left[~near]
    return groups


def as_results(image: dict[str, Any], found: list[Instance], box: Box | None = None) -> list[dict[str, Any]]:
    """Return instances as COCO's results, at the size of their image, of which the masks show a box."""
    width, height = image["width"], image["height"]
    left, top, right, bottom = (round(each) for each in box or (0, 0, width, height))
    results = []
    for number, score, mask in found:
        full = np.zeros((height, width), np.uint8, order="F")
        shown = Image.fromarray(mask).resize((right - left, bottom - top), Image.Resampling.NEAREST)
        full[top:bottom, left:right] = shown
        results.append(
            {"image_id": image["id"], "category_id": number, "segmentation": rle.encode(full), "score": score}
        )
    return results


def average_precisions(truth: COCO, results: list[dict[str, Any]]) -> dict[str, tuple[float, float]]:
    """Return AP, over IoU 0.50 to 0.95, and AP at IoU 0.50 of each part that is to be seen.

    Parts of fewer pixels than `SMALLEST` of the image's are neither missed nor counted.
    """
    names = {each["id"]: each["name"] for each in truth.dataset["categories"]}
    image = truth.dataset["images"][0]
    least = SMALLEST * image["width"] * image["height"]
    seen = {each["category_id"] for each in truth.dataset["annotations"] if each["area"] >= least}
    if not results:
        return {names[key]: (0.0, 0.0) for key in sorted(seen)}
    with contextlib.redirect_stdout(io.StringIO()):
        evaluation = COCOeval(truth, truth.loadRes(results), "segm")
        evaluation.params.areaRng, evaluation.params.areaRngLbl = [[least, 1e10]], ["all"]
        evaluation.evaluate()
        evaluation.accumulate()
    precision = evaluation.eval["precision"]  # by IoU, recall, category, area, number of detections
    found = {}
    for index, key in enumerate(evaluation.params.catIds):
        if key in seen:
            curve = precision[:, :, index, 0, -1]
            found[names[key]] = (float(curve.mean()), float(curve[0].mean()))
    return found
