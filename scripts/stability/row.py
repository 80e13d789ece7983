"""What a row asks, what it saw, and the verdict; how it is run."""
import enum
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from bench import Bench


class Length(enum.Enum):
    short = "short"  # for the tests: seconds
    full = "full"  # for the report


class Verdict(enum.Enum):
    holds = "holds"
    fails = "fails"
    reported = "reported"  # nothing was asked: the figure is printed as it is


@dataclass(frozen=True)
class Figure:
    """Something measured, in words; `holds` is None where there is no gate."""
    text: str
    holds: bool | None = None


@dataclass(frozen=True)
class Row:
    name: str
    scene: str
    asked: str
    run: Callable
    seconds: int = 5  # what the full length takes, about


@dataclass(frozen=True)
class Result:
    row: Row
    figures: list[Figure]
    seconds: float

    @property
    def verdict(self):
        gated = [figure.holds for figure in self.figures if figure.holds is not None]
        if self.figures and not gated:
            return Verdict.reported
        return Verdict.holds if gated and all(gated) else Verdict.fails

    @property
    def observed(self):
        return "; ".join(figure.text for figure in self.figures)


def run_row(row, programs, length):
    """In a folder of its own. A row that cannot be measured fails."""
    start = time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        try:
            figures = row.run(Bench(programs, folder), length)
        except Exception as error:  # the report goes on and shows it
            figures = [Figure(f"{type(error).__name__}: {error}", False)]
    return Result(row, figures, time.monotonic() - start)


def plain(name):
    """As a row's name."""
    return name.replace("-", "_")


def at_most(what, value, gate):
    """NaN is not at most anything."""
    return Figure(f"{what} {value:.2g} (gate {gate:g})", bool(value <= gate))


def near(what, value, expected, gate):
    """Relative; `gate` too."""
    off = abs(value / expected - 1)
    shown = f"{off:.2%}" if 1e-3 <= off < 10 else f"{off:.1e}"
    return Figure(f"{what} {value:.6g}, {shown} off {expected:.6g} (gate {gate:g})", bool(off <= gate))


def equal(what, value, expected):
    return Figure(f"{what} {value}" + ("" if value == expected else f", not {expected}"), bool(value == expected))


def says(what, text, *pieces):
    """Whether a program's words hold every piece."""
    lacking = [piece for piece in pieces if piece not in text]
    return Figure(f"{what}: '{brief(text)}'" + "".join(f", without '{piece}'" for piece in lacking), not lacking)


def reported(text):
    return Figure(text)


def brief(text, most=220):
    text = " ".join(text.split())
    return text if len(text) <= most else text[:most] + " …"


def finite(what, values):
    """How many numbers of an array are not finite."""
    bad = int(np.count_nonzero(~np.isfinite(values)))
    seen = f"{bad} of {values.size} numbers not finite" if bad else f"{values.size} numbers, all finite"
    return Figure(f"{what}: {seen}", bad == 0)
