"""Every header compiles alone, with the include paths of its own layer.

    check_headers.py FACTS SOURCE

FACTS as in check_forbidden.py. Eigen is read once, in advance, for those headers that reach it by their own includes.
"""
import os
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import layers

OPTIONS = ["-std=c++20", "-Wall", "-Wextra", "-Werror", "-DOMPI_SKIP_MPICXX=1"]
INCLUDE = re.compile(r'^\s*#\s*include\s*["<]([^">]+)[">]', re.MULTILINE)
EIGEN = "Eigen/Core"


def reaches_eigen(header, source, known):
    """Whether the header includes Eigen, itself or through other headers of the project; `known` keeps the answers."""
    if header not in known:
        known[header] = False  # headers that include each other in a circle add nothing
        for name in INCLUDE.findall(header.read_text()):
            inner = [place for place in (source / "include" / name, source / "src" / name.removeprefix("ritz/"),
                                         header.parent / name) if place.is_file()]
            if name.startswith("Eigen/") or (inner and reaches_eigen(inner[0], source, known)):
                known[header] = True
    return known[header]


def said_of(command, text=""):
    """What the compiler complains of; nothing where it does not."""
    done = subprocess.run(command, input=text, capture_output=True, text=True)
    return done.stderr if done.returncode else ""


def check(facts_folder, source, work):
    table = layers.read(source)
    facts = {name: (facts_folder / f"{name}.txt").read_text().split() for name in table}
    ahead = work / "ahead.hpp"
    ahead.write_text(f"#include <{EIGEN}>\n")
    broken = said_of([*facts["fem"], *OPTIONS, "-x", "c++-header", str(ahead), "-o", f"{ahead}.gch"])
    if broken:
        return 0, [broken]
    known = {}
    jobs = [(layer, path) for layer in table for path in layers.sources(source, layer) if path.suffix == ".hpp"]

    def complaint(job):
        layer, path = job
        eigen = ["-include", str(ahead)] if reaches_eigen(path, source, known) else []
        return said_of([*facts[layer], *OPTIONS, *eigen, "-fsyntax-only", "-x", "c++", "-"], f'#include "{path}"\n')

    for _, path in jobs:
        reaches_eigen(path, source, known)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        return len(jobs), [said for said in pool.map(complaint, jobs) if said]


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        count, complaints = check(Path(sys.argv[1]), Path(sys.argv[2]), Path(folder))
    print("\n".join(complaints) or f"{count} headers compile alone")
    sys.exit(1 if complaints or not count else 0)
