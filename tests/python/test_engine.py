# SPDX-License-Identifier: BSD-3-Clause
"""berm.engine steps a case inside this process."""

import gc
import os
import subprocess
import sys
import threading
from pathlib import Path

import berm
import numpy as np
import pytest

engine = pytest.importorskip("berm.engine")


@pytest.fixture
def own_case(case: Path, tmp_path: Path) -> Path:
    """The case with a law of one's own in place of sand's."""
    text = case.read_text()
    begin = text.index("[material.sand]")
    end = text.index("[", begin + 1)
    material = (
        '[material.sand]\nlaw = "user"\nlibrary = "none.so"\nstate_variables = 1\n'
        'density = "1500 kg/m^3"\nyoung_modulus = "7 MPa"\npoisson_ratio = 0.25\n'
    )
    file = tmp_path / "own.toml"
    file.write_text(text[:begin] + material + text[end:])
    return file


def elastic(stress: np.ndarray, strain: np.ndarray, state: np.ndarray, dt: float, time: float) -> None:
    shear, bulk = 7e6 / 2.5, 7e6 / 1.5
    volume = strain[:3].sum()
    stress[:3] += (bulk - 2 * shear / 3) * volume + 2 * shear * strain[:3]
    stress[3:] += shear * strain[3:]
    state[0] += 1


def test_steps_give_the_bytes_of_the_program(case: Path, finished: berm.Run, tmp_path: Path) -> None:
    run = engine.Run(case, folder=tmp_path / "stepped")
    while run.step(100):
        pass
    assert run.finished
    assert (tmp_path / "stepped" / "history.csv").read_bytes() == (finished.folder / "history.csv").read_bytes()


def test_arrays_lie_in_the_memory_of_the_run_and_follow_it(case: Path) -> None:
    run = engine.Run(str(case))
    before = run.particles(run.bodies[0])
    address = before["velocity"].__array_interface__["data"][0]
    still = before["velocity"].copy()
    run.step(50)
    after = run.particles(run.bodies[0])
    assert after["velocity"].__array_interface__["data"][0] == address
    assert not np.array_equal(before["velocity"], still), "the array from before shows the numbers of now"
    assert not before["velocity"].flags.writeable and not before["velocity"].flags.owndata
    alive = after["mass"] > 0
    assert alive.sum() == len(np.unique(after["id"][alive]))


def test_arrays_keep_their_run(case: Path) -> None:
    run = engine.Run(str(case))
    mass = run.particles(run.bodies[0])["mass"]
    total = mass.sum()
    run.stop()
    del run
    gc.collect()
    assert mass.sum() == total


def test_rows_come_as_they_are_written(case: Path, finished: berm.Run) -> None:
    run = engine.Run(str(case))
    times = [run.row["time_s"]]
    run.finish(on_row=lambda now: times.append(now.row["time_s"]))
    assert np.array_equal(times, finished.history["time_s"][: len(times)]) and len(times) >= len(finished.history) - 1


def test_a_law_of_python_computes_the_stress(own_case: Path) -> None:
    calls = []

    def law(*arguments: object) -> None:
        calls.append(1)
        elastic(*arguments)  # type: ignore[arg-type]

    run = engine.Run(str(own_case), laws={"sand": law}, set={"material.sand.can_yield": False})
    at_start = len(calls)
    run.step(3)
    fields = run.particles(run.bodies[0])
    alive = fields["mass"] > 0
    assert len(calls) - at_start == 3 * alive.sum()
    state = next(values for name, values in fields.items() if name.startswith("law_state"))
    assert np.array_equal(np.unique(state[alive]), [3.0])


def test_what_a_law_throws_comes_out_of_the_step(own_case: Path) -> None:
    def law(stress: np.ndarray, strain: np.ndarray, state: np.ndarray, dt: float, time: float) -> None:
        if time > 0:
            raise ZeroDivisionError("of the law")
        elastic(stress, strain, state, dt, time)

    run = engine.Run(str(own_case), laws={"sand": law})
    with pytest.raises(ZeroDivisionError, match="of the law"):
        run.finish()
    assert run.ended and not run.finished


def test_errors_are_those_of_the_package(case: Path, tmp_path: Path) -> None:
    with pytest.raises(berm.InputError, match="no_such_case"):
        engine.Run("no_such_case.toml")
    with pytest.raises(berm.InputError, match="friction_angel"):
        engine.Run(str(case), set={"material.sand.friction_angel": 1})
    with pytest.raises(berm.InputError, match="either a case"):
        engine.Run()
    with pytest.raises(berm.InputError, match="threads"):
        engine.Run(str(case), threads=-3)
    with pytest.raises(TypeError, match="not a function: 3"):
        engine.Run(str(case), laws={"sand": 3})
    run = engine.Run(str(case), folder=str(tmp_path / "run"))
    with pytest.raises(berm.InputError, match="no body"):
        run.particles("snad")
    with pytest.raises(berm.InputError, match="0 or more"):
        run.step(-1)
    run.step(50)
    run.stop()
    resumed = engine.Run(resume=tmp_path / "run")
    assert resumed.steps >= 50
    resumed.finish()
    assert resumed.finished


def test_a_caller_drives_the_body_of_a_stage(case: Path, tmp_path: Path) -> None:
    text = case.read_text()
    begin, end = text.index('[[stage]]\nname = "drag"'), text.index("[output]")
    stage = '[[stage]]\nname = "follow"\nkind = "drive"\ndrive.x.velocity = 0\nuntil.time = "10 ms"\n'
    file = tmp_path / "driven.toml"
    file.write_text(text[:begin] + text[end:] + stage)
    run = engine.Run(str(file))
    with pytest.raises(berm.InputError, match="is not of kind"):
        run.drive(velocity={"x": 1.0})
    while run.stage != "follow":
        run.step()
    other = run.clone()
    del run
    gc.collect()
    before, begin_time = other.rigid_bodies[0], other.time
    other.drive(velocity={"x": 0.2})
    other.limit_time_step(1e-5)
    other.step(100)
    after = other.rigid_bodies[0]
    assert other.time_step == 1e-5
    assert after.displacement[0] - before.displacement[0] == pytest.approx(0.2 * (other.time - begin_time), rel=1e-9)
    assert (after.impulse - before.impulse)[0] < 0
    assert after.angular_velocity[:2].tolist() == [0, 0] and after.torque[:2].tolist() == [0, 0], "about z alone in the plane"
    with pytest.raises(berm.InputError, match='no degree of freedom "u"'):
        other.drive(velocity={"u": 1.0})
    with pytest.raises(berm.InputError, match="a velocity and a force"):
        other.drive(velocity={"x": 1.0}, force={"x": 1.0})


def test_a_clone_keeps_the_laws_of_its_run(own_case: Path) -> None:
    run = engine.Run(str(own_case), laws={"sand": elastic})
    run.step(5)
    other = run.clone()
    run.step(5)
    forces = run.rigid_bodies[0].force
    del run
    gc.collect()
    other.step(5)
    assert np.array_equal(other.rigid_bodies[0].force, forces)


def test_other_threads_go_on_while_a_run_steps(case: Path) -> None:
    run = engine.Run(str(case))
    counted = 0
    done = threading.Event()

    def count() -> None:
        nonlocal counted
        while not done.is_set():
            counted += 1
            done.wait(0.0005)

    beside = threading.Thread(target=count)
    beside.start()
    run.step(500)
    during = counted
    done.set()
    beside.join()
    assert during > 3


def test_messages_go_to_a_function(case: Path) -> None:
    messages: list[str] = []
    engine.Run(str(case), message=messages.append).finish()
    assert any("particles, 1 thread" in line for line in messages)


def test_the_stub_has_the_names_and_arguments_of_the_module(tmp_path: Path) -> None:
    pytest.importorskip("mypy")
    artefacts = tmp_path / "artefacts"  # of pybind11: its metaclass, and an __init__ that throws
    classes = ["MacroElement", "RigidBody", "Run", "RigidBody.__init__", "__test__"]
    artefacts.write_text("".join(f"berm.engine.{name}\n" for name in classes))
    package = str(Path(berm.__file__).parents[1])
    checked = subprocess.run(
        [sys.executable, "-m", "mypy.stubtest", "berm.engine", "--allowlist", str(artefacts), "--ignore-unused-allowlist"],
        cwd=tmp_path, env={**os.environ, "MYPYPATH": package}, capture_output=True, text=True,
    )  # fmt: skip
    assert checked.returncode == 0, checked.stdout + checked.stderr
