#!/usr/bin/python3
"""A beam of 150,000 degrees of freedom through all nonlinear stages, beside its bars; and how memory grows.

    /usr/bin/python3 benchmarks/nonlinear.py --bin build/default/bin [--ranks 2]

20 modes, their 210 derivatives, 30 columns, the polynomial. The bars: 60 s in all, 20 s after the modes, 4 GB over all
ranks. The same with 10 modes' 55 derivatives says what the other 155 cost: streamed, they would cost no memory. The
modes' seconds are what the rest is measured against, and -plan's promises are held against what came.
"""
import argparse
import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "scripts"))

from bench import Bench  # noqa: E402
from programs import Failed  # noqa: E402

BEAM = ["-mesh", "box:0.3,0.3,1/24,24,80/tet4", "-fix", "zmin", "-material_young", "1e7", "-material_poisson", ".45",
        "-material_density", "1000", "-modes", "20", "-basis", "30", "-polynomial"]
WHOLE, AFTER, MEMORY = 60.0, 20.0, 4.0  # the bars: s, s, GB


def run(where, ranks, derivatives):
    """Seconds of the whole program and of each stage, GB over all ranks; GB and seconds that -plan promises."""
    words = [*BEAM, "-derivatives", derivatives, "-summary", "summary.json"]
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(where, folder, limit=None)
        bench.reduce(*words, "-plan", ranks=ranks)
        plan = bench.summary("summary.json")["plan"]
        seconds = bench.reduce(*words, ranks=ranks).seconds
        whole = bench.summary("summary.json")
    stages = [(row["stage"], row["seconds"]) for row in whole["stages"]]
    return seconds, stages, *(of["all_ranks"] / 1e9 for of in (whole["memory"], plan["memory"])), plan["seconds"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", default="build/default/bin", type=pathlib.Path)
    parser.add_argument("--ranks", default=2, type=int)
    args = parser.parse_args()
    for derivatives in (10, 20):
        seconds, stages, memory, plan_memory, plan_seconds = run(args.bin, args.ranks, derivatives)
        names = [name for name, _ in stages]
        after = sum(s for _, s in stages[names.index("modes") + 1:])
        modes = stages[names.index("modes")][1]
        pairs = derivatives * (derivatives + 1) // 2
        print(f"{pairs} derivatives: {', '.join(f'{name} {s:.1f} s' for name, s in stages)}")
        print(f"  whole {seconds:.1f} s ({seconds / WHOLE:.2f} of its bar), after the modes {after:.1f} s "
              f"({after / AFTER:.2f} of its bar, {after / modes:.2f} of the modes), {memory:.2f} GB "
              f"({memory / MEMORY:.2f} of its bar)\n"
              f"  -plan: {plan_seconds:.1f} s ({plan_seconds / seconds:.2f} of what was measured), "
              f"{plan_memory:.2f} GB ({plan_memory / memory:.2f})", flush=True)


if __name__ == "__main__":
    try:
        main()
    except Failed as failure:
        sys.exit(str(failure))
