"""Compare the files of an asset of each category, flat and in one other layout, with recorded hashes.

The same seed gives the same bytes on every machine and Python; `tests/tree_hashes.json` holds their hashes.
After an intended change of assets, `--write` records the new hashes.
"""

import hashlib
import json
from pathlib import Path
from typing import Annotated, Any
from zlib import crc32

import typer

from artgen.catalog import categories, find
from artgen.export.files import encode
from artgen.export.layouts import LAYOUTS
from artgen.graph import Cache

RECORD = Path(__file__).parents[1] / "tests" / "tree_hashes.json"
SEED = 0
DIGITS = 16


def main(
    names: Annotated[list[str] | None, typer.Argument(metavar="[CATEGORY]...")] = None,
    *,
    share: Annotated[str, typer.Option(help="The share of the categories that is made.")] = "1/1",
    write: Annotated[bool, typer.Option(help="Record the hashes instead of comparing them.")] = False,
) -> None:
    """Generate, certify and write assets, and say which of their files differ from the record."""
    number, shares = map(int, share.split("/"))
    known = json.loads(RECORD.read_text(encoding="utf-8")) if RECORD.exists() else {}
    found = dict(hashes(category) for category in (names or categories())[number - 1 :: shares])
    if write:
        record = dict(sorted((known | found).items()))
        RECORD.write_text(json.dumps(record, indent=1) + "\n", encoding="utf-8")
        return
    different = {
        name: [kind for kind, each in kinds.items() if known.get(name, {}).get(kind) != each]
        for name, kinds in found.items()
    }
    for name, kinds in different.items():
        if kinds:
            typer.echo(f"{name}: not the same bytes as before: {', '.join(kinds)}", err=True)
    if any(different.values()):
        typer.echo(
            f"if that is meant, run: python scripts/tree_hashes.py {' '.join(names or ())} --write", err=True
        )
        raise typer.Exit(1)
    typer.echo(f"{len(found)} assets: the same bytes as before")


def hashes(category: str) -> tuple[str, dict[str, str]]:
    """Return the name of an asset, and hashes of its files by format or layout."""
    asset, _ = find(category).evaluate(SEED, cache=Cache(), keep_graph=True)
    # GLB packs maps as the machine does; the digests of other formats are of unpacked maps
    parts = [encode(asset, ("urdf", "mjcf", "usd"), textures=256), encode(asset, ("glb",), textures=0)]
    found = {name: each for files in parts for name, each in _of_formats(files).items()}
    others = [name for name in LAYOUTS if name not in ("flat", "parts")]  # parts has the files of flat
    layout = others[crc32(category.encode()) % len(others)]
    found[layout] = _hash(json.loads(encode(asset, textures=256, layout=layout)["asset.json"])["digests"])
    proven = asset.certify()
    found["certificate"] = _hash([proven.to_data(), proven.leaves])
    return asset.name, found


def _of_formats(files: dict[str, bytes]) -> dict[str, str]:
    data: dict[str, Any] = json.loads(files["asset.json"])
    digests, formats = data.pop("digests"), data.pop("formats")
    data.pop("version")
    listed = {name: {path: digests[path] for path in each["files"]} for name, each in formats.items()}
    return {name: _hash(each) for name, each in {**listed, "asset": data}.items()}


def _hash(data: Any) -> str:
    return hashlib.sha256(json.dumps(data, sort_keys=True).encode()).hexdigest()[:DIGITS]


if __name__ == "__main__":
    typer.run(main)
