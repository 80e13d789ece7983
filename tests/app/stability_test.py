"""One row of the stability report at its short length, held against its gate.

    stability_test.py NAME
"""
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))

from program import BIN  # noqa: E402
from stability import report, table  # noqa: E402
from stability.row import Length, Verdict  # noqa: E402
from stability.work import run_row  # noqa: E402


class Stability(unittest.TestCase):
    def test_row(self):
        row = next(row for row in table.ROWS if row.name == NAME)
        result = run_row(row, BIN, Length.short)
        print(report.text_of(result), flush=True)
        self.assertIsNot(result.verdict, Verdict.fails, result.observed)


if __name__ == "__main__":
    NAME = sys.argv.pop()
    unittest.main()
