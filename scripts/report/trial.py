"""One run: how wrong it is, once; what it costs, many times over."""
import csv
import math
import shutil

import numpy as np

from report import errors, programs
from report.methods import BY_NAME
from report.reference import tone_of

LOST = 10.0  # a run whose largest error is more has lost the motion, and has failed


def judge(bench, reference, run, key):
    """A dict of the columns of runs.csv that need no repetition, and rows (t, error) for over_time.csv."""
    row = {}
    try:
        over_time = compare(bench, reference, run, key, row)
    except programs.Failed as failure:
        return row | {"status": "failed", "reason": str(failure), "seconds": failure.seconds}, []
    return row | {"status": "done", "reason": ""}, over_time


def compare(bench, reference, run, key, row):
    """Fills `row` as far as the run gets."""
    full = BY_NAME[run.method].program == "full"
    if full:
        folder, _ = bench.full(run.step, run.integrator)
    else:
        row |= model_columns(bench, run)
        folder = move(bench, run, bench.folder / "runs" / key)
    times, u = reference.body.frames(folder / ("full.h5" if full else "motion.h5"))
    error = errors.norms(u - reference.u, reference.body.mass)
    row |= {"error_integrated": errors.integrated(error, reference.size, times),
            "error_max": errors.largest(error, reference.size)}
    if not row["error_max"] <= LOST:
        reason = f"the motion is lost: its error grows to {row['error_max']:.1e} of the largest displacement"
        raise programs.Failed(reason, 0.0 if full else 1e-6 * float(step_costs(folder)[0].sum()))
    if full:
        row |= {"error_basis": 0.0, "error_time": row["error_integrated"], "energy_balance": energy_balance(folder)}
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
    bench.reduced(bench.model(run.method, run.knobs)[0], run.step, run.integrator, run.precision, folder,
                  ["--every", bench.every(run.step)])
    return folder


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


def energy_balance(folder):
    path = folder / "energy.csv"
    if not path.exists():
        return float("nan")
    table = np.genfromtxt(path, delimiter=",", names=True)
    return float(np.max(np.abs(table["drift"])) / np.max(table["kinetic"] + table["elastic"]))


def step_costs(folder):
    """µs of every step, Newton iterations and steps rejected in all."""
    with open(folder / "timing.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    return (np.array([float(row["microseconds"]) for row in rows]), sum(int(row["iterations"]) for row in rows),
            sum(int(row["rejected"]) for row in rows))


def sample(bench, run, key):
    """What one repetition costs: seconds of stepping, µs a step (median, p99), Newton iterations, rejected, memory."""
    if BY_NAME[run.method].program == "full":
        folder, steps = bench.folder / "timed" / key, bench.scene.count(run.step)
        cost = bench.full_once(bench.problem(), bench.toml(run.step, run.integrator), folder, steps, steps)
        shutil.rmtree(folder)
        return full_sample(cost)
    folder = bench.folder / "timed" / key
    done = bench.reduced(bench.model(run.method, run.knobs)[0], run.step, run.integrator, run.precision, folder,
                         ["--frames", 0])
    micros, iterations, rejected = step_costs(folder)
    shutil.rmtree(folder)
    return {"seconds": 1e-6 * float(micros.sum()), "median": float(np.median(micros)),
            "p99": float(np.percentile(micros, 99)), "iterations": iterations, "rejected": rejected,
            "memory": done.memory}


def full_sample(cost):
    """ritz-full says what its steps took in all: their mean stands for the median."""
    return {"seconds": cost["seconds"], "median": 1e6 * cost["seconds"] / cost["steps"], "memory": cost["memory"]}
