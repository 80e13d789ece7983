"""Tables go between their marks, again and again, and nowhere else; those in docs are of the rows that there are."""
import unittest
from pathlib import Path

import doc_tables
from report import lean, scenes
from stability import table as stability

PAGE = "# a\n<!-- lean -->\nold\n<!-- /lean -->\nb\n"


class Pages(unittest.TestCase):
    def test_only_what_is_between_the_marks_changes(self):
        once = doc_tables.replaced(PAGE, "lean", "| new |\n")
        self.assertEqual(once, "# a\n<!-- lean -->\n\n| new |\n\n<!-- /lean -->\nb\n")
        self.assertEqual(doc_tables.replaced(once, "lean", "| new |\n"), once)

    def test_a_page_without_the_marks_is_refused(self):
        for text in ("", PAGE.replace("<!-- /lean -->", ""), PAGE + PAGE):
            with self.assertRaises(SystemExit):
                doc_tables.replaced(text, "lean", "new")

    def test_a_cell_cannot_end_its_row(self):
        self.assertEqual(doc_tables.markdown(["a"], [["b|c\nd"]]).splitlines()[2], "| b\\|c d |")

    def cells(self, page, name):
        """Lines of a table of a page."""
        text = (Path(__file__).resolve().parents[2] / "docs" / page).read_text()
        rows = text[text.index(f"<!-- {name} -->"):text.index(f"<!-- /{name} -->")].splitlines()
        return [line.strip("| ").split(" | ") for line in rows if line.startswith("|")][2:]

    def test_the_tables_are_of_these_rows(self):
        self.assertEqual([row[:2] for row in self.cells("stability.md", "stability")],
                         [[row.scene, doc_tables.short(row.asked)] for row in stability.ROWS])
        self.assertEqual([row[0] for row in self.cells("report.md", "lean")][1:-1], [kind.title for kind in lean.KINDS])
        self.assertEqual([row[0] for row in self.cells("report.md", "reach")], [scene.title for scene in scenes.FULL])


if __name__ == "__main__":
    unittest.main()
