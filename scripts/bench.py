"""A folder to work in and the programs; what they read and write there; words that many scenes share."""
import csv
import json
from pathlib import Path

import h5py
import numpy as np

import programs

SOFT = ["-material_young", "1e6", "-material_poisson", ".3", "-material_density", "1000"]


def material(young=1e6, poisson=.3, density=1000):
    return ["-material_young", repr(young), "-material_poisson", repr(poisson), "-material_density", repr(density)]


def statics(target, load, steps=1):
    """A scene: `load` on a target such as 'set = "xmax"' or 'vertex = 4', and a probe named tip there."""
    return f'[static]\nsteps = {steps}\n[[load]]\n{target}\n{load}\n[[probe]]\nname = "tip"\n{target}\n'


def text(value):
    """Of an HDF5 attribute or dataset, which h5py gives as bytes or as str."""
    return value.decode() if isinstance(value, bytes) else str(value)


def rows(path):
    """A CSV file, a dictionary a row."""
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def table(path):
    """Header and rows of a CSV file of numbers."""
    with open(path, newline="") as file:
        header, *lines = csv.reader(file)
    return header, np.array(lines, float)


def summary(path):
    """What -summary wrote."""
    return json.loads(path.read_text())


def report_of(file):
    """What ritz-reduce says of an open model: pairs of a stage and its seconds, and its figures by name."""
    report = file["report"]
    stages, figures = (zip(map(text, report[names][:]), map(float, report[values][:]))
                       for names, values in (("stages", "seconds"), ("figure_names", "figure_values")))
    return list(stages), dict(figures)


class Bench:
    def __init__(self, where, folder, limit=3600):
        self.programs, self.folder, self.limit = Path(where).resolve(), Path(folder), limit

    def start(self, program, *words, **how):
        """A process; `how`: of `launched` and of programs.start."""
        return programs.start(self.programs / program, *words, **self.launched(program, **how))

    def run(self, program, *words, **how):
        """A program to its end; `how`: of `launched` and of programs.run."""
        return programs.run(self.programs / program, *words, **self.launched(program, **({"limit": self.limit} | how)))

    def launched(self, program, ranks=2, under=(), **how):
        """`ranks`: of a parallel program, 0 without mpirun; `under`: the words that start each of them."""
        started = programs.mpirun(ranks) if program in programs.PARALLEL else []
        return {"under": [*started, *under], "folder": self.folder} | how

    def reduce(self, *words, **how):
        return self.run("ritz-reduce", *words, **how)

    def full(self, *words, **how):
        return self.run("ritz-full", *words, **how)

    def move(self, *words, **how):
        return self.run("ritz-run", *words, **how)

    def inspect(self, *words, **how):
        return self.run("ritz-inspect", *words, **how)

    def write(self, name, content):
        (self.folder / name).write_text(content)
        return name

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
        return summary(self.folder / name)

    def table(self, name):
        return table(self.folder / name)

    def tip(self, name="probes.csv"):
        """The last displacement of the only probe, m."""
        return self.table(name)[1][-1, 1:]

    def modes(self, name="frequencies.csv"):
        return rows(self.folder / name)

    def frequencies(self, *words, **how):
        """Those of the flexible modes, Hz, of a reduction."""
        self.reduce(*words, "-quiet", **how)
        return np.array([float(row["frequency_hz"]) for row in self.modes() if row["kind"] == "flexible"])

    def certificate(self, name="model.h5"):
        """(how certified, eigenvalues counted below the shift, eigenvalues found)."""
        with h5py.File(self.folder / name) as file:
            of = file["bodies/body/modes/certificate"].attrs
            return text(of["certified"]), int(of["counted"]), int(of["found"])
