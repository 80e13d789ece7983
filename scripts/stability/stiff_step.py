"""A beam bent far and let go, with steps a thousand times longer than its fastest mode takes."""
import itertools

import numpy as np

from bench import SOFT
from .motion import GAINED, move, pull, reduce_beam, said
from .row import Figure, Length, Row, at_most, finite, plain, reported

SMALL = ["-mesh", "box:1,.1,.06/4,1,1/tet10", "-fix", "xmin", *SOFT, "-quiet"]


def reduced(integrator):
    def run(bench, length):
        step = 1e3 / reduce_beam(bench)
        steps = 5000 if length is Length.full else 500
        scene = bench.write("swing.toml", pull(3., float(step), steps, integrator))
        move(bench, scene)
        seen = said(bench)
        z = bench.read("motion.h5", "z")
        tip = np.abs(bench.table("probes.csv")[1][:, 1:]).max()
        figures = [finite(f"{steps} steps of {step:.2g} s, the tip moves by up to {tip:.2g} m", z),
                   reported(f"{seen.rejected} steps rejected")]
        if integrator == "avf":
            return [*figures, at_most("energy drifts, relative, by", seen.drift, 1e-8)]
        return [*figures, at_most("energy gained, relative,", seen.gained, GAINED),
                reported(f"{seen.lost:.3g} of the energy and work lost")]
    return run


def full(integrator):
    def run(bench, length):
        bench.reduce(*SMALL, "-modes", "1000")
        step = float(1e3 / np.sqrt(bench.body("model.h5", "modes/eigenvalues").max()))
        steps = 400 if length is Length.full else 40
        scene = bench.write("swing.toml", pull(3., step, steps, integrator))
        bench.full(*SMALL, "-scene", scene, "-summary", "full.json")
        summary = bench.summary("full.json")
        energy, brought = summary["energy"], bench.table("energy.csv")[1][:, 3].max()
        figures = [finite(f"{steps} steps of {step:.2g} s", bench.read("full.h5", "snapshots")),
                   reported(f"{summary['newton_iterations']} Newton iterations, {summary['rejected_steps']} steps rejected")]
        if integrator == "avf":
            return [*figures, at_most("energy drifts, relative, by", energy["largest_drift"] / brought, 1e-8)]
        return [*figures, at_most("energy gained, relative,", energy["gained"] / brought, GAINED),
                reported(f"{energy['lost'] / brought:.3g} of the energy and work lost")]
    return run


WRONG = .2  # of the largest displacement: a motion that nobody should believe
PERIOD = 3.2  # s, of the beam's first mode
DAMPINGS = {"undamped": "", "damped a little": "[damping]\nalpha = 1.0\nbeta = 1e-2\n",
            "damped much": "[damping]\nbeta = 1.0\n"}


def long_steps(bench, length):
    """Against avf at a sixteenth of the step."""
    reduce_beam(bench)
    figures = []
    for force, (name, damping), steps in itertools.product(
            (30., 3e3, 3e6), DAMPINGS.items(), (4, 10, 20, 50) if length is Length.full else (4, 50)):
        tips = []
        for integrator, parts in (("avf", 16), ("linearly-implicit", 1)):
            step = PERIOD / steps / parts
            scene = pull(force, step, 3 * steps * parts, integrator, ramp=PERIOD / 2) + damping
            ran = move(bench, bench.write("swing.toml", scene))
            tips.append(bench.table("probes.csv")[1][::parts, 1:])
        fine, coarse = tips
        off = np.linalg.norm(coarse - fine, axis=1).max() / np.linalg.norm(fine, axis=1).max()
        warned = "warned of" if ran.warnings else "no warning"
        figures.append(Figure(f"{force:g} N, {name}, {steps} steps a period: {off:.1%} off, {warned}",
                              bool(ran.warnings or off < WRONG)))
    return figures


ASKED = {"avf": "finite; the energy stays to 1e-8; rejected steps counted"}
ROWS = [Row(plain(f"stiff_step_{name}"), f"dt omega_max = 1e3, {name}, reduced to 10 coordinates",
            ASKED.get(name, "finite; no energy gained; rejected steps counted"), reduced(name))
        for name in ("avf", "implicit-euler", "bdf2")]
ROWS += [Row(plain(f"stiff_step_full_{name}"), f"dt omega_max = 1e3, {name}, the full model",
             ASKED.get(name, "finite; no energy gained; rejected steps counted"), full(name), seconds=30)
         for name in ("avf", "implicit-euler")]
ROWS.append(Row("long_steps_linearly_implicit", "a beam under 10 to 1e6 times 3 N, 4 ... 50 steps a period, linearly-implicit",
                f"no motion {WRONG:.0%} off without a warning", long_steps))
