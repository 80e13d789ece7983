"""runs.csv is appended to, read back, and survives an interruption in the middle of a row."""
import math
import sys
import tempfile
import unittest
from pathlib import Path

from support import row
from report import table


class Table(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.path = Path(temporary.name) / "runs.csv"

    def test_round_trip(self):
        written = [row(key="a", reason='a "b", c'), row(key="b", microseconds_p99=math.nan, iterations=None)]
        for one in written:
            table.append(self.path, table.COLUMNS, [one])
        read = table.read(self.path)
        self.assertEqual([one["key"] for one in read], ["a", "b"])
        self.assertEqual(read[0], written[0])
        self.assertTrue(math.isnan(read[1]["microseconds_p99"]) and math.isnan(read[1]["iterations"]))

    def test_a_cut_row_is_not_read_and_makes_room(self):
        for cut in (1, 2, 40):
            self.path.unlink(missing_ok=True)
            table.append(self.path, table.COLUMNS, [row(key="a"), row(key="b")])
            self.path.write_bytes(self.path.read_bytes()[:-cut])
            self.assertEqual([one["key"] for one in table.read(self.path)], ["a"])
            table.keep(self.path, table.COLUMNS, {"a", "b"})
            table.append(self.path, table.COLUMNS, [row(key="c")])
            self.assertEqual([one["key"] for one in table.read(self.path)], ["a", "c"])

    def test_rows_that_are_not_wanted_are_dropped(self):
        table.append(self.path, table.COLUMNS, [row(key="a"), row(key="b"), row(key="c")])
        self.assertEqual(table.keep(self.path, table.COLUMNS, {"a", "c"}), 1)
        self.assertEqual([one["key"] for one in table.read(self.path)], ["a", "c"])
        self.assertEqual(table.keep(self.path, table.COLUMNS, {"a", "c"}), 0)

    def test_without_a_file(self):
        self.assertEqual(table.read(self.path), [])
        self.assertEqual(table.keep(self.path, table.COLUMNS, {"a"}), 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
