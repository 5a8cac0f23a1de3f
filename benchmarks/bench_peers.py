"""Compare with scene-synthesizer: time, triangles, colors, penetrations of links, inertia."""

import shutil
import statistics
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from peer import Peer, peer
from report import Section, Table, shown, span
from timing import seconds
from urdf import TOUCHING, Contents, Penetration, Positions, contents, penetration

import artgen
from artgen.asset import Asset

CLASSES = {
    "cabinet": "BaseCabinetAsset",
    "dishwasher": "DishwasherAsset",
    "microwave": "MicrowaveAsset",
    "oven": "RangeAsset",
    "refrigerator": "RefrigeratorAsset",
}
"""The peer's class of each category."""

OURS, THEIRS = "artgen", "scene-synthesizer"

_COMPARED = f"""
Assets of artgen and of scene-synthesizer's articulated classes, of the same seeds, each written as URDF and
read back by the same code. *Same work* is from a seed to a URDF with its meshes: no certificate, no maps.
*All* is what `artgen generate` does beyond that: certificate, maps (from the cache) and all formats. A
class that draws no parameters of its own gives the same asset for each seed. Links are in each other where
python-fcl finds colliders of two links that move against each other deeper than {1e3 * TOUCHING:g} mm in
each other, at random states within the limits of the joints; artgen's dependencies (a rack needs the door
open), which a URDF cannot say, forbid some states: both counts are shown. A tensor of inertia is *possible*
if it keeps the triangle inequality and the link's mass within the link's size can have it. Both are used as
they come: scene-synthesizer takes a density as an argument, which changes the masses and not the tensors.
"""


@dataclass(frozen=True)
class Measured:
    """Measurements of an asset of one library.

    Attributes:
        contents: Contents of its URDF.
        anywhere: Penetrations of links within the joint limits.
        allowed: The same, in states that its dependencies allow.
    """

    contents: Contents
    anywhere: Penetration
    allowed: Penetration


Found = Mapping[tuple[str, str], Sequence[Measured]]


def measure(*, quick: bool) -> Section:
    """Run the benchmark."""
    names = ["microwave"] if quick else list(CLASSES)
    seeds = range(1) if quick else range(3)
    states = 5 if quick else 50
    with peer() as other, tempfile.TemporaryDirectory() as directory:
        times = {name: _times(other, name, seeds, Path(directory)) for name in names}
        found = {
            (name, who): [_measured(other, name, who, seed, states, Path(directory)) for seed in seeds]
            for name in names
            for who in (THEIRS, OURS)
        }
        version = other.version
    return Section(
        "against scene-synthesizer",
        _COMPARED,
        [
            _time_table(times, len(seeds)),
            _looks_table(found),
            _inside_table(found, names, states * len(seeds)),
            _mass_table(found),
        ],
        _findings(times, found, names),
        {THEIRS: version},
    )


def _times(other: Peer, name: str, seeds: Sequence[int], directory: Path) -> dict[str, float]:
    """Return the median times of both libraries over seeds, measured alternately [s]."""
    place = directory / "times" / name
    place.mkdir(parents=True)

    def ours(seed: int, *, everything: bool) -> None:
        asset = artgen.catalog.find(name).generate(seed, cache=artgen.graph.Cache(), certify=everything)
        if everything:
            asset.export(place / f"all_{seed}")
        else:
            asset.export(place / f"same_{seed}", formats=("urdf",), textures=0)

    def round_of(seed: int) -> dict[str, float]:
        return {
            THEIRS: other.make(CLASSES[name], seed, place / f"{seed}.urdf"),
            "same": seconds(partial(ours, seed, everything=False)),
            "all": seconds(partial(ours, seed, everything=True)),
        }

    rounds = []
    for seed in seeds:
        round_of(seed)  # imports, first calls and maps that are not in the cache are no part of the figures
        shutil.rmtree(place)
        place.mkdir()
        rounds.append(round_of(seed))
    return {what: statistics.median(each[what] for each in rounds) for what in rounds[0]}


def _measured(other: Peer, name: str, who: str, seed: int, states: int, directory: Path) -> Measured:
    place = directory / "assets" / f"{who}_{name}_{seed}"
    if who == THEIRS:
        place.mkdir(parents=True)
        path = place / "asset.urdf"
        other.make(CLASSES[name], seed, path)
        anywhere = penetration(path, states)
        return Measured(contents(path), anywhere, anywhere)
    asset = artgen.catalog.find(name).generate(seed)
    asset.export(place, formats=("urdf",))
    path = place / f"{asset.name}.urdf"
    return Measured(
        contents(path), penetration(path, states), penetration(path, states, partial(_blocked, asset))
    )


def _blocked(asset: Asset, q: Positions) -> bool:
    """Tell whether a dependency forbids positions; a URDF rounds the limits."""
    within = {}
    for name, position in q.items():
        low, high = asset.joint(name).limits or (position, position)
        within[name] = min(max(position, low), high)
    return bool(asset.blocked(within))


def _time_table(times: Mapping[str, dict[str, float]], seeds: int) -> Table:
    return Table(
        f"Processor time per asset, median of {seeds} seeds",
        ("category", f"{THEIRS} [ms]", "artgen, same work [ms]", "ratio", "artgen, all [ms]", "ratio"),
        [
            (
                name,
                1e3 * each[THEIRS],
                1e3 * each["same"],
                each["same"] / each[THEIRS],
                1e3 * each["all"],
                each["all"] / each[THEIRS],
            )
            for name, each in times.items()
        ],
    )


def _middle(of: Sequence[Measured], what: str) -> float:
    return statistics.median(float(getattr(each.contents, what)) for each in of)


def _looks_table(found: Found) -> Table:
    counted = ("bodies", "joints", "vertices", "faces", "colors", "maps", "colliders")
    return Table(
        "What is in the URDF, medians",
        ("category", "by", *counted),
        [(name, who, *(_middle(of, what) for what in counted)) for (name, who), of in found.items()],
    )


def _inside(found: Found, name: str, who: str, states: str) -> tuple[float, float]:
    """Return the share of states with a penetration of links [%], and the largest depth [mm]."""
    each = [getattr(of, states) for of in found[name, who]]
    deepest = max(one.deepest for one in each)
    return 100.0 * statistics.mean(one.share for one in each), round(1e3 * deepest, 6)


def _inside_table(found: Found, names: Sequence[str], states: int) -> Table:
    return Table(
        f"States with links in each other, of {states} random ones; and the deepest",
        (
            "category",
            f"{THEIRS} [%]",
            "[mm]",
            "artgen, limits alone [%]",
            "[mm]",
            "artgen, as its dependencies allow [%]",
            "[mm]",
        ),
        [
            (
                name,
                *_inside(found, name, THEIRS, "anywhere"),
                *_inside(found, name, OURS, "anywhere"),
                *_inside(found, name, OURS, "allowed"),
            )
            for name in names
        ],
    )


def _mass_table(found: Found) -> Table:
    return Table(
        "Masses and tensors of inertia, medians",
        ("category", "by", "mass [kg]", "bodies", "with a mass", "triangle inequality", "possible"),
        [
            (
                name,
                who,
                *(_middle(of, what) for what in ("mass", "bodies", "massive", "triangular", "fitting")),
            )
            for (name, who), of in found.items()
        ],
    )


def _findings(times: Mapping[str, dict[str, float]], found: Found, names: Sequence[str]) -> list[str]:
    same = [each[THEIRS] / each["same"] for each in times.values()]
    everything = [each["all"] / each[THEIRS] for each in times.values()]
    quicker = [name for name, ratio in zip(names, same, strict=True) if ratio < 1.0]
    faces = [_middle(found[name, OURS], "faces") / _middle(found[name, THEIRS], "faces") for name in names]
    per_face = [1.0 / ratio / more for ratio, more in zip(same, faces, strict=True)]
    theirs, alone, allowed = (
        statistics.mean(_inside(found, name, who, states)[0] for name in names)
        for who, states in ((THEIRS, "anywhere"), (OURS, "anywhere"), (OURS, "allowed"))
    )
    possible = {
        who: sum(_middle(found[name, who], "fitting") for name in names)
        / sum(_middle(found[name, who], "bodies") for name in names)
        for who in (THEIRS, OURS)
    }
    return [
        f"The same work takes scene-synthesizer {span(same)} times as long as artgen"
        + (f"; scene-synthesizer is faster for {', '.join(quicker)}." if quicker else "."),
        (
            f"Certificate, maps and all formats included, artgen takes {span(everything)} times as long as "
            "scene-synthesizer takes for its URDF."
        ),
        (
            f"Assets of artgen have {span(faces)} times as many faces; a face takes artgen {span(per_face)} "
            "times as long."
        ),
        (
            f"Links are in each other at {shown(theirs)} % of the states of scene-synthesizer's assets; of "
            f"artgen's at {shown(alone)} % within the limits alone, and at {shown(allowed)} % of those that "
            "its dependencies allow."
        ),
        (
            f"Tensors of inertia are possible for {shown(100.0 * possible[THEIRS])} % of scene-synthesizer's "
            f"bodies and {shown(100.0 * possible[OURS])} % of artgen's."
        ),
    ]
