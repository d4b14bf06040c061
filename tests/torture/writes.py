# SPDX-License-Identifier: BSD-3-Clause
"""Every call by which berm changes files fails in turn."""

import itertools
import os
import random
import shutil

import run_folder
from program import LINE, PUSHED_PIPE, WIP_PIPE, sample_of


def is_checkpoint(path):
    """Not the folder of that name in which a run is given what it needs."""
    return os.path.basename(path).startswith("step_") or (os.path.basename(path) == "checkpoint" and "/start.part/" not in path)


def check_ending(status, said, failed, folder):
    """Whether a command ends as the calls that failed want it: without a checkpoint a run goes on and says so; all else ends it with a reason. A file may fail
    to close where nothing is lost, its bytes having been on the disk before: then it is as the command says. The names in the run folder
    and in frames are forced to the disk for each checkpoint too: where that fails the checkpoint is left out; after the summary they are forced again."""
    without = "no checkpoint of step" in said
    vital = [call for call in failed if (not is_checkpoint(call[1]) and not (without and call in (["fsync", folder], ["fsync", os.path.join(folder, "frames")]))) or call[0] == "mkdir"]
    if status == 0:
        run_folder.expect(all(name == "close" for name, _ in vital), f"exit status 0, but these calls failed: {vital}")
        # HDF5 opens a file a second time where the first fails; and what has its name already is on the disk.
        lost = any(name != "open" and (name != "close" or path.endswith(".part")) for name, path in failed)
        run_folder.expect(not lost or vital or without, "no warning of a missing checkpoint")
    else:
        run_folder.expect(status == 1, f"exit status {status}")
        run_folder.expect(vital, f"exit status 1, but only these calls failed: {failed}")
        run_folder.expect(run_folder.has_reason(said), "no message names a file and a reason")


def check_fault(berm, words, folder, reference, before, at, how):
    """One run with a fault. `before` prepares the folder; returns a line of what is wrong, or None."""
    before()
    status, said, failed = berm.faulted(words, at, how)
    try:
        check_ending(status, said, failed, folder)
        if status == 0:
            lost = run_folder.differences(folder, reference)
            run_folder.expect(not lost, f"exit status 0, but {', '.join(lost)}")
        run_folder.check(folder, reference)
        run_folder.expect(not os.listdir(berm.scratch), "temporary files are left")
    except run_folder.Damaged as error:
        return f"{' '.join(words)}: call {at} {how}: {error}\n    it said: {said.strip()[-300:]}"


def torture_writes(berm, sample):
    folder = os.path.join(berm.place, "results")

    def clear():
        shutil.rmtree(folder, ignore_errors=True)

    def with_results():
        clear()
        shutil.copytree(os.path.join(berm.place, "pushed_pipe"), folder)

    commands = [(name, [*words, "--threads", "1", "-o", folder], clear) for name, words in (("pushed_pipe", PUSHED_PIPE), ("wip_pipe", WIP_PIPE), ("line", LINE))]
    commands.append(("report", ["report", folder], with_results))
    tried = lost = 0
    for name, words, before in commands:
        before()
        calls = berm.calls(words)
        try:
            run_folder.check_order(calls)
        except run_folder.Damaged as error:
            lost += 1
            print(f"{' '.join(words)}: {error}", flush=True)
        shutil.copytree(folder, os.path.join(berm.place, name))
        ways = ("ENOSPC", "EIO", "EFBIG", "FULL", "SHORT")
        faults = [(at, random.choice(ways)) for at in sample_of(calls, sample)] if sample else itertools.product(range(1, len(calls) + 1), ways)
        for at, how in faults:
            tried += 1
            error = check_fault(berm, words, folder, os.path.join(berm.place, name), before, at, how)
            if error:
                lost += 1
                print(error, flush=True)
        print(f"{name}: {len(calls)} calls", flush=True)
    print(f"{tried} faults, {lost} not survived")
    return tried > 0 and lost == 0
