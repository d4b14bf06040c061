# SPDX-License-Identifier: BSD-3-Clause
"""Starts the program, by itself or as several ranks of an MPI launcher, finds its processes, and waits for none for ever."""

import os
import shutil
import signal
import subprocess
import time

TIME_LIMIT = 300  # s, of one run
MARK = b"RANKS_TEST"  # the variable by which the processes of one start are found


class Failure(Exception):
    pass


def expect(fine, what):
    if not fine:
        raise Failure(what)


class Ended:
    """How a command ended: its exit status (negative: the signal), and what it printed."""

    def __init__(self, command, status, printed, said):
        self.command, self.status, self.printed, self.said = command, status, printed, said

    def messages(self):
        """Those of berm about what is wrong; not its warnings, nor what the launcher says."""
        return [line for line in self.said.splitlines() if line.startswith("berm: ") and not line.startswith("berm: warning: ")]

    def fails(self, what):
        """The failure of a test that expected something else."""
        return Failure(f"{what}\n    {self.command}\n    exit status {self.status}; it said: {self.said.strip()[-1500:]}")

    def expect(self, fine, what):
        if not fine:
            raise self.fails(what)


def variables_of(process):
    """Those that a process was started with; none where it is gone."""
    try:
        with open(f"/proc/{process}/environ", "rb") as file:
            return dict(entry.split(b"=", 1) for entry in file.read().split(b"\0") if b"=" in entry)
    except OSError:
        return {}


def is_program(process, program):
    """What a program starts has its variables, too."""
    try:
        return os.path.samefile(f"/proc/{process}/exe", program)
    except OSError:  # it has ended
        return False


def send(number, process):
    try:
        os.kill(process, number)
    except ProcessLookupError:
        pass


class Launcher:
    """Of `program`. Its ranks and threads may be more than there are processors."""

    def __init__(self, program, place):
        self.program, self.mpirun, self.starts = program, shutil.which("mpirun"), 0
        self.scratch = os.path.join(place, "temporary")
        os.mkdir(self.scratch)
        # A launcher that is not Open MPI knows none of these.
        self.environment = dict(
            os.environ,
            OMPI_ALLOW_RUN_AS_ROOT="1",
            OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
            OMPI_MCA_rmaps_base_oversubscribe="1",
            OMPI_MCA_hwloc_base_binding_policy="none",
            OMPI_MCA_mpi_yield_when_idle="1",
            OMPI_MCA_btl_vader_single_copy_mechanism="none",  # containers forbid it
            PRTE_MCA_rmaps_default_mapping_policy=":oversubscribe",
            OMP_PROC_BIND="false",
        )

    def is_there(self):
        return self.mpirun and os.path.exists(os.path.join(os.path.dirname(self.program), "lib", "libberm_mpi.so"))

    def starts_processes(self):
        """Some machines let it start none, whatever they run."""
        return subprocess.run([self.mpirun, "-n", "2", "true"], env=self.environment, capture_output=True, timeout=TIME_LIMIT).returncode == 0

    def words(self, *words):
        """The command of one process. It finds no gnuplot: pictures would take longer than all else here."""
        variables = (f"PATH={self.scratch}", f"TMPDIR={self.scratch}", f"{MARK.decode()}={os.getpid()}.{self.starts}")
        return ["/usr/bin/env", *variables, self.program, *words]

    def start(self, of_each, **more):
        """So many processes with so many words: [(1, words)] is one without a launcher."""
        self.starts += 1
        command = []
        for count, words in of_each:
            command += [":", "-n", str(count), *self.words(*words)]
        command = self.words(*of_each[0][1]) if of_each[0][0] == 1 and len(of_each) == 1 else [self.mpirun, *command[1:]]
        process = subprocess.Popen(
            command, env={**self.environment, **more}, text=True, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE
        )
        process.number = self.starts
        return process

    def ranks_of(self, process):
        """The processes of a start that run now, by rank."""
        found = {}
        for name in filter(str.isdigit, os.listdir("/proc")):
            variables = variables_of(name)
            if variables.get(MARK) == f"{os.getpid()}.{process.number}".encode() and is_program(name, self.program):
                named = [variables[rank] for rank in (b"OMPI_COMM_WORLD_RANK", b"PMIX_RANK", b"PMI_RANK") if rank in variables]
                found[int(named[0]) if named else 0] = int(name)
        return found

    def wait(self, process, limit=TIME_LIMIT):
        command = " ".join(process.args)
        try:
            printed, said = process.communicate(timeout=limit)
        except subprocess.TimeoutExpired:
            for each in [*self.ranks_of(process).values(), process.pid]:
                send(signal.SIGKILL, each)
            process.wait()
            raise Failure(f"has not ended after {limit} s: {command}") from None
        return Ended(command, process.returncode, printed, said)

    def run(self, ranks, *words, limit=TIME_LIMIT):
        return self.wait(self.start([(ranks, words)]), limit)

    def run_hastily(self, *of_each, limit=TIME_LIMIT):
        """The same of what ends with another status than 0: Open MPI waits a second, twice, before it ends the other ranks, which have ended."""
        return self.wait(self.start(of_each, OMPI_MCA_odls_base_sigkill_timeout="0"), limit)

    def expect_gone(self, process, seconds=10):
        """That no rank is left of a launcher that has ended."""
        end = time.monotonic() + seconds
        while left := self.ranks_of(process):
            if time.monotonic() > end:
                for each in left.values():
                    send(signal.SIGKILL, each)
                raise Failure(f"the launcher has ended, but after {seconds} s these ranks have not: {sorted(left)}")
            time.sleep(0.05)
