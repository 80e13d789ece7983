"""The contract of a run that may fail: finite numbers, or one sentence, an exit code and nothing left behind."""
from .row import Figure, brief, finite

# What no user should see.
TRACES = ("PETSC ERROR", "Traceback", "HDF5-DIAG", "terminate called", "Segmentation", "MPI_ABORT")


def refused(bench, ran, before, code=None):
    """One figure for a run that was right to fail."""
    wrong = []
    if ran.code not in ((1, 2) if code is None else (code,)):
        wrong.append(f"exit code {ran.code}")
    if len(ran.sentence.splitlines()) != 1:
        wrong.append(f"{len(ran.sentence.splitlines())} sentences")
    wrong += [f"'{trace}' on stderr" for trace in TRACES if trace in ran.err.replace("MPI_ABORT was invoked", "")]
    left = bench.files() - before
    if left:
        wrong.append(f"left {', '.join(sorted(left))} behind")
    text = f"exit {ran.code}, '{brief(ran.sentence, 160)}'"
    return Figure(text + "".join(f", but {w}" for w in wrong), not wrong)


def finite_or_failed(bench, what, program, words, motion, dataset, codes=(1,)):
    """A run that may fail by its numerics, not by its input unless `codes` has 2; `motion` is the file whose dataset
    must be finite."""
    before = bench.files() - {motion}
    (bench.folder / motion).unlink(missing_ok=True)
    ran = bench.run(program, *words, code=None)
    if ran.code == 0:
        seen = finite(what, bench.read(motion, dataset))
        return Figure("converged, " + seen.text, seen.holds)
    seen = refused(bench, ran, before, code=ran.code if ran.code in codes else codes[0])
    return Figure(f"{what}: {seen.text}", seen.holds)
