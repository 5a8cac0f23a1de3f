"""The page of the documentation that says what a survey of many samples of every category found."""

from collections.abc import Iterator, Mapping, Sequence

from artgen.version import __version__
from surveys.markdown import escaped
from surveys.summary import Criterion, Record, criteria, failures, figures, listed

_STATES = {True: "yes", False: "**no**", None: "not measured"}


def soak_page(records: Mapping[str, Sequence[Record]]) -> str:
    """Return the page, in Markdown.

    Args:
        records: Of each category, those of its survey.
    """
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
        *(_row_of(name, found) for name, found in records.items()),
    ]
    for name, found in records.items():
        lines += _of_category(name, found)
    return "\n".join(lines) + "\n"


def _row_of(name: str, records: Sequence[Record]) -> str:
    asked = criteria(records)
    met = sum(each.passed is True for each in asked)
    wrong = "; ".join(f"{each.name} ({each.found})" for each in asked if each.passed is not True)
    return f"| [`{name}`](#{name}) | {len(records)} | {met} of {len(asked)} | {escaped(wrong) or 'nothing'} |"


def _of_category(name: str, records: Sequence[Record]) -> Iterator[str]:
    yield from ("", f"## {name}", "", "| asked | found | met |", "| --- | --- | --- |")
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
