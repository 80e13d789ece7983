"""What ritz-reduce warns of: meshes that answer, but not well."""
import unittest

from program import BOX, InAFolder


class Warnings(InAFolder):
    def warnings(self, kind, poisson):
        words = [word.replace("tet4", kind) for word in BOX]
        return self.reduce(*words, "-material_poisson", poisson, "-quiet").stderr

    def test_locking_of_linear_tetrahedra(self):
        for poisson in (".49", ".499", ".4999"):
            with self.subTest(poisson=poisson):
                warning = self.warnings("tet4", poisson)
                self.assertIn("lock", warning)
                self.assertIn("tet10", warning)
                self.assertEqual(len(warning.splitlines()), 1)
                self.assertEqual(self.warnings("tet10", poisson), "")
        self.assertEqual(self.warnings("tet4", ".3"), "")


if __name__ == "__main__":
    unittest.main()
