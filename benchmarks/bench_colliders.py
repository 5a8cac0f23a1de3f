"""Compare colliders from the construction of solids with CoACD: time, pieces, open hollows, steps."""

import statistics
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from manifold3d import Manifold, OpType
from report import Section, Table, span
from surveys.speed import STEP, speed
from timing import empty_cache, seconds, timed

import artgen
from artgen.asset import Asset, Link
from artgen.asset.collision import link_parts, with_colliders

KINDS = ("exact", "coacd")

_COMPARED = """
The same assets with artgen's own colliders, known from how the solids were made (`exact`), and with CoACD's
(`collision="coacd"`: CoACD's decomposition of every solid that is not convex, at its threshold of 0.05,
with an empty cache). Evaluation keeps the pieces of the solids in step as it goes, so *exact* is given
twice: what naming and counting the colliders of the links takes, and everything from the seed to the asset,
which is more than its share; the ratio is to the latter. The time of CoACD is without starting its
processes. The *hollow* of a link is what its convex hull has beyond its solids: of it, the share is given
that colliders leave open; and of the solids, the share that colliders cover. Volumes are of exact booleans,
summed over the links. MuJoCo simulates both exports from the closed pose. Assets for
which CoACD takes many minutes (a microwave, a toaster) are left out, which flatters it.
"""


@dataclass(frozen=True)
class Made:
    """An asset with colliders of one kind.

    Attributes:
        seconds: Processor time to make them [s].
        pieces: Number of pieces.
        open: Share of the hollows that they leave open.
        covered: Share of the solids that they cover.
        steps: Steps of MuJoCo per second.
    """

    seconds: float
    pieces: int
    open: float
    covered: float
    steps: float


Found = Mapping[str, Mapping[str, Made]]


def measure(*, quick: bool) -> Section:
    """Run the benchmark."""
    names = ["plier"] if quick else ["drawer", "handle", "lamp", "plier", "trashcan"]
    start = statistics.median(seconds(_start) for _ in range(1 if quick else 5))
    whole, found = {}, {}
    for name in names:
        _generated(name)  # imports and first calls are no part of the figures
        whole[name] = statistics.median(seconds(partial(_generated, name)) for _ in range(1 if quick else 3))
        asset = artgen.catalog.find(name).generate(0, cache=artgen.graph.Cache(), certify=False)
        found[name] = {kind: _made(asset, kind, start) for kind in KINDS}
    return Section(
        "colliders by construction against CoACD",
        _COMPARED,
        [_time_table(whole, found), _volume_table(found)],
        _findings(whole, found),
    )


def _start() -> None:
    """Start a process, as CoACD needs one."""
    subprocess.run([sys.executable, "-P", "-c", "import io, json, sys, coacd, numpy"], check=True)


def _generated(name: str) -> None:
    """Make an asset with its colliders."""
    _complete(artgen.catalog.find(name).generate(0, cache=artgen.graph.Cache(), certify=False))


def _complete(asset: Asset) -> None:
    for link in asset.links:
        _ = link.colliders


def _made(asset: Asset, kind: str, start: float) -> Made:
    """Measure one kind of colliders.

    Args:
        asset: The asset; its own colliders are not made yet.
        kind: Of `KINDS`, `exact` before the others.
        start: What starting a process of CoACD takes [s].
    """
    times: dict[str, float] = {}
    with empty_cache() as cache:
        with timed(times, "made"):
            made = with_colliders(asset, kind)
            _complete(made)
        decomposed = sum(path.is_file() for path in cache.glob("coacd/**/*"))
    with tempfile.TemporaryDirectory() as directory:
        made.export(Path(directory) / "asset", formats=("mjcf",), textures=0)
        factor = speed(made, Path(directory) / "asset" / f"{made.name}.xml", {})
    hollow, open_, solid, covered = (sum(each) for each in zip(*map(_volumes, made.links), strict=True))
    return Made(
        times["made"] - start * decomposed,
        sum(len(link.colliders) for link in made.links),
        open_ / hollow,
        covered / solid,
        factor / STEP,
    )


def _volumes(link: Link) -> tuple[float, float, float, float]:
    """Return four volumes of a link: hollow, open part of the hollow, solids, covered part of them [m^3]."""
    solid = Manifold.batch_boolean([part.solid for part in link_parts(link)], OpType.Add)
    colliders = Manifold.batch_boolean([each.convex.manifold() for each in link.colliders], OpType.Add)
    hollow = solid.hull() - solid
    return hollow.volume(), (hollow - colliders).volume(), solid.volume(), (solid ^ colliders).volume()


def _time_table(whole: Mapping[str, float], found: Found) -> Table:
    return Table(
        "Time and pieces",
        (
            "asset",
            "exact [ms]",
            "seed to asset [ms]",
            "CoACD [ms]",
            "CoACD / seed to asset",
            "pieces, exact",
            "pieces, CoACD",
        ),
        [
            (
                name,
                1e3 * of["exact"].seconds,
                1e3 * whole[name],
                1e3 * of["coacd"].seconds,
                of["coacd"].seconds / whole[name],
                of["exact"].pieces,
                of["coacd"].pieces,
            )
            for name, of in found.items()
        ],
    )


def _volume_table(found: Found) -> Table:
    return Table(
        "Hollows and steps",
        (
            "asset",
            "open, exact [%]",
            "open, CoACD [%]",
            "covered, exact [%]",
            "covered, CoACD [%]",
            "steps/s, exact",
            "steps/s, CoACD",
            "exact / CoACD",
        ),
        [
            (
                name,
                *(100.0 * of[kind].open for kind in KINDS),
                *(100.0 * of[kind].covered for kind in KINDS),
                *(of[kind].steps for kind in KINDS),
                of["exact"].steps / of["coacd"].steps,
            )
            for name, of in found.items()
        ],
    )


def _findings(whole: Mapping[str, float], found: Found) -> list[str]:
    slower = span([of["coacd"].seconds / whole[name] for name, of in found.items()])
    pieces = span([of["coacd"].pieces / of["exact"].pieces for of in found.values()])
    opened, covered = (
        {kind: span([100.0 * getattr(of[kind], what) for of in found.values()]) for kind in KINDS}
        for what in ("open", "covered")
    )
    steps = {name: of["exact"].steps / of["coacd"].steps for name, of in found.items()}
    behind = [name for name, ratio in steps.items() if ratio < 1.0]
    return [
        f"CoACD alone takes {slower} times as long as everything from the seed to the asset.",
        f"It makes {pieces} times as many pieces.",
        (
            f"Of the hollows, {opened['exact']} % stay open by construction and {opened['coacd']} % with "
            f"CoACD; of the solids, {covered['exact']} % and {covered['coacd']} % are covered."
        ),
        (
            f"With colliders by construction, MuJoCo makes {span(list(steps.values()))} times as many steps "
            "a second" + (f"; with CoACD it is faster for {', '.join(behind)}." if behind else ".")
        ),
    ]
