"""What each kind of scene costs, beside the full set of parts; and what the runtime takes to load each kind of model.

lean.csv has a row a kind; the columns that a row does not have are empty."""
import csv
import os
import statistics
from dataclasses import dataclass

import h5py

import programs
from bench import SOFT, Bench, report_of, rows, statics

BEAMS = {"quick": "box:1,0.1,0.06/16,3,2/tet10", "full": "box:1,0.1,0.06/40,6,4/tet10"}
STATIC = statics('set = "xmax"', "total = [0, 0, -1]", steps=4)
ONE_STEP = STATIC.replace("[static]\nsteps = 4", "[time]\nstep = 1e-3\nend = 1e-3")
SCENES = {"one_step.toml": ONE_STEP, "static.toml": STATIC, "damped.toml": f"{ONE_STEP}[damping]\nalpha = 0.5\n"}
REPETITIONS = 10
COLUMNS = ("program", "form", "kind", "options", "stages", "groups", "seconds", "memory_bytes", "file_bytes",
           "load_seconds", "resident_bytes")


@dataclass(frozen=True)
class Kind:
    title: str
    options: tuple  # ritz-reduce's
    run: tuple = ()  # ritz-run's, beyond the model and the scene
    scene: str = "one_step.toml"


HELD = ("-fix", "xmin")
NONLINEAR = (*HELD, "-modes", "20", "-derivatives", "10", "-basis", "20", "-polynomial")
KINDS = (
    Kind("linear: one support set, no damping", (*HELD, "-modes", "20")),
    Kind("linear, two support sets", ("-fix", "xmin,xmax", "-modes", "20")),
    Kind("linear, damped", (*HELD, "-modes", "20"), scene="damped.toml"),
    Kind("linear, surface output", (*HELD, "-modes", "20", "-surface_only")),
    Kind("linear, free body", ("-fix", "none", "-modes", "20")),
    Kind("statics only, from full solutions", (*HELD, "-modes", "0", "-snapshots", "static.h5", "-polynomial"),
         scene="static.toml"),
    Kind("nonlinear", NONLINEAR),
    Kind("nonlinear, surface output", (*NONLINEAR, "-surface_only")),
    Kind("nonlinear, run as linear", NONLINEAR, ("--linear",)),
    Kind("the full set", (*HELD, "-modes", "20", "-derivatives", "20", "-basis", "40", "-polynomial")),
)


def reduced(bench, model, body, kind):
    """Reduces, and reads off the model what that took."""
    bench.reduce(*body, *kind.options, "-output", model, "-quiet")
    with h5py.File(bench.folder / model) as file:
        stages, figures = report_of(file)
        groups = sorted(file["bodies/body"])
    return {"stages": " ".join(name for name, _ in stages), "groups": " ".join(groups),
            "seconds": sum(seconds for _, seconds in stages), "memory_bytes": figures["peak_memory_bytes"],
            "file_bytes": (bench.folder / model).stat().st_size}


def load_times(bench, commands):
    """Of each of ritz-run's commands, which read what a step (or statics) needs and write one frame: median seconds, and
    bytes resident at the most. They take turns."""
    ritz_run = bench.programs / "ritz-run"
    rounds = [[programs.measured(ritz_run, *words, folder=bench.folder) for words in commands]
              for _ in range(REPETITIONS)]
    return [{"load_seconds": statistics.median(run.seconds for run in runs),
             "resident_bytes": statistics.median(run.memory for run in runs)} for runs in zip(*rounds)]


def run_words(model, kind):
    return [model, "--scene", kind.scene, "--frames", "1", "--output", "motion.h5", "--quiet", *kind.run]


def measure(bench, form, say):
    """A list of rows. `say(text)` is called before each."""
    bench.folder.mkdir(parents=True, exist_ok=True)
    body = ("-mesh", BEAMS[form], *SOFT)
    for name, scene in SCENES.items():
        bench.write(name, scene)
    say("what kinds of scenes need: full statics")
    bench.full(*body, *HELD, "-scene", "static.toml", "-output", "static.h5", "-quiet")
    found, commands = [{"kind": "ritz-run alone (--help)"}], [["--help"]]
    for number, kind in enumerate(KINDS):
        say(f"what kinds of scenes need: {kind.title}")
        model = f"{number}.h5"
        found.append({"kind": kind.title, "options": " ".join((*kind.options, *kind.run))} |
                     reduced(bench, model, body, kind))
        commands.append(run_words(model, kind))
    say("what kinds of scenes need: loading")
    return [row | cost for row, cost in zip(found, load_times(bench, commands))]


def size_of(folder):
    """Bytes of all files below, links not followed."""
    return sum(path.lstat().st_size for path in folder.rglob("*") if path.is_file() and not path.is_symlink())


def read(path):
    return rows(path) if path.exists() else []


def write(path, found):
    part = path.with_suffix(".part")
    with open(part, "w", newline="") as file:
        table = csv.DictWriter(file, COLUMNS)
        table.writeheader()
        table.writerows(found)
    os.replace(part, path)


def run(bin_folder, output, form, program, runtime, say):
    """Writes lean.csv unless it is there, of this build and form. `runtime`: a folder where the runtime alone is
    installed, or None."""
    path = output / "lean.csv"
    known = read(path)
    if known and all((row["program"], row["form"]) == (program, form) for row in known):
        return
    found = measure(Bench(bin_folder, output / "work" / program / "lean"), form, say)
    if runtime:
        found.append({"kind": "the runtime, installed (RITZ_PRECOMPUTE=OFF)", "file_bytes": size_of(runtime)})
    write(path, [{"program": program, "form": form, **row} for row in found])
