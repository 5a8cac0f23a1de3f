"""Measure one sample, from its draw to its behavior in a simulator."""

import functools
import time
from collections.abc import Callable, Sequence
from contextlib import suppress
from typing import Any

from artgen.asset import Asset
from artgen.asset.report import CheckResult
from artgen.catalog import find
from artgen.errors import ArtgenError, InfeasibleError
from artgen.generator import Generator
from artgen.graph import Cache, Graph
from artgen.validate import guarded
from artgen.validate.colliders import check_colliders
from artgen.validate.hands import check_grasps
from artgen.validate.solids import check_solids
from artgen.validate.tree import check_tree
from artgen.version import __version__
from surveys.folder import memory_folder
from surveys.products import misfits, size_of
from surveys.speed import speed

_DIGITS = 6  # significant digits of numbers


def measure(seed: int, *, category: str, fast: bool = False) -> dict[str, Any]:
    """Generate a sample and return its measurements, as JSON data."""
    generator = find(category)
    _warm(category)
    first, seconds = _timed(lambda: generator.generate(seed, cache=Cache(), certify=False))
    certificate, proof_seconds = _timed(first.certify)
    asset = first if certificate.proven else generator.generate(seed)
    required, collided = _redraws(generator, seed, first.attempt, asset.attempt)
    record: dict[str, Any] = {
        "category": category,
        "seed": seed,
        "state": "done",
        "version": __version__,
        "seconds": _rounded(seconds),
        "proof": {"seconds": _rounded(proof_seconds), "pairs": len(certificate.pairs)},
        "redrawn": {"required": required, "collided": collided},
        "collision": "" if certificate.proven else str(certificate),
        "links": len(asset.links),
        "joints": len(asset.joints),
        "colliders": {link.name: len(link.colliders) for link in asset.links},
        "mass": _rounded(asset.mass),
        "size": [_rounded(length) for length in size_of(asset)],
        "ground": _rounded(asset.bounds()[0, 2]),
        "aside": _rounded(asset.links[0].bounds()[:, 0].mean()),
        "misfits": misfits(asset),
        "parameters": dict(asset.parameters),
        "checks": _checks(
            [
                ("solids", lambda: check_solids(asset)),
                ("tree", lambda: check_tree(asset)),
                ("colliders", lambda: check_colliders(asset)),
            ]
        ),
    }
    return record if fast else record | _in_use(asset, record["checks"])


def _in_use(asset: Asset, checks: dict[str, Any]) -> dict[str, Any]:
    """Return the measurements with hands and MuJoCo, and all checks."""
    from artgen.validate.behavior import check_behavior
    from artgen.view.opening import opened

    with memory_folder() as folder:
        directory = asset.export(folder / asset.name, formats=("mjcf",), textures=0)
        done = _checks(
            [("grasps", lambda: check_grasps(asset)), ("behavior", lambda: check_behavior(asset, directory))]
        )
        path = next(directory.glob("*.xml"))
        speeds = {
            name: _rounded(speed(asset, path, opened(asset, share)))
            for name, share in (("closed", 0.0), ("half open", 0.5))
        }
    return {"checks": checks | done, "speed": speeds, "forces": _forces(asset)}


def _checks(chosen: Sequence[tuple[str, Callable[[], CheckResult]]]) -> dict[str, Any]:
    found = {}
    for name, run in chosen:
        result, seconds = _timed(functools.partial(guarded, name, run))
        found[name] = {
            "faults": [str(fault) for fault in result.faults],
            "notes": [str(each) for each in result.findings if each.severity == "note"],
            "skipped": result.skipped,
            "seconds": _rounded(seconds),
        }
    return found


def _forces(asset: Asset) -> dict[str, float]:
    """Return the force with which a hand moves each joint [N]."""
    from artgen.validate.hands.motion import hand_forces

    return {name: _rounded(force) for name, force in hand_forces(asset).items()}


def _redraws(generator: Generator, seed: int, first: int, last: int) -> tuple[int, int]:
    """Return the numbers of draws that a requirement and a collision ruled out."""
    required, collided = first, 0
    for attempt in range(first, last):
        values = generator.sample(seed, attempt=attempt)
        try:
            Graph(generator.build(values)).evaluate(values, Cache())
        except InfeasibleError:
            required += 1
        else:
            collided += 1
    return required, collided


@functools.cache
def _warm(category: str) -> None:
    """Import modules and fill caches, so that the first sample of a process is not slower."""
    with suppress(ArtgenError):
        find(category).generate(0, cache=Cache()).bounds()


def _timed(run: Callable[[], Any]) -> tuple[Any, float]:
    """Return a result and its processor time [s]."""
    start = time.process_time()
    result = run()
    return result, time.process_time() - start


def _rounded(number: float) -> float:
    return float(f"{number:.{_DIGITS}g}") + 0.0
