#!/usr/bin/env python3
"""Error of the static path against the size of the model: a rubber cantilever is pulled by its tip, reduced with k modes,
their derivatives and r columns, and compared with the full model. Prints a table and draws it.
  sweep.py BIN [OUT]      BIN: the folder of the programs; OUT: where to work (default: sweep)"""
import csv
import subprocess
import sys
from pathlib import Path

import numpy as np
import ritz

PROBLEM = "-mesh box:1,.1,.1/20,2,2/tet10 -fix xmin -material_young 1e6 -material_poisson .3 -material_density 1000".split()
SCENE = """[static]
steps = 5
[[load]]
set = "xmax"
total = [0, 0, -4]
[[probe]]
name = "tip"
set = "xmax"
"""
SWEEP = [(2, 4), (3, 6), (4, 8), (4, 12), (6, 16), (6, 24)]  # k, r


def run(*words):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(done.stderr)


def full_tip(folder):
    with open(folder / "probes.csv", newline="") as file:
        return np.array([[float(row["tip_ux"]), float(row["tip_uz"])] for row in csv.DictReader(file)])


def sweep(programs, out):
    out.mkdir(parents=True, exist_ok=True)
    (out / "scene.toml").write_text(SCENE)
    run(programs / "ritz-full", *PROBLEM, "-scene", out / "scene.toml", "-output", out / "full.h5", "-quiet")
    truth = full_tip(out)
    rows = []
    for k, r in SWEEP:
        model = out / f"k{k}_r{r}.h5"
        run(programs / "ritz-reduce", *PROBLEM, "-modes", k, "-derivatives", k, "-basis", r, "-polynomial", "-quiet",
            "-output", model)
        tip = ritz.run(out / "scene.toml", model).probes["tip"]
        error = np.abs(tip[:, [0, 2]] - truth).max() / np.abs(truth).max()
        discarded = ritz.read(model).reduction.discarded
        rows.append((k, r, error, discarded))
        print(f"k = {k}  r = {r:2d}  error of the tip {error:.1e}  left out of the basis {discarded:.1e}")
    return rows


def draw(rows, path):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    pyplot.figure(figsize=(5, 3.5))
    pyplot.semilogy([r for _, r, _, _ in rows], [error for _, _, error, _ in rows], "o-")
    for k, r, error, _ in rows:
        pyplot.annotate(f"k = {k}", (r, error), xytext=(4, 4), textcoords="offset points")
    pyplot.xlabel("columns r of the basis")
    pyplot.ylabel("error of the tip / its way")
    pyplot.grid(True, which="both", alpha=.3)
    pyplot.tight_layout()
    pyplot.savefig(path, dpi=150)


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    folder = Path(sys.argv[2] if len(sys.argv) == 3 else "sweep")
    draw(sweep(Path(sys.argv[1]), folder), folder / "sweep.png")
