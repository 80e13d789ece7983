"""A model whose witness fails is not written, and an earlier one stays."""
import unittest

from program import InAFolder

MATERIAL = ["-material_young", "1e6", "-material_poisson", ".3", "-material_density", "1000", "-quiet"]


class Witness(InAFolder):
    def test_a_model_that_fails_is_not_written(self):
        """A body so large that its quartic coefficients are too small for a number: what is left is not the body."""
        words = [*MATERIAL, "-fix", "xmin", "-modes", "4", "-polynomial"]
        thin = ["-material_young", "1e-16", "-material_density", "1e-106"]  # whose matrices are still ordinary numbers
        self.reduce(*words, "-mesh", "box:1,.3,.2/4,1,1/hex8")
        before = {path.name: path.read_bytes() for path in self.folder.iterdir()}
        said = self.reduce(*words, *thin, "-mesh", "box:1e75,3e74,2e74/4,1,1/hex8", code=1).err
        self.assertIn("the polynomial does not agree with the full model", said)
        self.assertIn("the model was not written", said)
        self.assertEqual({path.name: path.read_bytes() for path in self.folder.iterdir()}, before)


if __name__ == "__main__":
    unittest.main()
