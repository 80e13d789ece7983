"""Pictures of rows of runs.csv and over_time.csv, as matplotlib figures."""
import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams.update({"svg.fonttype": "none", "font.size": 9, "axes.grid": True, "grid.alpha": 0.25,
                            "legend.frameon": False, "legend.fontsize": 8})
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of backend)

from report import compare  # noqa: E402
from report.methods import METHODS  # noqa: E402

COLOURS = dict(zip((method.name for method in METHODS), ("#8d99ae", "#e0a458", "#d1495b", "#2e86ab", "#2f3e46", "#6a994e")))
TITLES = {method.name: method.title for method in METHODS}
MARKS = {"": "o", "exact": "*", "avf": "o", "newmark": "s", "generalized-alpha": "D", "bdf2": "^", "implicit-euler": "v",
         "central-difference": "P"}
LARGEST = 3.0  # the error at the upper edge; crosses stand there
REAL = dict(color="0.6", linewidth=1, linestyle=":")


def knobs(row):
    return " ".join(f"{name}{row[name]:g}" for name in "kr" if row[name])


def seconds(value):
    return f"{1e3 * value:g} ms" if value < 1 else f"{value:g} s"


def work_precision(rows):
    """Two diagrams: the size of the model at one step, and the step and the integrator at one size."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(12.5, 5.2), sharey=True, layout="constrained")
    for axes, sweep, lines in ((left, "basis", by_method), (right, "step", by_integrator)):
        frame(axes, rows)
        for line in lines([row for row in rows if row["sweep"] == sweep or row["method"] == "full"]):
            draw_line(axes, line, knobs if sweep == "basis" else lambda row: seconds(row["step"]))
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.13), ncols=3)
    left.set(title="The size of the model, at one step", ylabel="time-integrated error, relative (M-norm)")
    right.set(title="The step and the integrator, at one size")
    return figure


def by_method(rows):
    """Lines: label, colour, mark, rows."""
    for name in TITLES:
        chosen = [row for row in rows if row["method"] == name]
        for integrator in dict.fromkeys(row["integrator"] for row in chosen):
            if name == "full" and integrator not in ("avf", ""):
                continue
            line = [row for row in chosen if row["integrator"] == integrator]
            yield TITLES[name], COLOURS[name], MARKS[integrator], line


def by_integrator(rows):
    for row_kind in dict.fromkeys((row["method"], row["integrator"], row["precision"]) for row in rows):
        line = [row for row in rows if (row["method"], row["integrator"], row["precision"]) == row_kind]
        method, integrator, precision = row_kind
        if method in ("linear_polynomial", "pod"):
            continue
        yield f"{TITLES[method]}, {integrator or 'statics'}{', single' if precision == 'single' else ''}", \
            COLOURS[method], MARKS[integrator], line


def frame(axes, rows):
    """Axes, the Pareto front, the real-time line, the reference's floor, and a cross for each failure."""
    good = compare.done(rows)
    axes.set(xscale="log", yscale="log", xlabel="time of stepping, s")
    points = [(row["seconds"], row["error_integrated"]) for row in good]
    best = [points[i] for i in compare.front(points)]
    axes.step(*zip(*best), where="post", color="0.75", linewidth=6, alpha=0.5, zorder=0, label="Pareto front")
    if rows[0]["analysis"] == "time":
        axes.axvline(rows[0]["end"], **REAL)
        axes.annotate("real time", (rows[0]["end"], 0.02), xycoords=("data", "axes fraction"), rotation=90, fontsize=7,
                      color="0.4", ha="right")
    axes.axhline(rows[0]["floor"], **REAL)
    axes.annotate("the reference's floor", (0.99, rows[0]["floor"]), xycoords=("axes fraction", "data"), fontsize=7,
                  color="0.4", va="bottom", ha="right")
    bad = [row for row in compare.failed(rows) if row["seconds"] > 0]
    if bad:
        axes.plot([row["seconds"] for row in bad], [LARGEST] * len(bad), "x", color="#b00020", clip_on=False, zorder=5,
                  label="failed (time until then)")
    axes.axhline(0.01, color="#2e86ab", linewidth=0.8, alpha=0.5)
    axes.annotate("1 %", (0.005, 0.01), xycoords=("axes fraction", "data"), fontsize=7, color="#2e86ab", va="bottom")
    axes.set_ylim(top=LARGEST)


def draw_line(axes, line, label_of):
    label, colour, mark, rows = line
    good = sorted(compare.done(rows), key=lambda row: (row["k"], row["r"], -row["step"]))
    if not good:
        return
    style = "--" if "single" in label else "-"
    axes.errorbar([row["seconds"] for row in good], [row["error_integrated"] for row in good], marker=mark, color=colour,
                  xerr=[[max(0, row["seconds"] - row["seconds_q1"]) for row in good],
                        [max(0, row["seconds_q3"] - row["seconds"]) for row in good]],
                  linewidth=1, markersize=4, elinewidth=0.8, label=label, linestyle=style)
    for row in good:
        axes.annotate(label_of(row), (row["seconds"], row["error_integrated"]), xytext=(4, 3),
                      textcoords="offset points", fontsize=6, color=colour)


def over_time(rows, frames):
    """The error of the best run of each method at the basis sweep's step, over time."""
    figure, axes = plt.subplots(figsize=(8, 4.2), layout="constrained")
    for name, title in TITLES.items():
        chosen = [row for row in compare.done(rows) if row["method"] == name and row["sweep"] == "basis"]
        if not chosen:
            continue
        row = min(chosen, key=lambda row: row["error_integrated"])
        line = [(frame["t"], frame["error"]) for frame in frames if frame["key"] == row["key"]]
        axes.plot(*zip(*line), color=COLOURS[name], label=f"{title}, {knobs(row)}")
    axes.set(yscale="log", ylabel="‖u − v‖_M / max ‖v‖_M", xlabel="t, s" if rows[0]["analysis"] == "time" else "load fraction")
    axes.legend(loc="best")
    return figure


def parts(rows):
    """The error's parts, a group of bars a run: mesh, basis, time."""
    chosen = [row for row in compare.done(rows) if row["sweep"] == "basis"]
    figure, axes = plt.subplots(figsize=(max(7, 0.42 * len(chosen)), 4), layout="constrained")
    for shift, (column, colour, label) in enumerate((("error_mesh", "#adb5bd", "mesh"), ("error_basis", "#d1495b", "basis"),
                                                     ("error_time", "#2e86ab", "time step"))):
        axes.bar([i + 0.27 * (shift - 1) for i in range(len(chosen))], [row[column] for row in chosen], 0.25, color=colour,
                 label=label)
    axes.axhline(rows[0]["floor"], label="the reference's floor", **REAL)
    axes.set_xticks(range(len(chosen)), [f"{TITLES[row['method']]}\n{knobs(row)}" for row in chosen], rotation=60,
                    ha="right", fontsize=7)
    axes.set(yscale="log", ylabel="relative error")
    axes.legend()
    return figure
