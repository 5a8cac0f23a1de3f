"""Files that grow by a line at a time, so that a run can be killed and go on."""

from pathlib import Path


def lines_of(path: Path) -> tuple[list[str], str]:
    """Return the lines of a file, and what a killed run left of another one; nothing if there is no file."""
    try:
        return lines_in(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        return [], ""


def lines_in(text: str) -> tuple[list[str], str]:
    """Return the lines of a text, and what comes after the last line break."""
    *lines, cut = text.split("\n")
    return lines, cut
