"""Unit loads on named sets, projected onto the basis, against an integration over the faces in NumPy; effective masses
against the mass; and the model as VTK's reader sees it."""
import unittest

import numpy as np

from program import InAFolder

LENGTHS = np.array([1, .4, .3])
SIDES = ["xmin", "xmax", "ymin", "ymax", "zmin", "zmax"]
FACES = {  # by VTK's type of cell: each face's corners, and where the vertices in the middle of its edges stand
    10: [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]],
    24: [[0, 2, 1, 6, 5, 4], [0, 1, 3, 4, 8, 7], [1, 2, 3, 5, 9, 8], [0, 3, 2, 7, 9, 6]],
    12: [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]],
    25: [[0, 3, 2, 1, 11, 10, 9, 8], [4, 5, 6, 7, 12, 13, 14, 15], [0, 1, 5, 4, 8, 17, 12, 16],
         [1, 2, 6, 5, 9, 18, 13, 17], [2, 3, 7, 6, 10, 19, 14, 18], [3, 0, 4, 7, 11, 16, 15, 19]],
    26: [[0, 1, 2, 6, 7, 8], [3, 5, 4, 11, 10, 9], [0, 3, 4, 1, 12, 9, 13, 6], [1, 4, 5, 2, 13, 10, 14, 7],
         [2, 5, 3, 0, 14, 11, 12, 8]],
}
SHARES = {3: np.full(3, 1 / 3), 4: np.full(4, 1 / 4), 6: np.array([0, 0, 0, 1, 1, 1]) / 3,
          8: np.array([-1, -1, -1, -1, 4, 4, 4, 4]) / 12}  # of a flat face's area


def boundary_faces(geometry):
    types, offsets, vertices = (geometry[f"cells/{name}"][:] for name in ("types", "offsets", "vertices"))
    seen = {}
    for i, kind in enumerate(types):
        cell = vertices[offsets[i]:offsets[i + 1]]
        for face in FACES[kind]:
            seen.setdefault(frozenset(cell[face]), []).append(cell[face])
    return [faces[0] for faces in seen.values() if len(faces) == 1]


def side_weights(geometry, side):
    """The integral of each vertex's shape function over a side of the box."""
    points = geometry["points"][:]
    axis, end = divmod(SIDES.index(side), 2)
    inside = np.isclose(points[:, axis], end * LENGTHS[axis])
    weights = np.zeros(len(points))
    for face in boundary_faces(geometry):
        if not inside[face].all():
            continue
        a, b, c = points[face[:3]]
        area = np.linalg.norm(np.cross(b - a, c - a)) * (1 if len(face) in (4, 8) else .5)
        weights[face] += area * SHARES[len(face)]
    return weights, inside


class SetLoads(InAFolder):
    def model(self, kind, *words):
        self.reduce("-mesh", f"box:{LENGTHS[0]},{LENGTHS[1]},{LENGTHS[2]}/4,2,2/{kind}", "-material_young", "1e6",
                    "-material_poisson", ".3", "-material_density", "1000", "-modes", "7", "-quiet", *words)
        body = self.body()
        columns = body["basis/columns"]
        return body, np.stack([columns[name][:] for name in sorted(columns)])  # r x n x 3

    def test_projections(self):
        for kind in ("tet4", "tet10", "hex8", "hex20", "wedge15"):
            body, u = self.model(kind, "-fix", "xmin")
            scale = np.abs(u).max()
            for side in SIDES:
                with self.subTest(kind=kind, side=side):
                    load = body["loads"][side]
                    weights, inside = side_weights(body["geometry"], side)
                    axis, end = divmod(SIDES.index(side), 2)
                    traction = np.einsum("v,rvc->rc", weights, u)
                    inwards = -1 if end else 1
                    self.assertEqual(load.attrs["vertices"], inside.sum())
                    np.testing.assert_array_equal(body["geometry/sets"][side]["rows"][:], np.flatnonzero(inside))
                    self.assertAlmostEqual(load.attrs["area"] / np.prod(np.delete(LENGTHS, axis)), 1, delta=1e-13)
                    same = lambda a, b: np.testing.assert_allclose(a, b, rtol=0, atol=1e-12 * scale)
                    same(load["total"][:], u[:, inside].mean(axis=1))
                    same(load["traction"][:], traction)
                    same(load["pressure"][:], inwards * traction[:, axis])

    def test_gram_matrix_holds_mass_and_participation(self):
        for kind in ("tet4", "hex8"):
            body, u = self.model(kind)
            gram, r = body["inertia/gram"][:], len(u)
            mass = 1000 * LENGTHS.prod()
            self.assertAlmostEqual(gram[0, 0] / mass, 1, delta=1e-13)
            participation = gram[4:, 0].reshape(3, r)
            masses = participation**2
            np.testing.assert_allclose(masses.sum(axis=1), mass, rtol=1e-11)  # of a free body: all of it
            np.testing.assert_allclose(masses[:, 6:], 0, atol=1e-12 * mass)
            whole = sum(gram[4 + c * r:4 + (c + 1) * r, 4 + c * r:4 + (c + 1) * r] for c in range(3))
            np.testing.assert_allclose(whole, np.eye(r), atol=1e-12)  # UᵀMU

    def test_vtk_opens_the_model(self):
        try:
            from vtkmodules.vtkIOHDF import vtkHDFReader
        except ImportError:
            self.skipTest("no VTK")
        for kind, vtk_type in (("tet4", 10), ("tet10", 24), ("hex8", 12), ("hex20", 25), ("wedge6", 13), ("wedge15", 26)):
            body, u = self.model(kind, "-fix", "xmin")
            reader = vtkHDFReader()
            reader.SetFileName(str(self.folder / "model.hdf"))
            reader.Update()
            grid = reader.GetOutput()
            self.assertEqual(grid.GetNumberOfPoints(), u.shape[1])
            self.assertEqual(grid.GetNumberOfCells(), len(body["geometry/cells/types"]))
            self.assertEqual(grid.GetCellType(0), vtk_type)
            self.assertEqual(grid.GetPointData().GetNumberOfArrays(), len(u))
            bounds = np.array(grid.GetBounds())
            np.testing.assert_allclose(bounds, np.ravel([np.zeros(3), LENGTHS], order="F"), atol=1e-15)
            mode = grid.GetPointData().GetArray(1)
            self.assertRegex(mode.GetName(), r"^mode 02, \d+(\.\d+)? Hz$")
            size = np.linalg.norm(u[1], axis=1).max()
            for vertex in (0, 7, u.shape[1] - 1):
                np.testing.assert_array_equal(grid.GetPoint(vertex), body["geometry/points"][vertex])
                np.testing.assert_allclose(mode.GetTuple(vertex), 0.1 * np.linalg.norm(LENGTHS) / size * u[1, vertex],
                                           rtol=1e-6, atol=1e-8)


if __name__ == "__main__":
    unittest.main()
