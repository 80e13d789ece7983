#!/usr/bin/env python3
"""Draws the shape that a cubature's model takes under a load beside the full one, and the cells that the cubature has.

    plot_cubature.py model.h5 motion.h5 full.h5 picture.png [--title TEXT]

Both motions must have a frame at the same load fractions, and probes.csv beside them. Printed are the probes' distances
and the error in the M-norm, ||u_r - u||_M / ||u||_M, of the last frame.
"""
import argparse
from pathlib import Path

import h5py
import matplotlib
import numpy as np

import plot_modes
from bench import table
from plot_rubber import COLOURS, EDGES, SIZE, Motion, eye, mass_product, surface

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of backend)
from matplotlib.colors import LogNorm  # noqa: E402

SCALE = plt.get_cmap("plasma")
FACES = [(0, 1, 3), (1, 2, 3), (2, 0, 3), (0, 2, 1)]
MARGIN = .004  # m around a shape


class Cells:
    """points (n x 3), cells (m x 10) of a model, and which of them its cubature has (T), with what weights."""

    def __init__(self, path):
        with h5py.File(path) as file:
            body = file["bodies/body"]
            if "cubature" not in body:
                raise SystemExit(f"{path}: it has no cubature to draw")
            self.points = body["geometry/points"][:]
            self.cells = body["geometry/cells/vertices"][:].reshape(-1, SIZE)
            cubature = body["cubature"]
            self.weights, starts = cubature["weights"][:], cubature["starts"][:-1]
            volumes, U = cubature["volumes"][:], body["basis/U"][:]
            gradients = cubature["gradients"][:].reshape(len(volumes), 9, -1)
        of_cubature = np.add.reduceat(volumes[:, None, None] * gradients, starts).reshape(len(starts), -1)
        self.chosen = self.nearest(of_cubature, self.integrals(U.reshape(len(self.points), 3, -1)))

    def integrals(self, U):
        """The integrals of the gradients of U over all cells (m x 9r): volumes times the gradients in their middles."""
        corners = self.points[self.cells[:, :4]]
        edges = corners[:, 1:] - corners[:, :1]
        slopes = np.linalg.inv(edges)  # columns: gradients of the barycentric 1, 2, 3
        flat = np.concatenate([-slopes.sum(axis=2, keepdims=True), slopes], axis=2).transpose(0, 2, 1)
        shapes = np.stack([flat[:, i] + flat[:, j] for i, j in EDGES], axis=1)  # those of corners vanish there
        volumes = abs(np.linalg.det(edges)) / 6
        return np.einsum("c,cej,ceir->cjir", volumes, shapes, U[self.cells[:, 4:]]).reshape(len(self.cells), -1)

    @staticmethod
    def nearest(wanted, given):
        """A model does not say where in its geometry a cubature's cells stand; the gradients there tell it."""
        found = np.array([int(np.argmin(np.linalg.norm(given - row, axis=1))) for row in wanted])
        if len(set(found)) < len(found):
            raise SystemExit("two cells of the cubature look alike: this mesh is too coarse or too curved to draw")
        return found


def probes(motion):
    """Load fractions, and by name the displacements (f x 3) in the table beside a motion."""
    path = Path(motion)
    stem = "" if path.stem in ("motion", "full") else path.stem + "."
    names, rows = table(path.with_name(stem + "probes.csv"))
    return rows[:, 0], {name.removesuffix("_ux"): rows[:, i:i + 3]
                        for i, name in enumerate(names) if name.endswith("_ux")}


def draw_cells(axes, frame, cells):
    """The body at rest, and through it the cells of the cubature by their weights. Returns what the colours mean."""
    faces, shade = surface(cells.cells), LogNorm(cells.weights.min(), cells.weights.max())
    plot_modes.paint(axes, frame, cells.points, faces, np.full((len(faces), 3), .93))
    plot_modes.paint(axes, frame, cells.points, cells.cells[cells.chosen][:, FACES].reshape(-1, 3),
                     np.repeat(SCALE(shade(cells.weights))[:, :3], len(FACES), axis=0))
    axes.set_title(f"the {len(cells.chosen)} of {len(cells.cells)} cells of the cubature")
    return matplotlib.cm.ScalarMappable(shade, SCALE)


def draw_shapes(axes, frame, motions):
    """The last shapes, by displacement. Returns what the colours mean."""
    lengths = [1e3 * np.linalg.norm(motion.u[-1], axis=1) for motion in motions.values()]
    shade, faces = plt.Normalize(0, np.max(lengths)), surface(motions["full"].cells)
    for one, (name, motion), length in zip(axes, motions.items(), lengths):
        plot_modes.paint(one, frame, motion.points + motion.u[-1], faces,
                         SCALE(shade(length[faces].mean(axis=1)))[:, :3])
        one.set_title(name)
    return matplotlib.cm.ScalarMappable(shade, SCALE)


def draw(cells, motions, tables, title, path):
    frame = eye(turn=-35, tilt=35)
    seen = np.concatenate([m.points @ frame.T for m in motions.values()] +
                          [(m.points + m.u[-1]) @ frame.T for m in motions.values()])
    low, high = seen[:, :2].min(axis=0) - MARGIN, seen[:, :2].max(axis=0) + MARGIN
    figure = plt.figure(figsize=(12, 7), layout="constrained")
    figure.suptitle(title, fontsize=13)
    above, below = figure.subfigures(2, 1, height_ratios=[1.5, 1])
    at_rest, *bent = above.subplots(1, 3)
    above.colorbar(draw_cells(at_rest, frame, cells), ax=at_rest, orientation="horizontal", shrink=.7,
                   label="weight of a cell")
    above.colorbar(draw_shapes(bent, frame, motions), ax=bent, orientation="horizontal", shrink=.5,
                   label="displacement, mm")
    for axes in (at_rest, *bent):
        axes.set(aspect="equal", xlim=(low[0], high[0]), ylim=(low[1], high[1]), xticks=[], yticks=[])
        axes.set_frame_on(False)
    probed = tables["full"][1]
    for axes, name in zip(below.subplots(1, len(probed), squeeze=False)[0], probed):
        for (which, (fractions, places)), style in zip(tables.items(), ({"linewidth": 5}, {"marker": "o"})):
            axes.plot(fractions, 1e3 * np.linalg.norm(places[name], axis=1), label=which, color=COLOURS[which], **style)
        axes.set(xlabel="load fraction", ylabel="displacement, mm",
                 title=f"probe '{name}': in the end {apart(probed[name][-1], tables['reduced'][1][name][-1]):.1%} apart")
        axes.grid(alpha=.25)
        axes.legend(frameon=False)
    figure.savefig(path, dpi=90)


def apart(of_full, of_reduced):
    return np.linalg.norm(of_reduced - of_full) / np.linalg.norm(of_full)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name in ("model", "motion", "full", "picture"):
        parser.add_argument(name)
    parser.add_argument("--title", default="Reduced by cubature, beside full")
    options = parser.parse_args()

    cells, reduced, full = Cells(options.model), Motion(options.motion), Motion(options.full)
    of_full, of_reduced = probes(options.full), probes(options.motion)
    if len(reduced.times) != len(full.times) or not np.allclose(reduced.times, full.times):
        raise SystemExit(f"{options.motion} and {options.full} have frames at different load fractions")
    product = mass_product(full)
    norm = lambda v: np.sqrt(np.vdot(v, product(v)))  # noqa: E731
    print(f"a cubature of {len(cells.chosen)} of {len(cells.cells)} cells; error under the whole load: "
          f"{norm(reduced.u[-1] - full.u[-1]) / norm(full.u[-1]):.2%} in the M-norm")
    for name, u in of_full[1].items():
        v = of_reduced[1][name]
        print(f"probe {name}: {1e3 * np.linalg.norm(v[-1] - u[-1]):.2f} mm apart of {1e3 * np.linalg.norm(u[-1]):.1f} mm, "
              f"{apart(u[-1], v[-1]):.1%}")
    draw(cells, {"full": full, "reduced": reduced}, {"full": of_full, "reduced": of_reduced}, options.title,
         options.picture)


if __name__ == "__main__":
    main()
