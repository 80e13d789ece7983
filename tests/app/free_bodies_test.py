"""Bodies that can move as a whole, reduced with a basis that cannot: which loads run, and that those run right."""
import unittest

import h5py
import numpy as np

from program import InAFolder

RUBBER = ["-mesh", "box:0.3,0.04,0.03/8,2,2/tet10", "-material_young", "1e6", "-material_poisson", "0.4",
          "-material_density", "1000", "-quiet"]
NONLINEAR = ["-modes", "3", "-derivatives", "3", "-basis", "6", "-polynomial"]
TIME = '[time]\nstep = 1e-3\nend = 0.02\n[[probe]]\nname = "tip"\nset = "xmax"\n'
PULSE = "table = [[0, 0], [0.01, 1], [0.02, 0]]\n"
GRAVITY = "gravity = [0, 0, -9.81]\n"
PUSHED = "push or turn it as a whole"


def load(name, total, table=""):
    return f'[[load]]\nset = "{name}"\ntotal = {total}\n{table}'


def stretched(one="", other=""):
    return load("xmax", [0.3, 0, 0], one) + load("xmin", [-0.3, 0, 0], other)


class FreeBodies(InAFolder):
    def model(self, *words, name="model.h5"):
        self.reduce(*RUBBER, *words, "-output", name, ranks=1)
        return name

    def run_it(self, model, scene, *words):
        return self.move(model, "--scene", self.write("scene.toml", scene), "--output", "moved.h5", *words, code=None)

    def expect_runs(self, model, scene, *words):
        result = self.run_it(model, scene, *words)
        self.assertEqual((result.code, result.err), (0, ""))
        return self.tip("moved.probes.csv")

    def expect_refused(self, model, scene, *words, says=PUSHED):
        for old in self.folder.glob("moved*"):
            old.unlink()
        result = self.run_it(model, scene, *words)
        self.assertEqual(result.code, 2, result.err)
        self.assertEqual(len(result.err.splitlines()), 1, result.err)
        self.assertIn(says, result.err)
        self.assertFalse(any(name.startswith("moved") for name in self.files()), self.files())

    def test_a_free_nonlinear_body(self):
        model = self.model("-fix", "none", *NONLINEAR)
        for name, scene in [("gravity", GRAVITY + TIME),
                            ("a push", TIME + load("xmax", [0, 0, 0.3], PULSE)),
                            ("a couple", TIME + load("xmax", [0, 0, 0.3]) + load("xmin", [0, 0, -0.3])),
                            ("a torque about the axis",
                             TIME + load("ymax", [0, 0, 0.3]) + load("ymin", [0, 0, -0.3])),
                            ("tables that differ", TIME + stretched(PULSE)),
                            ("tables that differ between their points",
                             TIME + stretched(PULSE, "table = [[0, 0], [0.02, 0]]\n")),
                            ("shaking", TIME + "[shake]\ndirection = [0, 1, 0]\n" + PULSE)]:
            for words in ([], ["--linear"]):
                with self.subTest(name, words=words):
                    self.expect_refused(model, scene, *words)
        self.expect_runs(model, TIME)
        self.expect_runs(model, TIME + stretched(PULSE, PULSE), "--linear")

    def test_loads_in_equilibrium_agree_with_the_full_model(self):
        ramp = "table = [[0, 0], [0.02, 1]]\n"
        scene = TIME + stretched(ramp, ramp)
        reduced = self.expect_runs(self.model("-fix", "none", "-modes", "9", "-derivatives", "2", "-basis", "12",
                                              "-polynomial"), scene)
        self.full(*RUBBER, "-fix", "none", "-scene", "scene.toml", "-output", "whole.h5", ranks=1)
        full = self.tip("whole.probes.csv")
        self.assertGreater(full[0], 1e-5)
        self.assertLess(np.linalg.norm(reduced - full), 0.25 * np.linalg.norm(full))

    def test_pressure_all_round_is_in_equilibrium(self):
        model = self.model("-fix", "none", *NONLINEAR)
        faces = [f'[[load]]\nset = "{face}"\npressure = 1e3\n' for face in
                 ("xmin", "xmax", "ymin", "ymax", "zmin", "zmax")]
        self.expect_runs(model, TIME + "".join(faces))
        self.expect_refused(model, TIME + "".join(faces[1:]))

    def test_a_body_that_slides(self):
        """Held along x at one end: that direction runs, the others do not."""
        model = self.model("-fix", "xmin:x", *NONLINEAR)
        tip = self.expect_runs(model, TIME + load("xmax", [0.3, 0, 0], PULSE))
        self.assertGreater(abs(tip[0]), 0)
        self.expect_runs(model, "gravity = [9.81, 0, 0]\n" + TIME)
        self.expect_refused(model, TIME + load("xmax", [0, 0, 0.3], PULSE))
        self.expect_refused(model, GRAVITY + TIME)

    def test_what_the_surface_does_not_tell_is_refused(self):
        model = self.model("-fix", "none", "-surface_only", *NONLINEAR)
        self.expect_runs(model, TIME + stretched(PULSE, PULSE))
        self.expect_refused(model, TIME + load("xmax", [0, 0, 0.3]))

    def test_other_bases_without_rigid_motions(self):
        self.model("-fix", "none", "-modes", "6", name="modes.h5")
        chosen = self.model("-fix", "none", "-modes", "4", "-basis_modes", "1,2", "-derivatives", "1", name="chosen.h5")
        self.expect_refused(chosen, GRAVITY + TIME)
        with h5py.File(self.folder / "modes.h5") as file:
            points = file["bodies/body/geometry/points"][:]
        bent = np.zeros_like(points)
        bent[:, 2] = points[:, 0] ** 2
        np.save(self.folder / "bent.npy", bent.reshape(1, -1))
        pod = self.model("-fix", "none", "-modes", "0", "-snapshots", "bent.npy", "-basis", "1", name="pod.h5")
        self.expect_refused(pod, GRAVITY + TIME)

    def test_a_model_of_modes_alone_flies(self):
        model = self.model("-fix", "none", "-modes", "3")
        fallen = self.expect_runs(model, GRAVITY + TIME)
        self.assertAlmostEqual(fallen[2], -9.81 * 0.02**2 / 2, delta=1e-9)
        flown = self.expect_runs(model, TIME + load("xmax", [0, 0, 0.3], PULSE))
        self.assertGreater(flown[2], 1e-4)


if __name__ == "__main__":
    unittest.main()
