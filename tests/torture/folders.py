# SPDX-License-Identifier: BSD-3-Clause
"""Run folders whose files are damaged or do not go together, given to all commands that read them. Each ends with exit status 0, 1 or 2, or 75, and a clear message."""

import os
import random
import re
import shutil

from mutants import judged, Told, Way
from program import LINE, PUSHED_PIPE, ROOT, WIP_PIPE, run_of

EXAMPLES = os.path.join(ROOT, "examples")
# Runs of a second or less: a pipe, a line on slices, a footing, finite elements dry and wet, a body of soil alone.
KINDS = {
    "pipe": PUSHED_PIPE,
    "line": LINE,
    "footing": run_of("clay.toml", "stage.push.until.time=0.2", "stage.turn.until.time=0.2", folder=os.path.join(EXAMPLES, "footing_envelope")),
    "elements": WIP_PIPE,
    "water": run_of("in_place.toml", "mesh.near_size=40 mm", "stage.rest.until.time=0.3 s", folder=os.path.join(EXAMPLES, "pipe_consolidation")),
    "soil": run_of("case.toml", "stage.vibration.until.time=3 s", folder=os.path.join(EXAMPLES, "bar")),
}
COMMANDS = (
    ["report", "{}", "-o", "page.html"],
    ["report", "{}", "{}", "-o", "page.html"],
    ["export", "{}", "-o", "exported"],
    ["export", "{}", "--to", "line", "-o", "exported"],
    ["macro-element", "{}", "-o", "fitted"],
    ["run", "--resume", "{}", "--threads", "1"],
)
WORDS = (b"nan", b"inf", b"-1", b"1e308", b"1e999", b"9223372036854775808", b"", b'"', b"[", b"{", b"\x00", b"\x1b[2J", b"\xff\xfe", b"\n", b",", b"null", b"true", b"a" * 5000, b"../../x")
TEXTS = (".csv", ".json", ".toml", ".log", ".pvd", ".txt", ".vtu", ".h5", ".msh")


def files_in(folder):
    return sorted(os.path.join(place, name) for place, _, names in os.walk(folder) for name in names if name.endswith(TEXTS))


def word_replaced(content):
    found = list(re.finditer(rb'[-+]?\d[\d.eE+-]*|"[^"\n]*"|\w+', content[:200_000]))
    if not found:
        return content
    word = random.choice(found)
    return content[: word.start()] + random.choice(WORDS) + content[word.end() :]


def cut(content):
    return content[: random.randrange(len(content) + 1)]


def piece_gone(content):
    begin = random.randrange(len(content) + 1)
    return content[:begin] + content[begin + random.choice((1, 10, 1000)) :]


def byte_changed(content):
    place = random.randrange(len(content) + 1)
    return content[:place] + bytes([random.randrange(256)]) + content[place + 1 :]


def first_line(content):
    return content.split(b"\n", 1)[0] + b"\n"


CHANGES = {
    "a word is another": word_replaced,
    "cut": cut,
    "a piece is gone": piece_gone,
    "a byte is another": byte_changed,
    "empty": lambda content: b"",
    "its first line alone": first_line,
    "twice": lambda content: content + content,
}


def damage(folder, others):
    """Damages one to three files of a run folder; `others`: run folders of other kinds, of which a file may come. What was done, in words."""
    done = []
    for _ in range(random.choice((1, 1, 1, 2, 3))):
        path = random.choice(files_in(folder))
        name, way = os.path.relpath(path, folder), random.choice((*CHANGES, "gone", "of another run"))
        if way == "gone":
            os.remove(path)
        elif way == "of another run":
            other = os.path.join(random.choice(others), name)
            if not os.path.exists(other):
                continue
            shutil.copyfile(other, path)
        else:
            with open(path, "rb") as file:
                content = file.read()
            with open(path, "wb") as file:
                file.write(CHANGES[way](content))
        done.append(f"{name}: {way}")
        if not files_in(folder):
            break
    return "; ".join(done)


def torture(berm, number, first, keep):
    """Whether so many damaged folders were survived. Their chances begin with their number, so that one can be looked at alone."""
    runs = {}
    for kind, words in KINDS.items():
        runs[kind] = os.path.join(berm.place, "runs", kind)
        status, said = berm.run(*words, "--threads", "1", "-o", runs[kind])
        if status != 0:
            print(f"an undisturbed run of a {kind} ends with {status}: {said}")
            return False
    folder, counts, faults = os.path.join(berm.place, "damaged"), {}, 0
    for k in range(first, first + number):
        random.seed(k)
        kind, command = random.choice(list(KINDS)), random.choice(COMMANDS)
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(runs[kind], folder)
        done = damage(folder, [run for name, run in runs.items() if name != kind])
        process = berm.start(*(word.replace("{}", folder) for word in command), hears=True)
        out, said = process.communicate(timeout=600)
        counts[process.returncode] = counts.get(process.returncode, 0) + 1
        fault = judged(Told(process.returncode, out if command[0] != "report" else "", said, False, 0), Way(command, None, 0), "damaged")
        if process.returncode == 75 or not fault:
            continue
        faults += 1
        print(f"{k}: {kind}, {command[0]}: {done}: {fault}\n    {said.strip()[-300:]!r}", flush=True)
        if keep:
            shutil.copytree(folder, os.path.join(keep, f"folder_{k}"), dirs_exist_ok=True)
    print(f"{number} damaged folders; how the commands ended: {dict(sorted(counts.items()))}; {faults} faults")
    return faults == 0
