"""A mesh file that no generator would write: a beam whose vertices and cells stand in a random order."""
import itertools

import numpy as np


def kuhn_beam(cells, lengths):
    """Points and tetrahedra of a box, six tetrahedra a hexahedron."""
    shape = np.array(cells) + 1
    grid = np.array(list(itertools.product(*map(range, shape))))
    number = lambda v: np.ravel_multi_index(np.asarray(v).T, shape)
    tets = []
    for corner in itertools.product(*map(range, cells)):
        for axes in itertools.permutations(range(3)):
            path = np.array(corner) + np.vstack([np.zeros(3, int), np.cumsum(np.eye(3, dtype=int)[list(axes)], axis=0)])
            if np.linalg.det(path[1:] - path[0]) < 0:
                path[[1, 2]] = path[[2, 1]]
            tets.append(number(path))
    return grid * (np.array(lengths) / cells), np.array(tets)


def write_shuffled_beam(path, cells=(10, 2, 2), lengths=(1, .1, .06)):
    """Gmsh 2.2, with gaps in the vertices' numbers."""
    points, tets = kuhn_beam(cells, lengths)
    shuffle = np.random.default_rng(7)
    ids = shuffle.permutation(3 * len(points))[:len(points)] + 1
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", str(len(points))]
    lines += [f"{ids[v]} {points[v][0]!r} {points[v][1]!r} {points[v][2]!r}" for v in shuffle.permutation(len(points))]
    lines += ["$EndNodes", "$Elements", str(len(tets))]
    for number, tet in enumerate(shuffle.permutation(tets)):
        lines.append(f"{number + 1} 4 2 1 1 " + " ".join(str(ids[v]) for v in tet))
    path.write_text("\n".join(lines + ["$EndElements", ""]))
