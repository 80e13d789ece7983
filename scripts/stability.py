#!/usr/bin/env python3
"""Runs the stability report's rows and prints what was asked, what was observed, and the verdict.

    stability.py [--rows NAME ...] [--length short|full] [--out FOLDER] [--list]

The programs are those of RITZ_BIN, else of build/default/bin. Exit code 1 when a row fails.
"""
import argparse
import datetime
import shlex
import sys
import tempfile
import time
from pathlib import Path

import h5py

from bench import SOFT, Bench, text
from programs import built, machine
from stability import report, table
from stability.row import Length, Verdict, run_row


def facts(programs, arguments):
    """What made this report."""
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(programs, folder)
        bench.reduce("-mesh", "box:1,1,1/1,1,1/tet4", *SOFT, "-modes", "1")
        with h5py.File(bench.folder / "model.h5") as file:
            made = file["provenance"]
            program = f"{text(made.attrs['program'])} on {made.attrs['ranks']} ranks"
            versions = {text(name): text(version) for name, version in made["versions"][:]}
    return {"command": shlex.join(arguments), "date": datetime.datetime.now().isoformat(" ", "minutes"),
            "machine": machine(), "program": program, **versions}


def waiting(rows, done_guess, spent):
    """About how long the rest takes, by how the guesses held so far."""
    pace = spent / done_guess if done_guess else 1
    left = pace * sum(row.seconds for row in rows)
    return f"{left / 60:.0f} min" if left >= 90 else f"{left:.0f} s"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rows", nargs="*", default=[], metavar="NAME", help="only rows whose names begin so")
    parser.add_argument("--length", choices=[length.value for length in Length], default="full")
    parser.add_argument("--out", type=Path, help="folder for stability.csv and stability.html")
    parser.add_argument("--list", action="store_true", help="print the rows' names, and run nothing")
    options = parser.parse_args()
    rows, unknown = table.find(options.rows)
    if unknown:
        parser.error(f"there is no row '{unknown[0]}'; --list prints their names")
    if options.list:
        print("\n".join(row.name for row in rows))
        return 0

    programs, length = built(), Length(options.length)
    made_by = facts(programs, sys.argv) if options.out else {}
    results, start, guessed = [], time.monotonic(), 0
    for i, row in enumerate(rows):
        print(f"[{i + 1}/{len(rows)}] {row.name}" + (
            f", about {waiting(rows[i:], guessed, time.monotonic() - start)} to go" if length is Length.full else ""),
            file=sys.stderr, flush=True)
        results.append(run_row(row, programs, length))
        guessed += row.seconds
        print(report.text_of(results[-1]), flush=True)
    print(report.summary(results))
    if options.out:
        options.out.mkdir(parents=True, exist_ok=True)
        report.write_csv(options.out / "stability.csv", results)
        groups = {title: group.ROWS for title, group in table.GROUPS.items()}
        report.write_html(options.out / "stability.html", results, groups, made_by)
        print(f"The report: {options.out}/stability.html, {options.out}/stability.csv")
    return int(any(result.verdict is Verdict.fails for result in results))


if __name__ == "__main__":
    sys.exit(main())
