#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Line coverage of src and bindings/c by the tests of the C interface and the core, every instruction set of this
# machine included; of the random tests, slow without optimisation, only those of steps in time and of single spheres.
# Prints one line per file and the lines that no test reaches; fails below 95 %.
# Needs gcovr (on Debian: apt-get install gcovr).
# tests/coverage.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=build-coverage

command -v gcovr >/dev/null || { echo "no gcovr; on Debian: apt-get install gcovr" >&2 && exit 1; }
mkdir -p "$build"
{
  cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_C_FLAGS="-O1 --coverage" \
    -DCMAKE_CXX_FLAGS="-O1 --coverage -fprofile-update=atomic" -DHGRID_BUILD_FORTRAN=OFF \
    -DHGRID_BUILD_PYTHON=OFF -DHGRID_BUILD_APP=OFF -DHGRID_BUILD_BENCH=OFF -DHGRID_INSTALL=OFF &&
    cmake --build "$build"
} >"$build/build.log" 2>&1 || { cat "$build/build.log" >&2 && exit 1; }
find "$build" -name '*.gcda' -delete
{
  ctest --test-dir "$build" -L 'unit|api|closed_form|hard_cases|golden' -j"$(nproc)" &&
    ctest --test-dir "$build" -R '^test_(skin|queries_agree$)' -j"$(nproc)"
} >"$build/ctest.log" 2>&1 || { cat "$build/ctest.log" >&2 && exit 1; }
gcovr --root . --object-directory "$build" --filter 'src/' --filter 'bindings/c/' --exclude-throw-branches \
  --print-summary --fail-under-line 95 --txt -
