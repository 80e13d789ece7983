"""A run that is asked to end, or whose files may not grow: nothing is half-written, one sentence says what was kept."""
import os
import resource
import signal
import subprocess
import time
import unittest

from bad_input.runner import sentences
from program import BIN, BOX, InAFolder

HELD = [*BOX, "-fix", "xmin"]
SCENE = '[time]\nstep = 1e-3\nend = {}\n[[load]]\nset = "xmax"\ntotal = [0, 2, 4]\n[[probe]]\nname = "tip"\nset = "xmax"\n'
# mpirun waits so many seconds before it asks ranks to end, and again before it kills them; a second is what users have,
# the other tests have none. What is interrupted must last longer.
PATIENT = dict(os.environ, OMPI_MCA_odls_base_sigkill_timeout="1")


def setUpModule():
    """A shell starts what it runs in the background with SIGINT and SIGQUIT ignored, and a program leaves them so."""
    for number in (signal.SIGINT, signal.SIGQUIT, signal.SIGHUP):
        if signal.getsignal(number) == signal.SIG_IGN:
            signal.signal(number, signal.SIG_DFL)


class Interrupts(InAFolder):
    def write(self, name, text):
        (self.folder / name).write_text(text)

    def interrupt(self, number, ready, *words):
        """What a run answers to a signal that it is sent when `ready(process)` returns: code and sentences."""
        process = subprocess.Popen(words, cwd=self.folder, text=True, env=PATIENT, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE)
        ready(process)
        process.send_signal(number)
        _, err = process.communicate(timeout=60)
        return process.returncode, [line for line in sentences(err) if line.startswith("ritz-")]

    def after(self, stage):
        def wait(process):
            while f"  {stage} " not in (line := process.stdout.readline()):
                self.assertTrue(line)
        return wait

    def part(self, name):
        def wait(process):
            deadline = time.monotonic() + 60
            while not list(self.folder.glob(f"{name}.*.part")):
                self.assertLess(time.monotonic(), deadline)
        return wait

    def test_as_soon_as_there_is_a_file(self):
        """Also the one by which a run tries whether its folder takes files."""
        self.reduce(*HELD, "-quiet")
        self.write("scene.toml", SCENE.format(1e5))
        before = self.files()
        for _ in range(10):
            self.assertEqual(self.interrupt(signal.SIGTERM, self.part("motion.h5"), BIN / "ritz-run", "model.h5", "--scene",
                                            "scene.toml"),
                             (-signal.SIGTERM, ["ritz-run: interrupted; motion.h5 was not written"]))
            self.assertEqual(self.files(), before)

    def test_the_runtime(self):
        self.reduce(*HELD, "-quiet")
        self.write("scene.toml", SCENE.format(1e5))
        words = [BIN / "ritz-run", "model.h5", "--scene", "scene.toml", "--timing", "t.csv"]
        before = self.files()
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            self.assertEqual(self.interrupt(number, self.part("t.csv"), *words),
                             (-number, ["ritz-run: interrupted; motion.h5 was not written"]))
            self.assertEqual(self.files(), before)
        self.write("motion.h5", "an earlier motion")
        self.assertEqual(self.interrupt(signal.SIGTERM, self.part("t.csv"), *words),
                         (-signal.SIGTERM, ["ritz-run: interrupted; motion.h5 is what it was"]))
        self.assertEqual((self.folder / "motion.h5").read_text(), "an earlier motion")
        self.assertEqual(self.files(), before | {"motion.h5"})

    def test_ranks(self):
        self.write("scene.toml", SCENE.format(1e2))
        self.write("model.h5", "an earlier model")
        larger = [*HELD, "-mesh", "box:1,.4,.3/18,8,8/tet10", "-modes", "100"]
        runs = (("ritz-reduce", larger, self.after("assemble"), "model.h5 is what it was"),
                ("ritz-full", [*HELD[:-4], "-fix", "xmin", "-scene", "scene.toml", "-frames", "3"], self.part("full.h5"),
                 "full.h5 was not written"))
        before = self.files()
        for program, words, ready, kept in runs:
            for number, launch in ((signal.SIGTERM, ["mpirun", "-n", "2"]), (signal.SIGINT, ["mpirun", "-n", "2"]),
                                   (signal.SIGINT, [])):
                with self.subTest(program, number=number, ranks=len(launch)):
                    code, said = self.interrupt(number, ready, *launch, BIN / program, *words)
                    self.assertEqual(said, [f"{program}: interrupted; {kept}"])
                    self.assertNotEqual(code, 0)
                    if not launch:
                        self.assertEqual(code, -number)
                    self.assertEqual(self.files(), before)
        self.assertEqual((self.folder / "model.h5").read_text(), "an earlier model")

    def test_nobody_reads_its_output(self):
        code, said = self.interrupt(0, lambda process: process.stdout.close(), BIN / "ritz-reduce", *HELD)
        self.assertEqual((code, said), (-signal.SIGPIPE, ["ritz-reduce: interrupted; model.h5 was not written"]))
        self.assertEqual(self.files(), set())

    def test_files_of_the_runtime_that_may_not_grow(self):
        self.reduce(*HELD, "-quiet")
        self.write("scene.toml", SCENE.format(2))
        self.write("motion.h5", "an earlier motion")
        before = self.files()
        for frames, limit in (("200", 0), ("200", 3000), ("200", 100_000), ("0", 40_000)):
            short = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
            result = subprocess.run([BIN / "ritz-run", "model.h5", "--scene", "scene.toml", "--frames", frames],
                                    cwd=self.folder, capture_output=True, text=True, timeout=60, preexec_fn=short)
            with self.subTest(frames=frames, limit=limit):
                self.assertEqual(result.returncode, 1)
                self.assertEqual(len(sentences(result.stderr)), 1, result.stderr)
                self.assertIn("ulimit -f", result.stderr)
                self.assertEqual(self.files(), before)
        self.assertEqual((self.folder / "motion.h5").read_text(), "an earlier motion")

    def test_a_full_disk_of_the_runtime(self):
        """A small file system of its own, where the machine lets us mount one."""
        self.reduce(*HELD, "-quiet")
        self.write("scene.toml", SCENE.format(2))
        disk = self.folder / "disk"
        disk.mkdir()
        script = ('mount -t tmpfs -o size=$0 none . && cd "$PWD" || exit 77; echo earlier > motion.h5; '
                  '"$@"; code=$?; ls; exit $code')
        for size in ("4k", "32k", "200k"):
            result = subprocess.run(["unshare", "-rm", "sh", "-c", script, size, BIN / "ritz-run", "../model.h5", "--scene",
                                     "../scene.toml"], cwd=disk, capture_output=True, text=True, timeout=60)
            if result.returncode == 77:
                self.skipTest("no file system may be mounted here")
            self.assertIn(result.returncode, (1, 2), result.stderr)  # 2: refused before the work
            self.assertEqual(len(sentences(result.stderr)), 1, result.stderr)
            self.assertIn("the disk is full" if result.returncode == 1 else "of the disk", result.stderr)
            self.assertEqual(result.stdout, "motion.h5\n")


if __name__ == "__main__":
    unittest.main()
