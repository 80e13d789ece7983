"""Runs the scenes and draws the report; scripts/report.sh calls it."""
import argparse
import hashlib
import sys
from pathlib import Path

import programs
from report import campaign, lean, page, scenes
from report.methods import FORMS
from report.progress import Progress

PROGRAMS = ("ritz-reduce", "ritz-run", "ritz-full")


def build_of(folder):
    """Names a build on this machine: rows of another one are not comparable."""
    digest = hashlib.sha256(programs.machine().encode())
    for name in PROGRAMS:
        digest.update((folder / name).read_bytes())
    return digest.hexdigest()[:12]


def main():
    parser = argparse.ArgumentParser(prog="report.sh", description=__doc__)
    parser.add_argument("--quick", action="store_const", const="quick", default="full", dest="form",
                        help="fewer and smaller scenes, in under five minutes")
    parser.add_argument("--output", default=Path("report"), type=Path, help="the folder of the report")
    parser.add_argument("--bin", default=Path("build/default/bin"), type=Path, help="the folder of the programs")
    parser.add_argument("--runtime", type=Path, help="a folder where the runtime alone is installed, to be measured")
    options = parser.parse_args()
    missing = [name for name in PROGRAMS if not (options.bin / name).exists()]
    if missing:
        parser.error(f"{options.bin} has no {missing[0]}: build it first")
    options.output.mkdir(parents=True, exist_ok=True)
    progress = Progress()
    chosen = scenes.QUICK if options.form == "quick" else scenes.FULL
    program = build_of(options.bin)
    try:
        lean.run(options.bin.resolve(), options.output.resolve(), options.form, program, options.runtime, progress.say)
        campaign.run(campaign.start(chosen, FORMS[options.form], options.bin.resolve(), options.output.resolve(),
                                    program, progress))
    except KeyboardInterrupt:
        progress.end()
        page.write(options.output)
        print("report.sh: interrupted; the same command goes on from here", file=sys.stderr)
        return 130
    except programs.Failed as failure:
        progress.end()
        print(f"report.sh: {failure.reason}", file=sys.stderr)
        return 1
    progress.end()
    print(page.write(options.output))
    return 0


if __name__ == "__main__":
    sys.exit(main())
