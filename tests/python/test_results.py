# SPDX-License-Identifier: BSD-3-Clause
"""The package reads what a run leaves."""

import csv
import json
import shutil
from pathlib import Path

import berm
import numpy as np
import pytest


def test_history_has_the_numbers_of_the_file(finished: berm.Run) -> None:
    with open(finished.folder / "history.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    history = finished.history
    assert len(history) == len(rows) > 10
    assert history.stage == [row["stage"] for row in rows]
    for name in history:
        assert np.array_equal(history[name], [float(row[name]) for row in rows], equal_nan=True)
    assert history["V"] is history["V_N_m"]
    assert history.unit("V") == "N/m" and history.unit("w") == "m" and history.column("V").meaning == "vertical reaction"
    assert history.in_stage("drag").sum() == history.stage.count("drag")
    with pytest.raises(berm.InputError, match="no column 'v'"):
        history["v"]
    with pytest.raises(berm.InputError, match="there are rest, push, drag"):
        history.in_stage("dragg")


def test_a_row_that_is_being_written_is_left_out_and_a_damaged_one_is_refused(finished: berm.Run, tmp_path: Path) -> None:
    for name in ("history.csv", "history.schema.json"):
        shutil.copy(finished.folder / name, tmp_path)
    file = tmp_path / "history.csv"
    whole = file.read_text()
    file.write_text(whole + "1,drag,0.1")
    assert len(berm.History(file)) == len(finished.history)
    file.write_text(whole + "1,drag,0.1\n")
    with pytest.raises(berm.RunError, match="history.csv.*columns"):
        berm.History(file)


def test_key_results_are_those_of_the_summary(finished: berm.Run) -> None:
    assert finished.finished
    with open(finished.folder / "summary.json") as file:
        entries = json.load(file)["quantities"]
    assert {name: q.value for name, q in finished.quantities.items()} == {name: entry["value"] for name, entry in entries.items()}
    V, w = finished.quantities["V_end_of_push"], finished.quantities["w_end_of_push"]
    assert V.unit == "N/m" and w.unit == "m" and V.meaning
    assert finished.push.w.max() >= w.value > 0
    assert finished.origin["sessions"][0]["version"].startswith(berm.__version__)
    assert finished.case["rigid"]["pipe"]["diameter"] == finished.diameter == 0.02


def test_forces_along_the_depth_are_the_columns_of_their_file(finished: berm.Run, tmp_path: Path) -> None:
    shutil.copy(finished.folder / "resolved.toml", tmp_path)
    rows = "pile,settle,0,0.5,,-100,-90,-40\npile,settle,0.5,1,,-80,-40,0\n"
    (tmp_path / "depth_profile.csv").write_text(f"body,stage,z_top_m,z_bottom_m,H_N_m,V_N_m,axial_top_N,axial_bottom_N\n{rows}")
    profile = berm.open(tmp_path).depth_profile
    assert profile["body"] == ["pile", "pile"] and profile["stage"] == ["settle", "settle"]
    assert profile["V_N_m"].tolist() == [-100, -80] and profile["axial_top_N"].sum() == -130
    assert profile["H_N_m"].shape == (2,) and all(profile["H_N_m"] != profile["H_N_m"])
    with pytest.raises(berm.RunError, match="tz.csv"):
        _ = berm.open(tmp_path).tz


def test_an_invalid_answer_says_why(finished: berm.Run, tmp_path: Path) -> None:
    assert finished.invalid == []
    shutil.copy(finished.folder / "resolved.toml", tmp_path)
    (tmp_path / "summary.json").write_text(json.dumps({"invalid": ["energy does not balance"]}))
    assert berm.open(tmp_path).invalid == ["energy does not balance"]


def test_frames_have_position_and_fields_of_each_particle(finished: berm.Run) -> None:
    assert len(finished.frames) >= 3
    last = finished.frames[-1]
    count = int(finished.summary["timing"]["particles"])
    assert last.position.shape == (count, 3) and last["stress"].shape == (count, 6)
    assert last.field("stress").unit == "Pa" and last.triangles.shape == (0, 6)
    assert [frame.time for frame in finished.frames] == sorted(frame.time for frame in finished.frames)
    assert [frame.stage for frame in finished.frames][:2] == ["rest", "rest"] and last.stage == "drag"
    place = np.argsort(np.argsort(last["id"]))
    moved = last.position - finished.frames[0].position[np.argsort(finished.frames[0]["id"])][place]
    assert np.allclose(moved, last["displacement"], atol=1e-7), "displacement is stored with 24 bits: 6e-8 of centimetres"
    outline = last.rigid_bodies[0]
    assert np.isclose(np.ptp(outline[:, 0]), finished.diameter, rtol=1e-3), "a polygon of a hundred corners and more"
    with pytest.raises(berm.InputError, match="no field"):
        last["stres"]


def test_frames_of_finite_elements_have_their_triangles(finite_elements: berm.Run) -> None:
    last = finite_elements.frames[-1]
    assert last.triangles.shape[1] == 6 and last.triangles.max() < len(last.position)
    corners = last.position[last.triangles[:, :3], :2]
    areas = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 2
    bed = finite_elements.case["mesh"]
    assert 0.9 < areas.sum() / (bed["length"] * bed["depth"]) < 1, "the bed without what the pipe takes of it"


@pytest.mark.parametrize("damage", ["cut", "changed", "text", "gone"])
def test_a_damaged_frame_is_refused_with_its_name(finished: berm.Run, tmp_path: Path, damage: str) -> None:
    whole = finished.frames[-1].file.read_bytes()
    file = tmp_path / "particles_0009.vtu"
    head = whole.index(b"<AppendedData")
    if damage != "gone":
        changed = whole[: head + 200] + bytes(255 - byte for byte in whole[head + 200 : head + 2000]) + whole[head + 2000 :]
        file.write_bytes({"cut": whole[: head + 400], "changed": changed, "text": b"<VTKFile/>"}[damage])
    with pytest.raises(berm.RunError, match="particles_0009.vtu"):
        frame = berm.Frame(0.0, "", file)
        for name in ["position", *frame.fields]:
            frame.position if name == "position" else frame[name]


def test_drags_and_the_way_down_are_those_of_the_stages(finished: berm.Run) -> None:
    history, (drag,) = finished.history, finished.drags
    rows = np.flatnonzero(history.in_stage("drag"))
    assert drag.direction == 1 and len(drag.travel) == len(rows) + 1 and drag.travel[0] == 0
    assert np.array_equal(drag.H[1:], history["H"][rows]) and np.array_equal(drag.travel, drag.u)
    assert np.array_equal(finished.push.w, history["w"][history.in_stage("push")])


def test_a_sweep_back_counts_its_travel_against_x(finished: berm.Run, tmp_path: Path) -> None:
    shutil.copytree(finished.folder, tmp_path / "back")
    file = tmp_path / "back" / "curves.json"
    data = json.loads(file.read_text())
    for chart in data["charts"]:
        for curve in chart["curves"] if chart["chart"] in ("H_u", "w_u", "V_u") else []:
            curve.update(direction=-1, x=[-x for x in curve["x"]])
    file.write_text(json.dumps(data))
    (there,), (back,) = finished.drags, berm.open(tmp_path / "back", berm.Run).drags
    assert np.array_equal(back.u, -there.u) and np.array_equal(back.travel, there.travel) and np.array_equal(back.H, -there.H)


def test_curves_are_those_of_the_file(finished: berm.Run) -> None:
    charts = {chart["chart"]: chart for chart in json.loads((finished.folder / "curves.json").read_text())["charts"]}
    assert set(finished.curves) == set(charts) >= {"V_w", "H_u", "w_u", "V_u", "H_travel"}
    chart = finished.curves["H_u"]
    assert chart["x"] == {"symbol": "u", "unit": "m", "meaning": charts["H_u"]["x"]["meaning"]} and chart["y"]["unit"] == "N/m"
    (drag,) = chart["curves"]
    assert np.array_equal(drag["y"], finished.history["H"][drag["rows"]]) and drag["name"] == "drag" and chart["bands"] == []
    assert np.array_equal(drag["smoothed"], charts["H_u"]["curves"][0]["smoothed"]) and drag["smoothed"].std() < drag["y"].std()


@pytest.mark.parametrize("which", ["of an earlier version", "that went on"])
def test_curves_of_a_run_without_them_are_derived_by_the_program(finished: berm.Run, tmp_path: Path, which: str) -> None:
    shutil.copytree(finished.folder, tmp_path / "run")
    file = tmp_path / "run" / "curves.json"
    if which == "that went on":
        file.write_text(json.dumps({"history_rows": len(finished.history) - 1, "charts": []}))
    else:
        file.unlink()
    run = berm.open(tmp_path / "run", berm.Run)
    assert np.array_equal(run.drags[0].H, finished.drags[0].H) and np.array_equal(run.push.V, finished.push.V)
    smoothed = [each.curves["V_w"]["curves"][0]["smoothed"] for each in (run, finished)]
    assert np.array_equal(*smoothed, equal_nan=True)


def test_curves_that_are_damaged_or_of_another_body_are_refused(finished: berm.Run, tmp_path: Path) -> None:
    shutil.copytree(finished.folder, tmp_path / "run")
    file = tmp_path / "run" / "curves.json"
    data = json.loads(file.read_text())
    file.write_text(json.dumps({**data, "charts": []}))
    for of in ("push", "drags"):
        with pytest.raises(berm.InputError, match="no rigid body is driven"):
            getattr(berm.open(tmp_path / "run"), of)
    file.write_text(json.dumps({**data, "charts": [{"x": []}]}))
    with pytest.raises(berm.RunError, match="curves.json"):
        _ = berm.open(tmp_path / "run", berm.Run).curves


def test_what_is_no_run_is_refused(finished: berm.Run, tmp_path: Path) -> None:
    with pytest.raises(berm.InputError, match="it has no resolved.toml"):
        berm.open(tmp_path)
    with pytest.raises(berm.InputError, match="holds those of sand"):
        berm.open(finished.folder.parent)
    with pytest.raises(berm.InputError, match="no study"):
        berm.open(finished.folder, berm.Study)


def test_a_missing_or_damaged_file_of_a_run_is_named(finished: berm.Run, tmp_path: Path) -> None:
    shutil.copy(finished.folder / "resolved.toml", tmp_path)
    run = berm.open(tmp_path, berm.Run)
    assert not run.finished and run.case["geometry"] == "plane_strain"
    for name in ("summary", "history", "origin"):
        with pytest.raises(berm.RunError, match=name):
            getattr(run, name)
    (tmp_path / "summary.json").write_text("[]")
    with pytest.raises(berm.RunError, match="summary.json: is not a table"):
        run.summary


def test_history_as_a_table_of_pandas(finished: berm.Run) -> None:
    pytest.importorskip("pandas")
    table = finished.history.to_pandas()
    assert list(table.columns) == list(finished.history.columns) and table.attrs["units"]["V_N_m"] == "N/m"
    assert np.array_equal(table["V_N_m"], finished.history["V"]) and list(table["stage"]) == finished.history.stage


def test_history_as_a_dataset_of_xarray(finished: berm.Run) -> None:
    pytest.importorskip("xarray")
    data = finished.history.to_xarray()
    assert data["V_N_m"].attrs["units"] == "N/m" and np.array_equal(data["time_s"], finished.history["time_s"])
    assert float(data["w_m"].max()) == finished.history["w"].max()


def test_a_frame_as_pyvista_reads_it(finished: berm.Run) -> None:
    pytest.importorskip("pyvista")
    assert np.array_equal(finished.frames[-1].to_pyvista().points, finished.frames[-1].position)


def test_a_package_that_is_missing_is_named(finished: berm.Run, monkeypatch: pytest.MonkeyPatch) -> None:
    import sys

    for module, package in (("pandas", "apt-get install python3-pandas, or pip install pandas"), ("pyvista", "pip install pyvista")):
        monkeypatch.setitem(sys.modules, module, None)
        with pytest.raises(ImportError, match=f"{module} is not installed: {package}"):
            finished.history.to_pandas() if module == "pandas" else finished.frames[0].to_pyvista()
