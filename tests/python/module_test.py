"""The Python module on models known in closed form (tests/support/sample_model.hpp), and beside ritz-run."""
import contextlib
import copy
import gc
import os
import signal
import sys
import threading
import unittest
import warnings
from pathlib import Path

import h5py
import numpy as np

import ritz
from bench import SOFT
from program import BIN, InAFolder

HARD = "arm/upper"  # the body with hardening springs: E = (4 z1^2 + 9 z2^2) / 2 + (z1^2 + 2 z2^2)^2 / 4
TIP = ("[[load]]\nset = 'tip'\ntotal = [0, 0, 18]\ntable = [[0, 0], [0.5, 1]]\n"
       "[[probe]]\nname = 'p'\nset = 'tip'\n[[probe]]\nname = 'q'\nvertex = {vertex}\n")
TIME = "[time]\nstep = 0.05\nend = 2\n"


class OfModels(InAFolder):
    def setUp(self):
        super().setUp()
        self.bench.run("write_sample_model", "model.h5", "two-bodies")
        self.model = self.folder / "model.h5"
        self.soft, self.hard = ritz.read(self.model), ritz.read(self.model, body=HARD)
        self.vertex = int(self.soft.vertex_ids[1])

    def said_by_ritz_run(self, *words):
        """The sentence with which ritz-run fails."""
        ran = self.move(*words, code=None)
        self.assertNotEqual(ran.code, 0)
        return ran.sentence.removeprefix("ritz-run: ")

    def refuses(self, words, call, *arguments, kind=ritz.InputError, **named):
        with self.assertRaises(kind) as caught:
            call(*arguments, **named)
        self.assertIn(words, str(caught.exception))


class Views(OfModels):
    def all_of(self, body):
        yield from (body.U, body.points, body.vertex_ids, body.cell_types, body.cell_offsets, body.cell_vertices)
        yield from body.sets.values()
        modes, inertia = body.modes, body.inertia
        yield from (modes.eigenvalues, modes.energies, modes.residuals, modes.flexible, modes.floor_applies)
        yield from (inertia.gram, inertia.origin)
        if body.polynomial:
            yield from (body.polynomial.quadratic, body.polynomial.cubic, body.polynomial.quartic)
            yield from (body.reduction.stiffness, body.reduction.singular_values)

    def test_they_are_what_the_file_holds(self):
        with h5py.File(self.model) as file:
            there = file["bodies/arm%2Fupper"]
            for here, name in ((self.hard.points, "geometry/points"), (self.hard.vertex_ids, "geometry/vertex_ids"),
                               (self.hard.cell_vertices, "geometry/cells/vertices"),
                               (self.hard.modes.eigenvalues, "modes/eigenvalues"),
                               (self.hard.modes.residuals, "modes/residuals"),
                               (self.hard.reduction.singular_values, "reduction/singular_values"),
                               (self.hard.polynomial.quartic, "polynomial/quartic"),
                               (self.hard.inertia.gram, "inertia/gram")):
                np.testing.assert_array_equal(here, there[name][()], name)
            columns = [there[f"basis/columns/{c}"][()].ravel() for c in sorted(there["basis/columns"])]
            np.testing.assert_array_equal(self.hard.U, np.transpose(columns))
            self.assertEqual(set(self.hard.sets), {name.replace("%2F", "/").replace("%25", "%")
                                                   for name in there["geometry/sets"]})
        self.assertEqual(self.hard.U.shape, (3 * len(self.hard.points), self.hard.r))
        self.assertEqual(ritz.bodies(self.model), [self.soft.name, HARD])
        self.assertEqual((self.hard.name, self.hard.file), (HARD, self.model))
        self.assertIsNone(self.soft.polynomial)
        self.assertIsNone(self.soft.reduction)
        self.assertEqual(self.hard.report.notes, ["the arm's springs harden"])
        self.assertEqual(self.hard.report.seconds, [("assemble", 2.)])
        self.assertEqual(self.hard.report.figures, {"vertices": 4.})
        self.assertEqual(self.hard.checksums, {"mesh": "00000000000000aa", "problem": "00000000000000bb"})
        self.assertEqual(self.hard.reduction.discarded, .25)
        self.assertEqual(self.hard.inertia.mass, 4)

    def test_they_are_views_that_nobody_can_write_to(self):
        self.assertTrue(np.shares_memory(self.hard.U, self.hard.U))
        self.assertTrue(np.shares_memory(self.hard.polynomial.quartic, self.hard.polynomial.quartic))
        for array in self.all_of(self.hard):
            self.assertFalse(array.flags.writeable)
            self.assertFalse(array.flags.owndata and array.size > 0)
            with self.assertRaises(ValueError):
                array[...] = 0
            if array.size:
                with self.assertRaises(ValueError):
                    array.setflags(write=True)

    def test_they_outlive_their_body(self):
        for read in (lambda: ritz.read(self.model), lambda: ritz.read(self.model, body=HARD)):
            body = read()
            views, copies = list(self.all_of(body)), [array.copy() for array in self.all_of(body)]
            body = None
            gc.collect()
            others = [read() for _ in range(20)]  # takes what memory was freed
            self.assertEqual(len(others), 20)
            for view, kept in zip(views, copies):
                np.testing.assert_array_equal(view, kept)


class Evaluation(OfModels):
    def test_it_is_the_closed_form(self):
        equation, z = self.hard.equation(), np.array([.7, -.4])
        stretch = z[0]**2 + 2 * z[1]**2
        energy, force, tangent = equation.evaluate(z)
        self.assertAlmostEqual(energy, (4 * z[0]**2 + 9 * z[1]**2) / 2 + stretch**2 / 4, delta=1e-14)
        np.testing.assert_allclose(force, [(4 + stretch) * z[0], (9 + 2 * stretch) * z[1]], rtol=1e-14)
        self.assertEqual(energy, equation.energy(z))
        np.testing.assert_array_equal(force, equation.force(z))
        np.testing.assert_array_equal(tangent, equation.tangent(z))

    def test_force_and_tangent_are_derivatives(self):
        for body in (self.soft, self.hard):
            equation, z, side = body.equation(), np.array([.7, -.4]), 1e-5
            for i, unit in enumerate(side * np.eye(2)):
                above, below = equation.evaluate(z + unit), equation.evaluate(z - unit)
                self.assertAlmostEqual((above[0] - below[0]) / 2 / side, equation.force(z)[i], delta=1e-8)
                np.testing.assert_allclose((above[1] - below[1]) / 2 / side, equation.tangent(z)[i], atol=1e-8)

    def test_small_displacements_of_a_body_with_a_polynomial(self):
        linear = ritz.read(self.model, body=HARD, forces="linear")
        self.assertIsNone(linear.polynomial)
        np.testing.assert_array_equal(linear.equation().tangent([5, 5]), np.diag([4, 9]))

    def test_rest_is_where_the_force_is_the_load(self):
        equation = self.hard.equation()
        load = self.hard.unit_force("tip") @ [0, 0, 50]
        z = equation.equilibrium(load, steps=3)
        np.testing.assert_allclose(equation.force(z), load, atol=1e-8 * np.abs(load).max())
        np.testing.assert_allclose(self.soft.equation().equilibrium([8, 27]), [2, 3], rtol=1e-15)
        self.refuses("must be finite", equation.equilibrium, [np.inf, 0])


class Loads(OfModels):
    def test_they_are_work_done_on_displacements(self):
        F = self.soft.unit_force(self.vertex)
        row = 3 * list(self.soft.vertex_ids).index(self.vertex)
        np.testing.assert_array_equal(F.T, self.soft.U[row:row + 3])
        np.testing.assert_allclose(self.soft.gravity([0, 0, -9.81]), -9.81 * 2**.5 * np.ones(2), rtol=1e-14)
        tip = self.soft.unit_force("tip")
        self.assertEqual(tip.shape, (2, 3))

    def test_pressure_and_traction_are_the_file_s(self):
        with h5py.File(self.model) as file:
            loads = {name.replace("%2F", "/").replace("%25", "%"): group for name, group in
                     file["bodies/body/loads"].items()}
            faces = [name for name, load in loads.items() if "pressure" in load]
            self.assertTrue(faces)
            for name in faces:
                np.testing.assert_array_equal(self.soft.pressure(name), loads[name]["pressure"][()])
                np.testing.assert_array_equal(self.soft.traction(name), loads[name]["traction"][()])
            for name in set(loads) - set(faces):
                self.refuses("needs a surface", self.soft.pressure, name)


class Steps(OfModels):
    def test_an_exact_oscillator_swings(self):
        moving = self.soft.equation().instance(.1, z=[1, 0], velocity=[0, 3])
        self.assertEqual(moving.integrator, "exact")
        z = moving.steps(np.zeros((50, 2)))
        t = .1 * np.arange(1, 51)
        np.testing.assert_allclose(z, np.column_stack([np.cos(2 * t), np.sin(3 * t)]), atol=1e-12)
        self.assertAlmostEqual(moving.t, 5, delta=1e-14)
        self.assertAlmostEqual(moving.energy, 4 / 2 + 9 / 2, delta=1e-11)

    def test_energy_is_what_the_loads_put_in(self):
        moving = self.hard.equation(alpha=.3).instance(.1)
        pull = self.hard.unit_force("tip") @ [0, 0, 18]
        for n in range(100):
            moving.step(pull * min(1, n / 10))
        self.assertAlmostEqual(moving.energy, moving.work - moving.dissipated, delta=1e-8 * abs(moving.work))
        self.assertGreater(moving.dissipated, 0)
        self.assertGreaterEqual(moving.iterations, 100)

    def test_every_integrator_repeats_ritz_run_to_the_last_bit(self):
        for body, name in ((self.soft, "body"), (self.hard, HARD)):
            pull = body.unit_force("tip") @ [0, 0, 18]
            for integrator in ritz.integrators:
                if body is self.hard and integrator == "exact":
                    self.refuses("is for linear models", body.equation().instance, .05, integrator)
                    continue
                self.write("scene.toml", f"[time]\nstep = 0.05\nend = 2\nintegrator = '{integrator}'\n"
                           f"[damping]\nalpha = 0.1\nbeta = 0.01\nratio = [0.02, 0.03]\n"
                           f"[[body]]\nname = 'b'\nmodel_body = '{name}'\n"
                           "[[load]]\nset = 'tip'\ntotal = [0, 0, 18]\n")
                self.move("model.h5", "--scene", "scene.toml", "--frames", "0", "--quiet")
                there = self.bench.read("motion.b.h5", "z")
                equation = body.equation(alpha=.1, beta=.01, ratio=[.02, .03])
                moving = equation.instance(.05, integrator, load=pull)
                self.assertEqual(moving.integrator, integrator)
                here = [moving.z]
                for _ in range(40):
                    moving.step()
                    here.append(moving.z)
                np.testing.assert_array_equal(here, there, f"{name} {integrator}")
                again = equation.instance(.05, integrator, load=pull).steps(np.tile(pull, (40, 1)))
                np.testing.assert_array_equal(again, there[1:])

    def test_many_at_once_and_copies_go_their_own_ways(self):
        equation = self.hard.equation()
        pull = np.array([self.hard.unit_force("tip") @ [0, 0, force] for force in (5, 10, 15)])
        together, alone = ([equation.instance(.05) for _ in pull] for _ in range(2))
        for _ in range(20):
            ritz.step(together, pull)
            for moving, load in zip(alone, pull):
                moving.step(load)
        np.testing.assert_array_equal([moving.z for moving in together], [moving.z for moving in alone])
        branch, other = together[0].copy(), copy.copy(together[0])
        together[0].step(pull[2])
        np.testing.assert_array_equal(branch.z, alone[0].z)
        branch.step(pull[2])
        other.step()
        np.testing.assert_array_equal(branch.z, together[0].z)
        self.assertFalse(np.array_equal(branch.z, other.z))
        self.assertEqual((branch.t, branch.work), (together[0].t, together[0].work))

    def test_threads_step_side_by_side(self):
        equation = self.hard.equation()
        loads = np.random.default_rng(1).normal(size=(4, 2000, 2))
        expected = [equation.instance(.05).steps(load) for load in loads]
        found = [None] * len(loads)

        def work(i):
            moving = equation.instance(.05)
            found[i] = []
            for load in loads[i]:
                moving.step(load)
                found[i].append(moving.z)

        threads = [threading.Thread(target=work, args=(i,)) for i in range(len(loads))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        np.testing.assert_array_equal(found, expected)

    def test_python_runs_on_while_steps_are_made(self):
        moving = self.hard.equation().instance(.05)
        loads, refused = np.zeros((20000, 2)), []
        loads[:, 0] = np.sin(np.arange(len(loads)))
        thread = threading.Thread(target=lambda: moving.steps(loads))
        thread.start()
        while thread.is_alive():  # only where the lock is released can this thread meet the other in the midst of it
            try:
                moving.z
            except ritz.InputError as refusal:
                refused.append(str(refusal))
        self.assertTrue(refused)
        self.assertIn("twice at the same time", refused[0])
        self.assertAlmostEqual(moving.t, .05 * len(loads), delta=1e-9 * moving.t)

    def test_wrong_arguments_change_nothing(self):
        moving = self.hard.equation().instance(.05)
        before = moving.z
        self.refuses("load has the shape (3,), and must be one number for each reduced coordinate, (2,)", moving.step,
                     [1, 2, 3])
        self.refuses("load has the shape (2, 1)", moving.step, np.zeros((2, 1)))
        self.refuses("no array of real numbers", moving.step, [1j, 0])
        self.refuses("no array of real numbers", moving.step, ["a", "b"])
        self.refuses("loads has the shape (2,)", moving.steps, [1, 2])
        self.refuses("(any number, 2)", moving.steps, np.zeros((4, 3)))
        self.refuses("2 instances are given 1 loads", ritz.step, [moving, moving.copy()], [[0, 0]])
        self.refuses("twice", ritz.step, [moving, moving], np.zeros((2, 2)))
        self.refuses("too large", moving.step, [np.nan, 0], kind=ritz.NumericalError)
        for wrong in (lambda: moving.step(1, 2), lambda: ritz.step([None], [[0, 0]]), lambda: ritz.step(5, [[0, 0]])):
            with self.assertRaises(TypeError):
                wrong()
        np.testing.assert_array_equal(moving.z, before)
        self.assertEqual(moving.t, 0)
        moving.step(np.array([1, 2], np.float32))  # what fits without loss is taken
        moving.step([1, 2])
        moving.step(np.array([[1., 9.], [2., 9.]])[:, 0])

    def test_wrong_values_are_named(self):
        equation = self.hard.equation()
        self.refuses("did you mean 'newmark'", equation.instance, .1, "newmrak")
        self.refuses("not positive", equation.instance, 0)
        self.refuses("at most 0.66666", equation.instance, 10, "central-difference")
        self.refuses("must be finite", equation.instance, .1, z=[np.nan, 0])
        self.refuses("alpha is -1", self.hard.equation, alpha=-1)
        self.refuses("ratio is -0.1", self.hard.equation, ratio=[.1, -.1])
        self.refuses("at least 1", equation.equilibrium, [0, 0], steps=0)
        with self.assertWarnsRegex(RuntimeWarning, "2 % is written 0.02"):
            self.hard.equation(ratio=2)


class Files(OfModels):
    def test_dead_files_cost_the_programs_sentences(self):
        content = self.model.read_bytes()
        (self.folder / "cut.h5").write_bytes(content[:len(content) // 2])
        (self.folder / "text.h5").write_text("not a model")
        self.write("scene.toml", TIME)
        with h5py.File(self.model, "a") as file:
            file["bodies/body/modes/eigenvalues"][0] = 5
        for name in ("absent.h5", "cut.h5", "text.h5", "model.h5", "."):
            said = self.said_by_ritz_run(name, "--scene", "scene.toml")
            with contextlib.chdir(self.folder):
                self.refuses(said, ritz.read, name)
                self.refuses(said, ritz.run, "scene.toml", name)

    def test_a_body_that_is_not_there(self):
        self.refuses("arm/upper", ritz.read, self.model, body="arm/uper")
        self.refuses("unknown forces 'stred'; did you mean 'stored'", ritz.read, self.model, forces="stred")

    def test_unknown_sets_and_vertices_cost_the_programs_sentences(self):
        for target in ("tp", 123456):
            written = f"set = '{target}'" if isinstance(target, str) else f"vertex = {target}"
            self.write("scene.toml", f"{TIME}[[load]]\n{written}\ntotal = [0, 0, 1]\n")
            said = self.said_by_ritz_run("model.h5", "--scene", "scene.toml")
            self.refuses(said, self.soft.unit_force, target)


class Scenes(OfModels):
    def ran(self, text, *words, output="motion.h5"):
        self.write("scene.toml", text)
        return self.move("model.h5", "--scene", "scene.toml", "--output", output, *words)

    def same_as_ritz_run(self, run, motion="motion.h5"):
        times, z = self.bench.read(motion, "times", "z")
        np.testing.assert_array_equal(run.t, times)
        np.testing.assert_array_equal(run.z, z)
        header, rows = self.bench.table(Path(motion).with_name("probes.csv" if motion == "motion.h5" else
                                                               Path(motion).stem + ".probes.csv"))
        columns = np.column_stack([run.t, *run.probes.values()])
        self.assertEqual(header, ["t", *(f"{name}_u{c}" for name in run.probes for c in "xyz")])
        printed = np.array([[float(f"{x:.15g}") for x in row] for row in columns])
        np.testing.assert_array_equal(printed, rows)

    def test_a_file_and_a_dictionary_give_what_ritz_run_gives(self):
        before = self.files()
        scenes = {
            TIME + "[damping]\nalpha = 0.1\nratio = 0.02\n" + TIP.format(vertex=self.vertex):
                {"time": {"step": .05, "end": 2}, "damping": {"alpha": .1, "ratio": .02}},
            TIME.replace("end", "integrator = 'newmark'\nend") + TIP.format(vertex=self.vertex):
                {"time": {"step": np.float64(.05), "end": np.int64(2), "integrator": "newmark"}},
            "[static]\nsteps = 4\n" + TIP.format(vertex=self.vertex): {"static": {"steps": 4}}}
        for text, made in scenes.items():
            made |= {"load": [{"set": "tip", "total": np.array([0, 0, 18]), "table": [[0, 0], (.5, 1)]}],
                     "probe": ({"name": "p", "set": "tip"}, {"name": "q", "vertex": self.vertex})}
            self.ran(text)
            for scene in (self.folder / "scene.toml", str(self.folder / "scene.toml"), made):
                for model in (self.model, self.soft):
                    run = ritz.run(scene, model)
                    self.same_as_ritz_run(run)
                    self.assertEqual(run.bodies[""].inverted_cells, 0)
        self.assertEqual(self.files() - before, {"scene.toml", "motion.h5", "motion.xdmf", "probes.csv"})

    def test_the_motion_that_it_writes_is_ritz_run_s(self):
        self.ran(TIME + TIP.format(vertex=self.vertex), "--frames", "5")
        before = self.files()
        run = ritz.run(self.folder / "scene.toml", self.model, output=self.folder / "here.h5", frames=5)
        self.assertEqual(self.files() - before, {"here.h5", "here.xdmf", "here.probes.csv"})
        self.same_as_ritz_run(run, "here.h5")
        with h5py.File(self.folder / "here.h5") as here, h5py.File(self.folder / "motion.h5") as there:
            self.assertEqual(set(here), set(there))
            for name in ("points", "cells", "times", "z", "frame_times", "displacement"):
                np.testing.assert_array_equal(here[name][()], there[name][()], name)
        self.assertEqual((self.folder / "here.probes.csv").read_bytes(), (self.folder / "probes.csv").read_bytes())
        self.assertEqual(run.bodies[""].output, self.folder / "here.h5")

    def test_bodies_have_their_own_motions(self):
        bodies = f"[[body]]\nname = 'soft'\n[[body]]\nname = 'hard'\nmodel_body = '{HARD}'\n"
        pull = "".join(f"[[load]]\nbody = '{b}'\nset = 'tip'\ntotal = [0, 0, 18]\n"
                       f"[[probe]]\nname = '{b}s'\nbody = '{b}'\nset = 'tip'\n" for b in ("soft", "hard"))
        self.ran(TIME.replace("end", "integrator = 'avf'\nend") + bodies + pull)
        run = ritz.run(self.folder / "scene.toml", self.model)
        self.assertEqual(list(run.bodies), ["soft", "hard"])
        for name, body in run.bodies.items():
            np.testing.assert_array_equal(body.z, self.bench.read(f"motion.{name}.h5", "z"))
            self.assertEqual((body.integrator, body.steps), ("avf", 40))
        self.assertIsNone(run.bodies["soft"].energy)
        balance = run.bodies["hard"].energy
        self.assertGreater(balance.work, 0)
        self.assertLess(max(balance.gained, balance.lost), 1e-8 * balance.available)
        self.refuses("run.bodies[NAME].z", lambda: run.z)
        header, rows = self.bench.table("probes.csv")
        np.testing.assert_allclose(rows[:, 1:], np.column_stack([run.probes["softs"], run.probes["hards"]]), rtol=1e-14)
        self.refuses("is to be 'arm/upper' of its model, and the body given is 'body'", ritz.run,
                     self.folder / "scene.toml", self.soft)

    def test_precision_and_forces(self):
        hard = f"[[body]]\nname = 'b'\nmodel_body = '{HARD}'\n"
        for words, how in ((["--single"], {"precision": "float32"}), (["--linear"], {"forces": "linear"})):
            self.ran(TIME + hard + TIP.format(vertex=self.vertex), *words)
            run = ritz.run(self.folder / "scene.toml", self.model, **how)
            np.testing.assert_array_equal(run.z, self.bench.read("motion.b.h5", "z"))
        self.refuses("ritz.read(file, forces='linear')", ritz.run, {"time": {"step": 1, "end": 2}}, self.hard,
                     forces="linear")

    def test_what_is_wrong_with_a_file_costs_the_programs_sentence(self):
        before = self.files()
        for text in ("[time]\nstep = 0.1\n", "[time]\nstp = 0.1\nend = 1\n", "[time\n", "[static]\nsteps = 0\n",
                     TIME + "[[load]]\nset = 'tpi'\ntotal = [0, 0, 1]\n",
                     TIME + "[[load]]\nset = 'tip'\ntotal = [0, 0, 1.7e308]\n[[load]]\nset = 'tip'\ntotal = [0, 0, 1.7e308]\n"):
            self.write("scene.toml", text)
            ran = self.move("model.h5", "--scene", "scene.toml", code=None)
            kind = {1: ritz.NumericalError, 2: ritz.InputError}[ran.code]
            with contextlib.chdir(self.folder):
                self.refuses(ran.sentence.removeprefix("ritz-run: "), ritz.run, "scene.toml", "model.h5", kind=kind)
            self.assertEqual(self.files() - before, {"scene.toml"})

    def test_what_is_wrong_with_a_dictionary_is_said_without_lines(self):
        time = {"step": .1, "end": 1}
        endless = []
        endless.append(endless)
        for said, scene in (("the scene: unknown key 'stp' in [time]; did you mean 'step'", {"time": {"stp": 1, "end": 2}}),
                            ("the scene: [time] needs the key 'end'", {"time": {"step": 1}}),
                            ("'step' of [time] must be a number", {"time": {"step": "1", "end": 2}}),
                            ("'step' of [time] must be a finite number", {"time": {"step": np.nan, "end": 2}}),
                            ("'gravity' is of the kind NoneType", {"time": time, "gravity": None}),
                            ("three components", {"time": time, "gravity": [1, 2]}),
                            ("fits 64 bits", {"time": time, "load": [{"vertex": 2**70}]}),
                            ("is no text", {"time": time, 5: 1}),
                            ("nested deeper", {"time": time, "load": endless}),
                            ("an array of tables", {"time": time, "load": {"set": "tip"}})):
            self.refuses(said, ritz.run, scene, self.model)
        self.refuses("there is no model", ritz.run, {"time": time})
        self.refuses("give output", ritz.run, {"time": time}, self.model, frames=3)
        self.refuses("exclude each other", ritz.run, {"time": time}, self.model, output="x.h5", frames=3, every=2)
        with self.assertRaises(TypeError):
            ritz.run(5, self.model)

    def test_nothing_is_overwritten_that_is_read(self):
        content = self.model.read_bytes()
        self.refuses("model.h5", ritz.run, {"time": {"step": .1, "end": 1}}, self.soft, output=self.model)
        self.assertEqual(self.model.read_bytes(), content)

    def test_warnings_are_python_s(self):
        scene = {"time": {"step": .1, "end": 1}, "damping": {"ratio": 2}}
        with self.assertWarnsRegex(RuntimeWarning, "overdamped"):
            run = ritz.run(scene, self.model)
        self.assertEqual(len(run.warnings), 1)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with self.assertRaises(RuntimeWarning):
                ritz.run(scene, self.model)
            self.assertEqual(ritz.run({"time": {"step": .1, "end": 1}}, self.model).warnings, [])

    def test_an_interruption_ends_steps_after_a_whole_one(self):
        signal.signal(signal.SIGINT, signal.default_int_handler)
        start = lambda: self.hard.equation().instance(1e-3, z=[.5, -.2])  # noqa: E731
        moved, same = start(), start()
        loads = np.zeros((4_000_000, 2))
        timer = threading.Timer(.3, lambda: os.kill(os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            moved.steps(loads)
        timer.join()
        made = round(moved.t / 1e-3)
        self.assertTrue(0 < made < len(loads), made)
        np.testing.assert_array_equal(same.steps(loads[:made])[-1], moved.z)
        moved.step()
        same.step()
        np.testing.assert_array_equal(same.velocity, moved.velocity)

    def test_an_interruption_ends_a_run_and_leaves_nothing(self):
        signal.signal(signal.SIGINT, signal.default_int_handler)
        before = self.files()
        timer = threading.Timer(.3, lambda: os.kill(os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            ritz.run({"time": {"step": 1e-6, "end": 100}}, self.model, output=self.folder / "motion.h5", frames=2)
        timer.join()
        self.assertEqual(self.files(), before)


@unittest.skipUnless((BIN / "ritz-reduce").exists(), "needs ritz-reduce")
class Reduced(InAFolder):
    """What the models in closed form do not do."""
    BAR = ["-mesh", "box:1,.2,.2/4,1,1/tet4", *SOFT, "-modes", "6", "-derivatives", "6", "-basis", "12", "-polynomial", "-quiet"]

    def test_statics_that_fail_say_what_ritz_run_says(self):
        self.reduce(*self.BAR, "-fix", "xmin", ranks=0)
        self.write("scene.toml", "[static]\nsteps = 4\n[[load]]\nset = 'xmax'\ntotal = [-3e4, 0, 0]\n")
        said = self.move("model.h5", "--scene", "scene.toml", code=1).sentence.removeprefix("ritz-run: ")
        self.assertIn("limit point", said)
        body = ritz.read(self.folder / "model.h5")
        with self.assertRaises(ritz.NumericalError) as caught:
            body.equation().equilibrium(body.unit_force("xmax") @ [-3e4, 0, 0], steps=4)
        self.assertEqual(str(caught.exception), said)

    def test_a_cubature_is_the_sum_that_it_says(self):
        rubber = ["-material_law", "neo-hookean", "-cubature_plain", "-material_young", "1e6", "-material_poisson", ".25"]
        bar = [word for word in self.BAR if word != "-polynomial"]
        self.reduce(*bar, "-fix", "xmin", *rubber, "-material_density", "1e3", ranks=0)
        body = ritz.read(self.folder / "model.h5")
        cubature = body.cubature
        self.assertIsNone(body.polynomial)
        self.assertEqual(cubature.integrand, "energy")
        self.assertEqual(cubature.errors[-1, 0], len(cubature.cells))
        self.assertLess(max(cubature.errors[-1, [3, 5]]), 1e-3)
        self.assertFalse(cubature.gradients.flags.writeable)
        z = np.linspace(-1, 1, body.r) / np.arange(1, body.r + 1) ** 3
        F = np.eye(3) + (cubature.gradients @ z).reshape(-1, 3, 3).transpose(0, 2, 1)
        log = np.log(np.linalg.det(F))
        energy = 4e5 * ((np.einsum("pij,pij->p", F, F) - 3) / 2 - log + log**2 / 2)  # both of Lame's constants are 4e5 Pa
        weights = np.repeat(cubature.weights, np.diff(cubature.starts)) * cubature.volumes
        self.assertAlmostEqual(body.equation().energy(z) / (weights @ energy), 1, delta=1e-10)
        self.assertIsNone(ritz.read(self.folder / "model.h5", forces="linear").cubature)

    def test_a_free_body_is_not_moved_in_silence(self):
        self.reduce(*self.BAR, "-fix", "none", ranks=0)
        scene = {"time": {"step": .05, "end": 1}, "gravity": [0, 0, -9.81]}
        self.write("scene.toml", "gravity = [0, 0, -9.81]\n" + TIME)
        with contextlib.chdir(self.folder):
            said = self.move("model.h5", "--scene", "scene.toml", code=2).sentence.removeprefix("ritz-run: ")
            self.assertIn("neither falls nor flies", said)
            for model in ("model.h5", ritz.read("model.h5")):
                with self.assertRaises(ritz.InputError) as caught:
                    ritz.run(scene, model)
                self.assertEqual(str(caught.exception), said)
            with self.assertWarnsRegex(RuntimeWarning, "neither falls nor flies"):
                ritz.read("model.h5").equation()


if __name__ == "__main__":
    sys.exit(unittest.main())
