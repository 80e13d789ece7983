"""What a scene's runs are compared with: ritz-full with AVF on the same mesh at the finest step."""
import math
from dataclasses import dataclass, replace

import numpy as np

from report import errors
from report.bench import probe
from report.body import Body


@dataclass(frozen=True)
class Reference:
    body: Body
    times: np.ndarray
    u: np.ndarray  # frames x free components
    size: np.ndarray  # ‖u‖_M
    tone: float  # Hz of the probe after the release; NaN where nothing swings freely
    facts: dict  # columns of runs.csv


def tone_of(scene, folder, every):
    """Of the probe at the frames' times, so that all runs are looked at through the same window."""
    times, places = (values[::every] for values in probe(folder))
    if scene.analysis == "static" or math.isinf(scene.released):
        return float("nan")
    after = times > scene.released
    signal = places[after][:, np.argmax(np.std(places[after], axis=0))]
    return errors.tone(times[after], signal)


def find(bench):
    """Runs what is not there yet. Raises programs.Failed."""
    scene, body = bench.scene, bench.body()
    integrator = "avf" if scene.analysis == "time" else ""
    fine, _ = bench.full(scene.steps[-1], integrator)
    coarse, _ = bench.full(scene.steps[-2], integrator)
    times, u = body.frames(fine / "full.h5")
    size = errors.norms(u, body.mass)
    floor = errors.integrated(errors.norms(body.frames(coarse / "full.h5")[1] - u, body.mass), size, times)
    facts = {"reference_step": scene.steps[-1], "floor": floor, "error_mesh": mesh_error(bench, integrator)}
    return Reference(body, times, u, size, tone_of(scene, fine, bench.every(scene.steps[-1])), facts)


def mesh_error(bench, integrator):
    """Of the probe, at the coarsest step, on the two meshes."""
    scene = bench.scene
    if not scene.other:
        return float("nan")
    here, _ = bench.full(scene.steps[0], integrator)
    there, _ = replace(bench, scene=scene.other).full(scene.steps[0], integrator)
    (times, p), (_, q) = probe(here), probe(there)
    return errors.probes(p, q, times)
