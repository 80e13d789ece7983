"""A mesh file that no generator would write: a beam whose vertices and cells stand in a random order."""
import numpy as np

from stability.meshes import tetrahedra


def write_shuffled_beam(path, cells=(10, 2, 2), lengths=(1, .1, .06)):
    """Gmsh 2.2, with gaps in the vertices' numbers."""
    points, tets = tetrahedra(cells, lengths)
    shuffle = np.random.default_rng(7)
    ids = shuffle.permutation(3 * len(points))[:len(points)] + 1
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", str(len(points))]
    lines += [f"{ids[v]} {points[v][0]!r} {points[v][1]!r} {points[v][2]!r}" for v in shuffle.permutation(len(points))]
    lines += ["$EndNodes", "$Elements", str(len(tets))]
    for number, tet in enumerate(shuffle.permutation(tets)):
        lines.append(f"{number + 1} 4 2 1 1 " + " ".join(str(ids[v]) for v in tet))
    path.write_text("\n".join(lines + ["$EndElements", ""]))
