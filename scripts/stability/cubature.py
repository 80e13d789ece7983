"""Cubatures of a beam of each law, pushed far beyond what they were trained on: an answer, or a named failure."""
import h5py
import numpy as np

from bench import material
from .meshes import end_faces, hexahedra, write_msh
from .outcome import finite_or_failed
from .row import Figure, Row, at_most, plain, says

LAWS = {"neo-hookean": (), "neo-hookean-isochoric": (), "hencky": (), "corotational": (),
        "mooney-rivlin": ("1.5e5,4e4,1e-6",), "yeoh": ("1.9e5,-1e4,2e3,1e-6",), "arruda-boyce": ("3.8e5,3,1e-6",),
        "ogden": ("3.8e5,2.5,1e-6",)}
COLUMNS = 10
WORDS = ["-modes", "4", "-derivatives", "4", "-basis", str(COLUMNS), "-quiet"]
BEAM = ["-mesh", "box:1,.25,.25/8,2,2/tet4", "-fix", "xmin"]
PULL = '[[load]]\nset = "xmax"\ntotal = [0, {0!r}, {1!r}]\n[[probe]]\nname = "tip"\nset = "xmax"\n'
STATICS, MOTION = "[static]\nsteps = 2\n", "[time]\nstep = 0.01\nend = 0.1\n"
BENDING = 1500.  # N, by about a fifth of the length


def of_law(law):
    constants = ["-material_constants", *LAWS[law], "-material_density", "1000"] if LAWS[law] else material()
    return ["-material_law", law, *constants]


def reduce(bench, *words):
    """Writes model.h5; its table of errors: cells, and six figures a row."""
    bench.reduce(*words, *WORDS)
    with h5py.File(bench.folder / "model.h5") as file:
        errors = file["bodies/body/cubature/errors"]
        return errors["cells"][:], errors["figures"][:]


def pull(force):
    return PULL.format(force / 3, -force)


def run(bench, what, text, codes=(1,)):
    words = ["model.h5", "--scene", bench.write("scene.toml", text), "--quiet"]
    return finite_or_failed(bench, what, "ritz-run", words, "motion.h5", "displacement", codes)


def pushed(law):
    def of(bench, length):
        reduce(bench, *BEAM, *of_law(law), "-cubature", "20")
        start = f"[initial]\nz = {[40., 30., -20.] + [1.] * (COLUMNS - 3)!r}\n"
        return [run(bench, "x 1e3, statics", STATICS + pull(1e3 * BENDING)),
                run(bench, "x 1e3, motion", MOTION + pull(1e3 * BENDING)),
                run(bench, "far out at the start", MOTION + start, codes=(1, 2))]
    return of


def apart(bench, words, text):
    """How far the reduced tip is from the full one, relative to its way."""
    scene = bench.write("scene.toml", text)
    bench.full(*words, "-scene", scene, "-frames", "0", "-quiet")
    full = bench.tip()
    bench.move("model.h5", "--scene", scene, "--frames", "0", "--quiet")
    return np.linalg.norm(bench.tip() - full) / np.linalg.norm(full)


def incompressible(bench, length):
    words = ["-mesh", "box:1,.25,.25/4,1,1/tet10", "-fix", "xmin", "-material_law", "neo-hookean",
             *material(poisson=.4999)]
    reduce(bench, *words, "-cubature_tolerance", "1e-2", "-cubature_amplitude", ".1")
    return [at_most("3 N: the tips are apart, relative, by", apart(bench, words, STATICS + pull(3.)), .1)]


def contrast(bench, length):
    """Two halves of two laws."""
    points, hexes = hexahedra((8, 2, 2), (1, .25, .25))
    regions = np.where(points[hexes, 0].mean(axis=1) < .5, "hard", "soft")
    write_msh(bench.folder / "bar.msh", points, hexes, list(regions), {"xmax": end_faces(points, hexes, 1)})
    words = ["-mesh", "bar.msh", "-fix", "box:-1e-9,1e-9,-1,1,-1,1", "-material_density", "1000",
             "-material_hard_law", "hencky", "-material_hard_young", "1e10", "-material_hard_poisson", ".3",
             "-material_soft_law", "neo-hookean", "-material_soft_young", "1e6", "-material_soft_poisson", ".3"]
    reduce(bench, *words, "-cubature_tolerance", "1e-2")
    return [at_most("the tips are apart, relative, by", apart(bench, words, STATICS + pull(3 * BENDING)), .1)]


def too_few(bench, length):
    """The error at held-out statics, of T = r and of T = 8 r."""
    cells, errors = reduce(bench, *BEAM, *of_law("neo-hookean"), "-cubature", str(8 * COLUMNS))
    place = np.argmin(abs(cells - COLUMNS))
    few, many = errors[place, 4], errors[-1, 4]  # root mean square over statics
    return [Figure(f"{cells[place]} cells: {few:.2%}, {cells[-1]} cells: {many:.2%}", bool(few > .02 and many < few / 2))]


def beyond(bench, length):
    """Twice as far as the poses of the training."""
    reduce(bench, *BEAM, *of_law("neo-hookean"), "-cubature", "40", "-cubature_amplitude", ".1")
    near_, far = (bench.move("model.h5", "--scene", bench.write("scene.toml", STATICS + pull(force)), "--quiet")
                  for force in (BENDING / 10, 2 * BENDING))
    return [Figure(f"within: {len(near_.warnings)} warnings", not near_.warnings),
            says("beyond", " ".join(far.warnings), "trained on", "-cubature_amplitude")]


ASKED = "converged, or a failure in one sentence; never a frame with NaN"
ROWS = [Row(f"cubature_{plain(law)}", f"{law}, 20 cells: loads x 1e3, a start far out", ASKED, pushed(law), seconds=2)
        for law in LAWS]
ROWS += [
    Row("cubature_nu_4999", "neo-hookean, nu = .4999, Tet10, bent", "the full model's tip to 10 %", incompressible),
    Row("cubature_contrast", "halves of hencky and neo-hookean, E ratio 1e4, bent",
        "the full model's tip to 10 %", contrast),
    Row("cubature_few_cells", "T = r cells", "an error above 2 % in the model's table, which falls with more cells",
        too_few),
    Row("cubature_beyond", "twice the amplitude of the training", "a warning, and none within it", beyond),
]
