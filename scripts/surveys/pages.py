"""Pages of the documentation, in Markdown, with the results of surveys."""

from collections.abc import Iterable, Iterator, Mapping, Sequence

from artgen.version import __version__
from surveys.coverage import BINS, Coverage, Options, Spread
from surveys.summary import Criterion, Record, criteria, failures, figures, listed

_STATES = {True: "yes", False: "**no**", None: "not measured"}


def escaped(text: str) -> str:
    """Return text for a cell of a table: on one line, with bars and brackets escaped."""
    return text.replace("|", r"\|").replace("[", r"\[").replace("\n", " ")


def soak_page(records: Mapping[str, Sequence[Record]]) -> str:
    """Return the page about the surveys of categories, with the records of each category."""
    lines = [
        "# Soak",
        "",
        (
            f"What many samples of each category of artgen {__version__} were found to be. Written by "
            "`make survey`, which takes hours and goes on where it was interrupted; do not edit it. Times "
            "are those of the machine that ran it, with whatever else ran on it."
        ),
        "",
        "| category | seeds | met | not met |",
        "| --- | --- | --- | --- |",
        *(_row_of_survey(name, found) for name, found in records.items()),
    ]
    for name, found in records.items():
        lines += _survey_of(name, found)
    return "\n".join(lines) + "\n"


def _row_of_survey(name: str, records: Sequence[Record]) -> str:
    results = criteria(records)
    met = sum(each.passed is True for each in results)
    wrong = "; ".join(f"{each.name} ({each.found})" for each in results if each.passed is not True)
    return (
        f"| [`{name}`](#{name}) | {len(records)} | {met} of {len(results)} | {escaped(wrong) or 'nothing'} |"
    )


def _survey_of(name: str, records: Sequence[Record]) -> Iterator[str]:
    yield from ("", f"## {name}", "", "| criterion | found | met |", "| --- | --- | --- |")
    yield from map(_row_of_criterion, criteria(records))
    yield from ("", "| measured | of all samples |", "| --- | --- |")
    yield from (f"| {what} | {escaped(text)} |" for what, text in figures(records).items())
    wrong = failures(records)
    if wrong:
        yield from ("", "What was found wrong, with the first message of each kind:", "")
        for failure in wrong:
            yield f"- {failure.kind}: {listed(failure.seeds)}. `{' '.join(failure.message.split())[:200]}`"


def _row_of_criterion(each: Criterion) -> str:
    seeds = f", {listed(each.seeds)}" if each.seeds else ""
    return f"| {escaped(each.name)} | {escaped(each.found)} | {_STATES[each.passed]}{seeds} |"


def coverage_page(found: Iterable[Coverage]) -> str:
    """Return the page about the draws of categories."""
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
        lines += _coverage_of(each)
    return "\n".join(lines) + "\n"


def _coverage_of(each: Coverage) -> Iterator[str]:
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
