"""One row of the stability report at its short length, held against its gate.

    stability_test.py NAME
"""
import sys
import unittest

from program import BIN
from stability import report, table
from stability.row import Length, Verdict, run_row


class Stability(unittest.TestCase):
    def test_row(self):
        row = next(row for row in table.ROWS if row.name == NAME)
        result = run_row(row, BIN, Length.short)
        print(report.text_of(result), flush=True)
        self.assertIsNot(result.verdict, Verdict.fails, result.observed)


if __name__ == "__main__":
    NAME = sys.argv.pop()
    unittest.main()
