"""Load many seeds of every category in every layout in every client, and write the table of docs/clients.md.

Exports and answers stay in the work folder, so that an interrupted run continues; they are deleted when the
source of artgen changes. `--no-run` writes the page from the answers of an unfinished run. `make clients`
installs the clients, `make client-table` runs this.
"""

import hashlib
import json
import os
import shutil
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass
from pathlib import Path
from string import ascii_uppercase
from typing import Annotated, Any

import typer
from surveys.pages import escaped

from artgen import __version__, generate
from artgen.catalog import categories
from artgen.export import LAYOUTS
from artgen.validate.clients.exported import read_exported
from artgen.validate.clients.registry import CLIENTS, Client, chosen_clients
from artgen.validate.clients.run import run_client

ROOT = Path(__file__).parents[1]
SOURCE = ROOT / "src" / "artgen"
FREE = 5  # every so manyth export stands on a free base
PLAIN = 4  # every so manyth export has colors alone, no maps
PART = 5  # most categories that one process of a client reads

SLOW = ("mjx", "mujoco_warp", "genesis_mjcf", "genesis_urdf")
"""Clients that compile for each asset, for a minute or more: they read fewer seeds."""

READING = {"__pycache__", "check", "clients", "commands", "testing", "view"}
"""Folders of artgen that take no part in an export: where they change, exports stay."""

KNOWN = (
    (
        "Drake",
        (
            "in MJCF it passes over a joint's `ref`, its spring and dry friction, and over couplings, and "
            "turns a body with several joints about its parent's origin, where it may jam; its URDF is right"
        ),
    ),
    (
        "Genesis",
        (
            "in a URDF it gives shapes to links in the order of the file and joints in their own: keep both "
            "the same, as artgen does; what it says of dubious inertia compares different axes"
        ),
    ),
    ("MuJoCo", "from a URDF, its limits and contacts are as soft as its defaults; the MJCF has firmer ones"),
    ("MJX", "on JAX it refuses contacts between cylinders and boxes: `impl='warp'` takes them"),
    (
        "mujoco_usd_converter",
        "two joints of one body become two joints between the same bodies: they move one after the other",
    ),
    ("Newton", "a drive's target beyond a joint's limits becomes the middle of its range"),
    (
        "Newton, from a URDF",
        "limits are soft: a heavy sash, whose springs a URDF does not know, falls up to 0.13 m beyond them",
    ),
    (
        "PhysX",
        (
            "on a GPU, pieces a hundred times as long as thin collide on the processor, where rings may jam "
            "on them: cut such cylinders into lengths"
        ),
    ),
    ("pinocchio", "a coupled joint's leader has to come before it in the alphabet"),
    (
        "PyBullet",
        (
            "it passes over `<mimic>`, and loses a body of more than 127 links, such as a keyboard with its "
            "frames: export it with `frames=False`"
        ),
    ),
    ("robosuite", "it drops an object's `<equality>`: append it to the task"),
    (
        "SAPIEN, ManiSkill",
        (
            "their loader inverts `<mimic>` between joints of one body, so that a lever sticks "
            "(`artgen.envs.maniskill.build` couples them itself); the layout `partnet-mobility` leaves such "
            "couplings out; it divides the force on a leader by the ratio, so that screws stick, those of "
            "jars' lids and of pens' dials, and passes over leaders further from the base than their "
            "followers, as in laptops with two hinges; in place of a file's friction each joint has one of "
            "0.05 times the load on it, by which the catch of a hood's filter sticks at steps of 4 ms"
        ),
    ),
    ("SimReady's variants", "neutral by default, without friction or couplings: enable your simulator's"),
)
"""What people who use a client should know of it."""

ELSEWHERE = (
    ("Isaac Sim", "it needs an RTX GPU; its physics is ovphysx, its validators are the two of NVIDIA above"),
    (
        "brax",
        (
            "0.14.2 merges a fixed base into its world and then refuses the world's inertia, and knows no "
            "contact of a cylinder with a mesh, which a free base has; MJX, which it is built on, is above"
        ),
    ),
    (
        "RoboCasa",
        (
            "it is on no package index; robosuite, which it is built on, is above, and the sites, regions "
            "and classes that it looks for were read from its source"
        ),
    ),
    ("Gazebo", "Debian and PyPI have its library, but no program that loads a URDF without a display"),
)
"""Clients that no driver is for, and why."""


EARLIER = (
    "A run of 25 November 2026 read seeds 0 to 4 of dishwasher, door, handle, lamp, refrigerator, toaster "
    "and trashcan in all layouts, or seed 0 by the clients that compile for each asset: each client but "
    "drake_sdf, which was not there yet, passed all of them. "
    "Results of mjx, MuJoCo Warp, Newton, Genesis and drake_urdf, and all of chair and table, are of exports "
    "of 28 November 2026, the others of 27 November. "
    "A run of 1 December 2026 read seed 0 of all 60 categories, before their products had outputs, by all "
    "clients of the processor but gltf_validator, mjx, MuJoCo Warp, Newton, Genesis and mani_skill, and of "
    "20 of them by ovphysx: 1,695 of 1,700 passed. The others: the keyboard in pybullet and, within 120 s, "
    "in drake_urdf; the loaded catch of a range hood and the dial of a syringe in sapien; the folding "
    "chair, a closed chain, in robosuite."
)
"""Results that this run does not repeat."""


@dataclass(frozen=True)
class Task:
    """All seeds of a category in a layout, for one client."""

    client: Client
    category: str
    layout: str

    @property
    def file(self) -> str:
        """Name of the file with the answers of the client."""
        return f"{self.client.name}.{self.category}.{self.layout}.json"


def main(
    seeds: Annotated[int, typer.Option(help="Number of seeds of each category, from 0.")] = 20,
    slow_seeds: Annotated[
        int, typer.Option(help=f"Number of seeds for {', '.join(SLOW)}, which compile for each asset.")
    ] = 5,
    clients: Annotated[str, typer.Option(help="Names separated by commas.")] = "all",
    only: Annotated[str, typer.Option(help="Categories separated by commas; all by default.")] = "",
    layouts: Annotated[str, typer.Option(help="Layouts separated by commas.")] = ",".join(LAYOUTS),
    work: Annotated[Path, typer.Option(help="Folder for exports and answers.")] = Path("out/client_table"),
    jobs: Annotated[int, typer.Option(help="Number of clients that run at a time.")] = max(
        1, (os.cpu_count() or 2) // 2
    ),
    out: Annotated[Path, typer.Option(help="The page to write.")] = ROOT / "docs" / "clients.md",
    *,
    run: Annotated[bool, typer.Option(help="Run clients; otherwise, use the answers that there are.")] = True,
) -> None:
    """Write the table; exit code 1 if a client found a fault."""
    chosen, _ = chosen_clients(clients)
    named = [name.strip() for name in only.split(",") if name.strip()] or list(categories())
    folder = _fresh(work.absolute())
    tasks = [
        Task(client, category, layout)
        for client in chosen
        for layout in layouts.split(",")
        if layout in client.layouts and client.format in LAYOUTS[layout].formats
        for category in named
    ]
    if run:
        wanted = list(dict.fromkeys(task.layout for task in tasks))
        exports = {category: _exports(folder, category, wanted, seeds) for category in named}
        read = {
            task: exports[task.category][task.layout][: slow_seeds if task.client.name in SLOW else None]
            for task in tasks
        }
        results = _results(folder, read, jobs)
    else:
        saved = {task: _saved(folder / "answers" / task.file) for task in tasks}
        results = {task: answers for task, answers in saved.items() if answers}
    out.write_text("\n".join(_page(results, named)) + "\n", encoding="utf-8")
    typer.echo(out)
    states = Counter(outcome["state"] for found in results.values() for outcome in found)
    typer.echo(", ".join(f"{count} {state}" for state, count in sorted(states.items())))
    if states["failed"] or states["timed out"]:
        raise typer.Exit(1)


def _fresh(work: Path) -> Path:
    """Return the work folder, emptied if the source of artgen has changed since."""
    key = hashlib.sha256()
    for path in sorted(SOURCE.rglob("*")):
        if path.is_file() and not READING & set(path.parts):
            key.update(path.relative_to(SOURCE).as_posix().encode() + b"\0" + path.read_bytes())
    stamp = work / "source"
    if not stamp.is_file() or stamp.read_text(encoding="utf-8") != key.hexdigest():
        shutil.rmtree(work, ignore_errors=True)
        work.mkdir(parents=True)
        stamp.write_text(key.hexdigest(), encoding="utf-8")
    (work / "answers").mkdir(exist_ok=True)
    return work


def _exports(work: Path, category: str, layouts: Sequence[str], seeds: int) -> dict[str, list[Path]]:
    """Return the exports of a category by layout; missing ones are made."""
    result: dict[str, list[Path]] = {layout: [] for layout in layouts}
    for seed in range(seeds):
        number, asset = list(categories()).index(category) + seed, None
        for layout, made in result.items():
            made.append(work / "exports" / layout / f"{category}_{seed}")
            if (made[-1] / "asset.json").is_file():
                continue
            if asset is None:
                asset = generate(category, seed=seed, certify=False)
                asset = asset.with_base("free" if number % FREE == FREE - 1 else "fixed")
            textures = 0 if number % PLAIN == PLAIN - 1 else 512
            asset.export(made[-1], formats=LAYOUTS[layout].formats, layout=layout, textures=textures)
            typer.echo(f"exported {made[-1].name} {layout}", err=True)
    return result


def _results(work: Path, read: Mapping[Task, Sequence[Path]], jobs: int) -> dict[Task, list[dict[str, Any]]]:
    """Return the answer of each client to each export; answers of earlier runs are reused."""

    def run(tasks: Sequence[Task]) -> dict[Task, list[dict[str, Any]]]:
        pairs = [(task, directory) for task in tasks for directory in read[task]]
        outcomes = run_client(tasks[0].client, [read_exported(directory) for _, directory in pairs])
        found: dict[Task, list[dict[str, Any]]] = {task: [] for task in tasks}
        for outcome, (task, directory) in zip(outcomes, pairs, strict=True):
            found[task].append({**outcome.to_data(), "asset": directory.name, "message": outcome.message})
        return found

    results: dict[Task, list[dict[str, Any]]] = {}
    missing: dict[tuple[str, str], list[Task]] = {}
    for task, directories in read.items():
        earlier = _earlier_answers(work / "answers" / task.file, directories)
        if earlier is not None:
            results[task] = earlier
        else:
            missing.setdefault((task.client.name, task.layout), []).append(task)
    with ThreadPoolExecutor(jobs) as pool:
        parts = [
            tasks[start : start + PART] for tasks in missing.values() for start in range(0, len(tasks), PART)
        ]
        for future in as_completed([pool.submit(run, part) for part in parts]):
            for task, found in future.result().items():
                results[task] = found
                states = Counter(each["state"] for each in found)
                if not states["absent"]:  # it may be there next time
                    (work / "answers" / task.file).write_text(json.dumps(found), encoding="utf-8")
                counts = ", ".join(f"{count} {state}" for state, count in sorted(states.items()))
                typer.echo(f"{task.client.name} {task.category} {task.layout}: {counts}", err=True)
    return {task: results[task] for task in read}


def _earlier_answers(path: Path, directories: Sequence[Path]) -> list[dict[str, Any]] | None:
    """Return the answers of an earlier run; None if there are none, or a client reported a fault."""
    earlier = _saved(path)
    same = [each["asset"] for each in earlier] == [directory.name for directory in directories]
    return earlier if same and all(each["state"] == "passed" for each in earlier) else None


def _saved(path: Path) -> list[dict[str, Any]]:
    """Return the answers of an earlier run; empty if there are none."""
    try:
        answers: list[dict[str, Any]] = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return []
    return answers


def _page(results: dict[Task, list[dict[str, Any]]], named: Sequence[str]) -> Iterator[str]:
    """Yield the lines of the page."""
    yield "# Clients"
    yield ""
    yield (
        f"What simulators, validators and converters make of the exports of artgen {__version__}, every "
        "fifth on a free base, every fourth without maps. Written by `make client-table`; do not edit it."
    )
    yield ""
    yield "The clients have read these categories:"
    yield ""
    for letter, names in zip(ascii_uppercase, _sets(results), strict=False):
        yield f"- {letter}, {len(names)} of {len(named)}: {', '.join(names)}"
    yield from ("", EARLIER, "")
    yield (
        "A client passes an export if it reads it without a message that could be avoided, ends of itself, "
        "and what it says of masses, centers, inertias, joints, limits, gains, couplings and frames of links "
        "at five poses agrees with `asset.json`; a simulator also has to move each free joint within its "
        "limits."
    )
    for layout in LAYOUTS:
        yield from _table(layout, results)
    yield from _tolerances(results)
    yield from _tolerated(results)
    yield from ("", "## What to know of a client", "")
    yield from (f"- {name}: {text}." for name, text in KNOWN)
    yield from _not_run(results)


def _sets(results: dict[Task, list[dict[str, Any]]]) -> list[tuple[str, ...]]:
    """Return the sets of categories that clients have read in some layout, the largest first."""
    read: dict[tuple[Client, str], set[str]] = {}
    for task in results:
        read.setdefault((task.client, task.layout), set()).add(task.category)
    return sorted({tuple(sorted(names)) for names in read.values()}, key=lambda names: (-len(names), names))


def _table(layout: str, results: dict[Task, list[dict[str, Any]]]) -> Iterator[str]:
    """Yield the table of a layout, a row for each client; nothing for a layout that no client has read."""
    sets = _sets(results)
    of_layout = {task: found for task, found in results.items() if task.layout == layout}
    if not of_layout:
        return
    yield from ("", f"## Layout `{layout}`", "")
    yield "| client | version | reads | categories | seeds | passed |"
    yield "| --- | --- | --- | --- | --- | --- |"
    for client in dict.fromkeys(task.client for task in of_layout):
        rows = {task.category: found for task, found in of_layout.items() if task.client is client}
        found = [each for row in rows.values() for each in row]
        version = next((each["version"] for each in found if each["version"]), "")
        read = ascii_uppercase[sets.index(tuple(sorted(rows)))]
        counts = sorted({len(row) for row in rows.values()})
        seeds = " or ".join(f"0 to {count - 1}" if count > 1 else "0" for count in counts)
        yield f"| {client.name} | {version} | {client.format} | {read} | {seeds} | {_cell(found)} |"


def _cell(found: Sequence[dict[str, Any]]) -> str:
    """Return how many exports a client passes, and the first finding in each other one."""
    states = Counter(each["state"] for each in found)
    if states["absent"]:
        return "absent"
    others = (each for each in found if each["state"] != "passed")
    texts = [f"{each['asset']} {each['state']}: {escaped(each['message'])}" for each in others]
    return "; ".join([f"{states['passed']} of {len(found)}", *texts])


def _tolerances(results: dict[Task, list[dict[str, Any]]]) -> Iterator[str]:
    yield from ("", "## What is compared, and how closely", "")
    yield "| client | must tell | positions, limits [m, rad] | masses, moments, gains, relative |"
    yield "| --- | --- | --- | --- |"
    for client in dict.fromkeys(task.client for task in results):
        if client.reports:
            reports = ", ".join(client.reports)
            yield (f"| {client.name} | {reports} | {client.tolerances[0]:g} | {client.tolerances[1]:g} |")


def _tolerated(results: dict[Task, list[dict[str, Any]]]) -> Iterator[str]:
    """Yield the messages that no asset can avoid and that occurred."""
    rows: dict[tuple[str, str], str] = {}
    for task, found in results.items():
        for each in found:
            for message in each["tolerated"]:
                rows.setdefault((task.client.name, message["reason"]), message["message"])
    yield from (
        "",
        "## Messages that no asset can avoid",
        "",
        "| client | message | reason |",
        "| --- | --- | --- |",
    )
    for (client, reason), message in sorted(rows.items()):
        yield f"| {client} | {escaped(_placeless(message))} | {reason} |"


def _placeless(message: str) -> str:
    """Return a message without the folders of this machine."""
    words = [word.rpartition("/")[2] if word.count("/") > 2 else word for word in message.split()]
    return " ".join(words)[:240]


def _not_run(results: dict[Task, list[dict[str, Any]]]) -> Iterator[str]:
    yield from ("", "## What did not run, and why", "")
    absent = {
        task.client: found[0]["message"] for task, found in results.items() if found[0]["state"] == "absent"
    }
    for client, message in absent.items():
        yield f"- {client.name}: {escaped(message)}"
    for client in CLIENTS.values():
        if client not in absent and not any(task.client is client for task in results):
            yield f"- {client.name}: it was not run"
    for name, reason in ELSEWHERE:
        yield f"- {name}: {reason}"


if __name__ == "__main__":
    typer.run(main)
