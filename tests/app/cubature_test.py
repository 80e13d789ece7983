"""Reduced models of laws that are no polynomials: against the full model, sized by an accuracy, and what is refused."""
import json
import unittest

import numpy as np

from program import InAFolder

RUBBER = ["-mesh", "box:4,1,1/8,2,2/tet10", "-fix", "xmin", "-material_young", "1e6", "-material_poisson", "0.3",
          "-material_density", "1000", "-material_law", "neo-hookean"]
BASIS = ["-modes", "6", "-derivatives", "6", "-basis", "16"]
BEND = '[[load]]\nset = "xmax"\ntotal = [0, 0, -5e3]\n[[probe]]\nname = "tip"\nset = "xmax"\n'
STATIC = "[static]\nsteps = 2\n"

# A column of three bricks, the upper two of region SOFT.
TWO_REGIONS = """*NODE
""" + "".join(f"{1 + i + 2 * j + 4 * k}, {i}, {j}, {k}\n" for k in range(4) for j in range(2) for i in range(2)) + """*ELEMENT, TYPE=C3D8, ELSET=HARD
100, 1, 2, 4, 3, 5, 6, 8, 7
*ELEMENT, TYPE=C3D8, ELSET=SOFT
101, 5, 6, 8, 7, 9, 10, 12, 11
102, 9, 10, 12, 11, 13, 14, 16, 15
*NSET, NSET=foot
1, 2, 3, 4
*MATERIAL, NAME=STEEL
*ELASTIC
1e6, .3
*DENSITY
1000
*SOLID SECTION, ELSET=HARD, MATERIAL=STEEL
*SOLID SECTION, ELSET=SOFT, MATERIAL=STEEL
"""


class Cubature(InAFolder):
    def cubature(self, model="model.h5"):
        return self.body(model)["cubature"]

    def bent(self, model="model.h5"):
        self.move(model, "--scene", self.write("bend.toml", STATIC + BEND))
        return self.tip()

    def test_bends_as_the_full_model(self):
        self.full(*RUBBER, "-scene", self.write("bend.toml", STATIC + BEND), "-quiet")
        full = self.tip()
        self.reduce(*RUBBER, *BASIS, "-polynomial", "-summary", "s.json", "-quiet", ranks=2)
        reduced = self.bent()
        self.assertGreater(np.abs(full).max(), .8)
        self.assertLess(np.linalg.norm(reduced - full) / np.linalg.norm(full), .01)
        self.inspect("model.h5", "--check")
        told = json.loads((self.folder / "s.json").read_text())["cubature"]
        last = told["errors"][-1]
        self.assertEqual((told["integrand"], told["cells"]), ("beyond-polynomial", last["cells"]))
        for kind in ("lifts", "statics"):
            self.assertLessEqual(last[kind]["root_mean_square"], 1e-3)
        self.assertLess(told["cells"], 192)
        self.assertTrue((self.cubature()["weights"][:] > 0).all())

        self.reduce(*RUBBER, *BASIS, "-cubature", "64", "-cubature_plain", "-quiet", "-output", "plain.h5", ranks=1)
        self.assertEqual(len(self.cubature("plain.h5")["cells"]), 64)
        self.assertNotIn("polynomial", self.body("plain.h5"))
        self.assertLess(np.linalg.norm(self.bent("plain.h5") - full) / np.linalg.norm(full), .03)

    def test_cells_of_a_polynomial_law_are_left_to_the_polynomial(self):
        self.write("two.inp", TWO_REGIONS)
        words = ["-mesh", "two.inp", "-fix", "foot", *RUBBER[4:-2], "-modes", "4", "-derivatives", "4"]
        self.reduce(*words, "-material_SOFT_law", "yeoh", "-material_SOFT_constants", "1.5e5,-2e3,1e2,2e-6",
                    "-cubature_tolerance", "1e-2", "-quiet", ranks=1)
        materials = [name.decode() for name in self.body()["geometry/materials/regions"][:]]
        regions = {materials[i] for i in self.cubature()["regions"][:]}
        self.assertEqual(regions, {"SOFT"})
        self.assertTrue(set(self.cubature()["cells"][:]) <= {101, 102})

    def test_an_accuracy_chooses_columns_and_cells(self):
        scene = self.write("bend.toml", STATIC + BEND)
        self.full(*RUBBER, "-scene", scene, "-quiet")
        full = self.tip()
        sizes = []
        for target in (.1, .01):
            self.reduce(*RUBBER, "-modes", "6", "-accuracy", str(target), "-accuracy_scene", scene, "-quiet", ranks=2)
            figures = self.report()[1]
            self.assertLessEqual(figures["accuracy_error"], target)
            self.assertLess(np.linalg.norm(self.bent() - full), target * np.linalg.norm(full))
            sizes.append((len(self.body()["reduction/stiffness"]), len(self.cubature()["cells"])))
        self.assertLess(sizes[0][0], sizes[1][0])
        self.assertLess(sizes[0][1], sizes[1][1])

    def test_every_law_is_reduced(self):
        laws = {"neo-hookean-isochoric": None, "mooney-rivlin": "0.15e6,0.04e6,2e-6", "yeoh": "0.15e6,-2e3,1e2,2e-6",
                "arruda-boyce": "0.35e6,2.5,2e-6", "ogden": "0.63e6,1.3,1.2e3,5,-1e4,-2,2e-6", "hencky": None,
                "corotational": None}
        small = ["-mesh", "box:4,1,1/6,1,1/hex8", "-fix", "xmin", "-material_density", "1000"]
        for law, constants in laws.items():
            with self.subTest(law=law):
                own = ["-material_constants", constants] if constants else RUBBER[4:8]
                words = [*small, "-material_law", law, *own]
                self.reduce(*words, "-modes", "3", "-derivatives", "3", "-cubature_tolerance", "0.005", "-quiet", ranks=1)
                reduced = self.bent()
                self.full(*words, "-scene", "bend.toml", "-quiet")
                self.assertLess(np.linalg.norm(reduced - self.tip()), .03 * np.linalg.norm(self.tip()))

    def test_what_does_not_fit_is_refused_in_a_sentence(self):
        steel = RUBBER[:-2]
        for words, sentence in (
            ([*steel, "-cubature", "10"], "-polynomial reduces exactly"),
            ([*RUBBER, "-cubature", "10", "-cubature_tolerance", "0.1"], "in two ways"),
            ([*RUBBER, "-polynomial", "-cubature_plain"], "contradict"),
            ([*RUBBER, *BASIS, "-cubature", "0"], "-cubature"),
            ([*RUBBER, *BASIS, "-cubature", "1000"], "192"),
            ([*RUBBER, *BASIS, "-cubature_tolerance", "-1"], "-cubature_tolerance"),
            ([*RUBBER, *BASIS, "-cubature_poses", "1"], "-cubature_poses"),
            ([*RUBBER, *BASIS, "-cubature_plain", "-cubature_amplitude", "0"], "-cubature_amplitude"),
            ([*RUBBER[:-1], "neo-hokean", *BASIS, "-polynomial"], "neo-hookean"),
        ):
            with self.subTest(words=words):
                self.assertIn(sentence, self.reduce(*words, code=2, ranks=1).err)


if __name__ == "__main__":
    unittest.main()
