"""Flat doors in pictures, as `artgen images` writes them: boxes of plain colors."""

import json

import numpy as np
from PIL import Image, ImageDraw
from pycocotools import mask as rle

SIZE = 96
LABELS = ("frame", "door", "glass", "handle", "latch")
COLOURS = {
    "frame": (120, 90, 60),
    "door": (200, 190, 170),
    "glass": (120, 190, 220),
    "handle": (40, 40, 45),
    "latch": (250, 220, 90),
}
LINKS = {"frame": "base", "door": "leaf", "glass": "leaf", "handle": "lever", "latch": "bolt"}


def boxes(rng):
    """A leaf with a pane and a handle in a frame, as boxes that cover each other in this order."""
    x, y = rng.integers(10, 30, 2)
    width, height = rng.integers(40, 52, 2)
    return {
        "frame": (x - 7, y - 7, x + width + 7, y + height + 7),
        "door": (x, y, x + width, y + height),
        "glass": (x + 10, y + 6, x + width - 10, y + 16),
        "handle": (x + 4, y + 22, x + 20, y + 34),
        "latch": (x, y + 26, x + 2, y + 30),
    }


def drawn(folder, split, count, seed):
    """Write a split of flat doors as `artgen images` does."""
    rng = np.random.default_rng(seed)
    images, annotations = [], []
    for number in range(count):
        picture = Image.new("RGB", (SIZE, SIZE), tuple(map(int, rng.integers(60, 110, 3))))
        labels = np.zeros((SIZE, SIZE), int)
        for index, (name, box) in enumerate(boxes(rng).items(), 1):
            ImageDraw.Draw(picture).rectangle(box, COLOURS[name])
            labels[box[1] : box[3] + 1, box[0] : box[2] + 1] = index
        file = f"{split}_{number}.png"
        picture.save(folder / file)
        images.append(
            {"id": number + 1, "asset": f"door_{number}", "width": SIZE, "height": SIZE, "file_name": file}
        )
        for index, name in enumerate(LABELS, 1):
            code = rle.encode(np.asfortranarray(labels == index, np.uint8))
            annotations.append(
                {
                    "id": len(annotations) + 1,
                    "image_id": number + 1,
                    "category_id": index,
                    "segmentation": {**code, "counts": code["counts"].decode()},
                    "area": int((labels == index).sum()),
                    "bbox": rle.toBbox(code).tolist(),
                    "iscrowd": 0,
                    "link": LINKS[name],
                }
            )
    categories = [{"id": i, "name": name, "supercategory": "door"} for i, name in enumerate(LABELS, 1)]
    (folder / f"{split}.json").write_text(
        json.dumps({"images": images, "annotations": annotations, "categories": categories})
    )
