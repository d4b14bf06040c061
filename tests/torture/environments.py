# SPDX-License-Identifier: BSD-3-Clause
"""Runs in other environments, whose bytes must be those of a run in a plain one."""

import os
import random
import shutil

import run_folder
from program import LINE, PUSHED_PIPE, ROOT, WIP_PIPE

WATER = ["run", os.path.join(ROOT, "examples", "pipe_consolidation", "in_place.toml"), "--set", "stage.rest.until.time=2 s"]
KINDS = {"pipe": PUSHED_PIPE, "line": LINE, "elements": WIP_PIPE, "water": WATER}
# What programs around berm set, and what it must not compute by.
CHOICES = {
    "OMP_NUM_THREADS": ("1", "2", "4"),
    "OMP_WAIT_POLICY": ("active", "passive"),
    "OMP_DYNAMIC": ("true", "false"),
    "OMP_SCHEDULE": ("static", "dynamic,1", "guided"),
    "OMP_PROC_BIND": ("true", "false", "close"),
    "OMP_STACKSIZE": ("2M", "16M"),
    "GOMP_SPINCOUNT": ("0", "100", "1000000"),
    "GOMP_CPU_AFFINITY": ("0",),
    "OPENBLAS_NUM_THREADS": ("1", "2", "4"),
    "GOTO_NUM_THREADS": ("2",),
    "MKL_NUM_THREADS": ("2",),
    "MALLOC_ARENA_MAX": ("1",),
    "MALLOC_PERTURB_": ("85",),
    "LC_ALL": ("C", "de_DE.UTF-8", "tr_TR.UTF-8"),
    "LANG": ("de_DE.UTF-8",),
    "TZ": ("Asia/Kolkata",),
    "GMSH_HOME": ("/nowhere/",),
}


def some():
    return {name: random.choice(values) for name, values in CHOICES.items() if random.random() < 0.4}


def torture(berm, number):
    """Whether so many environments of each kind of run gave the bytes of a plain one."""
    fine = True
    for kind, words in KINDS.items():
        plain, other = (os.path.join(berm.place, f"{kind}_{name}") for name in ("plain", "other"))
        status, said = berm.run(*words, "--threads", "1", "-o", plain)
        if status != 0:
            print(f"an undisturbed run of a {kind} ends with {status}: {said}")
            return False
        differing = 0
        for _ in range(number):
            environment = some()
            shutil.rmtree(other, ignore_errors=True)
            status, said = berm.run(*words, "--threads", random.choice("123"), "-o", other, **environment)
            found = run_folder.differences(other, plain) if status == 0 else [f"it ends with {status}: {said.strip()[-200:]}"]
            if found:
                differing += 1
                print(f"{kind} with {environment}: {', '.join(found[:5])}", flush=True)
        fine = fine and differing == 0
        print(f"{kind}: {number} environments, {differing} with other bytes", flush=True)
    return fine
