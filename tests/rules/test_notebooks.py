"""The notebooks of the documents: kept without output, formatted, and they run."""

from __future__ import annotations

import ast
import json
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

pytestmark = pytest.mark.quick

ROOT = Path(__file__).parents[2]
NOTEBOOKS = sorted((ROOT / "docs" / "notebooks").glob("*.ipynb"))
EACH = pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)


def cells(path: Path, kind: str) -> list[dict[str, Any]]:
    return [
        cell
        for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]
        if cell["cell_type"] == kind
    ]


def test_there_are_notebooks_and_the_page_names_all() -> None:
    page = (ROOT / "docs" / "tutorials" / "notebooks.md").read_text(encoding="utf-8")
    assert len(NOTEBOOKS) >= 3
    assert all(f"../notebooks/{path.name})" in page for path in NOTEBOOKS)


@EACH
def test_a_notebook_is_kept_without_output(path: Path) -> None:
    code = cells(path, "code")
    assert code
    for cell in code:
        assert cell["outputs"] == []
        assert cell["execution_count"] is None
        ast.parse("".join(cell["source"]))


@EACH
def test_a_notebook_begins_with_what_it_is_about_and_checks_itself(path: Path) -> None:
    assert "".join(cells(path, "markdown")[0]["source"]).startswith("# ")
    assert any("assert " in "".join(cell["source"]) for cell in cells(path, "code"))


@EACH
def test_the_code_of_a_notebook_runs(path: Path) -> None:
    """Without a kernel; `make release` runs it in Jupyter."""
    names: dict[str, Any] = {}
    for cell in cells(path, "code"):
        exec(compile("".join(cell["source"]), path.name, "exec"), names)  # noqa: S102 - our own


@pytest.mark.release
@EACH
def test_a_notebook_runs_in_jupyter(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """With the extra `notebook`, which `make release` installs."""
    nbformat, nbclient = import_module("nbformat"), import_module("nbclient")
    monkeypatch.setenv("PYTHONPATH", str(ROOT / "src"))
    notebook = nbformat.read(path, as_version=4)
    nbclient.NotebookClient(notebook, timeout=300, kernel_name="python3").execute()
    shown = [cell["outputs"] for cell in notebook["cells"] if cell["cell_type"] == "code"]
    assert sum(1 for outputs in shown if outputs) >= len(shown) - 2
    assert not any(out["output_type"] == "error" for outputs in shown for out in outputs)
