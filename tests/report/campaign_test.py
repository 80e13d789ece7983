"""Finished runs are not run again, whatever the moment of the interruption; what fails is a row."""
import io
import sys
import tempfile
import unittest
from pathlib import Path
from types import SimpleNamespace
from unittest import mock

import programs
from report import campaign, scenes, table
from report.methods import Form, plan
from report.progress import Progress
from report.scenes import Limits

FORM = Form("tried", 3, Limits(methods=("linear", "derivatives"), sweeps=("basis",)))
RUNS = len(plan(scenes.QUICK[0], FORM))
GOOD = RUNS - 1  # one of them fails
FOUND = SimpleNamespace(body=SimpleNamespace(facts={"cells": 7}), facts={"floor": 1e-3})


class Stopped(KeyboardInterrupt):
    pass


class Campaigns(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.output = Path(temporary.name)
        self.judged, self.timed, self.stop_after = [], [], None

    def count(self, log, key):
        if self.stop_after is not None and len(self.judged) + len(self.timed) >= self.stop_after:
            raise Stopped
        log.append(key)

    def judge(self, bench, found, run, key):
        self.count(self.judged, key)
        if run.method == "linear" and run.knobs.k == 4:
            return {"status": "failed", "reason": "the step does not converge", "seconds": 0.5}, []
        return {"status": "done", "reason": "", "error_integrated": 0.1}, [(0.0, 0.0), (1.0, 0.1)]

    def sample(self, bench, run, key, repetition, repetitions):
        self.count(self.timed, key)
        n = len(self.timed)
        return {"seconds": 1.0 * n, "median": 10.0 * n, "p99": 20.0, "memory": 1e6, "part": False}

    def run_it(self, program="build"):
        chosen = (scenes.QUICK[0],)
        with mock.patch.object(campaign.reference, "find", lambda bench: FOUND), \
                mock.patch.object(campaign.trial, "judge", self.judge), \
                mock.patch.object(campaign.trial, "sample", self.sample):
            campaign.run(campaign.start(chosen, FORM, self.output, self.output, program, Progress(io.StringIO())))

    def rows(self):
        return table.read(self.output / "runs.csv")

    def test_rows(self):
        self.run_it()
        rows = self.rows()
        self.assertEqual(len(rows), RUNS)
        failed = [one for one in rows if one["status"] == "failed"]
        self.assertEqual([one["reason"] for one in failed], ["the step does not converge"])
        done = next(one for one in rows if one["status"] == "done")
        samples = [10.0 * (i + 1) for i, key in enumerate(self.timed) if key == done["key"]]
        self.assertEqual((done["repetitions"], done["microseconds"]), (3, sorted(samples)[1]))
        self.assertEqual(done["cells"], 7)
        self.assertEqual(len(table.read(self.output / "over_time.csv")), 2 * GOOD)

    def test_methods_take_turns(self):
        self.run_it()
        for repetition in range(3):
            self.assertEqual(len(set(self.timed[GOOD * repetition:GOOD * (repetition + 1)])), GOOD)
        self.assertNotEqual(self.timed[:GOOD], self.timed[GOOD:2 * GOOD])

    def test_finished_runs_are_not_run_again(self):
        self.run_it()
        before = (self.output / "runs.csv").read_bytes()
        self.judged, self.timed = [], []
        self.run_it()
        self.assertEqual((self.judged, self.timed), ([], []))
        self.assertEqual((self.output / "runs.csv").read_bytes(), before)

    def test_an_interruption_loses_nothing(self):
        for self.stop_after in (5, RUNS, RUNS + 8, RUNS + 3 * GOOD - 1):
            with self.assertRaises(Stopped):
                self.run_it()
            self.assertEqual(len(self.judged) + len(self.timed), self.stop_after)
        self.stop_after = None
        self.run_it()
        self.assertEqual(len(self.judged), RUNS)
        self.assertEqual(len(self.timed), 3 * GOOD)
        self.assertEqual(len(self.rows()), RUNS)

    def test_another_build_runs_anew(self):
        self.run_it()
        self.run_it("another build")
        self.assertEqual(len(self.judged), 2 * RUNS)
        self.assertEqual({one["program"] for one in self.rows()}, {"another build"})


class Programs(unittest.TestCase):
    def bash(self, script):
        return programs.measured("/bin/bash", "-c", script)

    def test_a_failure_carries_the_program_s_sentence(self):
        said = "ritz-run: step 3 does not converge"
        with self.assertRaisesRegex(programs.Failed, "^bash -c .*: exit code 1: ") as caught:
            self.bash(f"echo warning: mind >&2; echo ritz-run: warning: mind >&2; echo {said} >&2; exit 1")
        self.assertEqual(caught.exception.reason, said)
        self.assertGreater(caught.exception.seconds, 0)

    def test_a_failure_to_start_carries_the_launcher_s_sentence(self):
        with self.assertRaises(programs.Failed) as caught:
            self.bash("{ echo ------; echo; echo there are not enough slots; echo ------; } >&2; exit 1")
        self.assertEqual(caught.exception.reason, "there are not enough slots")

    def test_a_killed_program_fails_too(self):
        with self.assertRaises(programs.Failed):
            self.bash("kill -9 $$")

    def test_a_program_that_does_not_end_fails(self):
        with self.assertRaisesRegex(programs.Failed, "^sleep did not end within 0.1 s$"):
            programs.run("sleep", "60", limit=0.1)

    def test_another_exit_code_may_be_wanted(self):
        self.assertEqual(programs.run("/bin/bash", "-c", "exit 3", code=3).code, 3)
        self.assertEqual(programs.run("/bin/bash", "-c", "exit 3", code=None).code, 3)
        with self.assertRaises(programs.Failed):
            programs.run("true", code=3)

    def test_variables(self):
        shown = "echo $OMP_NUM_THREADS-$MORE"
        self.assertEqual(programs.run("/bin/bash", "-c", shown, environment={"MORE": "5"}).out, "1-5\n")
        self.assertEqual(programs.run("/bin/bash", "-c", shown, environment={"OMP_NUM_THREADS": None}).out, "-\n")

    def test_seconds_and_memory(self):
        done = self.bash("echo 'run  1.25 s'")
        self.assertEqual(done.out, "run  1.25 s\n")
        self.assertGreater(done.seconds, 0)
        self.assertGreater(done.memory, 1e5)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
