"""Files that grow by a line at a time, so that a run can be killed and go on."""

from pathlib import Path


def lines_of(path: Path) -> tuple[list[str], str]:
    """Return the lines of a file, and what a killed run left of another one; nothing if there is no file."""
    try:
        *lines, cut = path.read_text(encoding="utf-8").split("\n")
    except FileNotFoundError:
        return [], ""
    return lines, cut
