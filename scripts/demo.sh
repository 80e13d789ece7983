#!/usr/bin/env bash
# From a bare Debian 12 to pictures: installs what is missing and builds the programs. Computes a tuning fork's modes on
# two ranks, strikes it, and draws what came out (out/fork); plucks a bar and measures how its end moves (out/bar). Then
# bends (out/rubber) and twists (out/twist) a rubber cantilever far beyond what modes alone can follow, reduced beside full.
# Last it bends and twists a rubber strap whose law is no polynomial, reduced by a cubature of some of its cells (out/strap).
set -euo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
(($# == 0)) || fail "demo.sh takes no arguments, and got '$*'."

build_programs ritz-reduce ritz-run ritz-full ritz-inspect
PATH=$root/build/default/bin:$PATH

out=out/fork
say "1 of 5: a tuning fork, whose modes are computed on 2 ranks and which is then struck"
mkdir -p "$out"
mpirun -n 2 ritz-reduce -options_file config/fork.opts
ritz-inspect --check "$out/model.h5"
ritz-run "$out/model.h5" --scene config/fork.toml --output "$out/motion.h5" --every 8
/usr/bin/python3 scripts/plot_modes.py "$out/model.h5" "$out/modes.png"
/usr/bin/python3 scripts/plot_probes.py "$out/probes.csv" "$out/probes.png"

say
say "2 of 5: a steel bar, whose end is pulled and let go"
mkdir -p out/bar
mpirun -n 2 ritz-reduce -options_file config/bar.opts
ritz-run out/bar/model.h5 --scene config/bar.toml --output out/bar/motion.h5 --every 25
/usr/bin/python3 scripts/plot_modes.py out/bar/model.h5 out/bar/modes.png
/usr/bin/python3 scripts/plot_probes.py out/bar/probes.csv out/bar/probes.png

# reduced_beside_full NAME OPTIONS SCENE TITLE [--twist]
reduced_beside_full() {
  local to=out/$1 options=$2 scene=$3 title=$4
  shift 4
  say
  say "$title"
  mkdir -p "$to/full"
  mpirun -n 2 ritz-reduce -options_file "$options"
  ritz-run "$to/model.h5" --scene "$scene" --output "$to/motion.h5" --every 1
  mpirun -n 2 ritz-full -options_file "$options" -scene "$scene" -output "$to/full/full.h5" -every 1
  /usr/bin/python3 scripts/plot_rubber.py "$to/model.h5" "$to/motion.h5" "$to/full/full.h5" "$to/motion.png" \
    --title "${title#*: }" "$@"
}
reduced_beside_full rubber config/rubber.opts config/rubber_pull.toml \
  "3 of 5: A rubber cantilever, 300 x 40 x 30 mm, pulled and let go: 2400 degrees of freedom beside 20"
reduced_beside_full twist config/rubber_twist.opts config/rubber_twist.toml \
  "4 of 5: A rubber cantilever, 300 x 45 x 30 mm, twisted and let go: 2400 degrees of freedom beside 5" --twist

title="A strap of neo-Hookean rubber, 160 x 50 x 16 mm, bent and twisted: 7602 degrees of freedom beside 40"
say "5 of 5: $title"
mkdir -p out/strap/full
mpirun -n 2 ritz-reduce -options_file config/strap.opts
ritz-run out/strap/model.h5 --scene config/strap.toml --output out/strap/motion.h5 --every 1
mpirun -n 2 ritz-full -options_file config/strap.opts -scene config/strap.toml -output out/strap/full/full.h5 -every 1
/usr/bin/python3 scripts/plot_cubature.py out/strap/model.h5 out/strap/motion.h5 out/strap/full/full.h5 \
  out/strap/bent.png --title "$title"

say
say "The model:            $out/model.h5 (for ParaView: $out/model.hdf)"
say "Its frequencies:      $out/frequencies.csv"
say "The motion:           $out/motion.xdmf (for ParaView), $out/motion.h5"
say "The probes:           $out/probes.csv"
say "A plucked bar:        out/bar/model.h5, out/bar/motion.xdmf, out/bar/probes.csv"
say "Rubber, bent:         out/rubber/model.h5, out/rubber/motion.xdmf, out/rubber/full/full.xdmf"
say "Rubber, twisted:      out/twist/model.h5, out/twist/motion.xdmf, out/twist/full/full.xdmf"
say "A strap by cubature:  out/strap/model.h5, out/strap/motion.xdmf, out/strap/full/full.xdmf"
say "Pictures:             $out/modes.png, $out/probes.png, out/bar/modes.png, out/bar/probes.png,"
say "                      out/rubber/motion.png, out/twist/motion.png, out/strap/bent.png"
