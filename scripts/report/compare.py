"""What rows of runs.csv say together: fronts, the time to reach an error, steps that pay a model back."""
import math


def done(rows):
    return [row for row in rows if row["status"] == "done"]


def failed(rows):
    return [row for row in rows if row["status"] != "done"]


def front(points):
    """The indices of the (cost, error) pairs that no other one beats in both, cheap ones first."""
    best, indices = math.inf, []
    for index in sorted(range(len(points)), key=lambda i: points[i]):
        if points[index][1] < best:
            best = points[index][1]
            indices.append(index)
    return indices


def to_reach(rows, error):
    """Of the runs that are at most so wrong, the cheapest; None where there is none, and where the reference itself is not
    so sure: an error below its floor tells nothing."""
    good = [row for row in done(rows) if max(row["error_integrated"], row["floor"]) <= error]
    return min(good, key=lambda row: row["seconds"], default=None)


def time_to(rows, error):
    """In words: the time of the cheapest run that is at most so wrong, or how near the best one comes."""
    row = to_reach(rows, error)
    if row:
        return f"{row['seconds']:.3g} s"
    if not done(rows):
        return "failed" if rows else "–"
    return f"{told(min(done(rows), key=lambda row: row['error_integrated']))} at best"


def told(row):
    """A run's error in words, as far as the reference tells it."""
    below = row["error_integrated"] < row["floor"]
    return f"below {percent(row['floor'])}" if below else percent(row["error_integrated"])


def percent(share):
    if math.isnan(share):
        return "–"
    return f"{100 * share:.0f} %" if share >= 0.095 else f"{100 * share:.2g} %"


def reach(rows, titles, error):
    """Heads and lines of a table: a row a scene, a column a method, the time to an error, and what may be trusted."""
    names = [name for name in titles if any(row["method"] == name for row in rows)]
    lines = []
    for scene in scenes(rows):
        here = [row for row in rows if row["scene"] == scene]
        floor = "rounding" if here[0]["floor"] < 1e-9 else percent(here[0]["floor"])
        lines.append((here[0]["title"], *(time_to([row for row in here if row["method"] == name], error)
                                          for name in names), floor))
    return (f"time of stepping to {percent(error)}", *(titles[name] for name in names), "the reference's floor"), lines


WORTH_PAYING = 0.05  # the error up to which a model may pay back


def break_even(row, rows):
    """After how many steps the making of the reduced model is paid back, against the full model with AVF at the same
    step (or the nearest that was run); NaN where the model is more than WORTH_PAYING off, and where the full model is
    not slower, or was not run."""
    full = [other for other in done(rows) if other["method"] == "full" and other["scene"] == row["scene"]
            and other["integrator"] in ("avf", "")]
    wrong = row["status"] != "done" or row["error_integrated"] > WORTH_PAYING
    if not full or wrong or math.isnan(row["precompute_seconds"]):
        return math.nan
    beside = min(full, key=lambda other: abs(math.log(other["step"] / row["step"])))
    saved = 1e-6 * (beside["microseconds"] - row["microseconds"])
    return math.ceil(row["precompute_seconds"] / saved) if saved > 0 else math.nan


def enough_until(rows, method, error):
    """The factor of the load up to which a method's best size stays below an error, by a straight line between the
    factors that were run, both in logarithms; NaN where it does at all of them, or at none."""
    best = {}
    for row in done(rows):
        if row["method"] == method:
            factor = row["load_factor"]
            best[factor] = min(best.get(factor, math.inf), row["error_integrated"])
    line = sorted(best.items())
    for (low, below), (high, above) in zip(line, line[1:]):
        if below <= error < above:
            return low * (high / low) ** (math.log(error / below) / math.log(above / below))
    return math.nan


def scenes(rows):
    """Names in the order of the rows."""
    return list(dict.fromkeys(row["scene"] for row in rows))
