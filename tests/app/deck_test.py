"""Decks of Abaqus and CalculiX: the frequencies are those of the supports, elements and materials that the deck means."""
import unittest

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
