"""StVK in confined compression: P = (lambda + 2 mu)/2 s (s^2 - 1), whose limit point is at a stretch s of 1/sqrt 3."""
import math
import re

from bench import material, statics
from .meshes import TET, write_msh
from .outcome import refused
from .row import Figure, Row, near, says

LIMIT = 25906.74  # Pa at s = 1/sqrt 3
AREA, HEIGHT = .5, 1  # of the tetrahedron whose vertex 2 alone moves, along x: its share of a pressure is AREA / 3
COLUMN = ["-mesh", "column.msh", "-fix", "box:-1,1e-9,-2,2,-2,2,box:.5,2,-2,2,-2,2:yz", "-quiet",
          *material(1e5, .3, 1000)]
BLOCK = ["-mesh", "box:.2,.1,.1/2,1,1/hex8", "-fix", "xmin:x,ymin:y,ymax:y,zmin:z,zmax:z", *material(1e5, .3, 1000)]


def press(bench, pressure):
    return bench.write("press.toml", statics("vertex = 2", f"total = [{-pressure * AREA / 3!r}, 0, 0]"))


def reached(ran):
    found = re.search(r"load fraction (\S+)", ran.sentence)
    return float(found.group(1).rstrip(",")) if found else float("nan")


def column(bench, run):
    """A load below the limit, and one beyond it."""
    run(press(bench, 22085.34), 0)
    figures = [near("at 22085.34 Pa the stretch", 1 + bench.tip()[0] / HEIGHT, .75, 1e-6)]
    for name in bench.files() - {"column.msh", "model.h5", "model.hdf", "frequencies.csv", "press.toml"}:
        (bench.folder / name).unlink()
    before = bench.files()
    ran = run(press(bench, 30000.), None)
    return [*figures, refused(bench, ran, before, code=1), says("named", ran.sentence, "limit point"),
            Figure(f"at load fraction {reached(ran)}, the closed form's is {LIMIT / 30000:.6f}",
                   0 <= LIMIT / 30000 - reached(ran) <= 1 / 1024 + 5e-4)]


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
    scene = bench.write("press.toml", statics('set = "xmax"', "traction = [-30000, 0, 0]"))
    before = bench.files()
    ran = bench.full(*BLOCK, "-scene", scene, "-quiet", code=None)
    expected = math.sqrt(3 / 7) * (1 - 3 / 7) / (2 / 3 / math.sqrt(3)) * LIMIT / 30000
    return [refused(bench, ran, before, code=1),
            Figure(f"at load fraction {reached(ran)}; warping of any wave length sets in at {expected:.4f}, the limit "
                   f"point is at {LIMIT / 30000:.4f}", expected - 5e-4 <= reached(ran) <= LIMIT / 30000),
            says("named", ran.sentence, "bifurcation")]


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
    ran = bench.full(*BLOCK, "-scene", push)
    stretch = 1 + bench.tip()[0] / .2
    figures = [says(f"full, stretch {stretch:.2f}", last_lines(ran.out), "2 cells are inside out at the end")]
    bench.reduce(*BLOCK, "-modes", "100", "-polynomial", "-quiet")
    ran = bench.move("model.h5", "--scene", push)
    stretch = 1 + bench.tip()[0] / .2
    return [*figures, says(f"reduced, stretch {stretch:.2f}", last_lines(ran.out), "2 cells are inside out at the end")]


def last_lines(text):
    return " ".join(line for line in text.splitlines() if "inside out" in line)


ROWS = [
    Row("compression_full", "confined compression past a stretch of 1/sqrt 3, the full model",
        "a stretch of .75 to 1e-6 where the closed form has it; past the limit a failure that names a limit point, at "
        "its load fraction to 1/1024", full),
    Row("compression_reduced", "the same by ritz-run with all modes", "the same", reduced),
    Row("compression_warping", "a confined block of nu = .3 past the load at which it may warp",
        "a failure that names a bifurcation, between the load where warping may set in and the limit point", wrinkles),
    Row("compression_inversion", "pushed through itself in time",
        "the cells that are inside out are counted and named, by both programs", inside_out),
]
