"""The notebooks run, and are checked in without outputs."""

import json
from pathlib import Path

import pytest

NOTEBOOKS = sorted((Path(__file__).parent.parent / "notebooks").glob("*.ipynb"))


def cells(notebook):
    return json.loads(notebook.read_text(encoding="utf-8"))["cells"]


def test_there_are_some():
    assert len(NOTEBOOKS) >= 6


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_no_outputs(notebook):
    for cell in cells(notebook):
        assert not cell.get("outputs") and cell.get("execution_count") is None


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_lines_are_not_cut(notebook):
    """A page shows a hundred columns of code."""
    for cell in cells(notebook):
        if cell["cell_type"] == "code":
            assert all(len(line.rstrip("\n")) <= 104 for line in cell["source"])


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_it_runs(notebook):
    nbclient, nbformat = pytest.importorskip("nbclient"), pytest.importorskip("nbformat")
    document = nbformat.read(notebook, as_version=4)
    nbclient.NotebookClient(document, timeout=120, kernel_name="python3").execute()
    # what a cell ends with is shown
    assert any(
        output.output_type in ("execute_result", "display_data") and "text/html" in output.data
        for cell in document.cells
        for output in cell.get("outputs", [])
    ) or notebook.stem.startswith("6")
