"""The page docs/concept_mapping.md, written from the table of concepts."""

from concepts.concept import FORMAT_TITLES, Cell
from concepts.table import CONCEPTS

_HEAD = """# What each format says

How artgen's concepts are written in URDF, MJCF, USD, GLB and SDFormat, with their units, and what is lost
where. The words in backticks stand in the files, here of an asset named `cabinet_7`. *Lost* names the entry
under `formats` in the export's `asset.json` that tells, for each asset, which joints or links it concerns and
what was written instead. `scripts/concept_mapping.py` writes this page from `concepts.table`, and the
tests hold both against the writers.
"""


def concept_page() -> str:
    """Return the text of docs/concept_mapping.md."""
    titles = ["concept", "unit in artgen", "in asset.json", *FORMAT_TITLES.values()]
    lines = [f"| {' | '.join(titles)} |", f"|{' --- |' * len(titles)}"]
    for concept in CONCEPTS:
        field = f"`{concept.field}`" if concept.field else ""
        cells = [concept.name, concept.unit, field, *(_said(concept.cells[name]) for name in FORMAT_TITLES)]
        lines.append(f"| {' | '.join(cells)} |")
    return _HEAD + "\n" + "\n".join(lines) + "\n"


def _said(cell: Cell) -> str:
    if not cell.losses:
        return cell.text
    return f"{cell.text}. *Lost: {', '.join(cell.losses)}*"
