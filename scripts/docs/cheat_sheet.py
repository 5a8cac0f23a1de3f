"""Write docs/cheat_sheet.md: the signature and the first line of every node, by task.

python scripts/docs/cheat_sheet.py
"""

import inspect
import math
import sys
from collections.abc import Callable, Iterator
from fnmatch import fnmatch
from pathlib import Path
from typing import Any

sys.path.append(str(Path(__file__).parents[1]))

from node_examples import nodes
from node_pages import placed
from surveys.pages import escaped

import artgen
from artgen import feel, signals
from artgen.nodes.joint import Feel

PAGE = Path(__file__).parents[2] / "docs" / "cheat_sheet.md"

INTRO = """# Cheat sheet

Everything that a category is made of, after `import artgen as ag`: `ag.box(...)`, `ag.details.icon(...)`;
methods are written with their class. Lengths are metres, angles radians. `help(ag.box)` has arguments, errors
and an example. `python scripts/docs/cheat_sheet.py` writes this page from the code.
"""

SECTIONS = {  # title: introduction, and patterns of `page/node`; a node is in the first section with a match
    "Shapes": (
        "Solids are centered on the origin unless the line says otherwise.",
        "primitives/* swept/[!s]*",
    ),
    "Bending": ("A path in space, and a profile swept along it.", "swept/sweep paths/*"),
    "Profiles": (
        "A region of the plane, for `extrude`, `revolve`, `sweep` and `loft`; `a | b`, `a - b`, `a & b`.",
        "profiles/*",
    ),
    "Planning space": ("Boxes without surface, from which parts take sizes and places.", "regions/*"),
    "Measuring": (
        "The results are sockets, like every number of a category.",
        (
            "solids/*.anchor solids/*.size solids/*.bounds solids/*.centroid solids/*.volume solids/*.area "
            "bodies/*.mass bodies/*.center_of_mass"
        ),
    ),
    "Placing": (
        "In asset coordinates at rest: `solid.at(z=0.1)`. The front faces -Y, up is Z.",
        (
            "solids/*.at solids/*.rotate solids/*.scale solids/*.mirror solids/*.align solids/array "
            "bodies/*.at bodies/*.rotate bodies/*.mirror bodies/*.suffixed vectors/*"
        ),
    ),
    "Combining": (
        "`a | b` unites, `a - b` cuts, `a & b` keeps the overlap. [Colliders](colliders.md) follow.",
        "solids/*",
    ),
    "Links": (
        "`part` makes a link; the other calls add to it and join links.",
        "bodies/part bodies/weld bodies/Body.*",
    ),
    "Joints": (
        (
            "`follows=0.5 * turn` couples; `(turn > 0.6) & (slide < 0.01)` is for `needs=` and `when=`. "
            "[Springs, friction, effort](physics.md#joints)."
        ),
        "joints/*",
    ),
    "Hands": ("For `part(..., grasp=...)` and `part(..., push=...)`.", "bodies/frame bodies/*_on"),
    "Details": ("Only visible: no mass, no collider.", "bodies/detail print/* hardware/*"),
    "Fittings": (
        (
            "After `from artgen import fittings`: `panel.install(fittings.dial(), at=place)`. "
            "[Sizes and forces](fittings.md)."
        ),
        "fittings/*",
    ),
    "Numbers": (
        "Arithmetic and comparisons work as usual; these replace `if`, `min` and `math`.",
        "numbers/*",
    ),
}
_CHOICES = ("uniform", "truncated_normal", "loguniform", "choice", "count", "by", "one_of", "fixed", "given")
_MATERIALS = ("material", "colored", "shades", "Material.with_")
_SPELLED = {
    (1.0, 0.0, 0.0): "X",
    (0.0, 1.0, 0.0): "Y",
    (0.0, 0.0, 1.0): "Z",
    (0.0, -1.0, 0.0): "-Y",
    (0.0, 0.0, 0.0): "(0, 0, 0)",
    math.pi: "pi",
    1.5 * math.pi: "1.5 * pi",
    2.0 * math.pi: "2 * pi",
}


def drawn() -> str:
    """Return the page, in Markdown."""
    return "\n".join(_lines()) + "\n"


def _lines() -> Iterator[str]:
    yield INTRO
    found = by_section()
    for title, (intro, _) in SECTIONS.items():
        yield from _section(title, intro, found[title])
    named = [(name, _named(name)) for name in _MATERIALS]
    yield from _section(
        "Materials", "The third argument of `part`. [Materials and details](materials.md).", named
    )
    yield from (f"Names: {', '.join(f'`{name}`' for name in artgen.MATERIALS)}.", "")
    presets = [name for name, value in vars(feel).items() if isinstance(value, Feel)]
    yield from (
        f"Presets of joints (`feel=ag.feel.HINGE`): {', '.join(f'`{name}`' for name in presets)}.",
        "",
    )
    named = [(f"signals.{name}", getattr(signals, name)) for name in signals.__all__ if name != "Signal"]
    yield from _section(
        "Signals", "For `body.output(...)`: `a & b`, `a | b`, `~a`, `0.5 * a`. [Outputs](outputs.md).", named
    )
    named = [(name, _named(name)) for name in _CHOICES]
    yield from _section("Choices", "Defaults of parameters. [Sampling](parameters.md).", named)


def by_section() -> dict[str, list[tuple[str, Any]]]:
    """Return the nodes of each section; LookupError if a node is in none."""
    made = dict(nodes())
    found: dict[str, list[tuple[str, Any]]] = {title: [] for title in SECTIONS}
    for page, examples in placed().items():
        for name in (each.name for each in examples if signature(each.name, made[each.name])):
            title = next((title for title in SECTIONS if _has(title, f"{page}/{name}")), None)
            if title is None:
                raise LookupError(
                    f"no section of the cheat sheet has {page}/{name}; add a pattern to SECTIONS"
                )
            if not name.startswith("Dependency."):  # the same as those of a condition
                found[title].append((name, made[name]))
    return found


def _has(title: str, node: str) -> bool:
    return any(fnmatch(node, pattern) for pattern in SECTIONS[title][1].split())


def _named(name: str) -> Any:
    made: Any = artgen
    for part in name.split("."):
        made = getattr(made, part)
    return made


def _section(title: str, intro: str, rows: list[tuple[str, Any]]) -> Iterator[str]:
    yield from (f"## {title}", "", intro, "", "| call | |", "| --- | --- |")
    for name, made in rows:
        first = inspect.getdoc(made).partition("\n\n")[0].replace("\n", " ")  # type: ignore[union-attr]
        yield f"| `{signature(name, made)}` | {escaped(first)} |"
    yield ""


def signature(name: str, made: Callable[..., Any]) -> str:
    """Return a call with names and defaults; empty for a handle, which operations make, not calls."""
    parameters = [each for each in inspect.signature(made).parameters.values() if each.name != "self"]
    if [each.name for each in parameters] == ["node"]:
        return ""
    listed = [
        str(each.replace(annotation=each.empty, default=each.empty)) + _default(each) for each in parameters
    ]
    keywords = [number for number, each in enumerate(parameters) if each.kind is each.KEYWORD_ONLY]
    if keywords and not any(each.kind is each.VAR_POSITIONAL for each in parameters):
        listed.insert(keywords[0], "*")
    return f"{name}({', '.join(listed)})"


def _default(parameter: inspect.Parameter) -> str:
    value = parameter.default
    if value is parameter.empty:
        return ""
    if isinstance(value, artgen.Material | Feel):
        return f"={getattr(value, 'name', '...')}"
    if isinstance(value, float) and value not in _SPELLED:
        return f"={value:g}"
    return f"={_SPELLED[value] if isinstance(value, float | tuple) and value in _SPELLED else repr(value)}"


if __name__ == "__main__":
    PAGE.write_text(drawn(), encoding="utf-8")
