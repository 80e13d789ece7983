#!/usr/bin/env bash
# Error against run time: installs what is missing, builds the programs, runs the scenes of scripts/report/scenes.py
# with the methods of scripts/report/methods.py, and writes report/: runs.csv, index.html and its pictures as PNG.
# Interrupted, it goes on from where it was; finished runs are not run again.
#   scripts/report.sh [--quick] [--output DIR]
#   --quick   fewer and smaller scenes, in under five minutes (the full form: under an hour on two cores)
#   --output  the folder of the report (default: report)
set -euo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

words=()
form=full
while (($#)); do
  case $1 in
    --quick)
      form=quick
      words+=(--quick) ;;
    --output)
      [[ -n ${2:-} ]] || fail "--output wants a folder."
      words+=(--output "$(realpath -m "$2")")
      shift ;;
    *) fail "report.sh knows --quick and --output DIR, not '$1'." ;;
  esac
  shift
done

build_programs ritz-reduce ritz-run ritz-full
if [[ $form == full ]]; then
  quietly cmake --preset runtime-only -DRITZ_TESTS=OFF
  build build/runtime-only
  quietly cmake --install build/runtime-only --prefix build/runtime-only/installed
  words+=(--runtime build/runtime-only/installed)
fi
PYTHONPATH=$root/scripts exec /usr/bin/python3 -m report "${words[@]}"
