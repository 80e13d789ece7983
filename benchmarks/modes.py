#!/usr/bin/python3
"""20 modes of clamped beams by ritz-reduce on 1 and 2 ranks, beside CalculiX on the same mesh in the same run.

    /usr/bin/python3 benchmarks/modes.py --bin build/default/bin [--sizes 30000,100000] [--cells tet10,tet4] [--csv F]

Whole programs against whole programs: seconds on the wall, peak memory over all processes, and the ratio to ccx (one
thread). Frequencies are compared as well: a fast wrong answer is no answer. CalculiX integrates its mass with fewer
points, so they agree to a few 1e-3 only. Beside them, what -plan promises of both, over what was measured.
"""
import argparse
import csv
import pathlib
import re
import shutil
import sys
import tempfile

import h5py
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "scripts"))

import programs  # noqa: E402
from bench import Bench  # noqa: E402

MATERIAL = dict(young=1e9, poisson=0.3, density=1000.0)
MODES = 20


def grid(cells, unknowns):
    """The 4:1:1 beam whose degrees of freedom come nearest to so many."""
    steps = 2 if cells == "tet10" else 1
    n = min(range(1, 200), key=lambda n: abs(3 * (4 * steps * n + 1) * (steps * n + 1) ** 2 - unknowns))
    return f"box:4,1,1/{4 * n},{n},{n}/{cells}"


def reduce(bench, mesh, ranks):
    words = ["-mesh", mesh, "-fix", "xmin", "-modes", MODES, "-output", "model.h5", "-summary", "summary.json",
             *(word for name, value in MATERIAL.items() for word in (f"-material_{name}", value))]
    bench.reduce(*words, "-plan", ranks=ranks)
    plan = bench.summary("summary.json")["plan"]
    seconds = bench.reduce(*words, ranks=ranks).seconds
    summary = bench.summary("summary.json")
    return dict(seconds=seconds, memory=summary["memory"]["all_ranks"] / 1e9,
                stages={row["stage"]: row["seconds"] for row in summary["stages"]},
                frequencies=summary["modes"]["frequency_hz"],
                plan_seconds=plan["seconds"], plan_memory=plan["memory"]["all_ranks"] / 1e9)


def write_inp(folder):
    """The mesh that ritz-reduce has just written, as CalculiX reads it."""
    with h5py.File(folder / "model.h5") as model:
        points = model["VTKHDF/Points"][:]
        size = int(model["VTKHDF/Offsets"][1])
        cells = model["VTKHDF/Connectivity"][:].reshape(-1, size) + 1
    kind = {4: "C3D4", 8: "C3D8", 10: "C3D10"}[size]
    with open(folder / "beam.inp", "w") as out:
        out.write("*NODE\n")
        np.savetxt(out, np.c_[np.arange(1, len(points) + 1), points], fmt="%d,%.16g,%.16g,%.16g")
        out.write(f"*ELEMENT,TYPE={kind},ELSET=body\n")
        np.savetxt(out, np.c_[np.arange(1, len(cells) + 1), cells], fmt="%d", delimiter=",")
        out.write("*NSET,NSET=fixed\n")
        np.savetxt(out, np.flatnonzero(points[:, 0] == 0) + 1, fmt="%d,")
        out.write(f"*MATERIAL,NAME=m\n*ELASTIC\n{MATERIAL['young']},{MATERIAL['poisson']}\n*DENSITY\n"
                  f"{MATERIAL['density']}\n*SOLID SECTION,ELSET=body,MATERIAL=m\n*BOUNDARY\nfixed,1,3\n"
                  f"*STEP\n*FREQUENCY\n{MODES}\n*END STEP\n")


def calculix(folder, limit):
    """Nothing where it is not installed, or takes longer than `limit`."""
    ccx = shutil.which("ccx")
    if not ccx:
        return None
    write_inp(folder)
    try:
        ran = programs.measured(ccx, "-i", "beam", folder=folder, limit=limit)
    except programs.Failed as failure:
        print(f"{failure.reason}; it is left out", flush=True)
        return None
    table = re.findall(r"^ +\d+ +\S+ +\S+ +(\S+) +0\.0000000E\+00$", (folder / "beam.dat").read_text(), re.M)
    return dict(seconds=ran.seconds, memory=ran.memory / 1e9, frequencies=[float(f) for f in table])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", default="build/default/bin", type=pathlib.Path)
    parser.add_argument("--sizes", default="30000,100000,300000")
    parser.add_argument("--cells", default="tet10,tet4")
    parser.add_argument("--limit", default=600, type=float, help="seconds that ccx may take")
    parser.add_argument("--csv", type=pathlib.Path)
    args = parser.parse_args()
    rows = []
    print(f"{'mesh':34} {'program':10} {'seconds':>8} {'GB':>6} {'ccx/this':>9} {'memory/ccx':>10} {'assembly s':>10} "
          f"{'plan s':>8} {'/this':>6} {'plan GB':>8} {'/this':>6}")
    for cells in args.cells.split(","):
        for size in map(int, args.sizes.split(",")):
            mesh = grid(cells, size)
            with tempfile.TemporaryDirectory() as name:
                bench = Bench(args.bin, name, limit=None)
                runs = {f"{n} rank{'s' * (n > 1)}": reduce(bench, mesh, n) for n in (1, 2)}
                peer = calculix(bench.folder, args.limit)
            for program, run in {**runs, **({"ccx": peer} if peer else {})}.items():
                speed = peer["seconds"] / run["seconds"] if peer else float("nan")
                memory = run["memory"] / peer["memory"] if peer else float("nan")
                assembly = run.get("stages", {}).get("assemble", float("nan"))
                plan_seconds, plan_memory = (run.get(f"plan_{what}", float("nan")) for what in ("seconds", "memory"))
                print(f"{mesh:34} {program:10} {run['seconds']:8.1f} {run['memory']:6.2f} {speed:9.2f} {memory:10.2f} "
                      f"{assembly:10.2f} {plan_seconds:8.1f} {plan_seconds / run['seconds']:6.2f} {plan_memory:8.2f} "
                      f"{plan_memory / run['memory']:6.2f}", flush=True)
                rows.append(dict(mesh=mesh, program=program, seconds=run["seconds"], gigabytes=run["memory"],
                                 speed_over_ccx=speed, memory_over_ccx=memory, assembly_seconds=assembly,
                                 plan_seconds=plan_seconds, plan_gigabytes=plan_memory))
            if peer:
                n = min(len(peer["frequencies"]), MODES)
                ours, theirs = (np.array(f[:n]) for f in (runs["1 rank"]["frequencies"], peer["frequencies"]))
                print(f"{'':34} frequencies differ by at most {np.max(np.abs(ours / theirs - 1)):.1e}")
            print(f"{'':34} assembly on 2 ranks: "
                  f"{runs['1 rank']['stages']['assemble'] / runs['2 ranks']['stages']['assemble']:.2f} times as fast")
    if args.csv:
        with open(args.csv, "w", newline="") as out:
            table = csv.DictWriter(out, rows[0].keys())
            table.writeheader()
            table.writerows(rows)


if __name__ == "__main__":
    try:
        main()
    except programs.Failed as failure:
        sys.exit(str(failure))
