"""The same model on any number of ranks: eigenvalues to 1e-10, vectors to 1e-9 + 1e-11 / relative gap, clusters and
the basis as subspaces; ten times the solver's tolerance where it iterates; bitwise on one rank."""
import itertools
import math
import unittest
from dataclasses import dataclass

import h5py
import numpy as np

from mesh_file import write_shuffled_beam
from program import InAFolder
from stability.repeated import clusters, largest_sine

MATERIAL = ["-material_young", "1e6", "-material_poisson", ".3", "-material_density", "1000", "-quiet"]
RANKS = (2, 3, 5, 8)


@dataclass(frozen=True)
class Gates:
    values: float
    vectors: float
    by_gap: float

    def of(self, gap):
        """Of vectors whose relative gap is so large."""
        return self.vectors + self.by_gap / gap


DIRECT = Gates(1e-10, 1e-9, 1e-11)
ITERATIVE = Gates(1e-7, 1e-7, 0)  # residuals are held to 1e-8


def flat_columns(body, rows=slice(None)):
    """U, 3n x r, or some vertices' rows of it."""
    return np.stack([body["basis/columns"][name][rows].ravel() for name in sorted(body["basis/columns"])], axis=-1)


def gap(values, begin, end, beyond):
    """The distance of a cluster from its neighbours, relative to itself."""
    below = values[begin] - values[begin - 1] if begin > 0 else np.inf
    above = (values[end] if end < len(values) else beyond) - values[end - 1]
    return min(below, above) / values[end - 1]


def span_gate(body, gates=DIRECT):
    """Of span(U), by the gap of the singular values where U was cut."""
    sigma, r = body["reduction/singular_values"][:], body["basis"].attrs["column_count"]
    return gates.of(1 - sigma[r] / sigma[r - 1] if r < len(sigma) else 1)


class Compared(InAFolder):
    """Two models of one problem; `other` may hold the surface alone."""

    def expect_same_values(self, one, other, gates=DIRECT):
        np.testing.assert_array_equal(other["modes/kinds"][:], one["modes/kinds"][:])
        np.testing.assert_allclose(other["modes/eigenvalues"][:], one["modes/eigenvalues"][:], rtol=gates.values)

    def expect_same_modes(self, one, other, beyond=np.inf, gates=DIRECT):
        """`beyond`: the first eigenvalue that they do not have."""
        self.expect_same_values(one, other, gates)
        flexible = one["modes/kinds"][:] == b"flexible"
        values = one["modes/eigenvalues"][flexible]
        shared = np.isin(one["geometry/vertex_ids"][:], other["geometry/vertex_ids"][:])
        u, v = flat_columns(one, shared), flat_columns(other)
        np.testing.assert_allclose(v[:, ~flexible], u[:, ~flexible], rtol=0, atol=1e-9 * np.abs(u).max())
        u, v = u[:, flexible], v[:, flexible]
        for begin, end in clusters(values):
            gate = gates.of(gap(values, begin, end, beyond))
            self.assertLessEqual(largest_sine(u[:, begin:end], v[:, begin:end]), gate, f"modes {begin} to {end}")
            if end == begin + 1:  # the sign too
                difference = np.linalg.norm(u[:, begin] - v[:, begin]) / np.linalg.norm(u[:, begin])
                self.assertLessEqual(difference, gate, f"mode {begin}")

    def expect_same_span(self, one, other, gates=DIRECT):
        self.assertLessEqual(largest_sine(flat_columns(one), flat_columns(other)), span_gate(one, gates))


class Ranks(Compared):
    def model(self, ranks, *words):
        name = f"on_{ranks}.h5"
        self.reduce(*MATERIAL, *words, "-output", name, ranks=ranks)
        return self.body(name)

    def expect_same(self, one, other, beyond, gates):
        self.expect_same_modes(one, other, beyond, gates)
        np.testing.assert_array_equal(one["geometry/points"][:], other["geometry/points"][:])
        np.testing.assert_array_equal(one["geometry/cells/vertices"][:], other["geometry/cells/vertices"][:])

    def compare(self, modes, *words, gates=DIRECT, counts=RANKS):
        one = self.model(1, "-modes", str(modes), *words)
        self.reduce(*MATERIAL, "-modes", str(modes + 4), *words, "-output", "more.h5", ranks=1)
        kept = len(one["modes/eigenvalues"])
        more = self.body("more.h5")["modes/eigenvalues"][:]
        beyond = more[kept] if kept < len(more) else np.inf
        for ranks in counts:
            with self.subTest(ranks=ranks):
                self.expect_same(one, self.model(ranks, "-modes", str(modes), *words), beyond, gates)

    def compare_iterative(self, modes, *words, counts):
        self.compare(modes, *words, "-solver", "iterative", gates=ITERATIVE, counts=counts)

    def test_clamped_tetrahedra(self):
        self.compare(10, "-mesh", "box:1,.1,.06/12,2,2/tet4", "-fix", "xmin")

    def test_free_square_hexahedra(self):
        self.compare(8, "-mesh", "box:1,.1,.1/12,2,2/hex8")

    def test_a_file_in_a_random_order(self):
        write_shuffled_beam(self.folder / "beam.msh")
        self.compare(8, "-mesh", "beam.msh", "-fix", "box:0,0,-1,1,-1,1")

    def test_fewer_cells_than_ranks(self):
        self.compare(100, "-mesh", "box:1,.3,.2/2,1,1/hex8")
        self.compare_iterative(4, "-mesh", "box:1,.3,.2/4,1,1/hex8", "-fix", "xmin", counts=(5, 8))

    def test_partly_supported(self):
        words = ["-mesh", "box:1,.1,.06/8,2,1/tet10", "-fix", "xmin:yz,xmax:z"]
        self.compare(6, *words)
        self.compare_iterative(6, *words, counts=(2, 3))


class Nonlinear(Compared):
    """The basis as a subspace, and the energy of one displacement through each rank count's own U."""

    def energy(self, body, u):
        """Ẽ(z) at the z nearest to u, by the stored coefficients: ½ A zz + ⅙ B zzz + 1/24 C zzzz."""
        z = np.linalg.lstsq(flat_columns(body), u, rcond=None)[0]
        total = 0.0
        for name, order, factorial in (("quadratic", 2, 2), ("cubic", 3, 6), ("quartic", 4, 24)):
            indices = np.array(list(itertools.combinations_with_replacement(range(len(z)), order)))
            times = [factorial / math.prod(map(math.factorial, np.unique(i, return_counts=True)[1])) for i in indices]
            total += np.dot(body[f"polynomial/{name}"][:] * times, z[indices].prod(axis=1)) / factorial
        return total

    def model(self, ranks, *words):
        name = f"on_{ranks}.h5"
        self.reduce(*MATERIAL, *words, "-polynomial", "-output", name, ranks=ranks)
        return self.body(name)

    def compare(self, *words, gates=DIRECT, counts=RANKS):
        one = self.model(1, *words)
        U = flat_columns(one)
        u = U @ (.1 / np.abs(U).max() * np.arange(1, U.shape[1] + 1))
        energy = self.energy(one, u)
        for ranks in counts:
            with self.subTest(ranks=ranks):
                other = self.model(ranks, *words)
                self.expect_same_span(one, other, gates)
                # The energy is of the fourth degree in what the span leaves of u.
                self.assertAlmostEqual(self.energy(other, u) / energy, 1, delta=4 * span_gate(one, gates))

    def test_derivatives(self):
        for mesh in ("1,.1,.06/6,2,1/tet4", "1,.1,.06/3,1,1/tet10", "1,.3,.2/4,1,1/hex8"):  # the last has 4 cells
            with self.subTest(mesh=mesh):
                self.compare("-mesh", "box:" + mesh, "-fix", "xmin", "-modes", "4", "-derivatives", "4", "-basis", "7")

    def test_derivatives_without_a_factorization(self):
        self.compare("-mesh", "box:1,.1,.06/4,2,1/tet10", "-fix", "xmin", "-modes", "4", "-derivatives", "4", "-basis",
                     "7", "-solver", "iterative", gates=ITERATIVE, counts=(2, 3))

    def test_snapshots(self):
        np.save(self.folder / "s.npy", np.random.default_rng(1).random((6, 3 * 20)))
        self.compare("-mesh", "box:1,.3,.2/4,1,1/hex8", "-fix", "xmin", "-modes", "0", "-snapshots", "s.npy",
                     "-basis", "4")


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
