"""From a mesh to a nonlinear model, from that to a motion, and beside it the full model under the same scene."""
import unittest

import h5py
import numpy as np

from program import InAFolder

BEAM = ["-mesh", "box:1,.1,.06/8,2,1/tet10", "-fix", "xmin", "-material_young", "1e6", "-material_poisson", ".3",
        "-material_density", "1000"]
LOAD = 3.6  # N: PL²/EI = 2
STATIC = '[static]\nsteps = 2\n[[load]]\nset = "xmax"\ntotal = [0, 0, -{}]\n[[probe]]\nname = "tip"\nset = "xmax"\n'
MOVING = '[time]\nstep = .02\nend = .1\nintegrator = "{}"\n'


class Nonlinear(InAFolder):
    def setUp(self):
        super().setUp()
        self.write("scene.toml", STATIC.format(LOAD))

    def full_tip(self):
        self.full(*BEAM, "-scene", "scene.toml", "-quiet")
        return self.tip()

    def reduced_tip(self, *words):
        self.reduce(*BEAM, *words, "-polynomial")
        self.inspect("model.h5", "--check")
        told = self.inspect("model.h5", "--verbose").out
        witness = ["force", "energy", "stiffness"] + ["taylor_slope"] * ("-derivatives" in words)
        for figure in ("basis_orthonormality", *(f"witness_{name}" for name in witness)):
            self.assertIn(figure, told)
        self.move("model.h5", "--scene", "scene.toml")
        return self.tip()

    def test_derivatives_bend_as_the_full_model_does(self):
        full = self.full_tip()
        self.assertGreater(abs(full[2]), .2)
        error = lambda tip: np.linalg.norm(tip - full) / np.linalg.norm(full)
        self.assertLess(error(self.reduced_tip("-modes", "6", "-derivatives", "6", "-basis", "12")), 2e-2)
        self.assertGreater(error(self.reduced_tip("-modes", "6")), .3)

    def test_a_target_for_the_error_is_met_by_few_columns(self):
        target = 1e-2
        out = self.reduce(*BEAM, "-accuracy", str(target), "-accuracy_scene", "scene.toml").out
        self.assertIn("error on the static path", out)
        figures = self.report()[1]
        self.assertEqual(self.body()["reduction/stiffness"].shape, (figures["accuracy_columns"],))
        self.assertEqual(figures["accuracy_target"], target)
        self.assertLessEqual(figures["accuracy_error"], target)
        self.assertLessEqual(figures["accuracy_columns"], 14)
        self.inspect("model.h5", "--check")
        self.move("model.h5", "--scene", "scene.toml")
        tip = self.tip()
        full = self.full_tip()
        # The tip moves most: its error is about that of the whole body.
        self.assertLess(np.linalg.norm(tip - full), 2 * target * np.linalg.norm(full))

    def test_a_basis_for_an_error_is_used_again_until_its_scene_changes(self):
        words = [*BEAM, "-accuracy", "1e-1", "-accuracy_scene", "scene.toml"]
        self.reduce(*words, "-output", "old.h5")
        self.assertIn("reusing the basis", self.reduce(*words, "-reuse", "old.h5").out)
        self.write("scene.toml", STATIC.format(LOAD / 3))
        result = self.reduce(*words, "-reuse", "old.h5")
        self.assertNotIn("reusing", result.out)
        self.assertIn("nothing is reused of old.h5: its basis was made with", result.err)

    def test_snapshots_of_the_full_model_give_its_states_back(self):
        full = self.full_tip()
        with h5py.File(self.folder / "full.h5") as file:
            states = file["snapshots"][:]
        np.save(self.folder / "states.npy", states)
        np.save(self.folder / "fortran.npy", np.asfortranarray(states))
        np.save(self.folder / "single.npy", states.astype(np.float32))
        np.save(self.folder / "both.npy", np.asfortranarray(states.astype(np.float32)))
        names = ("full.h5", "states.npy", "fortran.npy", "single.npy", "both.npy")
        tips = [self.reduced_tip("-modes", "0", "-snapshots", name) for name in names]
        np.testing.assert_allclose(tips[0], full, rtol=0, atol=1e-6 * np.abs(full).max())
        np.testing.assert_allclose(tips[1], tips[0], rtol=0, atol=1e-12)
        np.testing.assert_array_equal(tips[2], tips[1])
        np.testing.assert_array_equal(tips[4], tips[3])
        np.testing.assert_allclose(tips[3], full, rtol=0, atol=1e-5 * np.abs(full).max())

    def test_a_basis_without_modes_is_used_again(self):
        self.full_tip()
        pod = [*BEAM, "-modes", "0", "-snapshots", "full.h5"]
        self.reduce(*pod, "-output", "pod.h5", ranks=1)
        out = self.reduce(*pod, "-polynomial", "-reuse", "pod.h5", ranks=1).out
        self.assertIn("reusing the basis", out)
        with h5py.File(self.folder / "pod.h5") as first, h5py.File(self.folder / "model.h5") as second:
            for path in ("basis/columns/0001", "reduction/stiffness", "inertia/gram"):
                np.testing.assert_array_equal(first["bodies/body"][path][()], second["bodies/body"][path][()])
        self.inspect("model.h5", "--check")

    def test_what_a_nonlinear_model_cannot_do(self):
        self.reduce(*BEAM, "-modes", "3", "-derivatives", "2", "-polynomial")
        self.write("exact.toml", MOVING.format("exact"))
        self.assertIn("exact", self.move("model.h5", "--scene", "exact.toml", code=2).err)


if __name__ == "__main__":
    unittest.main()
