"""Pictures of models and motions: what moves is seen, and tables of something else are refused."""
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import programs
from program import BIN

try:
    import plot_modes
    import plot_probes
except ImportError:
    sys.exit(77)

SCRIPTS = Path(plot_modes.__file__).parent


def box(low, high, n=6):
    """Vertices and outward triangles of the sides of a box."""
    low, high = np.array(low, float), np.array(high, float)
    points, faces = [], []
    for axis in range(3):
        for end in (0, 1):
            a, b = np.meshgrid(*[np.linspace(0, 1, n + 1)] * 2, indexing="ij")
            grid = np.empty((n + 1, n + 1, 3))
            grid[..., axis], grid[..., (axis + 1) % 3], grid[..., (axis + 2) % 3] = end, a, b
            first = sum(map(len, points)) + np.arange((n + 1)**2).reshape(n + 1, n + 1)
            corners = [first[:-1, :-1], first[1:, :-1], first[1:, 1:], first[:-1, 1:]]
            turned = (0, 1, 2, 3) if end else (0, 3, 2, 1)
            quads = np.stack([corners[i].ravel() for i in turned], axis=1)
            faces += [quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]]
            points.append((low + (high - low) * grid).reshape(-1, 3))
    return np.concatenate(points), np.concatenate(faces)


class Modes(unittest.TestCase):
    def test_motion_goes_across_the_line_of_sight(self):
        points, faces = box((0, 0, 0), (10, 3, 1))
        eyes = plot_modes.Eyes(points, faces)
        for axis in range(3):
            shape = np.zeros_like(points)
            shape[:, axis] = points[:, 0]
            frame = eyes.best(shape)
            np.testing.assert_allclose(frame @ frame.T, np.eye(3), atol=1e-12)
            self.assertGreater(np.linalg.norm(frame[:2, axis]), 0.85, f"along {'xyz'[axis]}")

    def test_a_part_that_moves_behind_the_body_is_seen(self):
        for end in (-1, 1):
            body, sides = box((0, 0, 0), (10, 6, 1))
            knob, its = box((7, 2, 1.5), (8, 3, 2)) if end > 0 else box((7, 2, -1), (8, 3, -.5))
            points, faces = np.concatenate([body, knob]), np.concatenate([sides, its + len(body)])
            shape = np.zeros_like(points)
            shape[len(body):, 1] = 1
            frame = plot_modes.Eyes(points, faces).best(shape)
            seen, _ = plot_modes.in_sight(frame, points, faces)
            self.assertGreater(np.count_nonzero(seen >= len(sides)), len(its) / 6)
            self.assertGreater(end * frame[2, 2], 0)  # from the knob's side

    def test_a_sheet_of_a_model(self):
        with tempfile.TemporaryDirectory() as folder:
            programs.run(BIN / "write_sample_model", f"{folder}/model.h5")
            programs.run("/usr/bin/python3", SCRIPTS / "plot_modes.py", f"{folder}/model.h5", f"{folder}/sheet.png")
            self.assertTrue(Path(folder, "sheet.png").read_bytes().startswith(b"\x89PNG"))

    def test_what_is_no_model_is_refused_in_a_sentence(self):
        for path in (Path(__file__), Path("there is no such file")):
            with self.assertRaisesRegex(SystemExit, "is not a model that VTK can read") as refusal:
                plot_modes.read_surface(str(path))
            self.assertNotIn("\n", str(refusal.exception))


class Probes(unittest.TestCase):
    def read(self, text):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "table.csv"
            path.write_text(text)
            return plot_probes.read(path)

    def test_of_each_probe_the_component_that_moves(self):
        times = np.linspace(0, 1, 50)
        a, b = np.sin(30 * times), np.cos(20 * times)
        rows = [f"{t},{0.1 * x},{x},0,5,5,{y}" for t, x, y in zip(times, a, b)]
        read, columns = self.read("t,tip_ux,tip_uy,tip_uz,my_root_ux,my_root_uy,my_root_uz\n" + "\n".join(rows))
        np.testing.assert_array_equal(read, times)
        self.assertEqual(list(columns), ["tip_uy", "my_root_uz"])
        np.testing.assert_array_equal(columns["tip_uy"], a)

    def test_another_table_is_refused_in_a_sentence(self):
        frequencies = "index,kind,frequency_hz\n" + "1,rigid,0\n" * 9
        for text, why in ((frequencies, "not a table of probes"), ("", "not a table of probes"), ("t\n" + "0\n" * 9, "not a table"),
                          ("t,a_ux,a_uy,a_uz\n0,1,2,3\n", "at least 8 rows"),
                          ("t,a_ux,a_uy,a_uz\n" + "0,1,2,3\n" * 9, "nothing moves")):
            with self.assertRaisesRegex(SystemExit, why) as refusal:
                self.read(text)
            self.assertNotIn("\n", str(refusal.exception))


if __name__ == "__main__":
    unittest.main()
