"""Repeated eigenvalues: clusters are whole, and span the same space whoever computed them."""
import numpy as np

import programs
from bench import SOFT, material
from .meshes import hexahedra, permuted, write_msh
from .row import Length, Row, at_most, equal, near

CLUSTER = 1e-6  # relative gap
LAMB = ((2.501133, 5), (2.639869, 5), (3.424530, 3), (3.864700, 7), (3.916337, 7), (4.439998, 1))  # omega R / c_s
SPHERE = """SetFactory("OpenCASCADE");
Sphere(1) = {{0, 0, 0, 1}};
Mesh.MeshSizeMax = {size};
Mesh.ElementOrder = 2;
Mesh.HighOrderOptimize = 2;
Mesh.MshFileVersion = 2.2;
"""


def clusters(values):
    """Half-open ranges of indices whose neighbours agree."""
    ends = [i for i in range(1, len(values)) if values[i] - values[i - 1] > CLUSTER * values[i]] + [len(values)]
    return list(zip([0, *ends[:-1]], ends))


def largest_sine(a, b):
    """Between the spans of the columns."""
    qa, qb = np.linalg.qr(a)[0], np.linalg.qr(b)[0]
    return np.linalg.norm(qb - qa @ (qa.T @ qb), 2)


def flexible(bench, *words, ranks=2):
    """Eigenvalues and vectors (3n x k)."""
    bench.reduce(*words, "-quiet", ranks=ranks)
    kinds, values, U = bench.body("model.h5", "modes/kinds", "modes/eigenvalues", "basis/U")
    return values[kinds == b"flexible"], U[:, kinds == b"flexible"]


def same_spaces(what, one, other, groups):
    worst = max(largest_sine(one[:, a:b], other[:, a:b]) for a, b in groups)
    return at_most(f"{what}: largest sine of a principal angle", worst, 1e-6)


def on_ranks(bench, words, groups, length):
    _, one = flexible(bench, *words, ranks=1)
    return [same_spaces(f"1 and {ranks} ranks", one, flexible(bench, *words, ranks=ranks)[1], groups)
            for ranks in ((2, 3) if length is Length.full else (2,))]


def whole_clusters(bench, words, pairs):
    """Asked for k, given the end of k's cluster."""
    given = [len(flexible(bench, *words, "-modes", k)[0]) for k, _ in pairs]
    wanted = [end for _, end in pairs]
    return equal(f"of {[k for k, _ in pairs]} asked for, given", given, wanted)


def file_in_another_order(bench, cells, lengths, words, k):
    points, hexes = hexahedra(cells, lengths)
    write_msh(bench.folder / "plain.msh", points, hexes)
    values, plain = flexible(bench, "-mesh", "plain.msh", *words, "-modes", k)
    shuffled, moved, ids, order = permuted(points, hexes)
    write_msh(bench.folder / "permuted.msh", shuffled, moved, ids=ids)
    _, other = flexible(bench, "-mesh", "permuted.msh", *words, "-modes", k)
    back = np.empty_like(order)
    back[order] = np.arange(len(order))
    other = other.reshape(len(points), 3, -1)[back].reshape(3 * len(points), -1)
    return same_spaces("the file in another order", plain, other, clusters(values))


def square_beam(bench, length):
    words = ["-mesh", "box:1,.1,.1/10,2,2/hex8", "-fix", "xmin", *SOFT]
    values, _ = flexible(bench, *words, "-modes", 8)
    groups = clusters(values)
    figures = [at_most("the first two eigenvalues differ, relative, by", values[1] / values[0] - 1, 1e-9),
               whole_clusters(bench, words, [(1, 2), (3, 4), (5, 5)]),
               *on_ranks(bench, [*words, "-modes", 8], groups, length)]
    held = ["-fix", "box:-1e-9,1e-9,-1,1,-1,1", *SOFT]
    return [*figures, file_in_another_order(bench, (10, 2, 2), (1, .1, .1), held, 8)]


def cube(bench, length):
    words = ["-mesh", "box:1,1,1/4,4,4/hex8", *SOFT]
    values, _ = flexible(bench, *words, "-modes", 17)
    groups = clusters(values)
    ends = [end for _, end in groups]
    pairs = [(k, next(end for end in ends if end >= k)) for k in (1, 4)]
    return [equal("multiplicities", [b - a for a, b in groups][:3], [2, 3, 3]),
            whole_clusters(bench, words, pairs), *on_ranks(bench, [*words, "-modes", 17], groups, length),
            file_in_another_order(bench, (4, 4, 4), (1, 1, 1), SOFT, 17)]


def sphere(bench, length):
    bench.write("sphere.geo", SPHERE.format(size=.22))
    programs.run("gmsh", "-3", "sphere.geo", "-o", "sphere.msh", folder=bench.folder)
    words = ["-mesh", "sphere.msh", *material(poisson=.25), "-modes", "28"]
    values, _ = flexible(bench, *words)
    omega = np.sqrt(values / (1e6 / 2.5 / 1000))
    figures, groups, start = [], [], 0
    for expected, times in LAMB:
        groups.append((start, start + times))
        worst = max(omega[start:start + times], key=lambda w: abs(w - expected))
        figures.append(near(f"{times} at omega R/c_s", worst, expected, .002))
        start += times
    return [*figures, *on_ranks(bench, words, groups, length)]


ROWS = [
    Row("square_beam", "clamped square beam, Hex8: bending in pairs",
        "principal angles <= 1e-6 between numbers of ranks and orders of the file; clusters whole", square_beam,
        seconds=6),
    Row("cube", "free cube, Hex8: pairs and triples", "the same", cube, seconds=10),
    Row("sphere", "free sphere, nu = .25, curved Tet10: multiplets of 5, 5, 3, 7, 7, 1",
        "Lamb's frequencies within .2 %, his multiplicities; multiplets span the same spaces on 1, 2, 3 ranks to 1e-6",
        sphere, seconds=25),
]
