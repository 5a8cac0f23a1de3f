"""The page of the documentation that says what categories draw."""

from collections.abc import Iterable, Iterator

from artgen.version import __version__
from surveys.coverage import BINS, Coverage, Options, Spread
from surveys.markdown import escaped


def coverage_page(found: Iterable[Coverage]) -> str:
    """Return the page, in Markdown."""
    every = list(found)
    seeds = f"seeds 0 to {every[0].seeds - 1}" if every else "no seeds"
    lines = [
        "# Coverage",
        "",
        (
            f"What the categories of artgen {__version__} draw: {seeds} of each, first draws, before "
            "requirements rule any out. Written by `make coverage-table`; do not edit it."
        ),
        "",
        (
            "Behind each option stands how often it was drawn. A range is reached where draws fall into it, "
            f"in {BINS} equal parts; where it depends on another parameter, each case has a row. Names are "
            "full: `handle.lever_handle.length` is a parameter of `lever_handle`, which the parameter "
            "`handle` may be; overrides may leave out the generator."
        ),
    ]
    for each in every:
        lines += _of_category(each)
    return "\n".join(lines) + "\n"


def _of_category(each: Coverage) -> Iterator[str]:
    options = [option for option in each.options.values() if option.varies]
    yield from ("", f"## {each.category}", "")
    missing = ", ".join(f"`{name}`" for name in each.missing) or "none"
    unfilled = "; ".join(each.unfilled) or "none"
    yield f"- {len(options)} parameters with options, {len(each.spreads)} ranges of numbers"
    yield f"- Options that never occur: {missing}"
    yield f"- Ranges that are not filled: {unfilled}"
    yield from ("", "| parameter | drawn |", "| --- | --- |")
    yield from map(_row_of_options, options)
    yield from (
        "",
        "| number | where | range | drawn | reached | parts |",
        "| --- | --- | --- | --- | --- | --- |",
    )
    yield from map(_row_of_spread, each.spreads.values())


def _row_of_options(each: Options) -> str:
    counts = ", ".join(f"{escaped(option)} {count}" for option, count in each.counts.items())
    return f"| `{each.name}` | {counts} |"


def _row_of_spread(each: Spread) -> str:
    unit = f" {each.unit}" if each.unit else ""
    reached = f"{each.least:.4g} to {each.most:.4g}" if each.drawn else "nothing"
    return (
        f"| `{each.name}` | {escaped(each.branch)} | {each.low:g} to {each.high:g}{unit} | {each.drawn} | "
        f"{reached} | {each.hit} of {BINS} |"
    )
