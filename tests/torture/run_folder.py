# SPDX-License-Identifier: BSD-3-Clause
"""What a run folder may look like after a fault: every file whole or absent."""

import json
import os
import re
import struct
import xml.etree.ElementTree as xml


class Damaged(Exception):
    pass


def expect(fine, what):
    if not fine:
        raise Damaged(what)


def read(path):
    with open(path, "rb") as file:
        return file.read()


def check_history(path, reference):
    """Whole rows only, the first ones of an undisturbed run; `reference` is its history, or None."""
    content = read(path)
    expect(content == b"" or content.endswith(b"\n"), f"{path}: ends in half a row")
    lines = content.splitlines()
    columns = {line.count(b",") for line in lines}
    expect(len(columns) <= 1, f"{path}: rows have different numbers of columns")
    if reference is not None:
        same = lines[:-1]  # a run that fails or is stopped ends with a row of its own
        expect(reference.splitlines()[: len(same)] == same, f"{path}: differs from an undisturbed run")


def check_table(path, reference, killed):
    """Of a pipeline: whole rows; those of an undisturbed run where none of a last moment are added."""
    content = read(path)
    expect(content.endswith(b"\n"), f"{path}: ends in half a row")
    expect(reference is None or not killed or reference.startswith(content), f"{path}: differs from an undisturbed run")


def check_vtu(path):
    """The XML ends, and every array lies in the appended data with the length that it announces."""
    content = read(path)
    mark = b'<AppendedData encoding="raw">\n_'
    start, ending = content.find(mark), b"\n</AppendedData>\n</VTKFile>\n"
    expect(start > 0 and content.endswith(ending), f"{path}: is not a whole frame")
    grid = xml.fromstring(content[:start] + b"</VTKFile>")
    data = content[start + len(mark) : -len(ending)]
    end = 0
    for array in grid.iter("DataArray"):
        offset = int(array.get("offset"))
        expect(offset + 24 <= len(data), f"{path}: an array begins behind the end")
        blocks = struct.unpack("<Q", data[offset : offset + 8])[0]
        first = offset + 24 + 8 * blocks
        expect(first <= len(data), f"{path}: an array has more blocks than fit")
        end = max(end, first + sum(struct.unpack(f"<{blocks}Q", data[offset + 24 : first])))
    expect(end == len(data), f"{path}: {len(data)} bytes of data, its arrays say {end}")


def check_collection(path):
    """Every frame that it names is there."""
    for entry in xml.parse(path).getroot().iter("DataSet"):
        expect(os.path.exists(os.path.join(os.path.dirname(path), entry.get("file"))), f"{path}: names {entry.get('file')}, which is not there")


def check_ending(path, ending):
    expect(read(path).rstrip().endswith(ending), f"{path}: is not whole")


def check(folder, reference=None, killed=False):
    """Raises Damaged for what must not be in the folder of a run. `reference`: the folder of an undisturbed run of the same case. `killed`: parts of files
    and the lock may be left, which a run that only fails removes."""
    for parent, _, names in os.walk(folder):
        for name in names:
            path = os.path.join(parent, name)
            same = reference and os.path.join(reference, os.path.relpath(path, folder).removeprefix("start.part/"))
            if name.endswith(".part") or name == "lock":
                expect(killed, f"{path}: is left")
            elif name == "history.csv":
                check_history(path, same and read(same))
            elif name in ("line.csv", "berms.csv", "springs.csv"):
                check_table(path, same and read(same), killed)
            elif name in ("summary.json", "origin.json"):
                json.loads(read(path))
            elif name.endswith(".vtu"):
                check_vtu(path)
            elif name.endswith(".pvd"):
                check_collection(path)
            elif name.endswith(".png"):
                check_ending(path, b"IEND\xaeB`\x82")
            elif name.endswith(".html"):
                check_ending(path, b"</html>")
            elif name.startswith("mesh.") or name in ("case.toml", "resolved.toml", "ground.csv"):
                expect(same is None or read(path) == read(same), f"{path}: differs from that of an undisturbed run")


def check_order(calls):
    """What a power cut must not find: a file with its name that is not on the disk yet, or a checkpoint or summary that knows of more than is on the
    disk. `calls`: (name, path) of those that change files. Files are written beside the steps, which meanwhile add rows: a checkpoint knows of those that were there when it was begun."""
    on_disk = set()
    new_names = set()  # folders with names that are not on the disk
    named = set()
    owed = {}  # by the part of a checkpoint: what of the run was not on the disk when it was begun
    for number, (name, path) in enumerate(calls):
        if name == "open" and path.endswith(".h5.part"):
            run = os.path.dirname(os.path.dirname(path))
            history = os.path.join(run, "history.csv")
            owed.setdefault(path, (new_names & {run}) | ({history} - on_disk))
        elif name == "fsync":
            on_disk.add(path)
            new_names.discard(path)
            for missing in owed.values():
                missing.discard(path)
        elif name in ("write", "sendfile", "ftruncate"):
            on_disk.discard(path)
        elif name == "rename":
            folder, file = os.path.split(path)
            given = {start.replace("/start.part/", "/"): start for start in named if "/start.part/" in start}
            expect(path + ".part" in on_disk or path in given, f"{path}: gets its name before it is on the disk")
            if file == "summary.json":
                expect(os.path.join(folder, "history.csv") in on_disk, f"{path}: gets its name before history.csv is on the disk")
            if file.endswith(".h5"):
                frames = os.path.join(os.path.dirname(folder), "frames")
                expect(frames not in new_names, f"{path}: gets its name before those in {frames} are on the disk")
                missing = owed.pop(path + ".part")
                expect(not missing, f"{path}: gets its name before {missing} are on the disk")
            if file.endswith(".h5") or file == "summary.json":
                there = (call for call, at in calls[number + 1 :] if (call == "fsync" and at == folder) or (call == "rename" and os.path.dirname(at) == folder))
                expect(next(there, None) == "fsync", f"{path}: its name is not forced to the disk")
            if file == "resolved.toml" and path in given:  # from here on the run can be resumed
                for other in ("case.toml", "origin.json", "checkpoint/case_file.txt"):
                    expect(os.path.join(folder, other) in given, f"{path}: gets its name before {other}")
                expect(not any("start.part" in names for names in new_names), f"{path}: gets its name before those of what the run is given are on the disk")
            new_names.add(folder)
            named.add(path)


def results(folder):
    """All files of a run, or of runs in a folder, by name, without what differs from run to run: the log, time taken, machine and date, and the
    sessions of origin.json."""
    found = {}
    for parent, _, names in os.walk(folder):
        for name in names:
            path = os.path.join(parent, name)
            inner = os.path.relpath(path, folder)
            if name in ("run.log", "lock") or "checkpoint" in inner.split(os.sep):
                continue
            content = read(path)
            if name == "summary.json":
                summary = json.loads(content)
                for run in summary.get("uncertainty", {}).get("runs", ()):
                    run.pop("wall_s", None)
                for key in ("machine", "date"):
                    summary.get("text", {}).pop(key, None)
                timing = summary.get("timing", {})
                summary["timing"] = {key: timing[key] for key in ("particles", "cells", "steps") if key in timing}
                content = json.dumps(summary).encode()
            if name == "origin.json":  # a resumed run has a session more, and each its time
                content = json.dumps(json.loads(content)["input_sha256"]).encode()
            found[inner] = content
    return found


def has_begun(folder):
    """Whether a run can be resumed; before, it is begun anew."""
    return os.path.exists(os.path.join(folder, "resolved.toml"))


def is_complete(folder):
    """Whether a run has left all its results; killed then, it leaves its lock, and checkpoints that it was about to remove."""
    return os.path.exists(os.path.join(folder, "summary.json")) and not os.path.exists(os.path.join(folder, "checkpoint", "case_file.txt"))


def has_half_a_checkpoint(folder):
    try:
        return any(name.endswith(".h5.part") for name in os.listdir(os.path.join(folder, "checkpoint")))
    except FileNotFoundError:
        return False


def last_line(folder):
    path = os.path.join(folder, "run.log")
    return (read(path).rstrip().splitlines() or [b""])[-1] if os.path.exists(path) else b""


def log_is_whole(folder, reference):
    """The log ends as that of an undisturbed run: with the name of its folder, or with its bands."""
    ours, theirs = last_line(folder), last_line(reference)
    return b"everything is in" in ours if b"everything is in" in theirs else ours == theirs


def differences(folder, reference):
    """What is not as an undisturbed run of the same case, or an undisturbed study, leaves it, in words."""
    ours, theirs = results(folder), results(reference)
    logs = [path for path, _, names in os.walk(reference) if "run.log" in names]
    inner = sorted(os.path.relpath(log, reference) for log in logs)
    words = [f"{log}/run.log does not go to the end" for log in inner if not log_is_whole(os.path.join(folder, log), os.path.join(reference, log))]
    words += [f"{name} is missing" for name in sorted(theirs.keys() - ours.keys())]
    words += [f"{name} is too many" for name in sorted(ours.keys() - theirs.keys())]
    return words + [f"{name} differs" for name in sorted(ours.keys() & theirs.keys()) if ours[name] != theirs[name]]


def has_reason(text):
    """Whether a message names a file and why it failed."""
    return re.search(r"/\S+.*(No space left on device|Input/output error|File too large)", text) is not None
