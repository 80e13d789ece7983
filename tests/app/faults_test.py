"""A rank that dies, memory that runs out, a disk that fills: the program ends, the earlier output is intact, a new start
gives the same."""
import os
import re
import resource
import signal
import subprocess
import time
import unittest
from pathlib import Path

import h5py
import numpy as np

import programs
from program import BOX, sentences
from ranks_test import Compared

MODES = [*BOX, "-fix", "xmin", "-quiet"]
LONGER = [*BOX, "-fix", "xmin", "-mesh", "box:1,.4,.3/12,5,5/tet10", "-modes", "60"]
LARGE = [*LONGER, "-modes", "200"]  # to write: 15 MB
NONLINEAR = [*LONGER, "-mesh", "box:1,.4,.3/8,4,4/tet10", "-modes", "12", "-derivatives", "8", "-basis", "20",
             "-polynomial"]
FULL = [*BOX[2:-2], "-mesh", "box:1,.15,.1/12,3,2/hex8", "-fix", "xmin", "-scene", "scene.toml"]
SWING = '[time]\nstep = 0.02\nend = 1\n[[load]]\nset = "xmax"\ntotal = [0, 2, 4]\n'
EARLIER = {"model.h5": "an earlier model", "frequencies.csv": "earlier frequencies"}


def await_that(condition):
    """False when it did not come in time."""
    deadline = time.monotonic() + 60
    while not condition():
        if time.monotonic() > deadline:
            return False
        time.sleep(0.001)
    return True


def ranks_of(mpirun):
    listed = subprocess.run(["ps", "-o", "pid=", "--ppid", str(mpirun.pid)], capture_output=True, text=True).stdout
    return sorted(map(int, listed.split()))


class Faulty(Compared):
    def setUp(self):
        super().setUp()
        self.write_earlier_output()

    def write_earlier_output(self):
        for path in self.folder.glob("model.*"):
            path.unlink()
        for name, text in EARLIER.items():
            self.write(name, text)

    def start(self, words, program="ritz-reduce"):
        return self.bench.start(program, *words)

    def expect_earlier_output(self):
        self.assertEqual({name: (self.folder / name).read_text() for name in EARLIER}, EARLIER)


class Killed(Faulty):
    def kill_rank(self, process, wait):
        """Kills the last rank at once when `wait(process)` returns."""
        self.assertTrue(await_that(lambda: len(ranks_of(process)) == 2))
        victim = ranks_of(process)[-1]
        wait(process)
        os.kill(victim, signal.SIGKILL)
        process.communicate(timeout=60)
        self.assertNotEqual(process.returncode, 0)
        self.expect_earlier_output()

    def half_a_file(self, process):
        self.after("loads")(process)
        self.part("model.h5")(process)

    def test_a_rank_dies_in_any_stage_and_a_new_start_gives_the_same(self):
        waits = {"mesh": lambda process: None}
        before = ("mesh", "assemble", "modes", "basis", "check", "polynomial")
        waits |= {f"what follows {stage}": self.after(stage) for stage in before}
        for name, wait in waits.items():
            with self.subTest(name):
                self.kill_rank(self.start(NONLINEAR), wait)
        self.kill_rank(self.start(LARGE), self.half_a_file)
        self.reduce(*NONLINEAR)
        self.reduce(*NONLINEAR, "-output", "again.h5")
        one, other = self.body(), self.body("again.h5")
        self.expect_same_values(one, other)
        self.expect_same_span(one, other)

    def test_a_rank_of_the_full_model_dies(self):
        self.write("scene.toml", SWING)
        self.write("full.h5", "an earlier motion")
        waits = {"mesh": lambda process: None, "assemble": self.after("mesh"), "run": self.after("assemble")}
        for stage, wait in waits.items():
            with self.subTest(stage):
                self.kill_rank(self.start(FULL, "ritz-full"), wait)
                self.assertEqual((self.folder / "full.h5").read_text(), "an earlier motion")
        states = []
        for name in ("full.h5", "again.h5"):
            self.full(*FULL, "-output", name, "-quiet", limit=60)
            with h5py.File(self.folder / name) as file:
                states.append(file["state/displacement"][:])
        self.assertLess(np.abs(states[0] - states[1]).max(), 1e-10 * np.abs(states[0]).max())


class Short(Faulty):
    """Of memory, or of disk space, on all ranks."""

    def test_the_factorization_fails(self):
        for option, value, word in (("23", "1", "memory ran out"), ("14", "-90", "the factorization of K")):
            with self.subTest(word):
                process = self.start([*NONLINEAR, "-mesh", "box:1,.4,.3/24,8,8/hex8", "-quiet",
                                      f"-solve_mat_mumps_icntl_{option}", value])
                _, err = process.communicate(timeout=60)
                self.assertEqual(process.returncode, 1, err)
                self.assertEqual(len(sentences(err)), 1, err)
                self.assertIn(word, err)
                self.expect_earlier_output()
                self.assertEqual(self.files(), set(EARLIER))

    def test_files_that_may_not_grow(self):
        """The limit falls on both ranks between two stages."""
        for limit in (0, 4096, 300_000, 1_500_000):
            process = self.start(LONGER)
            self.after("mesh")(process)
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
            result = self.run_alone(*LONGER, under=["unshare", "-m", "sh", "-c", script, size])
            self.assertIn(result.code, (1, 2), result.err)
            self.assertEqual(len(sentences(result.err)), 1, result.err)
            self.assertEqual(result.out, "model.h5\nearlier\n")


class Limited(Faulty):
    """Of address space, from the start: OpenBLAS would ask for its work space for ever."""

    def run_in(self, megabytes, program, words, ranks=0):
        script = f"ulimit -v {megabytes * 1024}; exec \"$@\""
        return self.run_alone(*words, program=program, ranks=ranks, under=["bash", "-c", script, "-"],
                              environment=dict.fromkeys(programs.ONE_THREAD))

    def test_from_too_little_to_enough(self):
        self.write("scene.toml", SWING.replace("end = 1", "end = 0.04"))
        for program, words in (("ritz-reduce", MODES), ("ritz-full", [*FULL, "-quiet"])):
            for megabytes in (350, 420, 460, 480, 2000):
                with self.subTest(program=program, megabytes=megabytes):
                    result = self.run_in(megabytes, program, words)
                    self.assertIn(result.code, (0,) if megabytes == 2000 else (0, 1), result.err)
                    if result.code == 0:
                        self.write_earlier_output()
                        continue
                    self.assertEqual(len(sentences(result.err)), 1, result.err)
                    self.assertIn("memory ran out", result.err)
                    self.expect_earlier_output()
                    self.assertFalse([name for name in self.files() if name.endswith(".part")])

    def test_ranks(self):
        result = self.run_in(420, "ritz-reduce", MODES, ranks=2)
        self.assertEqual(result.code, 1, result.err)
        self.assertEqual(len(sentences(result.err)), 1, result.err)
        self.expect_earlier_output()


class Alone(Faulty):
    def test_a_rank_that_runs_out_of_memory_alone_takes_the_others_along(self):
        """Wherever it is, and whatever the others wait for, in Open MPI and in MUMPS too."""
        self.write("scene.toml", SWING)
        said = ""
        grows = [*NONLINEAR, "-mesh", "box:1,.4,.3/16,8,6/tet10"]  # by more than is free after the assembly
        for program, words, stage in (("ritz-reduce", grows, "assemble"), ("ritz-reduce", NONLINEAR, "modes"),
                                      ("ritz-reduce", NONLINEAR, "basis"), ("ritz-full", FULL, "assemble")):
            process = self.start(words, program)
            self.after(stage)(process)
            rank = ranks_of(process)[-1]
            status = Path(f"/proc/{rank}/status").read_text()
            size = 1024 * int(re.search(r"VmSize:\s+(\d+)", status)[1])
            resource.prlimit(rank, resource.RLIMIT_AS, (size, size))
            _, err = process.communicate(timeout=60)
            with self.subTest(f"{program} after {stage}"):
                if process.returncode == 0:  # it had enough
                    self.write_earlier_output()
                    continue
                said += err
                self.expect_earlier_output()
                self.assertEqual(self.files(), {*EARLIER, "scene.toml"})
        self.assertIn("ritz-reduce: memory ran out", said)  # not of all: what Open MPI needs may lack too


if __name__ == "__main__":
    unittest.main()
