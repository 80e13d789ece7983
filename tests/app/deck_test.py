"""Decks of Abaqus and CalculiX: the frequencies are those of the supports, elements and materials that the deck means."""
import unittest

from crooked_bar import crooked
from program import InAFolder

CALCULIX = (1630.104, 6972.959)  # ccx 2.20 on deck(), Hz; the second with the tip held in y and z too
CELLS = 6
SIDE, STEP = .012, .015  # m
UNITS = ["-modes", "2", "-quiet"]


def deck(kind="C3D8", comma="", supports="*BOUNDARY\nFIX, 1, 3\n", steps="*STEP\n*FREQUENCY\n3\n*END STEP\n",
         material="*ELASTIC\n2.1e11, .3\n*DENSITY\n7850.\n", more=""):
    """A bar of hexahedra, in SI units. `comma` stands at the end of each keyword that data lines follow."""
    points = [(i * STEP, y, z) for i in range(CELLS + 1) for z in (0, SIDE) for y in (0, SIDE)]
    square = (1, 2, 4, 3)  # around the section
    text = f"*NODE, NSET=ALL{comma}\n" + "".join(f"{n + 1}, {x}, {y}, {z}\n" for n, (x, y, z) in enumerate(points))
    text += f"*ELEMENT, TYPE={kind}, ELSET=BAR{comma}\n"
    for cell in range(CELLS):
        vertices = [4 * (cell + end) + v for end in (0, 1) for v in square]
        text += f"{cell + 1}, " + ", ".join(map(str, vertices)) + "\n"
    text += f"*NSET, NSET=FIX{comma}\n1, 2, 3, 4\n*NSET, NSET=TIP{comma}\n25, 26, 27, 28\n"
    text += "*MATERIAL, NAME=STEEL\n" + material + "*SOLID SECTION, ELSET=BAR, MATERIAL=STEEL\n"
    return text + more + supports + steps


class CrookedBars(InAFolder):
    """Beside CalculiX 2.20 on the same deck, which prints seven digits."""
    FREQUENCIES = {  # Hz; CalculiX integrates the mass of wedges by too few points, so that theirs differ
        "C3D8": (1643.926, 2136.984, 6931.039, 9834.386, 11941.31, 13046.3),
        "C3D20": (1397.017, 1905.224, 6268.826, 8060.442, 10243.5, 12613.57)}
    UNDER_10_MN = {  # displacements of TIP, m, under -.01 N along z
        "C3D8": (-3.058472e-11, 1.138371e-11, -1.261526e-09),
        "C3D20": (-5.107538e-11, 8.696224e-12, -1.782986e-09),
        "C3D15": (-4.589412e-11, 9.993879e-12, -1.779027e-09),
        "C3D6": (-3.709935e-11, 5.96314e-11, -1.270409e-09)}

    def test_the_frequencies_of_calculix(self):
        for kind, expected in self.FREQUENCIES.items():
            with self.subTest(kind):
                self.reduce("-mesh", self.write("m.inp", crooked(kind)), "-modes", "6", "-quiet", ranks=2)
                for row, frequency in zip(self.frequencies(), expected):
                    self.assertAlmostEqual(float(row["frequency_hz"]) / frequency, 1, delta=5e-7)

    def test_the_statics_of_calculix(self):
        scene = '[static]\nsteps = 1\n[[load]]\nset = "TIP"\ntotal = [0, 0, -0.01]\n[[probe]]\nname = "tip"\nset = "TIP"\n'
        self.write("s.toml", scene)
        for kind, expected in self.UNDER_10_MN.items():
            with self.subTest(kind):
                self.full("-mesh", self.write("m.inp", crooked(kind)), "-scene", "s.toml", "-quiet", ranks=2)
                moved = self.table("probes.csv")[1][-1, 1:4]
                for number, known in zip(moved, expected):
                    self.assertAlmostEqual(number / known, 1, delta=1e-6)


class LargeLoads(InAFolder):
    """A crooked bar, bent by a third of its length by a force at its tip: what CalculiX 2.20 found on the same deck with
    NLGEOM, a digit before the last of seven."""
    TIP = {  # m, of 3 x 2 x 2 C3D20
        "*HYPERELASTIC, NEO HOOKE\n2.e5, 2.e-6\n": (3.239135e-04, -2.014495e-02, 3.104055e-02),
        "*HYPERELASTIC, MOONEY-RIVLIN\n1.5e5, 4.e4, 2.e-6\n": (2.478577e-04, -2.080012e-02, 3.179206e-02),
        "*HYPERELASTIC, YEOH\n1.5e5, -2.e3, 1.e2, 2.e-6, 1.e30, 1.e30\n":
            (-3.178108e-04, -2.383744e-02, 3.501790e-02),
        "*HYPERELASTIC, ARRUDA-BOYCE\n3.5e5, 2.5, 2.e-6\n": (2.716981e-04, -2.047602e-02, 3.141486e-02),
        "*HYPERELASTIC, OGDEN, N=3\n6.3e5, 1.3, 1.2e3, 5., -1.e4, -2., 2.e-6, 1.e30\n1.e30\n":
            (1.010364e-03, -1.529528e-02, 2.516748e-02),
        "*ELASTIC, TYPE=ENGINEERING CONSTANTS\n1.e6, 5.e5, 2.e5, .3, .25, .2, 3.e5, 2.e5\n1.e5,\n":
            (-2.309117e-03, -2.989358e-02, 4.026007e-02)}
    NEARLY_INCOMPRESSIBLE = {  # m, of 4 x 2 x 2 cubes of six C3D10, the bulk modulus 1e3 and 1e4 times the shear modulus
        "*HYPERELASTIC, NEO HOOKE\n2.e5, 5.e-9\n": (1.432344e-03, -1.491686e-02, 2.431043e-02),
        "*HYPERELASTIC, NEO HOOKE\n2.e5, 5.e-10\n": (1.607257e-03, -1.427362e-02, 2.333525e-02)}
    TURNED = "*ORIENTATION, NAME=TURNED\n1., 2., .5, -1., 1., 0.\n"

    def moves_to(self, text, expected):
        self.write("s.toml", '[static]\nsteps = 4\n[[load]]\nset = "TIP"\ntotal = [2, -1, 1.5]\n'
                             '[[probe]]\nname = "tip"\nset = "TIP"\n')
        self.full("-mesh", self.write("m.inp", text), "-scene", "s.toml", "-quiet", ranks=1)
        for number, known in zip(self.table("probes.csv")[1][-1, 1:4], expected):
            self.assertAlmostEqual(number, known, delta=1e-6 * max(map(abs, expected)))

    def test_the_statics_of_calculix(self):
        for law, expected in self.TIP.items():
            with self.subTest(law):
                text = crooked("C3D20", count=(3, 2, 2)).replace("*ELASTIC\n2.1e11, .3\n", law)
                if "ENGINEERING" in law:
                    text = text.replace("*MATERIAL,", self.TURNED + "*MATERIAL,").replace(
                        "MATERIAL=STEEL\n", "MATERIAL=STEEL, ORIENTATION=TURNED\n")
                self.moves_to(text, expected)

    def test_nearly_incompressible_rubber(self):
        for law, expected in self.NEARLY_INCOMPRESSIBLE.items():
            with self.subTest(law):
                self.moves_to(crooked("C3D10", count=(4, 2, 2)).replace("*ELASTIC\n2.1e11, .3\n", law), expected)


class Decks(InAFolder):
    def first(self, text, *words):
        self.said = self.reduce("-mesh", self.write("m.inp", text), *UNITS, *words, ranks=1).err
        return self.eigenvalues()[0]

    def refused(self, text, *words):
        return self.reduce("-mesh", self.write("m.inp", text), *UNITS, *words, ranks=1, code=2).err

    def test_the_frequency_of_calculix(self):
        for supports, expected in zip(("FIX, 1, 3\n", "FIX, 1, 3\nTIP, 2, 3\n"), CALCULIX):
            self.first(deck(supports="*BOUNDARY\n" + supports))
            self.assertAlmostEqual(float(self.frequencies()[0]["frequency_hz"]), expected, delta=1e-6 * expected)

    def test_commas_at_the_end_of_keywords(self):
        plain = self.first(deck())
        commas = deck(comma=",").replace("*BOUNDARY\n", "*BOUNDARY,\n").replace("*ELASTIC\n", "*ELASTIC, \n")
        self.assertEqual(self.first(commas), plain)

    def test_supports_of_steps(self):
        plain = self.first(deck())
        static = "*STEP\n*STATIC\n*BOUNDARY\nFIX, 1, 3\nTIP, 2, 3\n*CLOAD\n13, 3, 1.\n*END STEP\n"
        frequency = "*STEP\n*FREQUENCY\n3\n{}*END STEP\n"
        new = frequency.format("*BOUNDARY, OP=NEW\nFIX, 1, 3\n")
        self.assertEqual(self.first(deck(supports="", steps=static + new)), plain)
        both = self.first(deck(supports="", steps=static + frequency.format("")))
        self.assertEqual(both, self.first(deck(supports="*BOUNDARY\nFIX, 1, 3\nTIP, 2, 3\n")))
        self.assertGreater(both, 4 * plain)

    def test_what_changes_the_physics(self):
        plain = self.first(deck())
        for text in ("*EQUATION\n2\n25, 2, 1., 26, 2, -1.\n", "*RIGID BODY, NSET=TIP, REF NODE=1\n"):
            with self.subTest(text):
                word = text[1:text.index("\n")].split(",")[0]
                self.assertIn("*" + word, self.refused(deck(more=text)))
                self.assertEqual(self.first(deck(more=text), "-ignore", word), plain)
                self.assertIn("*" + word, self.said)
                self.assertIn("*" + word, str(self.body().file["report/notes"][:]))

    def test_parts_of_a_material(self):
        plain = self.first(deck())
        elastic, density = "*ELASTIC\n2.1e11, .3\n", "*DENSITY\n7850.\n"
        self.assertEqual(self.first(deck(material=elastic), "-material_density", "7850"), plain)
        self.assertEqual(self.first(deck(material=density), "-material_young", "2.1e11", "-material_poisson", ".3"), plain)
        self.assertIn("-material_density", self.refused(deck(material=elastic)))
        law = "*ELASTIC\n2.1e11, .3, 20.\n1e11, .3, 500.\n"
        self.assertIn("temperature", self.refused(deck(material=law + density)))
        self.assertEqual(self.first(deck(material=law + density), "-material_young", "2.1e11", "-material_poisson", ".3"),
                         plain)
        cold = "*DENSITY\n7850., 20.\n7700., 500.\n"
        self.assertIn("temperature", self.refused(deck(material=elastic + cold)))
        self.assertEqual(self.first(deck(material=elastic + cold), "-material_density", "7850"), plain)

    def test_another_hexahedron(self):
        plain = self.first(deck())
        self.assertIn("2 x 2 x 2", self.refused(deck("C3D8R")))
        self.assertEqual(self.first(deck("C3D8R"), "-ignore", "C3D8R"), plain)
        self.assertIn("C3D8R", self.said)


if __name__ == "__main__":
    unittest.main()
