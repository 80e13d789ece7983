#!/usr/bin/python3
"""What a step costs through Python, beside the same steps in C++.

    /usr/bin/python3 benchmarks/python.py --bin build/default/bin --module build/default/python [--columns 20]

A cantilever of rubber whose tip is pulled up and down, r columns, 1000 steps. Instance.steps makes 50 of them in one call,
in C++; Instance.step makes one a call. Both take turns, and of each 50 steps the quickest of all rounds counts, by the
thread's own clock, so that other programs disturb little. The bar: a step of the nonlinear model costs at most 1.2
times the one in C++; one of the linear model takes less than a call of Python itself. Both must end in the same state to the last bit.
"""
import argparse
import pathlib
import sys
import tempfile
import time

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "scripts"))

from bench import SOFT, Bench  # noqa: E402
from programs import Failed  # noqa: E402

BEAM = ["-mesh", "box:0.3,0.04,0.03/16,2,2/tet10", "-fix", "xmin", *SOFT, "-polynomial"]
BAR, ROUNDS, CHUNK, STEP = 1.2, 10, 50, 2e-4


def seconds(work):
    began = time.thread_time()
    work()
    return time.thread_time() - began


def compare(equation, integrator, loads, read):
    """Seconds of a step in C++ and through Python, after each of which `read` is called."""
    chunks = np.split(loads, len(loads) // CHUNK)
    taken = np.empty((ROUNDS, len(chunks), 2))

    def one_by_one(moving, rows):
        for load in rows:
            moving.step(load)
            read(moving)

    for of_round in taken:
        in_cpp, through_python = (equation.instance(STEP, integrator) for _ in range(2))
        for of_chunk, chunk in zip(of_round, chunks):
            rows = list(chunk)
            of_chunk[:] = seconds(lambda: in_cpp.steps(chunk)), seconds(lambda: one_by_one(through_python, rows))
        if not np.array_equal(in_cpp.z, through_python.z):
            raise Failed("the two do not end in the same state")
    return taken.min(0).sum(0) / len(loads)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", default="build/default/bin", type=pathlib.Path)
    parser.add_argument("--module", default="build/default/python", type=pathlib.Path)
    parser.add_argument("--columns", default=20, type=int)
    args = parser.parse_args()
    sys.path.insert(0, str(args.module))
    import ritz
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(args.bin, folder)
        modes = max(2, args.columns // 2)
        bench.reduce(*BEAM, "-modes", modes, "-derivatives", modes, "-basis", args.columns, "-quiet", ranks=0)
        body, linear = (ritz.read(bench.folder / "model.h5", forces=forces) for forces in ("stored", "linear"))
    swing = .2 * np.sin(2 * np.pi * np.arange(1, 1001) / 250)
    loads = np.outer(swing, body.unit_force("xmax")[:, 2])
    for equation, integrators in ((body.equation(alpha=.5), ("avf", "implicit-euler", "central-difference")),
                                  (linear.equation(alpha=.5), ("exact",))):
        for integrator in integrators:
            for name, read in (("step(load)", lambda moving: None), ("step(load), z", lambda moving: moving.z)):
                there, here = compare(equation, integrator, loads, read)
                print(f"r = {body.r}, {integrator}, {name}: {1e6 * here:.2f} µs through Python, {1e6 * there:.2f} µs in C++, "
                      f"{here / there:.3f} times ({here / there / BAR:.2f} of the bar)", flush=True)


if __name__ == "__main__":
    try:
        main()
    except Failed as failure:
        sys.exit(str(failure))
