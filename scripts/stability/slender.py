"""A cantilever of length 1 m and section 1 x 1 mm, quadratic cells."""
import math

from bench import SOFT
from .row import Figure, Row, near

BEAM = ["-mesh", "box:1,.001,.001/30,1,1/tet10", "-fix", "xmin", *SOFT, "-modes", "2"]
EXPECTED = 1.875104 ** 2 * math.sqrt(1e6 * .001 ** 2 / 12 / 1000) / (2 * math.pi)  # Euler-Bernoulli, Hz


def direct(bench, length):
    return [near("f1 in Hz", bench.frequencies(*BEAM)[0], EXPECTED, .01)]


def iterative(bench, length):
    ran = bench.reduce(*BEAM, "-solver", "iterative", "-quiet", code=None)
    if ran.code == 0:
        return [near("said to be converged; f1 in Hz", float(bench.modes()[0]["frequency_hz"]), EXPECTED, .01)]
    return [Figure(f"exit {ran.code}, '{ran.sentence}'", ran.code == 1 and "converged to" in ran.sentence)]


ROWS = [
    Row("slender_direct", "L/h = 1000, by factorization", "f1 within 1 % of Euler-Bernoulli", direct),
    Row("slender_iterative", "L/h = 1000, -solver iterative",
        "f1 within 1 %, or a failure that is said: never a false 'converged'", iterative, seconds=8),
]
