"""Commands that describe categories: `artgen list` and, for one category, `artgen info`."""

import sys
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from rich.console import Console
from rich.padding import Padding
from rich.table import Table
from rich.text import Text
from typer import Argument, Option

from artgen.asset.summary import facts
from artgen.catalog import broken, categories, find, rooms
from artgen.commands.console import console, table
from artgen.commands.options import Category, Seed
from artgen.errors import ParameterError, nearest
from artgen.generator import Fixed, Generator, Parameter
from artgen.sampling import Distribution
from artgen.sampling.choices import OTHERWISE, By
from artgen.sampling.distributions import LogUniform, Normal, shown

if TYPE_CHECKING:
    from artgen.view.picture import Pixels

_PLAIN_WIDTH = 110  # columns in files and pipes
_PICTURE = 56  # columns of a picture in a terminal
_SAMPLE = 3  # facts of the sample: size, links, joints


def list_categories() -> None:
    """List the categories, and the rooms that `artgen scene` furnishes."""
    for message in broken().values():
        typer.echo(f"warning: {' '.join(message.split())}", err=True)
    result = table("category", "what it is", "joints", "parameters", "labels")
    for name in categories():
        category = find(name)
        joints = "" if category.joints is None else "-".join(map(str, dict.fromkeys(category.joints)))
        result.add_row(
            name, _first_line(category), joints, str(len(category.parameters())), ", ".join(category.labels)
        )
    console().print(result)
    typer.echo(f"rooms: {', '.join(rooms())}")


def _first_line(category: Generator) -> str:
    return (category.__doc__ or "").strip().partition("\n")[0]


def info(
    category: Category,
    word: Annotated[
        str | None,
        Argument(metavar="WORD", help="Only parameters with this word in their name or description."),
    ] = None,
    *,
    seed: Seed = 0,
    picture: Annotated[
        Path | None, Option(metavar="FILE", help="PNG or JPEG file for a picture of the sample.")
    ] = None,
) -> None:
    """Show a category: its parameters with ranges and probabilities, and a sample with its joints.

    A terminal with true colors shows the sample as well.
    """
    found = find(category)
    width = None if sys.stdout.isatty() else _PLAIN_WIDTH
    output = Console(width=width, highlight=False, markup=False)
    if word is None:
        _print_sample(found, seed, picture, output)
    elif picture is not None:
        raise ParameterError("--picture is a picture of the sample; leave the WORD out")
    parameters = found.parameters()
    chosen = {name: each for name, each in parameters.items() if _matches(each, word or "")}
    if not chosen:
        raise ParameterError(
            f"{found.name} has no parameter with {word!r} in its name or description."
            f"{nearest(word or '', parameters)}"
        )
    leading = {
        f"{name.rpartition('.')[0]}.{needed}".lstrip(".")
        for name, each in parameters.items()
        for needed in each.distribution.needs()
    }
    for title, styles in (("styles, on which other draws depend", True), ("parameters", False)):
        rows = {name: each for name, each in chosen.items() if (name in leading) == styles}
        if rows:
            output.print(Text(f"{title}:", "bold"))
            output.print(Padding(_parameter_table(rows), (0, 0, 1, 2)))


def _print_sample(category: Generator, seed: int, picture: Path | None, output: Console) -> None:
    """Print name, labels and one sample of a category; draw the sample."""
    from artgen.export.thumbnail import thumbnail
    from artgen.view.picture import check_suffix, save_image

    if picture is not None:
        check_suffix(picture)
    output.print(Text(category.name, "bold").append(f"  {_first_line(category)}", "not bold"))
    asset, _ = category.evaluate(seed, certify=False)
    drawn = output.is_terminal and output.color_system == "truecolor"
    if picture is not None or drawn:
        pixels = thumbnail(asset)
        if drawn:
            output.print(_blocks(pixels))
        if picture is not None:
            typer.echo(save_image(pixels, picture))
    grid = Table.grid(padding=(0, 2))
    grid.add_row("labels", ", ".join(category.labels))
    if category.joints is not None:
        grid.add_row("joints", " to ".join(map(str, dict.fromkeys(category.joints))))
    grid.add_row("sample", f"seed {seed}")
    for name, lines in facts(asset)[:_SAMPLE]:
        grid.add_row(f"  {name}", "\n".join(lines))
    output.print(Padding(grid, (0, 0, 1, 0)))


def _blocks(pixels: "Pixels") -> Text:
    """Return a picture as text, two pixels above each other in each character."""
    import numpy as np
    from PIL import Image

    small = np.asarray(Image.fromarray(pixels).resize((_PICTURE, _PICTURE)))
    text = Text()
    for upper, lower in zip(small[::2], small[1::2], strict=True):
        for (r, g, b), (red, green, blue) in zip(upper, lower, strict=True):
            text.append("\N{UPPER HALF BLOCK}", f"rgb({r},{g},{b}) on rgb({red},{green},{blue})")
        text.append("\n")
    return text


def _matches(parameter: Parameter, word: str) -> bool:
    return word.lower() in f"{parameter.name} {parameter.distribution.doc}".lower()


def _parameter_table(parameters: Mapping[str, Parameter]) -> Table:
    result = table("name", "drawn", "what it is")
    for name, parameter in parameters.items():
        made = parameter.distribution
        rows = drawn_rows(name, made)
        cell = Table.grid(padding=(0, 2))
        for row in rows:
            cell.add_row(*row)
        limits = (
            "" if made.within is None else f"({made.within[0]:g} to {made.within[1]:g}{_unit(made)} allowed)"
        )
        result.add_row(name, cell, " ".join(filter(None, [made.doc, limits])))
    return result


def drawn_rows(name: str, made: Distribution) -> list[tuple[str, ...]]:
    """Return the values of a parameter with their probabilities, in a row for each condition.

    A row is `("layout=french", "0.83 to 0.92 m")`; for a yes or no, `("P(water | layout=french)", "= 0.5")`.
    """
    short, yes = name.rpartition(".")[2], all(type(item) is bool for item in made.support())
    together: dict[str, list[str]] = {}  # conditions by their values
    for condition, leaf in _cases(made):
        together.setdefault(_values(leaf, _unit(made), probability=yes), []).append(condition)
    rows: list[tuple[str, ...]] = []
    for values, conditions in together.items():
        condition = " or ".join(dict.fromkeys(conditions))
        if yes:
            rows.append((f"P({short}{' | ' if condition else ''}{condition})", values))
        else:
            always = "always " * isinstance(made, Fixed)
            rows.append((condition, values) if condition else (f"{always}{values}",))
    return rows


def _cases(made: Distribution, before: str = "") -> list[tuple[str, Distribution]]:
    """Return the leaves of a distribution, each with the condition under which it is drawn."""
    if not isinstance(made, By):
        return [(before, made)]
    result = []
    for key, case in made.cases:
        own = OTHERWISE if key == OTHERWISE else f"{made.parameter}={_item(key)}"
        result += _cases(case, ", ".join(filter(None, [before, own])))
    return result


def _unit(made: Distribution) -> str:
    return f" {made.unit}".rstrip()


def _values(made: Distribution, unit: str, *, probability: bool) -> str:
    """Return the values of a distribution without conditions; of a yes or no, the probability of yes."""
    if not made.discrete:
        low, high = made.support()
        kind = {Normal: "normal in ", LogUniform: "log-uniform in "}.get(type(made), "")
        return f"{kind}{low:g} to {high:g}{unit}"
    if probability:
        return f"= {sum(share for item, share in made.shares() if item):.2g}"
    if isinstance(made, Fixed):
        return f"{_item(made.value)}{unit}"
    shares = made.shares()
    items = [item for item, _ in shares]
    if len({round(share, 6) for _, share in shares}) > 1:
        return ", ".join(f"{_item(item)} {share:.0%}" for item, share in shares) + unit
    if all(type(item) is int for item in items) and items == list(range(items[0], items[-1] + 1)):
        return f"{items[0]} to {items[-1]}{unit}"
    return " | ".join(map(_item, items)) + unit


def _item(item: Any) -> str:
    """Return an option as text; generators and materials by name, and an empty text as two quotes."""
    return item if isinstance(item, str) and item else shown(item)
