"""A folder to work in, and the programs."""
from __future__ import annotations

import csv
import json
import os
import shlex
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path

import h5py
import numpy as np

PARALLEL = ("ritz-reduce", "ritz-full")
# What no user should see.
TRACES = ("PETSC ERROR", "Traceback", "HDF5-DIAG", "terminate called", "Segmentation", "MPI_ABORT")
SOFT = ["-material_young", "1e6", "-material_poisson", ".3", "-material_density", "1000"]


class Broken(Exception):
    """A program did not do what the row needs to go on."""


@dataclass(frozen=True)
class Ran:
    program: str
    code: int
    out: str
    err: str
    seconds: float

    @property
    def sentence(self):
        """What the program said of its failure, without what mpirun adds."""
        return "\n".join(line for line in self.err.splitlines() if line.startswith(f"{self.program}: "))

    @property
    def warnings(self):
        return [line for line in self.err.splitlines() if "warning: " in line]


def material(young=1e6, poisson=.3, density=1000):
    return ["-material_young", repr(young), "-material_poisson", repr(poisson), "-material_density", repr(density)]


def statics(target, load, steps=1):
    """A scene: `load` on a target such as 'set = "xmax"' or 'vertex = 4', and a probe named tip there."""
    return f'[static]\nsteps = {steps}\n[[load]]\n{target}\n{load}\n[[probe]]\nname = "tip"\n{target}\n'


class Bench:
    def __init__(self, programs, folder, limit=3600):
        self.programs, self.folder, self.limit = Path(programs), Path(folder), limit

    def run(self, program, *words, ranks=2, code=0):
        """`code` None: whatever comes."""
        mpirun = ["mpirun", "-n", str(ranks)] if program in PARALLEL else []
        start = time.monotonic()
        try:
            done = subprocess.run([*mpirun, self.programs / program, *map(str, words)], cwd=self.folder,
                                  capture_output=True, text=True, timeout=self.limit)
        except subprocess.TimeoutExpired:
            raise Broken(f"{program} did not end within {self.limit} s") from None
        ran = Ran(program, done.returncode, done.stdout, done.stderr, time.monotonic() - start)
        if code is not None and ran.code != code:
            raise Broken(f"{shlex.join([program, *map(str, words)])}: exit code {ran.code}: "
                         f"{ran.sentence or ran.err[-300:]}")
        return ran

    def reduce(self, *words, **how):
        return self.run("ritz-reduce", *words, **how)

    def full(self, *words, **how):
        return self.run("ritz-full", *words, **how)

    def move(self, *words, **how):
        return self.run("ritz-run", *words, **how)

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return name

    def tip(self):
        """The last displacement of the only probe, m."""
        return self.table("probes.csv")[1][-1, 1:]

    def files(self):
        return {path.name for path in self.folder.iterdir()}

    def read(self, name, *datasets):
        """Arrays of an HDF5 file."""
        with h5py.File(self.folder / name) as file:
            found = [file[dataset][()] for dataset in datasets]
        return found[0] if len(found) == 1 else found

    def body(self, name, *datasets):
        return self.read(name, *(f"bodies/body/{dataset}" for dataset in datasets))

    def summary(self, name):
        """What -summary wrote."""
        return json.loads((self.folder / name).read_text())

    def table(self, name):
        """Header and rows of a CSV file of numbers."""
        with open(self.folder / name, newline="") as file:
            header, *rows = csv.reader(file)
        return header, np.array(rows, float)

    def modes(self):
        """frequencies.csv, a dictionary a row."""
        with open(self.folder / "frequencies.csv", newline="") as file:
            return list(csv.DictReader(file))

    def frequencies(self, *words, **how):
        """Those of the flexible modes, Hz, of a reduction."""
        self.reduce(*words, "-quiet", **how)
        return np.array([float(row["frequency_hz"]) for row in self.modes() if row["kind"] == "flexible"])

    def certificate(self, name="model.h5"):
        """(how certified, eigenvalues counted below the shift, eigenvalues found)."""
        with h5py.File(self.folder / name) as file:
            of = file["bodies/body/modes/certificate"].attrs
            kind = of["certified"]
            return kind.decode() if isinstance(kind, bytes) else str(kind), int(of["counted"]), int(of["found"])


def default_programs():
    """Where the programs are: RITZ_BIN, else the default build of this tree."""
    built = Path(__file__).resolve().parents[2] / "build/default/bin"
    return Path(os.environ.get("RITZ_BIN", built))
