"""Every notebook runs from top to bottom in an empty directory, and comes without outputs."""

import os
from pathlib import Path

import nbformat
import pytest
from nbclient import NotebookClient

FOLDER = Path(__file__).parent.parent / "examples" / "notebooks"
NOTEBOOKS = sorted(FOLDER.glob("*.ipynb"))

TOLD = {
    "01_quick_start": ["changed: {'handle_height'}", "proven: 6 pairs", "with the handle down: ()"],
    "02_write_a_category": ["base and arm collide", "100.0 % proven", "the spring lifts the arm to 0."],
    "03_tailor_a_distribution": ["the same: 46 of 47", "Did you mean 'width'?", "100.0 % proven"],
    "04_repair_a_design": ["2 of 3 pairs fail", "1.6 rad: proven", "100.0 % proven", "grasps       0 faults"],
    "05_in_simulators": ["let go: door at 0.00", "episode 3: drawer_slide_0 at 9", "sound"],
}
"""What the cells of each have to print, besides running."""

PAGES = {
    "01_quick_start": 1,
    "02_write_a_category": 2,
    "03_tailor_a_distribution": 1,
    "04_repair_a_design": 2,
}
"""How many viewers the cells of each show."""


def test_notebooks_are_numbered_and_come_without_outputs() -> None:
    numbers = [path.name[:3] for path in NOTEBOOKS]
    assert numbers == [f"{number:02}_" for number in range(1, len(NOTEBOOKS) + 1)]
    assert [path.stem for path in NOTEBOOKS] == list(TOLD)
    for path in NOTEBOOKS:
        cells = nbformat.read(path, 4).cells
        assert not [cell for cell in cells if cell.get("outputs") or cell.get("execution_count")], path.name
        assert cells[0].cell_type == "markdown"


@pytest.mark.parametrize("path", NOTEBOOKS, ids=[path.stem for path in NOTEBOOKS])
@pytest.mark.filterwarnings(
    "ignore::DeprecationWarning:nbclient", "ignore::DeprecationWarning:jupyter_client"
)
def test_notebook_runs(path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("IPYTHONDIR", str(tmp_path / "ipython"))  # the user's settings are not ours
    (tmp_path / "empty").mkdir()
    book = nbformat.read(path, 4)
    where = {"metadata": {"path": str(tmp_path / "empty")}}
    NotebookClient(book, timeout=120, kernel_name="python3", resources=where).execute(env=dict(os.environ))
    outputs = [output for cell in book.cells for output in cell.get("outputs", [])]
    complaints = [each.text for each in outputs if each.output_type == "stream" and each.name == "stderr"]
    assert complaints == []
    printed = "".join(output.text for output in outputs if output.output_type == "stream")
    assert [text for text in TOLD[path.stem] if text not in printed] == []
    pages = [output for output in outputs if "<iframe" in output.get("data", {}).get("text/html", "")]
    assert len(pages) == PAGES.get(path.stem, 0)
    assert {item.name for item in (tmp_path / "empty").iterdir()} <= {"out"}
