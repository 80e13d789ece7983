"""Runs of ritz-reduce in a folder of their own."""
import csv
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import h5py

BIN = Path(os.environ["RITZ_BIN"])
BOX = ["-mesh", "box:1,.4,.3/4,2,2/tet4", "-material_young", "1e6", "-material_poisson", ".3",
       "-material_density", "1000", "-modes", "5"]


class InAFolder(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def reduce(self, *words, ranks=2, code=0):
        result = subprocess.run(["mpirun", "-n", str(ranks), BIN / "ritz-reduce", *words], cwd=self.folder,
                                capture_output=True, text=True, timeout=120)
        self.assertEqual(result.returncode, code, result.stderr)
        return result

    def files(self):
        return {path.name for path in self.folder.iterdir()}

    def frequencies(self, folder=".", table="frequencies.csv"):
        with open(self.folder / folder / table, newline="") as file:
            return list(csv.DictReader(file))

    def eigenvalues(self, folder=".", table="frequencies.csv"):
        return [float(row["eigenvalue"]) for row in self.frequencies(folder, table)]

    def body(self, name="model.h5"):
        file = h5py.File(self.folder / name)
        self.addCleanup(file.close)
        return file["bodies/body"]
