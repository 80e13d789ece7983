#!/usr/bin/env bash
# Installs what is missing, builds, and passes every test. Its last line counts them.
#   scripts/test.sh [--sanitize address|undefined] [--quick]
#   --sanitize  builds with that sanitizer, in a folder of its own
#   --quick     leaves out the tests that are labelled slow
set -euo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

preset=default
selection=()
while (($#)); do
  case $1 in
    --sanitize)
      [[ ${2:-} == address || ${2:-} == undefined ]] || fail "--sanitize wants 'address' or 'undefined'."
      preset=$2
      shift ;;
    --quick) selection=(--label-exclude slow) ;;
    *) fail "test.sh knows --sanitize address|undefined and --quick, not '$1'." ;;
  esac
  shift
done

cd "$root"
install_packages
prepare_environment
tree=build/$preset
quietly cmake --preset "$preset" -DRITZ_WERROR=ON
build "$tree"

rm -f "$tree/ctest.xml"
status=0
ctest --test-dir "$tree" -j 2 --output-on-failure --no-tests=error --output-junit ctest.xml "${selection[@]}" || status=$?
[[ -s $tree/ctest.xml ]] && tally "$tree/ctest.xml"
exit "$status"
