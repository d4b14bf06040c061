# SPDX-License-Identifier: BSD-3-Clause
"""Every example is stopped at random moments and resumed; its rows must be those of a run that was not. No run lasts longer than some seconds: rows are
compared as far as both have them, and all files where both ended."""

import glob
import os
import random
import shutil
import signal
import subprocess
import time
import tomllib

import run_folder
from program import ROOT, TIME_LIMIT

STOPPED = 75


def cases():
    """What `berm run` takes; each once, in an order that is always the same."""
    found = []
    for path in sorted(glob.glob(os.path.join(ROOT, "examples", "*", "*.toml"))):
        with open(path, "rb") as file:
            if "stage" in tomllib.load(file):
                found.append(path)
    return found


def rows(folder):
    """Of its history, without the one that a stop adds."""
    try:
        return run_folder.read(os.path.join(folder, "history.csv")).splitlines()[:-1]
    except FileNotFoundError:
        return []


def stop_after(berm, seconds, words):
    """The status of what is stopped after so many seconds; 0 where it ended before."""
    process = berm.start(*words, "--threads", "1")
    try:
        process.wait(timeout=seconds)
    except subprocess.TimeoutExpired:
        process.send_signal(signal.SIGTERM)
    said = process.communicate(timeout=TIME_LIMIT)[1]
    run_folder.expect(process.returncode in (0, STOPPED), f"{' '.join(words)} ends with {process.returncode}: {said.strip()[-300:]}")
    return process.returncode


def torture_case(berm, case, seconds):
    """The number of stops, and of rows that were compared behind the first of them."""
    plain, other = (os.path.join(berm.place, name) for name in ("plain", "stopped"))
    for folder in (plain, other):
        shutil.rmtree(folder, ignore_errors=True)
    begun = ["run", case, "--set", "output.checkpoint_wall_time=1 s", "-o"]
    begin = time.monotonic()
    ended = stop_after(berm, seconds, [*begun, plain]) == 0
    seconds = time.monotonic() - begin  # of a case that is shorter
    wanted, stops, first = len(rows(plain)), 0, None
    status, words = STOPPED, [*begun, other]
    while status == STOPPED and (stops < 3 or len(rows(other)) < wanted or ended):
        # Three stops, and then as long as the other had.
        status = stop_after(berm, random.uniform(0.2, 0.5) * seconds if stops < 3 else 2 * seconds, words)
        stops += status == STOPPED
        if status == STOPPED and not run_folder.has_begun(other):
            continue
        first = len(rows(other)) if first is None else first
        words = ["run", "--resume", other]
    common = min(wanted, len(rows(other)))
    run_folder.expect(rows(other)[:common] == rows(plain)[:common], "its rows differ from those of a run that was not stopped")
    if ended and status == 0:
        differing = run_folder.differences(other, plain)
        run_folder.expect(not differing, ", ".join(differing))
    return stops, max(0, common - (first or 0))


def torture(berm, sample, seconds):
    chosen = cases()
    if sample:
        chosen = random.sample(chosen, min(sample, len(chosen)))
    lost = behind = 0
    for case in chosen:
        name = os.path.relpath(case, ROOT)
        try:
            stops, compared = torture_case(berm, case, seconds)
            behind += compared > 0
            print(f"{name}: {stops} stops, {compared} rows behind the first", flush=True)
        except (run_folder.Damaged, subprocess.TimeoutExpired) as error:
            lost += 1
            print(f"{name}: {error}", flush=True)
    print(f"{len(chosen)} cases, {behind} with rows behind a stop, {lost} with other bytes")
    return lost == 0 and behind > 0
