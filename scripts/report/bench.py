"""Where a scene is worked at: its files, its reduced models and its full motions, each made once and kept."""
import hashlib
import json
import os
from dataclasses import dataclass
from pathlib import Path

import h5py

import programs
from bench import report_of, table
from report import body
from report.methods import BY_NAME
from report.scenes import Scene


def save(path, value):
    """A JSON file that is whole or absent."""
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_suffix(".part")
    part.write_text(json.dumps(value))
    os.replace(part, path)


def load(path):
    return json.loads(path.read_text()) if path.exists() else None


def probe(folder):
    """Times and places (n x 3) of the probe, from probes.csv."""
    rows = table(folder / "probes.csv")[1]
    return rows[:, 0], rows[:, 1:4]


def name_of(*parts):
    return hashlib.sha256(json.dumps(parts).encode()).hexdigest()[:16]


def cost_of(path, training, done, words):
    """What ritz-reduce says of a model, and what the process cost, with the seconds that its training took."""
    stages = {"training": training} if training else {}
    with h5py.File(path) as file:
        took, figures = report_of(file)
        columns = int(file["bodies/body/basis"].attrs["column_count"])
        error_force = figures.get("witness_force")
        if "bodies/body/cubature" in file:
            error_force = float(file["bodies/body/cubature/errors/figures"][-1, [3, 5]].max())  # the largest, held out
    for name, seconds in took:
        stages[name] = stages.get(name, 0.0) + seconds
    return {"stages": stages, "seconds": training + done.seconds, "memory": figures["peak_memory_bytes"],
            "bytes": path.stat().st_size, "columns": columns, "flags": " ".join(map(str, words)),
            "error_force": error_force}


@dataclass(frozen=True)
class Bench:
    scene: Scene
    bin: Path
    folder: Path

    @property
    def shared(self):
        """The folder of what scenes with the same body share."""
        return self.folder.parent / "shared"

    def problem(self):
        """The options that the two parallel programs share."""
        mesh = self.scene.mesh if isinstance(self.scene.mesh, str) else self.scene.mesh.write(self.shared / "meshes")
        return ["-mesh", mesh, "-fix", self.scene.fixed, *self.scene.options]

    def parallel(self, program, *words):
        """Runs a program of the scene's problem."""
        under = programs.mpirun(self.scene.ranks if self.scene.ranks > 1 else 0)
        return programs.measured(self.bin / program, *self.problem(), *words, under=under)

    def toml(self, step, integrator, loads=None):
        text = self.scene.toml(step, integrator, self.scene.loads if loads is None else loads)
        path = self.folder / "scenes" / f"{name_of(text)}.toml"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def every(self, step):
        return round(self.scene.frame / step)

    def body(self):
        folder = self.shared / "bodies" / name_of(self.problem())
        if not (folder / "model.h5").exists():
            folder.mkdir(parents=True, exist_ok=True)
            self.parallel("ritz-reduce", "-modes", 1, "-export", "petsc", "-output", folder / "model.h5")
            (folder / "model_K.bin").unlink()
        return body.read(folder / "model.h5", folder / "model_M.bin", self.scene.fixed)

    def full(self, step, integrator, loads=None):
        """The folder of a motion of the full model and what it cost, as a dict. Raises programs.Failed."""
        words = self.problem()
        scene = self.toml(step, integrator, loads)
        folder = self.folder / "full" / name_of(words, scene.name)
        cost = load(folder / "cost.json")
        if not cost:
            folder.mkdir(parents=True, exist_ok=True)
            done = self.full_once(scene, folder / "full.h5", ["-every", self.every(step)])
            cost = {"wall": done.seconds}
            save(folder / "cost.json", cost)
        return folder, cost

    def full_once(self, scene, output, words):
        """Runs the full model; what its steps cost stands beside `output` as timing.csv."""
        return self.parallel("ritz-full", "-scene", scene, "-output", output, "-timing", output.parent / "timing.csv",
                             *words)

    def training(self):
        """The motion that POD learns from, at the middle step."""
        return self.full(self.scene.middle, "avf" if self.scene.analysis == "time" else "", self.scene.training)

    def model(self, method, knobs):
        """The path of a reduced model and what it cost, as a dict. Raises programs.Failed."""
        method = BY_NAME[method]
        words = [word.format(k=knobs.k, r=knobs.r, T=knobs.T) for word in method.options]
        learned = [self.scene.toml(self.scene.middle, "", self.scene.training)] if method.learns else []
        folder = self.shared / "models" / name_of(self.problem(), words, learned)
        path, cost = folder / "model.h5", load(folder / "cost.json")
        if not cost:
            folder.mkdir(parents=True, exist_ok=True)
            training, snapshots = 0.0, []
            if method.learns:
                motion, spent = self.training()
                training, snapshots = spent["wall"], ["-snapshots", motion / "full.h5"]
            done = self.parallel("ritz-reduce", *words, *snapshots, "-output", path)
            cost = cost_of(path, training, done, [*self.problem(), *words, *snapshots])
            save(folder / "cost.json", cost)
        return path, cost

    def reduced(self, model, step, integrator, precision, folder, frames):
        """Runs a reduced model; `frames`: --every's or --frames' words."""
        folder.mkdir(parents=True, exist_ok=True)
        single = ["--single"] if precision == "single" else []
        words = [model, "--scene", self.toml(step, integrator), "--output", folder / "motion.h5", "--timing",
                 folder / "timing.csv", "--summary", folder / "summary.json", *single, *frames]
        return programs.measured(self.bin / "ritz-run", *words)
