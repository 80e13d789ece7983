"""Every kind of cell through the programs: modes, derivatives, polynomial, motion, and what VTK sees of the files."""
import unittest

import h5py
import numpy as np

from program import InAFolder

BOX = "1,.2,.15/6,2,2"
VOLUME = 1 * .2 * .15
STEEL = ["-material_young", "1e6", "-material_poisson", ".3", "-material_density", "1000"]
FIRST = .7595  # Hz, the limit of finer meshes: hex20 and wedge15 with 67,000 degrees of freedom are .02 % above it
ACCURACY = {"tet4": .75, "tet10": .013, "hex8": .26, "hex20": .011, "wedge6": .11, "wedge15": .009}  # on 6 x 2 x 2

# A hexahedron, a pyramid on its end, and four tetrahedra around that, in the order of Gmsh.
MIXED = """$MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
13
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 0 0 1
6 1 0 1
7 1 1 1
8 0 1 1
9 1.5 .5 .5
10 2 0 0
11 2 1 0
12 2 0 1
13 2 1 1
$EndNodes
$Elements
11
1 3 2 1 1 1 4 8 5
2 5 2 2 2 1 2 3 4 5 6 7 8
3 7 2 2 2 2 3 7 6 9
4 7 2 2 2 10 12 13 11 9
5 7 2 2 2 2 10 11 3 9
6 7 2 2 2 6 7 13 12 9
7 4 2 2 2 2 6 12 9
8 4 2 2 2 2 12 10 9
9 4 2 2 2 3 13 7 9
10 4 2 2 2 3 11 13 9
11 3 2 3 3 10 11 13 12
$EndElements
"""


def volume_and_area(path):
    from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
    from vtkmodules.vtkIOHDF import vtkHDFReader
    from vtkmodules.util.numpy_support import vtk_to_numpy
    reader = vtkHDFReader()
    reader.SetFileName(str(path))
    sizes = vtkCellSizeFilter()
    sizes.SetInputConnection(reader.GetOutputPort())
    sizes.Update()
    data = sizes.GetOutput().GetCellData()
    return [vtk_to_numpy(data.GetArray(name)) for name in ("Volume", "Area")]


class Cells(InAFolder):
    def first_flexible(self):
        return next(float(row["frequency_hz"]) for row in self.frequencies() if row["kind"] == "flexible")

    def test_a_cantilever_of_each(self):
        scene = '[time]\nstep = 0.01\nend = 0.2\n[[load]]\nset = "xmax"\npressure = -30.0\n[[load]]\nset = "ymax"\ntraction = [0, 0, 1.0]\n'
        self.write("scene.toml", scene)
        for kind, error in ACCURACY.items():
            with self.subTest(kind):
                self.reduce("-mesh", f"box:{BOX}/{kind}", "-fix", "xmin", *STEEL, "-modes", "4", "-derivatives", "3",
                            "-polynomial", "-quiet", ranks=2)
                self.assertTrue(-1e-4 < self.first_flexible() / FIRST - 1 < error, self.first_flexible())
                self.assertIn(kind + " cells", self.inspect("model.h5").out)
                self.move("model.h5", "--scene", "scene.toml", "--quiet")

    def check_picture(self, model):
        """What plot_modes.py draws is the file's: all modes by name, and at vertices their values."""
        from plot_modes import read_surface
        points, _, drawn = read_surface(str(model))
        with h5py.File(model) as file:
            stored = {name: values[:] for name, values in file["VTKHDF/PointData"].items()}
            apart = np.linalg.norm(points[:, None] - file["VTKHDF/Points"][:], axis=2)
        self.assertEqual(set(drawn), set(stored))
        at_vertex, vertex = np.nonzero(apart < 1e-6)
        self.assertGreaterEqual(len(vertex), 7 * 3 * 3 - 5)  # the cells' corners on the boundary
        for name, values in stored.items():
            np.testing.assert_array_equal(drawn[name][at_vertex], values[vertex])

    def test_what_vtk_sees(self):
        try:
            import vtkmodules.vtkIOHDF  # noqa: F401
        except ImportError:
            self.skipTest("no VTK")
        for kind in ACCURACY:
            for words in ([], ["-surface_only"]):
                with self.subTest(kind=kind, words=words):
                    self.reduce("-mesh", f"box:{BOX}/{kind}", "-fix", "xmin", *STEEL, "-modes", "2", "-quiet", *words)
                    self.check_picture(self.folder / "model.hdf")
                    volumes, areas = volume_and_area(self.folder / "model.hdf")
                    if words:
                        self.assertAlmostEqual(areas.sum(), 2 * (.2 + .15 + .2 * .15), delta=1e-12)
                    else:
                        self.assertGreater(volumes.min(), 0)
                        self.assertAlmostEqual(volumes.sum(), VOLUME, delta=1e-12)

    def test_pyramids_join_hexahedra_to_tetrahedra(self):
        self.write("mixed.msh", MIXED)
        words = ["-mesh", "mixed.msh", "-fix", "1", *STEEL, "-modes", "30", "-quiet"]
        result = self.reduce(*words, "-derivatives", "2", "-polynomial", ranks=1)
        self.assertNotIn("not conforming", result.err)
        together = self.eigenvalues()
        self.reduce(*words, ranks=3)
        np.testing.assert_allclose(self.eigenvalues(), together, rtol=1e-10)
        mass = self.body()["inertia/gram"][0, 0]
        self.assertAlmostEqual(mass, 2000, delta=1e-9)
        self.assertIn("pyramid5", self.inspect("model.h5").out)


if __name__ == "__main__":
    unittest.main()
