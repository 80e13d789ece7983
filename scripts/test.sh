#!/usr/bin/env bash
# Installs what is missing, builds, and passes every test. Its last line counts them.
#   scripts/test.sh [--preset NAME] [--quick] [-DNAME=VALUE ...]
#   --preset  another build of CMakePresets.json, in a folder of its own: address (the sanitizers), runtime-only
#   --quick   leaves out what takes long, and ranks other than 2: the tests with the label "thorough"
#   -D...     is for cmake
set -euo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

preset=default
selection=() targets=()
definitions=()
while (($#)); do
  case $1 in
    --preset)
      preset=${2:-}
      [[ $preset =~ ^(default|address|runtime-only)$ ]] || fail "--preset wants default, address or runtime-only."
      shift ;;
    --quick) selection=(--label-exclude thorough) targets=(--target quick) ;;
    -D*) definitions+=("$1") ;;
    *) fail "test.sh knows --preset NAME, --quick and -DNAME=VALUE, not '$1'." ;;
  esac
  shift
done

cd "$root"
install_packages
prepare_environment
tree=build/$preset
quietly cmake --preset "$preset" "${definitions[@]}"
build "$tree" "${targets[@]}"

rm -f "$tree/ctest.xml"
status=0
ctest --test-dir "$tree" -j 2 --output-on-failure --no-tests=error --output-junit ctest.xml "${selection[@]}" || status=$?
[[ -s $tree/ctest.xml ]] && tally "$tree/ctest.xml"
exit "$status"
