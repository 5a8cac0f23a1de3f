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

TILE = 0.3
"""Side of the squares that a network looks at one by one, as a share of that around the asset."""

_LEAST = 12  # pixels of an instance
_APART = 2.0  # how far two places are that pixels point to, by how much they disagree about each
_NEAR = 0.3  # how near, by the side of a square as large as what points there


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

    def picture(self, index: int) -> Array:
        """Return an image, shape (height, width, 3)."""
        return np.array(self._opened(index))

    def looks(self, index: int, size: int, boxes: Sequence[Box]) -> Array:
        """Return what boxes of an image show, in squares of pixels, shape (boxes, size, size, 3)."""
        picture, most = self._opened(index), self.whole(index)[2:] * 2
        inside = [tuple(np.clip(box, 0.0, most)) for box in boxes]  # rounded numbers may not be
        return np.stack([picture.resize((size, size), Image.Resampling.BILINEAR, box, 2.0) for box in inside])

    def _opened(self, index: int) -> Image.Image:
        with Image.open(self.folder / self.images[index]["file_name"]) as image:
            return image.convert("RGB")

    def masks(self, index: int) -> list[tuple[int, Array]]:
        """Return the class and the mask of each part in an image, without what is of no part."""
        found = self._annotations[self.images[index]["id"]]
        return [(each["class"], rle.decode(each["rle"]) > 0) for each in found if each["class"] != self.other]

    def whole(self, index: int) -> Box:
        """Return the box of a whole image."""
        return 0.0, 0.0, float(self.images[index]["width"]), float(self.images[index]["height"])

    def view(self, index: int, rng: np.random.Generator) -> tuple[Box, Box]:
        """Draw a box to look at, and the box of what it is part of.

        The first is most of an image, or a square of about `TILE` of the asset, often around a part of it;
        the second is the same, or the square around the asset.
        """
        whole = self.whole(index)
        width, height = whole[2:]
        if rng.random() < 0.15:
            zoom = rng.uniform(0.8, 1.0)
            left, top = rng.uniform(0.0, 1.0 - zoom, 2) * (width, height)
            box = left, top, left + zoom * width, top + zoom * height
            return box, box
        found = self._annotations[self.images[index]["id"]]
        boxes = np.array([rle.toBbox(each["rle"]) for each in found])
        low, high = boxes[:, :2].min(0), (boxes[:, :2] + boxes[:, 2:]).max(0)
        around = (low, high) + rng.normal(0.0, 0.03, (2, 2)) * (high - low)
        asset = square((*around[0], *around[1]), (width, height), rng.uniform(0.06, 0.2))
        middle = rng.uniform(low, high)
        kinds = np.array([each["class"] for each in found])
        there = np.unique(kinds[kinds != self.other])
        if len(there) and rng.random() < 0.75:  # a class of those in the image, and a part of it
            one = boxes[rng.choice(np.flatnonzero(kinds == rng.choice(there)))]
            middle = one[:2] + rng.uniform(0.0, 1.0, 2) * one[2:]
        side = TILE * (asset[2] - asset[0]) * rng.uniform(0.8, 1.25)
        middle += rng.uniform(-0.3, 0.3, 2) * side
        return square((*(middle - 0.5 * side), *(middle + 0.5 * side)), (width, height), 0.0), asset

    def example(self, index: int, size: int, box: Box | None = None) -> tuple[Array, ...]:
        """Return an image and what a network is to say of it, in a square.

        Args:
            index: Which image.
            size: Pixels on a side.
            box: Left, top, right and bottom of what is shown [pixels]; by default all.

        Returns:
            The image, shape (size, size, 3), uint8; the class of each pixel; and the way from each pixel to
            the centre of its instance, which may lie outside, shape (2, size, size) [sides of the square],
            NaN where there is none.
        """
        left, top, right, bottom = box = self.whole(index) if box is None else box
        (image,) = self.looks(index, size, [box])
        middle = (np.arange(size) + 0.5) / size
        rows, columns = ((a + middle * (b - a)).astype(int) for a, b in ((top, bottom), (left, right)))
        corner, sides = np.array(((top,), (left,))), np.array(((bottom - top,), (right - left,)))
        classes = np.zeros((size, size), np.uint8)
        offsets = np.full((2, size, size), np.nan, np.float32)
        for each in self._annotations[self.images[index]["id"]]:
            mask = rle.decode(each["rle"])
            y, x = np.nonzero(mask[np.ix_(rows, columns)])
            if len(y) == 0:
                continue
            classes[y, x] = each["class"]
            if each["class"] != self.other:
                centre = np.mean(np.nonzero(mask), 1, keepdims=True) + 0.5
                offsets[:, y, x] = (centre - corner) / sides - middle[np.stack((y, x))]
        return image, classes, offsets

    def shares(self) -> Array:
        """Return how often each image is to be learnt from: those without wanted parts a quarter as often."""
        wanted = [
            any(each["class"] != self.other for each in self._annotations[image["id"]])
            for image in self.images
        ]
        weights = np.where(wanted, 1.0, 0.25)
        return weights / weights.sum()

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


def within(box: Box, around: Box) -> Array:
    """Return where a box is in another, shape (4,) [sides of that one]."""
    corner, sides = np.array(around[:2] * 2), np.subtract(around[2:], around[:2])
    return ((np.array(box) - corner) / np.tile(sides, 2)).astype(np.float32)


def changed(
    images: Sequence[Array], classes: Array, offsets: Array, place: Array, rng: np.random.Generator
) -> tuple[list[Array], Array, Array, Array]:
    """Return images of one asset in another light, and half of the time mirrored with what is said of them.

    Without it, a network learns the colours of the few assets that it sees by heart.

    Args:
        images: Each of shape (height, width, 3), uint8.
        classes: Of each pixel of the first, shape (height, width).
        offsets: From each of these to the centre of its instance, shape (2, height, width).
        place: Where the first lies in the second, as `within` returns it.
        rng: Draws brightness, contrast, tint, and whether all is mirrored.
    """
    gain, shift = rng.uniform(0.7, 1.05) * rng.uniform(0.95, 1.05, 3), rng.uniform(-10.0, 10.0)
    lit = [np.clip(image * gain + shift, 0.0, 255.0).astype(np.uint8) for image in images]
    if rng.random() < 0.5:
        lit = [np.ascontiguousarray(image[:, ::-1]) for image in lit]
        classes = np.ascontiguousarray(classes[:, ::-1])
        offsets = offsets[:, :, ::-1] * np.array([[[1.0]], [[-1.0]]], np.float32)
        place = np.array([1.0 - place[2], place[1], 1.0 - place[0], place[3]], np.float32)
    return lit, classes, offsets, place


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
    """Tell instances apart: pixels of a class that hang together and point to the same centre are of one.

    A region whose pixels point to two places is parted, and regions that point to the same place are joined:
    the one has a neighbour of its class, the others something before it.

    Args:
        probabilities: Of each class in each pixel, shape (2 + classes, height, width).
        offsets: From each pixel to the centre of its instance, shape (2, height, width) [heights and widths].
    """
    best = probabilities.argmax(0)
    found: list[Instance] = []
    for number in np.unique(best[(best > 0) & (best < len(probabilities) - 1)]):
        y, x = np.nonzero(best == number)
        regions = ndimage.label(best == number)[0][y, x]
        votes = np.stack((y, x)) + offsets[:, y, x] * np.array(best.shape)[:, None]
        whole = [np.flatnonzero(regions == each) for each in range(1, regions.max() + 1)]
        parted = [each for region in whole if len(region) >= _LEAST for each in _parted(votes, region)]
        for members in _joined(votes, parted):
            mask = np.zeros(best.shape, bool)
            mask[y[members], x[members]] = True
            found.append((int(number), float(probabilities[number][mask].mean()), mask))
    return found


def _parted(votes: Array, members: Array) -> list[Array]:
    """Part pixels that point to two places, far apart for how much they disagree about each."""
    mine = votes[:, members]
    apart = mine - mine.mean(1, keepdims=True)
    along = np.linalg.svd(apart @ apart.T)[0][:, 0] @ apart
    halves = [along < 0.0, along >= 0.0]
    for _ in range(8):  # the means of the two, and who is nearer to which
        if min(map(np.sum, halves)) < _LEAST:
            return [members]
        low, high = (along[half].mean() for half in halves)
        halves = [along < 0.5 * (low + high), along >= 0.5 * (low + high)]
    if min(map(np.sum, halves)) < _LEAST:
        return [members]
    low, high = (along[half].mean() for half in halves)
    if high - low < _APART * sum(along[half].std() for half in halves) + 2.0:
        return [members]
    return [each for half in halves for each in _parted(votes, members[half])]


def _joined(votes: Array, groups: list[Array]) -> list[Array]:
    """Join groups of pixels, the largest first, that point to the same place, for how large they are."""
    joined: list[Array] = []
    for group in sorted(groups, key=len, reverse=True):
        for index, other in enumerate(joined):
            far = np.hypot(*(votes[:, group].mean(1) - votes[:, other].mean(1)))
            if far < _NEAR * np.sqrt(len(group) + len(other)):
                joined[index] = np.concatenate((other, group))
                break
        else:
            joined.append(group)
    return joined


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
