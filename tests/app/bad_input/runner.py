"""One row of the table: files, a command line, and what the program must answer."""
import re
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

from bench import Bench
from program import BIN, sentences
from programs import PARALLEL, Failed


@dataclass
class Case:
    name: str
    words: list
    says: list  # pieces that the sentence must hold
    files: dict = field(default_factory=dict)  # name -> text, bytes, or a function that makes it at a path
    program: str = "ritz-reduce"
    code: int = 2
    leaves: set = field(default_factory=set)  # new files of a run that is meant to succeed


RANKS = 2
# mpirun ends the other ranks once one has failed: each says with which code it ended by itself, and waits for the others.
EACH_RANK = """codes=$1; shift; "$@"; code=$?; echo $code >"$codes/$OMPI_COMM_WORLD_RANK"; tries=0
until [ -s "$codes/0" ] && [ -s "$codes/1" ] || [ $tries = 200 ]; do sleep .03; tries=$((tries + 1)); done; exit $code"""


def write_files(files, folder):
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if callable(content):
            content(path)
        else:
            path.write_bytes(content.encode() if isinstance(content, str) else content)


def contents(folder):
    """What stands where: the bytes of files; links and devices by their names alone."""
    files = (path for path in folder.rglob("*") if not path.is_dir())
    return {str(path.relative_to(folder)): path.read_bytes() if path.is_file() and not path.is_symlink() else None
            for path in files}


def complaints_about(case, result, codes, before, after):
    """What is wrong with the answer, in words; nothing when it is right."""
    if result.code != case.code or codes != [case.code] * (RANKS if case.program in PARALLEL else 0):
        yield f"exit code {result.code}, of the ranks {codes}, in place of {case.code}"
    said = sentences(result.err)
    if len(said) != (0 if case.code == 0 else 1):
        yield f"{len(said)} lines on stderr"
    if case.code != 0 and said and not re.match(rf"{case.program}: \S.*[^.\s]$", said[0]):
        yield "the line is no sentence of the program"
    for piece in case.says:
        if piece not in " ".join(said):
            yield f"the sentence lacks '{piece}'"
    if re.search(r"PETSC ERROR|Traceback|HDF5-DIAG|terminate called|\[\d+\]", result.err):
        yield "a stack trace"
    new = set(after) - set(before)
    if new != case.leaves:
        yield f"left behind {sorted(new - case.leaves)}, lacking {sorted(case.leaves - new)}"
    changed = [name for name in before if after.get(name) != before[name]]
    if changed:
        yield f"changed {changed}"


@dataclass
class Answer:
    complaints: list
    said: str = ""
    seconds: float = 0


def run(case):
    with tempfile.TemporaryDirectory() as temporary, tempfile.TemporaryDirectory() as codes:
        bench = Bench(BIN, temporary, limit=60)
        write_files(case.files, bench.folder)
        before = contents(bench.folder)
        each = ["sh", "-c", EACH_RANK, "sh", codes] if case.program in PARALLEL else []
        try:
            result = bench.run(case.program, *case.words, ranks=RANKS, under=each, code=None)
        except Failed:
            return Answer(["hangs"])
        ended = [int(text) for path in Path(codes).iterdir() if (text := path.read_text())]
        found = complaints_about(case, result, ended, before, contents(bench.folder))
        return Answer(list(found), result.err, result.seconds)


def written(name, program, *words, files=()):
    """The bytes of a file that a program makes of these words."""
    with tempfile.TemporaryDirectory() as temporary:
        bench = Bench(BIN, temporary, limit=60)
        write_files(dict(files), bench.folder)
        bench.run(program, *words)
        return (bench.folder / name).read_bytes()
