"""What work-precision diagrams are drawn of."""
from matplotlib.transforms import Bbox

from report import compare
from report.methods import METHODS

PALETTE = ("#8d99ae", "#e0a458", "#d1495b", "#2e86ab", "#6a994e", "#9d4edd", "#2f3e46", "#00a896")
COLOURS = {method.name: PALETTE[i % len(PALETTE)] for i, method in enumerate(METHODS)}
TITLES = {method.name: method.title for method in METHODS}
MARKS = {"": "o", "exact": "*", "avf": "o", "newmark": "s", "generalized-alpha": "D", "bdf2": "^",
         "implicit-euler": "v", "central-difference": "P", "linearly-implicit": "X"}
LEAST, LARGEST = 1e-6, 3.0  # errors at the edges; crosses stand at the upper one
REAL = dict(color="0.55", linewidth=1, linestyle=":")


def knobs(row):
    return " ".join(f"{name}{row[name]:g}" for name in "krT" if row[name])


def step(row):
    if row["analysis"] == "static":
        return f"1/{1 / row['step']:g}"
    return f"{1e6 * row['step']:g} µs" if row["step"] < 1e-3 else f"{1e3 * row['step']:g} ms"


def size_of(row):
    return row["method"], row["k"], row["r"], row["T"]


def named(row):
    return ", ".join(filter(None, (TITLES[row["method"]], knobs(row))))


def kind(row):
    single = ["single"] if row["precision"] == "single" else []
    return ", ".join([TITLES[row["method"]], row["integrator"] or "statics", *single])


def one_percent(axes):
    axes.axhline(0.01, color="#2e86ab", linewidth=0.8, alpha=0.6)
    axes.annotate("1 %", (1.004, 0.01), xycoords=("axes fraction", "data"), fontsize=7, color="#2e86ab", va="center")


def frame(axes, rows, shown):
    """The Pareto front of all rows as far as the reference tells errors, the real-time line, the reference's floor, and a cross for each failure among those
    that are shown."""
    axes.set(xscale="log", yscale="log")
    points = [(row["seconds"], max(row["error_integrated"], row["floor"])) for row in compare.done(rows)]
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
    axes.set_ylim(max(LEAST, 0.5 * min(floor, *(row["error_integrated"] for row in compare.done(rows)))), LARGEST)


def line(axes, rows, label, point):
    """A line through runs, from small to large and coarse to fine, with the quartiles of their time. Returns what `point`
    says of each, as labels for `place`."""
    good = sorted(compare.done(rows), key=lambda row: (row["k"], row["r"], row["T"], -row["step"]))
    if not good:
        return []
    first = good[0]
    colour, seconds = COLOURS[first["method"]], [row["seconds"] for row in good]
    axes.errorbar(seconds, [row["error_integrated"] for row in good], marker=MARKS[first["integrator"]], color=colour,
                  xerr=[[max(0, row["seconds"] - row["seconds_q1"]) for row in good],
                        [max(0, row["seconds_q3"] - row["seconds"]) for row in good]],
                  linewidth=1, markersize=4, elinewidth=0.8, label=label,
                  linestyle="--" if first["precision"] == "single" else "-")
    return [(point(row), row["seconds"], row["error_integrated"], colour) for row in good]


SIDES = ((4, 3, "left", "bottom"), (-4, 3, "right", "bottom"), (4, -3, "left", "top"), (-4, -3, "right", "top"),
         (0, 5, "center", "bottom"), (0, -5, "center", "top"))


POINT = 4  # pixels of a marker that no label may cover


def place(axes, labels):
    """Writes labels (text, x, y, colour) beside their points, first come first served: on the first side where one covers
    no other text of the axes and no point, and does not leave them. Where there is none it is left out. The figure
    is laid out, and all else is in the axes."""
    renderer, inside = axes.figure.canvas.get_renderer(), axes.get_window_extent()
    taken = [text.get_window_extent(renderer) for text in axes.texts]
    points = axes.transData.transform([(x, y) for _, x, y, _ in labels]) if labels else []
    taken += [Bbox.from_bounds(x - POINT / 2, y - POINT / 2, POINT, POINT) for x, y in points]
    for text, x, y, colour in labels:
        note = axes.annotate(text, (x, y), xytext=(0, 0), textcoords="offset points", fontsize=6.5, color=colour)
        note.set_in_layout(False)
        for right, up, ha, va in SIDES:
            note.set(position=(right, up), ha=ha, va=va)
            box = note.get_window_extent(renderer).padded(1)
            if inside.containsx(box.x0) and inside.containsx(box.x1) and inside.containsy(box.y0) \
                    and inside.containsy(box.y1) and not any(map(box.overlaps, taken)):
                taken.append(box)
                break
        else:
            note.remove()
