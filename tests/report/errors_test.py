"""The errors against closed forms."""
import math
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
import scipy.sparse

from report import body, errors

TIMES = np.linspace(0, 4 * math.pi, 2001)  # two whole periods
MASS = scipy.sparse.csr_matrix(np.array([[2.0, 1.0], [1.0, 3.0]]))
SHAPE = np.array([1.0, -2.0])
SIZE = math.sqrt(SHAPE @ MASS.toarray() @ SHAPE)


def swing(shift=0.0, factor=1.0):
    return factor * np.outer(np.cos(TIMES + shift), SHAPE)


def between(u, v):
    return errors.norms(u - v, MASS), errors.norms(v, MASS)


class Errors(unittest.TestCase):
    def test_norm_is_that_of_the_mass(self):
        np.testing.assert_allclose(errors.norms(swing(), MASS), SIZE * abs(np.cos(TIMES)), atol=1e-14)

    def test_a_motion_that_is_too_large_by_a_tenth(self):
        error, size = between(swing(factor=1.1), swing())
        self.assertAlmostEqual(errors.integrated(error, size, TIMES), 0.1, places=12)
        self.assertAlmostEqual(errors.largest(error, size), 0.1, places=12)

    def test_a_late_motion(self):
        shift = 0.3
        error, size = between(swing(shift), swing())  # cos(t + s) - cos(t) = -2 sin(s/2) sin(t + s/2)
        self.assertAlmostEqual(errors.integrated(error, size, TIMES), 2 * math.sin(shift / 2), places=5)
        self.assertAlmostEqual(errors.largest(error, size), 2 * math.sin(shift / 2), places=5)

    def test_uneven_times_are_weighed(self):
        times = np.array([0.0, 1.0, 3.0])
        self.assertAlmostEqual(errors.integrated(np.array([0.0, 0.0, 1.0]), np.ones(3), times), math.sqrt(1 / 3))

    def test_probes(self):
        q = np.outer(np.cos(TIMES), [3.0, 0.0, 4.0])
        self.assertAlmostEqual(errors.probes(q + [0, 0.5, 0], q, TIMES), 0.5 / (5 / math.sqrt(2)), places=3)

    def test_tone(self):
        times = np.arange(0, 2, 0.005)
        signal = 0.3 + np.exp(-0.2 * times) * np.sin(2 * math.pi * 3.7 * times)
        self.assertAlmostEqual(errors.tone(times, signal), 3.7, delta=0.005)
        self.assertAlmostEqual(errors.relative(3.3, 3.0), 0.1)

    def test_the_tone_of_a_short_or_drifting_signal_is_not_told(self):
        times = np.arange(0, 0.2, 0.005)
        self.assertTrue(math.isnan(errors.tone(times, np.sin(2 * math.pi * 3.7 * times))))
        self.assertTrue(math.isnan(errors.tone(times, times)))

    def test_every_error_of_the_table_is_defined(self):
        from report import table
        for column in table.COLUMNS:
            if column.startswith("error_") or column in ("floor", "energy_balance"):
                self.assertIn(column, errors.DEFINITIONS)

    def test_petsc_matrices_are_read(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "m.bin"
            path.write_bytes(np.array([1211216, 2, 3, 3, 2, 1, 0, 2, 1], ">i4").tobytes() +
                             np.array([1.5, -2.0, 4.0], ">f8").tobytes())
            np.testing.assert_array_equal(body.read_petsc(path).toarray(), [[1.5, 0, -2], [0, 4, 0]])
            path.write_bytes(bytes(16))
            with self.assertRaisesRegex(ValueError, "not a sparse matrix"):
                body.read_petsc(path)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
