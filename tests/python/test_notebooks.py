# SPDX-License-Identifier: BSD-3-Clause
"""The notebooks run from the first cell to the last and show pictures."""

import os
from pathlib import Path

import pytest

NOTEBOOKS = sorted((Path(os.environ["BERM_SOURCE"]) / "examples" / "notebooks").glob("*.ipynb"))


def test_there_is_one_for_each_job() -> None:
    jobs = ["buckle", "cpt", "flowline", "pile", "storm", "uplift"]
    assert [notebook.stem for notebook in NOTEBOOKS] == sorted([*jobs, "first_run", "law_of_my_own", "study_with_uncertainty"])


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda notebook: notebook.stem)
def test_notebook_runs(notebook: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    nbformat = pytest.importorskip("nbformat")
    nbclient = pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    if notebook.stem == "law_of_my_own":
        pytest.importorskip("berm.engine")
    for folder in ("IPYTHONDIR", "JUPYTER_DATA_DIR", "JUPYTER_RUNTIME_DIR"):  # nothing of the user's home is read or written
        monkeypatch.setenv(folder, str(tmp_path / folder))
    opened = nbformat.read(notebook, as_version=4)
    nbclient.NotebookClient(opened, timeout=300, kernel_name="python3", resources={"metadata": {"path": str(tmp_path)}}).execute()
    outputs = [output for cell in opened.cells for output in cell.get("outputs", [])]
    assert not [output for output in outputs if output.output_type == "error"]
    assert any("image/png" in output.get("data", {}) for output in outputs)
