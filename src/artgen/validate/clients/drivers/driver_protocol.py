"""Shared functions of drivers: reading requests, writing responses, converting numbers."""

import importlib.util
import json
import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

_MISSING = 3  # exit code


def serve(read: Callable[[dict[str, Any]], dict[str, Any]], *needs: str) -> None:
    """Answer each request on the command line."""
    if any(importlib.util.find_spec(name) is None for name in needs):
        sys.exit(_MISSING)
    paths = [Path(argument) for argument in sys.argv[1:]]
    for request, response in zip(paths[::2], paths[1::2], strict=True):
        answer = read(json.loads(request.read_text(encoding="utf-8")))
        sys.stdout.flush()
        partial = response.with_name(response.name + ".partial")
        partial.write_text(json.dumps(answer, default=_plain), encoding="utf-8")
        os.replace(partial, response)  # noqa: PTH105 - the same in all versions of Python


def missing() -> None:
    """End the process: the client is not installed."""
    sys.exit(_MISSING)


def transform(rotation: Any, position: Any) -> Any:
    """Return a frame, shape (4, 4), of a rotation, shape (3, 3), and a position, shape (3,) [m]."""
    result = np.eye(4)
    result[:3, :3] = np.asarray(rotation).reshape(3, 3)
    result[:3, 3] = position
    return result


def about_axes(moments: Any, turn: Any) -> Any:
    """Return an inertia, shape (3, 3), of its principal moments and axes, the columns of a rotation."""
    return np.asarray(turn) @ np.diag(moments) @ np.asarray(turn).T


def free(request: dict[str, Any]) -> list[dict[str, Any]]:
    """Return the joints of a request that may be driven alone."""
    return [joint for joint in request["joints"] if joint["follows"] is None and not joint["blocked"]]


def ends(joint: dict[str, Any]) -> tuple[float, float]:
    """Return the two end positions for driving a joint [rad or m]."""
    low, high = joint["limits"] or (-1.0, 1.0)
    return float(low), float(high)


def _plain(value: Any) -> Any:
    return np.asarray(value, float).tolist()
