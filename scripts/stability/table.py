"""All rows, in the order of the report."""
from . import (compression, contrast, cubature, degenerate, huge_loads, long_runs, near_incompressible, repeated, restarts,
               single, slender, slivers, static_loads, stiff_step, twist, units)

GROUPS = {
    "Nearly incompressible": near_incompressible,
    "Two very unequal halves": contrast,
    "Slender": slender,
    "Slivers": slivers,
    "Steps far too long": stiff_step,
    "Twist": twist,
    "Compression": compression,
    "Huge loads": huge_loads,
    "Cubature": cubature,
    "Long runs": long_runs,
    "Stopped and gone on with": restarts,
    "Static loads": static_loads,
    "Repeated eigenvalues": repeated,
    "Too much or too little in the mesh": degenerate,
    "Units, scales and the origin": units,
    "Single precision": single,
}
ROWS = [row for group in GROUPS.values() for row in group.ROWS]


def find(names):
    """The rows whose names begin so (all, when there are no names), and the names that no row has."""
    found = [row for row in ROWS if not names or any(row.name.startswith(name) for name in names)]
    unknown = [name for name in names if not any(row.name.startswith(name) for row in ROWS)]
    return found, unknown
