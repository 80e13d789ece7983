"""Runs that would write one file at the same time: one writes it, the others say so, and nothing is mixed."""
import subprocess
import time
import unittest

import h5py
import numpy as np

from bad_input.runner import sentences
from program import BIN, BOX, InAFolder

HELD = [*BOX, "-fix", "xmin"]
LONGER = ["mpirun", "-n", "2", BIN / "ritz-reduce", *HELD, "-mesh", "box:1,.4,.3/12,5,5/tet10", "-modes", "60"]
SCENE = '[time]\nstep = 1e-3\nend = {}\n[[load]]\nset = "xmax"\ntotal = [0, 2, 4]\n[[probe]]\nname = "tip"\nset = "xmax"\n'


class Races(InAFolder):
    def setUp(self):
        super().setUp()
        self.processes = []
        self.addCleanup(lambda: [process.kill() or process.communicate() for process in self.processes])

    def start(self, *words):
        process = subprocess.Popen(words, cwd=self.folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.processes.append(process)
        return process

    def end(self, process):
        """The exit code and the sentences of a run."""
        _, err = process.communicate(timeout=120)
        self.processes.remove(process)
        return process.returncode, sentences(err)

    def move(self, end, *words):
        scene = self.folder / f"{end}.toml"
        scene.write_text(SCENE.format(end))
        return self.start(BIN / "ritz-run", "model.h5", "--scene", scene.name, "--frames", "0", *words)

    def await_part(self, name):
        deadline = time.monotonic() + 60
        while not list(self.folder.glob(f"{name}.*.part")):
            self.assertLess(time.monotonic(), deadline)
            time.sleep(.002)

    def refused(self, process, name):
        code, said = self.end(process)
        self.assertEqual((code, len(said)), (2, 1), said)
        self.assertRegex(said[0], rf"{name}( beside the output)?: another run (is writing|has written) this file")

    def test_a_run_that_comes_second_is_refused_at_once(self):
        self.reduce(*HELD, "-quiet")
        first = self.move(1e5, "--output", "a.h5")
        self.await_part("a.h5")
        self.refused(self.move(1, "--output", "a.h5"), "a.h5")
        self.refused(self.move(1, "--output", "b.h5", "--timing", "./a.probes.csv"), "a.probes.csv")
        self.assertEqual(self.end(self.move(1, "--output", "b.h5")), (0, []))
        self.assertIn("b.probes.csv", self.files())
        first.kill()
        self.end(first)
        self.assertEqual(self.end(self.move(1, "--output", "a.h5")), (0, []), "a killed run holds nothing")

    def test_of_many_at_once_one_is_whole(self):
        self.reduce(*HELD, "-quiet")
        for _ in range(3):
            many = [self.move(end) for end in (.2, .3, .4, .5)]
            codes = [self.end(process)[0] for process in many]
            self.assertIn(0, codes)
            self.assertLessEqual(set(codes), {0, 2})
            with h5py.File(self.folder / "motion.h5") as file:
                times = file["times"][:]
            probes = np.loadtxt(self.folder / "probes.csv", delimiter=",", skiprows=1)
            np.testing.assert_allclose(probes[:, 0], times, atol=1e-12)
            self.assertFalse([name for name in self.files() if name.endswith(".part")])

    def test_models(self):
        first = self.start(*LONGER)
        while "  mesh " not in (line := first.stdout.readline()):
            self.assertTrue(line)
        self.refused(self.start(BIN / "ritz-reduce", *HELD, "-quiet"), "model.h5")
        self.assertEqual(self.end(first), (0, []))
        subprocess.run([BIN / "ritz-inspect", "model.h5", "--check"], cwd=self.folder, check=True, timeout=60,
                       stdout=subprocess.DEVNULL)
        np.testing.assert_allclose(self.eigenvalues(), self.body()["modes/eigenvalues"][:], rtol=1e-14)

    def test_what_another_has_written_meanwhile_stays(self):
        """As a run on another machine would, which ours cannot see."""
        process = self.start(*LONGER)
        while "  assemble " not in (line := process.stdout.readline()):
            self.assertTrue(line)
        (self.folder / "frequencies.csv").write_text("another's")
        self.refused(process, "frequencies.csv")
        self.assertEqual({path.name: path.read_text() for path in self.folder.iterdir()}, {"frequencies.csv": "another's"})


if __name__ == "__main__":
    unittest.main()
