#!/usr/bin/env python3
"""How well -mesh_error estimates: bodies whose frequencies are known, on meshes of growing fineness.

    mesh_error.py [--folder out/mesh_error] [--bodies cantilever plate fork sphere] [--ranks 2]

Runs ritz-reduce, compares the estimated errors of the lowest modes with their true ones, prints a table, and writes
mesh_error.csv and mesh_error.png (needs numpy, h5py, matplotlib; Gmsh for the fork and the sphere).

A mode is known again by its shape. The true frequencies of the cantilever and the plate are Aitken's limit of three meshes
of quadratic cells, those of the fork the limit of two whose errors fall as at edges that reenter, those of the sphere
Lamb's.
"""
import argparse
import csv
import sys
from dataclasses import dataclass, field
from pathlib import Path

import h5py
import numpy as np
import programs
from report.meshes import FORK

SPHERE = """SetFactory("OpenCASCADE");
Sphere(1) = {{0, 0, 0, 1}};
Physical Volume("ball") = {{1}};
Mesh.MeshSizeMax = {size};
Mesh.MeshSizeMin = {size};
Mesh.ElementOrder = {order};
"""
LAMB = [2.501133] * 5 + [2.639869] * 5 + [3.424530] * 3  # omega R / c_s of a free ball with nu = .25
EXTRA = 6  # modes of the reference beyond those that are compared, which may come in another order
SAME = 0.001  # relative distance of frequencies that are taken as one
REENTRANT = 2 * 0.5445  # an eigenvalue's error falls like h to this where an edge of 270 degrees is free
SAMPLES = 400  # vertices at which shapes are compared


@dataclass(frozen=True)
class Body:
    modes: int  # that are compared
    options: list  # of ritz-reduce
    meshes: dict  # by cell: list of (size h, value of -mesh or a function of the folder that writes a file)
    reference: list  # meshes, the finest last
    known: list = field(default_factory=list)  # frequencies, Hz, in place of the limit of the reference's


def boxes(lengths, cell, grids):
    text = ",".join(map(str, lengths))
    return [(max(a / n for a, n in zip(lengths, grid)), f"box:{text}/{','.join(map(str, grid))}/{cell}")
            for grid in grids]


def gmsh(name, text):
    def write(folder):
        path = folder / f"{name}.msh"
        if not path.exists():
            path.with_suffix(".geo").write_text(text)
            programs.run("gmsh", "-3", "-v", "1", "-o", path, path.with_suffix(".geo"))
        return str(path)
    return write


def spheres(order, sizes):
    return [(size, gmsh(f"sphere-{size}-{order}", SPHERE.format(size=size, order=order))) for size in sizes]


def forks(order, sizes):
    return [(size, gmsh(f"fork-{size}-{order}", f'size = {size};\nInclude "{FORK}";\nMesh.ElementOrder = {order};\n'))
            for size in sizes]


def bodies():
    soft = ["-material_young", "1e6", "-material_poisson", "0.3", "-material_density", "1000"]
    beam, plate = (1, 0.2, 0.15), (1, 1, 0.03)
    beams, plates = [(6, 2, 2), (12, 4, 3), (24, 8, 6)], [(8, 8, 1), (16, 16, 2), (24, 24, 3)]
    young = 1000 * 2 * 1.25 * (2 * np.pi) ** 2  # c_s = 2 pi m/s: Lamb's numbers are then frequencies in Hz
    return {
        "cantilever": Body(6, ["-fix", "xmin", *soft],
                           {cell: boxes(beam, cell, beams) for cell in ("tet4", "tet10", "hex8")},
                           boxes(beam, "hex20", [(6, 2, 2), (12, 4, 4), (24, 8, 8)])),
        "plate": Body(6, ["-fix", "xmin", *soft],
                      {"tet4": boxes(plate, "tet4", plates), "hex8": boxes(plate, "hex8", plates),
                       "tet10": boxes(plate, "tet10", [(4, 4, 1), (8, 8, 1), (16, 16, 1)])},
                      boxes(plate, "hex20", [(5, 5, 1), (10, 10, 2), (20, 20, 4)])),
        "fork": Body(6, ["-fix", "none", "-material_young", "2.06e11", "-material_poisson", "0.29",
                         "-material_density", "7850"],
                     {"tet4": forks(1, [0.004, 0.003, 0.0025]), "tet10": forks(2, [0.004, 0.0025])},
                     forks(2, [0.0014, 0.0011])),
        "sphere": Body(10, ["-fix", "none", "-material_young", repr(young), "-material_poisson", "0.25",
                            "-material_density", "1000"],
                       {"tet4": spheres(1, [0.5, 0.35, 0.25]), "tet10": spheres(2, [0.7, 0.5, 0.35])},
                       spheres(2, [0.25]), LAMB),
    }


@dataclass(frozen=True)
class Solved:
    points: np.ndarray  # n x 3
    shapes: np.ndarray  # k x n x 3, flexible modes
    frequencies: np.ndarray  # Hz
    errors: np.ndarray  # estimated, relative; NaN where they were not asked for


def solve(mesh, options, modes, folder, ranks, estimate):
    output = folder / "study.h5"
    programs.run(programs.built() / "ritz-reduce", "-mesh", mesh, *options, "-modes", modes, "-output", output, "-quiet",
                 *(["-mesh_error"] if estimate else []), under=programs.mpirun(ranks))
    with open(folder / "study.frequencies.csv", encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["kind"] == "flexible"]
    with h5py.File(output) as model:
        body = model["bodies/body"]
        shapes = np.array([body[f"basis/columns/{int(row['index']):04}"][:] for row in rows])
        points = body["geometry/points"][:]
    numbers = lambda name: np.array([float(row.get(name, "nan")) for row in rows])  # noqa: E731
    return Solved(points, shapes, numbers("frequency_hz"), numbers("mesh_error"))


def limits(sizes, levels):
    """The limit of the frequencies of meshes of these sizes: Aitken's of three, of two that at reentrant edges."""
    if len(levels) == 1:
        return levels[0]
    if len(levels) == 2:
        return levels[1] - (levels[0] - levels[1]) / ((sizes[0] / sizes[1])**REENTRANT - 1)
    a, b, c = levels
    first, second = b - a, c - b
    return np.where(np.abs(first) > np.abs(second), c - second**2 / (second - first), c)


def groups(frequencies):
    """Lists of modes whose frequencies are taken as one."""
    found = [[0]]
    for i in range(1, len(frequencies)):
        if frequencies[i] > (1 + SAME) * frequencies[found[-1][0]]:
            found.append([])
        found[-1].append(i)
    return found


def true_frequencies(solved, reference, frequencies):
    """For each mode the frequency of the group of the reference's modes that its shape is most like."""
    chosen = np.linspace(0, len(solved.points) - 1, min(SAMPLES, len(solved.points))).astype(int)
    near = [np.argmin(((reference.points - x) ** 2).sum(axis=1)) for x in solved.points[chosen]]
    flat = lambda shapes: shapes.reshape(len(shapes), -1)  # noqa: E731
    mine, theirs = flat(solved.shapes[:, chosen]), flat(reference.shapes[:, near])
    coordinates = np.linalg.lstsq(theirs.T, mine.T, rcond=None)[0]
    shares = [(coordinates[group] ** 2 * (theirs[group] ** 2).sum(axis=1)[:, None]).sum(axis=0)
              for group in groups(frequencies)]
    means = [frequencies[group].mean() for group in groups(frequencies)]
    return np.array(means)[np.argmax(shares, axis=0)]


def study(name, body, folder, ranks):
    path = lambda mesh: mesh(folder) if callable(mesh) else mesh  # noqa: E731
    levels = [solve(path(mesh), body.options, body.modes + EXTRA, folder, ranks, False) for _, mesh in body.reference]
    count = min(len(level.frequencies) for level in levels)
    frequencies = limits([size for size, _ in body.reference], [level.frequencies[:count] for level in levels])
    if body.known:
        count = min(count, len(body.known))
        print(f"{name}: the reference is off by {np.abs(frequencies[:count] / body.known[:count] - 1).max():.2%} at most")
        frequencies = np.array(body.known[:count])
    reference = Solved(levels[-1].points, levels[-1].shapes[:count], frequencies, np.full(count, np.nan))
    for cell, meshes in body.meshes.items():
        for size, mesh in meshes:
            solved = solve(path(mesh), body.options, body.modes, folder, ranks, True)
            true = solved.frequencies / true_frequencies(solved, reference, frequencies) - 1
            for i in range(body.modes):
                yield {"body": name, "cell": cell, "size": size, "mode": i + 1, "frequency_hz": solved.frequencies[i],
                       "true": true[i], "estimated": solved.errors[i], "effectivity": solved.errors[i] / true[i]}


def printed(rows):
    """One line a mesh: the true and the estimated errors of its modes, and the effectivities."""
    first = rows[0]
    percent = lambda name: " ".join(f"{100 * row[name]:7.2f}" for row in rows)  # noqa: E731
    ratios = " ".join(f"{row['effectivity']:5.2f}" for row in rows)
    return (f"{first['body']:10} {first['cell']:5} {first['size']:7.4g}\n    true %      {percent('true')}\n"
            f"    estimated % {percent('estimated')}\n    effectivity {ratios}")


def draw(rows, path):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    names = list(dict.fromkeys(row["body"] for row in rows))
    figure, axes = plt.subplots(1, len(names), figsize=(3.2 * len(names), 3.4), sharey=True, squeeze=False)
    for axis, name in zip(axes[0], names):
        axis.axhspan(0.5, 2, color="0.92")
        axis.axhline(1, color="0.6", linewidth=0.8)
        for cell, colour in (("tet4", "tab:orange"), ("hex8", "tab:blue"), ("tet10", "tab:green")):
            some = [row for row in rows if row["body"] == name and row["cell"] == cell]
            axis.plot([100 * row["true"] for row in some], [row["effectivity"] for row in some], "o", markersize=3.5,
                      color=colour, label=cell, alpha=0.75)
        axis.set(xscale="log", yscale="log", title=name, xlabel="true error of the frequency, %", ylim=(0.3, 12))
        axis.set_yticks([0.5, 1, 2, 4, 8], ["½", "1", "2", "4", "8"])
        axis.minorticks_off()
    axes[0, 0].set_ylabel("estimated / true error")
    axes[0, 0].legend(frameon=False, fontsize=8)
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--folder", type=Path, default=Path("out/mesh_error"))
    parser.add_argument("--bodies", nargs="+", choices=list(bodies()), default=list(bodies()))
    parser.add_argument("--ranks", type=int, default=2)
    given = parser.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    rows = []
    for name in given.bodies:
        of_mesh = {}
        for row in study(name, bodies()[name], given.folder, given.ranks):
            rows.append(row)
            of_mesh.setdefault((row["cell"], row["size"]), []).append(row)
            if len(of_mesh[row["cell"], row["size"]]) == bodies()[name].modes:
                print(printed(of_mesh[row["cell"], row["size"]]), flush=True)
    with open(given.folder / "mesh_error.csv", "w", encoding="utf-8", newline="") as file:
        table = csv.DictWriter(file, rows[0].keys())
        table.writeheader()
        table.writerows(rows)
    draw(rows, given.folder / "mesh_error.png")


if __name__ == "__main__":
    sys.exit(main())
