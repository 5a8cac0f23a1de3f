"""Check that seeds of each category fit its recorded topology and form one group, or record topologies.

python scripts/topologies.py drawer lamp
python scripts/topologies.py toaster --write

`generate(..., topology="fixed")` pads assets to the topology that is recorded beside the category. After a
change of a category that adds links, joints or colliders, `--write` records the topology of its seeds.
"""

import time
from collections.abc import Iterator
from typing import Annotated, get_args

import typer

from artgen.asset import Asset
from artgen.asset.asset import DetailName
from artgen.batch import Rule, groups
from artgen.catalog import categories, find
from artgen.errors import AssetError
from artgen.graph import Cache
from artgen.topology import Topology

ROOM = 0.05  # more colliders than those of the seeds, as a share: for other seeds


def main(
    names: Annotated[list[str] | None, typer.Argument(metavar="[CATEGORY]...")] = None,
    *,
    seeds: Annotated[int, typer.Option(min=1, help="Number of seeds.")] = 1000,
    write: Annotated[bool, typer.Option(help="Record topologies instead of checking them.")] = False,
) -> None:
    """Print the groups of the padded seeds of each category; exit code 1 if there is more than one."""
    wrong = False
    for name in names or categories():
        start = time.process_time()
        if write:
            topology = Topology.of(Topology.of([asset]) for asset in _assets(name, seeds)).with_room(ROOM)
            topology.save(find(name).topology_file)
            found = str(topology)
        else:
            lost, counts = _groups(name, seeds)
            wrong |= bool(lost) or set(counts.values()) != {1}
            found = ", ".join(f"{rule}: {count}" for rule, count in counts.items())
            found = "\n  ".join([f"groups {found}", *lost])
        typer.echo(f"{name}, {seeds} seeds, {time.process_time() - start:.0f} s: {found}")
    if wrong:
        raise typer.Exit(1)


def _assets(name: str, seeds: int) -> Iterator[Asset]:
    """Yield the seeds of a category at full detail, and a tenth of them at the other levels."""
    levels: dict[DetailName, int] = {"full": seeds, "medium": seeds // 10, "low": seeds // 10}
    for detail, count in levels.items():
        cache = Cache()
        for seed in range(count):
            yield find(name).generate(seed, cache=cache, certify=False, detail=detail)


def _groups(name: str, seeds: int) -> tuple[list[str], dict[str, int]]:
    """Return the messages of seeds that do not fit, and the numbers of groups of the others by rule."""
    topology, lost = Topology.load(find(name).topology_file), []
    first: dict[str, list[Asset]] = {rule: [] for rule in get_args(Rule)}  # of each group
    for asset in _assets(name, seeds):
        try:
            padded = topology.pad(asset)
        except AssetError as error:
            lost.append(str(error))
            continue
        for rule, assets in first.items():
            first[rule] = [group[0] for group in groups([*assets, padded], rule)]
    return lost, {rule: len(assets) for rule, assets in first.items()}


if __name__ == "__main__":
    typer.run(main)
