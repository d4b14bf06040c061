# SPDX-License-Identifier: BSD-3-Clause
"""Each request for memory fails in turn, alone or with all that follow: one for each way in which the program comes to ask. It ends with
one message and status 1 or 2, or as ever where it gets on without; a run is then resumed, or begun anew, to the bytes of an undisturbed
one. Some libraries end the program by themselves; they are counted apart."""

import bisect
import collections
import os
import random
import re
import shutil
import subprocess

import run_folder
from program import TESTS, run_of

CASES = os.path.join(TESTS, "torture", "cases")
STONE = os.path.join(CASES, "stone.toml")
WRONG = os.path.join(CASES, "study.toml")  # no case
SHIM = "failing_allocations"
# What ends the program by itself where it gets no memory, by a part of the name of the function or its library.
LIBRARIES = ("directory_iterator", "libudunits2", "libexpat", "libgomp", "libmpi", "libhdf5", "libdmumps", "libcrypto")
LIBRARIES += ("nlohmann::", "CLI::", "spdlog::", "toml::", "fmt::")


class Command:
    """What is done, `folder` being that of its results; `kept`: what it starts from, or None; `status`: that of its end where nothing fails."""

    def __init__(self, words, folder, kept=None, status=0):
        self.words, self.folder, self.kept, self.status = words, folder, kept, status

    def prepare(self):
        shutil.rmtree(self.folder, ignore_errors=True)
        if self.kept:
            shutil.copytree(self.kept, self.folder)


def commands_of(berm):
    folder, made = os.path.join(berm.place, "results"), os.path.join(berm.place, "made")
    status, said = berm.run("run", STONE, "--threads", "1", "-o", made)
    run_folder.expect(status == 0, f"an undisturbed run ends with {status}: {said}")
    elements = run_of("fem_case.toml", "stage.push.until.force=20", "stage.drag.until.displacement=0.1 mm")
    return {
        "version": Command(["--version"], folder),
        "refused": Command(["check", WRONG], folder, status=2),
        "check": Command(["check", STONE], folder),
        "report": Command(["report", folder], folder, made),
        "run": Command(["run", STONE, "--threads", "1", "-o", folder], folder),
        "elements": Command([*elements, "--threads", "1", "-o", folder], folder),
    }


class Symbols:
    """Names of the functions of a program, those too that it does not export, by their places."""

    def __init__(self, program):
        lines = (line.split(" ", 2) for line in subprocess.run(["nm", "-C", program], stdout=subprocess.PIPE, text=True).stdout.splitlines())
        self.places = sorted((int(place, 16), name) for place, kind, name in lines if place and kind in "tTwW")

    def name(self, frame):
        place = re.fullmatch(r"berm\+([0-9a-f]+)", frame)
        if not place:
            return frame
        at = bisect.bisect(self.places, (int(place[1], 16), ""))
        return "berm:" + self.places[at - 1][1] if at > 0 else frame

    def culprits(self, frames):
        """The functions that ended the program, up to the innermost of berm's own."""
        names = [self.name(frame) for frame in frames]
        own = next((k for k, name in enumerate(names) if name.startswith("berm:berm::")), len(names))
        return " < ".join(names[: own + 1])


def ways(berm, command):
    """The number of the first request of each way, and the number of all."""
    command.prepare()
    status, said, lines = berm.faulted(command.words, 0, "ONCE", shim=SHIM)
    run_folder.expect(status == command.status, f"where nothing fails it ends with {status}: {said}")
    first = {}
    for at, line in enumerate(lines, 1):
        first.setdefault(line[0], at)
    return list(first.values()), len(lines)


def check_end(status, said, undisturbed):
    run_folder.expect(status in (1, 2) or status == undisturbed, f"ends with {status}")
    if status != 0:
        messages = [line for line in said.splitlines() if line.startswith("berm: ") and not line.startswith("berm: warning: ")]
        run_folder.expect(len(messages) == 1, f"ends with {status} and {len(messages)} messages")


def check_results(berm, command, status, reference):
    """What is left is whole; a run that has failed is done again."""
    if command.words[0] == "run" and status != 0:
        begun = run_folder.has_begun(command.folder)
        status, said = berm.run("run", "--resume", command.folder, "--threads", "1") if begun else berm.run(*command.words)
        run_folder.expect(status == 0, f"{'resumed' if begun else 'begun anew'} it ends with {status}: {said.strip()[-300:]}")
    if status == 0 and os.path.isdir(reference):
        run_folder.check(command.folder, reference, killed=True)
        lost = run_folder.differences(command.folder, reference)
        page = os.path.join(command.folder, "report.html")
        if lost == ["report.html differs"] and b"more than there is memory for" in run_folder.read(page):
            return  # a page says what it could not read
        run_folder.expect(not lost, ", ".join(lost))


def torture_command(berm, name, command, sample, each, symbols):
    """Numbers of requests that failed, of those that berm did not survive, and of those that a library did not, by its name."""
    reference = os.path.join(berm.place, f"undisturbed_{name}")
    firsts, requests = ways(berm, command)
    if os.path.isdir(command.folder):
        shutil.copytree(command.folder, reference)
    if each:
        chosen = range(1, min(each, requests) + 1)
    else:
        chosen = random.sample(firsts, min(sample, len(firsts))) if sample else firsts
    lost, by_libraries = 0, collections.Counter()
    for k, at in enumerate(chosen):
        how = ("ONCE", "EVER")[k % 2]
        command.prepare()
        status, said, stacks = berm.faulted(command.words, at, how, shim=SHIM)
        try:
            try:
                check_end(status, said, command.status)
            except run_folder.Damaged:
                culprit = symbols.culprits([frame for part in stacks[-1] for frame in part.split()]) if len(stacks) > 1 else ""
                library = next((library for library in LIBRARIES if library in culprit), None)
                if not library:
                    raise
                by_libraries[library.strip(":")] += 1
            check_results(berm, command, status, reference)
        except run_folder.Damaged as error:
            lost += 1
            named = [" < ".join(symbols.name(frame) for part in stack for frame in part.split())[:600] for stack in stacks[:1] + stacks[1:][-1:]]
            print("\n    ".join([f"{name}: request {at} {how}: {error}; it said {said.strip()[-300:]!r}", *named]), flush=True)
    libraries = "".join(f", {count} ended by {library}" for library, count in by_libraries.most_common())
    print(f"{name}: {requests} requests in {len(firsts)} ways, {len(chosen)} failed, {lost} not survived{libraries}", flush=True)
    return len(chosen), lost, by_libraries


def torture(berm, names, sample, each):
    symbols, commands = Symbols(berm.program), commands_of(berm)
    tried, lost, by_libraries = 0, 0, collections.Counter()
    for name in names or commands:
        counts = torture_command(berm, name, commands[name], sample, each, symbols)
        tried, lost, by_libraries = tried + counts[0], lost + counts[1], by_libraries + counts[2]
    print(f"{tried} requests failed, {lost} not survived, {sum(by_libraries.values())} ended by libraries")
    return tried > 0 and lost == 0
