"""StVK in confined compression: P = (lambda + 2 mu)/2 s (s^2 - 1), whose limit point is at a stretch s of 1/sqrt 3."""
import math

from bench import material, statics
from .meshes import TET, write_msh
from .outcome import refused
from .row import Figure, Row, near, says

LIMIT = 25906.74  # Pa at s = 1/sqrt 3
CLOSE = 1 / 1024  # relative to it
AREA, HEIGHT = .5, 1  # of the tetrahedron whose vertex 2 alone moves, along x: its share of a pressure is AREA / 3
COLUMN = ["-mesh", "column.msh", "-fix", "box:-1,1e-9,-2,2,-2,2,box:.5,2,-2,2,-2,2:yz", "-quiet",
          *material(1e5, .3, 1000)]
BLOCK = ["-mesh", "box:.2,.1,.1/2,1,1/hex8", "-fix", "xmin:x,ymin:y,ymax:y,zmin:z,zmax:z", *material(1e5, .3, 1000)]


def press(bench, pressure):
    return bench.write("press.toml", statics("vertex = 2", f"total = [{-pressure * AREA / 3!r}, 0, 0]"))


def stands(ran, what):
    """One figure for a load that the body must bear."""
    return Figure(f"{what}: exit {ran.code}", ran.code == 0)


def column(bench, run):
    """A load below the limit, and one beyond it."""
    run(press(bench, 22085.34), 0)
    figures = [near("at 22085.34 Pa the stretch", 1 + bench.tip()[0] / HEIGHT, .75, 1e-6)]
    figures.append(stands(run(press(bench, LIMIT * (1 - CLOSE)), None), "at 1/1024 under the closed form's limit"))
    for name in bench.files() - {"column.msh", "model.h5", "model.hdf", "frequencies.csv", "press.toml"}:
        (bench.folder / name).unlink()
    before = bench.files()
    for pressure in (LIMIT * (1 + CLOSE), 30000.):
        ran = run(press(bench, pressure), None)
        figures += [refused(bench, ran, before, code=1), says("named", ran.sentence, "limit point")]
    return figures


def full(bench, length):
    write_msh(bench.folder / "column.msh", TET, [[0, 1, 2, 3]])
    return column(bench, lambda scene, code: bench.full(*COLUMN, "-scene", scene, "-frames", "0", code=code))


def reduced(bench, length):
    """By its one mode, which is the full model in another coordinate."""
    write_msh(bench.folder / "column.msh", TET, [[0, 1, 2, 3]])
    bench.reduce(*COLUMN, "-modes", "1", "-polynomial")
    words = ["model.h5", "--frames", "0", "--quiet", "--scene"]
    return column(bench, lambda scene, code: bench.move(*words, scene, code=code))


def wrinkles(bench, length):
    """Where the block is free to warp it does so before the limit point: mu s^2 + lambda (s^2 - 1)/2 = 0."""
    warping = math.sqrt(3 / 7) * (1 - 3 / 7) / (2 / 3 / math.sqrt(3)) * LIMIT

    def pull(pascal):
        return bench.write("press.toml", statics('set = "xmax"', f"traction = [{-pascal!r}, 0, 0]"))

    words = [*BLOCK, "-quiet", "-frames", "0", "-output", "under.h5", "-scene"]
    figures = [stands(bench.full(*words, pull(warping * (1 - CLOSE)), code=None),
                      "at 1/1024 under the load where warping of any wave length sets in")]
    before = bench.files()
    for pascal in (LIMIT * (1 + CLOSE), 30000.):
        ran = bench.full(*BLOCK, "-quiet", "-scene", pull(pascal), code=None)
        figures += [refused(bench, ran, before, code=1), says("named", ran.sentence, "bifurcation")]
    return figures


PUSH = """[time]
step = 1e-3
end = 0.1
integrator = "implicit-euler"
[[load]]
set = "xmax"
traction = [-60000, 0, 0]
[[probe]]
name = "end"
set = "xmax"
"""


def inside_out(bench, length):
    """A load past the limit, in time: the block is pushed through itself, which StVK cannot resist."""
    push = bench.write("push.toml", PUSH)
    bench.full(*BLOCK, "-scene", push, "-summary", "summary.json")
    figures = [turned(bench, "full")]
    bench.reduce(*BLOCK, "-modes", "100", "-polynomial", "-quiet")
    bench.move("model.h5", "--scene", push, "--summary", "summary.json")
    return [*figures, turned(bench, "reduced")]


def turned(bench, what):
    count = bench.summary("summary.json")["inverted_cells"]
    return Figure(f"{what}, stretch {1 + bench.tip()[0] / .2:.2f}: {count} cells inside out at the end", count == 2)


ROWS = [
    Row("compression_full", "confined compression past a stretch of 1/sqrt 3, the full model",
        "a stretch of .75 to 1e-6 where the closed form has it; a load of 1/1024 less than its limit is borne, and "
        "one of 1/1024 more ends in a failure that names a limit point", full),
    Row("compression_reduced", "the same by ritz-run with all modes", "the same", reduced),
    Row("compression_warping", "a confined block of nu = .3 past the load at which it may warp",
        "a load of 1/1024 less than that is borne; past the limit point a failure names a bifurcation", wrinkles),
    Row("compression_inversion", "pushed through itself in time",
        "the cells that are inside out are counted and named, by both programs", inside_out),
]
