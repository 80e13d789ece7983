"""The clamped block 1 x 0.10 x 0.06 m, E = 1e6 Pa, 1000 kg/m3, towards nu = 1/2."""
import numpy as np

from bench import material
from .meshes import quadratic, tetrahedra, write_msh
from .outcome import refused
from .row import Figure, Length, Row, near, says

REFERENCE = {.49: .31315, .499: .31357, .4999: .31363}  # Hz, three-dimensional, fine


def graded_block(cells):
    """Finer towards the support, whose edges carry singular stresses, and towards the sides."""
    points, tets = tetrahedra(cells, (1, 1, 1))
    t = 2 * points[:, 1:] - 1
    sides = (1 + t * (1.15 - .15 * t * t)) / 2 * [.1, .06]
    return np.column_stack([points[:, 0] * (1 + 2 * points[:, 0]) / 3, sides]), tets


def tet10(poisson):
    def run(bench, length):
        cells = (24, 4, 3) if length is Length.full else (16, 3, 2)
        write_msh(bench.folder / "block.msh", *quadratic(*graded_block(cells)))
        f = bench.frequencies("-mesh", "block.msh", "-fix", "box:-1e-9,1e-9,-1,1,-1,1", "-modes", "1",
                              *material(poisson=poisson))
        return [near("f1 in Hz", f[0], REFERENCE[poisson], .02)]
    return run


def linear(bench, length):
    ran = bench.reduce("-mesh", "box:1,.1,.06/12,2,2/tet4", "-fix", "xmin", *material(poisson=.4999), "-modes", "1")
    f = float(bench.modes()[0]["frequency_hz"])
    return [says(f"f1 = {f:.4g} Hz, not {REFERENCE[.4999]}, and a warning", " ".join(ran.warnings), "lock", "tet10")]


def impossible(bench, length):
    figures = []
    for poisson in (".5", ".6", "-1", "-1.5", "nan"):
        ran = bench.reduce("-mesh", "box:1,.1,.06/4,1,1/tet4", "-material_young", "1e6", "-material_poisson", poisson,
                           "-material_density", "1000", code=None)
        seen = refused(bench, ran, set(), code=2)
        figures.append(Figure(f"{poisson}: {seen.text}", seen.holds))
    return figures


ROWS = [Row(f"nu_{nu}".replace("0.", ""), f"cantilever, nu = {nu}, Tet10", f"f1 within 2 % of {f} Hz", tet10(nu))
        for nu, f in REFERENCE.items()]
ROWS += [
    Row("nu_4999_tet4", "the same with nu = .4999, Tet4", "a warning that it locks, which names tet10", linear),
    Row("nu_impossible", "nu = .5, .6, -1, -1.5, not a number", "refused: exit code 2, one sentence", impossible),
]
