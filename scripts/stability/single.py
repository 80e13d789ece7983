"""The runtime in single precision beside double."""
import numpy as np

from .motion import pull, reduce_beam
from .row import Row, at_most, plain

STEPS = 10_000


def trajectories(bench, integrator, force, step, damping):
    tips = []
    scene = bench.write("swing.toml", pull(force, step, STEPS, integrator, ramp=1.) + damping)
    for words in ([], ["--single"]):
        bench.move("model.h5", "--scene", scene, "--frames", "0", "--quiet", *words)
        tips.append(bench.table("probes.csv")[1][:, 1:])
    return tips


def compare(integrator, damping, force):
    def run(bench, length):
        reduce_beam(bench)
        double, single = trajectories(bench, integrator, force, 5e-3, damping)
        size = np.linalg.norm(double, axis=1).max()
        apart = np.linalg.norm(single - double, axis=1)
        return [at_most(f"{STEPS} steps of 5 ms, the tip moves by up to {size:.2g} m; at most apart, relative,",
                        apart.max() / size, 1e-4)]
    return run


def undamped(bench, length):
    """Rounding shifts the phase of a motion that nothing damps, more with every step: as its square at most. The
    coefficients alone, rounded to 24 bits and used in double, bring 9e-5 (other last bits of theirs 4e-5 to 4e-4: the
    stiff coordinates' share cancels in bending), forces in single 4e-5, the state 1e-5, so that to compensate the
    state's sums does not help."""
    reduce_beam(bench)
    double, single = trajectories(bench, "avf", 1., 5e-3, "")
    apart = np.linalg.norm(single - double, axis=1) / np.linalg.norm(double, axis=1).max()
    early, late = apart[:STEPS // 10].max(), apart.max()
    return [at_most(f"{STEPS} steps of 5 ms; at most apart, relative,", late, 1e-3),
            at_most("times as far as after a tenth of them", late / early, 100)]


DAMPED = "[damping]\nalpha = 0.2\n"
ROWS = [Row(plain(f"single_{name}"), f"1e4 steps in single precision, {name}", "the tip's path within 1e-4 of double's",
            compare(name, DAMPED, 1.))
        for name in ("avf", "implicit-euler", "newmark")]
ROWS.append(Row("single_undamped", "the same without damping, avf",
                "the tip's path within 1e-3 of double's; no runaway", undamped))
