"""runs.csv, a row a run, and over_time.csv, a row a frame of a run: appended to as runs finish, so that an interruption
loses none."""
import csv
import os

COLUMNS = (
    "key", "scene", "title", "load_factor", "analysis", "end", "mesh_checksum", "problem_checksum", "vertices", "cells",
    "dofs", "program", "versions", "machine", "form", "date", "ranks", "method", "flags", "k", "r", "T", "columns", "integrator", "precision", "step",
    "sweep", "status", "reason", "repetitions", "microseconds", "microseconds_q1", "microseconds_q3",
    "microseconds_p99", "seconds", "seconds_q1", "seconds_q3", "iterations", "rejected", "run_memory",
    "precompute_seconds", "precompute_stages", "precompute_memory", "file_bytes", "error_integrated", "error_max",
    "error_basis", "error_time", "error_mesh", "mesh_compared", "floor", "reference_step", "error_frequency",
    "error_force", "energy_balance")
OVER_TIME = ("key", "t", "error")
TEXTS = {"key", "scene", "title", "analysis", "mesh_checksum", "problem_checksum", "program", "versions",
         "machine", "form", "date", "method",
         "flags", "integrator", "precision", "sweep", "status", "reason", "precompute_stages", "mesh_compared"}


def shown(value):
    if value is None or value != value:
        return ""
    return f"{value:.10g}" if isinstance(value, float) else value


def append(path, columns, rows):
    new = not path.exists()
    with open(path, "a", newline="") as file:
        writer = csv.DictWriter(file, columns, lineterminator="\n")
        if new:
            writer.writeheader()
        writer.writerows({name: shown(row.get(name)) for name in columns} for row in rows)


def read(path):
    """Rows as dicts: numbers are floats, an empty one NaN, texts stay. A last row that was cut off is left out."""
    if not path.exists():
        return []
    number = lambda text: float(text) if text else float("nan")  # noqa: E731
    lines = path.read_text().splitlines(keepends=True)
    whole = lines[:-1] if lines and not lines[-1].endswith("\n") else lines
    return [{name: text if name in TEXTS else number(text) for name, text in row.items()}
            for row in csv.DictReader(whole)]


def keep(path, columns, wanted):
    """Writes the file anew with the rows alone whose key is wanted; returns how many were dropped."""
    if not path.exists():
        return 0
    rows = read(path)
    kept = [row for row in rows if row["key"] in wanted]
    part = path.with_suffix(".part")
    part.unlink(missing_ok=True)
    append(part, columns, kept)
    os.replace(part, path)
    return len(rows) - len(kept)
