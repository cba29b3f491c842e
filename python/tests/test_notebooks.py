"""The notebooks in examples/ run from their first cell to the last, as a reader runs them."""

import ast
import json
import pathlib

import matplotlib
import pytest

BOOKS = sorted((pathlib.Path(__file__).parents[2] / "examples/notebooks").glob("*.ipynb"))


def test_there_are_notebooks():
    assert len(BOOKS) >= 4


@pytest.mark.parametrize("book", BOOKS, ids=lambda book: book.stem)
def test_notebook_runs(book, tmp_path, monkeypatch):
    matplotlib.use("Agg")
    monkeypatch.chdir(tmp_path)
    names = {}
    cells = [c for c in json.loads(book.read_text())["cells"] if c["cell_type"] == "code"]
    for number, cell in enumerate(cells):
        assert cell["outputs"] == [], "notebooks are kept without outputs"
        code = ast.parse("".join(cell["source"]), f"{book.name}, code cell {number}")
        exec(compile(code, f"{book.name}, code cell {number}", "exec"), names)
    assert matplotlib.pyplot.get_fignums()
    matplotlib.pyplot.close("all")
