"""ritz-inspect --summary: what is in a model, as numbers that agree with the file."""
import re
import unittest
from pathlib import Path

import h5py
import numpy as np

from program import InAFolder

PAGE = (Path(__file__).parents[2] / "docs/summary.md").read_text()


class RitzInspect(InAFolder):
    def summary(self, *words):
        self.bench.run("write_sample_model", "model.h5", "two-bodies")
        self.inspect("model.h5", "--summary", "s.json", *words)
        return self.bench.summary("s.json")

    def test_every_key_is_documented(self):
        page = PAGE.split("## Of every program")[1].split("\n## ")[0] + PAGE.split("## `ritz-inspect`")[1]
        documented = set(re.findall(r"`(\w+)`", page))
        summary = self.summary("--check")
        body = summary["bodies"][0]
        for key in [*summary, *body, *body["geometry"], *body["report"], *summary["checked"][0]]:
            self.assertIn(key, documented)

    def test_numbers_are_those_of_the_file(self):
        summary = self.summary()
        self.assertIsNone(summary["checked"])
        with h5py.File(self.folder / "model.h5") as file:
            self.assertEqual(summary["model_format"], list(file.attrs["version"]))
            self.assertEqual([body["name"] for body in summary["bodies"]], ["body", "arm/upper"])
            for name, body in zip(["body", "arm%2Fupper"], summary["bodies"]):
                stored = file["bodies"][name]
                self.assertEqual(body["modes"]["eigenvalue"], list(stored["modes/eigenvalues"]))
                np.testing.assert_allclose(body["modes"]["frequency_hz"],
                                           np.sqrt(stored["modes/eigenvalues"][:]) / (2 * np.pi), rtol=1e-15)
                self.assertEqual(body["columns"], stored["basis"].attrs["column_count"])
                self.assertEqual(body["geometry"]["box"]["high"], list(stored["geometry/points"][:].max(0)))
                self.assertEqual(body["inertia"]["mass"], stored["inertia/gram"][0, 0])
                self.assertEqual([load["set"] for load in body["loads"]], [name.replace("%2F", "/").replace("%25", "%")
                                                                           for name in stored["loads"]])
                material = body["geometry"]["materials"][0]
                self.assertEqual(material["constants"]["young"], stored["geometry/materials/young"][0])
        arm = summary["bodies"][1]
        self.assertEqual(arm["polynomial"]["coordinates"], arm["columns"])
        self.assertEqual(arm["report"]["notes"], ["the arm's springs harden"])

    def test_a_check_is_measured(self):
        for checked in self.summary("--check")["checked"]:
            self.assertLess(checked["orthonormality"], 1e-12)
        self.assertLess(checked["stiffness"], 1e-9)

    def test_a_model_that_fails_has_no_summary(self):
        self.summary()
        with h5py.File(self.folder / "model.h5", "r+") as file:
            file["bodies/body/modes/eigenvalues"][0] = 5
        (self.folder / "s.json").unlink()
        failed = self.inspect("model.h5", "--summary", "s.json", "--check", code=2)
        self.assertEqual(len(failed.err.splitlines()), 1)
        self.assertEqual([path.name for path in self.folder.glob("s.json*")], [])

    def test_the_model_is_not_overwritten(self):
        self.summary()
        before = (self.folder / "model.h5").read_bytes()
        failed = self.inspect("model.h5", "--summary", "model.h5", code=2)
        self.assertIn("--summary model.h5", failed.err)
        self.assertEqual(failed.out, "")  # before the work
        self.assertEqual((self.folder / "model.h5").read_bytes(), before)


if __name__ == "__main__":
    unittest.main()
