"""ritz-scene takes the loads of a deck: with them the bodies move as CalculiX says of the same deck."""
import re
import shutil
import subprocess
import tomllib
import unittest

import numpy as np

from crooked_bar import crooked, on_top
from program import InAFolder, sentences

STATIC = "*STEP\n*STATIC\n{}*END STEP\n"
PROBE = '\n[[probe]]\nname = "tip"\nset = "TIP"\n'
KINDS = ("C3D4", "C3D10", "C3D8", "C3D20", "C3D6", "C3D15")


def face_lists(kind):
    """The faces on the top of the bar: a set TOP and a surface ROOF, "set, face", and lines of elements under 1 Pa."""
    face, cells = on_top(kind)
    listed = ",\n".join(map(str, cells))
    return f"*ELSET, ELSET=TOP\n{listed}\n*SURFACE, NAME=ROOF\nTOP, S{face}\n", f"TOP, P{face}", \
        "".join(f"{cell}, P{face}, 1.\n" for cell in cells)


class OfDecks(InAFolder):
    """The scene of a deck, and what ritz-scene said."""

    def take(self, text, *words, **how):
        self.write("m.inp", text)
        return self.bench.run("ritz-scene", "m.inp", *words, **how)

    def scene(self, text, *words):
        """A scene without warnings but that the step is linear."""
        taken = self.take(text, *words)
        self.warnings = [line for line in taken.warnings if "this step is linear" not in line]
        return tomllib.loads(taken.out)

    def refused(self, text, *words):
        taken = self.take(text, *words, "--output", "s.toml", code=2)
        self.assertEqual(len(sentences(taken.err)), 1, taken.err)
        self.assertEqual(self.files(), {"m.inp"})
        return taken.sentence

    def moved(self, text, units="m-kg-s", integrator=None):
        """The displacement of TIP at the end of the deck's scene, by ritz-full."""
        scene = self.take(text, "--units", units).out + PROBE
        self.write("s.toml", scene.replace("[time]", f'[time]\nintegrator = "{integrator}"'))
        self.full("-mesh", "m.inp", "-scene", "s.toml", "-units", units, "-quiet", ranks=1)
        return self.table("probes.csv")[1][-1, 1:4]

    def calculix(self, text, output="*NODE PRINT, NSET=TIP\nU\n"):
        """The last displacement of TIP by CalculiX."""
        self.write("c.inp", text.replace("*END STEP", output + "*END STEP"))
        subprocess.run(["ccx", "-i", "c"], cwd=self.folder, capture_output=True, timeout=120)
        rows = re.findall(r"^ +\d+((?: +-?[\d.E+-]+){3}) *$", (self.folder / "c.dat").read_text(), re.M)
        return np.array(rows[-1].split(), float)


@unittest.skipUnless(shutil.which("ccx"), "no CalculiX")
class BesideCalculix(OfDecks):
    """Small loads, so that large displacements are no matter; elements by the same points of integration. CalculiX
    prints seven digits."""

    def expect_alike(self, deck, within=3e-6, **how):
        ours, theirs = self.moved(deck, **how), self.calculix(deck)
        self.assertGreater(np.linalg.norm(theirs), 0)
        self.assertLess(np.linalg.norm(ours - theirs) / np.linalg.norm(theirs), within)

    def test_loads_on_all_elements(self):
        for kind in KINDS:
            sets, of_set, of_elements = face_lists(kind)
            deck = crooked(kind) + sets + STATIC
            for name, loads in {"forces": "*CLOAD\nTIP, 3, -.01\nTIP, 2, .004\n7, 1, .003\n",
                                "pressures": f"*DLOAD\n{of_set}, 3.\n{of_elements}*DSLOAD\nROOF, P, -9.\n",
                                "gravity": "*DLOAD\nBAR, GRAV, .0981, 0., 1., -2.\n"}.items():
                with self.subTest(kind=kind, loads=name):
                    self.expect_alike(deck.format(loads))

    def test_loads_of_earlier_steps(self):
        first = "*CLOAD\nTIP, 3, -.01\n7, 1, .3\n*DLOAD\nBAR, GRAV, .1, 0., 1., -2.\n"
        for second in ("*CLOAD\nTIP, 2, .04\n7, 1, .1\n", "*CLOAD, OP=NEW\nTIP, 2, .04\n",
                       "*DLOAD, OP=NEW\nBAR, GRAV, .3, 1., 1., 0.\n", "*CLOAD\nTIP, 3, .04\nTIP, 3, -.03\n"):
            with self.subTest(second):
                self.expect_alike(crooked("C3D8") + STATIC.format(first) + STATIC.format(second))

    def test_motions(self):
        """The trapezoidal rule, which is CalculiX's where ALPHA is 0, and the same step; the programs begin otherwise where
        a force is there at once."""
        table = "*AMPLITUDE, NAME=BLOW\n0., 0., 1.5e-4, 1., 3e-4, 0.\n"
        dynamic = "*STEP, INC=100{}\n*DYNAMIC, DIRECT, ALPHA=0.\n2e-5, 4e-4\n{}*END STEP\n"
        for ramp, loads, within in (("", "*CLOAD\nTIP, 3, -.01\n", 3e-3),
                                    (", AMPLITUDE=RAMP", "*CLOAD\nTIP, 3, -.01\n", 1e-4),
                                    ("", "*CLOAD, AMPLITUDE=BLOW\nTIP, 3, -.01\n", 1e-4),
                                    ("", "*DLOAD, AMPLITUDE=BLOW\nBAR, GRAV, .1, 0., 1., -2.\n", 1e-4)):
            with self.subTest(ramp + loads):
                self.expect_alike(crooked("C3D8") + table + dynamic.format(ramp, loads), within, integrator="newmark")

    def test_millimetres(self):
        deck = crooked("C3D10", size=(90., 24., 18.)).replace("2.1e11", "2.1e5").replace("7850.", "7.85e-9")
        sets, of_set, _ = face_lists("C3D10")
        loads = f"*CLOAD\nTIP, 3, -.01\n*DLOAD\n{of_set}, 1e-6\nBAR, GRAV, 9.81, 0., 1., -2.\n"
        deck += sets + STATIC.format(loads)
        ours, theirs = self.moved(deck, units="mm-t-s"), 1e-3 * self.calculix(deck)
        self.assertLess(np.linalg.norm(ours - theirs) / np.linalg.norm(theirs), 3e-6)


class Scenes(OfDecks):
    DECK = crooked("C3D8") + face_lists("C3D8")[0]

    def test_units(self):
        step = "*STEP\n*DYNAMIC, DIRECT\n2., 6.\n*CLOAD, AMPLITUDE=A\nTIP, 1, 3.\n*DSLOAD\nROOF, P, 5.\n" \
               "*DLOAD\nBAR, GRAV, 7., 0., 0., -1.\n*END STEP\n"
        scene = self.scene(self.DECK + "*AMPLITUDE, NAME=A\n0., 0., 4., 1.\n" + step, "--units", "mm-g-ms")
        self.assertEqual(self.warnings, [])
        self.assertEqual(scene["time"], {"step": 2e-3, "end": 6e-3})
        np.testing.assert_allclose(scene["gravity"], [0, 0, -7e3], rtol=1e-14)
        force, pressure = scene["load"]
        np.testing.assert_allclose(force["each"], [3, 0, 0], rtol=1e-14)
        np.testing.assert_allclose(force["table"], [[0, 0], [4e-3, 1]], rtol=1e-14)
        self.assertEqual(force["set"], "TIP")
        np.testing.assert_allclose(pressure["pressure"], 5e6, rtol=1e-14)
        self.assertEqual(pressure["set"], "ROOF")

    def test_fractions_have_no_unit(self):
        step = "*STEP\n*STATIC\n2., 8.\n*CLOAD, AMPLITUDE=A\nTIP, 1, 3.\n*END STEP\n"
        scene = self.scene(self.DECK + "*AMPLITUDE, NAME=A\n0., 0., 4., 1.\n" + step, "--units", "mm-t-ms")
        self.assertEqual(scene["static"], {"steps": 4})
        self.assertEqual(scene["load"][0]["table"], [[0, 0], [.5, 1]])

    def test_a_reduced_model_knows_the_faces(self):
        _, of_set, of_elements = face_lists("C3D8")
        ends = {}
        for name, loads in {"set": f"{of_set}, 100.\n", "elements": of_elements}.items():
            self.take(self.DECK + STATIC.format("*DLOAD\n" + loads), "--output", "s.toml")
            with open(self.folder / "s.toml", "a") as file:
                file.write(PROBE)
            self.reduce("-mesh", "m.inp", "-modes", "4", "-quiet")
            self.move("model.h5", "--scene", "s.toml")
            ends[name] = self.table("probes.csv")[1][-1, 1:4]
        self.assertLess(ends["set"][2], 0)
        np.testing.assert_allclose(100 * ends["elements"], ends["set"], rtol=1e-9)

    def test_what_is_noted_stands_in_both_places(self):
        taken = self.take(self.DECK + STATIC.format("*CLOAD\nTIP, 5, 1.\nTIP, 1, 1.\n"))
        notes = [line.split("warning: ")[1] for line in taken.warnings]
        self.assertEqual(len(notes), 2)
        for note in notes:
            self.assertIn(f"# {note}\n", taken.out)

    def test_refusals(self):
        for loads, said in (("*DLOAD\nBAR, BX, 1.\n", "'BX'"), ("*CLOAD\nNOBODY, 1, 1.\n", "NOBODY"),
                            ("*DLOAD\nBAR, P4, 1.\n", "between two elements")):
            self.assertIn(said, self.refused(self.DECK + STATIC.format(loads)))
        deck = self.DECK + STATIC.format("*DLOAD\nBAR, BX, 1.\n")
        self.assertEqual(self.scene(deck, "--ignore", "tie,bx").get("load"), None)
        self.assertEqual(len(self.warnings), 3, "BX, no loads, and TIE in vain")
        self.assertIn("[static]", self.bench.run("ritz-scene", "--ignore", "BX", "m.inp").out)
        self.assertIn("step 2", self.refused(deck, "--step", "2"))
        self.assertIn("m-kg-s", self.refused(deck, "--units", "mm"))
        self.assertIn("--units", self.refused(deck, "--unit", "mm-t-s"))

    def test_a_deck_is_not_overwritten(self):
        deck = self.DECK + STATIC.format("")
        self.take(deck, "--output", "m.inp", code=2)
        self.assertEqual((self.folder / "m.inp").read_text(), deck)
        self.write("more.inp", "*NSET, NSET=ALL\n1\n")
        self.take("*INCLUDE, INPUT=more.inp\n" + deck, "--output", "more.inp", code=2)
        self.assertIn("NSET=ALL", (self.folder / "more.inp").read_text())


if __name__ == "__main__":
    unittest.main()
