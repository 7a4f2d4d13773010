#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# The static library of each compiler, into build-compilers/: its golden hashes, the scenes of pair_hash, and programs in
# C that link it as pkg-config says, compiled by the same compiler and by the other one, with and without -fopenmp of
# their own (many_particles.c). Prints a table.
# tests/cross/compilers.sh [COMPILER...]   e.g. gcc-11 clang-16; those of the list that are there if none is given
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
work=$PWD/build-compilers
here=$PWD/tests/cross

names=("$@")
(($# > 0)) || names=(gcc-11 gcc-12 clang-14 clang-16)

cxx_of() { sed 's/gcc/g++/; s/clang/clang++/' <<<"$1"; }
other_than() { if [[ $1 == gcc* ]]; then echo clang; else echo gcc; fi; }

# build NAME
build() {
  cmake -S . -B "$work/$1" -G Ninja -DCMAKE_C_COMPILER="$1" -DCMAKE_CXX_COMPILER="$(cxx_of "$1")" \
    -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=OFF -DHGRID_BUILD_FORTRAN=OFF -DHGRID_BUILD_F77=OFF \
    -DHGRID_BUILD_PYTHON=OFF -DHGRID_BUILD_APP=OFF -DHGRID_BUILD_TESTS=ON -DCMAKE_INSTALL_LIBDIR=lib -DHGRID_WERROR=ON &&
    cmake --build "$work/$1" --target hgrid golden pair_hash &&
    cmake --install "$work/$1" --prefix "$work/$1/prefix"
}

# consumer NAME COMPILER FLAG...: a program of that compiler on the library of NAME.
consumer() {
  local prefix=$work/$1/prefix compiler=$2 program=$work/$1/many_particles
  shift 2
  # shellcheck disable=SC2046  # a list of words
  "$compiler" -O1 "$@" "$here/many_particles.c" \
    $(PKG_CONFIG_PATH=$prefix/lib/pkgconfig pkg-config --cflags --libs hgrid) -o "$program" && "$program"
}

# result COMMAND...: ok or FAILED; what it prints goes to the log.
result() { if "$@" >>"$log" 2>&1; then printf ' ok |'; else printf ' FAILED |' && failed=1; fi; }

failed=0
mkdir -p "$work"
echo "| compiler | builds | golden | pair_hash | consumer | with -fopenmp | other compiler | with -fopenmp |"
echo "|---|---|---|---|---|---|---|---|"
for name in "${names[@]}"; do
  if ! command -v "$(cxx_of "$name")" >/dev/null; then
    echo "| $name | is not here |"
    continue
  fi
  log=$work/$name.log
  : >"$log"
  printf '| %s |' "$name"
  result build "$name"
  result "$work/$name/tests/golden/golden" tests/golden/hashes.txt
  result diff "$here/expected.txt" <("$work/$name/tests/cross/pair_hash")
  result consumer "$name" "$name"
  result consumer "$name" "$name" -fopenmp
  result consumer "$name" "$(other_than "$name")"
  result consumer "$name" "$(other_than "$name")" -fopenmp
  echo
done
exit "$failed"
