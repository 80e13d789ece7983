#!/usr/bin/env bash
# Installs what is missing, builds, and passes every test. Its last line counts them.
#   scripts/test.sh [--sanitized] [--quick]
#   --sanitized  builds with the address and the undefined behaviour sanitizer, in a folder of its own
#   --quick      leaves out the tests that are labelled slow
set -euo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

preset=default
selection=()
while (($#)); do
  case $1 in
    --sanitized) preset=sanitized ;;
    --quick) selection=(--label-exclude slow) ;;
    *) fail "test.sh knows --sanitized and --quick, not '$1'." ;;
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
