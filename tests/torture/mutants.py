# SPDX-License-Identifier: BSD-3-Clause
"""Token mutants of all inputs of the examples and of the tests, given to the commands that read them; and of the files of a run folder. Each ends with a clear result:
exit status 0, 1 or 2, or 75 where it was asked to stop; with a message that names the file where that is 2; and with no number that is none."""

import concurrent.futures
import glob
import json
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import threading
import time

import run_folder
import token_mutants

MEMORY = 4 << 30  # bytes, of each process
ENDS_WITHIN = 300  # s after it was asked to stop, on a machine that has other things to do; longer is a hang
NOT_A_NUMBER = re.compile(r"(?<![\w\"'./-])[-+]?(nan|inf)(?![\w\"'.-])")
OF_THE_LIBRARY = re.compile(
    r"std::|vector::|basic_string|map::at|bad_alloc|stoi|stod|terminate|what\(\)|[Aa]ssert|filesystem error|json\.exception|bad variant|bad optional"
)
RUN_FILES = ("summary.json", "origin.json", "history.csv", "history.schema.json", "resolved.toml", "run.log", "frames/frames.pvd", "case.toml")
RUN_FILES += ("checkpoint/case_file.txt",)


class Way:
    """A command that reads mutants: its words, for a file that is called mutant.toml, the texts that it takes, seconds before it is asked to stop, and the exit status
    that it may have besides 0, 1 and 2: where it was asked to stop, and ever."""

    def __init__(self, words, takes, seconds, stopped=75, ever=0):
        self.words, self.takes, self.seconds, self.stopped, self.ever = words, takes, seconds, stopped, ever


def is_study(text):
    return re.search(r"^\[\[(case|axis|table)\]\]|^\[sample\]", text, re.MULTILINE) is not None


def is_element(text):
    return re.search(r"^\[\[test\]\]", text, re.MULTILINE) is not None


def is_case(text):
    return re.search(r"^\[\[stage\]\]|^\[stage|^\[mesh|^\[pipe", text, re.MULTILINE) is not None and not is_study(text)


def is_short(text):
    return is_case(text) and len(text) < 4000


QUEUED = ["--no-wait", "--runner", "true {jobs}"]
ENDED = -signal.SIGTERM  # by a signal, of what keeps nothing
WAYS = {
    "check": Way(["check", "--no-programs", "{}"], is_case, 10, ENDED),
    "check_geo": Way(["check", "{}"], is_case, 20, ENDED),
    "draw": Way(["draw", "{}", "-o", "out.svg"], is_case, 20, ENDED),
    "element": Way(["element", "{}", "-o", "out"], is_element, 10, ENDED),
    "study": Way(["study", "{}", "-o", "out", *QUEUED], is_study, 10, ever=75),
    "study_runs": Way(["study", "{}", "-o", "out", "--threads", "1"], is_study, 3),
    "envelope": Way(["envelope", "{}", "-o", "out", "--points", "2", *QUEUED], is_case, 10, ever=75),
    "envelope_runs": Way(["envelope", "{}", "-o", "out", "--points", "2", "--threads", "1"], is_case, 3),
    "run": Way(["run", "{}", "-o", "out", "--threads", "1"], is_short, 2),
    "uncertainty": Way(["run", "{}", "-o", "out", "--threads", "1", "--uncertainty"], is_short, 2),
    "resume": Way(["run", "--resume", "stopped", "--threads", "1"], None, 3),
    "report": Way(["report", "run", "-o", "page.html"], None, 10, ENDED),
    "export": Way(["export", "run", "-o", "out"], None, 10, ENDED),
}


class Told:
    def __init__(self, status, out, said, asked, seconds):
        self.status, self.out, self.said, self.asked, self.seconds = status, out, said, asked, seconds


class Worker:
    """A copy of all inputs, in which one file at a time is a mutant."""

    def __init__(self, berm, place, root, runs):
        self.berm, self.place = berm, place
        os.makedirs(os.path.join(place, "scratch"))
        for tree in ("examples", "tests/ranks", "tests/samples"):
            shutil.copytree(os.path.join(root, tree), os.path.join(place, tree), ignore=shutil.ignore_patterns("*.ipynb", "*.hpp", "*.cpp"))
        self.runs = runs

    def start(self, words, folder, seconds):
        environment = dict(os.environ, TMPDIR=os.path.join(self.place, "scratch"), OMP_NUM_THREADS="1", GOMP_SPINCOUNT="100")
        begin = time.monotonic()
        with open(os.path.join(self.place, "out"), "w+b") as out, open(os.path.join(self.place, "said"), "w+b") as said:
            process = subprocess.Popen([self.berm, *words], cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=out, stderr=said)
            asked = False
            try:
                process.wait(seconds)
            except subprocess.TimeoutExpired:
                asked = True
                process.send_signal(signal.SIGTERM)
                try:
                    process.wait(ENDS_WITHIN)
                except subprocess.TimeoutExpired:
                    process.kill()
                    process.wait()
                    return Told(None, "", "", asked, time.monotonic() - begin)
            texts = [(file.seek(0), file.read(1 << 20).decode(errors="surrogateescape"))[1] for file in (out, said)]
        return Told(process.returncode, *texts, asked, time.monotonic() - begin)

    def of_inputs(self, way, source, text):
        """Gives a mutant of an input to its command."""
        folder = os.path.join(self.place, os.path.dirname(source))
        results = os.path.join(folder, "out")
        with open(os.path.join(folder, "mutant.toml"), "w", encoding="utf-8", newline="") as file:
            file.write(text)
        told = self.start([word.replace("{}", "mutant.toml") for word in way.words], folder, way.seconds)
        fault = judged(told, way, "mutant.toml") or (way.words[0] == "run" and told.status is not None and of_results(results, told))
        if not fault and way.words[0] == "run" and told.status == 75 and run_folder.has_begun(results):
            again = self.start(["run", "--resume", "out", "--threads", "1"], folder, 1)
            fault = f"its folder is refused then: {again.said[-300:]}" if again.status == 2 else judged(again, way, "out")
        shutil.rmtree(results, ignore_errors=True)
        return told, fault

    def of_a_run(self, way, source, text):
        """Puts a mutant in the place of a file of a run folder."""
        folder = os.path.join(self.place, "runs")
        shutil.rmtree(folder, ignore_errors=True)
        name = source.split("/")[0]
        shutil.copytree(self.runs[name], os.path.join(folder, name))
        with open(os.path.join(folder, source), "w", encoding="utf-8", newline="") as file:
            file.write(text)
        told = self.start(way.words, folder, way.seconds)
        return told, judged(told, way, name)


def judged(told, way, name):
    """What is wrong with the end of a command, or None."""
    if told.status is None:
        return f"hangs: it does not end within {ENDS_WITHIN} s after SIGTERM"
    if told.asked and told.status == ENDED and not told.out + told.said:
        return None  # it had not come to its first word
    if told.status not in {0, 1, 2, way.ever} | ({way.stopped, 75} if told.asked else set()):
        return f"ends with {told.status}"
    errors = [line for line in told.said.splitlines() if line.startswith("berm: ")]
    if told.status in (1, 2) and not errors:
        return f"ends with {told.status} and no message"
    if told.status == 2 and name not in told.said:
        return "its message names no file"
    for words in (told.out, told.said):
        if re.search(r"[\x00-\x08\x0b-\x1f\x7f]", words):
            return "prints control characters"
    if OF_THE_LIBRARY.search(re.sub(r'"[^"]*"', "", told.said)):
        return "its message is one of a library"
    if any(len(line) > 2000 for line in told.said.splitlines()):
        return "its message has thousands of letters"
    number = NOT_A_NUMBER.search(told.out) if told.status == 0 else None
    return number and f"prints {number[0]} as a result"


def of_results(folder, told):
    """What is wrong with what a run left, or None."""
    def refuse(word):
        raise run_folder.Damaged(f"summary.json says {word}")

    try:
        if os.path.isdir(folder):
            run_folder.check(folder)
        summary = os.path.join(folder, "summary.json")
        if os.path.exists(summary):
            with open(summary) as file:
                json.load(file, parse_constant=refuse)
    except run_folder.Damaged as error:
        return str(error)
    return None


class Faults:
    def __init__(self, keep):
        self.keep, self.counts, self.found, self.lock = keep, {}, 0, threading.Lock()

    def note(self, name, number, source, text, told, fault, seed):
        with self.lock:
            counts = self.counts.setdefault(name, {})
            counts[told.status] = counts.get(told.status, 0) + 1
            if not fault:
                return
            self.found += 1
            print(f"{name} of {source}: {fault}; again: mutants --of {name} --seed {seed} --first {number} --number 1\n    {told.said.strip()[-400:]!r}", flush=True)
            if self.keep:
                os.makedirs(self.keep, exist_ok=True)
                with open(os.path.join(self.keep, f"{name}_{seed}_{number}_{source.replace('/', '_')}"), "w", encoding="utf-8", newline="") as file:
                    file.write(text)


def inputs(root, takes):
    found = []
    for pattern in ("examples/*/*.toml", "tests/ranks/*.toml", "tests/samples/*.toml"):
        for path in sorted(glob.glob(os.path.join(root, pattern))):
            with open(path) as file:
                text = file.read()
            if takes(text) and os.path.basename(path) != "mutant.toml":
                found.append((os.path.relpath(path, root), text))
    return found


def files_of_run(name, folder):
    return [(f"{name}/{file}", run_folder.read(os.path.join(folder, file)).decode()) for file in RUN_FILES if os.path.exists(os.path.join(folder, file))]


def sources_of(way, root, runs):
    """Texts of which mutants are made, with their names."""
    if way.takes:
        return inputs(root, way.takes)
    name = "stopped" if "stopped" in way.words else "run"
    return files_of_run(name, runs[name])


def torture(berm, root, options, runs):
    """`runs`: the folders of a run that has ended and of one that was stopped, of which copies are made. Whether all ended well."""
    names, seed = options.of or list(WAYS), options.seed
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, resource.getrlimit(resource.RLIMIT_AS)[1]))
    sources = {name: sources_of(WAYS[name], root, runs) for name in names}
    pool = token_mutants.Pool([text for _, text in inputs(root, lambda text: True)])
    workers = [Worker(berm.program, os.path.join(berm.place, f"worker_{k}"), root, runs) for k in range(options.jobs)]
    faults, end = Faults(options.keep), time.monotonic() + options.seconds
    numbers = iter(range(options.first, options.first + options.number))
    lock = threading.Lock()

    def work(worker):
        while time.monotonic() < end:
            with lock:
                k = next(numbers, None)
            if k is None:
                return
            chance = random.Random(f"{seed} {k}")
            name = names[k % len(names)]
            source, text = chance.choice(sources[name])
            text = token_mutants.mutant(text, pool, chance)
            told, fault = (worker.of_inputs if WAYS[name].takes else worker.of_a_run)(WAYS[name], source, text)
            faults.note(name, k, source, text, told, fault, seed)

    with concurrent.futures.ThreadPoolExecutor(options.jobs) as executor:
        for future in [executor.submit(work, worker) for worker in workers]:
            future.result()
    tried = 0
    for name, counts in faults.counts.items():
        tried += sum(counts.values())
        print(f"{name}: {sum(counts.values())} mutants; ended with {', '.join(f'{status}: {count}' for status, count in sorted(counts.items(), key=str))}")
    print(f"{tried} mutants, {faults.found} faults")
    return tried > 0 and faults.found == 0
