# SPDX-License-Identifier: BSD-3-Clause
"""Long and large runs: how much memory they take, and whether their energy balances."""

import json
import math
import os
import re
import time

SAMPLED_EVERY = 0.02  # s
PROBE_TEST = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), "examples", "probe_test", "case.toml")

COLUMN = """# A column of sand, 1 m wide and 2 m high, that falls in a mesh of 6 m x 2.25 m, as in `bench_steps`.
gravity = [0, "-1 gravity"]

[mesh]
kind = "box"
size = [6, 2.25]
cells = [{columns}, {rows}]

[material.sand]
law = "mohr_coulomb"
density = 1600
young_modulus = "7 MPa"
poisson_ratio = 0.25
friction_angle = "35 deg"

[body.sand]
material = "sand"

[body.sand.block]
center = [0.5, 1]
size = [1, 2]
spacing = {spacing}

[rigid.floor]
shape = "half_plane"
point = [0, 0]
normal = [0, 1]

[contact.floor]
body = "sand"
rigid = "floor"
friction_angle = 0.5

[support.left]
boundary = "left"
fixed = ["x"]
[support.bottom]
boundary = "bottom"
fixed = ["y"]
[support.right]
boundary = "right"
fixed = ["x"]

[[stage]]
name = "fall"
kind = "free"
until.time = {end}

[output]
history_time = {end}
"""


def column_case(particles, time_steps):
    """A case of about so many particles and steps: nine particles in each of two triangles of a square."""
    per_side = round(math.sqrt(particles / 36))
    spacing = 1 / per_side / math.sqrt(18)
    wave_speed = math.sqrt(7e6 / 0.74 / 1600)  # that of compression in this sand
    step = 0.3 / per_side / wave_speed  # about what berm takes
    return COLUMN.format(columns=6 * per_side, rows=round(2.25 * per_side), spacing=spacing, end=time_steps * step)


def sample(process, key):
    """Processor time (s) of the process and a number of its /proc/PID/status (MiB); None where it is gone."""
    try:
        with open(f"/proc/{process.pid}/status") as status, open(f"/proc/{process.pid}/stat") as stat:
            found = re.search(rf"^{key}:\s+(\d+) kB", status.read(), re.MULTILINE)
            ticks = int(stat.read().rpartition(")")[2].split()[11])
    except OSError:
        return None
    return (ticks / os.sysconf("SC_CLK_TCK"), int(found[1]) / 1024) if found else None


def watch(process, key, every):
    """Samples of the process itself, not of its children, until it ends."""
    found = []
    while process.poll() is None:
        found.append(sample(process, key))
        time.sleep(every)
    return [one for one in found if one]


def summary_of(folder):
    with open(os.path.join(folder, "summary.json")) as file:
        return json.load(file)


def ended_well(process):
    said = process.communicate()[1]
    if process.returncode != 0:
        print(f"exit status {process.returncode}: {said.strip()[-300:]}")
    return process.returncode == 0


def memory(berm, sizes, threads):
    """What `berm check` foretells and what a run takes at most, with two frames: within 10 %."""
    fine = True
    print("particles  cells  expected, MiB  taken, MiB")
    for size in sizes:
        case, folder = os.path.join(berm.place, "column.toml"), os.path.join(berm.place, f"column_{size:g}")
        with open(case, "w") as file:
            file.write(column_case(size, 20))
        check = berm.start("check", case, "--threads", threads, hears=True)
        expected = float(re.search(r"memory +about (\d+) MiB", check.communicate()[0])[1])
        run = berm.start("run", case, "--threads", threads, "-o", folder)
        taken = max(mebibytes for _, mebibytes in watch(run, "VmHWM", SAMPLED_EVERY))
        if not ended_well(run):
            return False
        timing = summary_of(folder)["timing"]
        within = abs(taken / expected - 1) <= 0.1
        fine = fine and within
        print(f"{timing['particles']}  {timing['cells']}  {expected:.0f}  {taken:.0f}{'' if within else '  NOT within 10 %'}", flush=True)
    return fine


def soak(berm, particle_steps, threads):
    """The probe test with a shorter drag and a frame each millisecond: memory flat after the first tenth, energy in balance within 1 % of the work done. A
    frame takes memory for a moment, so the least of each tenth counts."""
    folder = os.path.join(berm.place, "soak")
    # A drag of 20 mm takes 3e9 particle-steps, all before it 3.9e8.
    drag = max(0.1, (particle_steps - 3.5e8) / 3e9 * 20)
    changes = (f"stage.drag.until.displacement={drag:.2f} mm", "output.frame_time=1 ms")
    run = berm.start("run", PROBE_TEST, "--threads", threads, "-o", folder, *(word for change in changes for word in ("--set", change)))
    samples = watch(run, "VmRSS", SAMPLED_EVERY)
    if not ended_well(run):
        return False
    summary = summary_of(folder)
    done = summary["timing"]["particles"] * summary["timing"]["steps"]
    # By processor time: the machine may have had other things to do.
    end = samples[-1][0]
    tenths = [min(taken for at, taken in samples if k <= 10 * at / end <= k + 1) for k in range(10)]
    early, late = tenths[1], tenths[9]
    error = summary["checks"]["energy_error"]
    print(f"{done:.3g} particle-steps of {summary['timing']['particles']} particles in {summary['timing']['wall_s']:.0f} s")
    print(f"memory: {early:.1f} MiB after the first tenth, {late:.1f} MiB in the last ({len(samples)} samples; by tenths {tenths})")
    print(f"energy error: {100 * error:.3f} % of the work")
    return done >= particle_steps and late <= 1.05 * early and error < 0.01
