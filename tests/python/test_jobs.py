# SPDX-License-Identifier: BSD-3-Clause
"""Each kind of job has its results as tables and its chart: their numbers are those of the files of the run."""

import csv
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import berm
import numpy as np
import pytest

pytest.importorskip("matplotlib")
from berm.charts_plot import unit_for  # noqa: E402


def column(file: Path, name: str) -> np.ndarray:
    with file.open(newline="") as opened:
        return np.array([float(row[name]) for row in csv.DictReader(line for line in opened if not line.startswith("#"))])


def short(folder: Path, kind: str, changes: dict[str, Any]) -> berm.Run:
    """A template at the start of what it computes."""
    return berm.run(berm.new(kind, folder / f"{kind}.toml", size="quick"), folder / kind, set=changes, threads=1, quiet=True)


def test_a_lift_shows_its_resistance_upwards(tmp_path: Path) -> None:
    run = short(tmp_path, "uplift", {"stage.uplift.until.displacement": "5 mm"})
    (axes,) = run.plot().axes
    assert axes.get_ylabel() == "uplift resistance R (kN/m)"
    (chart,) = json.loads((run.folder / "curves.json").read_text())["charts"][-1]["curves"]
    drawn = axes.lines[0]
    assert np.allclose(drawn.get_ydata(), -np.array(chart["y"], dtype=float) / 1000)
    assert np.allclose(drawn.get_xdata(), np.array(chart["x"], dtype=float) * 1000)
    assert run.travels["uplift"] and not run.states
    with pytest.raises(berm.InputError, match="no chart p_y; it has .*R_s"):
        run.plot("p_y")


def test_a_pile_shows_its_p_y_curves(tmp_path: Path) -> None:
    run = short(tmp_path, "pile", {"stage.push_over.until.displacement": "10 mm"})
    H_u, p_y = run.plot().axes
    assert H_u.get_xlabel().startswith("displacement at the seabed u") and p_y.get_ylabel() == "resistance p (kN/m)"
    depths = np.unique(run.py["z_m"])
    assert [line.get_label() for line in p_y.lines if not line.get_label().startswith("_")] == [
        f"{1000 * z:g} mm" if z < 1 else f"{z:g} m" for z in depths
    ]
    assert np.array_equal(run.py["p_N_m"], column(run.folder / "py.csv", "p_N_m"))
    pytest.importorskip("pandas")
    assert len(run.py.to_pandas().groupby("z_m")) == len(depths)


def test_a_storm_shows_its_half_cycles(tmp_path: Path) -> None:
    run = short(tmp_path, "storm-on-a-cable", {})
    _, _, axes = run.plot().axes
    sizes = abs(column(run.folder / "half_cycles.csv", "u_end_m") - column(run.folder / "half_cycles.csv", "u_begin_m"))
    (drawn,) = axes.lines
    assert np.allclose(drawn.get_ydata(), sizes * 1000)
    assert np.isclose(sizes.max(), run.quantities["u_largest_half_cycle"].value), "as the program says it"


def test_a_penetrometer_shows_its_resistance_down_the_page(tmp_path: Path) -> None:
    run = short(tmp_path, "footing", {})
    q_z, N_z = run.plot().axes
    assert q_z.get_ylim()[0] > q_z.get_ylim()[1] and q_z.get_ylabel().startswith("depth")
    chart = next(chart for chart in json.loads((run.folder / "curves.json").read_text())["charts"] if chart["chart"] == "q_z")
    assert np.allclose(q_z.lines[0].get_xdata(), np.array(chart["curves"][0]["y"], dtype=float) / 1000, equal_nan=True)


def test_consolidation_shows_its_degree_and_the_states_of_the_pipe(tmp_path: Path) -> None:
    run = short(tmp_path, "consolidation", {"stage.consolidate.until.real_time": "2 h", "stage.drag.until.displacement": "10 mm"})
    *_, axes = run.plot().axes
    assert axes.get_ylabel() == "degree of consolidation U"
    assert np.isclose(axes.lines[0].get_ydata()[-1], run.quantities["U_of_consolidate"].value)
    assert list(run.states) == ["touchdown", "operation"]
    rows = run.history.in_stage("lay")
    assert np.isclose(run.states["touchdown"]["w"].value, run.history["w"][rows][-1], rtol=1e-6)
    assert set(run.travels) == {"push", "lay", "consolidate", "drag"} and "H_max" in run.travels["drag"]
    pandas = pytest.importorskip("pandas")
    table = run.key_results()
    assert isinstance(table, pandas.DataFrame) and set(table["kind"]) == {"answer", "prescribed"}
    assert list(table.columns) == ["quantity", "value", "unit", "of", "kind", "meaning"]
    assert table.set_index("quantity").loc["touchdown.w", "value"] == run.states["touchdown"]["w"].value
    assert len(run.key_results(kinds=["quality"])) == sum(q.kind == "quality" for q in run.quantities.values())


def test_a_pipeline_shows_its_shape_at_the_ends_of_its_stages(tmp_path: Path) -> None:
    times = {f"stage.{stage}.{key}": time for stage in ("heat", "cool", "heat_again") for key, time in (("ramp", 0.4), ("until.time", 0.5))}
    changes = {**times, "pipeline.slices.to": "36 m"}
    run = short(tmp_path, "lateral-buckle", changes)
    shape, y_load, M_load = run.plot().axes
    drawn = {line.get_label(): line for line in shape.lines}
    assert list(drawn) == ["lay", "unload", "heat", "cool", "heat_again"]
    last = column(run.folder / "line.csv", "frame").max()
    y = column(run.folder / "line.csv", "y_m")[column(run.folder / "line.csv", "frame") == last]
    shown = drawn["heat_again"].get_ydata() / (1000 if "mm" in shape.get_ylabel() else 1)
    assert np.allclose(shown, y[: len(shown)]) and np.abs(y[len(shown) :]).max() < 0.01 * np.abs(y).max()
    assert y_load.get_xlabel() == "rise of temperature T (K)" and M_load.get_ylabel() == "bending moment M (kN m)"


def test_units_of_charts_have_usual_prefixes() -> None:
    assert [unit_for("N/m", size).name for size in (50, 500, 5e6)] == ["N/m", "kN/m", "MN/m"]
    assert unit_for("m", 0.5) == (1000, "mm") and unit_for("m", 5) == (1, "m") and unit_for("1", 5e9) == (1, "1")
    assert unit_for("Pa", 3e4).name == "kPa" and unit_for("K", 300).name == "K"


def test_an_envelope_has_its_probes_and_a_picture(tmp_path: Path) -> None:
    clay = Path(os.environ["BERM_SOURCE"]) / "examples" / "envelope" / "clay.toml"
    found = berm.envelope(clay, tmp_path, points=2, travel=0.01, quiet=True)
    assert found.probes == {"down": "finished", "direction_-45": "finished", "swipe": "finished"}
    V, H = (column(tmp_path / "envelope.csv", f"{letter}_N_m") for letter in "VH")
    assert found.quantities["V_max"] == (V[0], "N/m", "", "answer", "") and np.isclose(found.quantities["H_max"].value, H.max())
    assert "Merifield" in found.published["V_max"].meaning
    path, ends = found.plot().axes[0].lines
    assert len(ends.get_xdata()) == 3 and np.allclose(ends.get_ydata(), V[:3] / 1000) and np.allclose(path.get_xdata(), H[3:] / 1000)


def test_a_factor_of_safety_lies_between_what_stands_and_what_fails(tmp_path: Path) -> None:
    found = berm.safety(berm.new("slope", tmp_path / "slope.toml", size="quick"), tmp_path / "out", tolerance=0.5, threads=1, quiet=True)
    assert found.stands < found.factor < found.fails and np.isclose(found.factor, (found.stands + found.fails) / 2)
    stood = [factor for factor, end in zip(found.trials["factor"], found.trials["end"]) if end == "stands"]
    assert max(factor for factor in stood if factor < found.fails) == found.stands


def test_the_engine_that_is_not_there_says_how_to_install_it(tmp_path: Path) -> None:
    shutil.copytree(Path(berm.__file__).parent, tmp_path / "berm", ignore=shutil.ignore_patterns("engine*.so", "__pycache__"))
    for words in ("from berm import engine", "import berm.engine", "import berm; berm.engine"):
        alone = {"PYTHONPATH": str(tmp_path)}
        said = subprocess.run([sys.executable, "-c", words], cwd=tmp_path, env=alone, capture_output=True, text=True)
        assert "ImportError: berm.engine is compiled" in said.stderr and "python3-berm" in said.stderr


def test_laboratory_tests_are_fitted_without_an_input(tmp_path: Path) -> None:
    (tmp_path / "box.csv").write_text("shear_strain (%),tau (kPa)\n0,0\n0.1,1\n0.5,4.6\n1,5.1\n5,5\n10,4.9\n")
    with pytest.raises(berm.InputError, match="k0"):
        berm.fit("mohr_coulomb", tmp_path / "out", tests=[tmp_path / "box.csv"], kind="simple_shear", undrained=True)
