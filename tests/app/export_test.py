"""Exported matrices are in the mesh's own order, whatever the number of ranks, and satisfy Eq. 1."""
import unittest

import numpy as np
from scipy.io import mmread

from mesh_file import write_shuffled_beam
from program import BOX, InAFolder

MATERIAL = ["-material_young", "1e6", "-material_poisson", ".3", "-material_density", "1000"]
SLIDING = ["-fix", "xmin:x,ymin:yz"]


def same_space(a, b, mass):
    """How far two sets of M-orthonormal vectors are from spanning the same."""
    return np.abs(a - b @ (b.T @ (mass @ a))).max()


class Export(InAFolder):
    def matrices(self, *words, ranks=2, ending="mtx", read=mmread):
        self.reduce(*BOX, *words, ranks=ranks)
        return [read(self.folder / f"model_{part}.{ending}") for part in ("K", "M", "modes")]

    def market(self, *words, ranks=2):
        stiffness, mass, modes = self.matrices(*words, "-export", "matrixmarket", ranks=ranks)
        return stiffness.tocsr(), mass.tocsr(), np.asarray(modes)

    def test_a_free_body_has_its_rigid_motions_in_the_order_of_the_mesh(self):
        stiffness, mass, _ = self.market()
        x = self.body()["geometry/points"][:]
        moves = [np.tile(e, (len(x), 1)) for e in np.eye(3)] + [np.cross(e, x) for e in np.eye(3)]
        scale = abs(stiffness).max()
        for move in moves:
            self.assertLess(np.abs(stiffness @ move.ravel()).max(), 1e-12 * scale)
        shift = moves[1].ravel()
        self.assertAlmostEqual(shift @ (mass @ shift) / (1000 * 1 * .4 * .3), 1, delta=1e-13)

    def test_modes_solve_the_eigenproblem(self):
        stiffness, mass, modes = self.market(*SLIDING)
        values = np.array(self.eigenvalues())
        self.assertEqual(modes.shape, (stiffness.shape[0], len(values)))
        np.testing.assert_allclose(modes.T @ (mass @ modes), np.eye(len(values)), atol=1e-12)
        residual = stiffness @ modes - mass @ modes * values
        self.assertLess((np.linalg.norm(residual, axis=0) / np.linalg.norm(mass @ modes * values, axis=0)).max(), 1e-8)

    def test_fixed_components_are_left_out(self):
        free, _, _ = self.market()
        held, _, _ = self.market(*SLIDING)
        x = self.body()["geometry/points"][:]
        keep = np.ones((len(x), 3), bool)
        keep[x[:, 0] == 0, 0] = False
        keep[x[:, 1] == 0, 1:] = False
        keep = keep.ravel()
        self.assertEqual(held.shape[0], keep.sum())
        self.assertLess(abs(held - free[keep][:, keep]).max(), 1e-9 * abs(free).max())

    def test_a_table_says_whose_row_it_is(self):
        """On a mesh whose vertices have numbers and an order of their own."""
        write_shuffled_beam(self.folder / "m.msh")
        for ranks in (1, 3):
            self.reduce("-mesh", "m.msh", "-fix", "box:-.01,.01,-1,1,-1,1:yz", *MATERIAL, "-modes", "2", "-export",
                        "matrixmarket", ranks=ranks)
            body = self.body()
            x, ids = body["geometry/points"][:], body["geometry/vertex_ids"][:]
            held = abs(x[:, 0]) < .01
            expected = [(str(i), "xyz"[c]) for i, h in zip(ids, held) for c in range(3) if not (h and c)]
            lines = (self.folder / "model_rows.csv").read_text().splitlines()
            self.assertEqual(lines[0], "row,vertex,component")
            rows = [line.split(",") for line in lines[1:]]
            self.assertEqual([(v, c) for _, v, c in rows], expected)
            self.assertEqual([int(row) for row, _, _ in rows], list(range(1, len(expected) + 1)))
            self.assertEqual(mmread(self.folder / "model_K.mtx").shape[0], len(expected))

    def test_the_number_of_ranks_does_not_matter(self):
        one = self.market(*SLIDING, ranks=1)
        for ranks in (2, 3):
            several = self.market(*SLIDING, ranks=ranks)
            for a, b in zip(one[:2], several[:2]):
                self.assertLess(abs(a - b).max(), 1e-13 * abs(a).max())
            np.testing.assert_allclose(several[2], one[2], atol=1e-9 * np.abs(one[2]).max())

    def test_petsc_binary(self):
        stiffness, mass, modes = self.market(*SLIDING)
        for ours, theirs in zip((stiffness.toarray(), mass.toarray(), modes),
                                self.matrices(*SLIDING, "-export", "petsc", ending="bin", read=read_petsc)):
            np.testing.assert_allclose(theirs, ours, rtol=0, atol=1e-12 * np.abs(ours).max())


def read_petsc(path):
    """PETSc's matrix: big-endian class id, rows, columns, non-zeros (-1: dense, by columns or rows), then all of them."""
    data = path.read_bytes()
    kind, rows, columns, count = np.frombuffer(data, ">i4", 4)
    assert kind == 1211216
    if count == -1:
        return np.frombuffer(data, ">f8", rows * columns, 16).reshape(rows, columns)
    lengths = np.frombuffer(data, ">i4", rows, 16)
    where = np.frombuffer(data, ">i4", count, 16 + 4 * rows)
    matrix = np.zeros((rows, columns))
    matrix[np.repeat(np.arange(rows), lengths), where] = np.frombuffer(data, ">f8", count, 16 + 4 * (rows + count))
    return matrix


if __name__ == "__main__":
    unittest.main()
