"""Motions that stop and go on."""
import numpy as np

from .motion import INTEGRATORS, pull, reduce_beam
from .row import Row, equal

STEPS, STOP = 200, 77
BLOW, STEP = 3., .02  # N, s


def run(bench, length):
    """Beside the same motion in one go: coordinates, velocities and all that an integrator remembers, bit for bit."""
    reduce_beam(bench)
    figures = []
    for integrator in INTEGRATORS:
        for steps, words in ((STEPS, ["--output", "whole.h5"]), (STOP, ["--output", "half.h5"]),
                             (STEPS, ["--output", "rest.h5", "--restart", "half.h5"])):
            scene = bench.write("swing.toml", pull(BLOW, STEP, steps, integrator, ramp=.4))
            bench.move("model.h5", "--scene", scene, "--frames", "0", "--quiet", *words)
        differing = 0
        for name in ("z", "zdot", "state/history"):
            whole, rest = (bench.read(f"{of}.h5", name) for of in ("whole", "rest"))
            of_rest = whole if name.startswith("state") else whole[STOP:]
            differing += int(np.count_nonzero(of_rest != rest)) if of_rest.shape == rest.shape else rest.size
        figures.append(equal(f"{integrator}: numbers that differ", differing, 0))
    return figures


ROWS = [Row("restart", f"{STEPS} steps, stopped after {STOP} and gone on with, by ritz-run", "the same to the last bit", run)]
