"""-summary: what both programs print, as numbers that agree with their files; all of it or nothing."""
import json
import os
import re
import unittest
from pathlib import Path

import h5py
import numpy as np

from program import BOX, InAFolder, sentences

PAGE = (Path(__file__).parents[2] / "docs/summary.md").read_text()
HELD = [*BOX, "-fix", "xmin"]
PUSH = '[[load]]\nset = "xmax"\ntotal = [0, 0, {}]\n'
STATIC = "[static]\nsteps = 2\n" + PUSH
MOVING = "[time]\nstep = 0.01\nend = 0.2\n[damping]\nalpha = 0.2\n" + PUSH


def documented(*sections):
    """The keys that these sections of the page list at the top."""
    keys = set()
    for section in sections:
        text = PAGE.split(f"\n## {section}\n")[1].split("\n## ")[0]
        text = text.split("| key | value |")[1] if section != "`ritz-reduce` and `ritz-full`" else "| `problem` |"
        for row in re.findall(r"^\|([^|]*)\|", text, re.M):
            keys |= set(re.findall(r"`(\w+)`", row))
    return keys


class Summary(InAFolder):
    def scene(self, text, force):
        return ["-scene", self.write("scene.toml", text.format(force))]

    def summary(self, name="s.json"):
        def refuse(constant):
            raise ValueError(f"{constant} is no JSON")
        return json.loads((self.folder / name).read_text(), parse_constant=refuse)

    def assert_head(self, summary, program, output, ranks, warnings):
        self.assertEqual((summary["format"], summary["version"]), ("ritz-summary", 1))
        self.assertEqual((summary["program"], summary["output"], summary["ranks"]), (program, output, ranks))
        self.assertRegex(summary["program_version"], r"^\d+\.\d+\.\d+$")
        memory = summary["memory"]
        self.assertLessEqual(memory["largest_rank"], memory["all_ranks"])
        self.assertLessEqual(memory["all_ranks"], ranks * memory["largest_rank"])
        self.assertGreater(memory["largest_rank"], 1e6)
        self.assertEqual(summary["warnings"], warnings)

    def warnings(self, result):
        return [line.removeprefix("warning: ") for line in result.err.splitlines() if line.startswith("warning: ")]


class OfModels(Summary):
    def test_modes(self):
        said = self.reduce(*BOX, "-fix", "none", "-summary", "s.json")
        summary = self.summary()
        self.assertEqual(set(summary), documented("Of every program", "`ritz-reduce` and `ritz-full`", "`ritz-reduce`"))
        self.assert_head(summary, "ritz-reduce", "model.h5", 2, self.warnings(said))
        self.assertGreater(len(summary["warnings"]), 0)
        self.assertEqual([summary[key] for key in ("basis", "derivatives", "accuracy", "polynomial", "plan", "reused")],
                         5 * [None] + ["nothing"])
        seconds, figures = self.report()
        problem = summary["problem"]
        for key in ("vertices", "cells", "pieces", "dropped_vertices", "degrees_of_freedom"):
            self.assertEqual(problem[key], figures[key], key)
        self.assertEqual(problem["named_sets"], len(self.body()["geometry/sets"]))
        np.testing.assert_allclose(problem["size"], [1, .4, .3], rtol=1e-12)
        np.testing.assert_allclose(problem["mass"], 120, rtol=1e-12)
        np.testing.assert_allclose(summary["inertia"]["centre_of_mass"], [.5, .2, .15], rtol=1e-12)
        np.testing.assert_allclose(np.diag(summary["inertia"]["tensor"]),
                                   10 * np.array([.16 + .09, 1 + .09, 1 + .16]), rtol=1e-12)
        times = {row["stage"]: row["seconds"] for row in summary["stages"]}
        self.assertEqual([*times][:-1], [stage for stage, _ in seconds])
        self.assertEqual([*times][-1], "write")
        for stage, took in seconds:
            self.assertEqual(times[stage], took, stage)

        modes, rows = summary["modes"], self.frequencies()
        self.assertEqual((modes["rigid"], modes["flexible"], modes["solver"]), (6, 5, "direct"))
        self.assertEqual(modes["iterations"], figures["eigensolver_iterations"])
        self.assertEqual(modes["kind"], [row["kind"] for row in rows])
        for key in ("frequency_hz", "eigenvalue", "residual"):
            np.testing.assert_allclose(modes[key], [float(row[key]) for row in rows], rtol=1e-14, err_msg=key)
        np.testing.assert_array_equal(modes["eigenvalue"], self.body()["modes/eigenvalues"][:])
        self.assertEqual(modes["certificate"]["kind"], rows[0]["certified"])
        self.assertEqual(modes["certificate"]["counted"], modes["certificate"]["found"])
        self.assertAlmostEqual(modes["certificate"]["shift_hz"] * 2 * np.pi, modes["certificate"]["shift"] ** .5)
        self.assertEqual(np.shape(modes["participation"]), (11, 6))
        np.testing.assert_allclose(np.sum(modes["effective_mass"], axis=0), 3 * [120], rtol=1e-9)
        np.testing.assert_allclose(np.square(modes["participation"])[:, :3], modes["effective_mass"], atol=1e-9)
        self.assertLessEqual(modes["orthonormality"], 1e-12)

    def test_a_nonlinear_model(self):
        words = [*HELD, "-derivatives", "3", "-basis", "7", "-polynomial"]
        said = self.reduce(*words, "-summary", "s.json")
        summary = self.summary()
        _, figures = self.report()
        reduction = self.body()["reduction"]
        basis = summary["basis"]
        self.assertEqual(basis["columns"], 7)
        np.testing.assert_array_equal(basis["singular_values_kept"] + basis["singular_values_left_out"],
                                      reduction["singular_values"][:])
        self.assertEqual(len(basis["singular_values_kept"]), 7)
        self.assertEqual(basis["orthonormality"], figures["basis_orthonormality"])
        for key, name in (("pairs", "derivative_pairs"), ("solved", "derivatives_solved"),
                          ("skipped", "derivatives_skipped"), ("iterations", "derivative_iterations"),
                          ("residual", "derivative_residual"), ("taylor_slope", "witness_taylor_slope")):
            self.assertEqual(summary["derivatives"][key], figures[name], key)
        polynomial = summary["polynomial"]
        self.assertEqual([polynomial[key] for key in ("coordinates", "quadratic", "cubic", "quartic")], [7, 28, 84, 210])
        for key in ("force", "energy", "stiffness"):
            self.assertEqual(polynomial["witness"][key], figures[f"witness_{key}"], key)
        share = re.search(r"effective mass of the basis, all columns: (\S+) % (\S+) (\S+)", said.out)
        np.testing.assert_allclose(100 * np.array(basis["effective_mass"]) / summary["problem"]["mass"],
                                   [float(x) for x in share.groups()], atol=.006)

        self.reduce(*words, "-reuse", "model.h5", "-output", "again.h5", "-summary", "again.json")
        again = self.summary("again.json")
        self.assertEqual(again["reused"], "basis")
        self.assertEqual((again["derivatives"], again["modes"]["iterations"]),
                         (summary["derivatives"], summary["modes"]["iterations"]))
        self.assertEqual((again["modes"]["effective_mass"], again["modes"]["participation"]), (None, None))
        self.assertEqual(self.report("again.h5")[1].keys(), figures.keys())

    def test_a_target_for_the_error(self):
        self.scene(STATIC, -5)
        self.reduce(*HELD, "-accuracy", "2e-2", "-accuracy_scene", "scene.toml", "-summary", "s.json", ranks=1)
        summary, (_, figures) = self.summary(), self.report()
        for key in ("target", "error", "modes", "columns"):
            self.assertEqual(summary["accuracy"][key], figures[f"accuracy_{key}"], key)
        self.assertEqual(summary["accuracy"]["target"], 2e-2)
        self.assertEqual(summary["accuracy"]["columns"], summary["basis"]["columns"])

    def test_a_plan(self):
        said = self.reduce(*HELD, "-derivatives", "2", "-plan", "-summary", "s.json").out
        self.assertEqual(self.files(), {"s.json"})
        summary = self.summary()
        self.assertEqual(set(summary), documented("Of every program", "`ritz-reduce` and `ritz-full`", "`ritz-reduce`"))
        plan = summary["plan"]
        self.assertIsNone(summary["modes"])
        self.assertEqual([row["stage"] for row in plan["stages"]], ["modes", "basis", "check", "write"])
        coming, done = (sum(row["seconds"] for row in rows) for rows in (plan["stages"], summary["stages"]))
        self.assertAlmostEqual(plan["seconds"], coming + done)
        self.assertEqual(f"{plan['seconds']:.1f}", re.search(r"in all +(\S+) s", said)[1])
        self.assertEqual(f"{plan['memory']['all_ranks'] / 1e9:.2f}", re.search(r"(\S+) GB over 2 ranks", said)[1])
        self.assertEqual(max(row["memory"] for row in plan["stages"]), plan["memory"]["largest_rank"])


class OfMotions(Summary):
    def timing(self):
        return self.table("t.csv")[1]

    def test_dynamics(self):
        said = self.full(*HELD, *self.scene(MOVING, 30), "-timing", "t.csv", "-summary", "s.json", "-frames", "1")
        summary, cost = self.summary(), self.timing()
        self.assertEqual(set(summary), documented("Of every program", "`ritz-reduce` and `ritz-full`", "`ritz-full`"))
        self.assert_head(summary, "ritz-full", "full.h5", 2, self.warnings(said))
        self.assertEqual((summary["analysis"], summary["integrator"], summary["start"]), ("dynamics", "avf", 0))
        self.assertEqual((summary["steps"], len(cost)), (20, 20))
        self.assertAlmostEqual(summary["end"], .2)
        self.assertEqual(summary["newton_iterations"], cost[:, 2].sum())
        self.assertEqual(summary["rejected_steps"], cost[:, 3].sum())
        self.assertEqual(summary["factorizations"], summary["newton_iterations"], "one for each of Newton's matrices")
        self.assertLessEqual(cost[:, 1].sum() * 1e-6, summary["seconds"])
        self.assertEqual([row["stage"] for row in summary["stages"]], ["mesh", "assemble", "run", "write"])
        self.assertEqual(summary["seconds"], summary["stages"][2]["seconds"])
        t, kinetic, elastic, work, dissipated, drift = self.table("energy.csv")[1].T
        energy = summary["energy"]
        for key, value in (("start", kinetic[0] + elastic[0]), ("kinetic", kinetic[-1]), ("elastic", elastic[-1]),
                           ("work", work[-1]), ("dissipated", dissipated[-1]), ("largest", (kinetic + elastic).max()),
                           ("gained", max(0, drift.max())), ("lost", max(0, -drift.min())),
                           ("largest_drift", np.abs(drift).max())):
            np.testing.assert_allclose(energy[key], value, rtol=1e-13, atol=1e-300, err_msg=key)
        self.assertGreater(energy["dissipated"], 0)
        self.assertEqual(summary["elastic_energy"], energy["elastic"])
        self.full(*HELD, *self.scene(MOVING.replace("0.2\n[d", "0.3\n[d"), 30), "-restart", "full.h5", "-quiet",
                  "-summary", "on.json")
        again = self.summary("on.json")
        self.assertEqual((again["start"], again["steps"]), (summary["end"], 10))

    def test_a_motion_that_gains_and_loses(self):
        for integrator in ("newmark", "implicit-euler"):
            text = MOVING.replace("end =", f'integrator = "{integrator}"\nend =')
            self.full(*HELD, *self.scene(text, 300), "-summary", "s.json", ranks=1)
            summary = self.summary()
            self.assertEqual(summary["integrator"], integrator)
            drift = self.table("energy.csv")[1][:, 5]
            self.assertGreater(summary["energy"]["largest_drift"], 0)
            np.testing.assert_allclose([summary["energy"]["gained"], summary["energy"]["lost"]],
                                       [max(0, drift.max()), max(0, -drift.min())], rtol=1e-13)

    def test_statics(self):
        self.full(*HELD, *self.scene(STATIC, 30), "-timing", "t.csv", "-summary", "s.json", ranks=1)
        summary, cost = self.summary(), self.timing()
        self.assertEqual(set(summary), documented("Of every program", "`ritz-reduce` and `ritz-full`", "`ritz-full`"))
        self.assertEqual((summary["analysis"], summary["integrator"], summary["energy"]), ("statics", None, None))
        self.assertEqual((summary["start"], summary["end"], summary["steps"]), (0, 1, 2))
        self.assertEqual(summary["newton_iterations"], cost[:, 2].sum())
        self.assertEqual((summary["rejected_steps"], summary["inverted_cells"]), (cost[:, 3].sum(), 0))
        with h5py.File(self.folder / "full.h5") as file:
            self.assertEqual(summary["elastic_energy"], file["state"].attrs["elastic"])


class Nothing(Summary):
    def refused(self, result, *says):
        said = sentences(result.err)
        self.assertEqual(len(said), 1, said)
        for piece in says:
            self.assertIn(piece, said[0])

    def test_without_the_option(self):
        self.reduce(*HELD, "-quiet")
        self.full(*HELD, *self.scene(STATIC, 1), "-quiet", "-frames", "0")
        self.assertFalse([name for name in self.files() if name.endswith(".json")])

    def test_where_it_cannot_be_written(self):
        (self.folder / "folder").mkdir()
        before = self.files()
        for name, says in (("a/s.json", "there is no folder a"), ("folder", "is a folder"), ("/dev/null", "a device"),
                           ("model.h5", "writes besides"), ("frequencies.csv", "writes besides"),
                           ("model.hdf", "would take the place of")):
            with self.subTest(name=name):
                self.refused(self.reduce(*HELD, "-summary", name, code=2), name, says)
                self.assertEqual(self.files(), before)
        self.refused(self.reduce(*HELD, "-plan", "-summary", "a/s.json", code=2), "there is no folder a")
        scene = self.scene(MOVING, 1)
        self.refused(self.full(*HELD, *scene, "-summary", "scene.toml", code=2), "overwrite")
        self.refused(self.full(*HELD, *scene, "-summary", "energy.csv", code=2), "writes besides")
        self.assertEqual(self.files(), before | {"scene.toml"})

    def test_of_a_run_that_fails(self):
        self.write("s.json", "earlier")
        self.refused(self.reduce(*HELD, "-basis", "40", "-summary", "s.json", code=2), "independent directions")
        scene = self.scene(STATIC, 30)
        failing = self.full(*HELD, *scene, "-newton_snes_max_it", "1", "-summary", "s.json", code=1)
        self.refused(failing, "no equilibrium was found", "raise [static] steps")
        self.assertEqual(self.files(), {"s.json", "scene.toml"})
        self.assertEqual((self.folder / "s.json").read_text(), "earlier")

    def test_of_a_name_that_is_no_text(self):
        name = os.fsdecode(b"a\xff\"b.h5")
        self.reduce(*HELD, "-output", name, "-summary", "s.json", "-quiet", ranks=1)
        self.assertEqual(self.summary()["output"], 'a�"b.h5')


if __name__ == "__main__":
    unittest.main()
