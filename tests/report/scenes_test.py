"""The two tables: what they ask for can be run, and no run is asked for twice."""
import dataclasses
import sys
import tempfile
import tomllib
import unittest
from pathlib import Path

from report import meshes, scenes
from report.methods import BY_NAME, FORMS, METHODS, Knobs, Run, key_of, plan
from report.scenes import Limits

CONFIG = Path(__file__).resolve().parents[2] / "config"
EVERY = [(scene, form) for form, chosen in (("full", scenes.FULL), ("quick", scenes.QUICK)) for scene in chosen]


class Tables(unittest.TestCase):
    def test_keys_tell_runs_apart(self):
        keys = [key_of(run, scene, "1") for scene, form in EVERY if form == "full" for run in plan(scene, FORMS[form])]
        self.assertEqual(len(keys), len(set(keys)))
        scene = scenes.FULL[0]
        run = plan(scene, FORMS["full"])[0]
        key = key_of(run, scene, "1")
        self.assertEqual(key, key_of(dataclasses.replace(run), dataclasses.replace(scene, title="another"), "1"))
        self.assertNotEqual(key, key_of(run, scene, "2"))
        self.assertNotEqual(key, key_of(run, dataclasses.replace(scene, damping=9.0), "1"))
        self.assertNotEqual(key, key_of(dataclasses.replace(run, step=0.5), scene, "1"))

    def test_every_method_is_used_somewhere(self):
        for form in FORMS:
            used = {run.method for scene, its in EVERY if its == form for run in plan(scene, FORMS[form])}
            self.assertEqual(used, {method.name for method in METHODS})

    def test_every_step_divides_the_frames_and_the_end(self):
        for scene, _ in EVERY:
            for step in scene.steps:
                for whole in (scene.frame / step, scene.end / step):
                    self.assertAlmostEqual(whole, round(whole), places=9, msg=scene.name)
            self.assertEqual(list(scene.steps), sorted(scene.steps, reverse=True))

    def test_a_scene_is_large(self):
        """More than 100,000 degrees of freedom: three a vertex of a quadratic beam, less its held face."""
        for scene in scenes.FULL[-2:]:
            nx, ny, nz = (2 * int(n) for n in scene.mesh.split("/")[1].split(","))
            self.assertGreater(3 * nx * (ny + 1) * (nz + 1), 100_000)

    def test_the_full_model_is_never_its_own_reference(self):
        for scene, form in EVERY:
            for run in plan(scene, FORMS[form]):
                if BY_NAME[run.method].program == "full":
                    self.assertGreater(run.step, scene.steps[-1])

    def test_scene_files(self):
        for scene, _ in EVERY:
            text = tomllib.loads(scene.toml(scene.middle, "avf" if scene.analysis == "time" else "", scene.loads))
            self.assertEqual(len(text["load"]), len(scene.loads))
            self.assertEqual(text["probe"][0]["name"], "probe")
            self.assertIn("static" if scene.analysis == "static" else "time", text)

    def test_limits(self):
        basis = Run("s", "derivatives", Knobs(4, 8), "avf", "double", 0.1, "basis")
        step = Run("s", "derivatives", Knobs(8, 20), "bdf2", "double", 0.1, "step")
        admits = lambda run, **limits: Limits(**limits).admits(run)  # noqa: E731
        self.assertTrue(admits(basis) and admits(step))
        self.assertTrue(admits(basis, integrators=("newmark",)) and admits(step, sizes=((4, 8),)))
        self.assertFalse(admits(step, integrators=("newmark",)))
        self.assertFalse(admits(basis, sizes=((8, 20),)))
        self.assertFalse(admits(basis, sweeps=("step",)))
        self.assertFalse(admits(basis, methods=("linear",)))

    def test_the_twist_is_that_of_the_demo(self):
        demo = tomllib.loads((CONFIG / "rubber_twist.toml").read_text())["load"]
        ours = scenes.couple((16, 2, 2), 215)
        self.assertEqual(len(ours), len(demo))
        for mine, theirs in zip(ours, demo):
            self.assertEqual(mine.target, f"vertex = {theirs['vertex']}")
            for (t, factor), (there, other) in zip(mine.table, theirs["table"]):
                self.assertAlmostEqual(t, there, places=9)
                for a, b in zip(mine.total, theirs["total"]):
                    self.assertAlmostEqual(a * factor, b * other, delta=0.05)

    def test_the_block_has_eight_grains(self):
        with tempfile.TemporaryDirectory() as folder:
            text = Path(meshes.Block(8).write(Path(folder))).read_text()
        soft, hard = (part.split("*")[0].strip().splitlines()[1:] for part in text.split("ELSET=")[1:])
        self.assertEqual((len(soft), len(hard)), (512 - 64, 64))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
