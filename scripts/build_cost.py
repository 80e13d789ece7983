#!/usr/bin/env python3
"""Measures what builds from nothing and the legs of the tests cost, as the table of docs/building.md.

    build_cost.py [--tests] [--address] [--work FOLDER]

Processor seconds of all compilers, linkers and tests, user and system together, which other load on the machine changes
little. Builds in FOLDER (default: build/cost), which it removes before and leaves behind, and without a compiler cache.
  --tests     runs all tests as well, as scripts/test.sh does
  --address   measures the leg of the sanitizers as well: scripts/test.sh --preset address --quick
"""
import argparse
import os
import resource
import shutil
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PROGRAMS = ["ritz-reduce", "ritz-full", "ritz-run", "ritz-inspect"]


def processor_seconds(*command):
    """What the command and all its children use; its output is this program's."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([str(word) for word in command], check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def configured(preset, folder):
    shutil.rmtree(folder, ignore_errors=True)
    subprocess.run(["cmake", "--preset", preset, "-B", folder, "-DRITZ_WERROR=ON", "-DCCACHE=OFF"], check=True, cwd=ROOT)
    return folder


def build(folder, *targets):
    chosen = ["--target", *targets] if targets else []
    return processor_seconds("cmake", "--build", folder, "--parallel", os.cpu_count(), *chosen)


def tests(folder, *selection):
    return processor_seconds("ctest", "--test-dir", folder, "-j", "2", "--output-on-failure", *selection)


def measure(arguments):
    """Pairs of what was done and its processor seconds."""
    folder = configured("default", arguments.work / "default")
    programs = build(folder, *PROGRAMS)
    yield "the programs", programs
    yield "everything, the programs included", programs + build(folder)
    if arguments.tests:
        yield "all tests", tests(folder)
    if arguments.address:
        folder = configured("address", arguments.work / "address")
        yield "what the quick tests need, under the sanitizers", build(folder, "quick")
        yield "the quick tests, under the sanitizers", tests(folder, "--label-exclude", "thorough")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tests", action="store_true")
    parser.add_argument("--address", action="store_true")
    parser.add_argument("--work", type=Path, default=ROOT / "build" / "cost")
    rows = list(measure(parser.parse_args()))
    print("\n| | CPU s |\n| --- | --- |")
    for what, seconds in rows:
        print(f"| {what} | {seconds:.0f} |")


if __name__ == "__main__":
    main()
