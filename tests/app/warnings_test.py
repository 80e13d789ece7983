"""What ritz-reduce warns of: meshes and numbers that answer, but not well."""
import unittest

from program import BOX, InAFolder

PART = ["-material_poisson", ".3", "-modes", "2", "-fix", "xmin", "-quiet"]


class Warnings(InAFolder):
    def warnings(self, kind, poisson):
        words = [word.replace("tet4", kind) for word in BOX]
        return self.reduce(*words, "-fix", "none", "-material_poisson", poisson, "-quiet").err

    def part(self, size, young, density, *words, ranks=1):
        return self.reduce("-mesh", f"box:{size}/6,1,1/tet10", "-material_young", young, "-material_density", density,
                           *PART, *words, ranks=ranks).err

    def test_locking_of_linear_tetrahedra(self):
        for poisson in (".49", ".499", ".4999"):
            with self.subTest(poisson=poisson):
                warning = self.warnings("tet4", poisson)
                self.assertIn("lock", warning)
                self.assertIn("tet10", warning)
                self.assertEqual(self.warnings("tet10", poisson), "")
        self.assertNotIn("lock", self.warnings("tet4", ".3"))

    def test_linear_cells_that_bend(self):
        for cells in ("12,2,1/tet4", "12,2,2/tet4", "12,1,1/hex8"):
            for ranks in (1, 2):
                with self.subTest(cells=cells, ranks=ranks):
                    said = self.reduce("-mesh", f"box:1,.2,.1/{cells}", "-material_young", "1e9", "-material_density",
                                       "1000", *PART, ranks=ranks).err
                    self.assertEqual(len(said.splitlines()), 1, said)
                    self.assertIn("too high", said)
                    self.assertIn("tet10", said)

    def test_what_was_said_of_a_basis_is_said_again_where_it_is_reused(self):
        words = ["-mesh", "box:1,.2,.1/8,2,1/hex8", "-material_young", "1e9", "-material_density", "1000", *PART,
                 "-derivatives", "2", "-basis", "3"]
        first = self.reduce(*words, "-output", "first.h5").err
        self.assertIn("too high", first)
        self.assertEqual(self.reduce(*words, "-reuse", "first.h5").err, first)

    def test_a_body_that_nothing_holds(self):
        free = self.reduce(*BOX, "-quiet").err
        self.assertIn("nothing holds the body", free)
        self.assertNotIn("nothing holds", self.reduce(*BOX, "-quiet", "-fix", "none").err)
        self.assertNotIn("nothing holds", self.reduce(*BOX, "-quiet", "-fix", "xmin").err)

    def test_units_mixed_up(self):
        steel, in_megapascals = ("2.1e11", "7850"), ("2.1e5", "7.85e-9")
        mm, m = "100,20,10", ".1,.02,.01"
        in_millimetres = ["-units", "mm-t-s"]
        for size, (young, density), words, says in [
                (mm, steel, [], "-units mm-t-s"),
                ("300,200,100", ("7e10", "2700"), [], "-units mm-t-s"),
                ("100,20,10", ("1e6", "1000"), [], "-units mm-t-s"),
                (mm, in_megapascals, [], "-units mm-t-s"),
                (mm, ("210", "7.85e-6"), [], "-units mm-kg-ms"),
                (m, ("2.1e5", "7850"), [], "a Young's modulus in MPa"),
                (m, ("7e4", "2700"), [], "a Young's modulus in MPa"),
                (m, ("210", "7850"), [], "a Young's modulus in GPa"),
                (m, ("2.1e11", "7.85"), [], "a density in g/cm3"),
                (m, ("2.1e11", "7.85e-9"), [], "a density in t/mm3"),
                ("4,1,.5", ("3e7", "7.3e-4"), [], "in psi and a density in lbf s2/in4"),
                (m, in_megapascals, in_millimetres, "-units m-kg-s"),
                (mm, steel, in_millimetres, "a Young's modulus in Pa and a density in kg/m3"),
                (mm, ("2.1e11", "7.85e-9"), in_millimetres, "a Young's modulus in Pa,"),
                (mm, ("2.1e5", "7850"), in_millimetres, "a density in kg/m3")]:
            with self.subTest(size=size, young=young, density=density, words=words):
                said = self.part(size, young, density, *words)
                self.assertEqual(len(said.splitlines()), 1, said)
                self.assertIn(says, said)

    def test_units_that_are_right(self):
        in_micrometres, in_millimetres = ["-units", "um-kg-s"], ["-units", "mm-t-s"]
        for size, young, density, words in [
                (".1,.02,.01", "2.1e11", "7850", []), ("1,.1,.06", "1e6", "1000", []), ("20,3,2", "3e10", "2400", []),
                ("100,20,10", "2.1e11", "7850", ["-units", "m-kg-s"]), ("200,30,4", "2.1e11", "7850", ["-units", "m-kg-s"]),
                ("100,20,10", "2.1e5", "7.85e-9", in_millimetres), ("20,1,.4", "2.1e5", "7.85e-9", in_millimetres),
                ("100,20,10", "1.6e5", "2.33e-15", in_micrometres), ("300,20,20", "1.6e5", "2.33e-15", in_micrometres),
                (".01,.002,.001", "1e3", "1000", []), (".1,.1,.1", "1e5", "3", []), (".1,.1,.1", "1e4", "1.2", []),
                (".003,.003,.003", "1.22e12", "3515", []), (".1,.1,.1", "5.6e11", "22590", []),
                (".1,.1,.1", "1e6", "3500", []), ("10,1,1", "2.06e12", "7.85", ["-units", "cm-g-s"])]:
            with self.subTest(size=size, young=young):
                self.assertEqual(self.part(size, young, density, *words), "")

    def test_size_mass_and_frequency_in_one_line(self):
        said = self.reduce("-mesh", "box:1,.2,.1/4,1,1/tet10", "-material_young", "1e6", "-material_density", "1000",
                           *[word for word in PART if word != "-quiet"]).out
        self.assertRegex(said, r"size 1 x 0\.2 x 0\.1 m, mass 20 kg, first frequency 0\.5\d* Hz")


if __name__ == "__main__":
    unittest.main()
