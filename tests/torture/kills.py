# SPDX-License-Identifier: BSD-3-Clause
"""Runs that are killed at random moments, half of them while a checkpoint is half written."""

import os
import random
import shutil
import signal
import subprocess
import time

import calls
import run_folder
from program import LINE, PUSHED_PIPE, ROOT, TIME_LIMIT


def with_checkpoints(words, wall_time):
    return [*words, "--set", f"output.checkpoint_wall_time={wall_time} s"]


def example(name, wall_time, *changes):
    case = ["run", os.path.join(ROOT, "examples", name, "case.toml")]
    return with_checkpoints([*case, *(word for change in changes for word in ("--set", change))], wall_time)


# What is killed, and how often it writes a checkpoint: some twenty times.
CASES = {
    "pipe": with_checkpoints(PUSHED_PIPE, 0.01),
    "line": with_checkpoints(LINE, 0.05),
    "as_springs": with_checkpoints([*LINE, "--set", 'pipeline.slices={spacing=1, to=3, as_spring="always"}'], 0.02),
    **{name: with_checkpoints(calls.RUNS[name], 0.02) for name in ("clay", "water", "water_around_axis", "disks", "space", "earthworks", "elements", "elements_in_water")},
    "seepage": example("seepage", 0.02, "stage.seep.until.time=0.3 s"),
    "motion": example("shaken_base", 0.01),
    "tables": example("load_table", 0.02),
}


def kill_at_random(process, folder, length):
    """At a moment of the first `length` seconds; every second time at the next moment from there on that a checkpoint is half written."""
    try:
        process.wait(timeout=random.uniform(0, length))
        return
    except subprocess.TimeoutExpired:
        pass
    if random.random() < 0.5:
        end = time.monotonic() + length
        while time.monotonic() < end and process.poll() is None and not run_folder.has_half_a_checkpoint(folder):
            time.sleep(0.0005)
    process.send_signal(signal.SIGKILL)


def kill_and_resume(berm, case, folder, reference, kills, length):
    """One run, killed at most `kills` times, each at a random moment. Counts of kills, of those that left half a checkpoint, and of runs that were resumed."""
    shutil.rmtree(folder, ignore_errors=True)
    words, killed, halves, resumed = [*case, "--threads", "1", "-o", folder], 0, 0, 0
    while True:
        complete = run_folder.is_complete(folder)
        process = berm.start(*words)
        if killed < kills:
            kill_at_random(process, folder, length)
        said = process.communicate(timeout=TIME_LIMIT)[1]
        if process.returncode != -signal.SIGKILL:
            break
        killed += 1
        if os.path.isdir(folder):
            run_folder.check(folder, reference, killed=True)
        halves += run_folder.has_half_a_checkpoint(folder)
        if run_folder.has_begun(folder):
            words, resumed = ["run", "--threads", random.choice("12"), "--resume", folder], resumed + 1
    run_folder.expect(process.returncode == 0, f"exit status {process.returncode}: {said.strip()[-300:]}")
    run_folder.check(folder, reference, killed=complete)
    differing = run_folder.differences(folder, reference)
    run_folder.expect(not differing, ", ".join(differing))
    return killed, halves, resumed


def torture_case(berm, name, kills):
    case, reference = CASES[name], os.path.join(berm.place, f"undisturbed_{name}")
    begin = time.monotonic()
    status, said = berm.run(*case, "--threads", "1", "-o", reference)
    length = time.monotonic() - begin
    if status != 0:
        print(f"an undisturbed run ends with {status}: {said}")
        return False
    runs = lost = killed = halves = resumed = 0
    while killed < kills:
        folder = os.path.join(berm.place, "results")
        try:
            # The last of many ends by itself.
            counts = kill_and_resume(berm, case, folder, reference, min(10, kills - killed), 0.7 * length)
            killed, halves, resumed = killed + counts[0], halves + counts[1], resumed + counts[2]
        except run_folder.Damaged as error:
            lost += 1
            print(f"{name}, run {runs}: {error}", flush=True)
            if lost > 10:
                break
        runs += 1
    print(f"{name}: {killed} kills in {runs} runs, {halves} of them while a checkpoint was written, {resumed} times resumed, {lost} runs not survived", flush=True)
    return lost == 0


def torture(berm, names, kills):
    return all([torture_case(berm, name, kills) for name in names])
