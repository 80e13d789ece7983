"""A program that is asked to end removes what is half-written, says what was kept, and dies of the signal."""
import os
import signal
import subprocess
import tempfile
import unittest
from pathlib import Path

PROGRAM = Path(os.environ["RITZ_BIN"]) / "interrupted"
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT, signal.SIGXCPU, signal.SIGPIPE)


def setUpModule():
    """A shell starts what it runs in the background with SIGINT and SIGQUIT ignored, and a program leaves them so."""
    for number in (signal.SIGINT, signal.SIGQUIT, signal.SIGHUP):
        if signal.getsignal(number) == signal.SIG_IGN:
            signal.signal(number, signal.SIG_DFL)


class Interruption(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def interrupt(self, number, when, **how):
        """Standard error, and the exit code."""
        process = subprocess.Popen([PROGRAM, "a", when], cwd=self.folder, text=True, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, **how)
        self.assertEqual(process.stdout.readline(), "ready\n")
        process.send_signal(number)
        _, err = process.communicate(timeout=30)
        return err, process.returncode

    def files(self):
        return {path.name: path.read_text() for path in self.folder.iterdir()}

    def test_before_its_files_have_names(self):
        for number in SIGNALS:
            with self.subTest(number):
                self.assertEqual(self.interrupt(number, "before"), ("interrupted: interrupted; a was not written\n", -number))
                self.assertEqual(self.files(), {})
        (self.folder / "a").write_text("old")
        for number in SIGNALS:
            with self.subTest(number):
                self.assertEqual(self.interrupt(number, "before"), ("interrupted: interrupted; a is what it was\n", -number))
                self.assertEqual(self.files(), {"a": "old"})

    def test_while_they_get_them_and_after(self):
        for when in ("during", "after"):
            for number in (signal.SIGINT, signal.SIGTERM):
                with self.subTest(when):
                    self.assertEqual(self.interrupt(number, when), ("interrupted: interrupted; a is whole\n", -number))
                    self.assertEqual(self.files(), {"a": "new", "a.csv": "new"})

    def test_what_is_ignored_stays_ignored(self):
        for number in (signal.SIGHUP, signal.SIGINT):
            ignore = lambda: signal.signal(number, signal.SIG_IGN)
            self.assertEqual(self.interrupt(number, "before", preexec_fn=ignore), ("", 0))
            self.assertEqual(self.files(), {"a": "new", "a.csv": "new"})


if __name__ == "__main__":
    unittest.main()
