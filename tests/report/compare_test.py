"""Fronts, the time to an error, the steps that pay a model back."""
import math
import random
import sys
import unittest

from support import row
from report import compare


class Compare(unittest.TestCase):
    def test_front(self):
        points = [(3, 1.0), (1, 5.0), (2, 5.0), (2, 2.0), (4, 1.0), (5, 0.5)]
        self.assertEqual(compare.front(points), [1, 3, 0, 5])
        self.assertEqual(compare.front([]), [])

    def test_nothing_beats_the_front(self):
        chance = random.Random(1)
        points = [(chance.random(), chance.random()) for _ in range(200)]
        front = set(compare.front(points))
        for i, (cost, error) in enumerate(points):
            beaten = any(c <= cost and e <= error and (c, e) != (cost, error) for c, e in points)
            self.assertEqual(i in front, not beaten)

    def test_time_to_an_error_is_of_runs_that_reach_it(self):
        rows = [row(key="wrong", seconds=1e-6, error_integrated=0.02),
                row(key="slow", seconds=2, error_integrated=0.001),
                row(key="good", seconds=1, error_integrated=0.01),
                row(key="failed", status="failed", seconds=1e-9, error_integrated=0.0)]
        self.assertEqual(compare.to_reach(rows, 0.01)["key"], "good")
        self.assertIsNone(compare.to_reach(rows, 1e-4))

    def test_an_error_below_the_references_floor_is_not_told(self):
        rows = [row(seconds=1, error_integrated=0.002, floor=0.03)]
        self.assertIsNone(compare.to_reach(rows, 0.01))
        self.assertEqual(compare.time_to(rows, 0.01), "below 3 % at best")
        self.assertEqual(compare.time_to(rows, 0.03), "1 s")
        self.assertEqual(compare.told(row(error_integrated=0.05, floor=0.03)), "5 %")

    def test_words_for_the_time_to_an_error(self):
        rows = [row(seconds=2, error_integrated=0.013), row(status="failed", error_integrated=0.0)]
        self.assertEqual(compare.time_to(rows, 0.02), "2 s")
        self.assertEqual(compare.time_to(rows, 0.01), "1.3 % at best")
        self.assertEqual(compare.time_to(rows[1:], 0.01), "failed")
        self.assertEqual(compare.time_to([], 0.01), "–")

    def test_shares_in_words(self):
        words = {0.0131: "1.3 %", 0.0996: "10 %", 0.998: "100 %", 2.4e-4: "0.024 %", math.nan: "–"}
        for share, text in words.items():
            self.assertEqual(compare.percent(share), text)

    def test_the_table_of_times_says_what_its_reference_is_worth(self):
        rows = [row(method="full", floor=0.0046, error_integrated=0.004, seconds=2.0), row(method="pod", floor=0.0046)]
        heads, lines = compare.reach(rows, {"pod": "POD", "linear": "linear", "full": "full"}, 0.005)
        self.assertEqual(heads, ("time of stepping to 0.5 %", "POD", "full", "the reference's floor"))
        self.assertEqual((lines[0][2], lines[0][3]), ("2 s", "0.46 %"))
        self.assertEqual(compare.reach([row(floor=1e-12)], {}, 0.01)[1][0][-1], "rounding")

    def test_where_a_method_stops_being_enough(self):
        rows = [row(method="linear", load_factor=factor, error_integrated=error)
                for factor, error in ((1.0, 1e-3), (1.0, 5e-3), (10.0, 1e-1), (100.0, 1.0))]
        self.assertAlmostEqual(compare.enough_until(rows, "linear", 0.01), 10 ** 0.5)
        self.assertTrue(math.isnan(compare.enough_until(rows, "linear", 1e-4)))
        self.assertTrue(math.isnan(compare.enough_until(rows, "pod", 0.01)))

    def test_break_even(self):
        full = row(method="full", microseconds=5010.0, precompute_seconds=math.nan)
        other = row(method="full", microseconds=1.0, scene="another")
        reduced = row(microseconds=10.0, precompute_seconds=2.0, error_integrated=0.05)
        self.assertEqual(compare.break_even(reduced, [full, other, reduced]), 400)
        self.assertTrue(math.isnan(compare.break_even(reduced, [other, reduced])))
        self.assertTrue(math.isnan(compare.break_even(row(microseconds=6000.0, error_integrated=0.01), [full])))
        self.assertTrue(math.isnan(compare.break_even(full, [full])))
        self.assertTrue(math.isnan(compare.break_even(reduced | {"error_integrated": 0.06}, [full])), "too wrong")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
