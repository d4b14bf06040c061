# SPDX-License-Identifier: BSD-3-Clause
"""The package reads what the program leaves, and passes on what the program says."""

import csv
import math
import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import berm
import numpy as np
import pytest
from berm.program import toml_value


def test_import_loads_neither_numpy_nor_matplotlib() -> None:
    loaded = "import sys, berm; sys.exit(any(name in sys.modules for name in ('numpy', 'matplotlib', 'pandas', 'subprocess_of_berm')))"
    assert subprocess.run([sys.executable, "-c", loaded]).returncode == 0


def test_package_and_program_are_of_one_version() -> None:
    assert berm.version() == berm.__version__


def test_history_has_the_numbers_of_the_file(finished: berm.Run) -> None:
    with open(finished.folder / "history.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    history = finished.history
    assert len(history) == len(rows) > 10
    assert history.stage == [row["stage"] for row in rows]
    for name in history:
        assert np.array_equal(history[name], [float(row[name]) for row in rows], equal_nan=True)
    assert history["V"] is history["V_N_m"]
    assert history.unit("V") == "N/m" and history.unit("w") == "m"
    assert history.in_stage("drag").sum() == history.stage.count("drag")
    with pytest.raises(berm.InputError, match="no column 'v'"):
        history["v"]
    with pytest.raises(berm.InputError, match="there are"):
        history.in_stage("dragg")


def test_quantities_are_those_of_the_history(finished: berm.Run) -> None:
    assert finished.finished
    found = finished.quantities["w_end"] if "w_end" in finished.quantities else None
    lengths = [q for q in finished.quantities.values() if q.unit == "m"]
    assert lengths and all(isinstance(q.value, float) and q.meaning for q in lengths)
    if found is not None:
        assert math.isclose(found.value, finished.history["w"][-1], rel_tol=1e-9)


def test_frames_have_position_and_fields_of_each_particle(finished: berm.Run) -> None:
    assert len(finished.frames) >= 3
    last = finished.frames[-1]
    count = int(finished.summary["timing"]["particles"])
    assert last.position.shape == (count, 3) and last["stress"].shape == (count, 6)
    assert last.field("stress").unit == "Pa"
    assert [frame.time for frame in finished.frames] == sorted(frame.time for frame in finished.frames)
    moved = last.position - finished.frames[0].position[np.argsort(finished.frames[0]["id"])][np.argsort(np.argsort(last["id"]))]
    assert np.allclose(moved, last["displacement"], atol=1e-7), "frames store displacement as 32-bit numbers: 6e-8 of centimetres, and of the position's difference"
    with pytest.raises(berm.InputError, match="no field"):
        last["stres"]


def test_changes_are_written_as_toml() -> None:
    assert toml_value("35 deg") == '"35 deg"' and toml_value(True) == "true" and toml_value(3) == "3" and toml_value(0.1) == "0.1"
    assert toml_value(np.float64(0.5)) == "0.5" and toml_value([1, "a"]) == '[1, "a"]'
    with pytest.raises(berm.InputError, match="neither a number"):
        toml_value({})


def test_a_change_changes_the_run_and_a_wrong_one_is_refused_with_its_key(case: Path, tmp_path: Path, finished: berm.Run) -> None:
    changed = berm.run(case, tmp_path / "changed", set={"material.sand.friction_angle": "25 deg"}, threads=1, quiet=True)
    assert changed.history["V"][-1] != finished.history["V"][-1]
    with pytest.raises(berm.InputError, match="material.sand.friction_angel"):
        berm.run(case, tmp_path / "wrong", set={"material.sand.friction_angel": 1}, quiet=True)
    with pytest.raises(berm.InputError, match="--force"):
        berm.run(case, tmp_path / "changed", quiet=True)
    with pytest.raises(berm.InputError, match="either a case"):
        berm.run()


def test_an_interrupt_leaves_a_checkpoint_from_which_a_run_goes_on(case: Path, tmp_path: Path, finished: berm.Run) -> None:
    long = {"stage.drag.until.displacement": "2 mm"}
    folder = tmp_path / "long"

    def interrupt() -> None:
        limit = time.monotonic() + 30
        while not (folder / "history.csv").exists() and time.monotonic() < limit:
            time.sleep(0.01)
        os.kill(os.getpid(), signal.SIGINT)

    threading.Thread(target=interrupt).start()
    with pytest.raises(KeyboardInterrupt):
        berm.run(case, folder, set={**long, "output.history_time": "1 us"}, threads=1, quiet=True)
    assert not berm.open(folder, berm.Run).finished
    assert berm.run(resume=folder, threads=1, quiet=True).finished


def test_what_is_no_run_is_refused(tmp_path: Path) -> None:
    with pytest.raises(berm.InputError, match="no run folder"):
        berm.open(tmp_path)
    with pytest.raises(berm.InputError, match="no study"):
        berm.Study(tmp_path)


def test_a_missing_program_is_named(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("BERM", str(tmp_path / "none"))
    with pytest.raises(berm.RunError, match="none"):
        berm.version()


def test_a_study_has_rows_estimates_and_springs(sampled: berm.Study) -> None:
    draws = sampled.runs("draw")
    assert len(draws) == 10 and len(sampled.runs("best")) == 1
    H = sampled.values("H_end_of_drag", "draw") if "H_end_of_drag" in draws[0].quantities else np.array([run.history["H"][-1] for run in draws])
    assert np.ptp(H) > 0
    springs = sampled.springs
    assert set(springs["springs"]) == {"low", "best", "high"}
    peak = {name: springs["springs"][name]["lateral"][0]["peak_N_m"] for name in ("low", "best", "high")}
    assert peak["low"] < peak["best"] < peak["high"]
    assert isinstance(berm.open(sampled.folder), berm.Study)


def test_springs_go_to_a_pipeline_program(sampled: berm.Study, tmp_path: Path) -> None:
    files = berm.export(sampled.folder, to="orcaflex", output=tmp_path)
    assert any(file.name == "springs_best.csv" for file in files) and all(file.is_file() for file in files)


def test_pictures_show_curves_soil_and_springs(finished: berm.Run, sampled: berm.Study, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    for name, figure in (("curves", finished.plot()), ("soil", finished.plot_soil(field="stress")), ("springs", sampled.plot_springs())):
        figure.savefig(tmp_path / f"{name}.png")
        assert (tmp_path / f"{name}.png").stat().st_size > 5000
    lines = finished.plot().axes[0].lines
    assert np.array_equal(lines[0].get_ydata(), finished.history["w"][finished.history.in_stage("push")])


def test_history_as_a_table_of_pandas(finished: berm.Run, sampled: berm.Study) -> None:
    pytest.importorskip("pandas")
    table = finished.history.to_pandas()
    assert list(table.columns) == list(finished.history.columns) and table.attrs["units"]["V_N_m"] == "N/m"
    assert len(sampled.table()) == len(sampled.runs())


def test_history_as_a_dataset_of_xarray(finished: berm.Run) -> None:
    pytest.importorskip("xarray")
    assert finished.history.to_xarray()["V_N_m"].attrs["units"] == "N/m"


def test_types_hold() -> None:
    mypy = subprocess.run([sys.executable, "-m", "mypy", "--version"], capture_output=True)
    if mypy.returncode != 0:
        pytest.skip("mypy is not installed")
    source = Path(os.environ["BERM_SOURCE"]) / "python"
    checked = subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", "--ignore-missing-imports", "--cache-dir", os.devnull, "-p", "berm"],
        cwd=source, env={**os.environ, "MYPYPATH": str(source), "PYTHONPATH": ""}, capture_output=True, text=True,
    )  # fmt: skip
    assert checked.returncode == 0, checked.stdout
