"""The same model on any number of ranks: eigenvalues to 1e-10, vectors to 1e-9 + 1e-11 / relative gap, clusters as
subspaces; bitwise on one rank."""
import itertools
import math
import unittest

import h5py
import numpy as np

from mesh_file import write_shuffled_beam
from program import InAFolder

MATERIAL = ["-material_young", "1e6", "-material_poisson", ".3", "-material_density", "1000", "-quiet"]
CLUSTER = 1e-6
RANKS = (2, 3, 5, 8)


def flat_columns(body):
    """U, 3n x r."""
    return np.stack([body["basis/columns"][name][:].ravel() for name in sorted(body["basis/columns"])], axis=-1)


def clusters(values):
    """Half-open ranges of indices whose neighbours agree."""
    ends = [i for i in range(1, len(values)) if values[i] - values[i - 1] > CLUSTER * values[i]] + [len(values)]
    return list(zip([0] + ends[:-1], ends))


def gap(values, begin, end, beyond):
    """The distance of a cluster from its neighbours, relative to itself."""
    below = values[begin] - values[begin - 1] if begin > 0 else np.inf
    above = (values[end] if end < len(values) else beyond) - values[end - 1]
    return min(below, above) / values[end - 1]


def largest_sine(a, b):
    """Between the spans of the columns."""
    qa, qb = np.linalg.qr(a)[0], np.linalg.qr(b)[0]
    return np.linalg.norm(qb - qa @ (qa.T @ qb), 2)


class Ranks(InAFolder):
    def model(self, ranks, *words):
        name = f"on_{ranks}.h5"
        self.reduce(*MATERIAL, *words, "-output", name, ranks=ranks)
        return self.body(name)

    def expect_same(self, one, other, beyond):
        kinds = one["modes/kinds"][:]
        np.testing.assert_array_equal(other["modes/kinds"][:], kinds)
        flexible = kinds == b"flexible"
        values, others = one["modes/eigenvalues"][flexible], other["modes/eigenvalues"][flexible]
        np.testing.assert_allclose(others, values, rtol=1e-10)
        u, v = flat_columns(one), flat_columns(other)
        np.testing.assert_allclose(v[:, ~flexible], u[:, ~flexible], rtol=0, atol=1e-9 * np.abs(u).max())
        u, v = u[:, flexible], v[:, flexible]
        for begin, end in clusters(values):
            gate = 1e-9 + 1e-11 / gap(values, begin, end, beyond)
            self.assertLessEqual(largest_sine(u[:, begin:end], v[:, begin:end]), gate, f"modes {begin} to {end}")
            if end == begin + 1:  # the sign too
                difference = np.linalg.norm(u[:, begin] - v[:, begin]) / np.linalg.norm(u[:, begin])
                self.assertLessEqual(difference, gate, f"mode {begin}")
        np.testing.assert_array_equal(one["geometry/points"][:], other["geometry/points"][:])
        np.testing.assert_array_equal(one["geometry/cells/vertices"][:], other["geometry/cells/vertices"][:])

    def compare(self, modes, *words):
        one = self.model(1, "-modes", str(modes), *words)
        self.reduce(*MATERIAL, "-modes", str(modes + 4), *words, "-output", "more.h5", ranks=1)
        kept = len(one["modes/eigenvalues"])
        more = self.body("more.h5")["modes/eigenvalues"][:]
        beyond = more[kept] if kept < len(more) else np.inf
        for ranks in RANKS:
            with self.subTest(ranks=ranks):
                self.expect_same(one, self.model(ranks, "-modes", str(modes), *words), beyond)

    def test_clamped_tetrahedra(self):
        self.compare(10, "-mesh", "box:1,.1,.06/12,2,2/tet4", "-fix", "xmin")

    def test_free_square_hexahedra(self):
        self.compare(8, "-mesh", "box:1,.1,.1/12,2,2/hex8")

    def test_a_file_in_a_random_order(self):
        write_shuffled_beam(self.folder / "beam.msh")
        self.compare(8, "-mesh", "beam.msh", "-fix", "box:0,0,-1,1,-1,1")

    def test_fewer_cells_than_ranks(self):
        self.compare(100, "-mesh", "box:1,.3,.2/2,1,1/hex8")

    def test_partly_supported(self):
        self.compare(6, "-mesh", "box:1,.1,.06/8,2,1/tet10", "-fix", "xmin:yz,xmax:z")


class Nonlinear(InAFolder):
    """The basis as a subspace, and the energy of one displacement through each rank count's own U."""

    def energy(self, body, u, full):
        """Ẽ(z) at the z nearest to u, by the stored coefficients: ½ A zz + ⅙ B zzz + 1/24 C zzzz."""
        z = np.linalg.lstsq(full, u, rcond=None)[0]
        total = 0.0
        for name, order, factorial in (("quadratic", 2, 2), ("cubic", 3, 6), ("quartic", 4, 24)):
            indices = np.array(list(itertools.combinations_with_replacement(range(len(z)), order)))
            times = [factorial / math.prod(map(math.factorial, np.unique(i, return_counts=True)[1])) for i in indices]
            total += np.dot(body[f"polynomial/{name}"][:] * times, z[indices].prod(axis=1)) / factorial
        return total

    def test_basis_and_polynomial(self):
        one = None
        for ranks in (1, *RANKS[:3]):
            with self.subTest(ranks=ranks):
                name = f"on_{ranks}.h5"
                self.reduce(*MATERIAL, "-mesh", "box:1,.1,.06/8,2,1/tet10", "-fix", "xmin", "-modes", "5",
                            "-derivatives", "5", "-basis", "9", "-polynomial", "-output", name, ranks=ranks)
                body = self.body(name)
                U = flat_columns(body)
                if one is None:
                    one, u = U, U @ (.1 / np.abs(U).max() * np.arange(1, 10))
                    energy = self.energy(body, u, U)
                self.assertLessEqual(largest_sine(one, U), 1e-8)
                self.assertAlmostEqual(self.energy(body, u, U) / energy, 1, delta=1e-8)


class OneRank(InAFolder):
    def test_two_runs_agree_in_every_bit(self):
        for name in ("first", "second"):
            (self.folder / name).mkdir()
            self.reduce(*MATERIAL, "-mesh", "box:1,.1,.1/8,2,2/hex8", "-modes", "9", "-output", f"{name}/model.h5", ranks=1)
        first, second = ((self.folder / name / "frequencies.csv").read_bytes() for name in ("first", "second"))
        self.assertEqual(first, second)
        compared = []

        def compare(name, thing):
            if isinstance(thing, h5py.Dataset):
                self.assertEqual(thing[()].tobytes(), other[name][()].tobytes(), name)
                compared.append(name)

        other = self.body("second/model.h5")
        self.body("first/model.h5").visititems(compare)
        self.assertIn("basis/columns/0001", compared)


if __name__ == "__main__":
    unittest.main()
