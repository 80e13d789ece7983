"""Small meshes that no generator writes, as Gmsh 2.2 text."""
import itertools

import numpy as np

GMSH = {("face", 3): 2, ("face", 4): 3, ("cell", 4): 4, ("cell", 8): 5, ("cell", 10): 11}  # kind and vertices -> type
TET = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)


def write_msh(path, points, cells, regions=None, sets=(), ids=None):
    """`cells`: rows of vertices; `regions`: a name a cell; `sets`: name -> faces, rows of vertices; `ids`: the numbers
    of the vertices in the file."""
    ids = np.arange(1, len(points) + 1) if ids is None else ids
    regions = ["body"] * len(cells) if regions is None else regions
    names = {name: (3, i + 1) for i, name in enumerate(dict.fromkeys(regions))}
    names |= {name: (2, len(names) + i + 1) for i, name in enumerate(dict(sets))}
    elements = [("face", name, face) for name, faces in dict(sets).items() for face in faces]
    elements += [("cell", region, cell) for region, cell in zip(regions, cells)]
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(names))]
    lines += [f'{dimension} {tag} "{name}"' for name, (dimension, tag) in names.items()]
    lines += ["$EndPhysicalNames", "$Nodes", str(len(points))]
    lines += [f"{i} {x[0]!r} {x[1]!r} {x[2]!r}" for i, x in zip(ids, np.asarray(points, float).tolist())]
    lines += ["$EndNodes", "$Elements", str(len(elements))]
    for number, (kind, name, vertices) in enumerate(elements):
        tag = names[name][1]
        words = [number + 1, GMSH[kind, len(vertices)], 2, tag, tag, *(ids[v] for v in vertices)]
        lines.append(" ".join(map(str, words)))
    path.write_text("\n".join([*lines, "$EndElements", ""]))


def grid(cells, lengths):
    """Points of a box's lattice, z fastest, and the number of the one at (i, j, k)."""
    shape = np.array(cells) + 1
    lattice = np.array(list(itertools.product(*map(range, shape))))
    return lattice * (np.array(lengths) / cells), lambda at: int(np.ravel_multi_index(tuple(at), shape))


def hexahedra(cells, lengths):
    points, number = grid(cells, lengths)
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    return points, np.array([[number(np.add(c, d)) for d in corners]
                             for c in itertools.product(*map(range, cells))])


def tetrahedra(cells, lengths):
    """Kuhn's six a hexahedron."""
    points, number = grid(cells, lengths)
    tets = []
    for corner in itertools.product(*map(range, cells)):
        for axes in itertools.permutations(range(3)):
            path = np.array(corner) + np.vstack([np.zeros(3, int), np.cumsum(np.eye(3, dtype=int)[list(axes)], axis=0)])
            if np.linalg.det(path[1:] - path[0]) < 0:
                path[[1, 2]] = path[[2, 1]]
            tets.append([number(v) for v in path])
    return points, np.array(tets)


def quadratic(points, tets):
    """Tetrahedra with a vertex in the middle of each edge, in Gmsh's order."""
    edges = np.sort(tets[:, [[0, 1], [1, 2], [0, 2], [0, 3], [2, 3], [1, 3]]], axis=2)
    unique, of = np.unique(edges.reshape(-1, 2), axis=0, return_inverse=True)
    middles = points[unique].mean(axis=1)
    return np.vstack([points, middles]), np.hstack([tets, len(points) + of.reshape(-1, 6)])


def end_faces(points, hexes, x):
    """The quadrilaterals of hexahedra that lie in the plane of this x."""
    sides = [(0, 4, 7, 3), (1, 2, 6, 5)]
    return [cell[list(side)] for cell in hexes for side in sides if np.allclose(points[cell[list(side)], 0], x)]


def with_sliver(points, tets, degrees):
    """The middle tetrahedron cut into four by a vertex so near to its first face that the one between them has a
    smallest dihedral angle of `degrees`."""
    cell = len(tets) // 2
    face, apex = tets[cell][:3], tets[cell][3]
    a, b, c = points[face]
    centre, normal = (a + b + c) / 3, np.cross(b - a, c - a)
    if normal @ (points[apex] - a) < 0:
        normal = -normal
    farthest = max(np.linalg.norm(np.cross(q - p, centre - p)) / np.linalg.norm(q - p)
                   for p, q in ((a, b), (b, c), (c, a)))
    added = centre + np.tan(np.radians(degrees)) * farthest * normal / np.linalg.norm(normal)
    parts = [[len(points) if i == j else v for j, v in enumerate(tets[cell])] for i in range(4)]
    return np.vstack([points, added]), np.vstack([np.delete(tets, cell, axis=0), parts])


def permuted(points, cells, seed=7):
    """The same mesh in a random order: points, cells, numbers of vertices (with gaps), and where each point went."""
    shuffle = np.random.default_rng(seed)
    order = shuffle.permutation(len(points))
    place = np.empty_like(order)
    place[order] = np.arange(len(order))
    ids = np.sort(shuffle.permutation(3 * len(points))[:len(points)]) + 1
    return points[order], place[shuffle.permutation(cells)], ids, order
