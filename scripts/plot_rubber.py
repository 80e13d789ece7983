#!/usr/bin/env python3
"""Draws a reduced motion beside the full one and prints how far apart they are.

    plot_rubber.py model.h5 motion.h5 full.h5 picture.png [--shapes 6] [--title TEXT] [--twist]

Both motions must have a frame at the same times. Errors are relative in the M-norm: ||u_r - u||_M / ||u||_M.
"""
import argparse
import itertools

import h5py
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of backend)
from matplotlib.collections import PolyCollection  # noqa: E402

TET10, SIZE = 38, 10  # XDMF's number of a quadratic tetrahedron, and its vertices
EDGES = [(0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3)]  # whose middles are the vertices 4 ... 9
COLOURS = {"full": "#9aa3ad", "reduced": "#d1495b"}
WIDTH, PLOT = 12, 3.2  # of the picture, and the height of a plot below the shapes, inches
LIGHT = np.array([-0.35, 0.6, 0.72])


class Motion:
    """times (f), points (n x 3), u (f x n x 3), cells (m x 10), vertices in the order of their numbers."""

    def __init__(self, path):
        with h5py.File(path) as file:
            if "frame_times" not in file and "displacement" not in file:
                raise SystemExit(f"{path}: it has no frames to draw")
            order = np.argsort(file["vertex_ids"][:])
            self.points = file["points"][:][order].astype(float)
            self.u = file["displacement"][:][:, order].astype(float)
            self.times = file["frame_times" if "frame_times" in file else "times"][:]
            table = file["cells"][:].reshape(-1, SIZE + 1)
        if not (table[:, 0] == TET10).all():
            raise SystemExit(f"{path}: this script draws Tet10 meshes")
        place = np.empty_like(order)
        place[order] = np.arange(len(order))
        self.cells = place[table[:, 1:]]


def mass_product(motion):
    """M v of vectors (n x 3), of unit density: the exact 10 x 10 mass of straight-sided cells."""
    corners = motion.points[motion.cells[:, :4]]
    volumes = abs(np.linalg.det(corners[:, 1:] - corners[:, :1])) / 6
    element = np.full((10, 10), -6.0)  # corner with an edge opposite
    element[:4, :4] = 1 + 5 * np.eye(4)
    for (i, a), (j, b) in itertools.product(enumerate(EDGES), repeat=2):
        element[4 + i, 4 + j] = {2: 32, 1: 16, 0: 8}[len(set(a) & set(b))]
    for i, edge in enumerate(EDGES):
        element[4 + i, list(edge)] = element[list(edge), 4 + i] = -4

    def product(v):
        result = np.zeros_like(v)
        np.add.at(result, motion.cells, np.einsum("c,ab,cbx->cax", volumes / 420, element, v[motion.cells]))
        return result
    return product


def inside_out(motion, u):
    """How many cells have det(I + grad u) <= 0 at a vertex or in their middle."""
    corners = motion.points[motion.cells[:, :4]]
    slopes = np.linalg.inv(corners[:, 1:] - corners[:, :1])  # columns: gradients of the barycentric 1, 2, 3
    flat = np.concatenate([-slopes.sum(axis=2, keepdims=True), slopes], axis=2).transpose(0, 2, 1)  # m x 4 x 3
    x = (motion.points + u)[motion.cells]
    at = np.concatenate([np.eye(4), [(np.eye(4)[a] + np.eye(4)[b]) / 2 for a, b in EDGES], np.full((1, 4), 0.25)])
    bad = np.zeros(len(motion.cells), bool)
    for b in at:
        gradients = np.concatenate([(4 * b - 1)[None, :, None] * flat] +
                                   [4 * (b[i] * flat[:, [j]] + b[j] * flat[:, [i]]) for i, j in EDGES], axis=1)
        bad |= np.linalg.det(np.einsum("cax,cay->cxy", x, gradients)) <= 0
    return int(bad.sum())


def angles(motion):
    """How far the end at x max has turned about x, degrees, in every frame: the best rotation in the plane."""
    end = motion.points[:, 0] > motion.points[:, 0].max() - 1e-9
    rest = motion.points[end][:, 1:] - motion.points[end][:, 1:].mean(axis=0)
    now = motion.points[end][None, :, 1:] + motion.u[:, end, 1:]
    now = now - now.mean(axis=1, keepdims=True)
    sine = (rest[:, 0] * now[:, :, 1] - rest[:, 1] * now[:, :, 0]).sum(axis=1)
    return np.degrees(np.unwrap(np.arctan2(sine, (rest * now).sum(axis=(1, 2)))))


def surface(cells):
    """The boundary's triangles (m x 3), four to a curved face, turned outwards."""
    faces = {}
    for cell in cells:
        for corners in ((0, 1, 3), (1, 2, 3), (2, 0, 3), (0, 2, 1)):
            middle = [cell[4 + EDGES.index(tuple(sorted((corners[i], corners[(i + 1) % 3]))))] for i in range(3)]
            a, b, c = (cell[i] for i in corners)
            d, e, f = middle
            key = tuple(sorted((a, b, c)))
            if faces.pop(key, None) is None:
                faces[key] = ((a, d, f), (d, b, e), (f, e, c), (d, e, f))
    return np.array([triangle for four in faces.values() for triangle in four])


def paint(axes, frame, points, faces, colour):
    corners = (points @ frame.T)[faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    front = np.flatnonzero(normals[:, 2] > 0)
    front = front[np.argsort(corners[front, :, 2].mean(axis=1))]
    light = 0.45 + 0.55 * np.clip(normals[front] @ LIGHT, 0, 1)
    shaded = np.array(matplotlib.colors.to_rgb(colour)) * light[:, None]
    edges = 0.88 * shaded
    axes.add_collection(PolyCollection(corners[front][:, :, :2], facecolors=shaded, edgecolors=edges, linewidths=0.3))


def eye(turn=25, tilt=22):
    """Rows: right, up, towards the eye; x runs to the right, z upwards, seen from in front and above; degrees."""
    turn, tilt = np.radians(turn), np.radians(tilt)
    right = np.array([np.cos(turn), np.sin(turn), 0])
    away = np.array([np.sin(turn) * np.cos(tilt), -np.cos(turn) * np.cos(tilt), np.sin(tilt)])
    return np.array([right, np.cross(away, right), away])


def draw(reduced, full, chosen, curves, title, path):
    frame, faces = eye(), surface(full.cells)
    seen = np.concatenate([(m.points + m.u[i]) @ frame.T for m in (reduced, full) for i in chosen])
    low, high = seen[:, :2].min(axis=0) - 0.01, seen[:, :2].max(axis=0) + 0.01
    width, height = high - low
    shapes = 2 * (WIDTH / len(chosen) * height / width) + 0.9
    figure = plt.figure(figsize=(WIDTH, shapes + PLOT), layout="constrained")
    top, bottom = figure.subfigures(2, 1, height_ratios=[shapes, PLOT])
    figure.suptitle(title, fontsize=13)
    grid = top.subplots(2, len(chosen), squeeze=False)
    for row, (name, motion) in zip(grid, (("full", full), ("reduced", reduced))):
        for axes, i in zip(row, chosen):
            paint(axes, frame, motion.points + motion.u[i], faces, COLOURS[name])
            axes.set(aspect="equal", xlim=(low[0], high[0]), ylim=(low[1], high[1]), xticks=[], yticks=[])
            axes.set_frame_on(False)
            if name == "full":
                axes.set_title(f"t = {full.times[i]:.3g} s", fontsize=10)
        row[0].set_ylabel(name, fontsize=12, color=COLOURS[name])
    plots = bottom.subplots(1, len(curves), squeeze=False)[0]
    for axes, (label, of_full, of_reduced) in zip(plots, curves):
        axes.plot(full.times, of_full, color=COLOURS["full"], linewidth=4, label="full")
        axes.plot(reduced.times, of_reduced, color=COLOURS["reduced"], linewidth=1.4, label="reduced")
        for i in chosen:
            axes.axvline(full.times[i], color="0.85", linewidth=0.8, zorder=0)
        axes.set(xlabel="time, s", ylabel=label, xlim=(0, full.times[-1]))
        axes.grid(alpha=0.25)
    plots[0].legend(frameon=False)
    figure.savefig(path, dpi=90)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name in ("model", "motion", "full", "picture"):
        parser.add_argument(name)
    parser.add_argument("--shapes", type=int, default=6, help="how many times are drawn")
    parser.add_argument("--title", default="Reduced beside full")
    parser.add_argument("--twist", action="store_true", help="look at the angle of the end at x max, not at its place")
    options = parser.parse_args()

    reduced, full = Motion(options.motion), Motion(options.full)
    if len(reduced.times) != len(full.times) or not np.allclose(reduced.times, full.times):
        raise SystemExit(f"{options.motion} and {options.full} have frames at different times")
    product = mass_product(full)
    norm = lambda v: np.sqrt(max(0.0, np.vdot(v, product(v))))  # noqa: E731
    wide = [norm(a - b) for a, b in zip(reduced.u, full.u)]
    size = [norm(v) for v in full.u]
    print(f"error over the whole motion: {np.linalg.norm(wide) / np.linalg.norm(size):.2%} in the M-norm; "
          f"at worst {max(wide) / max(size):.2%} of the largest displacement")

    with h5py.File(options.model) as file:  # a motion's vertices stand in the model's order
        U = file["bodies/body/basis/U"][:]
        U = U.reshape(-1, 3, U.shape[1])[np.argsort(file["bodies/body/geometry/vertex_ids"][:])]
    columns = [np.ascontiguousarray(U[:, :, i]) for i in range(U.shape[2])]
    weighed = [product(c) for c in columns]
    gram = np.array([[np.vdot(a, b) for b in weighed] for a in columns])

    def floor(v):
        """The error of the best that the basis can do."""
        z = np.linalg.solve(gram, [np.vdot(c, v) for c in weighed])
        return norm(v - sum(a * c for a, c in zip(z, columns))) / norm(v)

    tip = full.points[:, 0] > full.points[:, 0].max() - 1e-9
    if options.twist:
        turned = angles(full), angles(reduced)
        print(f"the end turns by {turned[0].max():.1f} degrees (full), {turned[1].max():.1f} degrees (reduced)")
        for angle in (90, 180, 270):
            if turned[0].max() < angle:
                print(f"at {angle:3d} degrees: the full model does not get there")
                continue
            i, j = (int(np.argmax(t >= angle)) for t in turned)
            there = "the reduced model never gets there"
            if turned[1].max() >= angle:
                there = (f"error {norm(reduced.u[j] - full.u[i]) / norm(full.u[i]):.1%} where each first gets there "
                         f"({full.times[i]:.3f} s, {full.times[j]:.3f} s)")
            print(f"at {angle:3d} degrees: {there}; at the same time {wide[i] / size[i]:.1%}; "
                  f"the basis at its best {floor(full.u[i]):.1%}")
        curves = [("turn of the end, degrees", *turned)]
    else:
        a, b = (1e3 * m.u[:, tip].mean(axis=1) for m in (full, reduced))
        most = np.linalg.norm(a, axis=1).max()
        print(f"the tip: at most {np.linalg.norm(b - a, axis=1).max():.2f} mm apart, of a way of {most:.1f} mm; "
              f"the basis at its best {max(floor(v) for v in full.u[1:] if norm(v) > 0.1 * max(size)):.2%}")
        curves = [(f"{axis} of the tip, mm", a[:, i], b[:, i]) for i, axis in ((2, "z"), (1, "y"))]
    worst = [max(inside_out(m, u) for u in m.u[::5]) for m in (full, reduced)]
    print(f"cells inside out, at worst: {worst[0]} (full), {worst[1]} (reduced) of {len(full.cells)}")
    chosen = np.linspace(0, len(full.times) - 1, options.shapes + 1).astype(int)[1:]
    draw(reduced, full, chosen, curves, options.title, options.picture)


if __name__ == "__main__":
    main()
