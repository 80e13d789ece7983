"""Residual vectors: statics of the reduced model against the full one's, what is told of static errors, and refusals."""
import json
import unittest

import numpy as np

from program import BOX, InAFolder

HELD = [*BOX, "-fix", "xmin"]
STATIC = "[static]\nsteps = 1\n"
TIP = '[[probe]]\nname = "tip"\nset = "xmax"\n[[probe]]\nname = "top"\nset = "zmax"\n'
PUSH = '[[load]]\nset = "xmax"\ntotal = [1e-6, 2e-6, -1e-6]\n'  # N: far from where displacements matter
GRAVITY = "gravity = [1e-7, 0, -2e-7]\n"


class ResidualVectors(InAFolder):
    def summary(self, *words):
        said = self.reduce(*words, "-summary", "s.json", ranks=1)
        return said, json.loads((self.folder / "s.json").read_text())

    def errors(self, summary):
        return {row["set"]: row["missing"] for row in summary["static_errors"]}

    def test_statics_are_those_of_the_full_model(self):
        for scene, place in ((STATIC + PUSH + TIP, "xmax"), (GRAVITY + STATIC + TIP, "gravity"),
                             (GRAVITY + STATIC + PUSH + TIP, "all")):
            self.full(*HELD, "-scene", self.write("scene.toml", scene), "-quiet")
            full = self.tip()
            for words in ([], ["-modes", "0"], ["-derivatives", "3", "-basis", "4", "-polynomial"]):
                with self.subTest(place=place, words=words):
                    self.reduce(*HELD, *words, "-residual_vectors", place, "-quiet", ranks=2 if place == "all" else 1)
                    self.move("model.h5", "--scene", "scene.toml")
                    np.testing.assert_allclose(self.tip(), full, rtol=0, atol=1e-8 * np.abs(full).max())
            self.inspect("model.h5", "--check")

    def test_what_modes_miss_is_told_and_mended(self):
        said, summary = self.summary(*HELD)
        errors = self.errors(summary)
        self.assertEqual(set(errors), {"xmax", "ymin", "ymax", "zmin", "zmax", "body", None})
        figures = self.report()[1]
        for name, missing in errors.items():
            for axis, value in zip("xyz", missing):
                self.assertEqual(figures[f"static_error_{axis}" + (f" {name}" if name else "")], value)
        worst = max(errors, key=lambda name: max(errors[name]))
        self.assertIn(f"{100 * max(errors[worst]):.3g} % on '{worst}'", said.out)
        _, mended = self.summary(*HELD, "-residual_vectors", f"{worst},gravity")
        self.assertLess(max(self.errors(mended)[worst] + self.errors(mended)[None]), 1e-7)
        self.assertEqual(mended["basis"]["columns"], 5 + mended["basis"]["residual_vectors"])
        self.assertEqual(mended["basis"]["residual_vectors"], 6)

    def test_a_free_body_with_residual_vectors_falls(self):
        free = [*BOX, "-fix", "none"]
        self.reduce(*free, "-residual_vectors", "xmax,gravity", "-quiet", ranks=1)
        self.assertEqual(self.body()["reduction/stiffness"][:][:6].tolist(), 6 * [0])
        self.assertEqual(self.body()["reduction"].attrs["residual_vectors"], 3)  # gravity is borne by inertia
        self.inspect("model.h5", "--check")
        self.move("model.h5", "--scene",
                  self.write("fall.toml", "gravity = [0, 0, -9.81]\n[time]\nstep = 0.01\nend = 0.1\n" + TIP))
        np.testing.assert_allclose(self.tip()[:3], [0, 0, -9.81 * .1**2 / 2], rtol=1e-9, atol=1e-12)

    def test_errors_that_take_long_are_worked_out_when_asked_for(self):
        for words in (["-fix", "none"], ["-fix", "xmin", "-solver", "iterative"]):
            _, silent = self.summary(*BOX, *words)
            self.assertIsNone(silent["static_errors"])
            _, told = self.summary(*BOX, *words, "-static_error")
            self.assertGreater(max(self.errors(told)["xmax"]), 1e-3)

    def test_a_basis_with_them_is_used_again(self):
        words = [*HELD, "-residual_vectors", "xmax"]
        _, first = self.summary(*words, "-output", "old.h5")
        said, again = self.summary(*words, "-reuse", "old.h5")
        self.assertIn("reusing the basis", said.out)
        self.assertEqual(again["static_errors"], first["static_errors"])
        other = self.reduce(*HELD, "-residual_vectors", "zmax", "-reuse", "old.h5", ranks=1)
        self.assertIn("nothing is reused of old.h5", other.err)

    def test_what_is_refused(self):
        for word, said in (("xmaxx", "did you mean 'xmax'?"), ("xmax,", "there is an empty name"),
                           ('"xmax"y', "put a comma between"), ('"gravity"', "no set 'gravity'")):
            result = self.reduce(*HELD, "-residual_vectors", word, code=2, ranks=1)
            self.assertIn(said, result.err)
        self.assertIn("leave out -residual_vectors", self.reduce(
            *HELD, "-residual_vectors", "xmax", "-accuracy", ".1", "-accuracy_scene",
            self.write("scene.toml", STATIC + PUSH), code=2, ranks=1).err)
        self.assertIn("move nothing", self.reduce(*HELD, "-modes", "0", "-residual_vectors", "xmin", code=2, ranks=1).err)
        said = self.reduce(*HELD, "-residual_vectors", "xmin", ranks=1)
        self.assertIn("no residual vector for a load on 'xmin'", said.out)
        self.assertNotIn("reduction", self.body())


if __name__ == "__main__":
    unittest.main()
