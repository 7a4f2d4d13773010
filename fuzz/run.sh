#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Builds the fuzz targets with clang, address and undefined-behaviour sanitizers, into build-fuzz/, runs each for so
# many seconds and prints a table. What is found lies in build-fuzz/findings/; the exit code says whether anything was.
# fuzz/run.sh [SECONDS (60)] [TARGET... (grid csv lammps xyz)]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
seconds=${1:-60}
shift || true
targets=("$@")
((${#targets[@]} > 0)) || targets=(grid csv lammps xyz)
build=build-fuzz

for tool in clang clang++ cmake; do
  command -v "$tool" >/dev/null || {
    echo "no $tool; on Debian: apt-get install clang libclang-rt-14-dev cmake ninja-build" >&2
    exit 1
  }
done
cmake -S . -B "$build" -G Ninja -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
  -DCMAKE_BUILD_TYPE=RelWithDebInfo -DHGRID_BUILD_FUZZERS=ON -DHGRID_SANITIZE=address,undefined \
  -DBUILD_SHARED_LIBS=OFF -DHGRID_OPENMP=OFF -DHGRID_BUILD_TESTS=ON -DHGRID_BUILD_FORTRAN=OFF \
  -DHGRID_BUILD_PYTHON=OFF -DHGRID_BUILD_BENCH=OFF -DHGRID_INSTALL=OFF >"$build.log" 2>&1 ||
  { cat "$build.log" >&2 && exit 1; }
mv "$build.log" "$build/configure.log"
cmake --build "$build" --target "${targets[@]/#/fuzz_}" >"$build/build.log" 2>&1 || { cat "$build/build.log" >&2 && exit 1; }

# The value of a statistic that libFuzzer prints at its end; 0 if a finding cut it short.
final() { sed -n "s/^stat::$1: *//p" "$2" | grep . || echo 0; }
export UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1

total=0
printf '| %-8s | %7s | %11s | %9s | %8s | %8s | %8s |\n' target seconds executions 'per second' edges corpus findings
printf '|---|---|---|---|---|---|---|\n'
for target in "${targets[@]}"; do
  corpus=$build/corpus/$target findings=$build/findings/$target log=$build/$target.log
  mkdir -p "$corpus" "$findings"
  "$build/fuzz/fuzz_$target" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=2048 -max_len=1024 \
    -print_final_stats=1 -artifact_prefix="$findings/" "$corpus" "fuzz/corpus/$target" >"$log" 2>&1 || true
  found=$(find "$findings" -type f | wc -l)
  total=$((total + found))
  edges=$(sed -n 's/.* cov: \([0-9]*\).*/\1/p' "$log" | tail -n 1)
  printf '| %-8s | %7s | %11s | %9s | %8s | %8s | %8s |\n' "$target" "$seconds" \
    "$(final number_of_executed_units "$log")" "$(final average_exec_per_sec "$log")" "${edges:-0}" \
    "$(find "$corpus" -type f | wc -l)" "$found"
done
((total == 0)) || { echo "findings: $build/findings, logs: $build/*.log" >&2 && exit 1; }
