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

Array = NDArray[Any]
Box = tuple[float, float, float, float]
"""Left, top, right and bottom [pixels]."""
Instance = tuple[int, float, Array, Box]
"""Class from 1 on, score, how likely each place is of it, shape (height, width), and the box of these."""

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
        "base": ("base", "foot", "switch"),
        "rod": ("pole", "swivel", "slider", "arm_lower", "arm_upper"),
        "head": ("shade", "socket", "bulb", "harp", "finial"),
        "switch": ("button", "rocker", "dial", "pull_chain"),
    },
}
"""Labels of each part, by category; any other label is of the first part here that its link has a label of.

In other categories each label is a part. A lamp's label `switch` is what holds the part that moves.
"""

NO_PART = ("cord", "hose")

HANDLE_LIKE = ("handle", "lever", "knob", "button", "switch")
"""Parts that a hand acts on."""

SMALLEST = 4e-4
"""Share of the pixels of an image below which a part is not asked for: 20 x 20 pixels of 1024 x 1024."""

SAME = 0.5
"""Overlap of two masks, intersection over union, from which they are of the same part."""


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
        self._categories = {
            each["image_id"]: self._labels[each["category_id"]][0] for each in coco.anns.values()
        }
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

    def image(self, index: int) -> Image.Image:
        """Open an image."""
        with Image.open(self.folder / self.images[index]["file_name"]) as image:
            return image.convert("RGB")

    def parts(self, index: int) -> list[tuple[int, Any, Box]]:
        """Return the class, the mask as RLE and the box of each part in an image, the largest box first."""
        found = [each for each in self._of(index) if each["class"] != self.other]
        boxes = [rle.toBbox(each["rle"]) for each in found]
        order = np.argsort([-width * height for _, _, width, height in boxes], kind="stable")
        return [(found[i]["class"], found[i]["rle"], corners(boxes[i])) for i in order]

    def masks(self, index: int) -> list[tuple[int, Array]]:
        """Return the class and the mask of each part in an image, without what is of no part."""
        return [(number, rle.decode(mask) > 0) for number, mask, _ in self.parts(index)]

    def silhouette(self, index: int) -> Array:
        """Return where an image shows the asset, shape (height, width)."""
        return rle.decode(self._asset(index)) > 0

    def asset_box(self, index: int) -> Box:
        """Return the box of the asset in an image."""
        return corners(rle.toBbox(self._asset(index)))

    def possible(self, index: int) -> Array:
        """Return which classes are of the category of the asset in an image, shape (classes,)."""
        category = self._categories[self.images[index]["id"]]
        return np.array([name.partition("/")[0] == category for name in self.classes])

    def whole(self, index: int) -> Box:
        """Return the box of a whole image."""
        return 0.0, 0.0, float(self.images[index]["width"]), float(self.images[index]["height"])

    def _asset(self, index: int) -> Any:
        return rle.merge([each["rle"] for each in self._of(index)])

    def _of(self, index: int) -> list[dict[str, Any]]:
        return self._annotations[self.images[index]["id"]]

    def shares(self) -> Array:
        """Return how often each image is to be learnt from: those without wanted parts a quarter as often."""
        wanted = [any(each["class"] != self.other for each in self._of(i)) for i in range(len(self))]
        weights = np.where(wanted, 1.0, 0.25)
        return weights / weights.sum()


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


def corners(box: Sequence[float]) -> Box:
    """Return the box that COCO has as left, top, width and height."""
    left, top, width, height = map(float, box)
    return left, top, left + width, top + height


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


def as_results(image: dict[str, Any], found: Sequence[Instance]) -> list[dict[str, Any]]:
    """Return instances as COCO's results, the likeliest first, without those that another one covers."""
    width, height = image["width"], image["height"]
    results: list[dict[str, Any]] = []
    for number, score, likely, box in sorted(found, key=lambda each: -each[1]):
        mask = rle.encode(np.asfortranarray(laid(likely, box, (width, height)), np.uint8))
        same = [each["segmentation"] for each in results if each["category_id"] == number]
        if rle.area(mask) == 0 or (same and rle.iou([mask], same, [False] * len(same)).max() > SAME):
            continue
        results.append(
            {"image_id": image["id"], "category_id": number, "segmentation": mask, "score": float(score)}
        )
    return results


def laid(likely: Array, box: Box, size: tuple[int, int]) -> Array:
    """Return where something is in an image, shape (height, width), that is likely at places in a box."""
    mask = np.zeros(size[::-1], bool)
    low = np.clip(np.floor(box[:2]), 0, size).astype(int)
    high = np.clip(np.ceil(box[2:]), 0, size).astype(int)
    if (high <= low).any():
        return mask
    scale = likely.shape[::-1] / np.subtract(box[2:], box[:2])
    extent = (*((low - box[:2]) * scale), *((high - box[:2]) * scale))
    shown = Image.fromarray(likely.astype(np.float32)).transform(
        tuple((high - low).tolist()), Image.Transform.EXTENT, extent, Image.Resampling.BILINEAR
    )
    mask[low[1] : high[1], low[0] : high[0]] = np.asarray(shown) > 0.5
    return mask


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
