"""Summary of the records of a survey: criteria, failures and ranges of a category."""

import re
import statistics
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from artgen.asset.link import MOST_COLLIDERS

REDRAWN = 0.02
"""Allowed share of draws that are ruled out: with more, the ranges are not those of a product."""

MEDIAN_SECONDS = 0.120
"""Time from a seed to an asset, without the proof, on one core: a thousand in two minutes [s]."""

MOST_OF_ASSET = 199
"""Colliders of an asset: a scene with some dozens of them still fits a simulator on a GPU."""

SLOWEST = 20.0
"""Least speed of MuJoCo at steps of 2 ms, over real time: a lower one slows down learning."""

HAND = 60.0
"""Largest force for a hand or foot: people push doors and pedals with it [N]."""

ON_GROUND = 1e-6
"""Allowed distance of the lowest point from z = 0 [m]."""

OFF_CENTRE = 0.025
"""Allowed distance of the base's center from x = 0, over the width: hinges protrude at a side."""

_COPY = re.compile(r"_\d+$")  # suffix of one of several equal joints
_MANY = 12  # number of listed seeds
_LONG = 400  # shown characters of a message

Record = Mapping[str, Any]


@dataclass(frozen=True)
class Criterion:
    """A requirement for a category."""

    name: str  # the requirement
    found: str  # the result, with numbers
    passed: bool | None  # whether it is met; None if not measured
    seeds: tuple[int, ...] = ()  # the seeds that do not meet it


@dataclass(frozen=True)
class Failure:
    """A kind of failure."""

    kind: str  # ending of the samples, or the check that found a fault
    seeds: tuple[int, ...]  # seeds of the samples
    message: str  # message of the first sample

    def __str__(self) -> str:
        """Return kind, seeds and first message."""
        return f"{self.kind}: {listed(self.seeds)}\n  seed {self.seeds[0]}: {shortened(self.message)}"


def criteria(records: Sequence[Record]) -> list[Criterion]:
    """Return the criteria for a category with the results of a survey."""
    done = [record for record in records if record["state"] == "done"]
    used = [record for record in done if "speed" in record]
    ended = tuple(record["seed"] for record in records if record["state"] != "done")
    return [
        Criterion("every seed gives an asset", f"{len(done)} of {len(records)}", not ended, ended),
        _redraws(done),
        _median(done),
        _each("colliders a link", done, _most_of_link, MOST_COLLIDERS),
        _each("colliders", done, lambda record: sum(record["colliders"].values()), MOST_OF_ASSET),
        _none("like a product", done, lambda record: bool(record["misfits"])),
        _none("on the ground", done, lambda record: bool(abs(record["ground"]) > ON_GROUND)),
        _none("centered", done, _aside),
        *(_none(f"{check}: no faults", done, _faulty(check)) for check in ("solids", "tree", "colliders")),
        *(_none(f"{check}: no faults", used, _faulty(check)) for check in ("grasps", "behavior")),
        _each("force of a hand [N]", [each for each in used if each["forces"]], _hardest, HAND),
        _each("MuJoCo, times real time", used, lambda each: min(each["speed"].values()), SLOWEST, least=True),
    ]


def failures(records: Sequence[Record]) -> list[Failure]:
    """Return the kinds of failures, the most frequent first."""
    found: dict[str, list[tuple[int, str]]] = {}
    for record in records:
        for kind, message in _failures_of(record):
            found.setdefault(kind, []).append((record["seed"], message))
    kinds = [
        Failure(kind, tuple(dict.fromkeys(seed for seed, _ in each)), each[0][1])
        for kind, each in found.items()
    ]
    return sorted(kinds, key=lambda failure: -len(failure.seeds))


def figures(records: Sequence[Record]) -> dict[str, str]:
    """Return medians, 95 % values and ranges of the other measurements."""
    done = [record for record in records if record["state"] == "done"]
    if not done:
        return {}
    found = {
        "seed to asset [ms]": _quantiles(1e3 * record["seconds"] for record in done),
        "certificate [ms]": _quantiles(1e3 * record["proof"]["seconds"] for record in done),
        "colliders": _range(sum(record["colliders"].values()) for record in done),
        "links": _range(record["links"] for record in done),
        "joints": _range(record["joints"] for record in done),
        "mass [kg]": _range(record["mass"] for record in done),
    }
    for number, name in enumerate(("width", "depth", "height")):
        found[f"{name} [m]"] = _range(record["size"][number] for record in done)
    used = [record for record in done if "speed" in record]
    for name in used[0]["speed"] if used else ():
        found[f"MuJoCo {name}, times real time"] = _quantiles(record["speed"][name] for record in used)
    forces: dict[str, list[float]] = {}
    for record in used:
        for joint, force in record["forces"].items():
            forces.setdefault(_COPY.sub("", joint), []).append(force)
    found |= {f"force at {joint} [N]": _range(values) for joint, values in sorted(forces.items())}
    return found


def listed(seeds: Sequence[int]) -> str:
    """Return a list of seeds as text."""
    shown = ", ".join(str(seed) for seed in seeds[:_MANY])
    more = len(seeds) - _MANY
    plural = "seed" if len(seeds) == 1 else "seeds"
    return f"{len(seeds)} {plural}: {shown}" + (f" and {more} more" if more > 0 else "")


def shortened(message: str) -> str:
    """Shorten a long message: keep the end of a traceback, the beginning of anything else."""
    if len(message) <= _LONG:
        return message
    return "... " + message[-_LONG:] if message.startswith("Traceback") else message[:_LONG] + " ..."


def _failures_of(record: Record) -> Iterator[tuple[str, str]]:
    if record["state"] != "done":
        yield record["state"], record["message"].strip()
        return
    redrawn = record["redrawn"]
    if redrawn["collided"]:
        yield "redrawn for a collision", record["collision"]
    if redrawn["required"]:
        yield "redrawn by a requirement", f"{redrawn['required']} draws"
    for message in record["misfits"]:
        yield "like no product", message
    for check, result in record["checks"].items():
        if result["skipped"]:
            yield f"{check} (skipped)", result["skipped"]
        for fault in result["faults"]:
            yield check, fault
        for note in result["notes"]:
            yield f"{check} (note)", note
    hard = {joint: force for joint, force in record.get("forces", {}).items() if force > HAND}
    if hard:
        yield "force of a hand", ", ".join(f"{joint} {force:.3g} N" for joint, force in hard.items())


def _redraws(done: Sequence[Record]) -> Criterion:
    required = sum(record["redrawn"]["required"] for record in done)
    collided = sum(record["redrawn"]["collided"] for record in done)
    share = (required + collided) / max(required + collided + len(done), 1)
    return Criterion(
        f"redrawn: under {100 * REDRAWN:g} %",
        f"{100 * share:.2g} %: {required} by requirements, {collided} by collisions",
        share < REDRAWN if done else None,
        tuple(record["seed"] for record in done if any(record["redrawn"].values())),
    )


def _median(done: Sequence[Record]) -> Criterion:
    median = statistics.median([record["seconds"] for record in done]) if done else 0.0
    return Criterion(
        f"seed to asset: median at most {1e3 * MEDIAN_SECONDS:g} ms",
        f"{1e3 * median:.0f} ms",
        median <= MEDIAN_SECONDS if done else None,
    )


def _each(
    name: str,
    records: Sequence[Record],
    value: Callable[[Record], float],
    limit: float,
    *,
    least: bool = False,
) -> Criterion:
    """Return a criterion with an upper or lower limit for a number of each sample."""
    criterion = f"{name}: at {'least' if least else 'most'} {limit:g}"
    if not records:
        return Criterion(criterion, "not measured", None)
    values = {record["seed"]: value(record) for record in records}
    beyond = tuple(seed for seed, each in values.items() if (each < limit if least else each > limit))
    worst = min(values.values()) if least else max(values.values())
    return Criterion(
        criterion, f"{worst:.3g}, median {statistics.median(values.values()):.3g}", not beyond, beyond
    )


def _none(name: str, records: Sequence[Record], wrong: Callable[[Record], bool]) -> Criterion:
    """Return a criterion that each sample meets or not."""
    if not records:
        return Criterion(name, "not measured", None)
    seeds = tuple(record["seed"] for record in records if wrong(record))
    return Criterion(name, f"{len(records) - len(seeds)} of {len(records)}", not seeds, seeds)


def _faulty(check: str) -> Callable[[Record], bool]:
    return lambda record: bool(record["checks"][check]["faults"])


def _most_of_link(record: Record) -> float:
    return float(max(record["colliders"].values()))


def _hardest(record: Record) -> float:
    return float(max(record["forces"].values()))


def _aside(record: Record) -> bool:
    return bool(abs(record["aside"]) > OFF_CENTRE * record["size"][0])


def _quantiles(values: Iterable[float]) -> str:
    numbers = sorted(values)
    high = numbers[min(int(0.95 * len(numbers)), len(numbers) - 1)]
    return f"{numbers[0]:.3g} to {numbers[-1]:.3g}, median {statistics.median(numbers):.3g}, 95 % {high:.3g}"


def _range(values: Iterable[float]) -> str:
    numbers = list(values)
    return f"{min(numbers):.3g} to {max(numbers):.3g}, median {statistics.median(numbers):.3g}"
