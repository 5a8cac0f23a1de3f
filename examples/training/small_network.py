"""A small network for the parts of assets: one half finds them, the other traces each from near.

The finder looks at the asset once and says of each cell how likely a part of each class has its middle there,
and how far the sides of the part's box are. The tracer sees each box from near, whatever its size in the
image, and says which pixels are of it. What a class is, it need not know: it learns from all of them.
"""

import itertools
from dataclasses import replace
from typing import Any

import numpy as np
import torch
from part_images import Box, Instance, PartImages, as_results, square
from part_views import CELL, close_ups, look, near, relit, turned, wide, wide_box
from torch import Tensor, nn
from torch.nn import functional

DEVICE = torch.device("cuda" if torch.cuda.is_available() else "cpu")
NEAR = 64
"""Pixels on a side of what the tracer sees."""

_CLOSE_UPS = 6  # of an image that is learnt from
_MEAN, _SPREAD = 0.45, 0.25  # of what cameras see
_LEAST, _MOST = 0.05, 40  # how likely a part has to be to be traced, and how many are at most


class UNet(nn.Module):
    """Sees what is where at several scales, and at each place what there is on the whole."""

    def __init__(self, first: nn.Module, widths: list[int]) -> None:
        super().__init__()
        self.first = first
        self.down = nn.ModuleList(
            nn.Sequential(block(a, b, stride=2), block(b, b)) for a, b in itertools.pairwise(widths)
        )
        self.whole = nn.Linear(widths[-1], widths[-1])
        self.up = nn.ModuleList(block(a + b, a) for a, b in itertools.pairwise(widths))

    def forward(self, images: Tensor) -> tuple[Tensor, Tensor]:
        """Return features of the size of the first ones, and those of the whole."""
        levels = [self.first(images)]
        for down in self.down:
            levels.append(down(levels[-1]))
        x = levels.pop()
        whole = x.mean((2, 3))
        x = x + self.whole(whole)[:, :, None, None]
        for up in reversed(self.up):
            skip = levels.pop()
            x = up(torch.cat((skip, functional.interpolate(x, skip.shape[2:])), 1))
        return x, whole


class Finder(nn.Module):
    """Says where parts are, and of what classes there can be some."""

    def __init__(self, classes: int) -> None:
        super().__init__()
        first = nn.Sequential(block(3, 16, stride=2), block(16, 24, stride=2), block(24, 24))
        self.seen = UNet(first, [24, 40, 64, 96, 128])
        self.last = nn.Sequential(block(24, 48), nn.Conv2d(48, 5 * classes + 1, 1))
        self.possible = nn.Linear(128, classes)
        nn.init.constant_(self.last[-1].bias[:classes], -4.0)  # there is nothing almost everywhere

    def forward(self, images: Tensor) -> tuple[Tensor, Tensor, Tensor, Tensor]:
        """Return scores of peaks, sides [cells], scores of the asset, and of classes that can be there."""
        seen, whole = self.seen(images)
        said, classes = self.last(seen).float(), self.possible.out_features
        sides = functional.softplus(said[:, classes:-1] + 1.0).unflatten(1, (classes, 4))
        return said[:, :classes], sides, said[:, -1], self.possible(whole).float()


class Tracer(nn.Module):
    """Says which pixels in a box and around it are of the part that the box is of."""

    def __init__(self) -> None:
        super().__init__()
        self.seen = UNet(block(4, 10), [10, 24, 40, 64])
        self.last = nn.Conv2d(10, 1, 1)

    def forward(self, images: Tensor) -> Tensor:
        """Return scores of the pixels."""
        return self.last(self.seen(images)[0])[:, 0].float()


def block(inputs: int, outputs: int, stride: int = 1) -> nn.Sequential:
    """Return a convolution with what belongs to it."""
    convolution = nn.Conv2d(inputs, outputs, 3, stride, 1, bias=False)
    return nn.Sequential(convolution, nn.BatchNorm2d(outputs), nn.ReLU(inplace=True))


class SmallNetwork:
    """The two halves, and how they learn and answer.

    Args:
        images: To learn from.
        size: Pixels on a side of what the finder sees.
        halved: Whether to reckon with numbers of 16 bits, which some processors do twice as fast.
    """

    def __init__(self, images: PartImages, size: int, *, halved: bool = False) -> None:
        self.size, self.halved = CELL * round(size / CELL), halved
        self.finder, self.tracer = Finder(len(images.classes)), Tracer()
        self.model = nn.ModuleDict({"finder": self.finder, "tracer": self.tracer}).to(
            DEVICE, memory_format=torch.channels_last
        )

    def item(self, images: PartImages, index: int, rng: np.random.Generator) -> Any:
        """Return an example, changed at random."""
        image = images.image(index)
        shown = wide(images, index, image, wide_box(images, index, rng), self.size)
        looks, masks = close_ups(images, index, image, _CLOSE_UPS, NEAR, rng)
        picture, *looks = relit([shown.image, *looks], rng)
        shown = replace(shown, image=picture)
        if rng.random() < 0.5:
            shown = shown.mirrored()
        seen = (shown.peaks, shown.sides, shown.weights, shown.asset)
        close = [turned(*each, rng) for each in zip(looks, masks, strict=True)]
        return (
            pixels([shown.image])[0],
            *(torch.from_numpy(each.astype(np.float32)) for each in seen),
            torch.from_numpy(images.possible(index).astype(np.float32)),
            pixels([each for each, _ in close])
            if close
            else torch.zeros((0, 4, NEAR, NEAR), dtype=torch.uint8),
            torch.from_numpy(np.array([mask for _, mask in close], np.float32).reshape(-1, NEAR, NEAR)),
        )

    @staticmethod
    def together(items: list[Any]) -> Any:
        """Return examples as one batch; there are more looks from near than images, or fewer."""
        *wide_ones, looks, masks = zip(*items, strict=True)
        return *(torch.stack(each) for each in wide_ones), torch.cat(looks), torch.cat(masks)

    def loss(self, batch: Any) -> Tensor:
        """Return how wrong both halves are."""
        images, peaks, sides, weights, asset, possible, looks, masks = (each.to(DEVICE) for each in batch)
        with self._quick():
            said, reach, shows, can = self.finder(normal(images))
            traced = self.tracer(normal(looks)) if len(looks) else None
        wrong = missed(said, peaks) + 2.0 * apart(reach, sides, weights)
        wrong = wrong + functional.binary_cross_entropy_with_logits(shows, asset)
        wrong = wrong + functional.binary_cross_entropy_with_logits(can, possible)
        if traced is None:
            return wrong
        return wrong + functional.binary_cross_entropy_with_logits(traced, masks) + uncovered(traced, masks)

    @torch.inference_mode()
    def results(self, images: PartImages, index: int) -> list[dict[str, Any]]:
        """Return what is found in an image: one look tells where the asset is, a second its parts."""
        image, whole = images.image(index), images.whole(index)
        with self._quick():
            box = square(whole, whole[2:], 0.0)
            *_, shows, _ = self.finder(normal(pixels([look(image, box, self.size)]).to(DEVICE)))
            box = square(around(shows[0] > 0.0, box), whole[2:], 0.1)
            said, sides, _, can = self.finder(normal(pixels([look(image, box, self.size)]).to(DEVICE)))
            found = peaks_of(said[0].sigmoid() * can[0].sigmoid()[:, None, None], sides[0], box)
            if not found:
                return []
            looks, regions = zip(*(near(image, each, NEAR) for _, _, each in found), strict=True)
            traced = self.tracer(normal(pixels(looks).to(DEVICE))).sigmoid().cpu().numpy()
        instances: list[Instance] = [
            (number, score, mask, region)
            for (number, score, _), mask, region in zip(found, traced, regions, strict=True)
        ]
        return as_results(images.images[index], instances)

    def _quick(self) -> torch.autocast:
        return torch.autocast(DEVICE.type, torch.bfloat16, enabled=self.halved)


def pixels(pictures: Any) -> Tensor:
    """Return pictures as a network takes them, shape (n, channels, height, width)."""
    return torch.from_numpy(np.stack(pictures)).permute(0, 3, 1, 2)


def normal(images: Tensor) -> Tensor:
    """Return images whose numbers are about 0, and about 1 apart."""
    return ((images / 255.0 - _MEAN) / _SPREAD).contiguous(memory_format=torch.channels_last)


def missed(scores: Tensor, peaks: Tensor) -> Tensor:
    """Return how wrong the peaks are, for each part: those that are hard to see count for the most.

    Source: X. Zhou et al., Objects as Points, 2019, equation 1.
    """
    likely, top = scores.sigmoid(), peaks > 0.99
    found = (1.0 - likely) ** 2 * functional.logsigmoid(scores)
    other = (1.0 - peaks) ** 4 * likely**2 * functional.logsigmoid(-scores)
    return -torch.where(top, found, other).sum() / top.sum().clamp(min=1)


def apart(sides: Tensor, true: Tensor, weights: Tensor) -> Tensor:
    """Return how far boxes are from overlapping (1 - intersection over union), the mean of the parts."""
    both = torch.minimum(sides, true)
    areas = [
        (each[:, :, 0] + each[:, :, 2]) * (each[:, :, 1] + each[:, :, 3]) for each in (sides, true, both)
    ]
    overlap = areas[2] / (areas[0] + areas[1] - areas[2]).clamp(min=1e-3)
    return ((1.0 - overlap) * weights).sum() / weights.sum().clamp(min=1.0)


def uncovered(scores: Tensor, masks: Tensor) -> Tensor:
    """Return how far masks are from overlapping (1 - Dice), the mean of them."""
    likely = scores.sigmoid()
    both, either = (likely * masks).sum((1, 2)), (likely + masks).sum((1, 2))
    return (1.0 - (2.0 * both + 10.0) / (either + 10.0)).mean()


def around(shows: Tensor, box: Box) -> Box:
    """Return the box of the cells that show the asset, without the few outermost; all if none does."""
    y, x = np.nonzero((shows if shows.any() else ~shows).cpu().numpy())
    low, high = np.quantile((x, y), (0.002, 0.998), axis=1)
    scale = (box[2] - box[0]) / len(shows)
    ends = (*(box[:2] + scale * low), *(box[:2] + scale * (high + 1.0)))
    return tuple(float(each) for each in ends)  # type: ignore[return-value]


def peaks_of(likely: Tensor, sides: Tensor, box: Box) -> list[tuple[int, float, Box]]:
    """Return class, score and box of what is likelier in a cell of a square than around it, best first."""
    highest = functional.max_pool2d(likely[None], 3, 1, 1)[0] == likely
    classes, rows, columns = torch.nonzero(highest & (likely > _LEAST), as_tuple=True)
    scores = likely[classes, rows, columns]
    best = scores.argsort(descending=True, stable=True)[:_MOST]
    scale = (box[2] - box[0]) / likely.shape[-1]
    found = []
    for i in best.tolist():
        kind, y, x = classes[i], rows[i], columns[i]
        left, top, right, bottom = (scale * sides[kind, :, y, x]).tolist()
        middle = box[0] + scale * (x.item() + 0.5), box[1] + scale * (y.item() + 0.5)
        sides_of = middle[0] - left, middle[1] - top, middle[0] + right, middle[1] + bottom
        found.append((kind.item() + 1, scores[i].item(), sides_of))
    return found
