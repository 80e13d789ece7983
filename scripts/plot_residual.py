#!/usr/bin/env python3
"""Draws how the static answer to a load on a bracket's lug converges with the columns of the basis: modes alone, and with
residual vectors.

    plot_residual.py BIN picture.png [--ranks 2]

BIN holds the programs; Gmsh makes the mesh of config/bracket.geo. The table that is drawn is printed.
"""
import argparse
import tempfile
from pathlib import Path

import matplotlib

from bench import Bench, summary
import programs

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of backend)

GEOMETRY = Path(__file__).resolve().parents[1] / "config/bracket.geo"
STEEL = ["-material_young", "2.06e11", "-material_poisson", ".29", "-material_density", "7850"]
MODES = (1, 2, 4, 7, 10, 20, 40)
COLOURS = {"modes alone": "#9aa3ad", "with residual vectors of the lug": "#d1495b"}


def lug_error(bench, modes, words, ranks):
    """Columns of the basis, and what of the worst load on the lug and of gravity it misses."""
    bench.reduce("-mesh", "bracket.msh", "-fix", "bolts", *STEEL, "-modes", modes, *words, "-quiet", "-summary", "s.json",
                 ranks=ranks)
    told = summary(bench.folder / "s.json")
    worst = {row["set"]: max(x for x in row["missing"] if x is not None) for row in told["static_errors"]}
    columns = told["basis"]["columns"] if told["basis"] else len(told["modes"]["kind"])
    return columns, worst["lug"], worst[None]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs")
    parser.add_argument("picture")
    parser.add_argument("--ranks", type=int, default=2)
    asked = parser.parse_args()
    runs = {}
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(asked.programs, folder)
        programs.run("gmsh", "-3", "-v", "1", "-setnumber", "size", "0.009", "-o", bench.folder / "bracket.msh", GEOMETRY)
        for name, words in zip(COLOURS, ([], ["-residual_vectors", "lug"])):
            runs[name] = [lug_error(bench, modes, words, asked.ranks) for modes in MODES]
            for columns, lug, gravity in runs[name]:
                print(f"{name}: {columns} columns, lug {lug:.2e}, gravity {gravity:.2e}")
    figure, (of_lug, of_gravity) = plt.subplots(1, 2, figsize=(9, 3.6), sharey=True)
    for name, rows in runs.items():
        columns, lug, gravity = zip(*rows)
        of_lug.semilogy(columns, lug, "o-", color=COLOURS[name], label=name)
        of_gravity.semilogy(columns, gravity, "o-", color=COLOURS[name], label=name)
    of_lug.set_title("a load on the lug, worst direction")
    of_gravity.set_title("gravity, worst direction")
    of_lug.set_ylabel("missing of the static answer, energy norm")
    for axes in (of_lug, of_gravity):
        axes.set_xlabel("columns of the basis")
        axes.grid(True, alpha=.3)
    of_lug.legend(frameon=False)
    figure.tight_layout()
    figure.savefig(asked.picture, dpi=130)


if __name__ == "__main__":
    main()
