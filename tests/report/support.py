"""Rows of the report's table."""
from report import table


def row(**values):
    """A finished run of the full table; `values` change it."""
    plain = {name: "" if name in table.TEXTS else 0.0 for name in table.COLUMNS}
    plain |= {"key": "k", "scene": "beam", "title": "A beam", "load_factor": 1.0, "analysis": "time", "end": 1.0,
              "method": "derivatives", "k": 4.0, "r": 8.0, "T": 0.0, "integrator": "avf", "precision": "double", "step": 0.01,
              "sweep": "basis", "status": "done", "seconds": 1e-3, "seconds_q1": 1e-3, "seconds_q3": 2e-3,
              "microseconds": 10.0, "error_integrated": 0.1, "error_basis": 0.1, "error_time": 0.01, "error_mesh": 0.05,
              "floor": 1e-3, "precompute_seconds": 2.0, "reference_step": 0.001}
    return plain | values
