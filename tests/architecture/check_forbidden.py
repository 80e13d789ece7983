"""What the compiler itself sees of the layers: a header of a layer that may not be used is not found, one that may is.

    check_forbidden.py FACTS SOURCE

FACTS is a folder with one file a target, as CMake generates it: the compiler, then -I options, one a line. A layer that
is not built (python where pybind11 is not) has none.
"""
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import layers

# Outside headers that must not even be reachable.
PARALLEL = ["mpi.h", "petscsys.h", "slepcsys.h"]
UNREACHABLE = {
    **dict.fromkeys(["base", "files", "fem", "model", "runtime", "scene", "scene_file", "world", "readers"], PARALLEL + ["hdf5.h"]),
    **dict.fromkeys(["format", "tools", "decks", "python"], PARALLEL),
    "parallel": ["petscsys.h", "slepcsys.h"],
}


def shown_headers(table, source):
    """One header of each layer that has any, as other layers spell it."""
    headers = {}
    for folder in table:
        installed = source / "include/ritz" / folder
        found = sorted((installed if installed.is_dir() else source / "src" / folder).glob("*.hpp"))
        if found:
            headers[folder] = f"ritz/{folder}/{found[0].name}"
    return headers


def is_found(facts, header):
    compiler, *options = facts
    command = [compiler, "-E", *options, "-x", "c++", "-o", os.devnull, "-"]
    text = f"#if !__has_include(<{header}>)\n#error absent\n#endif\n"
    return subprocess.run(command, input=text, capture_output=True, text=True).returncode == 0


def check(facts_folder, source):
    table = {name: layer for name, layer in layers.read(source).items() if (facts_folder / f"{name}.txt").exists()}
    facts = {name: (facts_folder / f"{name}.txt").read_text().split() for name in table}
    jobs = [(layer, header, other in layers.closure(table, layer))
            for layer in table for other, header in shown_headers(table, source).items()]
    jobs += [(layer, header, False) for layer in table for header in UNREACHABLE.get(layer, [])]

    def complaint(job):
        layer, header, allowed = job
        found = is_found(facts[layer], header)
        return None if found == allowed else f"layer {layer} {'sees' if found else 'does not see'} {header}"

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        return len(jobs), [said for said in pool.map(complaint, jobs) if said]


if __name__ == "__main__":
    count, complaints = check(Path(sys.argv[1]), Path(sys.argv[2]))
    print("\n".join(complaints) or f"{count} headers are seen, or not, as the table of layers says")
    sys.exit(1 if complaints or not count else 0)
