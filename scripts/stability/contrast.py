"""A bar of two halves along x, one 1e6 times as stiff as the other."""
import numpy as np

from bench import statics
from .meshes import end_faces, hexahedra, write_msh
from .row import Row, at_most, equal, near

YOUNG, AREA = 1e6, .25
BAR = ["-mesh", "bar.msh", "-fix", "box:-1e-9,1e-9,-1,1,-1,1", "-quiet"]


def write_bar(bench, cells, lengths, stiff_end):
    points, hexes = hexahedra(cells, lengths)
    far = points[hexes, 0].mean(axis=1) > lengths[0] / 2
    regions = np.where(far == (stiff_end == "far"), "stiff", "soft")
    write_msh(bench.folder / "bar.msh", points, hexes, list(regions), {"end": end_faces(points, hexes, lengths[0])})


def materials(poisson, ratio):
    words = ["-material_poisson", str(poisson), "-material_density", "1000"]
    return [*words, "-material_soft_young", str(YOUNG), "-material_stiff_young", str(YOUNG * ratio)]


def stretched(stress, young):
    """u/L of a bar under a dead load, uniaxial StVK: stress = E/2 s (s^2 - 1), s = 1 + u/L."""
    x = stress / young
    for _ in range(60):
        x -= (x * (1 + x) * (1 + x / 2) - stress / young) / (1 + 3 * x + 1.5 * x * x)
    return x


def series(bench, length):
    figures = []
    for stiff_end in ("near", "far"):
        write_bar(bench, (4, 2, 2), (1, .5, .5), stiff_end)
        for pull in (1e-3, 1e5):
            scene = bench.write("pull.toml", statics('set = "end"', f"traction = [{pull / AREA!r}, 0, 0]"))
            bench.full(*BAR, *materials(0, 1e6), "-scene", scene, "-frames", "0")
            tip = bench.tip()[0]
            expected = .5 * stretched(pull / AREA, YOUNG) + .5 * stretched(pull / AREA, 1e6 * YOUNG)
            figures.append(near(f"stiff half {stiff_end}, {pull:g} N: the end moves by, in m,", tip, expected, 1e-8))
    return figures


def counted(bench, length):
    figures = []
    for stiff_end in ("near", "far"):
        write_bar(bench, (8, 2, 1), (1, .1, .06), stiff_end)
        bench.reduce(*BAR, *materials(.3, 1e6), "-modes", "12")
        kind, below, found = bench.certificate()
        figures.append(equal(f"stiff half {stiff_end}: {found} modes found, the inertia counts {below}; certified",
                             (kind, below), ("inertia", found)))
        residuals, floor = bench.body("model.h5", "modes/residuals", "modes/floor_applies")
        figures.append(at_most(f"{np.count_nonzero(floor)} modes at the floor of 10 eps |K|; residual of the others",
                               residuals[floor == 0].max(), 1e-8))
    return figures


ROWS = [
    Row("contrast_statics", "two halves, E ratio 1e6, pulled; nu = 0",
        "bars in series to 1e-8 (StVK's closed form)", series),
    Row("contrast_modes", "two halves, E ratio 1e6: twelve modes, nu = .3",
        "as many as the inertia counts: certified", counted),
]
