"""ritz-full as a program: what it writes, the same on any number of ranks, and that it goes on from where it stopped."""
import subprocess
import unittest
import xml.etree.ElementTree

import numpy as np

from mesh_file import write_shuffled_beam
from program import InAFolder, sentences

MATERIAL = ["-material_young", "1e6", "-material_poisson", ".3", "-material_density", "1000", "-quiet"]
BEAM = ["-mesh", "box:1,.15,.1/6,2,1/hex8", "-fix", "xmin", *MATERIAL]
SCENE = """
gravity = [0, 0.5, -2]
[time]
step = 0.02
end = {end}
integrator = "{integrator}"
[damping]
alpha = 0.1
beta = 0.001
[shake]
direction = [0, 1, 0]
table = [[0, 0], [0.1, 3], [0.2, -3], [0.3, 0]]
[[load]]
set = "xmax"
total = [0, 2, 4]
table = [[0, 0], [0.2, 1], [0.4, 0]]
[[load]]
set = "ymax"
pressure = 40
[[load]]
vertex = 7
each = [0, 0, 1]
[[probe]]
name = "tip"
set = "xmax"
[[probe]]
name = "corner"
vertex = 7
"""


class Full(InAFolder):
    def scene(self, name="scene.toml", end=.4, integrator="avf", text=SCENE):
        return ["-scene", self.write(name, text.format(end=end, integrator=integrator))]

    def motion(self, name="full.h5"):
        return self.file(name)


class Files(Full):
    def test_a_motion(self):
        self.full(*BEAM, *self.scene(), "-frames", "5")
        self.assertEqual(self.files(), {"scene.toml", "full.h5", "full.xdmf", "probes.csv", "energy.csv"})
        file = self.motion()
        self.assertEqual(file.attrs["format"], b"ritz-motion 1")
        n = len(file["points"])
        self.assertEqual(file["snapshots"].shape, (5, 3 * n))
        self.assertEqual(file["displacement"].shape, (5, n, 3))
        np.testing.assert_array_equal(file["displacement"][:].reshape(5, 3 * n), file["snapshots"][:])
        for i in range(5):
            np.testing.assert_array_equal(file[f"frames/{i}"][:], file["displacement"][i])
        np.testing.assert_allclose(file["times"][:], .02 * np.arange(21), atol=1e-15)
        np.testing.assert_array_equal(file["frame_times"][:], file["times"][::5])
        np.testing.assert_array_equal(file["state/displacement"][:], file["displacement"][-1])
        self.assertFalse(file["displacement"][:, file["points"][:, 0] == 0].any())
        self.assertTrue(all("units" in file[name].attrs for name in ("points", "snapshots", "times", "frames/0")))
        tree = xml.etree.ElementTree.parse(self.folder / "full.xdmf")
        self.assertEqual(len(tree.findall(".//Time")), 5)

    def test_probes(self):
        self.full(*BEAM, *self.scene(), "-every", "1")
        header, rows = self.table("probes.csv")
        self.assertEqual(header, "t,tip_ux,tip_uy,tip_uz,corner_ux,corner_uy,corner_uz".split(","))
        file = self.motion()
        x, u = file["points"][:], file["displacement"][:]
        tip = np.isclose(x[:, 0], 1)
        corner = list(file["vertex_ids"]).index(7)
        self.assertEqual(len(rows), 21)
        np.testing.assert_allclose(rows[:, 1:4], u[:, tip].mean(axis=1), atol=1e-15)
        np.testing.assert_allclose(rows[:, 4:], u[:, corner], atol=1e-15)
        header, energies = self.table("energy.csv")
        self.assertEqual(header, "t,kinetic,elastic,work,dissipated,drift".split(","))
        self.assertLess(np.abs(energies[:, 5]).max(), 1e-9 * energies[:, 2].max())
        self.assertGreater(energies[-1, 4], 0)

    def test_statics_and_a_release(self):
        pull = '[static]\nsteps = 2\n[[load]]\nset = "xmax"\ntotal = [0, 3, 5]\n[[probe]]\nname = "tip"\nset = "xmax"\n'
        self.full(*BEAM, *self.scene("pull.toml", text=pull), "-output", "pulled.h5")
        self.assertEqual(self.files(), {"pull.toml", "pulled.h5", "pulled.xdmf", "pulled.probes.csv"})
        pulled = self.motion("pulled.h5")["state/displacement"][:]
        np.testing.assert_array_equal(self.table("pulled.probes.csv")[1][:, 0], [0, .5, 1])
        self.full(*BEAM, *self.scene("let_go.toml", text="[time]\nstep = 0.01\nend = 0.2\n"), "-restart", "pulled.h5")
        file = self.motion()
        np.testing.assert_array_equal(file["displacement"][0], pulled)
        self.assertEqual(file["times"][0], 0)
        self.assertGreater(np.abs(file["state/velocity"][:]).max(), .1)
        energies = self.table("energy.csv")[1]
        np.testing.assert_allclose(energies[:, 1] + energies[:, 2], energies[0, 2], rtol=1e-9)

    def test_no_frames(self):
        self.full(*BEAM, *self.scene(), "-frames", "0")
        self.assertEqual(self.files(), {"scene.toml", "full.h5", "probes.csv", "energy.csv"})
        self.assertNotIn("snapshots", self.motion())

    def test_what_steps_cost(self):
        statics = '[static]\nsteps = 3\n[[load]]\nset = "xmax"\ntotal = [0, 3, 5]\n'
        for text, times in ((SCENE, .02 * np.arange(1, 21)), (statics, [1 / 3, 2 / 3, 1])):
            self.full(*BEAM, *self.scene(text=text), "-timing", "cost.csv", "-summary", "s.json")
            summary = self.bench.summary("s.json")
            header, rows = self.table("cost.csv")
            self.assertEqual(header, "t,microseconds,iterations,rejected".split(","))
            np.testing.assert_allclose(rows[:, 0], times, atol=1e-14)
            self.assertEqual(rows[:, 2].sum(), summary["newton_iterations"])
            self.assertTrue((rows[:, 1] > 0).all())
            self.assertLess(1e-6 * rows[:, 1].sum(), summary["seconds"])
            self.assertFalse(rows[:, 3].any())

    def test_shared_option_files(self):
        self.write("a.opts", "-modes 5\n-surface_only\n-modes_eps_tol 1e-9\n-solver iterative\n")
        self.full(*BEAM, *self.scene(end=.04), "-options_file", "a.opts")


class Loads(Full):
    """Small enough to be linear, beside the same scene on all modes of the reduced model, whose loads NumPy checks
    (set_loads_test.py)."""
    HEAD = "[time]\nstep = 0.02\nend = 0.4\nintegrator = 'newmark'\n"
    PROBES = ('[[probe]]\nname = "tip"\nset = "xmax"\n[[probe]]\nname = "corner"\nvertex = 7\n'
              'quantity = ["velocity", "displacement", "acceleration"]\n')
    TABLE = "table = [[0, 0], [0.1, 1], [0.3, -0.5]]\n"
    SCENES = {
        "gravity": ("gravity = [1e-6, 2e-6, -3e-6]\n", ""),
        "shake": ("", f"[shake]\ndirection = [1e-6, 2e-6, -3e-6]\n{TABLE}"),
        "total on a set": ("", f"[[load]]\nset = 'xmax'\ntotal = [1e-5, 2e-5, -3e-5]\n{TABLE}"),
        "each of a set": ("", f"[[load]]\nset = 'xmax'\neach = [1e-6, 2e-6, -3e-6]\n{TABLE}"),
        "total on a vertex": ("", f"[[load]]\nvertex = 7\ntotal = [1e-6, 2e-6, -3e-6]\n{TABLE}"),
        "each, a vertex": ("", "[[load]]\nvertex = 7\neach = [1e-6, 2e-6, -3e-6]\n"),
        "pressure": ("", f"[[load]]\nset = 'ymax'\npressure = 1e-4\n{TABLE}"),
        "traction": ("", f"[[load]]\nset = 'zmin'\ntraction = [1e-4, 2e-4, -3e-4]\n{TABLE}"),
        "damped": ("gravity = [1e-6, 2e-6, -3e-6]\n", "[damping]\nalpha = 0.5\nbeta = 0.01\n"),
    }

    def test_they_are_those_of_the_reduced_model(self):
        of_shapes = ("gravity", "pressure", "traction")  # what the shape of cells and faces decides
        for cells, modes, names in (("4,2,1/tet4", 72, of_shapes), ("2,2,1/tet10", 180, of_shapes),
                                    ("4,2,1/hex8", 72, self.SCENES)):
            mesh = ["-mesh", f"box:1,.15,.1/{cells}", *BEAM[2:]]
            self.reduce(*mesh, "-modes", str(modes), ranks=1)
            for name in names:
                top, rest = self.SCENES[name]
                with self.subTest(cells=cells, load=name):
                    words = self.scene(text=top + self.HEAD + rest + self.PROBES)
                    self.full(*mesh, *words, "-frames", "0", ranks=2)
                    header, full = self.table("probes.csv")
                    self.move("model.h5", "--scene", "scene.toml", "--frames", "0", "--quiet")
                    said, reduced = self.table("probes.csv")
                    self.assertEqual(header, said)
                    for letter, digits in ("u", 1e-6), ("v", 1e-6), ("a", 1e-5):
                        of = [i for i, column in enumerate(header) if column[-2:-1] == letter]
                        self.assertGreater(np.abs(reduced[:, of]).max(), 1e-10)
                        self.assertLess(np.abs(full - reduced)[:, of].max(), digits * np.abs(reduced[:, of]).max(), letter)


class Starts(Full):
    MOVE = "[time]\nstep = 0.01\nend = {end}\nintegrator = '{integrator}'\n"
    PULL = "[[load]]\nset = 'xmax'\ntotal = [0, 1, 2]\ntable = [[0, 1]]\n"
    PROBE = "[[probe]]\nname = 'p'\nset = 'xmax'\nquantity = ['displacement', 'velocity', 'acceleration']\n"

    def test_in_equilibrium_it_stays_at_rest(self):
        for integrator in ("avf", "newmark", "implicit-euler"):
            self.full(*BEAM, *self.scene(text="gravity = [0, 0, -1]\n" + self.MOVE + self.PULL + self.PROBE +
                                         "[initial]\nstatic = true\n", end=.1, integrator=integrator), "-frames", "0")
            rows = self.table("probes.csv")[1]
            size = np.abs(rows[0, 1:4]).max()
            self.assertGreater(size, 1e-3)
            self.assertLess(np.abs(rows[:, 1:4] - rows[0, 1:4]).max(), 1e-9 * size)
            self.assertLess(np.abs(rows[:, 4:]).max(), 1e-6 * size)

    def test_a_motion_gives_its_last_displacements_and_velocities(self):
        self.full(*BEAM, *self.scene(text=self.MOVE + self.PULL, end=.1), "-output", "first.h5", "-frames", "0")
        moved = self.motion("first.h5")["state"]
        for time in ("", "time = 0.1\n"):
            self.full(*BEAM, *self.scene(text=self.MOVE + self.PULL + f"[initial]\nmotion = 'first.h5'\n{time}", end=.1),
                      "-every", "1", ranks=3)
            np.testing.assert_array_equal(self.motion()["displacement"][0], moved["displacement"][:])
        # loads that do not change with time go on as from a restart
        self.full(*BEAM, *self.scene(text=self.MOVE + self.PULL, end=.2), "-restart", "first.h5", "-output", "on.h5")
        for name in ("displacement", "velocity"):
            expected = self.motion("on.h5")["state"][name][:]
            self.assertLess(np.abs(self.motion()["state"][name][:] - expected).max(), 1e-9 * np.abs(expected).max())

    def test_a_reduced_motion_starts_the_full_model_at_u_equals_U_z(self):
        self.reduce(*BEAM, "-modes", "3")
        self.write("swing.toml", "[time]\nstep = 0.01\nend = 0.1\n[initial]\nz = [0.1, 0.2, 0]\nvelocity = [0, 0, 3]\n")
        self.move("model.h5", "--scene", "swing.toml", "--frames", "0")
        z, zdot = (self.motion("motion.h5")[name][4] for name in ("z", "zdot"))
        U = self.body()["basis/U"][:]
        start = "[initial]\nmotion = 'motion.h5'\nmodel = 'model.h5'\ntime = 0.04\n"
        self.full(*BEAM, *self.scene(text=self.MOVE + self.PROBE + start, end=.02), "-every", "1", ranks=3)
        np.testing.assert_allclose(self.motion()["displacement"][0].ravel(), U @ z, atol=1e-14)
        tip = np.isclose(self.motion()["points"][:, 0], 1)
        velocity = (U @ zdot).reshape(-1, 3)[tip].mean(axis=0)
        self.assertGreater(np.abs(velocity).max(), 1e-3)
        np.testing.assert_allclose(self.table("probes.csv")[1][0, 4:7], velocity, atol=1e-13)

    def test_what_it_cannot_start_from(self):
        self.full(*BEAM, *self.scene(text=self.MOVE + self.PULL, end=.1), "-output", "first.h5", "-frames", "0")
        self.reduce(*BEAM, "-modes", "2", "-output", "other.h5")
        self.reduce(*BEAM, "-modes", "3")
        self.move("model.h5", "--scene", self.scene(text=self.MOVE, end=.1)[1], "--frames", "0")
        for initial, piece in (("z = [1]", "coordinates of a reduced model"),
                               ("motion = 'first.h5'\ntime = 0.05", "velocities of its last state alone, at t = 0.1 s"),
                               ("motion = 'motion.h5'", "motion of a reduced model"),
                               ("motion = 'first.h5'\nmodel = 'model.h5'", "first.h5"),
                               ("motion = 'motion.h5'\nmodel = 'other.h5'", "of another model than"),
                               ("motion = 'none.h5'", "none.h5")):
            with self.subTest(initial):
                before = self.files() | {"scene.toml"}
                said = self.full(*BEAM, *self.scene(text=self.MOVE + f"[initial]\n{initial}\n", end=.2), code=2).err
                self.assertIn(piece, said)
                self.assertEqual(len(sentences(said)), 1, said)
                self.assertEqual(self.files(), before)
        start = "[initial]\nmotion = 'motion.h5'\nmodel = 'model.h5'\n"
        said = self.full(*BEAM, *self.scene(text=self.MOVE + start, end=.2), "-fix", "xmax", code=2).err
        self.assertIn("another mesh, material or support", said)


class Failures(Full):
    def test_a_lack_of_memory_is_no_limit_point(self):
        pull = '[static]\nsteps = 2\n[[load]]\nset = "xmax"\ntotal = [0, 3, 5]\n'
        mesh = ["-mesh", "box:1,.15,.1/24,6,6/hex8", "-fix", "xmin", *MATERIAL]
        for option, value, word in (("23", "1", "memory"), ("14", "-90", "-solve_mat_mumps_icntl_14")):
            with self.subTest(word):
                result = self.full(*mesh, *self.scene(text=pull), f"-solve_mat_mumps_icntl_{option}", value, code=1)
                complaint = sentences(result.err)
                self.assertEqual(len(complaint), 1, result.err)
                self.assertIn(word, complaint[0])
                self.assertNotIn("limit point", result.err)
                self.assertEqual(self.files(), {"scene.toml"})


class Restart(Full):
    def test_the_same_as_without_a_stop(self):
        for integrator in ("avf", "newmark", "implicit-euler"):
            with self.subTest(integrator):
                self.full(*BEAM, *self.scene(integrator=integrator), "-output", "whole.h5")
                self.full(*BEAM, *self.scene(end=.24, integrator=integrator), "-output", "half.h5", ranks=3)
                self.full(*BEAM, *self.scene(integrator=integrator), "-restart", "half.h5", "-output", "rest.h5")
                whole, rest = self.motion("whole.h5"), self.motion("rest.h5")
                np.testing.assert_allclose(rest["times"][:], whole["times"][12:], atol=1e-15)
                for name in ("displacement", "velocity", "acceleration"):
                    expected = whole["state"][name][:]
                    self.assertLess(np.abs(rest["state"][name][:] - expected).max(), 1e-11 * np.abs(expected).max())
                u = whole["state/displacement"][:]
                self.assertLess(np.abs(rest["state/displacement"][:] - u).max(), 1e-12)
                for name in ("work", "dissipated", "start"):
                    self.assertAlmostEqual(rest["state"].attrs[name], whole["state"].attrs[name], delta=1e-11)

    def test_with_another_integrator(self):
        """Newmark goes on from the balanced acceleration, whatever stopped: AVF keeps the mean of its last step, from which
        it would come out 2 to 6 times as far off as is allowed here."""
        fine = SCENE.replace("step = 0.02", "step = 0.0005")
        self.full(*BEAM, *self.scene(integrator="newmark", text=fine, end=.2), "-output", "whole.h5", "-frames", "0")
        self.full(*BEAM, *self.scene(integrator="avf", text=fine, end=.18), "-output", "half.h5", "-frames", "0")
        self.full(*BEAM, *self.scene(integrator="newmark", text=fine, end=.2), "-restart", "half.h5", "-output",
                  "rest.h5", "-frames", "0")
        whole, rest = self.motion("whole.h5"), self.motion("rest.h5")
        self.assertEqual(rest["state"].attrs["integrator"], b"newmark")
        for name, least in (("displacement", 1e-6), ("velocity", 5e-6), ("acceleration", 2e-5)):
            expected = whole["state"][name][:]
            self.assertLess(np.abs(rest["state"][name][:] - expected).max(), least * np.abs(expected).max(), name)

    def test_statics_go_on_from_statics(self):
        pull = '[static]\nsteps = {n}\n[[load]]\nset = "xmax"\ntotal = [0, {y}, {z}]\n'
        self.full(*BEAM, *self.scene(text=pull.format(n=4, y=3, z=5)), "-output", "whole.h5", "-frames", "0")
        self.full(*BEAM, *self.scene(text=pull.format(n=1, y=3, z=5)), "-output", "end.h5", "-frames", "0")
        a, b = (self.motion(name)["state/displacement"][:] for name in ("whole.h5", "end.h5"))
        self.assertLess(np.abs(a - b).max(), 1e-9 * np.abs(a).max())
        said = self.full(*BEAM, *self.scene(text=pull.format(n=4, y=3, z=5)), "-restart", "end.h5", code=2).err
        self.assertIn("nothing is left to do", said)

    def test_what_it_cannot_go_on_from(self):
        self.full(*BEAM, *self.scene(), "-output", "half.h5")
        before = self.files()
        for words, piece in ((["-fix", "xmax"], "another"), (["-material_young", "2e6"], "another"),
                             ([], "nothing is left to do"), (["-restart", "scene.toml"], "scene.toml"),
                             (["-restart", "none.h5"], "none.h5")):
            said = self.full(*BEAM, *self.scene(), "-restart", "half.h5", *words, code=2).err
            self.assertIn(piece, said)
            self.assertEqual(self.files(), before)


class FullDisk(Full):
    def test_the_earlier_output_stays_alone(self):
        """Whichever file does not fit; on a small file system of its own, where the machine lets us mount one."""
        disk = self.folder / "disk"
        disk.mkdir()
        try_it = ["unshare", "-m", "mount", "-t", "tmpfs", "none", disk]
        if subprocess.run(try_it, capture_output=True).returncode != 0:
            self.skipTest("no file system may be mounted here")
        self.scene()
        words = [*BEAM, "-scene", self.folder / "scene.toml", "-mesh", "box:1,.15,.1/12,4,3/hex8"]
        for size, code in (("16k", 2), ("64k", 2), ("120k", 2), ("180k", 1)):  # 2: too small for the frames alone
            script = ('mount -t tmpfs -o size=$0 none . && cd "$PWD" && echo earlier > full.h5 && '
                      'mpirun -n 2 "$@" >/dev/null; code=$?; ls; cat full.h5; exit $code')
            own_disk = ["unshare", "-m", "sh", "-c", script, size]
            result = self.full(*words, ranks=0, under=own_disk, folder=disk, limit=60, code=code)
            self.assertEqual(len(sentences(result.err)), 1, result.err)
            self.assertEqual(result.out, "full.h5\nearlier\n")


class Ranks(Full):
    def test_a_file_in_a_random_order(self):
        write_shuffled_beam(self.folder / "m.msh")
        scene = ("gravity = [0, 1, -1]\n[time]\nstep = 0.02\nend = 0.2\n[[probe]]\nname = 'a'\nvertex = %d\n")
        vertex = int((self.folder / "m.msh").read_text().splitlines()[5].split()[0])
        words = ["-mesh", "m.msh", "-fix", "box:-.01,.01,-1,1,-1,1", *MATERIAL,
                 *self.scene(text=scene % vertex), "-every", "1"]
        for solver in ("direct", "iterative"):
            for ranks in (1, 2, 3):
                self.full(*words, "-solver", solver, "-output", f"{solver}{ranks}.h5", ranks=ranks)
        first = self.motion("direct1.h5")
        expected = first["snapshots"][:]
        for solver, tolerance in (("direct", 1e-10), ("iterative", 1e-8)):
            for ranks in (1, 2, 3):
                other = self.motion(f"{solver}{ranks}.h5")
                for name in ("points", "vertex_ids", "cells"):
                    np.testing.assert_array_equal(other[name][:], first[name][:])
                self.assertLess(np.abs(other["snapshots"][:] - expected).max(), tolerance * np.abs(expected).max())


if __name__ == "__main__":
    unittest.main()
