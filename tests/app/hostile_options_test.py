"""An options file, a folder's own files of options, or a scene that somebody was sent: they run no command, load no
library, and end in one sentence."""
import os
import re
import shutil
import subprocess
import unittest

from program import BIN, BOX, InAFolder

SHELL = ":x;touch MARKER;.gz"
# A library that leaves its mark when it is loaded.
LIBRARY = '#include <fcntl.h>\n__attribute__((constructor)) static void mark(void) { open("MARKER", O_CREAT, 0600); }\n'
HOSTILE = [
    ("modes_eps_view", SHELL), ("modes_eps_monitor", SHELL), ("modes_eps_converged_reason", SHELL),
    ("modes_eps_view_values", SHELL), ("modes_eps_error_relative", SHELL), ("modes_st_ksp_view_mat", SHELL),
    ("modes_st_ksp_monitor", SHELL), ("solve_ksp_view", SHELL), ("solve_ksp_view_rhs", SHELL), ("log_view", SHELL),
    ("newton_snes_monitor", SHELL), ("mat_view", SHELL), ("vec_view", SHELL), ("options_monitor", SHELL),
    ("multigrid_pc_view", SHELL), ("log_trace", "MARKER"), ("malloc_dump", "MARKER"), ("history", "MARKER"),
    ("info", "MARKER"), ("log_view", "|touch MARKER"), ("log_view", ":$(touch MARKER)"), ("log_view", ":MARKER.gz"),
    ("modes_st_pc_type", "python"), ("modes_st_pc_python_type", "evil.PC"), ("solve_pc_type", "shell"),
    ("python", "./evil"), ("on_error_attach_debugger", "./evil"), ("start_in_debugger", "./evil"),
    ("solve_mat_mumps_ooc_tmpdir", "MARKER"), ("options_file_yaml", "evil.yaml"), ("options_string_yaml", "modes: 3"),
    ("modes_st_pc_hypre_type", "euclid"), ("solve_mat_mumps_icntl_3", "7"), ("viewer_binary_filename", "MARKER"),
]


class Hostile(InAFolder):
    def setUp(self):
        super().setUp()
        self.write("evil", "#!/bin/sh\ntouch MARKER\n")
        (self.folder / "evil").chmod(0o700)
        self.write("evil.yaml", "modes: 3\n")
        self.write("evil.py", "open('MARKER', 'w')\n")
        self.write("sysconfig.py", "open('MARKER', 'w')\n")

    def expect_one_sentence(self, result, before, *says):
        lines = result.err.splitlines()
        self.assertEqual(result.code, 2, result.err)
        self.assertEqual(len(lines), 1, result.err)
        self.assertNotIn("\x1b", result.err)
        for piece in says:
            self.assertIn(piece, lines[0])
        self.assertEqual(self.files(), before)

    def library(self):
        self.write("mark.c", LIBRARY)
        library = self.folder / "libmark.so"
        subprocess.run(["cc", "-shared", "-fPIC", "mark.c", "-o", library], cwd=self.folder, check=True)
        return library

    def test_options_of_a_file(self):
        for number, (name, value) in enumerate(HOSTILE):
            file, text = (("a.opts", f"-{name} '{value}'\n"), ("a.yaml", f"{name}: '{value}'\n"))[number % 2]
            with self.subTest(text):
                self.write(file, text)
                before = self.files()
                self.expect_one_sentence(self.run_alone(*BOX, "-options_file", file), before, f"-{name}")

    def test_options_of_a_command_line(self):
        for name, value in HOSTILE[::6]:
            with self.subTest(name):
                self.expect_one_sentence(self.run_alone(*BOX, f"-{name}", value), self.files(), f"-{name}")

    @unittest.skipUnless(shutil.which("cc"), "no C compiler")
    def test_a_library(self):
        library = self.library()
        for name in ("dll_append", "dll_prepend"):
            self.write("a.opts", f"-{name} {library}\n")
            self.expect_one_sentence(self.run_alone(*BOX, "-options_file", "a.opts"), self.files(), name)

    @unittest.skipUnless(shutil.which("cc"), "no C compiler")
    def test_libraries_of_the_current_folder(self):
        library = self.library()
        for program in ("ritz-reduce", "ritz-full", "ritz-run", "ritz-inspect", "ritz-scene"):
            needed = subprocess.run(["ldd", BIN / program], capture_output=True, text=True, check=True).stdout
            for name in re.findall(r"^\s*(lib\S+) =>", needed, re.M):
                shutil.copy(library, self.folder / name)
            result = self.run_alone("--help", program=program)
            self.assertEqual(result.code, 0, result.err)
            self.assertNotIn("MARKER", self.files())

    @unittest.skipUnless(shutil.which("cc"), "no C compiler")
    def test_petscs_own_files_are_not_read(self):
        library = self.library()
        home = self.folder / "home"
        home.mkdir()
        text = f"-dll_append {library}\n-modes 2\n-log_view :log\n"
        for place in (".petscrc", "petscrc", "home/.petscrc"):
            with self.subTest(place):
                self.write(place, text)
                result = self.run_alone(*BOX, "-quiet", environment={"HOME": str(home)})
                (self.folder / place).unlink()
                self.assertEqual(result.code, 0, result.err)
                self.assertRegex(result.err, rf"(?m)^warning: .*{re.escape(place)} are not read")
                self.assertFalse({"MARKER", "log"} & self.files())
                self.assertGreaterEqual(len(self.eigenvalues()), 5)

    def test_petscs_own_variables_are_not_read(self):
        for name, value in (("PETSC_OPTIONS", "-modes 2 -log_view :log"), ("PETSC_OPTIONS_YAML", "modes: 2")):
            with self.subTest(name):
                result = self.run_alone(*BOX, "-quiet", environment={name: value})
                self.assertEqual(result.code, 0, result.err)
                self.assertRegex(result.err, rf"(?m)^warning: .*{name} are not read")
                self.assertNotIn("log", self.files())
                self.assertGreaterEqual(len(self.eigenvalues()), 5)

    def test_a_report_takes_no_other_files_place(self):
        self.write("kept.txt", "kept")
        (self.folder / "link.txt").symlink_to("kept.txt")
        self.write("a.opts", "-modes 3\n")
        for name in ("model.h5", "frequencies.csv", "model_K.mtx", "link.txt", "a.opts", "none/log", "home/.."):
            with self.subTest(name):
                before = self.files()
                result = self.run_alone(*BOX, "-options_file", "a.opts", "-export", "matrixmarket", "-log_view", f":{name}")
                self.expect_one_sentence(result, before, "-log_view", name)
        for name in ("model.h5", "a.opts"):
            with self.subTest(plan=name):
                result = self.run_alone(*BOX, "-options_file", "a.opts", "-plan", "-log_view", f":{name}")
                self.expect_one_sentence(result, self.files(), "-log_view", name)
        self.assertEqual((self.folder / "kept.txt").read_text(), "kept")

    def test_a_wrong_option_leaves_no_report(self):
        self.expect_one_sentence(self.run_alone(*BOX, "-log_view", ":log", "-modes_eps_monitor", ":mon", "-modees", "3"),
                                 self.files(), "-modees")
        self.expect_one_sentence(self.run_alone(*BOX, "-log_view", ":log", "-fix", "nowhere"), self.files(), "nowhere")


class Reports(InAFolder):
    def test_of_the_log_in_each_format(self):
        for ranks, form, start in ((1, "", "***"), (2, "ascii_info_detail", "size"), (1, "ascii_csv", "Stage"),
                                   (2, "ascii_xml", "<?xml"), (1, "ascii_flamegraph", "")):
            with self.subTest(form):
                self.write("a.opts", f"-log_view :log:{form}\n")
                self.reduce(*BOX, "-options_file", "a.opts", "-quiet", ranks=ranks)
                text = (self.folder / "log").read_text().strip()
                self.assertTrue(text and text.startswith(start), text[:80])
                self.assertRegex(text, "modes|MatMatSolve")

    def test_of_a_solver(self):
        self.reduce(*BOX, "-quiet", "-modes_eps_view", ":view", "-modes_eps_monitor", ":mon", ranks=2)
        self.assertIn("EPS Object", (self.folder / "view").read_text())
        self.assertRegex((self.folder / "mon").read_text(), r"EPS nconv=\d")

    def test_a_wrong_one_is_one_sentence(self):
        for words in (["-log_view", ":x:bogus"], ["-log_view", "x"], ["-modes_eps_type", "nonsense"],
                      ["-solve_pc_type", "nonsense"], ["-multigrid_pc_gamg_threshold", "x"], ["-modes_eps_tol", "x"],
                      ["-newton_snes_max_it", "x"], ["-solve_mat_mumps_icntl_14", "x"]):
            for given in (words, ["-options_file", "a.opts"]):
                self.write("a.opts", " ".join(words) + "\n")
                with self.subTest(given=given, words=words):
                    before = self.files()
                    result = self.run_alone(*BOX, *given)
                    self.assertEqual(result.code, 2, result.err)
                    self.assertEqual(len(result.err.splitlines()), 1, result.err)
                    self.assertEqual(self.files(), before)


class Lengths(InAFolder):
    """No value is cut: the last of many supports counts."""

    def free(self, *words):
        self.reduce(*words, "-summary", "s.json", ranks=1)
        return self.bench.summary("s.json")["problem"]["degrees_of_freedom"]

    def test_of_a_value(self):
        expected = self.free(*BOX, "-fix", "xmin,xmax")
        for length in (4100, 70000):
            names = "xmin:x," * (length // 7)
            value = names + "xmin," + "xmax"
            self.write("a.opts", f"-fix {value}\n")
            self.write("a.yaml", f"fix: {value}\n")
            for words in (["-fix", value], ["-options_file", "a.opts"], ["-options_file", "a.yaml"]):
                with self.subTest(length=length, words=words[0]):
                    self.assertEqual(self.free(*BOX, *words), expected)


class Pipes(InAFolder):
    def test_are_no_inputs(self):
        os.mkfifo(self.folder / "pipe")
        os.mkfifo(self.folder / "pipe.msh")
        os.mkfifo(self.folder / "pipe.yaml")
        self.write("s.toml", "[time]\nstep = .1\nend = 1\n")
        for program, words in (("ritz-reduce", [*BOX, "-options_file", "pipe"]),
                               ("ritz-reduce", [*BOX, "-options_file", "pipe.yaml"]),
                               ("ritz-reduce", ["-mesh", "pipe.msh"]),
                               ("ritz-reduce", [*BOX, "-accuracy", ".1", "-accuracy_scene", "pipe"]),
                               ("ritz-full", [*BOX, "-scene", "pipe"]), ("ritz-full", [*BOX, "-scene", "/dev/zero"])):
            with self.subTest(program=program, words=words[-1]):
                result = self.run_alone(*words, program=program, limit=30)
                self.assertEqual(result.code, 2, result.err)
                self.assertIn("not a regular file", result.err)


if __name__ == "__main__":
    unittest.main()
