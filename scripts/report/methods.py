"""The table of methods, and the runs that a scene asks of them. A new method joins by a row of METHODS."""
import dataclasses
import hashlib
from dataclasses import dataclass

from report.scenes import Limits

LINEAR_INTEGRATORS = ("exact", "avf", "newmark", "generalized-alpha", "bdf2", "implicit-euler", "central-difference")
NONLINEAR_INTEGRATORS = (*LINEAR_INTEGRATORS[1:], "linearly-implicit")
FULL_INTEGRATORS = ("avf", "newmark", "implicit-euler")


@dataclass(frozen=True)
class Knobs:
    """How large the reduced model is."""
    k: int = 0  # modes
    r: int = 0  # columns of the basis; 0: all
    T: int = 0  # cells of the cubature; 0: there is none

    def __str__(self):
        return ", ".join(f"{name} {value}" for name, value in (("k", self.k), ("r", self.r), ("T", self.T)) if value)


@dataclass(frozen=True)
class Method:
    name: str
    title: str
    program: str  # reduced or full
    options: tuple = ()  # of ritz-reduce; {k}, {r} and {T} are filled in
    basis: tuple = ()  # Knobs that are swept at the scene's middle step
    step_basis: Knobs = Knobs()  # the size at which steps and integrators are swept
    integrators: tuple = ()  # the first is the basis sweep's
    single: tuple = ()  # of these integrators also in single precision
    learns: bool = False  # from a motion of the full model under the scene's training loads
    laws: tuple = ("polynomial", "other")  # of scenes that it is for


CUBATURE = ("-modes", "{k}", "-derivatives", "{k}", "-basis", "{r}", "-cubature", "{T}")
CUBATURES = tuple(Knobs(8, 20, 20 * n) for n in (1, 2, 4, 8))

METHODS = (
    Method("linear", "linear modes", "reduced", ("-modes", "{k}"),
           tuple(Knobs(k) for k in (2, 4, 8, 16, 32)), Knobs(8), LINEAR_INTEGRATORS),
    Method("linear_polynomial", "linear modes, nonlinear forces", "reduced", ("-modes", "{k}", "-polynomial"),
           tuple(Knobs(k) for k in (2, 4, 8, 16, 32)), Knobs(8), ("avf",), laws=("polynomial",)),
    Method("derivatives", "modes + derivatives", "reduced",
           ("-modes", "{k}", "-derivatives", "{k}", "-basis", "{r}", "-polynomial"),
           tuple(Knobs(*kr) for kr in ((2, 5), (4, 8), (4, 14), (8, 12), (8, 20), (8, 30), (8, 44), (16, 60))),
           Knobs(8, 20), NONLINEAR_INTEGRATORS, ("avf", "newmark", "implicit-euler"), laws=("polynomial",)),
    Method("pod", "POD of the full run", "reduced", ("-modes", "0", "-basis", "{r}", "-polynomial"),
           tuple(Knobs(0, r) for r in (5, 10, 20, 40)), Knobs(0, 20), ("avf",), learns=True,
           laws=("polynomial",)),
    Method("cubature", "cubature", "reduced", CUBATURE, CUBATURES, Knobs(8, 20, 80), ("avf", "newmark", "implicit-euler"),
           laws=("other",)),
    Method("cubature_plain", "cubature without variate", "reduced", (*CUBATURE, "-cubature_plain"), CUBATURES,
           Knobs(8, 20, 80), ("avf",), laws=("other",)),
    Method("full", "the full model", "full", (), (Knobs(),), integrators=FULL_INTEGRATORS),
)
BY_NAME = {method.name: method for method in METHODS}


@dataclass(frozen=True)
class Run:
    """A row of runs.csv before it is run."""
    scene: str
    method: str
    knobs: Knobs
    integrator: str
    precision: str  # double or single
    step: float
    sweep: str  # basis or step: the picture's line that the point lies on


def other_of(scene):
    return scene.other and (scene.other.mesh, scene.other.loads)


def key_of(run, scene, program):
    """The same run by the same build has the same key. What only words or chooses is no part of it."""
    bare = dataclasses.replace(scene, title="", limits=Limits(), step_sizes=(), step_cost=0.0,
                               other=other_of(scene))
    method = BY_NAME[run.method]
    return hashlib.sha256(repr((run, bare, method.options, method.learns, program)).encode()).hexdigest()[:16]


def basis_sweep(scene, method):
    integrator = "" if scene.analysis == "static" else method.integrators[0]
    return [Run(scene.name, method.name, knobs, integrator, "double", scene.middle, "basis") for knobs in method.basis]


def step_sweep(scene, method):
    if scene.analysis == "static":
        return []
    sizes = {name: Knobs(*size) for name, size in scene.step_sizes}
    knobs, runs = sizes.get(method.name, method.step_basis), []
    for precision, integrators in (("double", method.integrators), ("single", method.single)):
        for integrator in integrators:
            steps = scene.steps if method.program == "reduced" else scene.steps[:-1]
            runs += [Run(scene.name, method.name, knobs, integrator, precision, step, "step")
                     for step in steps]
    return runs


@dataclass(frozen=True)
class Form:
    """How much of the plan is run, and how often."""
    name: str
    repetitions: int
    limits: Limits = Limits()


FORMS = {
    "full": Form("full", 10),
    "quick": Form("quick", 3, Limits(sizes=((4, 0), (8, 0), (4, 8), (4, 14), (8, 20), (0, 10)),
                                     integrators=("exact", "avf", "newmark", "linearly-implicit", "implicit-euler"))),
}


def plan(scene, form):
    """The runs of a scene that it and the form want, each once."""
    runs = {}
    for method in (method for method in METHODS if scene.laws in method.laws):
        for run in basis_sweep(scene, method) + step_sweep(scene, method):
            if scene.limits.admits(run) and form.limits.admits(run):
                runs.setdefault(dataclasses.replace(run, sweep=""), run)
    return list(runs.values())
