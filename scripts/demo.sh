#!/usr/bin/env bash
# From a bare Debian 12 to pictures of a ringing tuning fork: installs what is missing, builds the three programs that
# it needs, computes the fork's modes on two ranks, strikes it, and draws what came out. Everything lands in out/fork.
set -euo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
(($# == 0)) || fail "demo.sh takes no arguments, and got '$*'."

cd "$root"
install_packages
prepare_environment
say "Building ritz-reduce, ritz-run and ritz-inspect."
quietly cmake --preset default
build build/default --target ritz-reduce ritz-run ritz-inspect
PATH=$root/build/default/bin:$PATH

out=out/fork
mkdir -p "$out"
mpirun -n 2 ritz-reduce -options_file config/fork.opts
ritz-inspect --check "$out/model.h5"
ritz-run "$out/model.h5" --scene config/fork.toml --output "$out/motion.h5" --every 8
/usr/bin/python3 scripts/plot_modes.py "$out/model.h5" "$out/frequencies.csv" "$out/modes.png"
/usr/bin/python3 scripts/plot_probes.py "$out/probes.csv" "$out/probes.png"

say
say "The model:            $out/model.h5 (for ParaView: $out/model.vtkhdf)"
say "Its frequencies:      $out/frequencies.csv"
say "The motion:           $out/motion.xdmf (for ParaView), $out/motion.h5"
say "The probes:           $out/probes.csv"
say "Pictures:             $out/modes.png, $out/probes.png"
