#!/usr/bin/python3
"""200 Newmark steps of a hex8 cantilever at large deflection by ritz-full, beside CalculiX on the same mesh.

    /usr/bin/python3 benchmarks/transient.py --bin build/default/bin [--ranks 2] [--cells 10,2,2] [--integrator newmark]

Every displacement of every step is compared: the two agree to 1e-6 of the largest one. CalculiX's C3D8 has the exact
mass and the plain 2x2x2 rule, ALPHA=0. makes its scheme Newmark's average acceleration, and its tolerance is tightened.
The load grows from 0, so that both start with no acceleration. Exit code 1 when they do not agree.
"""
import argparse
import pathlib
import re
import shutil
import sys
import tempfile

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "scripts"))

import programs  # noqa: E402
from bench import Bench, material  # noqa: E402

YOUNG, POISSON, DENSITY = 1e6, 0.3, 1000.0
STEP, STEPS = 0.01, 200
FORCE = (0.0, 1.5, -4.0)  # N in all, on the end
TABLE = [[0, 0], [0.4, 1], [0.8, 1], [1.0, 0], [2.0, 0.5]]
GATE = 1e-6


def ritz(bench, args):
    bench.write("scene.toml", f'[time]\nstep = {STEP}\nend = {STEP * STEPS}\nintegrator = "{args.integrator}"\n'
                              f'[[load]]\nset = "xmax"\ntotal = {list(FORCE)}\ntable = {TABLE}\n')
    ran = bench.full("-mesh", f"box:1,.1,.1/{args.cells}/hex8", "-fix", "xmin", *material(YOUNG, POISSON, DENSITY),
                     "-scene", "scene.toml", "-every", "1", "-solver", "direct", "-output", "full.h5", ranks=args.ranks)
    points, cells, u = bench.read("full.h5", "points", "cells", "displacement")
    return ran.seconds, points, cells.reshape(-1, 9)[:, 1:] + 1, u


def write_inp(folder, points, cells):
    end = np.flatnonzero(points[:, 0] == points[:, 0].max()) + 1
    with open(folder / "beam.inp", "w") as out:
        out.write("*NODE,NSET=all\n")
        np.savetxt(out, np.c_[np.arange(1, len(points) + 1), points], fmt="%d,%.16g,%.16g,%.16g")
        out.write("*ELEMENT,TYPE=C3D8,ELSET=body\n")
        np.savetxt(out, np.c_[np.arange(1, len(cells) + 1), cells], fmt="%d", delimiter=",")
        out.write("*NSET,NSET=fixed\n")
        np.savetxt(out, np.flatnonzero(points[:, 0] == 0) + 1, fmt="%d,")
        out.write("*NSET,NSET=end\n")
        np.savetxt(out, end, fmt="%d,")
        out.write(f"*MATERIAL,NAME=m\n*ELASTIC\n{YOUNG},{POISSON}\n*DENSITY\n{DENSITY}\n"
                  "*SOLID SECTION,ELSET=body,MATERIAL=m\n*BOUNDARY\nfixed,1,3\n*AMPLITUDE,NAME=a\n")
        out.writelines(f"{t},{f}\n" for t, f in TABLE)
        out.write(f"*STEP,INC={10 * STEPS},NLGEOM\n*DYNAMIC,DIRECT,ALPHA=0.\n{STEP},{STEP * STEPS}\n"
                  "*CONTROLS,PARAMETERS=FIELD\n1e-9\n*CLOAD,AMPLITUDE=a\n")
        out.writelines(f"end,{i + 1},{f / len(end)!r}\n" for i, f in enumerate(FORCE) if f)
        out.write("*NODE PRINT,NSET=all,FREQUENCY=1\nU\n*END STEP\n")


def calculix(ccx, folder, points, cells):
    write_inp(folder, points, cells)
    seconds = programs.run(ccx, "-i", "beam", folder=folder).seconds
    text = (folder / "beam.dat").read_text()
    tables = re.split(r"displacements.*?time +\S+\n", text)[1:]
    rows = [np.array([line.split() for line in table.splitlines() if line.strip()], float) for table in tables]
    return seconds, np.array([table[np.argsort(table[:, 0]), 1:] for table in rows])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", default="build/default/bin", type=pathlib.Path)
    parser.add_argument("--ranks", default=1, type=int)
    parser.add_argument("--cells", default="10,2,2")
    parser.add_argument("--integrator", default="newmark", help="another one than newmark differs by its own error")
    args = parser.parse_args()
    ccx = shutil.which("ccx")
    if not ccx:
        sys.exit("CalculiX (ccx) is not installed")
    with tempfile.TemporaryDirectory() as name:
        bench = Bench(args.bin, name, limit=None)
        ours, points, cells, u = ritz(bench, args)
        theirs, v = calculix(ccx, bench.folder, points, cells)
    if len(v) != STEPS or not np.isfinite(u).all():
        sys.exit(f"CalculiX reached {len(v)} of {STEPS} steps")
    difference = np.abs(u[1:] - v).max(axis=(1, 2)) / np.abs(v).max()
    print(f"{len(points)} vertices, {STEPS} steps, largest displacement {np.abs(v).max():.4f} m of a beam of 1 m")
    print(f"largest difference {difference.max():.1e} of it, at step {difference.argmax() + 1}; {GATE:.0e} is wanted")
    print(f"ritz-full {ours:.1f} s on {args.ranks} rank{'s' * (args.ranks > 1)}, ccx {theirs:.1f} s")
    return 0 if difference.max() <= GATE else 1


if __name__ == "__main__":
    try:
        sys.exit(main())
    except programs.Failed as failure:
        sys.exit(str(failure))
