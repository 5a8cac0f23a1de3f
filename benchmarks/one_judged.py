"""Judge a file by the sampled protocol and by the referee; print a line of JSON for each.

It is started by field.py: `one_judged.py FILE ROOT SECONDS referee` or `... sampled referee`.
"""

import json
import os
import sys
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

from sampled import NotLoadableError, deepest_at, sampled

from artgen.errors import ArtgenError
from artgen.referee import certify

_READ = (".urdf", ".xml", ".mjcf")  # by MuJoCo
_PAIRS = 5  # most failing pairs of a record
_TOTAL = 6.0  # time limit of the referee for a file, in limits for a pair
_LEAST_SECONDS = 20.0  # for the sampled protocol [s]


def by_states(path: Path, root: Path, seconds: float) -> dict[str, Any]:
    """Return what the sampled protocol finds."""
    if path.suffix not in _READ:
        return {"loadable": None, "reason": "the sampled protocol reads no USD"}
    try:
        found = sampled(path, root, seconds=max(_LEAST_SECONDS, 4.0 * seconds))
    except NotLoadableError as error:
        return {"loadable": False, "reason": str(error)}
    return {"loadable": True, **asdict(found)}


def by_the_referee(path: Path, root: Path, seconds: float) -> dict[str, Any]:
    """Return the verdict of the referee, or its error."""
    before = _processor_seconds()
    try:
        judgment = certify(path, root=root, seconds=seconds, total=_TOTAL * seconds, first=True)
    except ArtgenError as error:
        return {"error": str(error)}
    except Exception as error:  # noqa: BLE001 - a fault of the referee is a result
        return {"error": f"{type(error).__name__}: {error}", "crashed": True}
    return {
        "verdict": judgment.verdict,
        "verdict_with_excluded": judgment.verdict_with_excluded,
        "links": judgment.links,
        "joints": judgment.joints,
        "colliders": judgment.colliders,
        "pairs": len(judgment.pairs),
        "notes": list(judgment.notes),
        "seconds": judgment.seconds,
        "processor_seconds": round(_processor_seconds() - before, 3),
        "rechecked": judgment.rechecked,
        "failures": [str(pair) for pair in judgment.failures[:_PAIRS]],
        "witnesses": [
            found
            for pair in judgment.failures[:_PAIRS]
            if pair.result.witness is not None and (found := _confirmed(path, root, pair.result.witness.pose))
        ],
    }


def _processor_seconds() -> float:
    """Return the time of the processor for this process and those that it started [s]."""
    spent = os.times()
    return spent.user + spent.system + spent.children_user + spent.children_system


def _confirmed(path: Path, root: Path, pose: Mapping[str, float]) -> dict[str, Any]:
    """Return the deepest overlap that MuJoCo finds where the referee does; empty if it reads no such file."""
    try:
        return asdict(deepest_at(path, root, pose)) if path.suffix in _READ else {}
    except NotLoadableError:
        return {}


def main() -> None:
    """Judge the file."""
    path, root, seconds = Path(sys.argv[1]), Path(sys.argv[2]), float(sys.argv[3])
    judges = {"sampled": by_states, "referee": by_the_referee}
    for name in sys.argv[4:]:
        judge = judges[name]
        sys.stdout.write(json.dumps({name: judge(path, root, seconds)}) + "\n")
        sys.stdout.flush()


if __name__ == "__main__":
    main()
