"""What the moving rows share: a beam reduced for large bending, scenes, and what ritz-run says of a motion."""
from dataclasses import dataclass

import numpy as np

from bench import SOFT
from programs import Failed

BEAM = ["-mesh", "box:1,.1,.06/8,2,1/tet10", "-fix", "xmin", *SOFT]
NEWTON = 1e-10  # the relative residual at which a step ends
GAINED = 10 * NEWTON  # of the energy, by a method that only loses any: what that leaves open
INTEGRATORS = ("avf", "implicit-euler", "bdf2", "newmark", "generalized-alpha", "linearly-implicit")


def reduce_beam(bench, columns=10):
    """Writes model.h5; its highest angular frequency, rad/s."""
    bench.reduce(*BEAM, "-modes", 6, "-derivatives", 6, "-basis", columns, "-polynomial", "-quiet")
    return np.sqrt(bench.body("model.h5", "reduction/stiffness").max())


def pull(force, step, steps, integrator, ramp=None):
    """The beam's end is pulled downwards over `ramp` s, let go over another, and swings without damping."""
    ramp = ramp or 2 * step
    return (f'[time]\nstep = {step!r}\nend = {step * steps!r}\nintegrator = "{integrator}"\n'
            f'[[load]]\nset = "xmax"\ntotal = [0, {force / 3!r}, {-force!r}]\n'
            f'table = [[0, 0], [{ramp!r}, 1], [{2 * ramp!r}, 0]]\n'
            '[[probe]]\nname = "tip"\nset = "xmax"\n')


@dataclass(frozen=True)
class Said:
    """What ritz-run says of a motion."""
    rejected: int
    gained: float  # relative to what there was at the beginning and what the load brought
    lost: float

    @property
    def drift(self):
        return max(self.gained, self.lost)


def move(bench, scene, **how):
    """Runs model.h5 without frames; what it says of the motion is in motion.json."""
    return bench.move("model.h5", "--scene", scene, "--frames", "0", "--summary", "motion.json", **how)


def said(bench):
    """Of the motion that was moved last."""
    summary = bench.summary("motion.json")
    energy = summary["energy"]
    if not energy or not energy["available"] > 0:
        raise Failed(f"ritz-run says nothing of the energy: {energy}")
    return Said(summary["rejected_steps"], energy["gained"] / energy["available"], energy["lost"] / energy["available"])
