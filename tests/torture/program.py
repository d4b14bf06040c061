# SPDX-License-Identifier: BSD-3-Clause
"""The program that is tortured, and short runs of it."""

import os
import random
import re
import subprocess

import run_folder

TESTS = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
ROOT = os.path.dirname(TESTS)
BUILD = os.path.join(ROOT, "build", "release")
SAMPLES = os.path.join(TESTS, "samples")
RANKS = os.path.join(TESTS, "ranks")
TIME_LIMIT = 600  # s, of a run that takes a part of one


def run_of(case, *changes, folder=SAMPLES):
    """A run of a case of the samples, shortened: a part of a second of computing."""
    return ["run", os.path.join(folder, case), *(word for change in changes for word in ("--set", change))]


# Some hundred steps, some frames.
PUSHED_PIPE = run_of("mpm_case.toml", "mesh.cells=[15, 8]", "body.sand.block.spacing=2.6666667 mm", "stage.rest.until.time=0.5 ms", "output.history_time=0.2 ms")
# The mesh comes from gmsh; an increment or two.
WIP_PIPE = run_of("fem_case.toml", "stage.push.until.force=20", "stage.drag.until.displacement=0.1 mm")
# Four slices that are resolved one after the other, and springs beside; some hundred steps.
LINE = run_of("line.toml", "mesh.cells=[13, 7]", "body.clay.block.spacing=80 mm", 'pipeline.slices={spacing=1, to=3, as_spring="until_sliding"}',
              'pipeline.springs={travel="0.1 m", velocity="0.5 m/s"}', folder=RANKS)


class Berm:
    """The program, with a folder for its temporary files."""

    def __init__(self, options, place):
        self.program, self.shims, self.place = options.berm, options.shims, place
        self.scratch = os.path.join(place, "scratch")
        os.mkdir(self.scratch)

    def start(self, *words, hears=False, **more):
        """hears: its standard output can be read."""
        environment = {**os.environ, "TMPDIR": self.scratch, "OMP_NUM_THREADS": "1", "GOMP_SPINCOUNT": "100", **more}
        return subprocess.Popen([self.program, *words], cwd=self.place, env=environment, text=True, errors="surrogateescape", stderr=subprocess.PIPE,
                                stdout=subprocess.PIPE if hears else subprocess.DEVNULL)

    def run(self, *words, **more):
        """Exit status (negative: the signal that ended it) and what it said."""
        process = self.start(*words, **more)
        _, said = process.communicate(timeout=TIME_LIMIT)
        return process.returncode, said

    def faulted(self, words, at, how, one=False, shim="failing_writes"):
        """The same with a fault, and the calls that failed: (name, path) of each. at = 0: no fault, and all calls. one: not in its children."""
        told = os.path.join(self.place, "told")
        with open(told, "w"):
            pass
        only = {"FAULT_ONE": "1"} if one else {}
        status, said = self.run(*words, LD_PRELOAD=os.path.join(self.shims, f"lib{shim}.so"), FAULT_IN="berm", FAULT_AT=str(at), FAULT_HOW=how, FAULT_TOLD=told, **only)
        with open(told) as file:
            return status, said, [line.rstrip("\n").split(" ", 1) for line in file]

    def calls(self, words, how="EIO", one=False):
        """Those of an undisturbed run."""
        status, said, calls = self.faulted(words, 0, how, one)
        run_folder.expect(status == 0, f"an undisturbed run ends with {status}: {said}")
        return calls


def sample_of(calls, size):
    """Numbers, from 1, of `size` calls: of each kind of call on each kind of file one, before a second of any."""
    kinds = {}
    for at in random.sample(range(1, len(calls) + 1), len(calls)):
        name, path = calls[at - 1]
        kinds.setdefault((name, re.sub(r"\d+", "", os.path.basename(path))), []).append(at)
    rounds = [[alike[n] for alike in kinds.values() if n < len(alike)] for n in range(max(map(len, kinds.values())))]
    return [at for of_each in rounds for at in of_each][:size]
