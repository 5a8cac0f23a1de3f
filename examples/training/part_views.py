"""What a network looks at: an asset in a square, and its parts from near, drawn at random and relit."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from part_images import Array, Box, PartImages, square
from PIL import Image
from pycocotools import mask as rle

CELL = 4
"""Pixels on a side of the cells for each of which a network says what is there."""

AROUND = 1.7
"""Side of the square in which a part is seen from near, by the longer side of its box."""

_PEAK = 0.12  # how far around the middle of a box a peak falls off, by the box's sides
_SPREAD = 0.08  # by how much the boxes are off in which parts are seen from near, by their sides


@dataclass(frozen=True)
class Wide:
    """A square of an image, and what is in each cell of it, `n` on a side.

    Attributes:
        image: Shape (size, size, 3), uint8.
        peaks: For each class, 1 where the middle of a part's box is, less around it, shape (classes, n, n).
        sides: From the middle of a cell to left, top, right and bottom of a part of each class [cells], shape
            (classes, 4, n, n).
        weights: How much these count in a cell; 1 in all for each part, shape (classes, n, n).
        asset: Whether a cell shows the asset, shape (n, n).
    """

    image: Array
    peaks: Array
    sides: Array
    weights: Array
    asset: Array

    def mirrored(self) -> "Wide":
        """Return it with left and right changed."""
        return Wide(
            self.image[:, ::-1],
            self.peaks[:, :, ::-1],
            self.sides[:, [2, 1, 0, 3], :, ::-1],
            self.weights[:, :, ::-1],
            self.asset[:, ::-1],
        )


def wide(images: PartImages, index: int, image: Image.Image, box: Box, size: int) -> Wide:
    """Return a square of an image as a network sees it, and what it is to say of it."""
    n, classes = size // CELL, len(images.classes)
    peaks, weights = np.zeros((2, classes, n, n), np.float32)
    sides = np.zeros((classes, 4, n, n), np.float32)
    y, x = np.mgrid[:n, :n] + 0.5
    for number, _, part in images.parts(index):  # the smaller ones last: they are before the larger ones
        low, high = (n * np.subtract(each, box[:2]) / (box[2] - box[0]) for each in (part[:2], part[2:]))
        middle = 0.5 * (low + high)
        if not ((middle >= 0.0) & (middle < n)).all():
            continue
        across, down = (
            (np.array((x, y)).T - np.floor(middle) - 0.5) / np.maximum(0.7, _PEAK * (high - low))
        ).T
        peak = np.exp(-0.5 * (across**2 + down**2))
        kind = number - 1
        peaks[kind] = np.maximum(peaks[kind], peak)
        near = peak > 0.4
        sides[kind][:, near] = np.stack((x - low[0], y - low[1], high[0] - x, high[1] - y))[:, near]
        weights[kind][near] = peak[near] / peak[near].sum()
    shown = sampled(images.silhouette(index), box, n)
    return Wide(look(image, box, size), peaks, sides, weights, shown)


def wide_box(images: PartImages, index: int, rng: np.random.Generator) -> Box:
    """Draw a square to look at: the whole image, the asset, or some of it, often with a part in it."""
    whole = images.whole(index)
    if rng.random() < 0.12:
        return square(whole, whole[2:], 0.0)
    asset = square(images.asset_box(index), whole[2:], rng.uniform(0.02, 0.2))
    left, top, right, bottom = asset
    if rng.random() < 0.3:
        return asset
    side = (right - left) * rng.uniform(0.4, 1.0)
    corner = rng.uniform((left, top), (right - side, bottom - side))
    parts = images.parts(index)
    if parts and rng.random() < 0.6:
        part = parts[rng.integers(len(parts))][2]
        middle = np.add(part[:2], part[2:]) / 2.0
        corner = np.clip(middle - rng.uniform(0.1, 0.9, 2) * side, (left, top), (right - side, bottom - side))
    return float(corner[0]), float(corner[1]), float(corner[0] + side), float(corner[1] + side)


def near(image: Image.Image, box: Box, size: int) -> tuple[Array, Box]:
    """Return what is in a box and around it, as a network sees it from near, and the square that it sees.

    Args:
        image: The image.
        box: Of a part.
        size: Pixels on a side.

    Returns:
        Colors, and 255 inside of the box, shape (size, size, 4), uint8; the square, which may reach beyond
        the image, where all is black.
    """
    width, height = box[2] - box[0], box[3] - box[1]
    half = 0.5 * AROUND * max(width, height, 8.0)
    x, y = 0.5 * (box[0] + box[2]), 0.5 * (box[1] + box[3])
    region = x - half, y - half, x + half, y + half
    if 2.0 * half < 2 * size:
        seen = image.transform((size, size), Image.Transform.EXTENT, region, Image.Resampling.BILINEAR)
    else:  # of many pixels each one is to count
        cut = image.crop(tuple(round(each) for each in region))
        seen = cut.resize((size, size), Image.Resampling.BILINEAR, reducing_gap=2.0)
    at = 2.0 * half * (np.arange(size) + 0.5) / size
    inside = np.outer(
        (at > box[1] - region[1]) & (at < box[3] - region[1]),
        (at > box[0] - region[0]) & (at < box[2] - region[0]),
    )
    return np.dstack((np.asarray(seen), np.where(inside, 255, 0).astype(np.uint8))), region


def close_ups(
    images: PartImages, index: int, image: Image.Image, count: int, size: int, rng: np.random.Generator
) -> tuple[list[Array], list[Array]]:
    """Draw parts of an image, each class as often, and return them from near with their masks.

    The boxes are a little off, as a network finds them.
    """
    parts = images.parts(index)
    looks, masks = [], []
    kinds = np.array([number for number, _, _ in parts])
    for _ in range(count if parts else 0):
        chosen = rng.choice(np.flatnonzero(kinds == rng.choice(np.unique(kinds))))
        _, mask, box = parts[chosen]
        off = rng.normal(0.0, _SPREAD, 4) * np.tile(np.subtract(box[2:], box[:2]), 2)
        seen, region = near(image, tuple((box + off).tolist()), size)
        looks.append(seen)
        masks.append(sampled(rle.decode(mask) > 0, region, size))
    return looks, masks


def look(image: Image.Image, box: Box, size: int) -> Array:
    """Return what a box of an image shows, in a square of pixels, shape (size, size, 3), uint8."""
    inside = tuple(np.clip(box, 0.0, image.size * 2))  # rounded numbers may not be
    return np.array(image.resize((size, size), Image.Resampling.BILINEAR, inside, 2.0))


def sampled(mask: Array, box: Box, size: int) -> Array:
    """Return a mask at the middles of the cells of a square, shape (size, size); nothing is outside of it."""
    middle = (np.arange(size) + 0.5) / size
    rows, columns = (
        np.floor(a + middle * (b - a)).astype(int) for a, b in ((box[1], box[3]), (box[0], box[2]))
    )
    found = np.zeros((size, size), bool)
    inside = [
        np.flatnonzero((at >= 0) & (at < most)) for at, most in zip((rows, columns), mask.shape, strict=True)
    ]
    found[np.ix_(*inside)] = mask[np.ix_(rows[inside[0]], columns[inside[1]])]
    return found


def relit(pictures: Sequence[Array], rng: np.random.Generator) -> list[Array]:
    """Return pictures of an asset in another light, and sometimes of other colors.

    Without it, a network learns the colors of the few assets that it sees by heart. What pictures have
    beside their three colors stays.
    """
    gain = rng.uniform(0.6, 1.15) * rng.uniform(0.8, 1.2, 3)
    shift, gamma = rng.uniform(-25.0, 25.0), np.exp(rng.uniform(-0.35, 0.35))
    color = rng.uniform(0.0, 1.5) if rng.random() < 0.5 else 1.0
    order = rng.permutation(3) if rng.random() < 0.3 else np.arange(3)

    def changed(picture: Array) -> Array:
        seen = picture[..., order].astype(np.float32)
        grey = seen.mean(-1, keepdims=True)
        seen = np.clip((grey + color * (seen - grey)) * gain, 0.0, 255.0)
        seen = np.clip(255.0 * (seen / 255.0) ** gamma + shift, 0.0, 255.0)
        return np.concatenate((seen.astype(np.uint8), picture[..., 3:]), -1)

    return [changed(each) for each in pictures]


def turned(look: Array, mask: Array, rng: np.random.Generator) -> tuple[Array, Array]:
    """Return a look from near and its mask, turned by quarters and mirrored at random."""
    quarters, mirror = rng.integers(4), rng.random() < 0.5
    looks = [np.rot90(each, quarters) for each in (look, mask)]
    return tuple(each[:, ::-1] if mirror else each for each in looks)  # type: ignore[return-value]
