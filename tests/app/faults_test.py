"""A rank that dies, a disk that fills: the program ends, the earlier output is intact, a new start gives the same."""
import os
import resource
import signal
import subprocess
import time
import unittest

from bad_input.runner import sentences
from program import BIN, BOX, InAFolder

LONGER = [*BOX, "-fix", "xmin", "-mesh", "box:1,.4,.3/12,5,5/tet10", "-modes", "60"]
EARLIER = {"model.h5": "an earlier model", "frequencies.csv": "earlier frequencies"}


def ranks_of(mpirun):
    listed = subprocess.run(["ps", "-o", "pid=", "--ppid", str(mpirun.pid)], capture_output=True, text=True).stdout
    return sorted(map(int, listed.split()))


class Faults(InAFolder):
    def setUp(self):
        super().setUp()
        for name, text in EARLIER.items():
            (self.folder / name).write_text(text)

    def start(self, words):
        return subprocess.Popen(["mpirun", "-n", "2", BIN / "ritz-reduce", *words], cwd=self.folder, text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def await_line(self, process, stage):
        while stage and (line := process.stdout.readline()):
            if f"  {stage} " in line:
                return
        while not stage and len(ranks_of(process)) < 2:
            time.sleep(0.01)

    def expect_earlier_output(self):
        self.assertEqual({name: (self.folder / name).read_text() for name in EARLIER}, EARLIER)

    def kill_rank_after(self, stage):
        process = self.start(LONGER)
        self.await_line(process, stage)
        os.kill(ranks_of(process)[-1], signal.SIGKILL)
        process.communicate(timeout=60)
        self.assertNotEqual(process.returncode, 0)
        self.expect_earlier_output()

    def test_a_rank_dies_at_the_start(self):
        self.kill_rank_after("")

    def test_a_rank_dies_while_assembling(self):
        self.kill_rank_after("mesh")

    def test_a_rank_dies_while_solving_and_a_new_start_gives_the_same(self):
        self.kill_rank_after("assemble")
        self.reduce(*LONGER)
        once = self.eigenvalues()
        self.reduce(*LONGER, "-output", "again.h5")
        for a, b in zip(once, self.eigenvalues(), strict=True):
            self.assertAlmostEqual(a / b, 1, delta=1e-10)

    def test_files_that_may_not_grow(self):
        """The limit falls on both ranks between two stages."""
        for limit in (0, 4096, 300_000, 1_500_000):
            process = self.start(LONGER)
            self.await_line(process, "mesh")
            for pid in ranks_of(process):
                resource.prlimit(pid, resource.RLIMIT_FSIZE, (limit, limit))
            _, err = process.communicate(timeout=60)
            self.assertIn(process.returncode, (1, 2), err)
            self.assertEqual(len(sentences(err)), 1, err)
            self.expect_earlier_output()
            self.assertEqual(self.files(), set(EARLIER))

    def test_a_full_disk(self):
        """A small file system of its own, where the machine lets us mount one."""
        try_it = ["unshare", "-m", "mount", "-t", "tmpfs", "none", str(self.folder)]
        if subprocess.run(try_it, capture_output=True).returncode != 0:
            self.skipTest("no file system may be mounted here")
        for size in ("64k", "600k", "1200k", "1700k"):
            script = ('mount -t tmpfs -o size=$0 none . && cd "$PWD" && echo earlier > model.h5 && '
                      'mpirun -n 2 "$@" >/dev/null; code=$?; ls; cat model.h5; exit $code')
            result = subprocess.run(["unshare", "-m", "sh", "-c", script, size, BIN / "ritz-reduce", *LONGER],
                                    cwd=self.folder, capture_output=True, text=True, timeout=60)
            self.assertIn(result.returncode, (1, 2), result.stderr)
            self.assertEqual(len(sentences(result.stderr)), 1, result.stderr)
            self.assertEqual(result.stdout, "model.h5\nearlier\n")


if __name__ == "__main__":
    unittest.main()
