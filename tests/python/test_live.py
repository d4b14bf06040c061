# SPDX-License-Identifier: BSD-3-Clause
"""Runs that go on beside Python: progress, stop, resume, and no process that is left."""

import os
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import berm
import numpy as np
import pytest
from berm.live import progress_in

LONG = {"stage.drag.until.displacement": "2 mm", "output.history_time": "1 us"}  # some ten seconds


def until(condition: Callable[[], bool], seconds: float = 60) -> None:
    limit = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < limit, "it did not come"
        time.sleep(0.01)


def begun(run: berm.LiveRun) -> bool:
    return (run.folder / "history.csv").exists()


def children() -> list[str]:
    """Processes of this one, zombies among them."""
    return Path(f"/proc/self/task/{os.getpid()}/children").read_text().split()


def test_a_line_of_the_log_says_how_far_a_run_is() -> None:
    day = "2026-12-01 06:47:13 "
    assert progress_in(f"{day}a.toml -> r: 10 cells\n{day}lay 2  12 %  1 min 05 s left  w 1 mm\nmore") == (0.12, "lay 2", 65)
    assert progress_in(f"{day}heat  3 %  2 h 05 min left  w 1 mm") == (0.03, "heat", 7500)
    assert progress_in(f"{day}heat  3 %  120 ms left") == (0.03, "heat", pytest.approx(0.12))
    unknown = progress_in(f"{day}heat  0 %  ? left  w 1 mm")
    assert unknown is not None and unknown.fraction == 0 and np.isnan(unknown.time_left)
    assert progress_in(f"{day}nothing of the kind") is None


def test_a_run_is_stopped_resumed_and_comes_to_the_same_end(case: Path, tmp_path: Path) -> None:
    before = children()
    with berm.start(case, tmp_path / "run", set=LONG, threads=1) as run:
        assert run.running and run.progress.fraction < 1
        with pytest.raises(TimeoutError):
            run.wait(0.01)
        until(lambda: begun(run) and run.progress.fraction > 0)
        assert run.progress.stage in ("rest", "push", "drag") and f"{run.folder}" in repr(run)
        assert len(run.now.history) > 0
        with pytest.raises(berm.InputError, match="is running"):
            run.resume()
        run.stop()
        assert not run.running and not run.now.finished and any("stopped" in line for line in run.messages)
        finished = run.resume().wait()
        assert finished.finished and run.progress == (1, "drag", 0)
    assert children() == before
    whole = berm.run(case, tmp_path / "whole", set=LONG, threads=1, quiet=True)
    assert np.array_equal(whole.history["H"], finished.history["H"], equal_nan=True)


def test_a_run_that_is_stopped_before_it_began_begins_when_it_is_resumed(case: Path, tmp_path: Path) -> None:
    for wait in (0, 0.01, 0.03, 0.1):  # before and after the program waits for a signal
        with berm.start(case, tmp_path / f"{wait}", threads=1) as run:
            time.sleep(wait)
            run.stop()
            assert not run.running and run.resume().wait().finished


def test_what_the_program_refuses_is_thrown_by_wait(case: Path, tmp_path: Path) -> None:
    run = berm.start(case, tmp_path / "wrong", set={"material.sand.friction_angel": 1})
    with pytest.raises(berm.InputError, match="friction_angel"):
        run.wait()
    with pytest.raises(berm.InputError, match="not a run folder"):
        run.now
    with pytest.raises(berm.InputError, match="either a case"):
        berm.start()


@pytest.mark.parametrize("end", ["", "raise SystemExit(3)", "with run: pass"])
def test_a_run_does_not_outlive_the_python_that_started_it_and_leaves_a_checkpoint(case: Path, tmp_path: Path, end: str) -> None:
    script = f"""
import berm, time
run = berm.start({str(case)!r}, {str(tmp_path / "run")!r}, set={LONG!r}, threads=1)
while not (run.folder / "history.csv").exists(): time.sleep(0.01)
print(run._process.pid)
{end}
"""
    ended = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=120)
    assert ended.returncode == (3 if "3" in end else 0), ended.stderr
    assert not Path(f"/proc/{int(ended.stdout)}").exists()
    assert "stopped at t" in (tmp_path / "run" / "run.log").read_text()
    assert berm.run(resume=tmp_path / "run", threads=1, quiet=True).finished


def test_a_desk_serves_until_it_is_stopped(tmp_path: Path) -> None:
    from urllib.request import urlopen

    before = children()
    with berm.desk(tmp_path, no_browser=True) as desk:
        assert desk.running and desk.address.startswith("http://127.0.0.1:")
        assert b"<html" in urlopen(desk.address, timeout=10).read()[:500]
    assert not desk.running and children() == before
    with pytest.raises(berm.InputError, match="port"):
        berm.desk(tmp_path, port=0, no_browser=True)
