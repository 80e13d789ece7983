"""Pictures of rows of runs.csv and over_time.csv, as matplotlib figures."""
import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams.update({"svg.fonttype": "none", "font.size": 9, "axes.grid": True, "grid.alpha": 0.25,
                            "legend.frameon": False, "legend.fontsize": 8, "axes.titlesize": 10})
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of backend)
import numpy as np  # noqa: E402

from report import compare, diagram  # noqa: E402
from report.diagram import COLOURS, MARKS, TITLES, named, size_of  # noqa: E402


def work_precision(rows):
    """Two diagrams: the size of the model at one step; the step and the integrator at one size."""
    figure, (above, below) = plt.subplots(2, 1, figsize=(11, 9.5), sharex=True, sharey=True, layout="constrained")
    swept = {size_of(row) for row in rows if row["sweep"] == "step"}
    full = [row for row in rows if row["method"] == "full" and row["integrator"] in ("avf", "")]
    sizes = [row for row in rows if row["sweep"] == "basis" and row["method"] != "full"] + full
    steps = [row for row in rows if size_of(row) in swept and row["method"] not in ("linear_polynomial", "pod")]
    diagram.frame(above, rows, sizes)
    of_sizes, of_steps = [], []
    for method in dict.fromkeys(row["method"] for row in sizes):
        line = [row for row in sizes if row["method"] == method]
        of_sizes += diagram.line(above, line, TITLES[method], diagram.step if method == "full" else diagram.knobs)
    above.set_title(f"The size of the model, at a step of {diagram.step(sizes[0])}", loc="left")
    diagram.frame(below, rows, steps)
    for kind in dict.fromkeys((row["method"], row["integrator"], row["precision"]) for row in steps):
        line = [row for row in steps if (row["method"], row["integrator"], row["precision"]) == kind]
        of_steps += diagram.line(below, line, diagram.kind(line[0]), diagram.step)
    below.set_title("The step and the integrator, at one size of each model", loc="left")
    for axes in (above, below):
        axes.legend(loc="upper left", bbox_to_anchor=(1.03, 1.0))
        axes.set_ylabel("time-integrated error, relative (M-norm)")
    below.set_xlabel("time of stepping through the scene, s")
    figure.draw_without_rendering()
    diagram.place(above, of_sizes)
    diagram.place(below, of_steps)
    return figure


def best_sizes(rows):
    """Of each method the run of the basis sweep with the least error."""
    for name in TITLES:
        chosen = [row for row in compare.done(rows) if row["method"] == name and row["sweep"] == "basis"]
        if chosen:
            yield min(chosen, key=lambda row: row["error_integrated"])


def over_time(rows, frames):
    """The best run of each method at the basis sweep's step."""
    figure, axes = plt.subplots(figsize=(11, 4.2), layout="constrained")
    for row in best_sizes(rows):
        line = [(frame["t"], frame["error"]) for frame in frames if frame["key"] == row["key"] and frame["error"] > 0]
        if line:
            axes.plot(*zip(*line), color=COLOURS[row["method"]], label=named(row),
                      marker="o" if len(line) < 3 else None)
    axes.set(yscale="log", ylabel="‖u − v‖_M / max ‖v‖_M",
             xlabel="t, s" if rows[0]["analysis"] == "time" else "load fraction",
             title="Error over time: of each method its best size")
    axes.legend(loc="upper left", bbox_to_anchor=(1.03, 1.0))
    return figure


MOST_STEPS = 1e6


def spent(row, steps):
    """Seconds that so many steps take, with all that is done before them."""
    before = 0.0 if row["method"] == "full" else row["precompute_seconds"]
    return before + 1e-6 * row["microseconds"] * steps


def break_even(rows):
    """What so many steps cost with all that was done before them; where a reduced model's line meets the full one's,
    it is paid back."""
    figure, axes = plt.subplots(figsize=(11, 4.2), layout="constrained")
    steps = np.geomspace(1.0, MOST_STEPS, 200)
    for row in best_sizes(rows):
        paid = compare.break_even(row, rows)
        after = f"\npaid back after {paid:.0f} steps" if paid <= MOST_STEPS else ""
        label = f"{named(row)} ({compare.told(row)} off){after}"
        axes.plot(steps, spent(row, steps), color=COLOURS[row["method"]], label=label)
        if after:
            axes.plot(paid, spent(row, paid), marker="o", color=COLOURS[row["method"]])
    axes.set(xscale="log", yscale="log", xlabel="steps", ylabel="s, precomputation and training included",
             title="Steps after which a reduced model is paid back: of each method its best size")
    axes.legend(loc="upper left", bbox_to_anchor=(1.03, 1.0))
    return figure


PARTS = (("error_mesh", "#adb5bd", "mesh"), ("error_basis", "#d1495b", "basis"), ("error_time", "#2e86ab", "time step"))
LEAST = 1e-5  # relative errors below are not drawn


def parts(rows):
    """The error's parts, three bars a run."""
    chosen = [row for row in compare.done(rows) if row["sweep"] == "basis" and row["method"] != "full"]
    figure, axes = plt.subplots(figsize=(11, 1.2 + 0.27 * len(chosen)), layout="constrained")
    for shift, (column, colour, label) in enumerate(PARTS):
        axes.barh([i + 0.27 * (shift - 1) for i in range(len(chosen))], [max(row[column], LEAST) for row in chosen],
                  0.25, color=colour, label=label)
    axes.axvline(rows[0]["floor"], label="the reference's floor", **diagram.REAL)
    axes.set_yticks(range(len(chosen)), [named(row) for row in chosen])
    axes.set(xscale="log", xlabel="relative error", xlim=(LEAST, None),
             title="The error's parts, one refined at a time")
    axes.invert_yaxis()
    axes.legend(loc="upper left", bbox_to_anchor=(1.03, 1.0))
    return figure


def over_load(rows):
    """Of scenes that differ in how strong their loads are: the error of each run's size over the load's factor."""
    figure, axes = plt.subplots(figsize=(11, 4.2), layout="constrained")
    chosen = [row for row in compare.done(rows)
              if row["sweep"] == "basis" and row["method"] in ("linear", "derivatives")]
    ends = []
    for method, size in dict.fromkeys((row["method"], diagram.knobs(row)) for row in chosen):
        line = sorted((row["load_factor"], row["error_integrated"]) for row in chosen
                      if (row["method"], diagram.knobs(row)) == (method, size))
        axes.plot(*zip(*line), color=COLOURS[method], marker=MARKS["avf"], markersize=4, linewidth=1)
        ends.append((size, *line[-1], COLOURS[method]))
    for method in dict.fromkeys(row["method"] for row in chosen):
        axes.plot([], [], color=COLOURS[method], label=TITLES[method])
    floors = sorted({(row["load_factor"], row["floor"]) for row in chosen})
    axes.plot(*zip(*floors), label="the reference's floor", **diagram.REAL)
    diagram.one_percent(axes)
    enough = compare.enough_until(rows, "linear", 0.01)
    until = "" if np.isnan(enough) else f": within 1 % up to {enough:.2g} times the load"
    axes.set(xscale="log", yscale="log", xlabel="factor of the load", ylabel="time-integrated error, relative",
             title=f"Where linear stops being enough{until}")
    axes.margins(x=0.08)
    axes.legend(loc="upper left", bbox_to_anchor=(1.03, 1.0))
    figure.draw_without_rendering()
    diagram.place(axes, ends)
    return figure
