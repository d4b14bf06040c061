# SPDX-License-Identifier: BSD-3-Clause
"""The notebooks run from the first cell to the last, and are kept without outputs."""

import json
import os
from pathlib import Path

import pytest

NOTEBOOKS = sorted((Path(os.environ["BERM_SOURCE"]) / "examples" / "notebooks").glob("*.ipynb"))


def test_there_are_three() -> None:
    assert [notebook.stem for notebook in NOTEBOOKS] == ["first_run", "law_of_my_own", "study_with_uncertainty"]


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda notebook: notebook.stem)
def test_notebook_is_kept_without_outputs(notebook: Path) -> None:
    cells = json.loads(notebook.read_text())["cells"]
    assert all(not cell.get("outputs") and cell.get("execution_count") is None for cell in cells)


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda notebook: notebook.stem)
def test_notebook_runs(notebook: Path, tmp_path: Path) -> None:
    nbformat = pytest.importorskip("nbformat")
    nbclient = pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    if notebook.stem == "law_of_my_own":
        pytest.importorskip("berm.engine")
    opened = nbformat.read(notebook, as_version=4)
    nbclient.NotebookClient(opened, timeout=300, kernel_name="python3", resources={"metadata": {"path": str(tmp_path)}}).execute()
    errors = [output for cell in opened.cells for output in cell.get("outputs", []) if output.output_type == "error"]
    assert not errors
