"""One run: how wrong it is, once; what it costs, many times over."""
import dataclasses
import math
import shutil

import numpy as np

import programs
from bench import rows, summary
from report import errors
from report.methods import BY_NAME
from report.reference import tone_of

LOST = 10.0  # a run whose largest error is more has lost the motion, and has failed


def judge(bench, reference, run, key):
    """A dict of the columns of runs.csv that need no repetition, and rows (t, error) for over_time.csv."""
    row = {}
    try:
        over_time = compare(bench, reference, run, key, row)
    except programs.Failed as failure:
        return row | {"status": "failed", "reason": failure.reason, "seconds": failure.seconds}, []
    return row | {"status": "done", "reason": ""}, over_time


def compare(bench, reference, run, key, row):
    """Fills `row` as far as the run gets."""
    full = BY_NAME[run.method].program == "full"
    if full:
        folder, _ = bench.full(run.step, run.integrator)
        row |= {"flags": " ".join(map(str, bench.problem())), "energy_balance": energy_drift(folder)}
    else:
        row |= model_columns(bench, run)
        folder = bench.folder / "runs" / key
        move(bench, run, folder)
        row["energy_balance"] = energy_kept(folder)
    micros, row["iterations"], row["rejected"] = step_costs(folder)
    times, u = reference.body.frames(folder / ("full.h5" if full else "motion.h5"))
    error = errors.norms(u - reference.u, reference.body.mass)
    row |= {"error_integrated": errors.integrated(error, reference.size, times),
            "error_max": errors.largest(error, reference.size)}
    if not row["error_max"] <= LOST:
        reason = f"the motion is lost: its error grows to {row['error_max']:.1e} of the largest displacement"
        raise programs.Failed(reason, 1e-6 * float(micros.sum()))
    if full:
        row |= {"error_basis": 0.0, "error_time": row["error_integrated"]}
    else:
        row |= parts(bench, reference, run, u)
    if not math.isnan(reference.tone):
        row["error_frequency"] = errors.relative(tone_of(bench.scene, folder, bench.every(run.step)), reference.tone)
    if not full:
        shutil.rmtree(folder)
    return list(zip(times.tolist(), (error / reference.size.max()).tolist()))


def model_columns(bench, run):
    _, cost = bench.model(run.method, run.knobs)
    return {"flags": cost["flags"], "columns": cost["columns"], "precompute_seconds": cost["seconds"],
            "precompute_stages": "; ".join(f"{name} {seconds:.4g}" for name, seconds in cost["stages"].items()),
            "precompute_memory": cost["memory"], "file_bytes": cost["bytes"], "error_force": cost["error_force"]}


def move(bench, run, folder):
    return bench.reduced(bench.model(run.method, run.knobs)[0], run.step, run.integrator, run.precision, folder,
                         ["--every", bench.every(run.step)])


def parts(bench, reference, run, u):
    """The error of the basis and that of the step: by the same model at the reference's step."""
    finest = finest_frames(bench, reference, run)
    size, times, mass = reference.size, reference.times, reference.body.mass
    return {"error_basis": errors.integrated(errors.norms(finest - reference.u, mass), size, times),
            "error_time": errors.integrated(errors.norms(u - finest, mass), size, times)}


def finest_frames(bench, reference, run):
    path, _ = bench.model(run.method, run.knobs)
    step = bench.scene.steps[-1]
    integrator = "" if bench.scene.analysis == "static" else BY_NAME[run.method].integrators[0]
    folder = bench.folder / "finest" / f"{path.parent.name}-{bench.toml(step, integrator).stem}"
    if not (folder / "motion.h5").exists():
        bench.reduced(path, step, integrator, "double", folder, ["--every", bench.every(step)])
    return reference.body.frames(folder / "motion.h5")[1]


def energy_kept(folder):
    """Of a nonlinear motion, relative to the energy that there was; linear ones say none."""
    energy = summary(folder / "summary.json")["energy"]
    return energy["largest_drift"] / energy["available"] if energy and energy["available"] > 0 else float("nan")


def energy_drift(folder):
    path = folder / "energy.csv"
    if not path.exists():
        return float("nan")
    table = np.genfromtxt(path, delimiter=",", names=True)
    return float(np.max(np.abs(table["drift"])) / np.max(table["kinetic"] + table["elastic"]))


def step_costs(folder):
    """µs of every step, Newton iterations and steps rejected in all."""
    steps = rows(folder / "timing.csv")
    return (np.array([float(step["microseconds"]) for step in steps]), sum(int(step["iterations"]) for step in steps),
            sum(int(step["rejected"]) for step in steps))


def sample(bench, run, key, repetition, repetitions):
    """What one repetition costs: seconds of the whole motion's stepping, µs a step (median, p99), memory."""
    folder = bench.folder / "timed" / key
    if BY_NAME[run.method].program == "full":
        return part(bench, run, folder, repetition, repetitions)
    done = bench.reduced(bench.model(run.method, run.knobs)[0], run.step, run.integrator, run.precision, folder,
                         ["--frames", 0])
    costs = step_costs(folder)[0]
    shutil.rmtree(folder)
    return spent(costs, len(costs), done.memory)


def part(bench, run, folder, repetition, repetitions):
    """The full model takes too long to move that often: every round times one part of its motion, from where the last
    one stopped, and takes it for the whole; all but its first step, which analyses the matrix besides. Statics have no
    parts."""
    steps = bench.scene.count(run.step)
    parts = parts_of(bench.scene, run, repetitions)
    index = repetition % parts
    end = bench.scene.end * ((index + 1) * steps // parts) / steps
    until = dataclasses.replace(bench, scene=dataclasses.replace(bench.scene, end=end))
    folder.mkdir(parents=True, exist_ok=True)
    before = ["-restart", folder / f"{index - 1}.h5"] if index else []
    done = bench.full_once(until.toml(run.step, run.integrator), folder / f"{index}.h5", ["-frames", 0, *before])
    costs = step_costs(folder)[0]
    costs = costs[1:] if len(costs) > 1 else costs
    if repetition + 1 == repetitions:
        shutil.rmtree(folder)
    return spent(costs, steps, done.memory * bench.scene.ranks)


def parts_of(scene, run, repetitions):
    return 1 if scene.analysis == "static" else max(1, min(repetitions, scene.count(run.step) // 2))


def spent(costs, steps, memory):
    """`costs`: µs of each step that was timed, of `steps`."""
    return {"seconds": 1e-6 * float(np.mean(costs)) * steps, "median": float(np.median(costs)),
            "p99": float(np.percentile(costs, 99)), "memory": memory, "part": len(costs) < steps}
