"""Reads every #include of the project: a layer includes its own headers, those of the layers that it may use, the
standard library, and the outside headers that belong to it.

    check_layers.py ROOT        prints each breach as FILE:LINE: sentence; exit code 1 when there is one
"""
import re
import sys
from pathlib import Path

import layers

# Outside headers and the folders that may include them. Whatever is not listed belongs to nobody.
EVERYWHERE_ABOVE_RUNTIME = {"files", "scene", "format", "tools", "readers", "parallel", "algebra", "mesh", "stages", "config",
                            "app"}
OUTSIDE = [
    (r"Eigen/\w+", {"fem", "model", "runtime", "world", "python"} | EVERYWHERE_ABOVE_RUNTIME),
    (r"(petsc|slepc)\w*\.h", {"algebra"}),
    (r"mpi\.h", {"parallel", "algebra", "mesh", "stages", "config", "app"}),  # the last four: a communicator
    (r"hdf5\.h|H5\w+\.h", {"format"}),
    (r"CLI/\w+\.hpp", {"tools", "decks"}),
    (r"pybind11/(stl/)?\w+\.h", {"python"}),
    (r"toml\+\+/\w+\.h", {"scene_file"}),
    (r"metis\.h", {"mesh"}),
    (r"pugixml\.hpp|zlib\.h|lz4\.h|lzma\.h", {"readers"}),
    (r"yaml\.h", {"config"}),
    (r"(unistd|fcntl|signal|dlfcn|malloc|errno)\.h|sys/\w+\.h", EVERYWHERE_ABOVE_RUNTIME),
]
STANDARD = r"[a-z_]+"  # <vector>, <cmath>: no folder and no ending
PRINTING = {"iostream", "print"}
PRINTERS = {"app", "tools", "decks"}

INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]')


def breach(layer, path, quote, header):
    """What is wrong with this include, or None."""
    if ".." in Path(header).parts:
        return f"{header} climbs out of its folder; say ritz/LAYER/x.hpp"
    if header.startswith("ritz/"):
        target = header.split("/")[1]
        return None if target in layer.uses else f"layer {layer.folder} may not use {target} ({header})"
    if quote == '"':
        return None if (path.parent / header).is_file() else f"{header} is not a header of this folder"
    if re.fullmatch(STANDARD, header):
        printing = header in PRINTING and layer.folder not in PRINTERS
        return f"layer {layer.folder} may not print (<{header}>)" if printing else None
    for pattern, allowed in OUTSIDE:
        if re.fullmatch(pattern, header):
            return None if layer.folder in allowed else f"layer {layer.folder} may not include <{header}>"
    return f"<{header}> is an outside header that no layer may include; list it in {Path(__file__).name}"


def check(root):
    breaches, count = [], 0
    table = layers.read(root)
    for layer in table.values():
        for path in layers.sources(root, layer.folder):
            for number, line in enumerate(path.read_text().splitlines(), 1):
                found = INCLUDE.match(line)
                if not found:
                    continue
                count += 1
                said = breach(layer, path, *found.groups())
                if said:
                    breaches.append(f"{path.relative_to(root)}:{number}: {said}")
    known = set(table)
    for place in ("src", "include/ritz"):
        for folder in (Path(root) / place).iterdir():
            if folder.is_dir() and folder.name not in known:
                breaches.append(f"{place}/{folder.name} is no layer of CMakeLists.txt")
    return breaches, count


if __name__ == "__main__":
    breaches, count = check(Path(sys.argv[1]))
    print("\n".join(breaches) or f"{count} includes keep to their layers")
    sys.exit(1 if breaches else 0)
