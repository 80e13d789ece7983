#!/usr/bin/env python3
"""Puts the tables of a report into the documentation: what stands between <!-- NAME --> and <!-- /NAME --> is replaced.

    doc_tables.py [report [docs]]

reads report/runs.csv (reach), report/lean.csv (lean) and report/stability.csv (stability), which scripts/report.sh and
scripts/stability.sh write, puts them into docs/report.md and docs/stability.md, and copies the diagram of the first scene to
docs/work_precision.png."""
import csv
import shutil
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from report import compare, diagram, lean, page, table  # noqa: E402

LONGEST = 260  # letters of a cell


def markdown(heads, lines):
    safe = lambda text: str(text).replace("|", "\\|").replace("\n", " ")  # noqa: E731
    rows = [heads, ["---"] * len(heads), *lines]
    return "".join("| " + " | ".join(safe(x) for x in row) + " |\n" for row in rows)


def short(text):
    return text if len(text) <= LONGEST else text[:LONGEST].rsplit(" ", 1)[0] + " …"


def reach(folder):
    rows = table.read(folder / "runs.csv")
    return f"{page.origin(rows)}\n\n{markdown(*compare.reach(rows, diagram.TITLES, 0.01))}"


def scaled(row, column, scale):
    return f"{float(row[column]) / scale:.3g}" if row[column] else "–"


def lean_rows(folder):
    lines = [[row["kind"], row["stages"] or "–", scaled(row, "seconds", 1), scaled(row, "memory_bytes", 1e6),
              scaled(row, "file_bytes", 1e6), scaled(row, "load_seconds", 1e-3), scaled(row, "resident_bytes", 1e6)]
             for row in lean.read(folder / "lean.csv")]
    return markdown(["kind of scene", "stages that ran", "s", "memory, MB", "file, MB", "load, one step, a frame, ms",
                     "resident, MB"], lines)


def stability(folder):
    with open(folder / "stability.csv", newline="") as file:
        lines = [[row["scene"], short(row["asked"]), short(row["observed"]), row["verdict"]]
                 for row in csv.DictReader(file)]
    return markdown(["scene", "asked", "observed", "verdict"], lines)


def replaced(text, name, new):
    begin, end = f"<!-- {name} -->\n", f"<!-- /{name} -->"
    if text.count(begin) != 1 or text.count(end) != 1:
        raise SystemExit(f"the page has no place for the table '{name}': mark it with {begin.strip()} and {end}")
    return text[:text.index(begin) + len(begin)] + "\n" + new + "\n" + text[text.index(end):]


def main(report="report", docs="docs"):
    report, docs = Path(report), Path(docs)
    for name, source, make, target in (("reach", "runs.csv", reach, "report.md"),
                                       ("lean", "lean.csv", lean_rows, "report.md"),
                                       ("stability", "stability.csv", stability, "stability.md")):
        if (report / source).exists():
            (docs / target).write_text(replaced((docs / target).read_text(), name, make(report)))
    rows = table.read(report / "runs.csv")
    if rows:
        shutil.copy(report / f"{rows[0]['scene']}_work_precision.png", docs / "work_precision.png")


if __name__ == "__main__":
    main(*sys.argv[1:])
