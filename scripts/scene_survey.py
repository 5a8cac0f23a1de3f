"""Draw rooms of several seeds at low detail, examine each, and write what was found as a table.

python scripts/scene_survey.py --seeds 12 --states 100 --validated 2 --out out/scenes.jsonl

Each room is read back from its files. Its exact solids are intersected in random valid states; it is
simulated for 1 s and watched for 3 s, in which no body may move by more than 50 mm and no joint by more than
a tenth of its range; and the forces at the handles of its joints are compared with 20 N: the bounds of
MolmoSpaces. A whole validation takes longer than a draw, so that only the first seeds are validated. Records
stay in the file, so that an interrupted survey continues. The table is Markdown, for docs/scenes.md.
"""

import json
import statistics
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer

from artgen.asset import Asset
from artgen.errors import ArtgenError
from artgen.scene import ROOMS
from artgen.validate import validate
from artgen.validate.hands.motion import hand_forces
from artgen.validate.room import LIGHT_FORCE, motions_at_rest, overlaps

_COLUMNS = (
    "room", "seeds", "first draw", "later draw", "refused", "s", "joints", "m2", "triangles",
    "states", "overlaps", "moved", "over 20 N", "validated", "faults", "s",
)  # fmt: skip


def main(
    kinds: Annotated[list[str] | None, typer.Argument(help="Kinds of rooms; all by default.")] = None,
    *,
    seeds: Annotated[int, typer.Option(min=1, help="Number of seeds of each kind.")] = 12,
    first_seed: Annotated[int, typer.Option(min=0, help="The first seed.")] = 0,
    states: Annotated[int, typer.Option(min=0, help="Random states in which solids are intersected.")] = 100,
    validated: Annotated[int, typer.Option(min=0, help="Number of seeds that are also validated.")] = 2,
    out: Annotated[Path, typer.Option(help="File of records.")] = Path("out/scenes.jsonl"),
) -> None:
    """Measure rooms, one seed of each kind after the other, and print the table and each fault."""
    out.parent.mkdir(parents=True, exist_ok=True)
    records = [json.loads(line) for line in out.read_text().splitlines()] if out.exists() else []
    known = {(each["kind"], each["seed"]) for each in records}
    for seed in range(first_seed, first_seed + seeds):
        for kind in kinds or ROOMS:
            if (kind, seed) not in known:
                records.append(measured(kind, seed, states, checked=seed < first_seed + validated))
                with out.open("a", encoding="utf-8") as file:
                    file.write(json.dumps(records[-1]) + "\n")
    typer.echo(table(records))
    for each in records:
        for fault in each.get("faults", filter(None, [each.get("error")])):
            typer.echo(f"{each['kind']} {each['seed']}: {fault}", err=True)


def measured(kind: str, seed: int, states: int, *, checked: bool) -> dict[str, Any]:
    """Return the measurements of one room as JSON data, with all its faults if it is checked."""
    result: dict[str, Any] = {"kind": kind, "seed": seed}
    start = time.process_time()
    try:
        room = ROOMS[kind].generate(seed, detail="low")
    except ArtgenError as error:
        return result | {"seconds": time.process_time() - start, "error": str(error)}
    result["seconds"] = time.process_time() - start
    width, depth, _ = np.ptp(room.links[0].bounds(), axis=0)
    result |= {
        "attempt": room.attempt,
        "joints": len(room.free_joints),
        "area": float(width * depth),
        "triangles": sum(len(each.mesh.triangles) for link in room.links for each in link.surfaces),
    }
    with tempfile.TemporaryDirectory() as name:
        folder = room.export(Path(name) / room.name, textures=0)
        loaded = Asset.load(folder)
        overlap, moved = list(overlaps(loaded, states)), list(motions_at_rest(loaded))
        forces = hand_forces(loaded)
        result |= {
            "states": states,
            "overlaps": len(overlap),
            "moved": len(moved),
            "heavy": {joint: force for joint, force in forces.items() if force > LIGHT_FORCE},
            "faults": [f"{each.check}: {each}" for each in (*overlap, *moved)],
        }
        if checked:
            start = time.process_time()
            report = validate(folder)
            result["validate"] = time.process_time() - start
            result["faults"] = [f"{check.check}: {each}" for check in report.results for each in check.faults]
    return result


def table(records: Sequence[dict[str, Any]]) -> str:
    """Return one row for each kind: numbers of draws and faults, medians of times, ranges of sizes."""
    lines = [f"| {' | '.join(_COLUMNS)} |", f"|{' --- |' * len(_COLUMNS)}"]
    for kind in sorted({each["kind"] for each in records}):
        rows = [each for each in records if each["kind"] == kind]
        made = [each for each in rows if "attempt" in each]
        first = sum(each["attempt"] == 0 for each in made)
        cells = [kind, *map(str, (len(rows), first, len(made) - first, len(rows) - len(made)))]
        cells.append(_median(rows, "seconds"))
        for name in ("joints", "area", "triangles"):
            found = [each[name] for each in made]
            cells.append(f"{min(found):.0f} to {max(found):.0f}" if found else "")
        cells += [str(sum(each[name] for each in made)) for name in ("states", "overlaps", "moved")]
        cells.append(str(sum(len(each["heavy"]) for each in made)))
        checked = [each for each in made if "validate" in each]
        cells += [str(len(checked)), str(sum(len(each["faults"]) for each in checked))]
        cells.append(_median(checked, "validate"))
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines)


def _median(rows: Sequence[dict[str, Any]], name: str) -> str:
    return f"{statistics.median(each[name] for each in rows):.0f}" if rows else ""


if __name__ == "__main__":
    typer.run(main)
