"""One name for a node set, an element set and a surface means the same to every program: to -fix, to a scene's loads and
probes in ritz-full and in ritz-run; and a name that stays ambiguous is refused alike."""
import unittest

import numpy as np

from mesh_file import tetrahedra
from program import InAFolder

LABELS = {3: "S1", 2: "S2", 0: "S3", 1: "S4"}  # of a tetrahedron's face, by the vertex that is not on it
MATERIAL = ["-material_young", "1e6", "-material_poisson", ".3", "-material_density", "1000"]


def beam():
    """A deck whose ends have names as Abaqus/CAE gives them to picked faces, and names of their own kind beside."""
    points, cells = (np.array(part) for part in tetrahedra((4, 1, 1), (1., .2, .1)))
    ends = {"FIX": np.flatnonzero(points[:, 0] == 0), "GRIP": np.flatnonzero(points[:, 0] == 1)}
    lines = ["*NODE"] + [f"{i + 1}, {x!r}, {y!r}, {z!r}" for i, (x, y, z) in enumerate(points.tolist())]
    lines += ["*ELEMENT, TYPE=C3D4, ELSET=all"] + [f"{i + 1}, " + ", ".join(str(v + 1) for v in cell)
                                                   for i, cell in enumerate(cells.tolist())]
    for name, nodes in ends.items():
        beside = [i for i, cell in enumerate(cells) if np.isin(cell, nodes).any()]
        faces = [f"{i + 1}, {LABELS[int(np.flatnonzero(~np.isin(cells[i], nodes))[0])]}" for i in beside
                 if np.isin(cells[i], nodes).sum() == 3]
        for kind in ("NSET, NSET", "ELSET, ELSET"):
            for set_name in (name, f"{name}_{kind[0]}"):
                members = nodes if kind[0] == "N" else beside
                lines += [f"*{kind}={set_name}"] + [str(i + 1) for i in members]
        for set_name in (name, f"{name}_S"):
            lines += [f"*SURFACE, NAME={set_name}", *faces]
    lines += ["*ELSET, ELSET=EITHER", "1", "*SURFACE, NAME=EITHER", faces[0], ""]
    return "\n".join(lines)


def scene(load, pressure, probe):
    return (f"[static]\nsteps = 1\n[[load]]\nset = '{load}'\ntotal = [0, 0, 1e-3]\n"
            f"[[load]]\nset = '{pressure}'\npressure = 1e-2\n[[probe]]\nname = 'p'\nset = '{probe}'\n")


class SetNames(InAFolder):
    def setUp(self):
        super().setUp()
        self.write("beam.inp", beam())

    def model(self, fix):
        self.reduce("-mesh", "beam.inp", *MATERIAL, "-fix", fix, "-modes", "4", "-quiet")
        return np.array(self.eigenvalues())

    def probes(self, program, text, code=0):
        scene = self.write("scene.toml", text)
        if program == "run":
            result = self.move("model.h5", "--scene", scene, "--output", "motion.h5", code=code)
        else:
            result = self.full("-mesh", "beam.inp", *MATERIAL, "-fix", "FIX", "-scene", scene, "-quiet", code=code)
        return result.err if code else self.tip()

    def test_supports_take_the_node_set(self):
        alone = self.model("FIX_N")
        np.testing.assert_allclose(self.model("FIX"), alone, rtol=1e-12)
        np.testing.assert_allclose(self.model("nset:FIX"), alone, rtol=1e-12)
        stiffer = self.model("elset:FIX")
        self.assertGreater(stiffer[0], 1.2 * alone[0])
        np.testing.assert_allclose(stiffer, self.model("FIX_E"), rtol=1e-12)

    def test_loads_and_probes_take_their_own_kind_in_both_programs(self):
        self.model("FIX")
        for program in ("run", "full"):
            with self.subTest(program=program):
                shared = self.probes(program, scene("GRIP", "GRIP", "GRIP"))
                alone = self.probes(program, scene("GRIP_N", "GRIP_S", "GRIP_N"))
                np.testing.assert_array_equal(shared, alone)
                cells = self.probes(program, scene("elset:GRIP", "surface:GRIP", "elset:GRIP"))
                self.assertGreater(np.abs(cells - shared).max(), 1e-3 * np.abs(shared).max())

    def test_what_stays_ambiguous_is_refused_alike(self):
        self.model("FIX")
        for program in ("run", "full"):
            says = self.probes(program, scene("EITHER", "GRIP", "GRIP"), code=2)
            self.assertIn("several sets 'EITHER'; say which: 'elset:EITHER' or 'surface:EITHER'", says)
            self.assertEqual(sum(line.startswith("ritz-") for line in says.splitlines()), 1)
        refused = self.reduce("-mesh", "beam.inp", *MATERIAL, "-fix", "EITHER", code=2)
        self.assertIn("'elset:EITHER' or 'surface:EITHER'", refused.err)


if __name__ == "__main__":
    unittest.main()
