"""Write docs/concept_mapping.md from `concepts.table`."""

from pathlib import Path

from concepts.page import concept_page

if __name__ == "__main__":
    page = Path(__file__).parents[1] / "docs" / "concept_mapping.md"
    page.write_text(concept_page(), encoding="utf-8")
