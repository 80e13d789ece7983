"""An undamped beam that is struck at its end, over very many steps."""
from .motion import GAINED, INTEGRATORS, move, pull, reduce_beam, said
from .row import Figure, Length, Row, at_most, equal, finite, plain, reported, says

FAST = 60  # dt omega_max: the step of a motion that is watched; its fast modes, which the blow moves, are not resolved
DISSIPATIVE = ("implicit-euler", "bdf2")
BLOW = 30.  # N, up and down again over two steps


def swing(bench, integrator, steps, fast=FAST):
    step = float(fast / reduce_beam(bench))
    scene = bench.write("swing.toml", pull(BLOW, step, steps, integrator, ramp=step))
    return move(bench, scene, code=None)


def avf(bench, length):
    steps = 1_000_000 if length is Length.full else 10_000
    ran = swing(bench, "avf", steps)
    seen = said(bench)
    z = bench.read("motion.h5", "z")
    return [equal("steps", len(z) - 1, steps), finite("coordinates", z),
            at_most("energy drifts, relative, by", seen.drift, 1e-6), reported(ran.out.splitlines()[0])]


def drift(integrator, fast=FAST):
    """Printed as it is; the run ends well or is refused, and does not pass for right when it gains energy. That is
    held against what the blow brought: some steps after it, bdf2 still takes up what its history holds of the load."""
    def run(bench, length):
        steps = 1_000_000 if length is Length.full else 10_000
        ran = swing(bench, integrator, steps, fast)
        if ran.code != 0:
            return [Figure(f"exit {ran.code}, '{ran.sentence}'", ran.code == 1 and bool(ran.sentence))]
        seen = said(bench)
        figures = [reported(f"{steps} steps with dt omega_max = {fast}: of the energy that the blow brought "
                            f"{seen.gained:.2g} gained and {seen.lost:.2g} lost; {seen.rejected} steps rejected")]
        if integrator in DISSIPATIVE:
            figures.append(at_most("energy gained, relative,", seen.gained, GAINED))
        elif seen.gained > .1:
            figures.append(equal("warnings", len(ran.warnings), 1))
        return figures
    return run


def warning(bench, length):
    """Newmark gains energy on nonlinear models, though it is unconditionally stable on linear ones."""
    newmark = swing(bench, "newmark", 1000)
    grown = 1 + said(bench).gained
    calm = swing(bench, "avf", 1000)
    return [reported(f"newmark: the energy grows to {grown:.1e} times what the blow brought"),
            equal("newmark: warnings", len(newmark.warnings), 1),
            says("its warning", " ".join(newmark.warnings), '"avf"', '"implicit-euler"'),
            equal("avf: warnings", len(calm.warnings), 0)]


ASKED = "the drift is printed; no energy from nowhere without a warning"
LOSES = "the drift is printed; no energy gained, to ten times Newton's tolerance"
ROWS = [
    Row("newmark_warning", "undamped Newmark, dt omega_max = 60",
        "ritz-run warns once and names integrators that hold the energy; none for avf", warning),
    Row("million_avf", "1e6 undamped steps, avf", "the energy stays to 1e-6", avf, seconds=22),
    *(Row(plain(f"million_{name}"), f"1e6 undamped steps, {name}", LOSES if name in DISSIPATIVE else ASKED, drift(name),
           seconds=15)
      for name in INTEGRATORS if name != "avf"),
    Row("million_central_difference", "1e6 undamped steps, central-difference, dt omega_max = 0.5", ASKED,
        drift("central-difference", .5), seconds=7),
]
