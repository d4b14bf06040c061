# SPDX-License-Identifier: BSD-3-Clause
"""The package starts the program and passes on what it says."""

import os
import shutil
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path

import berm
import numpy as np
import pytest
from berm.program import toml_value


def test_package_and_program_are_of_one_version() -> None:
    assert berm.version() == berm.__version__


def test_a_program_is_taken_by_name_then_from_the_environment_then_from_beside_the_package(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, pretended: Callable[[str], Path]
) -> None:
    named = pretended("echo berm 7.7.7")
    monkeypatch.setenv("BERM", "false")
    assert berm.find_program(named) == str(named) and berm.version(program=named) == "7.7.7"
    assert berm.find_program() == shutil.which("false")
    monkeypatch.setenv("BERM", str(tmp_path / "none"))
    with pytest.raises(berm.RunError, match="none.*environment variable BERM"):
        berm.find_program()
    prefix = tmp_path / "prefix"
    shutil.copytree(Path(berm.__file__).parent, prefix / "lib" / "python3" / "dist-packages" / "berm")
    (prefix / "bin").mkdir()
    shutil.copy(named, prefix / "bin" / "berm")
    environment = {"PATH": "/nowhere", "PYTHONPATH": str(prefix / "lib" / "python3" / "dist-packages")}
    where = [sys.executable, "-c", "import berm; print(berm.find_program())"]
    installed = subprocess.run(where, env=environment, capture_output=True, text=True)
    assert installed.stdout.strip() == str(prefix / "bin" / "berm"), installed.stderr
    (prefix / "bin" / "berm").unlink()
    missing = subprocess.run(where, env=environment, capture_output=True, text=True)
    assert "the program berm is not in PATH" in missing.stderr


@pytest.mark.parametrize(
    ("line", "kind", "message"),
    [
        ("echo 'berm: case.toml:3: wrong' >&2; exit 2", berm.InputError, "^case.toml:3: wrong$"),
        ("echo 'berm: warning: odd' >&2; echo 'berm: it failed' >&2; exit 1", berm.RunError, "^it failed$"),
        ("echo 'berm: warning: stopped at t = 1 s' >&2; echo more >&2; exit 75", berm.Stopped, "^stopped at t = 1 s$"),
        ("kill -KILL $$", berm.RunError, "^berm was ended by SIGKILL"),
        ("echo 'berm: wrong:' >&2; echo 'append this' >&2; exit 2", berm.InputError, "^wrong:\nappend this$"),
        ("echo 'cannot open shared object' >&2; exit 127", berm.RunError, "status 127\ncannot open shared object"),
    ],
)
def test_an_exit_status_is_an_exception_with_the_message(
    pretended: Callable[[str], Path], line: str, kind: type[Exception], message: str
) -> None:
    with pytest.raises(kind, match=message):
        berm.report("out", program=pretended(line))


def test_a_program_that_cannot_be_started_is_named(tmp_path: Path) -> None:
    broken = tmp_path / "broken"
    broken.write_bytes(b"\x7fELF")
    broken.chmod(0o755)
    with pytest.raises(berm.RunError, match="broken"):
        berm.version(program=broken)


def test_progress_goes_to_stderr_unless_quiet(case: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    short = {"stage.drag.until.displacement": "0.1 mm", "stage.push.until.embedment": "0.1 mm"}
    berm.run(case, tmp_path / "loud", set=short, threads=1)
    assert "particles, 1 thread" in capsys.readouterr().err
    berm.run(case, tmp_path / "quiet", set=short, threads=1, quiet=True)
    assert capsys.readouterr().err == ""


def test_a_check_has_findings_and_what_a_run_takes(case: Path) -> None:
    found = berm.check(case, threads=1)
    assert not found.errors and found.effort is not None and found.effort.particles > 0 < found.effort.time
    assert "particles" in str(found) and found.of("note") == [each for each in found if each.level == "note"]
    warning, *others = berm.check(case, set={"body.sand.k0": 4}).warnings
    assert all(each.line and each.file == str(case) for each in others)
    assert warning.set == warning.key == "body.sand.k0" and str(warning).startswith("warning: --set body.sand.k0: ")


def test_what_is_wrong_with_a_case_is_found_with_its_place(case: Path, tmp_path: Path) -> None:
    wrong = tmp_path / "wrong.toml"
    wrong.write_text(case.read_text().replace('law = "mohr_coulomb"', 'law = "mohr_colomb"'))
    found = berm.check(wrong)
    (error,) = found.errors
    line = wrong.read_text()[: wrong.read_text().index("mohr_colomb")].count("\n") + 1
    assert (error.file, error.line, error.key) == (str(wrong), line, "material.sand.law") and "mohr_coulomb" in error.expected
    assert found.effort is None and str(found).startswith(f"error: {wrong}:{line}: material.sand.law: ")
    text = subprocess.run([berm.find_program(), "check", wrong], capture_output=True, text=True).stderr
    assert text.removeprefix("berm: ").startswith(str(error).removeprefix("error: ")), "the same words"
    assert "no such file" in berm.check(tmp_path / "none.toml").errors[0].message
    with pytest.raises(berm.InputError, match="--threads"):
        berm.check(case, threads=0)


def test_changes_are_written_as_toml() -> None:
    assert toml_value("35 deg") == '"35 deg"' and toml_value(True) == "true" and toml_value(3) == "3" and toml_value(0.1) == "0.1"
    assert toml_value([1, "a"]) == '[1, "a"]'
    assert toml_value(np.float64(0.5)) == "0.5" and toml_value(np.int64(4)) == "4" and toml_value(np.bool_(True)) == "true"
    assert toml_value(np.array([0, -9.81])) == "[0.0, -9.81]" and toml_value(np.array(3)) == "3" and toml_value(np.arange(2)) == "[0, 1]"
    assert toml_value(np.array([["a", "b"]])) == '[["a", "b"]]' and toml_value([np.float32(0.5), Path("b/c.csv")]) == '[0.5, "b/c.csv"]'
    assert toml_value(Path("a b.msh")) == '"a b.msh"'
    with pytest.raises(berm.InputError, match="neither a number"):
        toml_value({})


def test_parameters_are_those_of_the_manual() -> None:
    by_path = {(p.path, p.of): p for p in berm.parameters()}
    size = by_path["mesh.near_size", 'kind = "seabed"']
    assert (size.kind, size.unit, size.values, size.default) == ("number", "m", "more than 0 m", "required")
    assert by_path["title", ""].table == "" and by_path["mesh.trench.width", 'kind = "seabed"'].unit == "m"
    assert by_path["material.NAME.friction_angle", 'law = "mohr_coulomb"'].unit == "rad"
    assert by_path["stage.until.embedment", ""].meaning and not any(path.startswith("test.") for path, _ in by_path)
    manual = (Path(os.environ["BERM_SOURCE"]) / "docs" / "parameters.md").read_text()
    of_a_case = manual[: manual.index("## Element tests")]
    assert len(berm.parameters()) == of_a_case.count("\n| `")


def test_a_case_is_changed_by_numbers_of_numpy_and_by_paths(case: Path) -> None:
    sizes = [
        [line for line in str(berm.check(case, set=changes)).splitlines() if "cells" in line]
        for changes in (
            {"gravity": [0.0, -490.5], "mesh.cells": [40, 20]},
            {"gravity": np.array([0, -490.5]), "mesh.cells": np.array([40, 20]), "title": Path("a/b")},
            {},
        )
    ]
    assert sizes[0] == sizes[1] != sizes[2]


def test_a_commented_case_can_be_begun_with(tmp_path: Path) -> None:
    assert "particles" in str(berm.check(berm.new("pipe-in-clay", tmp_path / "pipe.toml")))
    quick = berm.new("pipe-in-clay", tmp_path / "quick.toml", size="quick", soil="kaolin")
    assert "Kaolin" in quick.read_text() and quick.read_text() != (tmp_path / "pipe.toml").read_text()
    (tmp_path / "cpt.csv").write_text("depth_m,qt_MPa\n" + "".join(f"{0.1 * k:.1f},{0.03 + 0.02 * k:.3f}\n" for k in range(1, 40)))
    sounded = [berm.new("pipe-in-clay", tmp_path / f"{n}.toml", cpt=tmp_path / "cpt.csv", n_kt=n).read_text() for n in (12, 15.0)]
    assert sounded[0] != sounded[1]
    with pytest.raises(berm.InputError, match="pipe-in-clai"):
        berm.new("pipe-in-clai", tmp_path / "other.toml")


def test_a_change_changes_the_run_and_a_wrong_one_is_refused_with_its_key(case: Path, tmp_path: Path, finished: berm.Run) -> None:
    changed = berm.run(case, tmp_path / "changed", set={"material.sand.friction_angle": "25 deg"}, threads=1, quiet=True)
    assert changed.history["V"][-1] != finished.history["V"][-1]
    with pytest.raises(berm.InputError, match="material.sand.friction_angel"):
        berm.run(case, tmp_path / "wrong", set={"material.sand.friction_angel": 1}, quiet=True)
    with pytest.raises(berm.InputError, match="--force"):
        berm.run(case, tmp_path / "changed", quiet=True)
    with pytest.raises(berm.InputError, match="either a case"):
        berm.run()


def test_an_interrupt_leaves_a_checkpoint_from_which_a_run_goes_on(case: Path, tmp_path: Path) -> None:
    long = {"stage.drag.until.displacement": "2 mm", "output.history_time": "1 us"}
    folder = tmp_path / "long"

    def interrupt() -> None:
        limit = time.monotonic() + 30
        while not (folder / "history.csv").exists() and time.monotonic() < limit:
            time.sleep(0.01)
        os.kill(os.getpid(), signal.SIGINT)

    threading.Thread(target=interrupt).start()
    with pytest.raises(KeyboardInterrupt):
        berm.run(case, folder, set=long, threads=1, quiet=True)
    assert not berm.open(folder, berm.Run).finished and "stopped at t" in (folder / "run.log").read_text()
    with pytest.raises(berm.InputError, match="allowed: mesh.near_left"):
        berm.run(resume=folder, set={"mesh.depth": "1 m"}, quiet=True)
    assert berm.run(resume=folder, threads=1, quiet=True).finished


def test_a_second_interrupt_ends_a_program_that_does_not_stop(pretended: Callable[[str], Path], tmp_path: Path) -> None:
    begun = tmp_path / "begun"
    stubborn = pretended(f"trap 'trap - INT; echo once > {begun}.once' INT; echo > {begun}; while true; do sleep 0.05; done")

    def interrupt_twice() -> None:
        for sign in (begun, begun.with_suffix(".once")):
            limit = time.monotonic() + 30
            while not sign.exists() and time.monotonic() < limit:
                time.sleep(0.01)
            os.kill(os.getpid(), signal.SIGINT)

    threading.Thread(target=interrupt_twice).start()
    start = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        berm.check("case.toml", program=stubborn)
    assert time.monotonic() - start < 25, "it came to an end by itself"


def test_a_run_is_continued_by_its_case(case: Path, tmp_path: Path) -> None:
    mine = tmp_path / "mine.toml"
    shutil.copy(case, mine)
    begun = berm.run(mine, tmp_path / "out", resume=True, threads=1, quiet=True)
    written = (begun.folder / "history.csv").stat().st_mtime_ns
    again = berm.run(mine, tmp_path / "out", resume=True, quiet=True)
    assert again.finished and (again.folder / "history.csv").stat().st_mtime_ns == written
    with pytest.raises(berm.InputError, match="leave out set"):
        berm.run(mine, tmp_path / "out", set={"title": "x"}, resume=True)
    mine.write_text(mine.read_text() + "# changed\n")
    with pytest.raises(berm.InputError, match="another case"):
        berm.run(mine, tmp_path / "out", resume=True)
    with pytest.raises(berm.InputError, match="without a case"):
        berm.run(mine, resume=tmp_path / "out")


def test_an_element_test_gives_the_rows_of_its_tests(tmp_path: Path) -> None:
    tests = tmp_path / "clay.toml"
    tests.write_text(
        """[material.clay]
law = "mohr_coulomb"
density = "1000 kg/m^3"
young_modulus = "2 MPa"
poisson_ratio = 0.45
cohesion = "5 kPa"
friction_angle = 0
[[test]]
name = "shear"
kind = "simple_shear"
material = "clay"
drained = false
vertical_stress = "20 kPa"
k0 = 1
strain_path = [0.1]
"""
    )
    rows = berm.element(tests, tmp_path / "out")
    assert list(rows) == ["shear"]
    assert rows["shear"].unit("tau_Pa") == "Pa"
    assert np.isclose(rows["shear"]["tau_Pa"].max(), 5000, rtol=1e-6), "s_u of a material without friction is its cohesion"


def test_a_fit_gives_the_keys_that_the_tests_tell(tmp_path: Path) -> None:
    (tmp_path / "box.csv").write_text("shear_strain (%),tau (kPa)\n0,0\n0.1,1\n0.5,4.6\n1,5.1\n5,5\n10,4.9\n")
    case = tmp_path / "fit.toml"
    case.write_text(
        """[material.clay]
law = "mohr_coulomb"
density = "1000 kg/m^3"
young_modulus = "2 MPa"
poisson_ratio = 0.45
cohesion = "8 kPa"
friction_angle = 0
[[free]]
key = "cohesion"
from = "1 kPa"
to = "20 kPa"
[[measured]]
name = "box"
file = "box.csv"
kind = "simple_shear"
drained = false
vertical_stress = "20 kPa"
k0 = 1
"""
    )
    found = berm.fit(case, tmp_path / "out")
    assert np.isclose(found.values["cohesion"], 5000, rtol=0.03), "the mean of the three rows that yield"
    assert 0 < found.errors["cohesion"] < 1000
    assert found.doubts == []
    assert "[material.clay]" in found.material
    with pytest.raises(berm.InputError, match="--force"):
        berm.fit(case, tmp_path / "out")


def test_a_storm_on_contours_gives_the_cyclic_strength(tmp_path: Path) -> None:
    (tmp_path / "contours.csv").write_text("shear_strain,average_stress_ratio,cycles,cyclic_stress_ratio\n0.15,0,1,1\n0.15,0,100,0.6\n")
    storm = tmp_path / "storm.toml"
    storm.write_text('[contours]\ntable = "contours.csv"\n[storm]\ncycles = [10]\nload = [0.4]\n')
    found = berm.cyclic(storm, tmp_path / "out")
    assert np.isclose(found.strength_factor, 0.8), "halfway along a straight contour in log N"
    assert np.isclose(found.load_multiplier, 2)
    assert np.isclose(found.equivalent_cycles, 10)
    assert "0.8 s_u" in found.answer
    assert found.material == ""
    with pytest.raises(berm.InputError, match="--force"):
        berm.cyclic(storm, tmp_path / "out")


def test_a_sounding_becomes_layers(tmp_path: Path) -> None:
    sounding = tmp_path / "sounding.csv"
    rows = [f"{0.1 * i:.1f},{10 if i > 20 else 0.3},{50 if i > 20 else 12}" for i in range(1, 41)]
    sounding.write_text("\n".join(["depth_m,q_t_MPa,f_s_kPa", *rows]) + "\n")
    found = berm.cpt(sounding, tmp_path / "out", n_kt=12, thinnest=0.5)
    assert [layer["soil"] for layer in found.layers][-1] == "sand"
    assert found.layers[-1]["top_m"] == pytest.approx(2.05)
    assert "[material.layer_1]" in found.toml and found.profile.is_file()
    with pytest.raises(berm.InputError, match="--force"):
        berm.cpt(sounding, tmp_path / "out")


def test_a_sea_state_gives_loads_and_load_histories(tmp_path: Path) -> None:
    sea = tmp_path / "sea.toml"
    sea.write_text(
        '[sea]\nspectrum = "jonswap"\nsignificant_height = "4.5 m"\npeak_period = "10 s"\npeakedness = 3.3\n'
        'depth = "30 m"\nduration = "600 s"\n'
        '[pipe]\ndiameter = "0.25 m"\nsubmerged_weight = "400 N/m"\ndrag = 0.9\ninertia = 3.29\nlift = 0.9\n[bed]\nfriction = 0.6\n'
    )
    found = berm.sea(sea, tmp_path / "out", set={"record.seeds": 2})
    assert np.isclose(found.quantities["significant_velocity"], 0.6698, atol=5e-4)
    assert np.isnan(found.quantities["weight_for_half_diameter"]), "its tables are of sand"
    assert [path.name for path in found.records] == ["record_1.csv", "record_2.csv"]
    assert len(found.waves) == 2
    assert "absolute lateral stability" in found.answer
    with pytest.raises(berm.InputError, match="--force"):
        berm.sea(sea, tmp_path / "out")


def test_a_route_gives_springs_by_kp(tmp_path: Path) -> None:
    line = tmp_path / "route.toml"
    line.write_text(
        '[pipe]\ndiameter = "0.4 m"\nwall = "15 mm"\nweight_laying = "1 kN/m"\nweight_operation = "1.2 kN/m"\nlay_factor = 2\n'
        '[operation]\ntemperature_rise = ["60 K"]\npressure_rise = ["10 MPa"]\n'
        '[[section]]\nname = "a"\nkp_from = "0 km"\nkp_to = "3 km"\nfriction_angle = ["33 deg"]\ninterface_angle = ["28 deg"]\n'
        'submerged_unit_weight = "9 kN/m^3"\n'
    )
    found = berm.route(line, tmp_path / "out")
    assert found.rows[0]["section"] == "a" and found.rows[0]["kp_to_km"] == "3"
    assert np.isclose(found.quantities["a.axial_breakout"], found.quantities["a.axial_residual"]), "sand does not remould"
    assert "buckling" in found.answer
    with pytest.raises(berm.InputError, match="--force"):
        berm.route(line, tmp_path / "out")


def test_the_header_of_laws_is_found() -> None:
    assert (berm.include_folder() / "berm" / "law.h").is_file()


def test_a_report_is_written_where_it_says(finished: berm.Run, tmp_path: Path) -> None:
    page = berm.report(finished.folder, output=tmp_path / "page.html")
    assert page.resolve() == (tmp_path / "page.html").resolve() and "<html" in page.read_text()[:500]
