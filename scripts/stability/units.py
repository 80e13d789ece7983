"""Units, densities and the origin: dimensionless results stay."""
import numpy as np

from bench import material, statics
from .meshes import tetrahedra, write_msh
from .row import Length, Row, at_most

COUNT = 8


def dimensionless(bench, words, young, density, size):
    """omega L sqrt(rho/E); E, rho and L in SI units."""
    f = bench.frequencies(*words, "-modes", COUNT)[:COUNT]
    return 2 * np.pi * f * size * np.sqrt(density / young)


def box(size):
    return ["-mesh", f"box:{size!r},{.1 * size!r},{.06 * size!r}/6,1,1/tet10"]


def furthest(a, b):
    return np.abs(a / b - 1).max()


def unit_systems(bench, length):
    figures = []
    for support in (["-fix", "xmin"], []):
        at = lambda words, size: dimensionless(bench, [*words, *support], 1e6, 1000, size)  # noqa: E731
        si = at([*box(1.), *material()], 1)
        what = "clamped" if support else "free"
        mm = at([*box(1000.), *material(1., .3, 1e-9), "-units", "mm-t-s"], 1)
        um = at([*box(1e6), *material(1., .3, 1e-15), "-units", "um-kg-s"], 1)
        figures += [at_most(f"{what}: mm-t-s and SI differ by", furthest(mm, si), 1e-9),
                    at_most("um-kg-s and SI", furthest(um, si), 1e-9)]
    return figures


def scales(bench, length):
    plain = dimensionless(bench, [*box(1.), *material(), "-fix", "xmin"], 1e6, 1000, 1)
    figures = []
    for density in (1e-12, 1e-6, 1., 1e6, 1e12) if length is Length.full else (1e-12, 1e12):
        there = dimensionless(bench, [*box(1.), *material(density=density), "-fix", "xmin"], 1e6, density, 1)
        figures.append(at_most(f"density {density:g} kg/m3: differ by", furthest(there, plain), 1e-9))
    for size, young in ((1e-6, 1e6), (1e-3, 2e11), (1e3, 2e11)) if length is Length.full else ((1e-6, 1e6),):
        there = dimensionless(bench, [*box(size), *material(young=young), "-fix", "xmin"], young, 1000, size)
        figures.append(at_most(f"a beam of {size:g} m, E = {young:g} Pa:", furthest(there, plain), 1e-9))
    return figures


def far_away(bench, length):
    """The gate: 20 units in the last place of the coordinates, as a fraction of the shortest edge."""
    offset, edge = 1e6, .2
    gate = 20 * np.spacing(offset) / edge
    figures = []
    for support in (True, False):
        found = []
        for shift in (0., offset):
            points, tets = tetrahedra((5, 1, 1), (1, .2, .2))
            write_msh(bench.folder / "beam.msh", points + shift, tets)
            across = f"{shift - 1!r},{shift + 1!r}"
            fix = ["-fix", f"box:{shift - .05!r},{shift + .05!r},{across},{across}"] if support else []
            found.append(dimensionless(bench, ["-mesh", "beam.msh", *material(), *fix], 1e6, 1000, 1))
        figures.append(at_most(f"{'clamped' if support else 'free'}: differ by", furthest(*found), gate))
    return figures


def bent(bench, length):
    """The reduced nonlinear model in two unit systems; a scene is in SI units always."""
    scene = bench.write("bend.toml", statics('set = "xmax"', "total = [0, 0, -3]", steps=2))
    reduction = ["-fix", "xmin", "-modes", "5", "-derivatives", "5", "-basis", "10", "-polynomial", "-quiet"]
    tips = []
    for words in ([*box(1.), *material()], [*box(1000.), *material(1., .3, 1e-9), "-units", "mm-t-s"],
                  [*box(1e6), *material(1., .3, 1e-15), "-units", "um-kg-s"]):
        bench.reduce(*words, *reduction)
        bench.move("model.h5", "--scene", scene, "--quiet")
        tips.append(bench.tip())
    size = np.linalg.norm(tips[0])
    return [at_most(f"the tip moves by {size:.3g} m; {name} and SI differ by",
                    np.linalg.norm(tip - tips[0]) / size, 1e-9)
            for name, tip in (("mm-t-s", tips[1]), ("um-kg-s", tips[2]))]


ROWS = [
    Row("units_modes", "SI, mm-t-s and um-kg-s: eight modes, clamped and free", "omega L sqrt(rho/E) agree to 1e-9",
        unit_systems, seconds=7),
    Row("units_motion", "the same, bent by a reduced nonlinear model", "the tip's way agrees to 1e-9", bent, seconds=6),
    Row("scales", "densities of 1e-12 ... 1e12 kg/m3, bodies of 1 um ... 1 km", "omega L sqrt(rho/E) agree to 1e-9",
        scales, seconds=8),
    Row("far_away", "coordinates + 1e6 m", "omega L sqrt(rho/E) agree to 20 ulp(offset) / shortest edge", far_away),
]
