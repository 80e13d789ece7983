# shellcheck shell=bash
# What the scripts share; to be sourced. Sets `root` to the top folder of the project.
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '%s\n' "$*"; }

fail() {
  printf '%s\n' "$*" >&2
  exit 2
}

# Installs those packages of scripts/packages.txt that are missing, as root or with sudo.
install_packages() {
  command -v apt-get >/dev/null || fail "There is no apt-get here; install what scripts/packages.txt names by your own means, then use cmake --preset default."
  local wanted missing=() become=() package
  mapfile -t wanted <"$root/scripts/packages.txt"
  for package in "${wanted[@]}"; do
    [[ $(dpkg-query -W -f '${Status}' "$package" 2>/dev/null) == "install ok installed" ]] || missing+=("$package")
  done
  ((${#missing[@]})) || return 0
  if ((EUID != 0)); then
    command -v sudo >/dev/null || fail "These packages are missing, and installing them needs root or sudo: ${missing[*]}"
    become=(sudo)
  fi
  say "Installing ${#missing[@]} Debian packages."
  quietly "${become[@]}" apt-get update -qq
  quietly "${become[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends --no-remove "${missing[@]}"
}

# Runs a command and shows what it said only when it failed.
quietly() {
  local log
  log=$(mktemp)
  if ! "$@" >"$log" 2>&1; then
    cat "$log" >&2
    rm -f "$log"
    fail "This command failed, as it says above: $*"
  fi
  rm -f "$log"
}

# cmake --build with ninja's progress line on a terminal; elsewhere a line for each fifth, and errors. As many compilers
# as cores, which nproc does not count where OMP_NUM_THREADS is set: ninja's two more share the caches, a fifth slower.
build() {
  local words=("$@" --parallel "$(env -u OMP_NUM_THREADS nproc)")
  if [[ -t 1 ]]; then
    cmake --build "${words[@]}"
  else
    NINJA_STATUS='%p ' cmake --build "${words[@]}" | awk '
      /^ *[0-9]+% / { fifth = int($1 / 20); if (fifth > said) { said = fifth; print "  built " 20 * fifth " %"; fflush() }; next }
      !/^ninja: no work to do/ { print; fflush() }'
  fi
}

# One BLAS thread a rank, and an Open MPI that runs as root, in a container and on fewer cores than ranks.
# What the caller has set himself stays.
prepare_environment() {
  export OPENBLAS_NUM_THREADS=${OPENBLAS_NUM_THREADS:-1}
  export OMP_NUM_THREADS=${OMP_NUM_THREADS:-1}
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  export OMPI_MCA_hwloc_base_binding_policy=${OMPI_MCA_hwloc_base_binding_policy:-none}
  export OMPI_MCA_rmaps_base_oversubscribe=${OMPI_MCA_rmaps_base_oversubscribe:-1}
  export OMPI_MCA_btl_vader_single_copy_mechanism=${OMPI_MCA_btl_vader_single_copy_mechanism:-none}
}

# Installs, configures and builds the programs that are named.
build_programs() {
  cd "$root"
  install_packages
  prepare_environment
  say "Building $*, which takes some minutes from nothing."
  quietly cmake --preset default
  build build/default --target "$@"
}

# "N passed, N failed, N skipped" over ctest's JUnit reports.
tally() {
  /usr/bin/python3 - "$@" <<'PYTHON'
import sys
import xml.etree.ElementTree as xml

suites = [xml.parse(path).getroot() for path in sys.argv[1:]]
count = lambda name: sum(int(suite.get(name, 0)) for suite in suites)
failed, skipped = count("failures"), count("skipped") + count("disabled")
print(f"{count('tests') - failed - skipped} passed, {failed} failed, {skipped} skipped")
PYTHON
}
