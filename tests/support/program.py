"""The programs in a folder of its own for every test, and what they write there."""
import os
import re
import signal
import tempfile
import time
import unittest
from pathlib import Path

import h5py

from bench import Bench, report_of

BIN = Path(os.environ["RITZ_BIN"])
BOX = ["-mesh", "box:1,.4,.3/4,2,2/tet4", "-material_young", "1e6", "-material_poisson", ".3",
       "-material_density", "1000", "-modes", "5"]
# What mpirun says of a non-zero exit, and MPI's files of a write that fails.
BOILERPLATE = re.compile(r"^-{60,}\n.*?^-{60,}\n|^(?:\[[^]\n]*\] )?mca_[^\n]*\n", re.M | re.S)


def sentences(err):
    """All that a program says on stderr but warnings; nothing else may stand there."""
    lines = BOILERPLATE.sub("", err).splitlines()
    return [line for line in lines if line.strip() and not line.startswith("warning: ")]


def heed_signals():
    """A shell starts what it runs in the background with SIGINT and SIGQUIT ignored, and a program leaves them so."""
    for number in (signal.SIGINT, signal.SIGQUIT, signal.SIGHUP):
        if signal.getsignal(number) == signal.SIG_IGN:
            signal.signal(number, signal.SIG_DFL)


class InAFolder(unittest.TestCase):
    """`how`: of Bench.run, ranks, code, limit, environment."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.bench = Bench(BIN, temporary.name, limit=60)
        self.folder = self.bench.folder

    def reduce(self, *words, **how):
        return self.bench.reduce(*words, **({"limit": 120} | how))

    def full(self, *words, **how):
        return self.bench.full(*words, **({"limit": 240} | how))

    def move(self, *words, **how):
        return self.bench.move(*words, **how)

    def inspect(self, *words, **how):
        return self.bench.inspect(*words, **how)

    def run_alone(self, *words, program="ritz-reduce", **how):
        """Without mpirun, whatever the exit code."""
        return self.bench.run(program, *words, **({"ranks": 0, "code": None} | how))

    def after(self, stage):
        """A function that waits until a process says that this stage has ended."""
        def wait(process):
            while f"  {stage} " not in (line := process.stdout.readline()):
                self.assertTrue(line, f"{stage} never ended")
        return wait

    def part(self, name):
        """A function that waits until a process has begun to write this file."""
        def wait(process):
            deadline = time.monotonic() + 60
            while not list(self.folder.glob(f"{name}.*.part")):
                self.assertLess(time.monotonic(), deadline)
        return wait

    def write(self, name, content):
        return self.bench.write(name, content)

    def files(self):
        return self.bench.files()

    def table(self, name):
        return self.bench.table(name)

    def tip(self, name="probes.csv"):
        return self.bench.tip(name)

    def frequencies(self, table="frequencies.csv"):
        return self.bench.modes(table)

    def eigenvalues(self, table="frequencies.csv"):
        return [float(row["eigenvalue"]) for row in self.frequencies(table)]

    def file(self, name):
        """An HDF5 file, open until the test ends."""
        file = h5py.File(self.folder / name)
        self.addCleanup(file.close)
        return file

    def body(self, name="model.h5"):
        return self.file(name)["bodies/body"]

    def report(self, name="model.h5"):
        """What ritz-reduce says in a model: pairs of a stage and its seconds, and its figures by name."""
        with h5py.File(self.folder / name) as file:
            return report_of(file)
