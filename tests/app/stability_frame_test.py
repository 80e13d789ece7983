"""The frame of the stability report: verdicts, failures of a row, the three forms of the table."""
import sys
import unittest
from pathlib import Path

import numpy as np

import programs
from bench import rows
from program import BIN, InAFolder
from stability import report, table
from stability.outcome import finite_or_failed, refused
from stability.row import Length, Row, Verdict, at_most, equal, finite, near, reported, run_row, says

PROGRAM = Path(__file__).resolve().parents[2] / "scripts/stability.py"


def row(*figures, name="a_row"):
    return Row(name, "a scene with <angles>", "what & why", lambda bench, length: list(figures))


class Frame(InAFolder):
    def result(self, *figures):
        return run_row(row(*figures), BIN, Length.short)

    def test_figures_can_fail(self):
        for good, bad in ((at_most("x", 1, 1), at_most("x", 1.01, 1)),
                          (near("x", 1.01, 1, .02), near("x", .97, 1, .02)),
                          (equal("x", 2, 2), equal("x", 2, 3)),
                          (says("x", "a warning", "warn"), says("x", "a warning", "tet10")),
                          (finite("x", np.zeros(3)), finite("x", np.array([0, np.inf, 0])))):
            self.assertTrue(good.holds, good)
            self.assertIs(bad.holds, False, bad)
        for figure in (at_most("x", float("nan"), 1), near("x", float("nan"), 1, 1)):
            self.assertIs(figure.holds, False)

    def test_verdicts(self):
        self.assertIs(self.result(at_most("x", 0, 1), reported("y")).verdict, Verdict.holds)
        self.assertIs(self.result(at_most("x", 0, 1), at_most("y", 2, 1)).verdict, Verdict.fails)
        self.assertIs(self.result(reported("y")).verdict, Verdict.reported)
        self.assertIs(self.result().verdict, Verdict.fails)

    def test_a_row_that_cannot_be_measured_fails(self):
        def broken(bench, length):
            bench.reduce("-mesh", "none.msh")
        result = run_row(Row("broken", "", "", broken), BIN, Length.short)
        self.assertIs(result.verdict, Verdict.fails)
        self.assertIn("exit code 2", result.observed)

    def test_what_a_refusal_must_be(self):
        bench = self.bench
        good = programs.Ran("ritz-run", 2, "", "ritz-run: a sentence\n")
        self.assertTrue(refused(bench, good, set()).holds)
        self.assertIs(refused(bench, good, set(), code=1).holds, False)
        for err in ("", "ritz-run: one\nritz-run: two\n", "ritz-run: one\nTraceback (most recent call last)\n"):
            self.assertIs(refused(bench, programs.Ran("ritz-run", 2, "", err), set()).holds, False)
        self.write("motion.h5.part", "")
        self.assertIs(refused(bench, good, set()).holds, False)
        wrong_input = finite_or_failed(bench, "x", "ritz-run", ["none.h5", "--scene", "none.toml"], "motion.h5", "z")
        self.assertIs(wrong_input.holds, False)

    def test_the_table(self):
        results = [self.result(at_most("x", 2, 1))]
        self.assertIn("NOT MET: x 2", report.text_of(results[0]))
        report.write_csv(self.folder / "t.csv", results)
        line, = rows(self.folder / "t.csv")
        self.assertEqual((line["scene"], line["asked"], line["observed"], line["verdict"]),
                         ("a scene with <angles>", "what & why", "x 2 (gate 1)", "fails"))
        report.write_html(self.folder / "t.html", results, {"Group": [results[0].row]}, {"command": "this"})
        page = (self.folder / "t.html").read_text()
        self.assertIn("a scene with &lt;angles&gt;", page)
        for far in ("http:", "https:", "src=", "<link", "@import"):
            self.assertNotIn(far, page)

    def test_the_program(self):
        def stability(*words, code=0):
            return programs.run(sys.executable, PROGRAM, *words, folder=self.folder, code=code)
        names = stability("--list").out.split()
        self.assertEqual(names, [row.name for row in table.ROWS])
        self.assertEqual(len(names), len(set(names)))
        stability("--rows", "no_such_row", code=2)
        done = stability("--rows", "nothing_free", "--length", "short", "--out", "report")
        self.assertIn("1 holds, 0 fails", done.out)
        written = {path.name for path in (self.folder / "report").iterdir()}
        self.assertEqual(written, {"stability.csv", "stability.html"})


if __name__ == "__main__":
    unittest.main()
