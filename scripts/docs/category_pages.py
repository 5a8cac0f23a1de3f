"""The pages of the categories: parameters, joints, and sources of the sizes."""

import importlib
import json
import re
from collections.abc import Iterator
from dataclasses import dataclass

from gallery_page import SEEDS as SHOWN
from gallery_page import viewer_of
from surveys.pages import escaped

from artgen import _disk_cache as disk_cache
from artgen.asset import AssetJoint
from artgen.catalog import find
from artgen.generator import Generator
from artgen.sampling import Distribution
from artgen.sampling.choices import By, Choice
from artgen.sampling.distributions import Fixed, LogUniform, Normal, shown

FOLDER = "categories"
SEEDS = 6
"""How many seeds of a category its joints are counted over."""

_SOURCES = re.compile(r"\b(Sizes|Constructions) (of|are those)\b")  # begins what says where numbers are from
_NUMBER = re.compile(r"_\d+(?=_|$)")  # what copies of a joint differ in
_UNITS = {"revolute": "rad", "prismatic": "m"}
_FREE = 1e-9


@dataclass
class Row:
    """A joint of a category, or several joints whose names differ by a number.

    Attributes:
        kind: Revolute or prismatic.
        seeds: Number of seeds that have it.
        most: Largest number of them in an asset.
        low: Lowest position over all [rad or m]; None for one without limits.
        high: Highest position.
        follows: Whether it is coupled to another joint.
        waits: Whether it depends on another joint.
    """

    kind: str
    seeds: int = 0
    most: int = 0
    low: float | None = None
    high: float | None = None
    follows: bool = False
    waits: bool = False

    def add(self, joints: list[AssetJoint]) -> None:
        """Count what one asset has of it."""
        self.seeds += 1
        self.most = max(self.most, len(joints))
        for joint in joints:
            self.follows |= joint.follows is not None
            self.waits |= joint.needs is not None
            if joint.limits is not None:
                low, high = joint.limits
                self.low = low if self.low is None else min(self.low, low)
                self.high = high if self.high is None else max(self.high, high)


def rows(category: str, seeds: int, digest: str) -> dict[str, Row]:
    """Return the joints of a category by name, with `<n>` for numbers; cached by `digest`."""
    key = f"{category}_{seeds}_{digest}"
    cached = disk_cache.read("docs_joints", key)
    if cached is not None:
        return {name: Row(**row) for name, row in json.loads(cached).items()}
    found: dict[str, Row] = {}
    for seed in range(seeds):
        groups: dict[str, list[AssetJoint]] = {}
        for joint in find(category).generate(seed, certify=False).joints:
            groups.setdefault(_NUMBER.sub("_<n>", joint.name), []).append(joint)
        for name, joints in groups.items():
            found.setdefault(name, Row(joints[0].kind)).add(joints)
    ordered = dict(sorted(found.items(), key=lambda item: (-item[1].seeds, item[0])))
    text = json.dumps({name: vars(row) for name, row in ordered.items()})
    disk_cache.write("docs_joints", key, text.encode())
    return ordered


def title_of(category: str) -> str:
    """Return the name of a category as a heading."""
    return category.replace("_", " ").capitalize()


def paragraphs(category: str) -> tuple[str, list[str], list[str]]:
    """Return the first line of a category's docstring, its description, and the source of its numbers."""
    text = importlib.import_module(find(category).function.__module__).__doc__ or ""
    first, *rest = (paragraph.replace("\n", " ") for paragraph in text.strip().split("\n\n"))
    about: list[str] = []
    sources: list[str] = []
    for paragraph in rest:
        begin = _SOURCES.search(paragraph)
        start = begin.start() if begin else len(paragraph)
        about.append(paragraph[:start].strip())
        sources.append(paragraph[start:].strip())
    return first, [each for each in about if each], [each for each in sources if each]


def written(category: str, joints: dict[str, Row], seeds: int) -> str:
    """Return the page of a category, in Markdown."""
    return "\n".join(_lines(find(category), joints, seeds)) + "\n"


def _lines(category: Generator, joints: dict[str, Row], seeds: int) -> Iterator[str]:
    name = category.name
    first, about, sources = paragraphs(name)
    yield from (f"# {title_of(name)}", "", first, "")
    sheet = f"../{name}.jpg"
    yield from (f"[![Twelve seeds of {name}, closed, open and from behind]({sheet})]({sheet})", "")
    yield from (
        f"[Open seed {SHOWN.get(name, 0)} in the viewer](../{viewer_of(name)}){{ .md-button target=_blank }}",
        "",
    )
    yield from ("```python", "import artgen", "", f'asset = artgen.generate("{name}", seed=0)', "```", "")
    yield from ("## What it is", "")
    for paragraph in about:
        yield from (escaped_text(paragraph), "")
    yield from _parameters(category)
    yield from _joints(joints, seeds)
    labels = ", ".join(f"`{label}`" for label in category.labels)
    yield from ("## Labels", "", f"Semantic labels of its parts: {labels}.", "")
    yield from ("## Sizes and sources", "")
    for paragraph in sources:
        yield from (escaped_text(paragraph), "")


def _parameters(category: Generator) -> Iterator[str]:
    found = category.parameters()
    yield from (
        "## Parameters",
        "",
        (
            f"{len(found)} parameters. *Limits* are what an override must keep; without them any value"
            " is tried. See [Parameters and sampling](../parameters.md)."
        ),
        "",
        "| parameter | drawn from | unit | limits | what it is |",
        "| --- | --- | --- | --- | --- |",
    )
    for name, parameter in found.items():
        drawn = parameter.distribution
        limits = "" if drawn.within is None else "{:g} to {:g}".format(*drawn.within)
        yield f"| `{name}` | {described(drawn)} | {drawn.unit} | {limits} | {escaped(drawn.doc)} |"
    yield ""


def _joints(joints: dict[str, Row], seeds: int) -> Iterator[str]:
    yield from (
        "## Joints",
        "",
        (
            f"Counted over seeds 0 to {seeds - 1}: in how many of them a joint is, how many of it an "
            "asset has at most, and the lowest and highest limit that occurred."
        ),
        "",
        "| joint | kind | seeds | at most | limits | |",
        "| --- | --- | ---: | ---: | --- | --- |",
    )
    for name, row in joints.items():
        notes = [
            note
            for note, holds in (("follows another", row.follows), ("waits for another", row.waits))
            if holds
        ]
        yield (f"| `{name}` | {row.kind} | {row.seeds} | {row.most} | {_limits(row)} | {', '.join(notes)} |")
    yield ""


def _limits(row: Row) -> str:
    if row.low is None or row.high is None:
        return "those of what it follows" if row.follows else "none"
    return f"{_short(row.low)} to {_short(row.high)} {_UNITS[row.kind]}"


def _short(number: float) -> str:
    return "0" if abs(number) < _FREE else f"{number:.3g}"


def described(distribution: Distribution) -> str:
    """Describe the distribution of a parameter for a cell of a table."""
    if isinstance(distribution, By):
        cases = [f"<li>{_case(key)}: {described(case)}</li>" for key, case in distribution.cases]
        return f"by `{distribution.parameter}`<ul>{''.join(cases)}</ul>"
    if isinstance(distribution, Choice):
        return _options(distribution)
    if isinstance(distribution, Fixed):
        return f"always {_option(distribution.value)}"
    low, high = distribution.support()
    if isinstance(distribution, Normal):
        spread = f"around {distribution.mean:g} ± {distribution.deviation:g}"
        return f"{low:g} to {high:g}, {spread}"
    return f"{low:g} to {high:g}" + (", even in ratio" if isinstance(distribution, LogUniform) else "")


def _options(drawn: Choice) -> str:
    numbers = [option for option in drawn.options if isinstance(option, int) and not isinstance(option, bool)]
    plain = drawn.weights is None
    if (
        plain
        and len(numbers) == len(drawn.options) > 2
        and numbers == list(range(numbers[0], numbers[-1] + 1))
    ):
        return f"{numbers[0]}, {numbers[0] + 1} ... {numbers[-1]}"
    if plain:
        return ", ".join(map(_option, drawn.options))
    total = sum(drawn.weights or ())
    shares = [100.0 * weight / total for weight in drawn.weights or ()]
    return ", ".join(
        f"{_option(each)} {share:.0f}%" for each, share in zip(drawn.options, shares, strict=True)
    )


def _option(value: object) -> str:
    return escaped(value if isinstance(value, str) else shown(value))


def _case(key: object) -> str:
    return "otherwise" if key == "otherwise" else f"`{key}`"


def escaped_text(text: str) -> str:
    """Return a paragraph of a docstring as Markdown; text that looks like a tag is escaped."""
    parts = re.split(r"(`[^`]*`)", text)
    return "".join(each if each.startswith("`") else each.replace("<", "&lt;") for each in parts)
