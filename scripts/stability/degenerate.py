"""Meshes and supports with too much or too little in them: a defined result, or one sentence."""
import numpy as np

from bench import SOFT, statics
from .meshes import TET, hexahedra, tetrahedra, write_msh
from .outcome import refused
from .row import Row, at_most, equal, says

TWO_SHARING = {  # what they share -> points, cells, rigid modes
    "a vertex": (np.vstack([TET, -TET[1:]]), [[0, 1, 2, 3], [0, 4, 6, 5]], 9),
    "an edge": (np.vstack([TET, [[0, -1, 0], [0, 0, -1]]]), [[0, 1, 2, 3], [0, 1, 4, 5]], 7),
    "nothing": (np.vstack([TET, TET + 3]), [[0, 1, 2, 3], [4, 5, 6, 7]], 12),
}


def rigid_count(bench):
    return sum(row["kind"] == "rigid" for row in bench.modes())


def mesh(bench, points, cells, name="mesh.msh"):
    write_msh(bench.folder / name, points, cells)
    return ["-mesh", name, *SOFT]


def unreferenced(bench, length):
    points, tets = tetrahedra((6, 1, 1), (1, .2, .2))
    plain = bench.frequencies(*mesh(bench, points, tets), "-modes", "6")
    spread = np.vstack([[[9, 9, 9]], points, [[-7, 0, 0], [.5, .1, .1]]])
    ran = bench.reduce(*mesh(bench, spread, tets + 1), "-modes", "6", "-quiet")
    f = np.array([float(row["frequency_hz"]) for row in bench.modes() if row["kind"] == "flexible"])
    return [says("warning", " ".join(ran.warnings), "3 vertices that no cell uses were dropped"),
            at_most("frequencies differ by", np.abs(f / plain - 1).max(), 1e-10)]


def duplicate(bench, length):
    """Two blocks that meet in a face but do not share its vertices."""
    points, hexes = hexahedra((2, 1, 1), (1, .5, .5))
    words = mesh(bench, np.vstack([points, points + [1, 0, 0]]), np.vstack([hexes, hexes + len(points)]))
    ran = bench.reduce(*words, "-modes", "4", "-quiet")
    return [equal("rigid modes", rigid_count(bench), 12),
            says("warning", " ".join(ran.warnings), "2 disconnected pieces")]


def sharing(bench, length):
    figures = []
    for what, (points, cells, rigid) in TWO_SHARING.items():
        bench.reduce(*mesh(bench, points, cells), "-modes", "100", "-quiet")
        figures.append(equal(f"sharing {what}: rigid modes", rigid_count(bench), rigid))
        figures.append(equal("modes in all", len(bench.modes()), 3 * len(points)))
    return figures


def one_cell(bench, length):
    words = [*mesh(bench, TET, [[0, 1, 2, 3]]), "-modes", "100"]
    one = bench.frequencies(*words, ranks=1)
    figures = [equal("rigid modes", rigid_count(bench), 6), equal("flexible modes", len(one), 6)]
    three = bench.frequencies(*words, ranks=3)
    figures.append(equal("on 3 ranks, two of them empty: flexible modes", len(three), 6))
    figures.append(at_most("frequencies differ by", np.abs(three / one - 1).max(), 1e-10))
    figures.append(equal("certified", bench.certificate()[0], "inertia"))
    return figures


def nothing_free(bench, length):
    ran = bench.reduce(*mesh(bench, TET, [[0, 1, 2, 3]]), "-fix", "box:-1,2,-1,2,-1,2", code=None)
    return [refused(bench, ran, {"mesh.msh"}, code=2)]


def same_way(bench, words, text):
    """The probe's, by model.h5 and by the full model."""
    scene, tips = bench.write("scene.toml", text), []
    bench.move("model.h5", "--scene", scene, "--quiet")
    tips.append(bench.tip())
    bench.full(*words, "-scene", scene, "-quiet")
    tips.append(bench.tip())
    size = np.linalg.norm(tips[1])
    apart = np.linalg.norm(tips[0] - tips[1]) / size
    return at_most(f"it moves by {size:.3g} m; reduced and full differ by", apart, 1e-8)


def one_free_vertex(bench, length):
    """It is held by three others; then pushed until it moves a tenth of the cell, reduced and full."""
    words = [*mesh(bench, TET, [[0, 1, 2, 3]]), "-fix", "box:-1,2,-1,2,-1,0.001"]
    bench.reduce(*words, "-modes", "3", "-polynomial", "-quiet")
    figures = [equal("modes", len(bench.modes()), 3)]
    return [*figures, same_way(bench, words, statics("vertex = 4", "total = [2e3, 1e3, 2e4]", steps=2))]


def more_modes_than_there_are(bench, length):
    bench.reduce("-mesh", "box:1,1,1/1,1,1/hex8", *SOFT, "-modes", "1000", "-quiet")
    return [equal("of 24 degrees of freedom, modes", len(bench.modes()), 24),
            equal("certified", bench.certificate()[0], "inertia")]


def more_directions_than_there_are(bench, length):
    """All modes and all their derivatives: the basis spans everything, many times over."""
    words = ["-mesh", "box:1,.5,.5/1,1,1/hex8", "-fix", "xmin", *SOFT]
    bench.reduce(*words, "-modes", "12", "-derivatives", "12", "-polynomial", "-quiet")
    columns = len(bench.body("model.h5", "reduction/stiffness"))
    return [equal("of 12 degrees of freedom and 90 vectors, columns kept", columns, 12),
            same_way(bench, words, statics('set = "xmax"', "total = [0, 2e3, 1e4]", steps=4))]


ROWS = [
    Row("unreferenced_vertices", "three vertices that no cell uses", "dropped with a warning; the frequencies stay",
        unreferenced),
    Row("duplicate_vertices", "two blocks meet in a face whose vertices are double",
        "two bodies: 12 rigid modes, and a warning", duplicate),
    Row("sharing", "two tetrahedra that share a vertex, an edge, nothing", "9, 7 and 12 rigid modes", sharing),
    Row("one_cell", "a mesh of one tetrahedron, on 1 and on 3 ranks", "6 rigid and 6 flexible modes, the same on both",
        one_cell),
    Row("nothing_free", "every vertex is held", "refused: exit code 2, one sentence", nothing_free),
    Row("one_free_vertex", "one free vertex, pushed", "3 modes, and with all of them the full model's way to 1e-8",
        one_free_vertex),
    Row("all_modes", "1000 modes of 24 degrees of freedom", "24 modes, certified", more_modes_than_there_are),
    Row("all_directions", "12 modes and 78 derivatives of 12 degrees of freedom, bent",
        "12 columns; the full model's way to 1e-8", more_directions_than_there_are),
]
