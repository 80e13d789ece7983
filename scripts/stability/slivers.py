"""One flat tetrahedron inside a clamped beam of 1 x 0.2 x 0.1 m; and flat and long cells by the hundred."""
import numpy as np

from bench import SOFT
from .meshes import quadratic, tetrahedra, with_sliver, write_msh
from .outcome import refused
from .row import Figure, Row, at_most, equal, near, reported, says

WORDS = ["-fix", "box:-1e-9,1e-9,-1,1,-1,1", *SOFT, "-modes", "6"]


def beam():
    return tetrahedra((10, 2, 1), (1, .2, .1))


def reduce(bench, points, tets, code=0):
    write_msh(bench.folder / "beam.msh", points, tets)
    ran = bench.reduce("-mesh", "beam.msh", *WORDS, "-quiet", code=code)
    return ran, np.array([float(row["frequency_hz"]) for row in bench.modes()][:6]) if ran.code == 0 else None


def low_modes(bench, length):
    _, plain = reduce(bench, *beam())
    figures = []
    for degrees in (.1, .01, 1e-3, 1e-4):
        ran, f = reduce(bench, *with_sliver(*beam(), degrees))
        figures.append(at_most(f"{degrees:g} deg: six modes move by", np.abs(f / plain - 1).max(), 1e-6))
        figures.append(says("warning", " ".join(ran.warnings), "dihedral angle under 1 degree"))
    return figures


def one_degree(bench, length):
    warned = ["dihedral" in " ".join(reduce(bench, *with_sliver(*beam(), degrees))[0].warnings)
              for degrees in (.999, 1.001)]
    return [Figure(f"at .999 and 1.001 degrees: {' and '.join('a warning' if w else 'none' for w in warned)}",
                   warned == [True, False])]


def millionth(bench, length):
    _, plain = reduce(bench, *beam())
    before = bench.files()
    ran, f = reduce(bench, *with_sliver(*beam(), 1e-6), code=None)
    if f is None:
        return [refused(bench, ran, before)]
    return [reported(f"solved; six modes move by {np.abs(f / plain - 1).max():.1e}"),
            says("warning", " ".join(ran.warnings), "dihedral angle under 1 degree")]


def flat_and_long(bench, length):
    """The block 1 x 0.1 x 0.06 m in slices that double in thickness from 1 um at the support on."""
    points, tets = tetrahedra((18, 2, 1), (18, .1, .06))
    planes = np.append(0, 1e-6 * 2.2 ** np.arange(18))
    points[:, 0] = (planes / planes[-1])[points[:, 0].round().astype(int)]
    write_msh(bench.folder / "slices.msh", *quadratic(points, tets))
    bench.reduce("-mesh", "slices.msh", *WORDS, "-quiet")
    kind, below, found = bench.certificate()
    thinnest = planes[1] / planes[-1]
    return [reported(f"the thinnest slice is {thinnest:.1e} m thick, its cells' edges 1 : {.05 / thinnest:.0e}"),
            near("f1 in Hz", float(bench.modes()[0]["frequency_hz"]), .307021, .03),
            equal(f"{found} modes found, the inertia counts {below}; certified", (kind, below), ("inertia", found))]


ROWS = [
    Row("sliver_modes", "a sliver of .1, .01, 1e-3, 1e-4 degrees in a beam",
        "low modes move by less than 1e-6; a warning names it", low_modes),
    Row("sliver_one_degree", "a sliver of .999 and 1.001 degrees",
        "a warning names cells under 1 degree, and no others", one_degree),
    Row("sliver_millionth", "a sliver of 1e-6 degrees", "solved with a warning, or refused; the change is reported",
        millionth),
    Row("flat_and_long", "a block in slices from 1 um to 0.5 m thick, Tet10",
        "f1 within 3 % of the fine mesh's .307021 Hz (the last slices are coarse); certified", flat_and_long),
]
