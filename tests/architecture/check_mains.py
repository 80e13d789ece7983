"""A main stays thin: fewer than 60 lines from its first to its last.

    check_mains.py ROOT
"""
import re
import sys
from pathlib import Path

LIMIT = 60


def length(path):
    found = re.search(r"^int main\(.*?(?:^\}|\}$)", path.read_text(), re.MULTILINE | re.DOTALL)
    return len(found.group().splitlines()) if found else None


def check(root):
    mains = sorted(Path(root).glob("src/*/*_main.cpp"))
    if not mains:
        yield "there is no src/LAYER/*_main.cpp"
    for path in mains:
        lines = length(path)
        if lines is None:
            yield f"{path.relative_to(root)}: no main found"
        elif lines >= LIMIT:
            yield f"{path.relative_to(root)}: main has {lines} lines, and must stay under {LIMIT}"


if __name__ == "__main__":
    complaints = list(check(sys.argv[1]))
    print("\n".join(complaints) or "every main is thin")
    sys.exit(1 if complaints else 0)
