# SPDX-License-Identifier: BSD-3-Clause
"""Each request for memory fails in turn, alone or with all that follow: one for each way in which the program comes to ask. It ends with one message and status 1 or 2, or as ever where a
library gets on without; a run is then resumed, or begun anew, to the bytes of an undisturbed one."""

import collections
import os
import random
import shutil

import run_folder
from program import TESTS, run_of

CASES = os.path.join(TESTS, "torture", "cases")
STONE = os.path.join(CASES, "stone.toml")
WRONG = os.path.join(CASES, "study.toml")  # no case


SHIM = "failing_allocations"


class Command:
    """What is done, `folder` being that of its results; `kept`: what it starts from, or None."""

    def __init__(self, words, folder, kept=None):
        self.words, self.folder, self.kept = words, folder, kept

    def prepare(self):
        shutil.rmtree(self.folder, ignore_errors=True)
        if self.kept:
            shutil.copytree(self.kept, self.folder)


def ways(berm, command):
    """The number of the first request of each way, and the number of all."""
    command.prepare()
    status, said, lines = berm.faulted(command.words, 0, "ONCE", shim=SHIM)
    run_folder.expect(status in (0, 2), f"an undisturbed run ends with {status}: {said}")
    first = {}
    for at, line in enumerate(lines, 1):
        first.setdefault(line[0], at)
    return list(first.values()), len(lines)


def own_messages(said):
    return [line for line in said.splitlines() if line.startswith("berm: ") and not line.startswith("berm: warning: ")]


def check_ending(status, said, undisturbed):
    run_folder.expect(status in (1, 2) or status == undisturbed, f"ends with {status}")
    if status != 0:
        messages = own_messages(said)
        run_folder.expect(len(messages) == 1, f"ends with {status} and {len(messages)} messages")


def check_fault(berm, command, reference, undisturbed, at, how):
    """Who asked, and what is wrong, or None."""
    command.prepare()
    status, said, asked = berm.faulted(command.words, at, how, shim=SHIM)
    who = " ".join(asked[0]) if asked else ""
    try:
        check_ending(status, said, undisturbed)
        if status != 0 and command.words[0] == "run":
            begun = run_folder.has_begun(command.folder)
            status, said = berm.run("run", "--resume", command.folder, "--threads", "1") if begun else berm.run(*command.words)
            run_folder.expect(status == 0, f"{'resumed' if begun else 'begun anew'} it ends with {status}")
        if status == 0 and reference:
            if command.words[0] == "run":
                run_folder.check(command.folder, reference, killed=True)
            lost = run_folder.differences(command.folder, reference)
            run_folder.expect(not lost, ", ".join(lost))
    except run_folder.Damaged as error:
        return who, f"{error}; it said {said.strip()[-300:]!r}"
    return who, None


def commands_of(berm):
    folder, made = os.path.join(berm.place, "results"), os.path.join(berm.place, "made")
    status, said = berm.run("run", STONE, "--threads", "1", "-o", made)
    run_folder.expect(status == 0, f"an undisturbed run ends with {status}: {said}")
    return {
        "version": Command(["--version"], folder),
        "refused": Command(["check", WRONG], folder),
        "check": Command(["check", STONE], folder),
        "report": Command(["report", folder], folder, made),
        "export": Command(["export", folder], folder, made),
        "run": Command(["run", STONE, "--threads", "1", "-o", folder], folder),
        "elements": Command([*run_of("fem_case.toml", "stage.push.until.force=20", "stage.drag.until.displacement=0.1 mm"), "--threads", "1", "-o", folder], folder),
    }


def torture(berm, names, sample):
    tried = lost = 0
    all_commands = commands_of(berm)
    for name in names or all_commands:
        command, reference = all_commands[name], os.path.join(berm.place, f"undisturbed_{name}")
        firsts, requests = ways(berm, command)
        undisturbed = berm.run(*command.words)[0] if name in ("refused", "export") else 0
        if os.path.isdir(command.folder):
            shutil.copytree(command.folder, reference)
        asked = random.sample(firsts, min(sample, len(firsts))) if sample else firsts
        faults = collections.Counter()
        for k, at in enumerate(asked):
            how = ("ONCE", "EVER")[k % 2]
            who, error = check_fault(berm, command, reference if os.path.isdir(reference) else None, undisturbed, at, how)
            if error:
                faults[who] += 1
                print(f"{name}: request {at} {how}: {error}\n    {who[:600]}", flush=True)
        print(f"{name}: {requests} requests in {len(firsts)} ways, {len(asked)} failed, {sum(faults.values())} not survived", flush=True)
        tried, lost = tried + len(asked), lost + sum(faults.values())
    print(f"{tried} requests failed, {lost} not survived")
    return tried > 0 and lost == 0
