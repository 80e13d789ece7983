"""Runs of the programs: how one is started, what it answered and cost, and the sentence that it fails with."""
import os
import platform
import re
import shlex
import subprocess
import tempfile
import time
from dataclasses import dataclass, replace
from pathlib import Path

PARALLEL = ("ritz-reduce", "ritz-full")
# What lets Open MPI run as root, in a container and on fewer cores than ranks, unless the caller has set it otherwise.
OPEN_MPI = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
            "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_btl_vader_single_copy_mechanism": "none"}
ONE_THREAD = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}


class Failed(Exception):
    """`reason`: the sentence that says why; `seconds` on the wall until then, 0 where nothing was measured."""

    def __init__(self, reason, seconds=0.0, message=None):
        super().__init__(message or reason)
        self.reason, self.seconds = reason, seconds


@dataclass(frozen=True)
class Ran:
    program: str
    code: int
    out: str
    err: str
    seconds: float = 0  # on the wall
    memory: float | None = None  # bytes, the most that one process held; None where it was not measured

    @property
    def sentence(self):
        """What the program said of its failure, without what mpirun adds."""
        return "\n".join(line for line in self.err.splitlines() if line.startswith(f"{self.program}: "))

    @property
    def warnings(self):
        return [line for line in self.err.splitlines() if "warning: " in line]

    @property
    def reason(self):
        """The one line in which the program, or else mpirun, says why it failed."""
        lines = [line for line in self.err.splitlines() if any(map(str.isalpha, line)) and "warning: " not in line]
        own = [line for line in lines if line.startswith("ritz-")]
        return next(iter(own or lines), "no reason given")


def machine():
    """What figures are measured on: "Intel Xeon at 2.8 GHz, 2 cores, 24 GB, Linux 6.1.0 x86_64"."""
    try:
        processor = re.search(r"^model name\s*: *(.*)", Path("/proc/cpuinfo").read_text(), re.MULTILINE)
    except OSError:
        processor = None
    name = processor[1] if processor else platform.processor() or "a processor without a name"
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    return (f"{' '.join(name.split())}, {len(os.sched_getaffinity(0))} cores, {memory / 1e9:.0f} GB, "
            f"{platform.system()} {platform.release()} {platform.machine()}")


def built():
    """The folder of the programs: RITZ_BIN, else the default build of this tree."""
    return Path(os.environ.get("RITZ_BIN", Path(__file__).resolve().parents[1] / "build/default/bin"))


def mpirun(ranks):
    """The words that start a program on so many ranks; none for 0."""
    return ["mpirun", "-n", str(ranks)] if ranks else []


def start(program, *words, under=(), folder=None, environment=None, **more):
    """A process. `under`: the words that start the program, such as mpirun's; `environment`: variables besides ours and
    the caller's, None for one that is to be absent; `more`: of subprocess.Popen."""
    variables = OPEN_MPI | os.environ | ONE_THREAD | (environment or {})
    variables = {name: value for name, value in variables.items() if value is not None}
    streams = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True} | more
    return subprocess.Popen(list(map(str, [*under, program, *words])), cwd=folder, env=variables, **streams)


def run(program, *words, code=0, limit=None, **how):
    """A program to its end, which `start` starts. Raises Failed after `limit` seconds, and where the exit code is not
    `code`; None: whatever comes."""
    name, began = Path(program).name, time.perf_counter()
    with start(program, *words, **how) as process:
        try:
            out, err = process.communicate(timeout=limit)
        except BaseException as why:
            process.terminate()  # mpirun ends its ranks then
            try:
                process.wait(5)
            except subprocess.TimeoutExpired:
                process.kill()
            if isinstance(why, subprocess.TimeoutExpired):
                raise Failed(f"{name} did not end within {limit} s", limit) from None
            raise
    ran = Ran(name, process.returncode, out, err, time.perf_counter() - began)
    if code is not None and ran.code != code:
        said = ran.sentence or ran.err[-300:] or ran.out[-300:]
        raise Failed(ran.reason, ran.seconds, f"{shlex.join([name, *map(str, words)])}: exit code {ran.code}: {said}")
    return ran


def measured(program, *words, under=(), **how):
    """`run`, with the memory. Under `time`, which is small: a process inherits the peak of the one that started it."""
    with tempfile.NamedTemporaryFile("r") as peak:
        ran = run(program, *words, under=["/usr/bin/time", "-q", "-f", "%M", "-o", peak.name, *under], **how)
        return replace(ran, memory=1024.0 * int(peak.read()))
