"""Layers of the method know no options of a program and no keys of a scene: the program adds what helps its user.

    check_words.py ROOT
"""
import re
import sys
from pathlib import Path

LAYERS = ["algebra", "stages", "runtime", "scene", "world"]
TABLE = "src/config/option_table.cpp"


def options(root):
    """The names of all options, as the table has them: {"mesh", "FILE", ...}."""
    return re.findall(r'^ *\{"(\w+)",', (root / TABLE).read_text(), re.MULTILINE)


def user_words(names):
    """-name of any option, alone or as the beginning of one, and [table] of a scene."""
    listed = "|".join(sorted(names, key=len, reverse=True))
    return re.compile(rf"(?<![\w-])-(?:{listed})(?![a-z])|\[\[?(?:time|static|damping|shake|load|probe)\]")


def spoken(line):
    """What of a line of C++ is words: its strings and its comment."""
    return " ".join(re.findall(r'"(?:[^"\\]|\\.)*"|//.*', line))


def check(root):
    root = Path(root)
    names = options(root)
    if len(names) < 20:
        yield f"{TABLE}: the table of options was not understood"
        return
    words = user_words(names)
    for layer in LAYERS:
        for path in sorted(p for top in ("src", "include/ritz") for p in (root / top / layer).rglob("*.[ch]pp")):
            for number, line in enumerate(path.read_text().splitlines(), 1):
                for said in words.findall(spoken(line)):
                    yield f"{path.relative_to(root)}:{number}: '{said}' is a word of the program's user"


if __name__ == "__main__":
    complaints = list(check(sys.argv[1]))
    print("\n".join(complaints) or "the method knows no options")
    sys.exit(1 if complaints else 0)
