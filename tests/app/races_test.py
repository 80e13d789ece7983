"""Runs that would write one file at the same time: one writes it, the others say so, and nothing is mixed."""
import unittest

import h5py
import numpy as np

from program import BOX, InAFolder, sentences

HELD = [*BOX, "-fix", "xmin"]
LONGER = [*HELD, "-mesh", "box:1,.4,.3/12,5,5/tet10", "-modes", "60"]
SCENE = '[time]\nstep = 1e-3\nend = {}\n[[load]]\nset = "xmax"\ntotal = [0, 2, 4]\n[[probe]]\nname = "tip"\nset = "xmax"\n'


class Races(InAFolder):
    def setUp(self):
        super().setUp()
        self.processes = []
        self.addCleanup(lambda: [process.kill() or process.communicate() for process in self.processes])

    def start(self, program, *words, **how):
        process = self.bench.start(program, *words, **how)
        self.processes.append(process)
        return process

    def end(self, process):
        """The exit code and the sentences of a run."""
        _, err = process.communicate(timeout=120)
        self.processes.remove(process)
        return process.returncode, sentences(err)

    def start_moving(self, end, *words):
        scene = self.write(f"{end}.toml", SCENE.format(end))
        return self.start("ritz-run", "model.h5", "--scene", scene, "--frames", "0", *words)

    def refused(self, process, name):
        code, said = self.end(process)
        self.assertEqual((code, len(said)), (2, 1), said)
        self.assertRegex(said[0], rf"{name}( beside the output)?: another run (is writing|has written) this file")

    def test_a_run_that_comes_second_is_refused_at_once(self):
        self.reduce(*HELD, "-quiet")
        first = self.start_moving(1e5, "--output", "a.h5")
        self.part("a.h5")(first)
        self.refused(self.start_moving(1, "--output", "a.h5"), "a.h5")
        self.refused(self.start_moving(1, "--output", "b.h5", "--timing", "./a.probes.csv"), "a.probes.csv")
        self.assertEqual(self.end(self.start_moving(1, "--output", "b.h5")), (0, []))
        self.assertIn("b.probes.csv", self.files())
        first.kill()
        self.end(first)
        self.assertEqual(self.end(self.start_moving(1, "--output", "a.h5")), (0, []), "a killed run holds nothing")

    def test_of_many_at_once_one_is_whole(self):
        self.reduce(*HELD, "-quiet")
        for _ in range(3):
            many = [self.start_moving(end) for end in (.2, .3, .4, .5)]
            codes = [self.end(process)[0] for process in many]
            self.assertIn(0, codes)
            self.assertLessEqual(set(codes), {0, 2})
            with h5py.File(self.folder / "motion.h5") as file:
                times = file["times"][:]
            probes = self.table("probes.csv")[1]
            np.testing.assert_allclose(probes[:, 0], times, atol=1e-12)
            self.assertFalse([name for name in self.files() if name.endswith(".part")])

    def test_models(self):
        first = self.start("ritz-reduce", *LONGER)
        self.after("mesh")(first)
        self.refused(self.start("ritz-reduce", *HELD, "-quiet", ranks=0), "model.h5")
        self.assertEqual(self.end(first), (0, []))
        self.inspect("model.h5", "--check")
        np.testing.assert_allclose(self.eigenvalues(), self.body()["modes/eigenvalues"][:], rtol=1e-14)

    def test_what_another_has_written_meanwhile_stays(self):
        """As a run on another machine would, which ours cannot see."""
        process = self.start("ritz-reduce", *LONGER)
        self.after("assemble")(process)
        self.write("frequencies.csv", "another's")
        self.refused(process, "frequencies.csv")
        self.assertEqual({path.name: path.read_text() for path in self.folder.iterdir()}, {"frequencies.csv": "another's"})


if __name__ == "__main__":
    unittest.main()
