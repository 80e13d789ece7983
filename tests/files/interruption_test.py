"""A program that is asked to end removes what is half-written, says what was kept, and dies of the signal."""
import signal
import unittest

from program import InAFolder, heed_signals

SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT, signal.SIGXCPU, signal.SIGPIPE)

setUpModule = heed_signals


class Interruption(InAFolder):
    def interrupt(self, number, when, **how):
        """Standard error, and the exit code."""
        process = self.bench.start("interrupted", "a", when, **how)
        self.assertEqual(process.stdout.readline(), "ready\n")
        process.send_signal(number)
        _, err = process.communicate(timeout=30)
        return err, process.returncode

    def texts(self):
        return {path.name: path.read_text() for path in self.folder.iterdir()}

    def test_before_its_files_have_names(self):
        for number in SIGNALS:
            with self.subTest(number):
                self.assertEqual(self.interrupt(number, "before"), ("interrupted: interrupted; a was not written\n", -number))
                self.assertEqual(self.texts(), {})
        self.write("a", "old")
        for number in SIGNALS:
            with self.subTest(number):
                self.assertEqual(self.interrupt(number, "before"), ("interrupted: interrupted; a is what it was\n", -number))
                self.assertEqual(self.texts(), {"a": "old"})

    def test_while_they_get_them_and_after(self):
        for when in ("during", "after"):
            for number in (signal.SIGINT, signal.SIGTERM):
                with self.subTest(when):
                    self.assertEqual(self.interrupt(number, when), ("interrupted: interrupted; a is whole\n", -number))
                    self.assertEqual(self.texts(), {"a": "new", "a.csv": "new"})

    def test_what_is_ignored_stays_ignored(self):
        for number in (signal.SIGHUP, signal.SIGINT):
            ignore = lambda: signal.signal(number, signal.SIG_IGN)
            self.assertEqual(self.interrupt(number, "before", preexec_fn=ignore), ("", 0))
            self.assertEqual(self.texts(), {"a": "new", "a.csv": "new"})


if __name__ == "__main__":
    unittest.main()
