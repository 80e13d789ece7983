"""What each kind of scene costs, beside the full set of parts; and what the runtime takes to load each kind of model.

lean.csv has a row a kind; the columns that a row does not have are empty."""
import csv
import os
import statistics
from dataclasses import dataclass

import h5py

from report import programs

MATERIAL = ("-material_young", "1e6", "-material_poisson", "0.3", "-material_density", "1000")
BEAMS = {"quick": "box:1,0.1,0.06/16,3,2/tet10", "full": "box:1,0.1,0.06/40,6,4/tet10"}
STATIC = "[static]\nsteps = 4\n[[load]]\nset = 'xmax'\ntotal = [0, 0, -1]\n[[probe]]\nname = 'tip'\nset = 'xmax'\n"
ONE_STEP = STATIC.replace("[static]\nsteps = 4", "[time]\nstep = 1e-3\nend = 1e-3")
SCENES = {"one_step.toml": ONE_STEP, "static.toml": STATIC, "damped.toml": f"{ONE_STEP}[damping]\nalpha = 0.5\n"}
RANKS, REPETITIONS = 2, 10
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


def reduced(bin_folder, folder, model, body, kind):
    """Reduces, and reads off the model what that took."""
    words = [folder / word if word == "static.h5" else word for word in kind.options]
    programs.run(bin_folder / "ritz-reduce", [*body, *words, "-output", model, "-quiet"], RANKS)
    with h5py.File(model) as file:
        stages = [name.decode() for name in file["report/stages"][:]]
        seconds = float(sum(file["report/seconds"][:]))
        figures = dict(zip((name.decode() for name in file["report/figure_names"][:]), file["report/figure_values"][:]))
        groups = sorted(file["bodies/body"])
    return {"stages": " ".join(stages), "groups": " ".join(groups), "seconds": seconds,
            "memory_bytes": figures["peak_memory_bytes"], "file_bytes": model.stat().st_size}


def load_times(bin_folder, commands):
    """Of each of ritz-run's commands, which read what a step (or statics) needs and write one frame: median seconds, and
    bytes resident at the most. They take turns."""
    rounds = [[programs.run(bin_folder / "ritz-run", words) for words in commands] for _ in range(REPETITIONS)]
    return [{"load_seconds": statistics.median(run.seconds for run in runs),
             "resident_bytes": statistics.median(run.memory for run in runs)} for runs in zip(*rounds)]


def run_words(folder, model, kind):
    return [model, "--scene", folder / kind.scene, "--frames", "1", "--output", folder / "motion.h5", "--quiet", *kind.run]


def measure(bin_folder, folder, form, say):
    """A list of rows. `say(text)` is called before each."""
    folder.mkdir(parents=True, exist_ok=True)
    body = ("-mesh", BEAMS[form], *MATERIAL)
    for name, text in SCENES.items():
        (folder / name).write_text(text)
    say("what kinds of scenes need: full statics")
    programs.run(bin_folder / "ritz-full", [*body, *HELD, "-scene", folder / "static.toml", "-output",
                                            folder / "static.h5", "-quiet"], RANKS)
    rows, commands = [{"kind": "ritz-run alone (--help)"}], [["--help"]]
    for number, kind in enumerate(KINDS):
        say(f"what kinds of scenes need: {kind.title}")
        model = folder / f"{number}.h5"
        rows.append({"kind": kind.title, "options": " ".join((*kind.options, *kind.run))} |
                    reduced(bin_folder, folder, model, body, kind))
        commands.append(run_words(folder, model, kind))
    say("what kinds of scenes need: loading")
    return [row | cost for row, cost in zip(rows, load_times(bin_folder, commands))]


def size_of(folder):
    """Bytes of all files below, links not followed."""
    return sum(path.lstat().st_size for path in folder.rglob("*") if path.is_file() and not path.is_symlink())


def read(path):
    if not path.exists():
        return []
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def write(path, rows):
    part = path.with_suffix(".part")
    with open(part, "w", newline="") as file:
        table = csv.DictWriter(file, COLUMNS)
        table.writeheader()
        table.writerows(rows)
    os.replace(part, path)


def run(bin_folder, output, form, program, runtime, say):
    """Writes lean.csv unless it is there, of this build and form. `runtime`: a folder where the runtime alone is
    installed, or None."""
    path = output / "lean.csv"
    known = read(path)
    if known and all((row["program"], row["form"]) == (program, form) for row in known):
        return
    rows = measure(bin_folder, output / "work" / program / "lean", form, say)
    if runtime:
        rows.append({"kind": "the runtime, installed (RITZ_PRECOMPUTE=OFF)", "file_bytes": size_of(runtime)})
    write(path, [{"program": program, "form": form, **row} for row in rows])
