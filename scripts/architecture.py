"""Draw the generated parts of docs/architecture.md from the code, and check the names on the page."""

import ast
import importlib
import re
import tomllib
from contextlib import suppress
from pathlib import Path

import grimp

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "docs" / "architecture.md"
PACKAGE = ROOT / "src" / "artgen"


def drawn(page: str) -> str:
    """Return the page with its generated parts drawn again.

    Raises:
        LookupError: The page names a module, class or function that does not exist.
    """
    for name in re.findall(r"`(artgen(?:\.\w+)*)`", page):
        _check(name)
    for mark, lines in (("layers", _layer_rows()), ("imports", ["```mermaid", *_arrows(), "```"])):
        part = "\n".join([f"<!-- {mark} -->", *lines, "<!-- end -->"])
        page = re.sub(rf"<!-- {mark} -->.*?<!-- end -->", lambda _, part=part: part, page, flags=re.DOTALL)
    return page


def layers() -> list[list[str]]:
    """Return the modules of each layer of import-linter's contract, from the top."""
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    contracts = settings["tool"]["importlinter"]["contracts"]
    (names,) = (each["layers"] for each in contracts if each["type"] == "layers")
    return [re.split(r"\s*\|\s*", layer.replace("artgen.", "")) for layer in names]


def _layer_rows() -> list[str]:
    """Return a table with a row for each module of each layer."""
    numbered = reversed(list(enumerate(reversed(layers()), 1)))
    rows = [f"| {number} | `{name}` | {_purpose(name)} |" for number, layer in numbered for name in layer]
    return ["| layer | module | purpose |", "| --- | --- | --- |", *rows]


def _purpose(name: str) -> str:
    """Return the first sentence of a module's docstring."""
    path = PACKAGE / name
    file = path / "__init__.py" if path.is_dir() else path.with_suffix(".py")
    text = ast.get_docstring(ast.parse(file.read_text(encoding="utf-8"))) or ""
    return re.split(r"(?<=\.)\s", text.replace("\n", " "))[0]


def _arrows() -> list[str]:
    """Return a flow chart with a line for each import between packages that others do not imply."""
    graph = grimp.build_graph("artgen", cache_dir=None)
    packages = [name for layer in layers() for name in layer if (PACKAGE / name).is_dir()]
    imported: dict[str, set[str]] = {}
    for package in packages:
        modules = {f"artgen.{package}", *graph.find_descendants(f"artgen.{package}")}
        targets = {target for each in modules for target in graph.find_modules_directly_imported_by(each)}
        imported[package] = {target.split(".")[1] for target in targets if target.startswith("artgen.")}
        imported[package] &= {*packages} - {package}
    return [
        "flowchart TD",
        *(
            f"    {package} --> {target}"
            for package in packages
            for target in sorted(imported[package])
            if not any(target in _reached(imported, other) for other in imported[package] - {target})
        ),
    ]


def _reached(imported: dict[str, set[str]], start: str) -> set[str]:
    """Return the packages that a package imports, directly or indirectly."""
    found: set[str] = set()
    waiting = [start]
    while waiting:
        new = imported[waiting.pop()] - found
        found |= new
        waiting += new
    return found


def _check(name: str) -> None:
    """Raise a LookupError if there is no module, class or function of a dotted name."""
    parts = name.split(".")
    for end in range(len(parts), 0, -1):
        with suppress(ImportError):
            found: object = importlib.import_module(".".join(parts[:end]))
            for part in parts[end:]:
                found = getattr(found, part, None)
            if found is not None:
                return
            break
    raise LookupError(f"{PAGE.name} names {name}, which does not exist")


if __name__ == "__main__":
    PAGE.write_text(drawn(PAGE.read_text(encoding="utf-8")), encoding="utf-8")
