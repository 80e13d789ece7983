"""Runs of the programs: one process, what it cost, and the one sentence that it fails with."""
import os
import re
import subprocess
import tempfile
import time
from dataclasses import dataclass

ENVIRONMENT = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1")


class Failed(Exception):
    """A sentence that says why; `seconds` on the wall until then, 0 where nothing was measured."""

    def __init__(self, reason, seconds=0.0):
        super().__init__(reason)
        self.seconds = seconds


@dataclass(frozen=True)
class Done:
    text: str
    seconds: float  # on the wall
    memory: float  # bytes at the most: of the largest process, times the ranks


def sentence(text):
    """The line of stderr in which a program, or else mpirun, complains."""
    lines = [line for line in text.splitlines() if re.search("[A-Za-z]", line)]
    return next((line for line in lines if line.startswith("ritz-")), lines[0] if lines else "no reason given")


def run(program, words, ranks=1):
    """Under `time`, which is small: a process inherits the peak of the memory of the one that started it."""
    launcher = ["mpirun", "-n", str(ranks)] if ranks > 1 else []
    with tempfile.NamedTemporaryFile("r") as peak:
        timed = ["/usr/bin/time", "-q", "-f", "%M", "-o", peak.name]
        start = time.perf_counter()
        done = subprocess.run([*timed, *launcher, program, *map(str, words)], env=ENVIRONMENT, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        seconds = time.perf_counter() - start
        if done.returncode:
            raise Failed(sentence(done.stdout), seconds)
        return Done(done.stdout, seconds, 1024.0 * int(peak.read()) * ranks)
