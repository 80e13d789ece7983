"""What work-precision diagrams are drawn of."""
import math

from report import compare
from report.methods import METHODS

PALETTE = ("#8d99ae", "#e0a458", "#d1495b", "#2e86ab", "#2f3e46", "#6a994e", "#9d4edd", "#00a896")
COLOURS = {method.name: PALETTE[i % len(PALETTE)] for i, method in enumerate(METHODS)}
TITLES = {method.name: method.title for method in METHODS}
MARKS = {"": "o", "exact": "*", "avf": "o", "newmark": "s", "generalized-alpha": "D", "bdf2": "^",
         "implicit-euler": "v", "central-difference": "P"}
LEAST, LARGEST = 1e-6, 3.0  # errors at the edges; crosses stand at the upper one
REAL = dict(color="0.55", linewidth=1, linestyle=":")


def knobs(row):
    return " ".join(f"{name}{row[name]:g}" for name in "kr" if row[name])


def step(row):
    if row["analysis"] == "static":
        return f"1/{1 / row['step']:g}"
    return f"{1e6 * row['step']:g} µs" if row["step"] < 1e-3 else f"{1e3 * row['step']:g} ms"


def size_of(row):
    return row["method"], row["k"], row["r"]


def named(row):
    return ", ".join(filter(None, (TITLES[row["method"]], knobs(row))))


def kind(row):
    single = ["single"] if row["precision"] == "single" else []
    return ", ".join([TITLES[row["method"]], row["integrator"] or "statics", *single])


def one_percent(axes):
    axes.axhline(0.01, color="#2e86ab", linewidth=0.8, alpha=0.6)
    axes.annotate("1 %", (0.004, 0.01), xycoords=("axes fraction", "data"), fontsize=7, color="#2e86ab", va="bottom")


def frame(axes, rows, shown):
    """The Pareto front of all rows, the real-time line, the reference's floor, and a cross for each failure among those
    that are shown."""
    axes.set(xscale="log", yscale="log")
    points = [(row["seconds"], row["error_integrated"]) for row in compare.done(rows)]
    best = [points[i] for i in compare.front(points)]
    axes.step(*zip(*best), where="post", color="0.75", linewidth=6, alpha=0.5, zorder=0,
              label="Pareto front of all runs")
    if rows[0]["analysis"] == "time":
        axes.axvline(rows[0]["end"], **REAL)
        axes.annotate("real time", (rows[0]["end"], 0.98), xycoords=("data", "axes fraction"), rotation=90, fontsize=7,
                      color="0.4", ha="right", va="top")
    floor = max(rows[0]["floor"], LEAST)
    axes.axhline(floor, **REAL)
    axes.annotate("the reference's floor", (0.004, floor), xycoords=("axes fraction", "data"), fontsize=7,
                  color="0.4", va="top")
    bad = [row["seconds"] for row in compare.failed(shown) if row["seconds"] > 0]
    if bad:
        axes.plot(bad, [LARGEST] * len(bad), "x", color="#b00020", clip_on=False, zorder=5,
                  label="failed (time until then)")
    one_percent(axes)
    axes.set_ylim(max(LEAST, 0.5 * min(floor, *(error for _, error in points))), LARGEST)


CLOSE = (0.2, 0.06)  # decades of time and of error within which a second label would cover the first


def line(axes, rows, label, point, labelled):
    """A line through runs, from small to large and coarse to fine, with the quartiles of their time. `point`: what is
    written at a point, unless one of the places in `labelled` is too close; adds its own."""
    good = sorted(compare.done(rows), key=lambda row: (row["k"], row["r"], -row["step"]))
    if not good:
        return
    first = good[0]
    colour, seconds = COLOURS[first["method"]], [row["seconds"] for row in good]
    axes.errorbar(seconds, [row["error_integrated"] for row in good], marker=MARKS[first["integrator"]], color=colour,
                  xerr=[[max(0, row["seconds"] - row["seconds_q1"]) for row in good],
                        [max(0, row["seconds_q3"] - row["seconds"]) for row in good]],
                  linewidth=1, markersize=4, elinewidth=0.8, label=label,
                  linestyle="--" if first["precision"] == "single" else "-")
    for row in good:
        place = math.log10(row["seconds"]), math.log10(row["error_integrated"])
        if any(all(abs(a - b) < width for a, b, width in zip(place, other, CLOSE)) for other in labelled):
            continue
        labelled.append(place)
        axes.annotate(point(row), (row["seconds"], row["error_integrated"]), xytext=(4, 3), textcoords="offset points",
                      fontsize=6.5, color=colour)
