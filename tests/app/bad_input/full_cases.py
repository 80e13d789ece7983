"""What ritz-full refuses: scenes at odds with the mesh or with what the full model can do, and its own options."""
import h5py
import numpy as np

from runner import Case, written

WORDS = ["-mesh", "box:1,1,1/2,1,1/tet4", "-material_young", "1e6", "-material_poisson", ".3", "-material_density",
         "1000", "-fix", "xmin"]
TIME = "[time]\nstep = 0.01\nend = 0.02\n"
LOAD = '[[load]]\nset = "xmax"\ntotal = [0, 0, 1]\n'


def bad(name, scene, *says, words=(), code=2, files=None):
    return Case(f"ritz-full: {name}", [*WORDS, "-scene", "scene.toml", *words], says,
                {"scene.toml": scene} | (files or {}), "ritz-full", code=code)


MOTION = written("full.h5", "ritz-full", *WORDS, "-scene", "scene.toml", files={"scene.toml": TIME + LOAD})


def restart(name, change, *says):
    """A restart from a motion with `change` done to it through HDF5."""
    def make(path):
        path.write_bytes(MOTION)
        with h5py.File(path, "r+") as file:
            change(file)
    return bad(f"a restart from {name}", TIME.replace("0.02", "0.04") + LOAD, "-restart old.h5", *says,
               words=["-restart", "old.h5"], files={"old.h5": make})


def state(name, value):
    return lambda file: file["state"].attrs.__setitem__(name, value)


def moved(file):
    vectors = file["state/displacement"][()]
    vectors[3, 2] += 1e-3
    file["state/displacement"][...] = vectors


def vectors(name, make):
    def change(file):
        array = make(file[name][()])
        del file[name]
        file[name] = array
    return change


def view_of_itself(file):
    name, shape = "state/velocity", file["state/velocity"].shape
    layout = h5py.VirtualLayout(shape, "f8")
    layout[...] = h5py.VirtualSource(".", name, shape)
    del file[name]
    file.create_virtual_dataset(name, layout)


RESTARTS = [
    restart("NaN energies", state("kinetic", np.nan), "kinetic", "finite"),
    restart("energies without end", state("work", np.inf), "work", "finite"),
    restart("a negative time", state("t", -1.0), "negative"),
    restart("an array for a time", state("t", np.arange(5000.0)), "'t'"),
    restart("two kinds", state("kind", [b"moving"] * 5000), "'kind'"),
    restart("an unknown kind", state("kind", np.bytes_("zzz")), "kind 'zzz'"),
    restart("an unknown integrator", state("integrator", np.bytes_("zzz")), "integrator 'zzz'"),
    restart("a text of any length", state("integrator", "avf"), "'integrator'"),
    restart("a checksum of many numbers", state("problem_checksum", np.array([b"x" * 16] * 4000)), "'problem_checksum'"),
    restart("a displacement that was changed", moved, "displacement", "checksum"),
    restart("NaN in the velocity", vectors("state/velocity", lambda v: v * np.nan), "velocity", "finite"),
    restart("too few displacements", vectors("state/displacement", lambda u: u[:-1]), "displacement"),
    restart("displacements in single precision", vectors("state/displacement", lambda u: u.astype("f4")), "displacement"),
    restart("no accelerations", lambda file: file["state"].__delitem__("acceleration"), "acceleration", "missing"),
    restart("a velocity that is a view of itself", view_of_itself, "velocity", "view"),
    restart("no state", lambda file: file.__delitem__("state"), "no last state"),
]


CASES = [
    Case("ritz-full: no scene", WORDS, ["-scene"], {}, "ritz-full"),
    Case("ritz-full: a scene that is not there", [*WORDS, "-scene", "scene.toml"], ["scene.toml"], {}, "ritz-full"),
    bad("a step of 0", TIME.replace("0.01", "0"), "scene.toml", "step"),
    bad("a negative step", TIME.replace("0.01", "-0.01"), "scene.toml", "step"),
    bad("1e12 steps", TIME.replace("0.01", "1e-12").replace("0.02", "1"), "steps", "GB"),
    bad("1e11 steps with frames", TIME.replace("0.01", "1e-11").replace("0.02", "1"), "steps", "GB",
        words=["-every", "1"]),
    bad("a stiffness beyond squares", TIME + LOAD, "double precision", words=["-material_young", "1e200"], code=1),
    bad("a load on a set that is not there", TIME + LOAD.replace("xmax", "xmxa"), "'xmxa'", "'xmax'"),
    bad("a probe on a set that is not there", TIME + '[[probe]]\nname = "a"\nset = "xmxa"\n', "'xmxa'", "'xmax'"),
    bad("a load on a vertex that is not there", TIME + LOAD.replace('set = "xmax"', "vertex = 99"), "99", "1 to 12"),
    bad("an integrator that it has not", TIME + 'integrator = "bdf2"\n' + LOAD, "bdf2", "avf, newmark and implicit-euler"),
    bad("damping by modes", TIME + LOAD + "[damping]\nratio = 0.01\n", "ratio", "alpha and beta"),
    bad("statics of a body that is not held", "[static]\nsteps = 2\n" + LOAD, "rigid motions", words=["-fix", "none"]),
    bad("frames in two ways", TIME + LOAD, "-frames", "-every", words=["-frames", "3", "-every", "2"]),
    bad("a frame every 0 steps", TIME + LOAD, "-every", words=["-every", "0"]),
    bad("fewer than no frames", TIME + LOAD, "-frames", words=["-frames", "-1"]),
    bad("a plan", TIME + LOAD, "-plan", "ritz-reduce", words=["-plan"]),
    bad("-secne", TIME + LOAD, "-secne", "-scene?", words=["-secne", "a"]),
    bad("an option of Newton's that is not there", TIME + LOAD, "-newton_snes_maxit", "-newton_snes_max_it?",
        words=["-newton_snes_maxit", "3"]),
    bad("a line search that is not there", TIME + LOAD, "foo", words=["-newton_snes_linesearch_type", "foo"]),
    bad("an output that ends in .xdmf", TIME + LOAD, ".xdmf", words=["-output", "a.xdmf"]),
    bad("an output in a folder that is not there", TIME + LOAD, "a/full.h5", words=["-output", "a/full.h5"]),
    bad("an output over its scene", TIME + LOAD, "-output scene.toml", "overwrite", words=["-output", "scene.toml"]),
    bad("a timing over its scene", TIME + LOAD, "-timing scene.toml", "overwrite", words=["-timing", "scene.toml"]),
    bad("a timing over its energies", TIME + LOAD, "-timing energy.csv", "writes", words=["-timing", "energy.csv"]),
    bad("a timing over its motion", TIME + LOAD, "-timing ./full.h5", "writes", words=["-timing", "./full.h5"]),
    bad("a timing over its description", TIME + LOAD, "-timing full.xdmf", "writes", words=["-timing", "full.xdmf"]),
    bad("a timing over another output's energies", TIME + LOAD, "-timing a.energy.csv", "writes",
        words=["-timing", "a.energy.csv", "-output", "a.h5"]),
    bad("a restart over whose file the timing goes", TIME + LOAD, "-timing a.h5", "-restart a.h5",
        words=["-timing", "a.h5", "-restart", "a.h5"], files={"a.h5": "1"}),
    bad("a table over its scene", TIME + LOAD, "energy.csv", "overwrite", words=["-scene", "energy.csv"],
        files={"energy.csv": TIME + LOAD}),
    bad("an output to a device", TIME + LOAD, "a device", words=["-output", "/dev/null"]),
    bad("a timing to a link", TIME + LOAD, "-timing a", "a symbolic link", words=["-timing", "a"],
        files={"a": lambda path: path.symlink_to("b")}),
    bad("a table where a folder stands", TIME + LOAD, "energy.csv", "is a folder", files={"energy.csv/kept": "1"}),
    bad("a timing in a folder that is not there", TIME + LOAD, "-timing a/b.csv", words=["-timing", "a/b.csv"]),
    bad("a restart from nothing", TIME + LOAD, "-restart none.h5", words=["-restart", "none.h5"]),
    bad("a restart from a scene", TIME + LOAD, "-restart scene.toml", words=["-restart", "scene.toml"]),
    bad("a load beyond a limit point", "[static]\nsteps = 2\n" + LOAD.replace("[0, 0, 1]", "[-1e9, 0, 0]"),
        "load fraction", "residual", code=1),
]

CASES += RESTARTS
