"""Lines of test files, found by a marker comment and not by number."""

from pathlib import Path


def place_of(file: str, marker: str) -> str:
    """Return `file:line` of the only line that ends in the comment `# marker`."""
    lines = Path(file).read_text().splitlines()
    found = [number for number, line in enumerate(lines, 1) if line.endswith(f"# {marker}")]
    assert len(found) == 1, f"marker {marker!r} is on the lines {found}"
    return f"{file}:{found[0]}"
