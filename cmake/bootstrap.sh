# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Sourced by ./demo and ./check from the root of the tree: gets what a bare Debian 12 lacks and builds into build/.
# shellcheck shell=bash

hgrid_build_dir=build

# What the library, the Fortran module, the command and the benchmarks need, and what the tests, Python and Lua add.
# shellcheck disable=SC2034  # the sourcing script uses the lists
hgrid_build_packages=(gcc g++ gfortran cmake ninja-build pkg-config libcli11-dev libeigen3-dev libgmp-dev
  libpugixml-dev libtomlplusplus-dev zlib1g-dev)
# shellcheck disable=SC2034  # the sourcing script uses the lists
hgrid_test_packages=(binutils libcmocka-dev liblua5.4-dev lua5.4 python3 python3-dev python3-numpy python3-yaml swig)
# What the layer for MPI needs (docs/guide/mpi.md), and a second MPI to test it with.
# shellcheck disable=SC2034  # as above
hgrid_mpi_packages=(libopenmpi-dev openmpi-bin libtrilinos-zoltan-dev libmpich-dev mpich
  python3-mpi4py)
# What hgrid_compare can compare the library with and hgrid_parts is made with (docs/evidence/benchmarks.md). Neither ./demo nor
# ./check asks for these.
# shellcheck disable=SC2034  # as above
hgrid_peer_packages=(libbenchmark-dev libboost-dev libbullet-dev libcgal-dev libembree-dev liblammps-dev libnanoflann-dev)

# Runs a command with its output in a log file; shows the log only if the command fails.
# hgrid_run_logged LOG COMMAND...
hgrid_run_logged() {
  local log=$1 status=0
  shift
  "$@" >"$log" 2>&1 </dev/null || status=$?
  if ((status != 0)); then
    cat "$log" >&2
    echo "failed (exit code $status): $*" >&2
  fi
  return "$status"
}

# Installs packages as root. Package lists that are absent or outdated make the first try fail.
# hgrid_apt_install PREFIX_COMMAND -- PACKAGE...
hgrid_apt_install() {
  local prefix=()
  while [[ $1 != -- ]]; do
    prefix+=("$1")
    shift
  done
  shift
  local apt=("${prefix[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=120)
  local install=("${apt[@]}" install -y --no-install-recommends "$@")
  local log=$hgrid_build_dir/packages.log
  "${install[@]}" >"$log" 2>&1 </dev/null && return
  echo "updating the package lists" >&2
  hgrid_run_logged "$log" "${apt[@]}" update && hgrid_run_logged "$log" "${install[@]}"
}

# Makes sure that the Debian packages are there, or says what to install and fails.
# hgrid_require_packages PACKAGE...
hgrid_require_packages() {
  if ! command -v dpkg-query >/dev/null; then
    echo "not a Debian system: please make sure that what these packages hold is installed: $*" >&2
    return
  fi
  local package missing=()
  for package in "$@"; do
    # A line for each architecture that the package is there for.
    dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed || missing+=("$package")
  done
  ((${#missing[@]} > 0)) || return 0
  local become_root=()
  if ((EUID != 0)); then
    if sudo -n true 2>/dev/null; then
      become_root=(sudo -n)
    elif [[ -t 0 ]] && command -v sudo >/dev/null; then
      sudo -v && become_root=(sudo)
    fi
    if ((${#become_root[@]} == 0)); then
      echo "these packages are missing, please install them as root:" >&2
      echo "  apt-get install --no-install-recommends ${missing[*]}" >&2
      return 1
    fi
  fi
  echo "installing Debian packages: ${missing[*]}" >&2
  mkdir -p "$hgrid_build_dir"
  hgrid_apt_install "${become_root[@]}" -- "${missing[@]}"
}

# Configures build/ unless that has been done. With --tests the tests, the modules for Python and Lua and the layer for
# MPI are part of it; a build that has them keeps them.
# hgrid_configure [--tests]
hgrid_configure() {
  local cache=$hgrid_build_dir/CMakeCache.txt whole=OFF
  if [[ ${1-} == --tests ]]; then
    whole=ON
  fi
  if [[ -f $hgrid_build_dir/build.ninja ]]; then
    if [[ $whole == OFF ]] ||
      { grep -q '^HGRID_BUILD_TESTS:[A-Z]*=ON' "$cache" && grep -q '^HGRID_BUILD_MPI:BOOL=ON' "$cache" &&
        grep -q '^HGRID_BUILD_LUA:[A-Z]*=ON' "$cache"; }; then
      return
    fi
  fi
  local options=(-DCMAKE_BUILD_TYPE=Release -DHGRID_BUILD_TESTS="$whole" -DHGRID_BUILD_PYTHON="$whole"
    -DHGRID_BUILD_LUA="$whole" -DHGRID_BUILD_MPI="$whole" -DHGRID_JOIN_SOURCES=ON)
  # The packages above are Debian's; a python3 that stands before Debian's on the path does not see them.
  if command -v dpkg-query >/dev/null; then
    options+=(-DPython3_EXECUTABLE=/usr/bin/python3)
  fi
  mkdir -p "$hgrid_build_dir"
  echo "configuring" >&2
  hgrid_run_logged "$hgrid_build_dir/configure.log" cmake -S . -B "$hgrid_build_dir" -G Ninja --no-warn-unused-cli \
    "${options[@]}"
}

# Reads the output of ninja, keeps it in a log and shows how far it is.
# hgrid_show_progress LOG
hgrid_show_progress() {
  local log=$1 line percent shown=-10
  : >"$log"
  while IFS= read -r line; do
    printf '%s\n' "$line" >>"$log"
    [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]] || continue
    percent=$((100 * BASH_REMATCH[1] / BASH_REMATCH[2]))
    if ((percent >= shown + 10)); then
      shown=$percent
      echo "building: $percent %" >&2
    fi
  done
}

# Builds into build/; no target means all.
# hgrid_build [--tests] [TARGET...]
hgrid_build() {
  local configure=() target=()
  if [[ ${1-} == --tests ]]; then
    configure=(--tests)
    shift
  fi
  (($# == 0)) || target=(--target "$@")
  hgrid_configure "${configure[@]}" || return
  local log=$hgrid_build_dir/build.log status
  set +o pipefail
  cmake --build "$hgrid_build_dir" "${target[@]}" 2>&1 </dev/null | hgrid_show_progress "$log"
  status=${PIPESTATUS[0]}
  set -o pipefail
  if ((status != 0)); then
    cat "$log" >&2
    echo "the build failed (exit code $status)" >&2
  fi
  return "$status"
}
