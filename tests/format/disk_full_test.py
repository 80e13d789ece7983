"""A disk that fills up at any moment of writing costs one sentence and leaves the previous model as it was."""
import os
import sys
import tempfile

import programs
from program import BIN

WRITE = BIN / "write_sample_model"
SCRIPT = """
mount -t tmpfs -o size={size}k tmpfs "$1" && cd "$1" && echo mounted || exit
"$0" model.h5 && "$0" model.h5 {notes}
echo "exit $?"
ls -A
cmp model.h5 "$2"
"""


def fill(size, notes, reference):
    with tempfile.TemporaryDirectory() as folder:
        words = ["-rm", "sh", "-c", SCRIPT.format(size=size, notes=notes), WRITE, folder, reference]
        ran = programs.run("unshare", *words, code=None)
    if "mounted" not in ran.out:
        sys.exit(77)
    return ran.out.split("\n")[1:-1], ran.err


with tempfile.TemporaryDirectory() as folder:
    reference = os.path.join(folder, "reference.h5")
    programs.run(WRITE, reference)
    for size in (1060, 1200, 2000, 3900, *range(3912, 3940, 4), 6000):
        lines, errors = fill(size, 200000, reference)
        if lines[0] == "exit 1":
            assert lines[1:] == ["model.h5", "model.hdf"], (size, lines, errors)
            assert errors.count("\n") == 1 and ("the disk is full" in errors or "is the disk full" in errors), (size, errors)
        else:
            assert lines[0] == "exit 0" and size > 3906 and "differ" in lines[3], (size, lines, errors)
    assert lines[0] == "exit 0"
