"""The result of a benchmark: tables, the comparison, and findings."""

import sys
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from rich import box
from rich.console import Console, Group, RenderableType
from rich.markup import escape
from rich.table import Table as RichTable
from rich.text import Text

sys.path.append(str(Path(__file__).parents[1] / "scripts"))

from surveys.pages import escaped

Cell = str | float | int | bool | None

_NOTHING = ""
_DIGITS = 3  # significant ones


@dataclass(frozen=True)
class Table:
    """Rows of one comparison.

    Attributes:
        title: Its title.
        columns: Heading of each column, with units; the first one names the row.
        rows: Cells; a number is shown with three digits, None if nothing was measured.
    """

    title: str
    columns: Sequence[str]
    rows: Sequence[Sequence[Cell]]

    def __post_init__(self) -> None:
        """Check the number of cells of each row.

        Raises:
            ValueError: A row has more or fewer cells than there are columns.
        """
        for row in self.rows:
            if len(row) != len(self.columns):
                raise ValueError(
                    f"table {self.title!r} has {len(self.columns)} columns, but the row of {row[0]!r} has "
                    f"{len(row)} cells; give one for each column"
                )


@dataclass(frozen=True)
class Section:
    """One benchmark.

    Attributes:
        title: Its heading.
        compared: Description of the comparison.
        tables: The measurements.
        findings: Conclusions, generated from the numbers.
        versions: Versions of packages of another environment, by name.
    """

    title: str
    compared: str
    tables: Sequence[Table]
    findings: Sequence[str]
    versions: dict[str, str] = field(default_factory=dict)


def shown(cell: Cell) -> str:
    """Format a cell: a number with three digits, without powers of ten for common sizes."""
    if cell is None:
        return _NOTHING
    if isinstance(cell, bool):
        return "yes" if cell else "no"
    if isinstance(cell, str | int):
        return str(cell)
    if abs(cell) >= 10.0**_DIGITS:
        return f"{cell:.0f}" if abs(cell) < 1e9 else f"{cell:.1e}"
    return f"{cell:.{_DIGITS}g}" if abs(cell) >= 1e-4 or cell == 0.0 else f"{cell:.1e}"


def flowing(text: str) -> str:
    """Return text on one line, without its line breaks."""
    return " ".join(text.split())


def span(values: Sequence[float]) -> str:
    """Format the smallest and the largest of some values."""
    low, high = shown(min(values)), shown(max(values))
    return low if low == high else f"{low} to {high}"


def show(console: Console, name: str, section: Section) -> None:
    """Print a section."""
    parts: list[RenderableType] = [Text(f"{name}: {section.title}", style="bold")]
    parts.append(Text(flowing(section.compared)))
    for table in section.tables:
        drawn = RichTable(title=escape(table.title), title_justify="left", box=box.SIMPLE_HEAD)
        for number, column in enumerate(table.columns):
            drawn.add_column(escape(column), justify="right" if number else "left")
        for row in table.rows:
            drawn.add_row(*(escape(shown(cell)) for cell in row))
        parts.append(drawn)
    parts += [Text(f"- {finding}") for finding in section.findings]
    console.print(Group(*parts, ""), highlight=False)


def markdown(section: Section) -> list[str]:
    """Return the lines of a section's text and tables."""
    lines = [flowing(section.compared)]
    for table in section.tables:
        lines += ["", f"**{table.title}**", "", _line(table.columns)]
        lines.append(_line(["---", *("---:" for _ in table.columns[1:])]))
        lines += [_line([escaped(shown(cell)) for cell in row]) for row in table.rows]
    return [*lines, "", *(f"- {finding}" for finding in section.findings)]


def _line(cells: Sequence[str]) -> str:
    return f"| {' | '.join(cells)} |"
