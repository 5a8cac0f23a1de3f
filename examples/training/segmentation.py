"""Learn to segment the parts of assets in images, and measure it on assets that were never seen.

    pip install "artgen[images,train]"
    artgen images door toaster refrigerator dishwasher lamp --assets 50 --size 512 --out images
    python examples/training/segmentation.py images --steps 800

The network is torchvision's Mask R-CNN where torchvision and a GPU are at hand, else a small U-Net that says
of each pixel of which part it is and where the centre of its instance lies. Both begin from scratch, without
downloaded weights. The table at the end is COCO's average precision of the masks, part by part.
"""

import argparse
import itertools
import json
import os
import time
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import torch
from part_images import (
    HANDLE_LIKE,
    TILE,
    Array,
    Box,
    PartImages,
    as_results,
    average_precisions,
    changed,
    instances,
    square,
    within,
)
from torch import Tensor, nn
from torch.nn import functional
from torch.utils.data import DataLoader, Dataset

DEVICE = torch.device("cuda" if torch.cuda.is_available() else "cpu")
MEAN, SPREAD = 0.45, 0.25  # of what cameras see
FEW = 20.0  # pixels of a class in a batch, below which it hardly matters whether they are found


class UNet(nn.Module):
    """Says of each pixel of which class it is and where the centre of its instance lies.

    Besides the square that it looks at, it sees all that this is part of at a glance: a small image that
    tells of what category the asset is, and where there what it looks at is.
    """

    def __init__(self, classes: int, width: int) -> None:
        super().__init__()
        widths = [width, 2 * width, 3 * width, 4 * width, 6 * width, 8 * width]
        self.first = block(3, width, stride=2)
        self.down = nn.ModuleList(
            nn.Sequential(block(a, b, stride=2), block(b, b)) for a, b in itertools.pairwise(widths)
        )
        self.up = nn.ModuleList(block(a + b, a) for a, b in itertools.pairwise(widths))
        glance = (block(a, b, stride=2) for a, b in itertools.pairwise([3, *widths[::2]]))
        self.glance = nn.Sequential(*glance)
        self.around = nn.Conv2d(widths[4], widths[3], 1)
        self.context = nn.Linear(widths[4], widths[-1])
        self.overall = nn.Linear(widths[4], classes)
        self.last = nn.Conv2d(width, classes + 2, 1)

    def forward(self, images: Tensor, glances: Tensor, places: Tensor) -> tuple[Tensor, Tensor]:
        """Return the scores of the classes and the ways to the centres, at half the size of the images.

        Args:
            images: What is looked at, shape (n, 3, size, size).
            glances: What that is part of, shape (n, 3, size / 2, size / 2).
            places: Left, top, right and bottom of the first in the second, shape (n, 4), 0-1.
        """
        levels = [self.first(normal(images))]
        for down in self.down:
            levels.append(down(levels[-1]))
        around = self.glance(normal(glances))
        glance = around.mean((2, 3))
        x = levels.pop() + self.context(glance)[:, :, None, None]
        for number, up in reversed([*enumerate(self.up)]):
            skip = levels.pop()
            x = up(torch.cat((skip, functional.interpolate(x, skip.shape[2:])), 1))
            if number == 3:  # fine enough to tell parts, and coarse enough for what was seen at a glance
                x = x + self.around(part_of_glance(around, places, x.shape[2]))
        said = self.last(x)
        return said[:, :-2] + self.overall(glance)[:, :, None, None], said[:, -2:]


def part_of_glance(around: Tensor, places: Tensor, size: int) -> Tensor:
    """Return what was seen at a glance where an image looks closer, shape (n, channels, size, size)."""
    share = (torch.arange(size, device=places.device) + 0.5) / size
    low, high = places[:, :2], places[:, 2:]
    x, y = (low + share[:, None, None] * (high - low)).permute(2, 1, 0) * 2.0 - 1.0
    grid = torch.stack((x[:, None, :].expand(-1, size, -1), y[:, :, None].expand(-1, -1, size)), -1)
    return functional.grid_sample(around, grid, align_corners=False, padding_mode="border")


def normal(images: Tensor) -> Tensor:
    """Return images whose numbers are about 0, and about 1 apart."""
    return (images / 255.0 - MEAN) / SPREAD


def block(inputs: int, outputs: int, stride: int = 1) -> nn.Sequential:
    """Return a convolution with what belongs to it."""
    convolution = nn.Conv2d(inputs, outputs, 3, stride, 1, bias=False)
    return nn.Sequential(convolution, nn.BatchNorm2d(outputs), nn.ReLU(inplace=True))


def overlap(scores: Tensor, classes: Tensor) -> Tensor:
    """Return how far regions are from overlapping (1 - Dice), the mean over the classes of a batch.

    Each class counts the same, be it of many pixels or of few.
    """
    likely = scores.softmax(1)
    true = functional.one_hot(classes, scores.shape[1]).permute(0, 3, 1, 2).to(likely)
    both, either = (likely * true).sum((0, 2, 3)), (likely + true).sum((0, 2, 3))
    there = true.sum((0, 2, 3)) > 0
    return (1.0 - (2.0 * both + FEW) / (either + FEW))[there].mean()


class SmallNetwork:
    """The U-Net, and how it learns and answers."""

    def __init__(self, images: PartImages, size: int, width: int = 16) -> None:
        self.size = size
        self.model = UNet(2 + len(images.classes), width).to(DEVICE, memory_format=torch.channels_last)
        rare = images.frequencies().clip(1e-6) ** -0.25  # small parts count for more than their pixels
        self.weights = torch.tensor(rare / rare[0], dtype=torch.float32, device=DEVICE).clamp(max=5.0)

    def item(self, images: PartImages, index: int, rng: np.random.Generator) -> Any:
        """Return an example, changed at random."""
        box, around = images.view(index, rng)
        (glance,) = images.looks(index, self.size // 2, [around])
        image, *said = images.example(index, self.size, box)
        place = within(box, around)
        pictures, classes, offsets, place = changed((image, glance), *said, place, rng=rng)
        tensors = (torch.from_numpy(each).permute(2, 0, 1) for each in pictures)
        return *tensors, torch.from_numpy(place), torch.from_numpy(classes), torch.from_numpy(offsets)

    @staticmethod
    def together(items: list[Any]) -> Any:
        """Return examples as one batch."""
        return tuple(torch.stack(each) for each in zip(*items, strict=True))

    def loss(self, batch: Any) -> Tensor:
        """Return how wrong the network is: about the class of each pixel, and the centres."""
        images, glances, places, classes, offsets = (each.to(DEVICE) for each in batch)
        scores, ways = self.model(self._seen(images), self._seen(glances), places)
        classes, offsets = classes[:, ::2, ::2].long(), offsets[:, :, ::2, ::2]
        wrong = functional.cross_entropy(scores, classes, self.weights) + overlap(scores, classes)
        known = ~offsets.isnan()
        far = (ways[known] - offsets[known]).abs().sum() / known.sum().clamp(min=1)  # none may be known
        return wrong + 0.5 * far  # more of the centres, and the classes are learnt late

    @torch.inference_mode()
    def results(self, images: PartImages, index: int) -> list[dict[str, Any]]:
        """Return what is found in an image: one look tells where the asset is, closer ones its parts."""
        whole = images.whole(index)
        width, height = whole[2:]
        something = self._look(images, index, [whole], whole)[0][0, 0] < 0.5
        y, x = np.nonzero(something if something.any() else ~something)
        (left, right), (top, bottom) = (np.quantile(each, (0.002, 0.998)) / self.size for each in (x, y))
        box = square((left * width, top * height, right * width, bottom * height), (width, height), 0.12)
        return as_results(images.images[index], instances(*self._tiled(images, index, box)), box)

    def _tiled(self, images: PartImages, index: int, box: Box) -> tuple[Array, Array]:
        """Return the probabilities and the ways in a box, looked at in squares that overlap by half."""
        pixels = round(self.size / TILE)
        steps = (
            np.linspace(0, pixels - self.size, 1 + int(np.ceil(2.0 * (1.0 / TILE - 1.0)))).round().astype(int)
        )
        scale = (box[2] - box[0]) / pixels
        corners = [(box[0] + scale * x, box[1] + scale * y) for y in steps for x in steps]
        side = scale * self.size
        looks = self._look(images, index, [(x, y, x + side, y + side) for x, y in corners], around=box)
        hat = 1.0 - np.abs(2.0 * (np.arange(self.size) + 0.5) / self.size - 1.0)
        weight = np.outer(hat, hat) + 1e-3  # the middle of a look knows best
        total, weights = np.zeros((looks[0].shape[1] + 2, pixels, pixels)), np.zeros((pixels, pixels))
        for (y, x), scores, ways in zip(itertools.product(steps, steps), *looks, strict=True):
            part = slice(y, y + self.size), slice(x, x + self.size)
            total[:, *part] += weight * np.concatenate((scores, ways * self.size / pixels))
            weights[part] += weight
        total /= weights
        return total[:-2], total[-2:]

    def _look(self, images: PartImages, index: int, boxes: list[Box], around: Box) -> tuple[Array, Array]:
        """Return the probabilities of the classes and the ways to the centres in some boxes."""
        pictures = images.looks(index, self.size, boxes)
        glance = images.looks(index, self.size // 2, [around])
        looks, glances = (
            self._seen(torch.from_numpy(each).permute(0, 3, 1, 2).to(DEVICE))
            for each in (pictures, glance.repeat(len(boxes), 0))
        )
        places = torch.from_numpy(np.stack([within(box, around) for box in boxes])).to(DEVICE)
        said = self.model(looks, glances, places)
        scores, ways = (functional.interpolate(each, scale_factor=2, mode="bilinear") for each in said)
        return scores.softmax(1).cpu().numpy(), ways.cpu().numpy()

    @staticmethod
    def _seen(images: Tensor) -> Tensor:
        return images.float().contiguous(memory_format=torch.channels_last)


class MaskRCNN:
    """Torchvision's Mask R-CNN, and how it learns and answers."""

    def __init__(self, images: PartImages, size: int) -> None:
        from torchvision.models.detection import maskrcnn_resnet50_fpn

        self.size = size
        self.model = maskrcnn_resnet50_fpn(
            weights=None,
            weights_backbone=None,
            num_classes=1 + len(images.classes),
            min_size=size,
            max_size=size,
        ).to(DEVICE)

    def item(self, images: PartImages, index: int, rng: np.random.Generator) -> Any:
        """Return an example, mirrored at random, with a box and a mask for each part."""
        image = images.picture(index)
        found = images.masks(index)
        masks = np.array([mask for _, mask in found], np.uint8).reshape(-1, *image.shape[:2])
        if rng.random() < 0.5:
            image, masks = image[:, ::-1], masks[:, :, ::-1]
        boxes = [(x.min(), y.min(), x.max() + 1, y.max() + 1) for y, x in map(np.nonzero, masks)]
        target = {
            "boxes": torch.tensor(np.array(boxes, np.float32).reshape(-1, 4)),
            "labels": torch.tensor([number for number, _ in found], dtype=torch.int64),
            "masks": torch.from_numpy(masks.copy()),
        }
        return torch.from_numpy(image.copy()).permute(2, 0, 1) / 255.0, target

    @staticmethod
    def together(items: list[Any]) -> Any:
        """Return examples as one batch."""
        return items

    def loss(self, batch: Any) -> Tensor:
        """Return the sum of the five losses of Mask R-CNN."""
        images = [image.to(DEVICE) for image, _ in batch]
        losses = self.model(
            images, [{key: each.to(DEVICE) for key, each in said.items()} for _, said in batch]
        )
        return torch.stack(list(losses.values())).sum()

    @torch.inference_mode()
    def results(self, images: PartImages, index: int) -> list[dict[str, Any]]:
        """Return what is found in an image."""
        image = torch.from_numpy(images.picture(index)).permute(2, 0, 1) / 255.0
        said = {key: each.cpu().numpy() for key, each in self.model([image.to(DEVICE)])[0].items()}
        masks = said["masks"][:, 0] > 0.5
        found = zip(said["labels"].tolist(), said["scores"].tolist(), masks, strict=True)
        return as_results(images.images[index], list(found))


class Shuffled(Dataset[Any]):
    """Images drawn at random, and changed; what is drawn depends on the seed and the place alone."""

    def __init__(self, network: Any, images: PartImages, length: int, seed: int) -> None:
        self.network, self.images, self.length, self.seed = network, images, length, seed
        self.order = np.random.default_rng(seed).choice(len(images), length, p=images.shares())

    def __len__(self) -> int:
        return self.length

    def __getitem__(self, place: int) -> Any:
        rng = np.random.default_rng((self.seed, place))
        return self.network.item(self.images, int(self.order[place]), rng)


def train(network: Any, images: PartImages, steps: int, batch: int, rate: float, seed: int) -> None:
    """Learn from the images."""
    shuffled = Shuffled(network, images, steps * batch, seed)
    workers = min(8, (os.cpu_count() or 1) // 2)
    loader = DataLoader(
        shuffled,
        batch,
        collate_fn=network.together,
        num_workers=workers,
        multiprocessing_context="spawn" if workers else None,
    )
    optimizer = torch.optim.AdamW(network.model.parameters(), rate, weight_decay=1e-4)
    schedule = torch.optim.lr_scheduler.OneCycleLR(optimizer, rate, total_steps=steps, pct_start=0.1)
    network.model.train()
    start, lately = time.monotonic(), 0.0
    for step, each in enumerate(loader, 1):
        loss = network.loss(each)
        optimizer.zero_grad()
        loss.backward()
        nn.utils.clip_grad_norm_(network.model.parameters(), 5.0)
        optimizer.step()
        schedule.step()
        lately += loss.item()
        if step % max(1, steps // 10) == 0:
            shown = lately / max(1, steps // 10)
            print(f"step {step}/{steps}, {time.monotonic() - start:.0f} s: loss {shown:.3f}", flush=True)
            lately = 0.0
    network.model.eval()


def evaluate(network: Any, images: PartImages) -> dict[str, tuple[float, float]]:
    """Return AP and AP50 of each part."""
    network.model.eval()
    results = [each for index in range(len(images)) for each in network.results(images, index)]
    return average_precisions(images.truth, results)


def table(precisions: dict[str, tuple[float, float]]) -> list[str]:
    """Return the lines of a table: the parts, the mean of those like handles, and that of all."""
    rows = dict(precisions)
    like = [each for name, each in precisions.items() if name.partition("/")[2] in HANDLE_LIKE]
    if like:
        rows["handle-like"] = tuple(np.mean(like, 0))
    rows["all"] = tuple(np.mean(list(precisions.values()), 0))
    return ["part                      AP   AP50"] + [
        f"{name:<22} {ap:5.3f}  {ap50:5.3f}" for name, (ap, ap50) in rows.items()
    ]


def arguments() -> argparse.Namespace:
    """Read the command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("images", type=Path, help="folder that `artgen images` wrote")
    parser.add_argument("--network", choices=("auto", "small", "mask-rcnn"), default="auto")
    parser.add_argument("--parts", nargs="*", default=(), help="such as door/handle or knob; all by default")
    parser.add_argument("--split", default="test", help="the assets that it is tried on")
    parser.add_argument("--steps", type=int, default=600, help="batches to learn from")
    parser.add_argument("--batch", type=int, default=8, help="images of a batch")
    parser.add_argument("--size", type=int, default=256, help="pixels on a side that the network sees")
    parser.add_argument("--rate", type=float, default=2e-3, help="highest learning rate")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument(
        "--out", type=Path, default=Path("segmentation"), help="folder for weights and results"
    )
    return parser.parse_args()


def main() -> None:
    """Train, measure and save."""
    options = arguments()
    torch.manual_seed(options.seed)
    torch.use_deterministic_algorithms(mode=True, warn_only=True)  # some have no such algorithm on a GPU
    seen = PartImages(options.images, "train", options.parts)
    unseen = PartImages(options.images, options.split, options.parts)
    if seen.classes != unseen.classes:
        raise SystemExit("error: the splits have different parts; they are not of one run of `artgen images`")
    kind = options.network
    if kind == "auto":
        kind = "mask-rcnn" if find_spec("torchvision") and DEVICE.type == "cuda" else "small"
    network = (MaskRCNN if kind == "mask-rcnn" else SmallNetwork)(seen, options.size)
    count = sum(each.numel() for each in network.model.parameters())
    print(
        f"{kind}, {count / 1e6:.1f} million weights, on {DEVICE}: {len(seen)} images, {len(unseen)} to test"
    )
    start = time.monotonic()
    train(network, seen, options.steps, options.batch, options.rate, options.seed)
    trained = time.monotonic()
    precisions = evaluate(network, unseen)
    print(f"learnt in {trained - start:.0f} s, tested in {time.monotonic() - trained:.0f} s")
    print(*table(precisions), sep="\n")
    options.out.mkdir(parents=True, exist_ok=True)
    torch.save({"classes": seen.classes, "weights": network.model.state_dict()}, options.out / "network.pt")
    (options.out / "precision.json").write_text(json.dumps(precisions, indent=2) + "\n")


if __name__ == "__main__":
    main()
