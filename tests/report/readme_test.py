"""Tables go between their marks, again and again, and nowhere else."""
import unittest

import support  # noqa: F401  (finds the scripts)
import readme_tables

PAGE = "# a\n<!-- lean -->\nold\n<!-- /lean -->\nb\n"


class Readme(unittest.TestCase):
    def test_only_what_is_between_the_marks_changes(self):
        once = readme_tables.replaced(PAGE, "lean", "| new |\n")
        self.assertEqual(once, "# a\n<!-- lean -->\n\n| new |\n\n<!-- /lean -->\nb\n")
        self.assertEqual(readme_tables.replaced(once, "lean", "| new |\n"), once)

    def test_a_page_without_the_marks_is_refused(self):
        for text in ("", PAGE.replace("<!-- /lean -->", ""), PAGE + PAGE):
            with self.assertRaises(SystemExit):
                readme_tables.replaced(text, "lean", "new")

    def test_a_cell_cannot_end_its_row(self):
        self.assertEqual(readme_tables.markdown(["a"], [["b|c\nd"]]).splitlines()[2], "| b\\|c d |")


if __name__ == "__main__":
    unittest.main()
