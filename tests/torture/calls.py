# SPDX-License-Identifier: BSD-3-Clause
"""berm is killed at each call by which it changes files, whatever it does: start, rows, frames, checkpoints and end of a run, a run that is
resumed or replaces another, a study, an envelope, bands, a test of soil, a page, exported tables. Done again, or resumed where a run has
begun, it must leave the bytes of what was not disturbed."""

import os
import random
import shutil
import signal

import run_folder
from program import LINE, PUSHED_PIPE, RANKS, TESTS, WIP_PIPE, run_of, sample_of

CASES = os.path.join(TESTS, "torture", "cases")
EXAMPLES = os.path.join(os.path.dirname(TESTS), "examples")
WATER = ['water.drainage="consolidation"', "water.permeability=1e-3", "water.porosity=0.4", "density=877", "inertia_density=1877"]
CHECKPOINTS = "output.checkpoint_wall_time=0.1 s"
PAUSE = 0.3  # of the calls of a run: there the run of `resumed` was killed


def of_ranks(case, *changes):
    return run_of(f"{case}.toml", CHECKPOINTS, *changes, folder=RANKS)


def in_water(material):
    return [f"material.{material}.{change}" for change in WATER]


LIFTED = ("stage.rest.until.time=2 ms", "stage.push.until.embedment=5 mm", "stage.lift.until.time=4 ms")
LIFTED += ("stage.drag.until.displacement=5 mm", "output.frame_travel=2 mm")
IN_SPACE = ("stage.push.until.embedment=2 mm", "stage.drag.until.displacement=2 mm", "output.frame_travel=1 mm")
SANDY_FLOW = [*in_water("clay"), "material.clay.friction_angle=0.5", "contact.skin.friction_angle=0.3", "contact.skin.adhesion=0"]

SHORT = ("stage.push.until.force=20", "stage.drag.until.displacement=0.1 mm")

# What is done, by its name. The folder of the results comes behind the words.
RUNS = {
    "pipe": [*PUSHED_PIPE, "--set", CHECKPOINTS],
    "clay": of_ranks("clay", *LIFTED),
    "water": of_ranks("sand", *in_water("sand")),
    "around_axis": of_ranks("cone", "stage.push.until.embedment=4 mm"),
    "water_around_axis": of_ranks("cone", "stage.push.until.embedment=1 mm", "stage.hold.until.time=0.5 ms", *in_water("clay"), "material.clay.friction_angle=0.35"),
    "disks": of_ranks("disks"),
    "tied_disks": of_ranks("disks", 'contact.rims.scheme="tied"'),
    "space": of_ranks("sphere", "stage.push.until.embedment=2 mm", "stage.drag.until.displacement=2 mm"),
    "body_in_space": run_of("space_case.toml", CHECKPOINTS, *IN_SPACE),
    "earthworks": of_ranks("works"),
    "line": [*LINE, "--set", CHECKPOINTS],
    "elements": WIP_PIPE,
    "elements_in_water": run_of("fem_case.toml", *SANDY_FLOW, *SHORT),
}
OTHERS = {
    "study": ["study", os.path.join(CASES, "study.toml")],
    "envelope": ["envelope", os.path.join(CASES, "clay_pipe.toml"), "--points", "2", "--travel", "0.01"],
    "bands": [*run_of("fem_case.toml", *SHORT, "fem.contact_size=2 mm", "mesh.near_size=4 mm"), "--uncertainty"],
    "element": ["element", os.path.join(EXAMPLES, "element", "case.toml"), "--force"],
}
HAVE_CHILDREN = ("study", "envelope", "bands")
OF_A_RUN = {"resumed": "pipe", "replaced": "pipe", "report": "pipe", "export": "pipe"}
NAMES = (*RUNS, *OTHERS, *OF_A_RUN)


class Scenario:
    """What is killed, and what is done then."""

    def __init__(self, berm, name):
        self.berm, self.name = berm, name
        self.folder, self.reference, self.before = (os.path.join(berm.place, what) for what in ("results", f"undisturbed_{name}", f"before_{name}"))
        self.one_thread = [] if name in ("element", "report", "export") else ["--threads", "1"]
        run = RUNS[OF_A_RUN.get(name, "pipe")]
        to = ["-o", self.folder]
        if name in RUNS:
            self.words = [*RUNS[name], *to]
        elif name in OTHERS:
            self.words = [*OTHERS[name], *to]
        elif name == "resumed":
            self.words = ["run", "--resume", self.folder]
        elif name == "replaced":
            self.words = [*run, "--force", *to]
        elif name == "report":
            self.words = ["report", self.folder]
        else:
            self.words = ["export", self.folder, "--to", "json"]
        self.words += self.one_thread
        if name in OF_A_RUN:
            self.make_before([*run, *to, "--threads", "1"])

    def make_before(self, words):
        """The folder of a run as it is before the command; for `resumed` that of one that was killed."""
        shutil.rmtree(self.folder, ignore_errors=True)
        calls = self.berm.calls(words, "KILL")
        if self.name == "resumed":
            shutil.rmtree(self.folder)
            self.berm.faulted(words, int(PAUSE * len(calls)), "KILL")
        os.rename(self.folder, self.before)

    def prepare(self):
        shutil.rmtree(self.folder, ignore_errors=True)
        if os.path.isdir(self.before):
            shutil.copytree(self.before, self.folder)

    def again(self):
        """What a job does after the kill: it goes on with a run that has begun."""
        is_run = self.words[0] == "run"
        if not is_run or not run_folder.has_begun(self.folder) or self.name == "replaced" and run_folder.is_complete(self.folder):
            return self.words
        more = ["--uncertainty"] if self.name == "bands" else []
        return ["run", "--resume", self.folder, *self.one_thread, *more]


def killed(scenario, at, one):
    """Whether it was killed, and a line of what is wrong, or None."""
    berm, folder = scenario.berm, scenario.folder
    scenario.prepare()
    status, said, failed = berm.faulted(scenario.words, at, "KILL", one)
    try:
        if not failed:
            run_folder.expect(status == 0, f"is not killed but ends with {status}: {said.strip()[-300:]}")
            return False, None
        allowed = (-signal.SIGKILL,) if one or scenario.name not in HAVE_CHILDREN else (-signal.SIGKILL, 0, 1)
        run_folder.expect(status in allowed, f"is not killed but ends with {status}: {said.strip()[-300:]}")
        words = scenario.again()
        status, said = berm.run(*words)
        run_folder.expect(status == 0, f"berm {words[0]} {words[1]} then ends with {status}: {said.strip()[-300:]}")
        if scenario.name not in HAVE_CHILDREN:
            run_folder.check(folder, scenario.reference, killed=True)  # a finished run that was to be replaced is left with a lock
        lost = run_folder.differences(folder, scenario.reference)
        run_folder.expect(not lost, ", ".join(lost))
    except run_folder.Damaged as error:
        return True, str(error)
    return True, None


def torture(berm, names, sample):
    tried = lost = 0
    for name in names:
        scenario = Scenario(berm, name)
        of_this = lost_of_this = 0
        for one in (True, False) if name in HAVE_CHILDREN else (True,):
            scenario.prepare()
            calls = berm.calls(scenario.words, "KILL", one)
            shutil.rmtree(scenario.reference, ignore_errors=True)
            shutil.copytree(scenario.folder, scenario.reference)
            # Of all processes together there are more calls than any makes.
            for at in sample_of(calls, sample) if sample else range(1, len(calls) + 1):
                was_killed, error = killed(scenario, at, one)
                of_this += was_killed
                if error:
                    lost_of_this += 1
                    print(f"{name} killed at call {at}, {' '.join(calls[at - 1])}{'' if one else ' of any process'}: {error}", flush=True)
        print(f"{name}: {of_this} kills, {lost_of_this} not survived, {len(calls)} calls", flush=True)
        tried, lost = tried + of_this, lost + lost_of_this
    print(f"{tried} kills, {lost} not survived")
    return tried > 0 and lost == 0
