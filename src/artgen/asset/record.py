"""The text of an asset's JSON: numbers that are the same on every machine, on lines that can be read."""

import json
from typing import Any

import numpy as np

DECIMALS = 12
"""Of coordinates of colliders [m]; numbers of other kinds have as many significant digits."""

_EXPANDED = 3  # levels that are always spread over lines; the next one where it holds more than numbers

_ENCODER = json.JSONEncoder(ensure_ascii=False, allow_nan=False)


def rounded(data: Any) -> Any:
    """Round every number in JSON data to 12 significant digits.

    The digits beyond differ between machines, whose libraries round differently.
    """
    if isinstance(data, float):
        return significant(data, 12)
    if isinstance(data, dict):
        return {key: rounded(value) for key, value in data.items()}
    return [rounded(item) for item in data] if isinstance(data, list | tuple) else data


def significant(number: float, digits: int) -> float:
    """Round a number to some significant digits; no zero is negative."""
    return float(f"{number:.{digits}g}") + 0.0


def rounded_link(data: dict[str, Any]) -> dict[str, Any]:
    """Round the numbers of a link: thousands of coordinates of its colliders, and few others."""
    colliders = [
        {
            key: _coordinates(value) if key in ("pose", "points") else rounded(value)
            for key, value in item.items()
        }
        for item in data["colliders"]
    ]
    details = [{**item, "bounds": _coordinates(item["bounds"])} for item in data.get("details", ())]
    exact = {"colliders": colliders, "details": details}
    return {key: exact[key] if key in exact else rounded(value) for key, value in data.items()}


def _coordinates(rows: Any) -> Any:
    """Round rows of coordinates to a millionth of a micrometre."""
    return (np.round(np.array(rows, float), DECIMALS) + 0.0).tolist()


def json_text(data: Any) -> str:
    """Return JSON text with a line for each thing that a reader looks for, such as a field or a collider."""
    return _spread(data, 0) + "\n"


def _spread(data: Any, level: int) -> str:
    """Return data as JSON text, its outer levels spread over lines."""
    if not isinstance(data, dict | list) or not data or level > _EXPANDED:
        return _ENCODER.encode(data)
    values = data.values() if isinstance(data, dict) else data
    if level == _EXPANDED and not any(isinstance(value, dict | list) for value in values):
        return _ENCODER.encode(data)
    indent = "\n" + " " * (level + 1)
    texts = [_spread(value, level + 1) for value in values]
    if isinstance(data, dict):
        texts = [f"{_ENCODER.encode(key)}: {text}" for key, text in zip(data, texts, strict=True)]
        opening, closing = "{}"
    else:
        opening, closing = "[]"
    return opening + indent + f",{indent}".join(texts) + indent[:-1] + closing
