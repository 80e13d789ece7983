#!/usr/bin/env python3
"""A reduced model of your own displacements: here those of a beam that bends into arcs, as a formula has them. NumPy writes
them, ritz-reduce makes a basis of them (POD), and the model tells how near it comes to arcs that it has not seen.
  pod.py BIN [OUT]      BIN: the folder of the programs; OUT: where to work (default: pod)"""
import subprocess
import sys
from pathlib import Path

import numpy as np
import ritz

PROBLEM = "-mesh box:1,.05,.05/20,1,1/tet10 -fix xmin -material_young 1e6 -material_poisson 0 -material_density 1000".split()
SEEN, UNSEEN = np.linspace(.1, 1.5, 15), np.array([.25, .75, 1.25])  # how far the end turns, rad


def run(*words):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(done.stderr)


def arc(points, angle):
    """Displacements, (3n,), of a beam along x of length 1 m whose middle line becomes an arc, and whose end turns."""
    x, y, z = points.T
    turn, height = angle * x, z - points[:, 2].mean()
    u = np.stack([np.sin(turn) / angle - height * np.sin(turn) - x, 0 * y, (1 - np.cos(turn)) / angle + height * (np.cos(turn) - 1)], 1)
    return u.ravel()


def missed(U, u):
    """The part of u that no U z reaches, relative."""
    return np.linalg.norm(u - U @ np.linalg.lstsq(U, u, rcond=None)[0]) / np.linalg.norm(u)


def pod(programs, out):
    out.mkdir(parents=True, exist_ok=True)
    run(programs / "ritz-reduce", *PROBLEM, "-modes", 1, "-quiet", "-output", out / "mesh.h5")
    points = ritz.read(out / "mesh.h5").points
    np.save(out / "snapshots.npy", [arc(points, angle) for angle in SEEN])  # (snapshots, 3n), the mesh file's order
    rows = []
    for r in (1, 2, 4, 6):
        model = out / f"r{r}.h5"
        run(programs / "ritz-reduce", *PROBLEM, "-modes", 0, "-snapshots", out / "snapshots.npy", "-basis", r, "-polynomial",
            "-quiet", "-output", model)
        body = ritz.read(model)
        far = max(missed(body.U, arc(points, angle)) for angle in UNSEEN)
        rows.append((r, far, body.reduction.discarded / np.linalg.norm(body.reduction.singular_values)))
        print(f"r = {r}  arcs that were not seen are missed by {far:.1e}  left out of the snapshots {rows[-1][2]:.1e}")
    return rows


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    pod(Path(sys.argv[1]), Path(sys.argv[2] if len(sys.argv) == 3 else "pod"))
