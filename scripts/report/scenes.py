"""The table of scenes. A scene is a body, what is done to it, and how finely the reference is computed."""
from dataclasses import dataclass, field

from report import meshes

STEEL = ("-material_young", "2.06e11", "-material_poisson", "0.29", "-material_density", "7850")
RUBBER = ("-material_young", "1e6", "-material_poisson", "0.45", "-material_density", "1100")


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
    mesh: object  # the words of -mesh, or a function that writes a mesh file into a folder and returns its path
    options: tuple  # of the programs: materials, units
    fixed: str  # the set whose vertices are held
    loads: tuple
    training: tuple  # loads of the motion that POD learns from
    probe: str  # a line of TOML
    frame: float  # s between the frames that are compared; every step divides it
    end: float  # s; of statics 1, the load fraction
    steps: tuple  # s, coarse to fine; the finest is the reference's
    analysis: str = "time"
    released: float = 0.0  # s, from when on the body moves freely: where its tone is taken
    damping: float = 0.0  # alpha, 1/s
    load_factor: float = 1.0  # of all loads
    other_mesh: object = None  # the mesh that the reference is repeated on, for the error of the mesh
    other_mesh_is: str = "finer"
    ranks: int = 1  # of ritz-reduce and ritz-full
    methods: tuple = field(default=())  # names of methods.METHODS; empty: all
    step_cost: float = 0.05  # s a step of ritz-full takes, about: for the estimate of the time left alone

    def toml(self, step, integrator, loads=None):
        head = f"[time]\nstep = {step!r}\nend = {self.end!r}\n"
        if integrator:
            head += f'integrator = "{integrator}"\n'
        if self.analysis == "static":
            head = f"[static]\nsteps = {round(1 / step)}\n"
        elif self.damping:
            head += f"[damping]\nalpha = {self.damping!r}\n"
        chosen = self.loads if loads is None else loads
        return head + "".join(load.toml(self.load_factor) for load in chosen) + f'[[probe]]\nname = "probe"\n{self.probe}\n'

    def count(self, step):
        return round(self.end / step)

    @property
    def reference_step(self):
        return self.steps[-1]


def pull(total, until=(0.3, 0.5, 0.51)):
    rise, hold, gone = until
    return (Load('set = "xmax"', total, ((0.0, 0.0), (rise, 1.0), (hold, 1.0), (gone, 0.0))),)


def cantilever(name="cantilever", cells="16,2,2", finer="32,4,4", **changes):
    values = dict(
        name=name, title="A cantilever pulled askew and released",
        mesh=f"box:0.3,0.04,0.03/{cells}/tet10", options=RUBBER, fixed="xmin",
        loads=pull((0.0, 0.6, 1.4)), training=pull((0.0, 1.2, -0.5)), probe='set = "xmax"',
        frame=0.02, end=1.2, steps=(0.02, 0.01, 0.005, 0.0025, 0.00125), released=0.51, damping=0.5,
        other_mesh=f"box:0.3,0.04,0.03/{finer}/tet10", step_cost=0.04)
    return Scene(**{**values, **changes})


FULL = (cantilever(),)
QUICK = (cantilever(cells="8,1,1", finer="12,2,2", end=0.8, steps=(0.02, 0.01, 0.005), step_cost=0.02),)
