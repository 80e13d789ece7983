#!/usr/bin/env bash
# Long fuzzing: builds the targets of tests/fuzz by Clang with libFuzzer and both sanitizers, and runs them one by one.
# Its last line says how many inputs ran; exit code 1 when there is a finding, which stays in build/fuzz/findings.
#   scripts/fuzz.sh [--seconds S] [TARGET ...]
#   --seconds  for each target (default: 1800)
#   TARGET     msh, scene, model, ... (default: all; tests/fuzz/README.md lists them)
set -euo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

seconds=1800
targets=()
while (($#)); do
  case $1 in
    --seconds)
      seconds=${2:-}
      [[ $seconds =~ ^[1-9][0-9]*$ ]] || fail "--seconds wants a whole number."
      shift ;;
    -*) fail "fuzz.sh knows --seconds S and names of targets, not '$1'." ;;
    *) targets+=("$1") ;;
  esac
  shift
done

cd "$root"
command -v clang++ >/dev/null || fail "Fuzzing needs Clang and its libFuzzer: apt-get install clang libclang-rt-14-dev."
install_packages
prepare_environment
tree=$root/build/fuzz
quietly cmake --preset fuzz
build "$tree" --target fuzz_targets
if ((${#targets[@]} == 0)); then
  for program in "$tree"/bin/fuzz_*; do
    [[ $program == */fuzz_seeds ]] || targets+=("${program##*/fuzz_}")
  done
fi
mkdir -p "$tree/findings"
"$tree/bin/fuzz_seeds" "$tree/seeds"

# libFuzzer looks for leaks after each input; at exit Open MPI's plugins are gone, and nobody can tell whose a leak was.
export LSAN_OPTIONS=suppressions=$root/tests/support/lsan.supp:print_suppressions=0:leak_check_at_exit=0
total=0 status=0
for target in "${targets[@]}"; do
  [[ -x $tree/bin/fuzz_$target ]] || fail "There is no target '$target'."
  seeds=("$tree/corpus/$target")
  mkdir -p "${seeds[0]}" "$tree/work"
  for folder in "tests/fuzz/corpus/$target" "$tree/seeds/$target"; do
    [[ -d $folder ]] && seeds+=("$(realpath "$folder")")
  done
  # PETSc is built without frame pointers: only the slow unwinder tells its leaks, which are known, from ours.
  unwinder=fast_unwind_on_malloc=1
  [[ $target =~ ^(opts|yaml)$ ]] && unwinder=fast_unwind_on_malloc=0
  # HDF5 asks malloc for what a damaged file says, and must take no for an answer; a `new` of that size is a finding.
  export ASAN_OPTIONS=detect_leaks=1:$unwinder:max_allocation_size_mb=1024:allocator_may_return_null=1
  log=$tree/findings/$target.log
  (cd "$tree/work" && "$tree/bin/fuzz_$target" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=2048 -malloc_limit_mb=16777216 \
    -max_len=65536 -dict="$root/tests/fuzz/dictionaries/$target.dict" -artifact_prefix="$tree/findings/$target-" \
    -print_final_stats=1 "${seeds[@]}") >"$log" 2>&1 || { status=1; say "$target: a finding, see $log"; }
  count=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log" | tail -1)
  say "$target: ${count:-0} inputs"
  total=$((total + ${count:-0}))
done
say "$total inputs of ${#targets[@]} targets, $([[ $status == 0 ]] && echo "no finding" || echo "findings in $tree/findings")"
exit "$status"
