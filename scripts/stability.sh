#!/usr/bin/env bash
# The stability report: installs what is missing, builds the programs, runs every row at its full length, and prints the
# table; report/stability.html and report/stability.csv hold it. Arguments go to stability.py:
#   scripts/stability.sh [--rows NAME ...] [--length short|full]
set -euo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

build_programs ritz-reduce ritz-run ritz-full ritz-inspect
exec /usr/bin/python3 scripts/stability.py --out report "$@"
