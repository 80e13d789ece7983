"""check_words.py must find what it is there to find."""
import tempfile
import unittest
from pathlib import Path

import check_words

NAMES = ["mesh", "modes", "modes_block", "basis", "fix"] + [f"option{i}" for i in range(20)]
TABLE = "entries = {\n" + "".join(f'    {{"{name}", "N", "", "", "text"}},\n' for name in NAMES) + "});\n"


class Words(unittest.TestCase):
    def complaints(self, line, table=TABLE):
        with tempfile.TemporaryDirectory() as name:
            root = Path(name)
            for file, text in ((check_words.TABLE, table), ("src/stages/a.cpp", line + "\n")):
                (root / file).parent.mkdir(parents=True)
                (root / file).write_text(text)
            return list(check_words.check(root))

    def test_finds_options_and_tables(self):
        for line in ('"; raise -modes or"', '"-basis"', "// see -fix", '"lower -modes_block"', '"under -modes_eps_"',
                     '"[static]: it moves"', 'f(x);  // [[load]] of the scene', '"(-fix)"', '"\\"-fix"'):
            self.assertEqual(len(self.complaints(line)), 1, line)

    def test_lets_code_and_prose_pass(self):
        for line in ("a -basis(x)", "x = a[time];", "// left-modes", '"-modesty"', "values[load]", '"a" -mesh "b"'):
            self.assertEqual(self.complaints(line), [], line)

    def test_needs_the_table(self):
        self.assertIn("not understood", self.complaints("", table="none")[0])


if __name__ == "__main__":
    unittest.main()
