#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# The part of the suite that is worth its time under sanitizers: the interface, the core, hard cases and past findings
# of the fuzzers under the address and undefined-behaviour sanitizers, what uses threads under the thread sanitizer.
# The fuzzers of scenes and checkpoints are left to fuzz/run.sh: compiling the simulation for them takes minutes. What
# counts the work of large systems (hard_cases.bounded_work) would take half of the time.
# For everything: cmake --preset asan-ubsan, or tsan, then build and ctest with the same preset.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# build_and_run PRESET TARGET_PATTERN CTEST_OPTION...: builds the test programs whose names match, runs the tests.
build_and_run() {
  local preset=$1 pattern=$2 build=build-$1 targets
  shift 2
  echo "== $preset"
  cmake --preset "$preset" -DHGRID_BUILD_BENCH=OFF >"$build.log" 2>&1 || { cat "$build.log" >&2 && return 1; }
  mv "$build.log" "$build/configure.log"
  mapfile -t targets < <(ninja -C "$build" -t targets all | sed -n 's/: CXX_EXECUTABLE_LINKER.*//p;s/: C_EXECUTABLE_LINKER.*//p' |
    grep -E "$pattern")
  cmake --build "$build" --target "${targets[@]}" >"$build/build.log" 2>&1 || { cat "$build/build.log" >&2 && return 1; }
  ctest --preset "$preset" -j"$(nproc)" "$@"
}

build_and_run asan-ubsan '^(tests/(unit|api|hard_cases)/|fuzz/fuzz_replay_(grid|csv|lammps|xyz|data|vtp|vtk)$)' \
  -L 'unit|api|hard_cases|fuzz' -E '^(fuzz\.(scene|checkpoint)|hard_cases\.bounded_work)$'
# The preset lets a forked child start threads, which the tool refuses by itself; races are reported all the same.
build_and_run tsan '/(test_build|test_last_error|hard_cases.processes|unit_parallel)$' \
  -R '^(test_build|test_last_error|hard_cases.processes|unit.parallel)$'
