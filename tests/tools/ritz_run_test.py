"""ritz-run as a program: exit codes, one sentence on stderr, no leftovers, and files that others can read."""
import resource
import signal
import sys
import unittest
import xml.etree.ElementTree as xml
from pathlib import Path

import h5py
import numpy as np

from program import InAFolder

SCENE = """
[time]
step = 0.1
end = 2
[[load]]
set = "tip"
total = [0, 0, 18]
[[probe]]
name = "tip"
set = "tip"
"""


class RitzRun(InAFolder):
    def setUp(self):
        super().setUp()
        self.bench.run("write_sample_model", "model.h5")
        self.write("scene.toml", SCENE)
        self.inputs = self.files()

    def run_it(self, *words, **how):
        return self.move(*words, code=None, **how)

    def outputs(self):
        return self.files() - self.inputs

    def refused(self, result, code, complaint):
        self.assertEqual(result.code, code, result.err)
        self.assertIn(complaint, result.err)
        self.assertEqual(len(result.err.strip().splitlines()), 1, result.err)
        self.assertEqual(result.out, "")
        self.assertEqual(self.outputs(), set())

    def test_the_summary_of_several_bodies_says_of_each_what_it_says_of_one(self):
        self.move("model.h5", "--scene", "scene.toml", "--summary", "summary.json")
        alone = self.bench.summary("summary.json")
        body = '[[body]]\nname = "{}"\n'
        self.write("scene.toml", body.format("a") + body.format("b") +
                   SCENE.replace('set = "tip"', 'body = "b"\nset = "tip"'))
        self.move("model.h5", "--scene", "scene.toml", "--summary", "summary.json")
        together = self.bench.summary("summary.json")
        self.assertNotIn("steps", together)
        self.assertEqual([body["name"] for body in together["bodies"]], ["a", "b"])
        for body in together["bodies"]:
            self.assertEqual(set(body) - {"name", "output"}, set(alone) - set(together))
            self.assertEqual(Path(body["output"]).name, f"motion.{body['name']}.h5")
            self.assertIn(Path(body["output"]).name, self.files())
            for key in ("model", "analysis", "integrator", "coordinates", "steps", "frames", "energy"):
                self.assertEqual(body[key], alone[key], key)

    def test_the_summary_says_what_is_printed(self):
        self.write("scene.toml", SCENE + "[damping]\nratio = 2\n")
        result = self.run_it("model.h5", "--scene", "scene.toml", "--summary", "summary.json")
        self.assertEqual(result.code, 0, result.err)
        said = self.bench.summary("summary.json")
        self.assertEqual((said["program"], said["integrator"], said["steps"]), ("ritz-run", "exact", 20))
        self.assertIn(f"20 steps of {said['coordinates']} coordinates", result.out)
        self.assertIn(f"{said['frames']} frames", result.out)
        self.assertEqual(said["energy"], None)
        self.assertEqual(["ritz-run: warning: " + text for text in said["warnings"]], result.err.splitlines())

    def test_a_summary_that_cannot_be_written_costs_nothing_else(self):
        self.refused(self.run_it("model.h5", "--scene", "scene.toml", "--summary", "nowhere/summary.json"), 2, "nowhere")
        self.refused(self.run_it("model.h5", "--scene", "scene.toml", "--summary", "scene.toml"), 2, "scene.toml")
        self.refused(self.run_it("model.h5", "--animate-mode", "1", "--summary", "s.json"), 2, "--summary")

    def test_an_overdamped_ratio_is_warned_of(self):
        for ratio, warned in (("2", True), ("[0.02, 1]", True), ("0.02", False)):
            with self.subTest(ratio=ratio):
                self.write("scene.toml", SCENE + f"[damping]\nratio = {ratio}\n")
                result = self.run_it("model.h5", "--scene", "scene.toml", "--quiet")
                self.assertEqual(result.code, 0, result.err)
                self.assertEqual(len(result.err.splitlines()), 1 if warned else 0, result.err)
                self.assertEqual("overdamped" in result.err, warned)

    def test_runs(self):
        result = self.run_it("model.h5", "--scene", "scene.toml")
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertEqual(len(result.out.splitlines()), 1)
        self.assertNotIn("\r", result.out)
        self.assertEqual(self.outputs(), {"motion.h5", "motion.xdmf", "probes.csv"})
        rows = self.table("probes.csv")[1]
        np.testing.assert_allclose(rows[:, 3], 1 - np.cos(3 * rows[:, 0]), atol=1e-13)

    def test_help(self):
        result = self.run_it("--help")
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertIn("--animate-mode", result.out)
        reference = self.run_it("--help-scene").out
        self.assertIn("```toml\n" + reference + "```", (Path(__file__).parents[2] / "docs/options.md").read_text())

    def test_quiet(self):
        self.assertEqual(self.run_it("model.h5", "--scene", "scene.toml", "--quiet").out, "")

    def test_bad_input(self):
        run = lambda *words: self.run_it("model.h5", *words)
        self.refused(run("--scene", "scne.toml"), 2, "scne.toml")
        self.refused(run("--scen", "scene.toml"), 2, "did you mean '--scene'?")
        self.refused(run("--animate-mode", "9"), 2, "--animate-mode is 1 to 2")
        self.refused(self.run_it("nothing.h5", "--scene", "scene.toml"), 2, "nothing.h5")
        self.refused(self.run_it("scene.toml", "--scene", "scene.toml"), 2, "scene.toml")
        self.write("scene.toml", SCENE.replace('"tip"\ntotal', '"tap"\ntotal'))
        self.refused(run("--scene", "scene.toml"), 2, "did you mean 'tip'?")
        self.write("scene.toml", SCENE.replace("18", "1e308") + "[damping]\nalpha = 1e308\n")
        self.write("scene.toml", SCENE.replace("[0, 0, 18]", "[0, 0, 1e308]\ntable = [[0, 1e10]]"))
        self.refused(run("--scene", "scene.toml"), 1, "not finite")

    def test_full_disk(self):
        def small_files():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))

        result = self.run_it("model.h5", "--scene", "scene.toml", preexec_fn=small_files)
        self.refused(result, 1, "ulimit -f")

    def test_damaged_models(self):
        whole = (self.folder / "model.h5").read_bytes()
        for keep in (0, 7, 100, len(whole) // 2, len(whole) - 1):
            (self.folder / "model.h5").write_bytes(whole[:keep])
            self.refused(self.run_it("model.h5", "--scene", "scene.toml"), 2, "model.h5")

    def test_xdmf_leads_to_the_displacements(self):
        self.run_it("model.h5", "--scene", "scene.toml", "--frames", "5", "--output", "a & b.h5")
        collection = xml.parse(self.folder / "a & b.xdmf").getroot().find("Domain/Grid")
        self.assertEqual(collection.get("CollectionType"), "Temporal")
        with h5py.File(self.folder / "a & b.h5") as motion:
            times = [float(grid.find("Time").get("Value")) for grid in collection]
            np.testing.assert_array_equal(times, motion["frame_times"][:])
            np.testing.assert_allclose(times, [0, .5, 1, 1.5, 2])
            for frame, grid in enumerate(collection):
                for item in grid.iter("DataItem"):
                    if item.get("Format") != "HDF":
                        continue
                    file, name = item.text.split(":")
                    self.assertEqual(file, "a & b.h5")
                    shape = tuple(map(int, item.get("Dimensions").split()))
                    self.assertEqual(motion[name].shape, shape)
                    self.assertEqual(motion[name].dtype.itemsize, int(item.get("Precision")))
                shown = motion[grid.find("Attribute/DataItem").text.split(":")[1]]
                np.testing.assert_array_equal(shown, motion["displacement"][frame])
            np.testing.assert_array_equal(motion["cells"][:], [6, 0, 1, 2, 3])  # one tetrahedron
            np.testing.assert_array_equal(motion["vertex_ids"][:], [10, 20, 30, 41])
            self.assertEqual(motion["displacement"].attrs["units"], b"m")
            tip = motion["displacement"][:, 1, 2]
        np.testing.assert_allclose(tip, 1 - np.cos(3 * np.array(times)), atol=1e-6)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
