"""The files of COCO: what is known of all pictures of a part of a set, with numbers that are unique in it."""

import json
from collections.abc import Collection
from typing import Any

from artgen.dataset.target import Target
from artgen.images.make import ANNOTATION_FILE
from artgen.images.plan import ImagePlan
from artgen.images.split import PARTS, split_of
from artgen.version import __version__

_TOGETHER = 64  # assets that are read at once


def write_coco(target: Target, records: Collection[dict[str, Any]], plan: ImagePlan) -> None:
    """Write `train.json`, `val.json` and `test.json`.

    Pictures and masks have the same numbers in a longer plan of the same kind.
    """
    part_of_seed = split_of(plan.seed, -(-plan.count // len(plan.categories)), plan.split)
    images: dict[str, list[dict[str, Any]]] = {part: [] for part in PARTS}
    masks: dict[str, list[dict[str, Any]]] = {part: [] for part in PARTS}
    done = [(number, record) for number, record in enumerate(records) if record["state"] == "done"]
    told = 0
    for start in range(0, len(done), _TOGETHER):
        some = done[start : start + _TOGETHER]
        texts = target.contents(f"{record['path']}/{ANNOTATION_FILE}" for _, record in some)
        for number, record in some:
            part = part_of_seed[record["seed"]]
            data = json.loads(texts[f"{record['path']}/{ANNOTATION_FILE}"])
            for index, image in enumerate(data["images"]):
                of_image = image.pop("annotations")
                image_id = number * plan.images + index + 1
                images[part].append({"id": image_id, **image})
                for mask in of_image:
                    told += 1
                    masks[part].append({"id": told, "image_id": image_id, **mask})
    for part in PARTS:
        data = {
            "info": {
                "description": f"{part} images of {', '.join(plan.categories)}",
                "version": f"artgen {__version__}",
                "plan": plan.to_data(),
            },
            "licenses": [],
            "categories": plan.vocabulary().categories(),
            "images": images[part],
            "annotations": masks[part],
        }
        target.write(f"{part}.json", json.dumps(data, allow_nan=False, ensure_ascii=False).encode())
