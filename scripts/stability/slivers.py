"""One flat tetrahedron inside a clamped beam of 1 x 0.2 x 0.1 m."""
import numpy as np

from .bench import SOFT
from .meshes import tetrahedra, with_sliver, write_msh
from .outcome import refused
from .row import Figure, Row, at_most, reported, says

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
    warned = [bool(reduce(bench, *with_sliver(*beam(), degrees))[0].warnings) for degrees in (.999, 1.001)]
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


ROWS = [
    Row("sliver_modes", "a sliver of .1, .01, 1e-3, 1e-4 degrees in a beam", "low modes move by less than 1e-6; a warning names it",
        low_modes, seconds=12),
    Row("sliver_one_degree", "a sliver of .999 and 1.001 degrees", "a warning names cells under 1 degree, and no others", one_degree),
    Row("sliver_millionth", "a sliver of 1e-6 degrees", "solved with a warning, or refused; the change is reported", millionth),
]
