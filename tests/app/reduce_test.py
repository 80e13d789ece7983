"""ritz-reduce as a program: what it prints, what it writes, what it takes over from an earlier run."""
import json
import math
import os
import pty
import re
import subprocess
import unittest
from pathlib import Path

import h5py
import numpy as np

from program import BOX, InAFolder

CLAMPED = [*BOX, "-fix", "xmin"]
CONFIG = Path(__file__).resolve().parents[2] / "config"

HELD = """*NODE
1, 0, 0, 0
2, 1, 0, 0
3, 0, 1, 0
4, 0, 0, 1
*ELEMENT, TYPE=C3D4, ELSET=BODY
1, 1, 2, 3, 4
*BOUNDARY
1, 1, 3
"""


def columns(body):
    return np.stack([body["basis/columns"][name][:] for name in sorted(body["basis/columns"])], axis=-1)


def contents(group):
    """All numbers and texts in a group, by their path."""
    found = {}
    for name, item in group.items():
        if isinstance(item, h5py.Group):
            found |= {f"{name}/{path}": data for path, data in contents(item).items()}
            found |= {f"{name}@{key}": value for key, value in item.attrs.items()}
        else:
            found[name] = item[()]
    return found


QUADRATIC = ["-mesh", "box:1,.4,.3/4,2,2/tet10"]  # which bends as it should, and is not warned of


def besides_linear_cells(warnings):
    return "".join(line for line in warnings.splitlines(keepends=True) if "linear cells" not in line)


class Fork(InAFolder):
    def test_the_prongs_swing_at_440_hz(self):
        """Against each other in the fork's plane x-y: found by the shape of the tips, not by its place."""
        self.reduce("-options_file", CONFIG / "fork.opts", "-mesh", CONFIG / "fork.msh", "-output", "model.h5",
                    "-modes", "6")
        body = self.body()
        left, right = (columns(body)[body[f"geometry/sets/tip_{side}/rows"][:]].mean(axis=0)
                       for side in ("left", "right"))
        apart = np.abs(right - left)
        opposing = (apart[0] > 10 * np.abs(right + left).max(axis=0)) & (apart[0] > 10 * apart[1:].max(axis=0))
        frequencies = [float(row["frequency_hz"]) for row in self.frequencies()]
        self.assertAlmostEqual(frequencies[np.flatnonzero(opposing)[0]], 440, delta=.005 * 440)


class MeshError(InAFolder):
    def errors(self, name):
        return [float(row["mesh_error"]) for row in self.frequencies(f"{name}.frequencies.csv")]

    def test_is_the_same_in_all_outputs_and_on_any_number_of_ranks(self):
        for cell in ("tet4", "tet10"):
            mesh = ["-mesh", f"box:1,.4,.3/4,2,2/{cell}", "-fix", "none", "-mesh_error"]
            one = self.reduce(*BOX, *mesh, "-output", "one.h5", "-summary", "one.json", ranks=1)
            self.reduce(*BOX, *mesh, "-output", "two.h5", ranks=2)
            errors = self.errors("one")
            self.assertEqual(errors[:6], [0] * 6)
            self.assertTrue(all(error > 1e-4 for error in errors[6:]), errors)
            self.assertNotIn("linear cells", one.err)
            printed = [float(value) / 100 for value in re.findall(r"mesh: about *([-+.\de]+) %", one.out)]
            np.testing.assert_allclose(printed, errors, rtol=.051)
            np.testing.assert_allclose(self.file("one.h5")["report/mesh_errors"][:], errors, rtol=1e-3)
            summary = json.loads((self.folder / "one.json").read_text())["modes"]["mesh_error"]
            np.testing.assert_allclose(summary, errors, rtol=1e-3)
            np.testing.assert_allclose(self.errors("two"), errors, rtol=1e-3)
            self.assertIn("mesh error of mode 7", self.inspect("one.h5").out)

    def test_is_reused_with_a_basis(self):
        basis = [*CLAMPED, "-mesh_error", "-derivatives", "2", "-basis", "6"]
        self.reduce(*basis, "-output", "one.h5")
        self.assertIn("reusing the basis", self.reduce(*basis, "-reuse", "one.h5", "-output", "two.h5").out)
        self.assertEqual(self.errors("two"), self.errors("one"))

    def test_is_absent_unless_asked_for(self):
        self.reduce(*CLAMPED)
        self.assertNotIn("mesh_error", self.frequencies()[0])
        self.assertNotIn("mesh_errors", self.file("model.h5")["report"])

    def test_is_refused_of_cells_of_which_it_knows_nothing(self):
        err = self.reduce(*BOX, "-mesh", "box:1,.4,.3/4,2,2/hex20", "-mesh_error", code=2).err
        self.assertRegex(err, "option -mesh_error: .* hex20; leave it out")
        self.assertEqual(self.files(), set())


class Files(InAFolder):
    def test_frequencies(self):
        self.reduce(*BOX)
        text = (self.folder / "frequencies.csv").read_text()
        axes = [f"{what}_{axis}" for what in ("effective_mass", "participation", "participation_about") for axis in "xyz"]
        self.assertEqual(text.splitlines()[0].split(","),
                         ["index", "kind", "frequency_hz", "eigenvalue", "residual", "certified", *axes])
        rows = self.frequencies()
        self.assertEqual([row["index"] for row in rows], [str(i + 1) for i in range(len(rows))])
        self.assertEqual([row["kind"] for row in rows], ["rigid"] * 6 + ["flexible"] * (len(rows) - 6))
        self.assertEqual({row["certified"] for row in rows}, {"inertia"})
        self.assertGreaterEqual(len(rows), 6 + 5)
        stored = self.body()["modes/eigenvalues"][:]
        for row, value in zip(rows, stored):
            self.assertAlmostEqual(float(row["eigenvalue"]), value, delta=1e-14 * value)
            self.assertAlmostEqual(float(row["frequency_hz"]), math.sqrt(value) / (2 * math.pi), delta=1e-13 * math.sqrt(value))
            self.assertLess(float(row["residual"]), 1e-8)
            for axis in "xyz":
                self.assertAlmostEqual(float(row["participation_" + axis])**2, float(row["effective_mass_" + axis]), delta=1e-8)
        self.assertGreaterEqual(max(len(re.sub(r"\D", "", row["eigenvalue"])) for row in rows), 14)
        for axis in "xyz":  # of a free body: all of it
            total = sum(float(row["effective_mass_" + axis]) for row in rows)
            self.assertAlmostEqual(total / self.body()["inertia/gram"][0, 0], 1, delta=1e-8)

    def test_mass_that_no_mode_holds_is_said(self):
        few = self.reduce(*CLAMPED, "-modes", "2").out
        self.assertIn("these modes hold only", few)
        self.assertNotIn("these modes hold only", self.reduce(*BOX).out)

    def test_no_modes_are_modes_too(self):
        self.assertIn("-modes 0", self.reduce(*CLAMPED, "-modes", "0", code=2).err)
        self.assertEqual(self.files(), set())
        self.assertNotIn("certified", self.reduce(*BOX, "-modes", "0").out)
        self.assertEqual([row["kind"] for row in self.frequencies()], ["rigid"] * 6)

    def test_all_modes_when_more_are_asked_for_than_there_are(self):
        self.reduce(*BOX, "-mesh", "box:1,1,1/1,1,1/tet4", "-modes", "100")
        self.assertEqual(len(self.frequencies()), 24)

    def test_the_surface_alone(self):
        self.reduce(*CLAMPED, "-output", "whole.h5")
        whole_values = self.eigenvalues(table="whole.frequencies.csv")
        self.reduce(*CLAMPED, "-surface_only", "-output", "surface.h5")
        whole, surface = self.body("whole.h5"), self.body("surface.h5")
        ids, kept = whole["geometry/vertex_ids"][:], surface["geometry/vertex_ids"][:]
        x = whole["geometry/points"][:]
        outside = (np.isclose(x, 0) | np.isclose(x, [1, .4, .3])).any(axis=1)
        np.testing.assert_array_equal(kept, ids[outside])
        self.assertLess(len(kept), len(ids))
        np.testing.assert_array_equal(surface["geometry/points"][:], x[outside])
        np.testing.assert_allclose(columns(surface), columns(whole)[outside], rtol=0, atol=1e-10)
        np.testing.assert_allclose(surface["inertia/gram"][:], whole["inertia/gram"][:], rtol=0, atol=1e-9)
        np.testing.assert_allclose(self.eigenvalues(table="surface.frequencies.csv"), whole_values, rtol=1e-12)

    def options(self):
        return {name.decode(): value.decode() for name, value in self.body().file["provenance/options"][:]}

    def test_options_are_kept_as_they_came_out(self):
        self.reduce(*BOX)
        self.assertEqual((self.options()["solver"], self.options()["fix"]), ("direct", "none"))
        self.reduce(*CLAMPED, "-solver", "iterative")
        self.assertEqual((self.options()["solver"], self.options()["fix"]), ("iterative", "xmin"))

    def test_what_no_factorization_counts_is_not_certified(self):
        for solver, word in (("direct", "inertia"), ("iterative", "no")):
            said = self.reduce(*CLAMPED, "-solver", solver).out
            self.assertEqual({row["certified"] for row in self.frequencies()}, {word})
            inspected = self.inspect("model.h5").out
            for text in (said, inspected):
                self.assertEqual("not certified" in text, solver == "iterative", text)

    def test_a_support_of_the_mesh_file(self):
        self.reduce("-mesh", self.write("m.inp", HELD), *BOX[2:-1], "2")
        self.assertEqual(self.options()["fix"], "the mesh file's own")

    def test_vertex_numbers_that_no_double_holds(self):
        ids = [2**53 + n for n in (1, 3, 5, 7)]
        points = ["0, 0, 0", "1, 0, 0", "0, 1, 0", "0, 0, 1"]
        self.write("m.inp", "*NODE\n" + "".join(f"{i}, {x}\n" for i, x in zip(ids, points)) +
                   f"*ELEMENT, TYPE=C3D4, ELSET=BODY\n1, {', '.join(map(str, ids))}\n")
        self.reduce("-mesh", "m.inp", *BOX[2:-1], "2")
        np.testing.assert_array_equal(np.sort(self.body()["geometry/vertex_ids"][:]), ids)

    def test_an_earlier_output_is_replaced(self):
        self.reduce(*CLAMPED)
        first = self.eigenvalues()
        self.reduce(*BOX)
        self.assertNotEqual(self.eigenvalues(), first)
        self.assertEqual(self.files(), {"model.h5", "model.hdf", "frequencies.csv"})


class Voice(InAFolder):
    def test_lines_where_nobody_watches(self):
        lines = self.reduce(*CLAMPED).out.splitlines()
        for stage in ("mesh", "assemble", "modes", "write"):
            self.assertEqual(len([l for l in lines if re.match(rf"\d{{4}}-\d\d-\d\d \d\d:\d\d:\d\d  {stage} ", l)]), 1, stage)
        self.assertFalse(any("\r" in line or "\033" in line for line in lines))
        self.assertTrue(any(line.startswith("certified: ") for line in lines))

    def test_lines_where_a_shell_starts_each_rank(self):
        """Which has the terminal that mpirun gives it, though nobody looks at it."""
        out = self.reduce(*CLAMPED, under=("sh", "-c", '"$@"; exit $?', "sh")).out
        self.assertRegex(out, r"(?m)^\d{4}-\d\d-\d\d .*  modes ")
        self.assertNotIn("\033", out)

    def on_a_terminal(self, *words):
        """What ritz-reduce writes to one, whose ends of line are \\r\\n."""
        ours, theirs = pty.openpty()
        with os.fdopen(ours, "rb", buffering=0) as screen:
            run = self.bench.start("ritz-reduce", *words, stdout=theirs, stderr=None, stdin=subprocess.DEVNULL)
            os.close(theirs)
            written = b""
            try:
                while piece := screen.read(4096):
                    written += piece
            except OSError:  # the other end is closed
                pass
        self.assertEqual(run.wait(), 0)
        return written.decode()

    def test_one_updating_line_a_stage_on_a_terminal(self):
        lines = [line.rstrip("\r").split("\r\033[K") for line in self.on_a_terminal(*CLAMPED, *QUADRATIC).split("\n")]
        self.assertNotRegex("".join(map("".join, lines)), r"[\r\033]")
        for stage in ("mesh", "assemble", "modes", "inertia", "loads", "write"):
            (*updates, _), = [line for line in lines if re.fullmatch(rf"{stage} +\d+\.\d\d s", line[-1])]
            self.assertEqual(updates[0], "")
            self.assertGreater(len(updates), 1)
            for update in updates[1:]:
                self.assertRegex(update, rf"^{stage}(: [a-z ]+)?  +\d+ %  \d+ s(, about \d+ s left)?$")
        self.assertEqual([len(line) for line in lines if line[-1].startswith("certified: ")], [1])

    def test_details_are_for_those_who_ask(self):
        words = [*CLAMPED, "-derivatives", "2", "-polynomial"]
        said, told = self.reduce(*words, ranks=1).out, self.reduce(*words, "-verbose", ranks=1).out
        for detail in ("residual ", "participation factors", "Sturm", "singular values", "Taylor", "quartic", "orthonormal"):
            self.assertNotIn(detail, said)
            self.assertIn(detail, told)
        self.assertIn("take more modes, or add -residual_vectors", said)
        self.assertIn("contradict each other", self.reduce(*CLAMPED, "-verbose", "-quiet", code=2).err)

    def test_quiet(self):
        result = self.reduce(*[word.replace("tet4", "tet10") for word in CLAMPED], "-quiet")
        self.assertEqual((result.out, result.err), ("", ""))

    def test_help_is_printed_once_and_nothing_run(self):
        for word in ("-help", "--help"):
            text = self.reduce(word).out
            self.assertEqual(text.count("usage:"), 1)
            for option in ("mesh", "fix", "modes", "material_young", "units", "output", "reuse", "export", "plan"):
                self.assertEqual(len(re.findall(rf"^  -{option}\b", text, re.M)), 1, option)
        self.assertEqual(self.files(), set())

    def test_versions(self):
        for program, word, ranks in (("ritz-reduce", "-version", 2), ("ritz-full", "--version", 2),
                                     ("ritz-run", "--version", 0), ("ritz-inspect", "--version", 0)):
            with self.subTest(program):
                text = self.bench.run(program, word, ranks=ranks).out
                self.assertRegex(text.splitlines()[0], rf"^{program} \d+\.\d+\.\d+$")
                self.assertEqual(text.count("PETSc:"), 1 if ranks else 0)

    def kernels(self, **environment):
        """What is said of OpenBLAS and its kernels, where it can choose among them."""
        text = self.bench.run("ritz-reduce", "-version", ranks=1, environment=environment).out
        blas = re.search(r"^BLAS: (OpenBLAS .*)$", text, re.M)
        if not blas or "DYNAMIC_ARCH" not in blas[1]:
            self.skipTest("the BLAS has kernels for one processor only")
        return blas[1]

    def test_kernels_of_the_blas_are_no_older_than_the_processor(self):
        flags = set(re.search(r"^flags\s*:(.*)$", Path("/proc/cpuinfo").read_text(), re.M)[1].split())
        if not {"avx2", "fma"} <= flags:
            self.skipTest("the processor has no AVX2")
        self.assertNotRegex(self.kernels(OPENBLAS_CORETYPE=None), "Prescott|Core2|Nehalem|Barcelona")
        self.assertIn("Nehalem", self.kernels(OPENBLAS_CORETYPE="Nehalem"))  # as the user says

    def test_plan_writes_nothing(self):
        plan = self.reduce(*CLAMPED, "-plan", "-solver", "direct", ranks=1).out
        self.assertIn("modes", plan)
        self.assertRegex(plan, r"two factorizations \d+\.\d s, block Lanczos \d+\.\d s")
        self.assertRegex(plan, r"over 1 rank\n")
        self.assertEqual(self.files(), set())

    def plan(self, *words, ranks=2):
        """The stages of a plan with what it says of each, and the bytes of a rank."""
        text = self.reduce(*CLAMPED, "-plan", "-solver", "direct", *words, ranks=ranks).out
        stages = dict(re.findall(r"^  (\w[\w ]*?) +\d+\.\d s   (.*)$", text, re.M))
        return stages, float(re.match(r"(\d+\.\d+) GB a rank", stages["in all"])[1])

    def test_plan_has_the_stages_that_are_asked_for(self):
        linear = ["mesh", "assemble", "modes", "write", "in all"]
        self.assertEqual(list(self.plan()[0]), linear)
        stages, _ = self.plan("-derivatives", "4", "-basis", "8", "-polynomial")
        self.assertEqual(list(stages), [*linear[:3], "basis", "polynomial", "check", *linear[3:]])
        self.assertIn("the first factor is kept", stages["modes"])
        self.assertRegex(stages["basis"], r"10 derivatives: loads .* s, solves .* s; principal directions of 15 vectors")
        self.assertIn("8 coordinates, 44 terms of a strain", stages["polynomial"])
        self.assertEqual(stages["check"], "of the derivatives and of the polynomial")
        stages, _ = self.plan("-derivatives", "4")
        self.assertEqual(list(stages), [*linear[:3], "basis", "check", *linear[3:]])
        stages, _ = self.plan("-polynomial", "-basis_modes", "1,3")
        self.assertEqual(list(stages), [*linear[:3], "basis", "polynomial", "check", *linear[3:]])
        self.assertNotIn("kept", stages["modes"])
        self.assertIn("principal directions of 2 vectors", stages["basis"])

    def test_plan_has_the_error_of_the_mesh(self):
        stages, _ = self.plan("-mesh_error")
        self.assertEqual(list(stages), ["mesh", "assemble", "modes", "mesh error", "write", "in all"])
        self.assertIn("a factorization, one step on quadratic cells", stages["mesh error"])

    def test_plan_of_a_search_for_an_accurate_basis(self):
        self.write("s.toml", '[static]\nsteps = 1\n[[load]]\nset = "xmax"\ntotal = [0, 0, -1]\n')
        stages, _ = self.plan("-accuracy", "1e-2", "-accuracy_scene", "s.toml")
        self.assertEqual(list(stages), ["mesh", "assemble", "full statics", "modes", "basis", "polynomial", "check",
                                        "write", "in all"])
        self.assertIn("a search, through about 15 derivatives", stages["basis"])
        self.assertIn("the first factor is kept", stages["modes"])

    def test_plan_counts_snapshots(self):
        np.save(self.folder / "s.npy", np.ones((6, 135)))
        self.assertIn(" of 6 vectors", self.plan("-modes", "0", "-snapshots", "s.npy")[0]["basis"])
        np.save(self.folder / "s.npy", np.ones((6, 134)))
        self.reduce(*CLAMPED, "-plan", "-snapshots", "s.npy", code=2)

    def test_plan_holds_two_factors_beside_derivatives(self):
        box = ["-mesh", "box:4,1,1/40,8,8/tet4"]
        linear, both = (self.plan(*box, *words)[1] for words in ([], ["-derivatives", "2"]))
        self.assertGreater(both, linear)

    def test_plan_of_what_is_left_when_a_basis_is_reused(self):
        words = ["-derivatives", "2", "-basis", "6"]
        self.reduce(*CLAMPED, *words)
        stages, _ = self.plan(*words, "-polynomial", "-reuse", "model.h5")
        self.assertEqual(list(stages), ["mesh", "assemble", "polynomial", "check", "write", "in all"])
        self.assertEqual(stages["check"], "of the polynomial")

    def test_log_view_shows_the_stages(self):
        self.write("a.opts", "-log_view\n")
        for words in (["-log_view"], ["-options_file", "a.opts"]):
            text = self.reduce(*CLAMPED, *words).out
            for stage in ("mesh", "assemble", "modes", "inertia", "loads", "write"):
                self.assertRegex(text, rf"Event Stage \d+: {stage}|\d+: +{stage}:")


class Reuse(InAFolder):
    def setUp(self):
        super().setUp()
        self.reduce(*CLAMPED, "-output", "old.h5")

    def again(self, *words):
        result = self.reduce(*CLAMPED, "-reuse", "old.h5", *words)
        return result.out, besides_linear_cells(result.err)

    def test_of_the_same_problem(self):
        before = self.eigenvalues(table="old.frequencies.csv")
        out, err = self.again()
        self.assertRegex(out, r"reusing \d+ modes of old\.h5")
        self.assertEqual(err, "")
        np.testing.assert_allclose(self.eigenvalues(), before, rtol=1e-11)
        np.testing.assert_allclose(columns(self.body()), columns(self.body("old.h5")), rtol=0, atol=1e-8)

    def test_on_another_number_of_ranks_and_for_more_modes(self):
        before = self.eigenvalues(table="old.frequencies.csv")
        self.assertIn("reusing", self.reduce(*CLAMPED, "-reuse", "old.h5", "-modes", "9", ranks=3).out)
        self.assertGreaterEqual(len(self.eigenvalues()), 9)
        np.testing.assert_allclose(self.eigenvalues()[:len(before)], before, rtol=1e-10)
        self.assertEqual({row["certified"] for row in self.frequencies()}, {"inertia"})

    def test_says_why_not(self):
        for words, why in [(["-mesh", "box:1,.4,.3001/4,2,2/tet4"], "another mesh"),
                           (["-material_young", "2e6"], "materials or supports"),
                           (["-fix", "xmax"], "materials or supports"),
                           (["-fix", "xmin:xy"], "materials or supports")]:
            out, err = self.again(*words)
            self.assertNotIn("reusing", out)
            self.assertEqual(len(err.splitlines()), 1, err)
            self.assertIn("nothing is reused of old.h5", err)
            self.assertIn(why, err)

    def test_says_that_a_surface_is_too_little(self):
        self.reduce(*CLAMPED, "-surface_only", "-output", "old.h5")
        self.assertIn("surface", self.again()[1])


class ReuseOfABasis(InAFolder):
    BASIS = ["-modes", "5", "-derivatives", "3", "-basis", "7"]

    def setUp(self):
        super().setUp()
        self.reduce(*CLAMPED, *self.BASIS, "-output", "old.h5", ranks=1)

    def again(self, *words, ranks=1):
        result = self.reduce(*CLAMPED, "-reuse", "old.h5", *words, ranks=ranks)
        return result.out, besides_linear_cells(result.err)

    def assert_nothing_reused(self, words, why):
        out, err = self.again(*words)
        self.assertNotIn("reusing", out)
        self.assertEqual(len(err.splitlines()), 1, err)
        self.assertIn("nothing is reused of old.h5", err)
        self.assertIn(why, err)

    def test_adds_the_polynomial(self):
        table = self.frequencies("old.frequencies.csv")
        out, err = self.again(*self.BASIS, "-polynomial", "-verbose")
        self.assertEqual(err, "")
        self.assertIn("reusing the basis of 7 columns of old.h5", out)
        self.assertIsNone(re.search(r" (modes|basis)  +\d+\.\d+ s$", out, re.M))
        self.assertIn("certified: ", out)
        self.assertRegex(out, r"the power [23]\.\d+ of the amplitude")
        old, new = self.body("old.h5"), self.body()
        np.testing.assert_array_equal(columns(new), columns(old))
        self.assertNotIn("polynomial", old)
        self.assertIn("polynomial", new)
        for part in ("modes", "reduction", "inertia"):
            for name, data in contents(old[part]).items():
                np.testing.assert_array_equal(contents(new[part])[name], data, f"{part}/{name}")
        for new_row, old_row in zip(self.frequencies(), table, strict=True):  # without the vectors of the modes
            self.assertEqual(new_row, {name: old_row[name] for name in new_row})
            self.assertNotIn("effective_mass_x", new_row)
        before, after = self.report("old.h5")[1], self.report("model.h5")[1]
        for name in ("derivatives_solved", "basis_orthonormality", "witness_taylor_slope", "eigensolver_iterations"):
            self.assertEqual(after[name], before[name], name)
        self.inspect("model.h5", "--check")

    def test_on_another_number_of_ranks(self):
        self.assertIn("reusing the basis", self.again(*self.BASIS, ranks=3)[0])
        np.testing.assert_array_equal(columns(self.body()), columns(self.body("old.h5")))

    def test_of_a_model_that_reused_it(self):
        self.again(*self.BASIS, "-output", "new.h5")
        out = self.reduce(*CLAMPED, *self.BASIS, "-reuse", "new.h5", "-polynomial", ranks=1).out
        self.assertIn("reusing the basis of 7 columns of new.h5", out)

    def test_says_why_not(self):
        made = "-modes 5 -modes_tolerance 1e-10 -derivatives 3 -basis 7"
        for words in (["-basis", "6"], ["-derivatives", "2"], ["-modes", "6"], ["-basis_modes", "1,2,3"]):
            with self.subTest(words=words):
                self.assert_nothing_reused([*self.BASIS, *words], f"its basis was made with {made}")
        self.assert_nothing_reused([*self.BASIS[:4], "-basis_tolerance", "1e-2"], made)
        self.assert_nothing_reused([], made)
        self.assert_nothing_reused([*self.BASIS, "-material_young", "2e6"], "materials or supports")
        self.assert_nothing_reused([*self.BASIS, "-solver", "iterative"], "-solver direct")
        self.assert_nothing_reused([*self.BASIS, "-export", "petsc"], "export")

    def test_looks_into_the_file_of_snapshots(self):
        rows = 3 * self.body("old.h5")["geometry/points"].shape[0]
        snapshots = ["-snapshots", "s.npy", "-basis", "4"]
        states = np.random.default_rng(1).random((3, rows))
        np.save(self.folder / "s.npy", states)
        self.reduce(*CLAMPED, *snapshots, "-output", "old.h5", ranks=1)
        self.assertIn("reusing the basis of 4 columns", self.again(*snapshots, "-polynomial")[0])
        np.save(self.folder / "s.npy", 2 * states)
        self.assert_nothing_reused(snapshots, "-snapshots s.npy (checksum ")


if __name__ == "__main__":
    unittest.main()
