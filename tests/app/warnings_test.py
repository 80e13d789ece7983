"""What ritz-reduce warns of: meshes and numbers that answer, but not well."""
import unittest

from program import BOX, InAFolder

PART = ["-material_poisson", ".3", "-modes", "2", "-fix", "xmin", "-quiet"]


class Warnings(InAFolder):
    def warnings(self, kind, poisson):
        words = [word.replace("tet4", kind) for word in BOX]
        return self.reduce(*words, "-fix", "none", "-material_poisson", poisson, "-quiet").stderr

    def part(self, size, young, density, *words, ranks=1):
        return self.reduce("-mesh", f"box:{size}/6,1,1/tet10", "-material_young", young, "-material_density", density,
                           *PART, *words, ranks=ranks).stderr

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
                                       "1000", *PART, ranks=ranks).stderr
                    self.assertEqual(len(said.splitlines()), 1, said)
                    self.assertIn("too high", said)
                    self.assertIn("tet10", said)

    def test_a_body_that_nothing_holds(self):
        free = self.reduce(*BOX, "-quiet").stderr
        self.assertIn("nothing holds the body", free)
        self.assertNotIn("nothing holds", self.reduce(*BOX, "-quiet", "-fix", "none").stderr)
        self.assertNotIn("nothing holds", self.reduce(*BOX, "-quiet", "-fix", "xmin").stderr)

    def test_units_mixed_up(self):
        steel, in_megapascals = ("2.1e11", "7850"), ("2.1e5", "7.85e-9")
        for size, (young, density), words, says in [
                ("100,20,10", steel, [], "-units mm-t-s"),
                ("100,20,10", in_megapascals, [], "-units mm-t-s"),
                ("100,20,10", ("210", "7.85e-6"), [], "-units mm-kg-ms"),
                (".1,.02,.01", ("2.1e5", "7850"), [], "MPa"),
                (".1,.02,.01", ("210", "7850"), [], "GPa"),
                (".1,.02,.01", ("2.1e11", "7.85"), [], "g/cm3"),
                (".1,.02,.01", in_megapascals, ["-units", "mm-t-s"], "-units m-kg-s"),
                ("100,20,10", steel, ["-units", "mm-t-s"], "-units mm-t-s")]:
            with self.subTest(size=size, young=young, density=density, words=words):
                said = self.part(size, young, density, *words)
                self.assertEqual(len(said.splitlines()), 1, said)
                self.assertIn(says, said)

    def test_units_that_are_right(self):
        for size, young, density, words in [
                (".1,.02,.01", "2.1e11", "7850", []), ("1,.1,.06", "1e6", "1000", []), ("20,3,2", "3e10", "2400", []),
                ("100,20,10", "2.1e11", "7850", ["-units", "m-kg-s"]),
                ("100,20,10", "2.1e5", "7.85e-9", ["-units", "mm-t-s"]),
                ("100,20,10", "1.6e5", "2.33e-15", ["-units", "um-kg-s"]), (".01,.002,.001", "1e3", "1000", [])]:
            with self.subTest(size=size, young=young):
                self.assertEqual(self.part(size, young, density, *words), "")

    def test_size_mass_and_frequency_in_one_line(self):
        said = self.reduce("-mesh", "box:1,.2,.1/4,1,1/tet10", "-material_young", "1e6", "-material_density", "1000",
                           *[word for word in PART if word != "-quiet"]).stdout
        self.assertRegex(said, r"size 1 x 0\.2 x 0\.1 m, mass 20 kg, first frequency 0\.5\d* Hz")


if __name__ == "__main__":
    unittest.main()
