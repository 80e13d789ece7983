"""The examples do what they say: compared with ritz-run, with each other, and with the programs' own figures."""
import importlib.util
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

import programs
from bench import Bench
from program import BIN

EXAMPLES = Path(__file__).resolve().parents[2] / "examples/python"
in_python = unittest.skipUnless(importlib.util.find_spec("ritz"), "the Python module is not built")
PROBLEM = ("-mesh box:1,.1,.1/10,1,1/tet4 -fix xmin -material_young 1e6 -material_poisson .3 -material_density 1000 "
           "-modes 3 -derivatives 3 -basis 6 -polynomial -quiet").split()
PULL = """[time]
step = 0.01
end = 2
[damping]
alpha = 0.5
[[load]]
vertex = {vertex}
total = [0, 0, -1]
table = [[0, 0], [0.01, 1], [1, 1], [1.01, 0]]
[[probe]]
name = "tip"
vertex = {vertex}
"""


def output(*words):
    return programs.run(*words, limit=200).out


class Examples(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.bench = Bench(BIN, cls.temporary.name, limit=200)
        cls.folder = cls.bench.folder
        cls.model = cls.folder / "model.h5"
        cls.bench.reduce(*PROBLEM, "-output", cls.model, ranks=0)
        with h5py.File(cls.model) as file:
            geometry = file["bodies/body/geometry"]
            cls.vertex = int(geometry["vertex_ids"][np.argmax(geometry["points"][:, 0])])

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_push_moves_as_ritz_run_does(self):
        self.bench.write("scene.toml", PULL.format(vertex=self.vertex))
        self.bench.move(self.model, "--scene", "scene.toml", "--output", "motion.h5")
        there = self.bench.table("probes.csv")[1][1:]
        here = np.array([line.split() for line in output(BIN / "example_push", self.model, self.vertex).splitlines()],
                        float)
        self.assertEqual(here.shape, (200, 4))
        np.testing.assert_allclose(here, there, rtol=1e-7, atol=1e-9 * np.abs(there).max())
        self.assertGreater(np.abs(here[:, 3]).max(), 1e-3)

    def test_push_names_a_vertex_that_is_not_there(self):
        self.assertIn("123456", self.bench.run("example_push", self.model, "123456", code=2).err)

    def test_sixteen_bodies_move_each_by_its_own_force(self):
        ways = [float(line.split()[2]) for line in output(BIN / "example_sixteen", self.model, self.vertex).splitlines()]
        self.assertEqual(len(ways), 16)
        self.assertEqual(ways, sorted(ways))
        self.assertLess(ways[15], 16 * ways[0])  # the rubber stiffens
        one = np.array([line.split() for line in output(BIN / "example_push", self.model, self.vertex).splitlines()], float)
        self.assertAlmostEqual(ways[0], np.linalg.norm(one[:100, 1:], axis=1).max(), delta=1e-8 * ways[0])

    @in_python
    def test_push_in_python_prints_the_same(self):
        self.assertEqual(output("/usr/bin/python3", EXAMPLES / "push.py", self.model, self.vertex),
                         output(BIN / "example_push", self.model, self.vertex))

    @in_python
    def test_evaluate_is_what_numpy_makes_of_the_coefficients(self):
        sys.path.insert(0, str(EXAMPLES))
        import evaluate
        import ritz
        body = ritz.read(self.model)
        z, side = .02 * np.linspace(1, -1, body.r), 1e-6
        there = evaluate.by_numpy(body.polynomial, z)
        for here, expected in zip(body.equation().evaluate(z), there):
            np.testing.assert_allclose(here, expected, rtol=1e-12, atol=1e-12 * np.abs(expected).max())
        stiffness = body.reduction.stiffness
        np.testing.assert_allclose(evaluate.by_numpy(body.polynomial, 0 * z)[2], np.diag(stiffness),
                                   atol=1e-9 * stiffness.max())
        for i, unit in enumerate(side * np.eye(body.r)):
            above, below = (evaluate.by_numpy(body.polynomial, at) for at in (z + unit, z - unit))
            self.assertAlmostEqual((above[0] - below[0]) / 2 / side, there[1][i], delta=1e-6 * np.abs(there[1]).max())
            np.testing.assert_allclose((above[1] - below[1]) / 2 / side, there[2][i], atol=1e-6 * np.abs(there[2]).max())
        said = output("/usr/bin/python3", EXAMPLES / "evaluate.py", self.model, ",".join(map(str, z)))
        self.assertIn(f"energy {there[0]:.10g}"[:-1], said)

    @in_python
    def test_sweep_converges_and_draws(self):
        said = output("/usr/bin/python3", EXAMPLES / "sweep.py", BIN, self.folder / "sweep")
        errors = [float(line.split("tip ")[1].split()[0]) for line in said.splitlines()]
        self.assertEqual(len(errors), 6)
        self.assertLess(errors[-1], .02)
        self.assertLess(errors[-1], errors[0] / 10)
        self.assertTrue((self.folder / "sweep/sweep.png").read_bytes().startswith(b"\x89PNG"))

    @in_python
    def test_pod_comes_near_to_what_it_has_not_seen(self):
        said = output("/usr/bin/python3", EXAMPLES / "pod.py", BIN, self.folder / "pod")
        missed = [float(line.split("missed by ")[1].split()[0]) for line in said.splitlines()]
        self.assertEqual(len(missed), 4)
        self.assertEqual(missed, sorted(missed, reverse=True))
        self.assertLess(missed[-1], 1e-4)
        self.assertGreater(missed[0], .1)


if __name__ == "__main__":
    unittest.main()
