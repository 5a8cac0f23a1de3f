"""The page of the documentation: each benchmark rewrites its own section."""

from collections.abc import Sequence
from pathlib import Path

from machine import machine
from report import Section, flowing, markdown

_TITLE = "# Benchmarks"
_HEAD = """
What artgen takes, beside what others take for the same work. Written by `make bench`; do not edit it.
Each section is written by the command beside it, which measures both sides in one run, in turn, and
takes medians; a single process is measured by the time of its processor. The ratios are what counts:
times are those of the machine named, with whatever else ran on it.
"""
_SECTION = "## "


def write_section(path: Path, name: str, section: Section, order: Sequence[str]) -> None:
    """Write a section of the page; the other sections stay unchanged.

    The page is replaced atomically, so that an interrupted run leaves the old one.

    Args:
        path: The page; it is made if there is none.
        name: Name of the benchmark.
        section: What it found.
        order: The names of all benchmarks, in the order of the page.
    """
    sections = _sections(path) | {name: "\n".join(_lines(name, section))}
    there = [sections[each] for each in order if each in sections]
    text = "\n".join([_TITLE, "", flowing(_HEAD), "", *there])
    path.parent.mkdir(parents=True, exist_ok=True)
    beside = path.with_name(f"{path.name}.part")
    beside.write_text(text, encoding="utf-8")
    beside.replace(path)


def _lines(name: str, section: Section) -> list[str]:
    return [
        f"{_SECTION}{name}: {section.title}",
        "",
        f"    python benchmarks/run.py {name}",
        "",
        *markdown(section),
        "",
        f"Measured on: {machine(section.versions)}.",
        "",
    ]


def _sections(path: Path) -> dict[str, str]:
    """Return the sections of the page by name."""
    if not path.is_file():
        return {}
    found: dict[str, list[str]] = {}
    name = ""
    for line in path.read_text(encoding="utf-8").splitlines():
        if line.startswith(_SECTION):
            name = line.removeprefix(_SECTION).partition(":")[0]
        if name:
            found.setdefault(name, []).append(line)
    return {name: "\n".join(lines).rstrip() + "\n" for name, lines in found.items()}
