"""What a scene does not need is absent: which stages ran (PETSc's log), which groups the file has, and that a part more
leaves every bit of the others as it was; on two ranks, leaves them the same at the gates of ranks_test.py."""
import re
import unittest

import h5py
import numpy as np

from program import InAFolder
from ranks_test import Compared

BEAM = ["-mesh", "box:1,.1,.06/8,2,1/tet10", "-material_young", "1e6", "-material_poisson", ".3",
        "-material_density", "1000"]
HELD = [*BEAM, "-fix", "xmin"]
ALWAYS = ["mesh", "assemble", "modes", "inertia", "loads", "write"]
GROUPS = {"geometry", "basis", "modes", "inertia", "loads"}
PUSHED = '[[load]]\nset = "xmax"\ntotal = [0, 0, -1]\n'
STATIC = "[static]\nsteps = 2\n" + PUSHED
MOVING = "[time]\nstep = 0.02\nend = 0.1\n" + PUSHED


class Lean(InAFolder):
    def stages(self):
        """The stages of PETSc's log, in their order."""
        text = (self.folder / "log").read_text()
        table = text[text.index("Summary of Stages"):]
        names = re.findall(r"^ *\d+: +(\S.*?): ", table, re.MULTILINE)
        return [name for name in names if name != "Main Stage"]

    def model(self, *words, name="model.h5"):
        """Stages, groups of the body, and all its datasets."""
        self.reduce(*words, "-log_view", ":log", "-output", name, ranks=1)
        values = {}

        def keep(path, thing):
            if isinstance(thing, h5py.Dataset):
                values[path] = thing[()]

        with h5py.File(self.folder / name) as file:
            file["bodies/body"].visititems(keep)
            return self.stages(), set(file["bodies/body"]), values

    def same(self, one, other, parts):
        compared = [path for path in one if path.split("/")[0] in parts]
        self.assertEqual(compared, [path for path in other if path.split("/")[0] in parts])
        self.assertGreater(len(compared), 0)
        for path in compared:
            self.assertEqual(one[path].tobytes(), other[path].tobytes(), path)

    def stages_of(self, scene):
        self.full(*HELD, "-scene", self.write("scene.toml", scene), "-log_view", ":log", "-quiet", ranks=1)
        return self.stages()

    def test_linear(self):
        stages, groups, _ = self.model(*HELD, "-modes", "4")
        self.assertEqual(stages, ALWAYS)
        self.assertEqual(groups, GROUPS)

    def test_linear_with_surface_output(self):
        stages, groups, whole = self.model(*HELD, "-modes", "4")
        self.assertEqual((stages, groups), self.model(*HELD, "-modes", "4", "-surface_only")[:2])
        surface = self.model(*HELD, "-modes", "4", "-surface_only")[2]
        self.same(surface, whole, {"modes", "inertia", "loads"})
        rows = np.searchsorted(whole["geometry/vertex_ids"], surface["geometry/vertex_ids"])
        self.assertLess(len(rows), len(whole["geometry/vertex_ids"]))
        np.testing.assert_array_equal(surface["geometry/points"], whole["geometry/points"][rows])

    def test_nonlinear(self):
        nonlinear = [*HELD, "-modes", "4", "-derivatives", "3", "-basis", "6"]
        stages, groups, basis = self.model(*nonlinear)
        self.assertEqual(stages, ["mesh", "assemble", "modes", "basis", "check", "inertia", "loads", "write"])
        self.assertEqual(groups, GROUPS | {"reduction"})
        stages, groups, with_forces = self.model(*nonlinear, "-polynomial")
        self.assertEqual([name for name in stages if name == "polynomial"], ["polynomial"])
        self.assertEqual(groups, GROUPS | {"reduction", "polynomial"})
        self.same(basis, with_forces, GROUPS | {"reduction"})
        modes = self.model(*HELD, "-modes", "4")[2]
        self.same(modes, basis, {"modes", "geometry"})

    def test_statics_only(self):
        self.assertEqual(self.stages_of(STATIC), ["mesh", "assemble", "run", "write"])
        self.assertFalse((self.folder / "energy.csv").exists())
        stages, groups, _ = self.model(*HELD, "-modes", "0", "-snapshots", "full.h5", "-polynomial")
        self.assertEqual(stages, ["mesh", "assemble", "modes", "basis", "polynomial", "check", "inertia", "loads",
                                  "write"])
        self.assertEqual(groups, GROUPS - {"modes"} | {"reduction", "polynomial"})
        self.move("model.h5", "--scene", "scene.toml", "--quiet")
        self.inspect("model.h5", "--check")

    def test_one_support_set(self):
        held = self.model(*HELD, "-modes", "4")
        self.assertNotIn("rigid", [kind.decode() for kind in held[2]["modes/kinds"]])
        free = self.model(*BEAM, "-fix", "none", "-modes", "4")
        self.assertEqual(held[:2], free[:2])
        self.assertEqual([kind.decode() for kind in free[2]["modes/kinds"]], ["rigid"] * 6 + ["flexible"] * 4)
        self.same(held[2], free[2], {"geometry"})

    def test_no_damping(self):
        self.assertEqual(self.stages_of(MOVING), ["mesh", "assemble", "run", "write"])
        undamped = (self.folder / "energy.csv").read_text().splitlines()
        dissipated = undamped[0].split(",").index("dissipated")
        self.assertEqual({row.split(",")[dissipated] for row in undamped[1:]}, {"0"})
        log = (self.folder / "log").read_text()
        self.stages_of(MOVING + "[damping]\nbeta = 1e-3\n")
        count = lambda text: int(re.search(r"^MatMult +(\d+)", text, re.MULTILINE).group(1))
        self.assertGreater(count((self.folder / "log").read_text()), count(log))


class LeanOnTwoRanks(Compared):
    def model(self, name, *words):
        self.reduce(*HELD, "-modes", "4", "-quiet", *words, "-output", name)
        return self.body(name)

    def test_a_part_more_leaves_the_others(self):
        linear, surface = self.model("linear.h5"), self.model("surface.h5", "-surface_only")
        self.assertLess(len(surface["geometry/points"]), len(linear["geometry/points"]))
        self.expect_same_modes(linear, surface)
        nonlinear = ["-derivatives", "3", "-basis", "6"]
        basis, forces = self.model("basis.h5", *nonlinear), self.model("forces.h5", *nonlinear, "-polynomial")
        self.expect_same_values(linear, basis)
        self.expect_same_values(basis, forces)
        self.expect_same_span(basis, forces)
        for one, other in ((linear, surface), (basis, forces)):
            gram = one["inertia/gram"][:]
            np.testing.assert_allclose(other["inertia/gram"][:], gram, rtol=0, atol=1e-9 * np.abs(gram).max())


if __name__ == "__main__":
    unittest.main()
