# SPDX-License-Identifier: BSD-3-Clause
"""The package reads what a study leaves, and takes its springs."""

import csv
import json
import shutil
from pathlib import Path

import berm
import numpy as np
import pytest


def test_rows_are_what_the_study_ran(sampled: berm.Study) -> None:
    assert [row.kind for row in sampled.rows] == ["best", "low", "high"] + 10 * ["draw"]
    assert all(row.finished and row.names == ("pipe",) for row in sampled.rows)
    assert len(sampled.runs("draw")) == 10 and len(sampled.runs("best", ["pipe"])) == 1
    assert isinstance(berm.open(sampled.folder), berm.Study)
    with pytest.raises(berm.InputError, match="no row of a study is of kind 'drawn'; kinds are row, best"):
        sampled.runs("drawn")
    with pytest.raises(berm.InputError, match="no cable; it has pipe"):
        sampled.runs(names=["cable"])


def test_values_are_those_of_the_table_and_follow_the_sample(sampled: berm.Study) -> None:
    H = sampled.values("H_end_of_drag")
    with open(sampled.folder / "results.csv", newline="") as file:
        assert np.allclose(H, [float(row["H at the end (kN/m)"]) * 1000 for row in csv.DictReader(file)], rtol=1e-9)
    angles = np.array(sampled.sample["material.sand.friction_angle (rad)"], dtype=float)
    assert np.corrcoef(angles, sampled.values("H_end_of_drag", "draw"))[0, 1] > 0.9, "stronger sand resists more"
    with pytest.raises(berm.InputError, match="no run has the key result 'H_end'; there are .*H_end_of_drag"):
        sampled.values("H_end")


def test_a_run_that_did_not_finish_is_a_number_that_is_missing_in_its_place(sampled: berm.Study, tmp_path: Path) -> None:
    shutil.copytree(sampled.folder, tmp_path / "out")
    file = tmp_path / "out" / "study.json"
    content = json.loads(file.read_text())
    content["rows"][5]["finished"] = False
    file.write_text(json.dumps(content))
    study = berm.Study(tmp_path / "out")
    assert np.flatnonzero(np.isnan(study.values("H_end_of_drag"))).tolist() == [5] and len(study.runs()) == 12
    file.write_text("{}")
    with pytest.raises(berm.RunError, match="study.json"):
        berm.Study(tmp_path / "out")


def test_estimates_are_quantiles_of_the_sample(sampled: berm.Study) -> None:
    (estimate,) = sampled.estimates
    draws = np.sort(sampled.values("H_end_of_drag", "draw")) / 1000
    assert estimate.names == ("pipe",) and estimate.measure == "H at the end (kN/m)" and (estimate.count, estimate.failed) == (10, 0)
    assert np.isclose(estimate.best, sampled.values("H_end_of_drag", "best")[0] / 1000)
    assert np.isclose(estimate.low, draws[0]) and np.isclose(estimate.high, draws[-1]), "of ten numbers 5 and 95 % are the ends"
    assert np.isclose(estimate.middle, np.median(draws)) and np.isclose(estimate.mean, draws.mean())


def test_distribution_is_that_of_the_draws(sampled: berm.Study) -> None:
    (spread,) = sampled.distribution
    draws = sampled.values("H_end_of_drag", "draw") / 1000
    assert spread["case"] == "pipe" and np.isclose(spread["standard deviation"], draws.std(ddof=1))
    assert np.isclose(spread["lognormal median"], np.exp(np.log(draws).mean()))
    assert np.isclose(spread["standard error of the mean"], draws.std(ddof=1) / np.sqrt(len(draws)))


def test_springs_have_low_best_and_high(sampled: berm.Study) -> None:
    springs = sampled.springs
    assert set(springs["springs"]) == {"low", "best", "high"}
    peak = {name: springs["springs"][name]["lateral"][0]["peak_N_m"] for name in ("low", "best", "high")}
    assert peak["low"] < peak["best"] < peak["high"]


def test_a_run_has_springs_of_its_own(finished: berm.Run) -> None:
    assert list(finished.springs["springs"]) == ["best"]
    assert np.isclose(finished.springs["diameter_m"], 50 * finished.diameter), "at 50 g, of the prototype"


def test_springs_go_to_a_pipeline_program(sampled: berm.Study, tmp_path: Path) -> None:
    files = berm.export(sampled.folder, to="orcaflex", output=tmp_path)
    assert any(file.name == "springs_best.csv" for file in files) and all(file.is_file() for file in files)
    with pytest.raises(berm.InputError, match="exel"):
        berm.export(sampled.folder, to="exel")


def test_a_study_as_a_table_of_pandas(sampled: berm.Study) -> None:
    pytest.importorskip("pandas")
    table = sampled.table()
    assert len(table) == len(sampled.rows) and np.array_equal(table["H_end_of_drag"], sampled.values("H_end_of_drag"))
    assert table["material.sand.friction_angle (rad)"].isna().sum() == 3, "best, low and high are no draws"
    assert table["kind"].tolist() == [row.kind for row in sampled.rows]


def test_a_study_of_which_a_row_failed_raises_and_leaves_the_others(tmp_path: Path) -> None:
    stone = """gravity = [0, "-10 m/s^2"]
mesh = {kind = "box", size = [1, 1], cells = [4, 4]}
material.stone = {law = "linear_elastic", density = 1000, young_modulus = 1e6, poisson_ratio = 0}
body.stone = {material = "stone", block = {center = [0.5, 0.7], size = [0.2, 0.2], spacing = 0.1}}
[[stage]]
name = "fall"
kind = "free"
until.time = "0.1 s"
"""
    (tmp_path / "falls.toml").write_text(stone)
    (tmp_path / "flies.toml").write_text(stone.replace("-10 m/s^2", "-9000 m/s^2"))
    cases = "".join(f'[[case]]\nname = "{name}"\nfile = "{name}.toml"\n' for name in ("falls", "flies"))
    (tmp_path / "study.toml").write_text(f'title = "stones"\n{cases}[[measure]]\nname = "energy error"\nquantity = "energy_error"\n')
    with pytest.raises(berm.RunError, match="1 of 2 runs failed"):
        berm.study(tmp_path / "study.toml", tmp_path / "out", threads=1, quiet=True)
    assert [row.finished for row in berm.Study(tmp_path / "out").rows] == [True, False]
