"""What a run is compared with belongs to the scene as it is now."""
import dataclasses
import sys
import tempfile
import tomllib
import unittest
from pathlib import Path
from types import SimpleNamespace
from unittest import mock

from report import scenes, trial
from report.bench import Bench
from report.methods import plan, FORMS

MODEL = Path("models/m/model.h5")


class Trials(unittest.TestCase):
    def test_a_changed_scene_is_run_anew_at_the_reference_s_step(self):
        scene = scenes.QUICK[0]
        run = next(run for run in plan(scene, FORMS["quick"]) if run.method == "derivatives")
        made = []

        def move(bench, model, step, integrator, precision, folder, frames):
            made.append((bench.scene.damping, step))
            folder.mkdir(parents=True)
            (folder / "motion.h5").touch()

        frames = SimpleNamespace(body=SimpleNamespace(frames=lambda path: (None, path)))
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(Bench, "model", lambda *_: (MODEL, {})), \
                mock.patch.object(Bench, "reduced", move):
            benches = [Bench(dataclasses.replace(scene, damping=damping), Path("bin"), Path(folder) / scene.name)
                       for damping in (0.5, 0.5, 2.0)]
            places = [trial.finest_frames(bench, frames, run) for bench in benches]
        self.assertEqual(made, [(0.5, scene.steps[-1]), (2.0, scene.steps[-1])])
        self.assertEqual(places[0], places[1])
        self.assertNotEqual(places[0], places[2])

    def test_the_full_model_is_timed_in_parts(self):
        scene = dataclasses.replace(scenes.QUICK[0], end=1.3)
        run = next(run for run in plan(scene, FORMS["quick"]) if run.method == "full" and run.step == scene.steps[0])
        ran = []

        def full_once(bench, path, output, words):
            ran.append((tomllib.loads(path.read_text())["time"]["end"], output.name, words[2:]))
            (output.parent / "timing.csv").write_text("t,microseconds,iterations,rejected\n0.02,30,2,0\n0.04,50,2,0\n")
            return SimpleNamespace(memory=1.0)

        with tempfile.TemporaryDirectory() as folder, mock.patch.object(Bench, "full_once", full_once):
            bench = Bench(scene, Path("bin"), Path(folder) / scene.name)
            samples = [trial.sample(bench, run, "key", repetition, 3) for repetition in range(3)]
            timed = bench.folder / "timed" / "key"
            self.assertEqual(ran, [(1.3 * 21 / 65, "0.h5", []), (1.3 * 43 / 65, "1.h5", ["-restart", timed / "0.h5"]),
                                   (1.3, "2.h5", ["-restart", timed / "1.h5"])])
            self.assertFalse(timed.exists())
        for sample in samples:
            self.assertAlmostEqual(sample["seconds"], 50e-6 * 65)
            self.assertEqual(sample["median"], 50)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
