"""The quick form end to end, with the programs; and that a second start finds all done."""
import sys
import tempfile
import time
import unittest
from pathlib import Path

import programs
from program import BIN
from report import compare, scenes, table
from report.methods import FORMS, METHODS, plan


class Quick(unittest.TestCase):
    def start(self, folder):
        programs.run("/usr/bin/python3", "-m", "report", "--quick", "--output", folder, "--bin", BIN)

    def test_end_to_end(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            self.start(folder)
            self.look(table.read(folder / "runs.csv"), folder)
            before = (folder / "runs.csv").read_bytes()
            started = time.time()
            self.start(folder)
            self.assertEqual((folder / "runs.csv").read_bytes(), before)
            rerun = [path for path in (folder / "work").rglob("*") if path.is_file() and path.stat().st_mtime > started]
            self.assertEqual(rerun, [])

    def look(self, rows, folder):
        self.assertEqual(len(rows), sum(len(plan(scene, FORMS["quick"])) for scene in scenes.QUICK))
        good = compare.done(rows)
        self.assertEqual({one["method"] for one in good}, {method.name for method in METHODS})
        for one in good:
            self.assertTrue(0 < one["error_integrated"] <= 10 and one["microseconds"] > 0, one)
        for one in compare.failed(rows):
            self.assertTrue(one["reason"])
        for scene in scenes.QUICK:
            self.assertTrue((folder / f"{scene.name}_work_precision.png").exists())
        self.assertIn("<svg", (folder / "index.html").read_text())
        here = lambda method, k, r: next(  # noqa: E731
            one for one in good if one["scene"] == "cantilever" and one["sweep"] == "basis" and
            (one["method"], one["k"], one["r"]) == (method, k, r))
        derivatives = here("derivatives", 8, 20)
        self.assertLess(derivatives["error_integrated"], 0.2 * here("linear", 8, 0)["error_integrated"])
        locked = here("linear_polynomial", 8, 0)
        self.assertGreater(locked["error_integrated"], 10 * derivatives["error_integrated"])
        self.assertGreater(locked["error_basis"], 10 * locked["error_time"])
        by_cells = lambda method, cells: next(  # noqa: E731
            one["error_integrated"] for one in good if one["scene"] == "rubber_statics" and
            (one["method"], one["T"]) == (method, cells))
        self.assertLess(by_cells("cubature", 20), by_cells("cubature_plain", 20))
        self.assertLess(2 * by_cells("cubature_plain", 160), by_cells("cubature_plain", 20))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
