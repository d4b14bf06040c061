# SPDX-License-Identifier: BSD-3-Clause
"""berm.macro_element steps the C code that berm macro-element writes."""

from __future__ import annotations

import copy
import json
import os
from pathlib import Path

import pytest

import berm

pytest.importorskip("berm.engine")

PARAMETERS = {
    "diameter": 0.5,
    "vertical_stiffness": 1e6,
    "horizontal_stiffness": 8e5,
    "backbone_factor": 1.2e4,
    "backbone_power": 0.5,
    "peak_ratio": 0.35,
    "surface_beta": 0.05,
    "surface_b1": 0.5,
    "surface_b2": 0.6,
    "uplift_ratio": 0.03,
    "flow_slope": 1.5,
    "flow_zero": 0.35,
    "flow_climb": 0.0,
    "first_yield": 0.6,
    "mobilisation_length": 0.01,
    "residual_ratio": 0.6,
    "softening_length": 0.2,
    "berm_rate": 0.0,
    "berm_length": 0.5,
    "berm_reach": 0.1,
    "axial_friction": 0.5,
    "axial_mobilisation": 0.004,
}
UNITS = {
    "diameter": "m",
    "vertical_stiffness": "N/m^2",
    "horizontal_stiffness": "N/m^2",
    "backbone_factor": "N/m",
    "mobilisation_length": "m",
    "softening_length": "m",
    "berm_rate": "N/m^3",
    "berm_length": "m",
    "berm_reach": "m",
    "axial_mobilisation": "m",
}


def write(folder: Path, version: int = 2, **changes: float) -> Path:
    numbers = {**PARAMETERS, **changes}.items()
    parameters: dict[str, object] = {name: {"value": value, "unit": UNITS.get(name, "1")} for name, value in numbers}
    points = {"backbone_w": {"value": [], "unit": "m"}, "backbone_V": {"value": [], "unit": "N/m"}}
    file = folder / "macro_element.json"
    file.write_text(json.dumps({"version": version, "parameters": {**parameters, **points}}))
    return file


def test_inside_the_surface_the_force_is_the_stiffness_times_the_step(tmp_path: Path) -> None:
    pipe = berm.macro_element(write(tmp_path).parent)
    pipe.start(w=0.1, V=2000)
    T, H, V = pipe.step(u=1e-4, w=0.1 - 2e-4)
    assert T == 0
    assert H == pytest.approx(80, abs=1e-9)
    assert V == pytest.approx(1800, abs=1e-9)
    assert pipe.stiffness[1:] == [[0, 8e5, 0], [0, 0, pytest.approx(1e6)]]
    assert (pipe.x, pipe.u, pipe.w, pipe.T, pipe.H, pipe.V) == (0, 1e-4, 0.1 - 2e-4, T, H, V)


def test_a_copy_tries_a_step_and_friction_holds_along_the_pipe(tmp_path: Path) -> None:
    pipe = berm.macro_element(write(tmp_path))
    pipe.start(w=0.1, V=2000)
    trial = copy.copy(pipe)
    trial.step(x=1)
    assert trial.T > 0.5 * 2000
    assert (pipe.x, pipe.T, pipe.stiffness[0][0]) == (0, 0, 0)
    pipe.step(x=1)
    assert (pipe.T, pipe.stiffness) == (trial.T, trial.stiffness)


def test_what_makes_no_sense_is_refused_and_the_state_stays(tmp_path: Path) -> None:
    with pytest.raises(berm.InputError, match=r"parameters.peak_ratio.value: -1 is not more than 0"):
        berm.macro_element(write(tmp_path, peak_ratio=-1))
    with pytest.raises(berm.InputError, match="version: it is 1, and this berm takes 2"):
        berm.macro_element(write(tmp_path, version=1))
    with pytest.raises(berm.InputError, match="no_such"):
        berm.macro_element(tmp_path / "no_such.json")
    (tmp_path / "deep.json").write_text("[" * 100_000)
    with pytest.raises(berm.InputError, match="deep.json: no JSON"):
        berm.macro_element(tmp_path / "deep.json")
    os.mkfifo(tmp_path / "pipe.json")
    with pytest.raises(berm.InputError, match="pipe.json: there is no such file"):
        berm.macro_element(tmp_path / "pipe.json")
    pipe = berm.macro_element(write(tmp_path))
    with pytest.raises(ValueError, match="displacement"):
        pipe.step(u=float("nan"))
    with pytest.raises(TypeError):
        pipe.step(0.001, 0)  # type: ignore[call-arg,misc]
    assert pipe.u == 0
