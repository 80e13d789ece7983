#!/usr/bin/env python3
"""Draws a sheet of mode shapes: the deformed surface, coloured by the size of its displacement, over the shape at rest.

    plot_modes.py model.h5 frequencies.csv sheet.png [--modes 12]

Reads the model with VTK's own reader of VTKHDF and needs no display.
"""
import argparse
import csv
import math

import h5py
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
TURN, TILT = math.radians(28), math.radians(18)  # of the eye, about the long axis and above it
LIGHT = np.array([0.3, 0.5, 0.81])
COLOURS = plt.get_cmap("plasma")


def read_surface(path):
    """The boundary's vertices (n x 3), triangles (m x 3), and point vectors by name, curved cells finely divided."""
    reader = vtkHDFReader()
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


def read_frequencies(path):
    with open(path, newline="") as file:
        table = csv.DictReader(file)
        if not {"kind", "frequency_hz"} <= set(table.fieldnames or ()):
            raise SystemExit(f"{path} is not a table of frequencies, as ritz-reduce writes it beside its model")
        return [(row["kind"], float(row["frequency_hz"])) for row in table]


def refuse_another_model(model, table, modes):
    """Whether the table is the one of this model shows in every frequency."""
    with h5py.File(model) as file:
        stored = [np.sqrt(body["modes/eigenvalues"][:]) / (2 * math.pi)
                  for body in file["bodies"].values() if "modes" in body]
    hertz = np.array([frequency for _, frequency in modes])
    close = lambda own: len(own) == len(hertz) and np.allclose(own, hertz, rtol=1e-6, atol=1e-6 * own.max(initial=0))  # noqa: E731
    if not any(map(close, stored)):
        raise SystemExit(f"{table} is the table of another model than {model}: its frequencies are others")


def eye(points):
    """An orthonormal frame (rows: right, up, towards the eye), the body's longest axis upright, its thinnest away."""
    spread = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2]
    up, right = (axis * np.sign(axis[np.argmax(abs(axis))]) for axis in spread[:2])
    away = np.cross(right, up)
    right, away = math.cos(TURN) * right - math.sin(TURN) * away, math.sin(TURN) * right + math.cos(TURN) * away
    up, away = math.cos(TILT) * up - math.sin(TILT) * away, math.sin(TILT) * up + math.cos(TILT) * away
    return np.array([right, up, away])


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
    width = height * max(aspect, 0.45)
    rows = math.ceil(count / max(1, int(10 // width)))
    return rows, math.ceil(count / rows), (width, height)


def draw(points, faces, shapes, path):
    """`shapes`: pairs of a title and a point vector."""
    frame = eye(points)
    seen = np.concatenate([points] + [swung(points, shape) for _, shape in shapes]) @ frame.T
    low, high = seen[:, :2].min(axis=0), seen[:, :2].max(axis=0)
    rows, columns, (width, height) = panels(len(shapes), (high[0] - low[0]) / (high[1] - low[1]))
    figure, grid = plt.subplots(rows, columns, squeeze=False, layout="constrained",
                                figsize=(columns * width + 0.9, rows * (height + 0.3)))
    for axes in grid.flat:
        axes.set_axis_off()
    for axes, (title, shape) in zip(grid.flat, shapes):
        paint_mode(axes, frame, points, faces, shape)
        axes.set_title(title, fontsize=11)
        axes.set(aspect="equal", xlim=(low[0], high[0]), ylim=(low[1], high[1]))
    scale = plt.cm.ScalarMappable(cmap=COLOURS)
    figure.colorbar(scale, ax=grid, shrink=0.5, aspect=30, label="displacement / its maximum")
    figure.savefig(path, dpi=100)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("model")
    parser.add_argument("frequencies")
    parser.add_argument("picture")
    parser.add_argument("--modes", type=int, default=12, help="how many flexible modes to draw, the lowest first")
    options = parser.parse_args()

    points, faces, vectors = read_surface(options.model)
    shapes = [vectors[name] for name in sorted(vectors) if name.startswith("mode_")]
    modes = read_frequencies(options.frequencies)
    refuse_another_model(options.model, options.frequencies, modes)
    if len(modes) != len(shapes):
        raise SystemExit(f"{options.model} holds {len(shapes)} modes and {options.frequencies} lists {len(modes)}")
    flexible = [(f"{hertz:.1f} Hz", shape) for (kind, hertz), shape in zip(modes, shapes) if kind == "flexible"]
    if not flexible:
        raise SystemExit(f"{options.model} has no flexible mode to draw")
    draw(points, faces, flexible[:options.modes], options.picture)


if __name__ == "__main__":
    main()
