"""The page of the field: tables from the records of field.py."""

import re
import statistics
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from machine import machine
from report import flowing, shown
from sampled import EACH, OVERLAP, TOGETHER
from surveys.pages import escaped

Record = Mapping[str, Any]

_HEAD = """
Articulated files that Python packages bring, judged by sampled states and by the referee (`artgen certify`),
and artgen's own assets beside them. Written by `benchmarks/field.py` from its records; do not edit it.
"""
_GROUPS = {
    "objects": "objects: doors, drawers, cabinets, kitchens and other things that a robot uses",
    "robots": "robots: arms, hands, legs, vehicles, and scenes with a robot in them",
    "artgen": 'artgen: 18 categories, seeds 0 and 1, exported with `limits="independent"`',
}
_DEFINITIONS = """
## Definitions

- *judged*: files with at least one hinge, slide, revolute, prismatic or continuous joint. Of a package with
more than {most} such files, {most} are chosen, evenly spaced in the order of their names. Of the robots,
{every} of those is judged. A file that MuJoCo loads and that has no such joint is left out.

- *objects* and *robots*: by the folder and the name of the file, see `group_of` in `benchmarks/field.py`. A
scene with a robot counts as a robot.

- *loadable*: MuJoCo compiles the file alone. A URDF is given to MuJoCo's reader without its visuals and with
its meshes as STL; `package://` is resolved in the folders above the file. The others are not loadable alone:
parts that other files include, files whose meshes or textures are not in the package, or files of another
version of MuJoCo.

- *sampled pass*: no overlap of colliders deeper than {overlap} mm at rest, at {each} states of each joint
alone, and at {together} Sobol states of all joints. Joints that follow others are moved with them; states
that move a follower out of its limits do not count. Pairs are those that the file lets collide (masks and
`<exclude>` of MJCF); links that a joint connects are left out, as MuJoCo does.

- *sampled pass with parents*: the same with all pairs of colliders that move against each other.

- *proven*, *collision*, *not proven*: the referee's verdict on the pairs that the file lets collide, over the
whole ranges of the joints. In a URDF these are all pairs, parents and children included. A collision has a
witness: positions of the joints at which it happens.

- *proven with excluded*: all pairs are proven, also those that the file excludes.

- *nothing moves*: no two links with colliders move against each other.

- *beyond the referee*: MuJoCo loads the file, or cannot for its format, and the referee refuses it.

- *over the time*: not finished in {limit} s; the referee has {seconds} s for a pair, 6 times that for a file.

- *verdict*: share of the files that are proven, have a collision, or in which nothing moves. The referee
stops at the first collision of a file, for one witness refutes it; pairs that are left then are not examined.
Files that neither MuJoCo nor the referee reads do not count.

- *median*: time of the referee for a file that it finished. The machine had other work, which lengthens it;
*processor* is the time that the processors spent on the referee, with the processes that it starts.

## What is not judged

- Groups of bodies that hang on different free or ball joints are not judged against each other, by neither of
the two: their ranges are not bounded.

- Planes, height fields, soft bodies and visuals. A mesh is its convex hull in both.

- Packages that fetch their files from elsewhere when they run bring none in their wheels, and are not in the
table; nor are packages without a wheel. Classes of scene-synthesizer that need arguments are not made.

- The sampled protocol reads no USD, for MuJoCo does not.

- Many files of robots leave the collision of neighbors to the simulator's filter of parents and children, and
limits of joints to a planner: a collision in this table says what the file says, not how a robot is used.

## Commands

    python benchmarks/field.py --page docs/field.md --every 8
    python benchmarks/field.py --packages metaworld,artgen --jobs 2
    artgen certify FILE --first

The records of single files are in `out/field/*.jsonl`; a file that has one is judged again only with
`--again`, and then by the referee only: its sampled states stay.
"""
_DECIDED = ("proven", "collision", "nothing moves")  # verdicts
_LISTED = 20  # most files of a list
_SHOWN = 12  # most reasons of a list
_PROTOCOL = 2.0 * OVERLAP  # depth from which an overlap contradicts a proof [m]


def _sampled(record: Record) -> Record:
    found: Record = record.get("sampled") or {}
    return found


def _referee(record: Record) -> Record:
    found: Record = record.get("referee") or {}
    return found


def articulated(record: Record) -> bool:
    """Tell whether a record counts: not if the file was loaded and has no joint that moves."""
    return _sampled(record).get("joints") != 0


def passes(record: Record, which: str) -> bool:
    """Tell whether all sampled states of a file are free of overlaps."""
    found = _sampled(record)
    return bool(found.get("loadable")) and bool(found["complete"]) and found[which]["depth"] == 0.0


def contradictions(records: Sequence[Record]) -> list[str]:
    """Return the proven files in which a sampled state overlaps, one line each."""
    lines = []
    for record in records:
        for verdict, which in (("verdict", "as_filed"), ("verdict_with_excluded", "with_parents")):
            found = _sampled(record).get(which)
            if found and _referee(record).get(verdict) == "proven" and found["depth"] > _PROTOCOL:
                pair = " and ".join(found["pair"])
                state = ", ".join(f"{name}={at:.6g}" for name, at in found["state"].items()) or "rest"
                lines.append(
                    f"{record['package']} `{record['path']}` ({verdict}): {pair} overlap by "
                    f"{1e3 * found['depth']:.3g} mm at {state}"
                )
    return lines


def beyond(record: Record) -> bool:
    """Tell whether MuJoCo loads a file, or cannot for its format, and the referee does not."""
    return "error" in _referee(record) and _sampled(record).get("loadable") is not False


_COLUMNS: dict[str, Callable[[Record], bool]] = {
    "loadable": lambda record: bool(_sampled(record).get("loadable")),
    "sampled pass": lambda record: passes(record, "as_filed"),
    "sampled pass with parents": lambda record: passes(record, "with_parents"),
    "proven": lambda record: _referee(record).get("verdict") == "proven",
    "proven with excluded": lambda record: _referee(record).get("verdict_with_excluded") == "proven",
    "collision": lambda record: _referee(record).get("verdict") == "collision",
    "not proven": lambda record: _referee(record).get("verdict") == "not proven",
    "nothing moves": lambda record: _referee(record).get("verdict") == "nothing moves",
    "beyond the referee": beyond,
    "over the time": lambda record: not _referee(record) and bool(record["ended"]),
}
"""Columns of the tables: what is counted."""

_OF_MUJOCO = ("loadable", "sampled pass", "sampled pass with parents")


def write_page(
    path: Path,
    records: Sequence[Record],
    left: Mapping[str, int],
    *,
    seconds: float,
    limit: float,
    most: int,
    every: int,
) -> None:
    """Write the page.

    Args:
        path: The page.
        records: All records.
        left: Number of files of each group that are not judged yet.
        seconds: Time limit of the referee for a pair [s].
        limit: Time limit for a file [s].
        most: Most files of a package.
        every: Each so many-th file of robots is judged.
    """
    lines = ["# The field", "", flowing(_HEAD), ""]
    lines += _totals(records)
    if left:
        rest = ", ".join(f"{count} of {group}" for group, count in left.items())
        lines += ["", f"Not judged yet: {rest}."]
    for group, title in _GROUPS.items():
        own = [each for each in records if each["group"] == group]
        if own:
            lines += ["", f"## {title[:1].upper()}{title[1:]}", "", *_table(own, by_format=group == "artgen")]
    lines += ["", "## Contradictions", "", *_contradictions(records)]
    lines += ["", "## Collisions that the samples do not meet", "", *_missed(records)]
    lines += ["", "## What the referee does not read", "", *_reasons(records)]
    lines += ["", *_definitions(seconds, limit, most, every)]
    commits = ", ".join(sorted({each["commit"] for each in records if "commit" in each}))
    lines += ["", f"Measured on: {machine({})}. The referee is that of commit {commits}.", ""]
    path.parent.mkdir(parents=True, exist_ok=True)
    beside = path.with_name(f"{path.name}.part")
    beside.write_text("\n".join(lines), encoding="utf-8")
    beside.replace(path)


def _header(first: Sequence[str]) -> list[str]:
    columns = [*first, *_COLUMNS, "verdict [%]", "median [s]", "processor [s]"]
    return [_line(columns), _line(["---", *("---:" for _ in columns[1:])])]


def _counts(records: Sequence[Record]) -> list[str]:
    times = [each["seconds"] for each in map(_referee, records) if "seconds" in each]
    spent = [each["processor_seconds"] for each in map(_referee, records) if "processor_seconds" in each]
    unread = all(_sampled(each).get("loadable", False) is None for each in records)
    return [
        *(
            "" if unread and name in _OF_MUJOCO else str(sum(map(counts, records)))
            for name, counts in _COLUMNS.items()
        ),
        _share(records),
        shown(statistics.median(times)) if times else "",
        shown(statistics.median(spent)) if spent else "",
    ]


def _share(records: Sequence[Record]) -> str:
    """Return the share of the complete files that have a verdict, in percent."""
    complete = [
        each
        for each in records
        if beyond(each) or ("error" not in _referee(each) and (_referee(each) or each["ended"]))
    ]
    decided = sum(_referee(each).get("verdict") in _DECIDED for each in complete)
    return f"{100.0 * decided / len(complete):.0f}" if complete else ""


def _totals(records: Sequence[Record]) -> Iterator[str]:
    yield from _header(("files", "judged"))
    for group in _GROUPS:
        own = [each for each in records if each["group"] == group and articulated(each)]
        if own:
            yield _line([group, str(len(own)), *_counts(own)])


def _table(records: Sequence[Record], *, by_format: bool) -> Iterator[str]:
    yield from _header(("format" if by_format else "package", "version", "judged"))
    key = "format" if by_format else "package"
    for name in dict.fromkeys(each[key] for each in sorted(records, key=lambda each: str(each[key]))):
        own = [each for each in records if each[key] == name and articulated(each)]
        if own:
            yield _line([name, own[0]["version"], str(len(own)), *_counts(own)])


def _contradictions(records: Sequence[Record]) -> list[str]:
    found = contradictions(records)
    if found:
        return [f"- {escaped(line)}" for line in found]
    proven = sum(_referee(each).get("verdict") == "proven" for each in records)
    refuted = sum(not _referee(each).get("rechecked", True) for each in records)
    deep = f"{1e3 * _PROTOCOL:g} mm"
    return [
        f"In none of {proven} proven files does a sampled state overlap by more than {deep}.",
        f"The recheck refutes {refuted} verdicts.",
    ]


def missed(records: Sequence[Record]) -> list[Record]:
    """Return the files in which the referee finds a collision and no sampled state overlaps."""
    return [
        record
        for record in records
        if _referee(record).get("verdict_with_excluded") == "collision" and passes(record, "with_parents")
    ]


def _missed(records: Sequence[Record]) -> Iterator[str]:
    refuted = [each for each in records if _referee(each).get("verdict_with_excluded") == "collision"]
    loaded = [each for each in refuted if _sampled(each).get("loadable")]
    witnesses = [found for each in loaded for found in _referee(each).get("witnesses", ())]
    confirmed = sum(found["depth"] > OVERLAP for found in witnesses)
    only = missed(records)
    yield (
        f"The referee finds a collision in {len(refuted)} files; MuJoCo loads {len(loaded)} of them. At "
        f"{confirmed} of {len(witnesses)} witnesses, at most five of a file, MuJoCo finds an overlap deeper "
        f"than {1e3 * OVERLAP:g} mm, too. In {len(only)} of these files no sampled state overlaps, with "
        "parents and all pairs:"
    )
    yield ""
    for record in only[:_LISTED]:
        failure = (_referee(record)["failures"] or [""])[0].partition("; first contact")[0]
        yield f"- {record['package']} `{record['path']}`: {escaped(failure)}"
    if len(only) > _LISTED:
        yield f"- and {len(only) - _LISTED} more"


def _reasons(records: Sequence[Record]) -> Iterator[str]:
    """Yield the referee's errors, files and numbers left out, with how often each was given."""
    counted: Counter[str] = Counter()
    for record in records:
        if articulated(record) and beyond(record):
            counted[_kind(_referee(record)["error"], record)] += 1
    if not counted:
        yield "It read all of them."
        return
    yield "| reason | files |"
    yield "| --- | ---: |"
    for reason, count in counted.most_common(_SHOWN):
        yield f"| {escaped(reason)} | {count} |"
    if len(counted) > _SHOWN:
        rest = sum(count for _, count in counted.most_common()[_SHOWN:])
        yield f"| {len(counted) - _SHOWN} other reasons | {rest} |"


def _kind(error: str, record: Record) -> str:
    """Return an error without its file, names and numbers."""
    name = Path(record["path"]).name
    text = error[error.index(name) + len(name) :] if name in error else error
    text = re.sub(r"'[^']*'|\"[^\"]*\"", "'...'", text.strip(":, "))
    text = re.sub(r"\S*/\S+", "...", text)
    return re.sub(r"\b\d+(\.\d+)?\b", "n", text)[:120]


def _definitions(seconds: float, limit: float, most: int, every: int) -> list[str]:
    text = _DEFINITIONS.format(
        seconds=f"{seconds:g}",
        limit=f"{limit:g}",
        most=most,
        every="each file" if every == 1 else f"each {every}th file",
        overlap=f"{1e3 * OVERLAP:g}",
        each=EACH,
        together=TOGETHER,
    )
    lines = []
    for paragraph in text.strip().split("\n\n"):
        item = paragraph.startswith("- ")
        lines += [paragraph if paragraph.startswith("    ") else flowing(paragraph), *([] if item else [""])]
    return _spaced(lines)


def _spaced(lines: Sequence[str]) -> list[str]:
    """Return lines with an empty one between a list and the heading after it."""
    result: list[str] = []
    for line in lines:
        if line.startswith("## ") and result and result[-1]:
            result.append("")
        result.append(line)
    return result


def _line(cells: Sequence[str]) -> str:
    return f"| {' | '.join(cells)} |"
