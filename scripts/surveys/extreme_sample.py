"""Measure one sample at the ends of ranges: make, prove, export, check and simulate it."""

import time
from collections.abc import Iterator, Mapping
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from artgen.asset import Asset
from artgen.asset.files import main_files
from artgen.catalog import find
from artgen.errors import InfeasibleError
from artgen.validate import guarded
from artgen.validate.colliders import check_colliders
from artgen.validate.solids import check_solids
from artgen.validate.tree import check_tree
from artgen.version import __version__
from surveys.extremes import Extreme, draw_extreme
from surveys.folder import memory_folder
from surveys.products import size_of
from surveys.rest import Oddity, oddities

FORMATS = ("urdf", "mjcf", "usd", "glb")

SIZES = (0.005, 4.0)
"""Allowed range of the longest side of an asset [m]."""

MASSES = (0.01, 600.0)
"""Allowed range of the mass of an asset [kg]."""

_CHECKS = (("solids", check_solids), ("tree", check_tree), ("colliders", check_colliders))


def measure_extreme(number: int, *, run: int, folder: Path | None = None) -> dict[str, Any]:
    """Make a sample and return its anomalies, as JSON data.

    Its state is `sound`, `odd` with anomalies, or `ruled out` by a requirement of its category.
    """
    start = time.perf_counter()
    extreme = draw_extreme(run, number)
    record: dict[str, Any] = {
        "run": run,
        "sample": number,
        "category": extreme.category,
        "state": "sound",
        "message": "",
        "anomalies": [],
        "seed": extreme.seed,
        "overrides": dict(extreme.overrides),
        "version": __version__,
    }
    try:
        asset, _ = find(extreme.category).evaluate(
            extreme.seed, attempts=1, on_collision="keep", overrides=extreme.overrides
        )
    except InfeasibleError as error:
        record |= {"state": "ruled out", "message": " ".join(str(error).split())}
    except Exception as error:  # noqa: BLE001 - any exception is an anomaly
        record |= {"state": "odd", "anomalies": [_anomaly("error", _told(error))]}
    else:
        anomalies = [_anomaly(*each) for each in _wrong(asset, folder)]
        record |= {"state": "odd" if anomalies else "sound", "anomalies": anomalies}
    return record | {"seconds": round(time.perf_counter() - start, 2)}


def of_record(record: Mapping[str, Any]) -> Extreme:
    """Return the sample of a record."""
    return Extreme(record["run"], record["sample"], record["category"], record["seed"], record["overrides"])


def _wrong(asset: Asset, folder: Path | None) -> Iterator[Oddity]:
    """Yield the anomalies of an asset."""
    assert asset.certificate is not None
    if not asset.certificate.proven:
        yield "not proven", "; ".join(map(str, asset.certificate.failures))
    yield from _implausible(asset)
    for name, check in _CHECKS:
        for fault in guarded(name, partial(check, asset)).faults:
            yield name, str(fault)
    if not asset.certificate.proven:
        return  # overlapping parts are thrown apart, and hide all else
    with memory_folder(folder) as place:
        try:
            files = main_files(asset.export(place / asset.name, formats=FORMATS, textures=0))
        except Exception as error:  # noqa: BLE001 - any exception is an anomaly
            yield "export", _told(error)
            return
        try:
            yield from oddities(asset, files["mjcf"], files["urdf"])
        except Exception as error:  # noqa: BLE001 - any exception is an anomaly
            yield "simulation", _told(error)


def _implausible(asset: Asset) -> Iterator[Oddity]:
    longest = float(np.max(size_of(asset)))
    for name, value, unit, (least, most) in (
        ("its longest side", longest, "m", SIZES),
        ("its mass", asset.mass, "kg", MASSES),
    ):
        if not least <= value <= most:
            yield "implausible", f"{name} is {value:.4g} {unit}: {least:g} to {most:g} {unit} are plausible"


def _anomaly(kind: str, message: str) -> dict[str, str]:
    return {"kind": kind, "message": message}


def _told(error: Exception) -> str:
    return f"{type(error).__name__}: {error}"
