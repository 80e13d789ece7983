#!/usr/bin/env python3
"""Draws a sheet of mode shapes: the deformed surface, coloured by the size of its displacement, over the shape at rest.

    plot_modes.py model.h5 sheet.png [--modes 12]

Each shape is titled by its array, such as "mode 07, 440.0 Hz", and seen from where most of its motion is in sight. Reads
the model with VTK's own reader of VTKHDF and needs no display.
"""
import argparse
import math
import os

import matplotlib
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkIOHDF import vtkHDFReader

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of backend)
from matplotlib.collections import PolyCollection  # noqa: E402

SWING = 0.07  # largest drawn displacement, as a part of the body's diagonal
# Of the eye, degrees about the long axis and above it; the first of those that show nearly as much as the best is taken.
EYES = [(turn, tilt) for tilt in (18, 50, -18) for turn in (28, 62, 118, 152, 208, 242, 298, 332)]
NEARLY = 0.8
PIXELS = 60  # along the longer side of the picture in which is counted what hides what
LIGHT = np.array([0.3, 0.5, 0.81])
COLOURS = plt.get_cmap("plasma")


def read_surface(path):
    """The boundary's vertices (n x 3), triangles (m x 3), and point vectors by name, curved cells finely divided."""
    reader = vtkHDFReader()
    if not (os.path.isfile(path) and reader.CanReadFile(path)):
        raise SystemExit(f"{path} is not a model that VTK can read")
    reader.SetFileName(path)
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputConnection(reader.GetOutputPort())
    surface.SetNonlinearSubdivisionLevel(2)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(surface.GetOutputPort())
    triangles.Update()
    mesh = triangles.GetOutput()
    if mesh.GetNumberOfPolys() == 0:
        raise SystemExit(f"{path}: VTK finds no surface to draw")
    data = mesh.GetPointData()
    vectors = {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)) for i in range(data.GetNumberOfArrays())}
    faces = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return vtk_to_numpy(mesh.GetPoints().GetData()).astype(float), faces, vectors


def eye(points, turn, tilt):
    """An orthonormal frame (rows: right, up, towards the eye), the body's longest axis upright. Without a turn and a tilt
    the thinnest axis points at the eye."""
    spread = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2]
    up, right = (axis * np.sign(axis[np.argmax(abs(axis))]) for axis in spread[:2])
    away = np.cross(right, up)
    turn, tilt = math.radians(turn), math.radians(tilt)
    right, away = math.cos(turn) * right - math.sin(turn) * away, math.sin(turn) * right + math.cos(turn) * away
    up, away = math.cos(tilt) * up - math.sin(tilt) * away, math.sin(tilt) * up + math.cos(tilt) * away
    return np.array([right, up, away])


def spread(corners, pixel):
    """Points (n x 3) all over triangles (m x 3 x 3), at most a pixel apart."""
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    parts = 2**np.ceil(np.log2(np.clip(longest / pixel, 1, 2 * PIXELS))).astype(int)
    points = []
    for n in np.unique(parts):
        i, j = np.nonzero(np.add.outer(np.arange(n), np.arange(n)) < n)
        weights = np.stack([i + 1 / 3, j + 1 / 3, n - i - j - 2 / 3], axis=1) / n
        points.append((weights @ corners[parts == n]).reshape(-1, 3))
    return np.concatenate(points)


def in_sight(frame, points, faces):
    """Of the triangles those that the eye sees, and how large they look: they face it, and their middle is not behind
    another one's."""
    corners = (points @ frame.T)[faces]
    looks = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])[:, 2] / 2
    front = np.flatnonzero(looks > 0)
    corners = corners[front]
    low, extent = corners.min(axis=(0, 1))[:2], np.ptp(corners[:, :, :2], axis=(0, 1)).max()
    pixel = extent / PIXELS

    def places(where):
        columns, rows = np.floor((where[:, :2] - low) / pixel).astype(int).T
        return columns * (PIXELS + 1) + rows
    surface, middles = spread(corners, pixel), corners.mean(axis=1)
    nearest = np.full((PIXELS + 1)**2, -np.inf)
    np.maximum.at(nearest, places(surface), surface[:, 2])
    seen = middles[:, 2] >= nearest[places(middles)] - 2 * pixel
    return front[seen], looks[front[seen]]


class Eyes:
    """The frames from which a body may be looked at."""

    def __init__(self, points, faces):
        self.faces = faces
        self.frames = [eye(points, *angles) for angles in EYES]
        self.sights = [in_sight(frame, points, faces) for frame in self.frames]

    def best(self, shape):
        """Where the motion across the line of sight, squared and over the picture, is nearly at its most."""
        def shown(frame, sight):
            seen, looks = sight
            return looks @ ((shape[self.faces[seen]].mean(axis=1) @ frame[:2].T)**2).sum(axis=1)
        amounts = [shown(*pair) for pair in zip(self.frames, self.sights)]
        return self.frames[next(i for i, amount in enumerate(amounts) if amount >= NEARLY * max(amounts))]


def visible(corners):
    """Which triangles (m x 3 x 3, in the eye's frame) look at the eye, far ones first, and how the light falls on them."""
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    front = np.flatnonzero(normals[:, 2] > 0)
    order = front[np.argsort(corners[front, :, 2].mean(axis=1))]
    return order, 0.45 + 0.55 * np.clip(normals[order] @ LIGHT, 0, 1)


def paint(axes, frame, points, faces, colours):
    """`colours`: a row of red, green, blue for each face."""
    corners = (points @ frame.T)[faces]
    order, light = visible(corners)
    shaded = colours[order] * light[:, None]
    axes.add_collection(PolyCollection(corners[order][:, :, :2], facecolors=shaded, edgecolors=shaded, linewidths=0.25))


def swung(points, shape):
    """The body at the end of its swing: of the two ends, the one where it takes more room."""
    size = np.linalg.norm(shape, axis=1).max()
    swing = shape * (SWING * np.linalg.norm(np.ptp(points, axis=0)) / size)
    return max((points + swing, points - swing), key=lambda ends: np.linalg.norm(np.ptp(ends, axis=0)))


def paint_mode(axes, frame, points, faces, shape):
    size = np.linalg.norm(shape, axis=1)
    paint(axes, frame, points, faces, np.full((len(faces), 3), 0.9))
    paint(axes, frame, swung(points, shape), faces, COLOURS(size[faces].mean(axis=1) / size.max())[:, :3])


def panels(count, aspect):
    """Rows, columns and the size (inches) of a panel of this width over height."""
    height = 3.0
    width = height * max(aspect, 0.5)
    rows = math.ceil(count / max(1, int(10 // width)))
    return rows, math.ceil(count / rows), (width, height)


def draw(points, faces, shapes, path):
    """`shapes`: pairs of a title and a point vector. All are drawn to one scale."""
    eyes = Eyes(points, faces)
    frames = [eyes.best(shape) for _, shape in shapes]
    boxes = []
    for frame, (_, shape) in zip(frames, shapes):
        seen = np.concatenate([points, swung(points, shape)]) @ frame.T
        boxes.append((seen[:, :2].min(axis=0), seen[:, :2].max(axis=0)))
    room = np.max([high - low for low, high in boxes], axis=0)
    rows, columns, (width, height) = panels(len(shapes), room[0] / room[1])
    figure, grid = plt.subplots(rows, columns, squeeze=False, layout="constrained",
                                figsize=(columns * width + 0.9, rows * (height + 0.3)))
    for axes in grid.flat:
        axes.set_axis_off()
    for axes, frame, (low, high), (title, shape) in zip(grid.flat, frames, boxes, shapes):
        paint_mode(axes, frame, points, faces, shape)
        axes.set_title(title, fontsize=9)
        (left, bottom), (right, top) = (low + high - room) / 2, (low + high + room) / 2
        axes.set(aspect="equal", xlim=(left, right), ylim=(bottom, top))
    scale = plt.cm.ScalarMappable(cmap=COLOURS)
    figure.colorbar(scale, ax=grid, shrink=0.5, aspect=30, label="displacement / its maximum")
    figure.savefig(path, dpi=100)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("model")
    parser.add_argument("picture")
    parser.add_argument("--modes", type=int, default=12, help="how many flexible modes to draw, the lowest first")
    options = parser.parse_args()

    points, faces, vectors = read_surface(options.model)
    shapes = [(name, vectors[name]) for name in sorted(vectors)
              if name.startswith(("mode ", "column ")) and not name.endswith(", rigid")]
    if not shapes:
        raise SystemExit(f"{options.model} has no flexible mode to draw")
    draw(points, faces, shapes[:options.modes], options.picture)


if __name__ == "__main__":
    main()
