"""A beam that 3 N bend by a quarter of its length, under 1e3 ... 1e9 times that."""
from .motion import BEAM, reduce_beam
from .outcome import finite_or_failed
from .row import Length, Row, plain

STATIC = '[static]\nsteps = 4\n[[load]]\nset = "xmax"\ntotal = [0, 1, {force!r}]\n'
MOVING = ('[time]\nstep = 0.02\nend = 0.2\nintegrator = "{integrator}"\n'
          '[[load]]\nset = "xmax"\ntotal = [0, 1, {force!r}]\n')


def factors(length):
    return [10 ** k for k in range(3, 10)] if length is Length.full else [1e3, 1e6, 1e9]


def reduced(integrator):
    def run(bench, length):
        reduce_beam(bench)
        figures = []
        for factor in factors(length):
            text = STATIC if integrator == "static" else MOVING
            scene = bench.write("huge.toml", text.format(force=-3. * factor, integrator=integrator))
            words = ["model.h5", "--scene", scene, "--quiet"]
            figures.append(finite_or_failed(bench, f"x {factor:.0e}", "ritz-run", words, "motion.h5", "displacement"))
        return figures
    return run


def full(integrator):
    def run(bench, length):
        figures = []
        for factor in factors(length) if length is Length.full else [1e9]:
            text = STATIC if integrator == "static" else MOVING
            scene = bench.write("huge.toml", text.format(force=-3. * factor, integrator=integrator))
            words = [*BEAM, "-scene", scene, "-quiet"]
            figures.append(finite_or_failed(bench, f"x {factor:.0e}", "ritz-full", words, "full.h5", "snapshots"))
        return figures
    return run


def linear(bench, length):
    bench.reduce(*BEAM, "-modes", 6, "-quiet")
    figures = []
    for force in (-3e9, -1e150, -1e308):
        scene = bench.write("huge.toml", MOVING.format(force=force, integrator="exact"))
        words = ["model.h5", "--scene", scene, "--double-frames", "--quiet"]
        figures.append(finite_or_failed(bench, f"{-force:.0e} N", "ritz-run", words, "motion.h5", "displacement"))
    return figures


ASKED = "converged, or a failure in one sentence; never a frame with NaN"
NAMES = ("static", "avf", "implicit-euler", "newmark", "linearly-implicit")
ROWS = [Row(plain(f"huge_{name}"), f"loads x 1e3 ... 1e9, reduced, {name}", ASKED, reduced(name)) for name in NAMES]
ROWS += [Row(plain(f"huge_full_{name}"), f"loads x 1e3 ... 1e9, the full model, {name}", ASKED, full(name), seconds=50)
         for name in ("static", "avf")]
ROWS.append(Row("huge_linear", "loads of 3e9, 1e150, 1e308 N, six modes, exact", ASKED, linear))
