#!/usr/bin/env python3
"""Draws the layers and what they use, as CMakeLists.txt states them: draw_layers.py [docs/layers.png]

A layer stands above all that it uses; an arrow is drawn to what no other of its layers already uses."""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
MPI = {"format_mpi", "parallel", "algebra", "mesh", "stages", "config", "app"}
WIDTH, HEIGHT = 1.7, .55  # of a box


def layers(text):
    """{layer: [the layers it uses]}, of the lines ritz_layer(NAME … USES … LIBRARIES …)."""
    found = {}
    for name, rest in re.findall(r"^ *ritz_layer\((\w+)([^)]*)\)", text, re.MULTILINE):
        uses = re.search(r"USES ([\w ]+?)(?: LIBRARIES|$)", rest.strip())
        found[name] = uses.group(1).split() if uses else []
    return found


def reached(uses, name):
    return {name}.union(*(reached(uses, other) for other in uses[name]))


def direct(uses, name):
    """What of uses[name] is not used through another of them."""
    return [a for a in uses[name] if not any(a in reached(uses, b) for b in uses[name] if b != a)]


def depth(uses, name):
    return 1 + max((depth(uses, other) for other in uses[name]), default=-1)


def places(uses):
    """{layer: (x, y)}: rows by depth, each row centred."""
    rows = {}
    for name in uses:
        rows.setdefault(depth(uses, name), []).append(name)
    return {name: ((i - (len(row) - 1) / 2) * 2, y) for y, row in rows.items() for i, name in enumerate(row)}


def draw(uses, output):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    at = places(uses)
    figure, axes = pyplot.subplots(figsize=(9, 9))
    for name, (x, y) in at.items():
        for other in direct(uses, name):
            ox, oy = at[other]
            axes.annotate("", (ox, oy + HEIGHT / 2), (x, y - HEIGHT / 2), zorder=1,
                          arrowprops={"arrowstyle": "->", "color": "#888"})
        colour = "#ffe3c2" if name in MPI else "#cfe8ff"
        axes.add_patch(pyplot.Rectangle((x - WIDTH / 2, y - HEIGHT / 2), WIDTH, HEIGHT, facecolor=colour, edgecolor="#555",
                                        zorder=2))
        axes.text(x, y, name, ha="center", va="center", fontsize=11, zorder=3)
    axes.set_title("Layers of ritz: arrows to what is used. Blue: serial, no MPI; orange: on many ranks", fontsize=11)
    axes.autoscale_view()
    axes.axis("off")
    figure.savefig(output, dpi=110, bbox_inches="tight")


if __name__ == "__main__":
    draw(layers((ROOT / "CMakeLists.txt").read_text()), sys.argv[1] if len(sys.argv) > 1 else ROOT / "docs/layers.png")
