# SPDX-License-Identifier: BSD-3-Clause
"""What a run may meet: it is halted and let go on (SIGSTOP, SIGCONT), the clock is set back, its folder gets another name, a rank of an MPI
launcher is killed. It leaves the bytes of an undisturbed run, resumed where it ended before; and two commands on one folder at a time each
end with a clear result, and tear nothing."""

import itertools
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import time

import run_folder
from program import PUSHED_PIPE, TESTS, TIME_LIMIT

sys.path.insert(0, os.path.join(TESTS, "ranks"))
from launcher import Launcher

CASES = os.path.join(TESTS, "torture", "cases")
RUN = [*PUSHED_PIPE, "--threads", "1", "--set", "output.checkpoint_wall_time=0.05 s"]
HALT = 0.05  # s


def expect_whole(folder, reference):
    run_folder.check(folder, reference, killed=True)
    lost = run_folder.differences(folder, reference)
    run_folder.expect(not lost, ", ".join(lost))


def expect_end(berm, *words):
    status, said = berm.run(*words)
    run_folder.expect(status == 0, f"berm {' '.join(words[:2])} ends with {status}: {said.strip()[-300:]}")


def halted(berm, folder, reference, length):
    process = berm.start(*RUN, "-o", folder)
    while process.poll() is None:
        time.sleep(random.uniform(0, length / 5))
        process.send_signal(signal.SIGSTOP)
        time.sleep(random.uniform(0, HALT))
        process.send_signal(signal.SIGCONT)
    said = process.communicate()[1]
    run_folder.expect(process.returncode == 0, f"ends with {process.returncode}: {said.strip()[-300:]}")
    expect_whole(folder, reference)


def with_clock_set_back(berm, folder, reference, length):
    status, said = berm.run(*RUN, "-o", folder, LD_PRELOAD=os.path.join(berm.shims, "libclock_set_back.so"))
    run_folder.expect(status == 0, f"ends with {status}: {said.strip()[-300:]}")
    expect_whole(folder, reference)


def moved(berm, folder, reference, length):
    """The run fails with a message, or ends; in its new place it is resumed."""
    elsewhere = folder + "_elsewhere"
    shutil.rmtree(elsewhere, ignore_errors=True)
    process = berm.start(*RUN, "-o", folder)
    time.sleep(random.uniform(0, 1.2 * length))
    if os.path.isdir(folder):
        os.rename(folder, elsewhere)
    said = process.communicate(timeout=TIME_LIMIT)[1]
    run_folder.expect(process.returncode in (0, 1), f"ends with {process.returncode}: {said.strip()[-300:]}")
    run_folder.expect(process.returncode == 0 or "berm: " in said, "ends with 1 and no message")
    if not os.path.isdir(elsewhere) or not run_folder.has_begun(elsewhere):
        return
    expect_end(berm, "run", "--resume", elsewhere, "--threads", "1")
    lost = [what for what in run_folder.differences(elsewhere, reference) if ".gp" not in what]  # which name the folder
    run_folder.expect(not lost, ", ".join(lost))


class Ranks:
    """Kills one of two or three ranks at random."""

    def __init__(self, berm):
        self.launcher = Launcher(berm.program, berm.place)

    def usable(self):
        return self.launcher.is_there() and self.launcher.starts_processes()

    def __call__(self, berm, folder, reference, length):
        count = random.choice((2, 3))
        process = self.launcher.start([(count, (*RUN, "-o", folder))])
        time.sleep(0.3 + random.uniform(0, 3 * length))
        found = list(self.launcher.ranks_of(process).values())
        if found:
            os.kill(random.choice(found), signal.SIGKILL)
        self.launcher.wait(process, TIME_LIMIT)
        self.launcher.expect_gone(process)
        expect_end(berm, *(("run", "--resume", folder, "--threads", "1") if run_folder.has_begun(folder) else (*RUN, "-o", folder)))
        if not run_folder.is_complete(folder) or os.path.exists(os.path.join(folder, "curves.png")):  # the ranks of the launcher find no gnuplot
            expect_whole(folder, reference)


def undisturbed(berm):
    """Its folder, and how long it took."""
    folder, reference = os.path.join(berm.place, "results"), os.path.join(berm.place, "undisturbed")
    begin = time.monotonic()
    expect_end(berm, *RUN, "-o", folder)
    length = time.monotonic() - begin
    os.rename(folder, reference)
    return folder, reference, length


def torture(berm, number):
    folder, reference, length = undisturbed(berm)
    ranks = Ranks(berm)
    ways = {"halted": halted, "clock set back": with_clock_set_back, "folder moved": moved}
    if ranks.usable():
        ways["rank killed"] = ranks
    lost = 0
    for name, way in ways.items():
        lost_so = 0
        for _ in range(number):
            shutil.rmtree(folder, ignore_errors=True)
            try:
                way(berm, folder, reference, length)
            except (run_folder.Damaged, subprocess.TimeoutExpired) as error:
                lost_so += 1
                print(f"{name}: {error}", flush=True)
        print(f"{name}: {number} runs, {lost_so} not survived", flush=True)
        lost += lost_so
    print(f"{number * len(ways)} runs disturbed, {lost} not survived")
    return lost == 0


def pair_commands(folder):
    """What may be done at the same time with one folder."""
    study, clay, stone = (os.path.join(CASES, f"{name}.toml") for name in ("study", "clay_pipe", "stone"))
    return {
        "run": [*RUN, "-o", folder],
        "replace": [*RUN, "-o", folder, "--force"],
        "other": ["run", stone, "-o", folder, "--force", "--threads", "1"],
        "resume": ["run", "--resume", folder, "--threads", "1"],
        "report": ["report", folder],
        "export": ["export", folder, "--to", "json"],
        "draw": ["draw", stone, "-o", os.path.join(folder, "model.png")],
        "check": ["check", os.path.join(folder, "resolved.toml")],
        "study": ["study", study, "-o", folder, "--threads", "1"],
        "bands": ["run", "--resume", folder, "--uncertainty", "--threads", "1"],
        "envelope": ["envelope", clay, "-o", folder, "--points", "2", "--travel", "0.01", "--threads", "1"],
        "element": ["element", os.path.join(os.path.dirname(TESTS), "examples", "element", "case.toml"), "-o", folder, "--force"],
    }


def pair(berm, first, second, folder, length):
    """Starts one a moment after the other. Raises Damaged for an end that is not clear, or for what is torn."""
    processes = [berm.start(*first)]
    time.sleep(random.uniform(0, length))
    processes.append(berm.start(*second))
    for process, words in zip(processes, (first, second)):
        said = process.communicate(timeout=TIME_LIMIT)[1]
        run_folder.expect(process.returncode in (0, 1, 2), f"berm {words[0]} ends with {process.returncode}: {said.strip()[-300:]}")
        told = process.returncode == 0 or re.search(r"^berm: |^interrupted|^[0-9]+ of", said, re.MULTILINE)
        run_folder.expect(told, f"berm {words[0]} ends with {process.returncode} and no message: {said!r}")
    if os.path.isdir(folder):
        run_folder.check(folder, killed=True)


def torture_pairs(berm, number):
    """All pairs of commands, each on a new folder, that of a finished run and that of one that was killed."""
    folder, reference, length = undisturbed(berm)
    stopped = os.path.join(berm.place, "stopped")
    process = berm.start(*RUN, "-o", folder)
    time.sleep(0.6 * length)
    process.send_signal(signal.SIGTERM)
    process.communicate(timeout=TIME_LIMIT)
    os.rename(folder, stopped)
    commands = pair_commands(folder)
    every = list(itertools.product(commands, commands, (None, reference, stopped)))
    lost = tried = 0
    for first, second, before in random.sample(every, min(number, len(every))) if number else every:
        shutil.rmtree(folder, ignore_errors=True)
        if before:
            shutil.copytree(before, folder)
        tried += 1
        try:
            pair(berm, commands[first], commands[second], folder, length)
        except (run_folder.Damaged, subprocess.TimeoutExpired) as error:
            lost += 1
            print(f"{first} and {second} in {os.path.basename(before) if before else 'a new folder'}: {error}", flush=True)
    print(f"{tried} pairs of commands, {lost} not survived")
    return tried > 0 and lost == 0
