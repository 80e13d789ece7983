"""The page is made from the tables alone, loads nothing, and hides no failure."""
import re
import sys
import tempfile
import unittest
from pathlib import Path

from support import row
from report import compare, errors, page, pictures, table

SIZES = ((4, 8, 1e-3, 0.2), (4, 14, 2e-3, 0.06), (8, 20, 5e-3, 0.008))


def motion():
    rows = [row(key=f"d{k}{r}", k=float(k), r=float(r), seconds=seconds, error_integrated=error)
            for k, r, seconds, error in SIZES]
    rows += [row(key=f"s{step:g}", k=8.0, r=20.0, sweep="step", step=step, seconds=1e-4 / step, error_integrated=step)
             for step in (0.02, 0.01)]
    rows += [row(key="full", method="full", k=0.0, r=0.0, sweep="basis", seconds=1.0, microseconds=1e4,
                 error_integrated=2e-3, precompute_seconds=float("nan"))]
    return rows + [row(key="lost", integrator="newmark", sweep="step", status="failed", seconds=0.4,
                       reason="step 3 <does not> converge", error_integrated=float("nan"))]


def write(folder, rows):
    table.append(folder / "runs.csv", table.COLUMNS, rows)
    table.append(folder / "over_time.csv", table.OVER_TIME,
                 [{"key": one["key"], "t": t, "error": 0.01 * t} for one in rows for t in (0.0, 0.5, 1.0)])
    return page.write(folder).read_text()


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = Path(temporary.name)
        cls.text = write(cls.folder, motion())

    def test_self_contained(self):
        names = set(re.findall(r"https?://[^\"'\s<>]*", self.text))
        self.assertEqual(names, {"http://www.w3.org/2000/svg", "http://www.w3.org/1999/xlink"})  # namespaces
        loads = r"<(?:script|link|img|iframe)|@import|url\((?!#)|(?:src|href)=\"(?!#)"
        self.assertEqual(re.findall(loads, self.text), [])
        self.assertGreaterEqual(self.text.count("<svg"), 3)

    def test_the_same_pictures_as_png(self):
        pictures = sorted(path.name for path in self.folder.glob("*.png"))
        self.assertEqual(len(pictures), self.text.count("<svg"))
        for name in pictures:
            self.assertEqual((self.folder / name).read_bytes()[:4], b"\x89PNG")

    def test_the_same_tables_give_the_same_page(self):
        self.assertEqual(page.write(self.folder).read_text(), self.text)

    def test_every_part_stands_under_its_heading_and_in_the_contents(self):
        headings = re.findall(r'<h2 id="([^"]*)">', self.text)
        self.assertEqual(headings, ["reach", "beam", "omissions", "definitions"])
        self.assertEqual(re.findall(r'<li><a href="#([^"]*)">', self.text), headings)

    def test_it_says_where_and_when_and_how_much_was_run(self):
        quick = row(machine="a box & 2 cores", form="quick", date="2024-05-06", versions="PETSc 3", program="abc")
        said = page.origin([quick, quick | {"date": "2024-05-08"}])
        for words in ("the quick form", "a box & 2 cores", "2024-05-06 to 2024-05-08", "PETSc 3", "build abc"):
            self.assertIn(words, said)
        self.assertIn("the full form", page.origin([row(form="full")]))
        self.assertNotIn("Measured", page.origin([row()]))  # of a table of before

    def test_no_table_is_wider_than_a_window(self):
        for head in re.findall(r"<tr>((?:<th>.*?</th>)+)</tr>", self.text):
            self.assertLessEqual(head.count("<th>"), 12)

    def test_labels_cover_neither_each_other_nor_a_point(self):
        crowd = [row(key=f"{k}", k=float(k), r=float(r), seconds=1e-3 * (1 + 0.02 * k), error_integrated=0.1 / (1 + 0.05 * k))
                 for k, r in zip(range(1, 30), range(10, 40))]
        figure = pictures.work_precision(motion() + crowd)
        figure.draw_without_rendering()
        renderer = figure.canvas.get_renderer()
        for axes in figure.axes:
            boxes = [text.get_window_extent(renderer) for text in axes.texts]
            for i, box in enumerate(boxes):
                self.assertFalse(any(map(box.overlaps, boxes[:i])), axes.texts[i].get_text())
        labels = [text for text in figure.axes[0].texts if text.get_text().startswith("k")]
        self.assertGreater(len(labels), 3)
        self.assertLess(len(labels), len(crowd))
        pictures.plt.close(figure)

    def test_failures_are_listed_with_their_reason(self):
        self.assertIn("step 3 &lt;does not&gt; converge", self.text)
        self.assertIn("failed (time until then)", self.text)
        good = page.omissions([one for one in motion() if one["status"] == "done"])
        self.assertNotIn("converge", good)
        self.assertIn("not planned", good)

    def test_definitions_stand_in_it(self):
        for name in errors.DEFINITIONS:
            self.assertIn(f"<dt>{name}</dt>", self.text)

    def test_time_to_one_percent(self):
        lines = page.reach_table(motion()).splitlines()
        derivatives = next(line for line in lines if "modes + derivatives" in line)
        self.assertIn("0.8 %", derivatives)
        self.assertIn("0.005 s", derivatives)
        self.assertIn("2 % at best", page.reach_table([row(error_integrated=0.02)]))

    def test_where_a_model_is_paid_back_is_drawn(self):
        self.assertTrue((self.folder / "beam_break_even.png").exists())
        derivatives = next(one for one in motion() if one["key"] == "d820")
        self.assertEqual(compare.break_even(derivatives, motion()), 201)
        for words in ("modes + derivatives, k8 r20 (0.8 % off)", "paid back after 201 steps"):
            self.assertIn(words, self.text)

    def test_a_scene_where_all_runs_failed(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertIn("No run was finished", write(Path(folder), [row(status="failed", reason="why")]))

    def test_a_family_over_its_load(self):
        rows = [row(key=f"{factor}{method}", scene="fork" if factor == 1 else f"fork_x{factor}", method=method,
                    load_factor=float(factor), error_integrated=1e-4 * factor)
                for factor in (1, 30) for method in ("linear", "derivatives")]
        with tempfile.TemporaryDirectory() as folder:
            write(Path(folder), rows)
            self.assertTrue((Path(folder) / "fork_over_load.png").exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
