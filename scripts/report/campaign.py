"""All runs of a form: scene by scene, each run judged once, then timed in rounds that go through all of them.

Finished runs stand in runs.csv; what an unfinished one has so far stands in work/BUILD/SCENE/state/KEY.json.
"""
import datetime
import random
import shutil
import statistics
from dataclasses import dataclass
from pathlib import Path

import programs
from report import reference, table, trial
from report.bench import Bench, load, save
from report.methods import BY_NAME, Form, key_of, plan
from report.progress import Progress


@dataclass(frozen=True)
class Campaign:
    benches: tuple
    form: Form
    output: Path
    program: str  # which build of the programs
    progress: Progress


def start(scenes, form, bin_folder, output, program, progress):
    """Forgets what another build has left."""
    for old in (output / "work").glob("*"):
        if old.name != program:
            shutil.rmtree(old)
    benches = tuple(Bench(scene, bin_folder, output / "work" / program / scene.name) for scene in scenes)
    return Campaign(benches, form, output, program, progress)


def run(campaign):
    """Runs what is not finished. A run that is no longer in the plan, or of another build, is dropped."""
    plans = {bench: {key_of(run, bench.scene, campaign.program): run for run in plan(bench.scene, campaign.form)}
             for bench in campaign.benches}
    runs_csv, over_time_csv = campaign.output / "runs.csv", campaign.output / "over_time.csv"
    table.keep(runs_csv, table.COLUMNS, {key for runs in plans.values() for key in runs})
    done = {row["key"] for row in table.read(runs_csv)}
    table.keep(over_time_csv, table.OVER_TIME, done)
    left = {bench: {key: run for key, run in runs.items() if key not in done} for bench, runs in plans.items()}
    campaign.progress.expect(sum(expected(bench.scene, runs.values(), campaign.form) for bench, runs in left.items()))
    for bench, runs in left.items():
        if runs:
            run_scene(campaign, bench, runs)


def run_scene(campaign, bench, runs):
    campaign.progress.say(f"{bench.scene.name}: the reference")
    found = reference.find(bench)
    campaign.progress.add(reference_seconds(bench.scene))
    states = {key: judged(campaign, bench, found, run, key) for key, run in runs.items()}
    for repetition in range(campaign.form.repetitions):
        time_round(campaign, bench, runs, states, repetition)
    for key, run in runs.items():
        finish(campaign, bench, found, run, key, states[key])


def judged(campaign, bench, found, run, key):
    path = state_path(bench, key)
    state = load(path)
    if state is not None:
        campaign.progress.skip(seconds(bench.scene, run))
    else:
        campaign.progress.say(f"{bench.scene.name}: {describe(run)}")
        row, over_time = trial.judge(bench, found, run, key)
        state = {"row": row, "over_time": over_time, "samples": []}
        save(path, state)
        campaign.progress.add(seconds(bench.scene, run))
    return state


def time_round(campaign, bench, runs, states, repetition):
    """Times every run once more, in an order of chance, so that what disturbs the machine disturbs all alike."""
    order = sorted(runs)
    random.Random(repetition).shuffle(order)
    for key in order:
        state = states[key]
        if state["row"]["status"] == "done" and len(state["samples"]) <= repetition:
            campaign.progress.say(f"{bench.scene.name}: {describe(runs[key])}, round {repetition + 1}")
            state["samples"].append(trial.sample(bench, runs[key], key, repetition, campaign.form.repetitions))
            save(state_path(bench, key), state)
            campaign.progress.add(round_seconds(bench.scene, runs[key], campaign.form))
        else:
            campaign.progress.skip(round_seconds(bench.scene, runs[key], campaign.form))


def finish(campaign, bench, found, run, key, state):
    row = columns(bench.scene, run) | {"key": key, "program": campaign.program, "machine": programs.machine(),
                                       "form": campaign.form.name, "date": datetime.date.today().isoformat()}
    row |= found.body.facts | found.facts
    row |= state["row"] | (summary(state["samples"]) if state["samples"] else {})
    table.append(campaign.output / "over_time.csv", table.OVER_TIME,
                 [{"key": key, "t": t, "error": error} for t, error in state["over_time"]])
    table.append(campaign.output / "runs.csv", table.COLUMNS, [row])


def columns(scene, run):
    return {"scene": scene.name, "title": scene.title, "load_factor": scene.load_factor, "analysis": scene.analysis,
            "end": scene.end, "ranks": scene.ranks, "method": run.method, "k": run.knobs.k, "r": run.knobs.r,
            "T": run.knobs.T,
            "integrator": run.integrator, "precision": run.precision, "step": run.step, "sweep": run.sweep,
            "mesh_compared": scene.other_is if scene.other else ""}


def quartiles(values):
    """First quartile, median, third."""
    return statistics.quantiles(values, n=4, method="inclusive") if len(values) > 1 else values * 3


def summary(samples):
    """The columns that come of repetition. The parts of a motion take their own time: all of them take their mean."""
    step = quartiles([sample["median"] for sample in samples])
    whole = quartiles([sample["seconds"] for sample in samples])
    if any(sample["part"] for sample in samples):
        whole[1] = statistics.fmean(sample["seconds"] for sample in samples)
    return {"repetitions": len(samples),
            "microseconds": step[1], "microseconds_q1": step[0], "microseconds_q3": step[2],
            "microseconds_p99": statistics.median(sample["p99"] for sample in samples),
            "seconds": whole[1], "seconds_q1": whole[0], "seconds_q3": whole[2],
            "run_memory": max(sample["memory"] for sample in samples)}


def describe(run):
    knobs = f" {run.knobs}" if str(run.knobs) else ""
    single = " in single precision" if run.precision == "single" else ""
    return f"{BY_NAME[run.method].title}{knobs}, {run.integrator or 'statics'}, step {run.step:g}{single}"


def state_path(bench, key):
    return bench.folder / "state" / f"{key}.json"


def seconds(scene, run):
    """About what one run takes."""
    return scene.count(run.step) * scene.step_cost if BY_NAME[run.method].program == "full" else 0.15


def round_seconds(scene, run, form):
    """About what timing it once takes."""
    whole = seconds(scene, run)
    return whole / trial.parts_of(scene, run, form.repetitions) if BY_NAME[run.method].program == "full" else whole


def reference_seconds(scene):
    steps = sum(scene.count(step) for step in (scene.steps[-1], scene.steps[-2], scene.middle))
    other = 0 if not scene.other else 4 if scene.other_is == "a finer" else 0.1
    return scene.step_cost * (steps + other * scene.count(scene.steps[0]))


def expected(scene, runs, form):
    if not runs:
        return 0.0
    return reference_seconds(scene) + sum(
        seconds(scene, run) + form.repetitions * round_seconds(scene, run, form) for run in runs)
