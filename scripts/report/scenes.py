"""The table of scenes. A scene is a body, what is done to it, and how finely the reference is computed."""
import math
from dataclasses import dataclass, replace

from report import meshes

STEEL = ("-material_young", "2.06e11", "-material_poisson", "0.29", "-material_density", "7850")
RUBBER = ("-material_young", "1e6", "-material_poisson", "0.45", "-material_density", "1100")
GRAINS = ("-material_soft_young", "1e5", "-material_hard_young", "1e8", "-material_poisson", "0.3",
          "-material_density", "1000")  # a stiffness ratio of 1e3


@dataclass(frozen=True)
class Limits:
    """Which runs are wanted; what is empty wants all."""
    methods: tuple = ()  # names of methods.METHODS
    sweeps: tuple = ()  # basis, step
    sizes: tuple = ()  # (k, r) of the basis sweep
    integrators: tuple = ()  # of the step sweep

    def admits(self, run):
        wants = lambda limit, value: not limit or value in limit  # noqa: E731
        if not (wants(self.methods, run.method) and wants(self.sweeps, run.sweep)):
            return False
        if run.sweep == "step":
            return wants(self.integrators, run.integrator)
        size = (run.knobs.k, run.knobs.r)
        return size == (0, 0) or wants(self.sizes, size)


@dataclass(frozen=True)
class Load:
    target: str  # a line of TOML: a set or a vertex
    total: tuple  # N
    table: tuple  # of (s, factor)

    def toml(self, factor):
        rows = ", ".join(f"[{t!r}, {f!r}]" for t, f in self.table)
        return f"[[load]]\n{self.target}\ntotal = {[factor * x for x in self.total]}\ntable = [{rows}]\n"


@dataclass(frozen=True)
class Scene:
    name: str
    title: str
    mesh: object  # the words of -mesh, or a value of meshes.py
    options: tuple  # of the programs: materials, units
    fixed: str  # the set whose vertices are held
    loads: tuple
    training: tuple  # loads of the motion that POD learns from
    probe: str  # a line of TOML
    frame: float  # s between the frames that are compared; every step divides it
    end: float  # s; of statics 1, the load fraction
    steps: tuple  # s, coarse to fine; the finest is the reference's
    analysis: str = "time"
    released: float = 0.0  # s, from when on the body moves freely, where its tone is taken; infinity: never
    damping: float = 0.0  # alpha, 1/s
    load_factor: float = 1.0  # of all loads
    other: object = None  # the same scene on another mesh, for the error of the mesh
    other_is: str = "a finer"
    ranks: int = 1  # of ritz-reduce and ritz-full
    limits: Limits = Limits()
    step_sizes: tuple = ()  # pairs of a method's name and the (k, r) of its step sweep, in place of the method's own
    step_cost: float = 0.05  # s a step of ritz-full takes, about: for the estimate of the time left alone

    def toml(self, step, integrator, loads):
        head = f"[time]\nstep = {step!r}\nend = {self.end!r}\n"
        if self.analysis == "static":
            head = f"[static]\nsteps = {round(1 / step)}\n"
        if integrator:
            head += f'integrator = "{integrator}"\n'
        if self.damping:
            head += f"[damping]\nalpha = {self.damping!r}\n"
        acting = "".join(load.toml(self.load_factor) for load in loads)
        return f'{head}{acting}[[probe]]\nname = "probe"\n{self.probe}\n'

    @property
    def laws(self):
        """Whether the forces of the materials are polynomials."""
        return "other" if "-material_law" in self.options else "polynomial"

    @property
    def middle(self):
        """The step of the basis sweep."""
        return self.steps[(len(self.steps) - 1) // 2]

    def count(self, step):
        return round(self.end / step)


def halved(step, times):
    return tuple(step / 2**n for n in range(times + 1))


def held(target, total, rise, until, gone):
    """A load that grows, holds, and is let go."""
    return Load(target, total, ((0.0, 0.0), (rise, 1.0), (until, 1.0), (gone, 0.0)))


def pull(*total):
    return (held('set = "xmax"', total, 0.2, 0.3, 0.31),)


def on_another_mesh(scene, mesh, **changes):
    return replace(scene, other=replace(scene, mesh=mesh, **changes))


def cantilever(cells, finer, **changes):
    scene = Scene(
        "cantilever", "A rubber cantilever, 300 x 40 x 30 mm, pulled askew and released",
        f"box:0.3,0.04,0.03/{cells}/tet10", RUBBER, "xmin", pull(0.0, 0.3, 0.7), pull(0.0, 0.6, -0.3), 'set = "xmax"',
        frame=0.02, end=1.3, steps=halved(0.02, 3), released=0.31, damping=0.5,
        step_sizes=(("derivatives", (8, 30)),), step_cost=0.06)
    return on_another_mesh(replace(scene, **changes), f"box:0.3,0.04,0.03/{finer}/tet10")


def couple(cells, degrees):
    """Forces on the corners of a box's end that turn as they grow, as config/rubber_twist.toml has them, and stay."""
    nx, ny, nz = (2 * n for n in cells)  # of a quadratic mesh
    at = lambda t: (t / 0.3, math.radians(degrees) * t / 0.3)  # noqa: E731
    times = [0.03 * n for n in range(11)]
    turned = lambda part: tuple((t, at(t)[0] * part(at(t)[1])) for t in times)  # noqa: E731
    loads = []
    for y, z in ((-1, -1), (1, -1), (-1, 1), (1, 1)):
        vertex = f"vertex = {1 + nx + (nx + 1) * ((ny if y > 0 else 0) + (ny + 1) * (nz if z > 0 else 0))}"
        sense = 1 if degrees > 0 else -1
        loads.append(Load(vertex, (0.0, -22.9 * z * sense, 34.4 * y * sense), turned(math.cos)))
        loads.append(Load(vertex, (0.0, -34.4 * y, -22.9 * z), turned(lambda a: math.sin(abs(a)))))
    return tuple(loads)


def twist(cells, finer):
    """Held, not released: the end of a body let go at 270 degrees spins, and no step of these follows it."""
    mesh = lambda n: f"box:0.3,0.045,0.03/{n[0]},{n[1]},{n[2]}/tet10"  # noqa: E731
    loads, there = couple(cells, 200), couple(finer, 200)
    scene = Scene(
        "twist", "A rubber cantilever twisted through 270 degrees and held", mesh(cells), RUBBER, "xmin", loads,
        couple(cells, -150), loads[-1].target, frame=0.006, end=0.504, steps=halved(0.006, 2), released=math.inf,
        damping=20.0, step_cost=0.1)
    return on_another_mesh(scene, mesh(finer), loads=there, probe=there[-1].target)


def strike(left, right):
    """Softly, for 1.2 ms: a harder one rings at kilohertz, which no step of these follows."""
    table = tuple((1e-4 * n, round(math.sin(math.pi * n / 12) ** 2, 6)) for n in range(13))
    return (Load('set = "tip_left"', left, table), Load('set = "tip_right"', right, table))


def fork(factor):
    """Struck with 20 N times the factor. Steel would yield long before the largest: the law does not, and shows where
    linear motion ends."""
    scene = Scene(
        "fork" if factor == 1 else f"fork_x{factor:g}",
        f"A steel tuning fork, held at its stem, struck with {20 * factor:g} N", meshes.Fork(0.006, 7), STEEL,
        "stem_end", strike((20.0, 0.0, 0.0), (-20.0, 0.0, 0.0)), strike((20.0, 0.0, 5.0), (0.0, 0.0, 0.0)),
        'set = "tip_left"', frame=1e-4, end=6e-3, steps=halved(1e-4, 3), released=1.2e-3, load_factor=float(factor),
        ranks=2, step_sizes=(("derivatives", (4, 14)),), step_cost=0.25)
    if factor != 1:
        scene = replace(scene, limits=Limits(integrators=("exact", "avf")))
    return on_another_mesh(scene, meshes.Fork(0.004, 10))


def block(cells, finer, **changes):
    shear = lambda *total: held('set = "top"', total, 0.08, 0.12, 0.125)  # noqa: E731
    later = held('set = "top"', (0.0, 20.0, 5.0), 0.03, 0.06, 0.065)
    scene = Scene(
        "block", "A soft block with hard grains (stiffness ratio 1000), sheared and released", meshes.Block(cells),
        GRAINS, "bottom", (shear(25.0, 10.0, 0.0),), (shear(-15.0, 0.0, 0.0), later), 'set = "top"', frame=0.004,
        end=0.3, steps=halved(0.002, 3), released=0.125, damping=1.0, step_cost=0.08)
    return on_another_mesh(replace(scene, **changes), meshes.Block(finer))


def rubber(cells, finer, analysis, **changes):
    """A law that is no polynomial. Linear cells, which are stiffer than the rubber, but all runs have the same."""
    along = ((0.0, 0.0), (1.0, 1.0)) if analysis == "static" else ((0.0, 0.0), (0.2, 1.0), (0.3, 1.0), (0.31, 0.0))
    scene = Scene(
        "rubber" if analysis == "time" else "rubber_statics",
        "A beam of neo-Hookean rubber, 800 x 200 x 200 mm, bent" + (" and released" if analysis == "time" else ": statics"),
        f"box:0.8,0.2,0.2/{cells}/tet4", ("-material_law", "neo-hookean", *RUBBER), "xmin",
        (Load('set = "xmax"', (0.0, 240.0, 480.0), along),), (), 'set = "xmax"', frame=0.02, end=1.0,
        steps=halved(0.02, 2), released=0.31, damping=0.5, step_cost=0.15)
    if analysis == "static":
        scene = replace(scene, analysis=analysis, frame=0.2, end=1.0, steps=(0.2, 0.1), damping=0.0, released=0.0)
    return on_another_mesh(replace(scene, **changes), f"box:0.8,0.2,0.2/{finer}/tet4")


def large(analysis):
    """More than 100,000 degrees of freedom."""
    beam = Scene(
        "large_transient", "A generated beam of 1 x 0.06 x 0.06 m, pulled", "box:1,0.06,0.06/100,6,6/tet10", RUBBER,
        "xmin", (Load('set = "xmax"', (0.0, 0.3, 0.7), ((0.0, 0.0), (0.3, 1.0))),),
        (Load('set = "xmax"', (0.0, 0.8, -0.2), ((0.0, 0.0), (0.3, 1.0))),), 'set = "xmax"', frame=0.05, end=0.5,
        steps=halved(0.05, 1), ranks=2, step_cost=10.0, other_is="a coarser",
        limits=Limits(methods=("linear", "linear_polynomial", "derivatives", "full"),
                      integrators=("avf", "implicit-euler"),
                      sizes=((4, 0), (8, 0), (16, 0), (4, 14), (8, 20), (8, 44))))
    if analysis == "static":
        along = lambda loads: tuple(replace(load, table=((0.0, 0.0), (1.0, 1.0))) for load in loads)  # noqa: E731
        beam = replace(beam, name="large_statics", title="The generated beam, bent: statics", analysis=analysis,
                       loads=along(beam.loads), training=along(beam.training), frame=1.0, end=1.0, steps=(1.0, 0.5),
                       step_cost=16.0)
    return on_another_mesh(beam, "box:1,0.06,0.06/50,3,3/tet10")


FORK_FACTORS = (1, 10, 100)
FULL = (cantilever("16,2,2", "24,3,3"), twist((16, 2, 2), (24, 3, 3)), *map(fork, FORK_FACTORS), block(8, 16),
        rubber("24,6,6", "32,8,8", "static"), rubber("24,6,6", "32,8,8", "time"), large("static"), large("time"))
QUICK = (cantilever("8,1,1", "12,2,2", end=1.3, steps=halved(0.02, 2), step_sizes=(), step_cost=0.01),
         block(4, 8, end=0.2, steps=halved(0.004, 2), step_cost=0.01),
         rubber("12,3,3", "16,4,4", "static", step_cost=0.1),
         rubber("12,3,3", "16,4,4", "time", end=0.6, limits=Limits(sweeps=("basis",)), step_cost=0.04))
