"""A run that is asked to end, or whose files may not grow: nothing is half-written, one sentence says what was kept."""
import signal
import unittest

from program import BOX, InAFolder, heed_signals, sentences

HELD = [*BOX, "-fix", "xmin"]
SCENE = '[time]\nstep = 1e-3\nend = {}\n[[load]]\nset = "xmax"\ntotal = [0, 2, 4]\n[[probe]]\nname = "tip"\nset = "xmax"\n'
# mpirun waits so many seconds before it asks ranks to end, and again before it kills them; a second is what users have,
# the other tests have none. What is interrupted must last longer.
PATIENT = {"OMPI_MCA_odls_base_sigkill_timeout": "1"}

setUpModule = heed_signals


class Interrupts(InAFolder):
    def interrupt(self, number, ready, program, *words, ranks=0):
        """What a run answers to a signal that it is sent when `ready(process)` returns: code and sentences."""
        process = self.bench.start(program, *words, ranks=ranks, environment=PATIENT)
        ready(process)
        process.send_signal(number)
        _, err = process.communicate(timeout=60)
        return process.returncode, [line for line in sentences(err) if line.startswith("ritz-")]

    def test_as_soon_as_there_is_a_file(self):
        """Also the one by which a run tries whether its folder takes files."""
        self.reduce(*HELD, "-quiet")
        self.write("scene.toml", SCENE.format(1e5))
        before = self.files()
        for _ in range(10):
            self.assertEqual(self.interrupt(signal.SIGTERM, self.part("motion.h5"), "ritz-run", "model.h5", "--scene",
                                            "scene.toml"),
                             (-signal.SIGTERM, ["ritz-run: interrupted; motion.h5 was not written"]))
            self.assertEqual(self.files(), before)

    def test_the_runtime(self):
        self.reduce(*HELD, "-quiet")
        self.write("scene.toml", SCENE.format(1e5))
        words = ["ritz-run", "model.h5", "--scene", "scene.toml", "--timing", "t.csv"]
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
            for number, ranks in ((signal.SIGTERM, 2), (signal.SIGINT, 2), (signal.SIGINT, 0)):
                with self.subTest(program, number=number, ranks=ranks):
                    code, said = self.interrupt(number, ready, program, *words, ranks=ranks)
                    self.assertEqual(said, [f"{program}: interrupted; {kept}"])
                    self.assertNotEqual(code, 0)
                    if not ranks:
                        self.assertEqual(code, -number)
                    self.assertEqual(self.files(), before)
        self.assertEqual((self.folder / "model.h5").read_text(), "an earlier model")

    def test_nobody_reads_its_output(self):
        code, said = self.interrupt(0, lambda process: process.stdout.close(), "ritz-reduce", *HELD)
        self.assertEqual((code, said), (-signal.SIGPIPE, ["ritz-reduce: interrupted; model.h5 was not written"]))
        self.assertEqual(self.files(), set())

    def test_files_of_the_runtime_that_may_not_grow(self):
        self.reduce(*HELD, "-quiet")
        self.write("scene.toml", SCENE.format(2))
        self.write("motion.h5", "an earlier motion")
        before = self.files()
        for frames, limit in (("200", 0), ("200", 3000), ("200", 100_000), ("0", 40_000)):
            result = self.move("model.h5", "--scene", "scene.toml", "--frames", frames, code=None,
                               under=["prlimit", f"--fsize={limit}"])
            with self.subTest(frames=frames, limit=limit):
                self.assertEqual(result.code, 1)
                self.assertEqual(len(sentences(result.err)), 1, result.err)
                self.assertIn("ulimit -f", result.err)
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
            result = self.move("../model.h5", "--scene", "../scene.toml", code=None, folder=disk,
                               under=["unshare", "-rm", "sh", "-c", script, size])
            if result.code == 77:
                self.skipTest("no file system may be mounted here")
            self.assertIn(result.code, (1, 2), result.err)  # 2: refused before the work
            self.assertEqual(len(sentences(result.err)), 1, result.err)
            self.assertIn("the disk is full" if result.code == 1 else "of the disk", result.err)
            self.assertEqual(result.out, "motion.h5\n")


if __name__ == "__main__":
    unittest.main()
