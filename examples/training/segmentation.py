"""Learn to segment the parts of assets in images, and measure it on assets that were never seen.

    pip install "artgen[images,train]"
    artgen images door toaster refrigerator dishwasher lamp --assets 50 --split 0.8,0,0.2 --out images
    python examples/training/segmentation.py images --parts handle lever knob button switch

The network is torchvision's Mask R-CNN where torchvision and a GPU are at hand, else a small one that finds
parts and traces each from near. Both begin from scratch, without downloaded weights. The table at the end is
COCO's average precision of the masks, part by part.
"""

import argparse
import json
import os
import time
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import torch
from part_images import HANDLE_LIKE, PartImages, as_results, average_precisions
from small_network import DEVICE, SmallNetwork
from torch import Tensor, nn
from torch.utils.data import DataLoader, Dataset


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
        image = np.array(images.image(index))
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
        image = torch.from_numpy(np.array(images.image(index))).permute(2, 0, 1) / 255.0
        said = {key: each.cpu().numpy() for key, each in self.model([image.to(DEVICE)])[0].items()}
        found = zip(said["labels"].tolist(), said["scores"].tolist(), said["masks"][:, 0], strict=True)
        return as_results(images.images[index], [(*each, images.whole(index)) for each in found])


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
    parser.add_argument("--steps", type=int, default=1500, help="batches to learn from")
    parser.add_argument("--batch", type=int, default=8, help="images of a batch")
    parser.add_argument("--size", type=int, default=384, help="pixels on a side that the network sees")
    parser.add_argument(
        "--bfloat16",
        action="store_true",
        help="small: numbers of 16 bits, quicker where processors have them",
    )
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
    network = (
        MaskRCNN(seen, options.size)
        if kind == "mask-rcnn"
        else SmallNetwork(seen, options.size, halved=options.bfloat16)
    )
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
