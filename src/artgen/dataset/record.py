"""The line of an asset in the manifest."""

import hashlib
import json
from typing import Any

_WORD = 16  # characters of a digest


def record_of(text: bytes, path: str) -> dict[str, Any]:
    """Return the line of an asset, from its `asset.json` alone."""
    data = json.loads(text)
    certificate = data["certificate"]
    return {
        "name": data["name"],
        "category": data["category"],
        "seed": data["seed"],
        "state": "done",
        "path": path,
        "files": {name: each["main"] for name, each in data["formats"].items()},
        "attempt": data["attempt"],
        "proven": None if certificate is None else certificate["proven"],
        "mass": data["mass"],
        "links": len(data["links"]),
        "joints": {joint["name"]: joint["kind"] for joint in data["joints"]},
        "parameters": data["parameters"],
        "digest": hashlib.sha256(text).hexdigest()[:_WORD],
    }


def failure(name: str, category: str, seed: int, error: str) -> dict[str, Any]:
    """Return the line of an asset that cannot be made."""
    return {"name": name, "category": category, "seed": seed, "state": "failed", "error": error}
