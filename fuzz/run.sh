#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Builds the fuzz targets with clang, address and undefined-behaviour sanitizers, into build-fuzz/, gives each so many
# seconds of processor time and prints a table. What is found lies in build-fuzz/findings/; the exit code says whether
# anything was. Run again it goes on from the corpus of the last time.
# fuzz/run.sh [SECONDS (60)] [TARGET... (grid csv lammps xyz data vtp vtk scene checkpoint)]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
seconds=${1:-60}
shift || true
targets=("$@")
((${#targets[@]} > 0)) || targets=(grid csv lammps xyz data vtp vtk scene checkpoint)
build=build-fuzz

for tool in clang clang++ cmake ninja; do
  command -v "$tool" >/dev/null || {
    echo "no $tool; on Debian: apt-get install clang libclang-rt-14-dev cmake ninja-build" >&2
    exit 1
  }
done
mkdir -p "$build"
{
  cmake -S . -B "$build" -G Ninja -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
    -DCMAKE_BUILD_TYPE=RelWithDebInfo -DHGRID_BUILD_FUZZERS=ON -DHGRID_SANITIZE=address,undefined \
    -DBUILD_SHARED_LIBS=OFF -DHGRID_THREADS=OFF -DHGRID_BUILD_TESTS=ON -DHGRID_BUILD_FORTRAN=OFF \
    -DHGRID_BUILD_PYTHON=OFF -DHGRID_BUILD_BENCH=OFF -DHGRID_INSTALL=OFF &&
    cmake --build "$build" --target "${targets[@]/#/fuzz_}"
} >"$build/build.log" 2>&1 || { cat "$build/build.log" >&2 && exit 1; }

# The last value of a statistic in a log of libFuzzer; 0 if a finding cut it short.
final() { sed -n "s/^stat::$1: *//p" "$2" | tail -n 1 | grep . || echo 0; }
# Seconds of processor time that all programs run here have taken, in `used`; `times` knows them in this shell only.
measure_used() {
  times >"$build/times"
  used=$(awk -F '[ms ]' 'NR == 2 { printf "%d", $1 * 60 + $2 + $4 * 60 + $5 }' "$build/times")
}
export UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1

total=0
printf '| %-10s | %7s | %11s | %9s | %8s | %8s | %8s |\n' target seconds executions 'per second' edges corpus findings
printf '|---|---|---|---|---|---|---|\n'
for target in "${targets[@]}"; do
  corpus=$build/corpus/$target findings=$build/findings/$target log=$build/$target.log
  mkdir -p "$corpus" "$findings"
  : >"$log"
  measure_used
  executions=0 begin=$used spent=0 sound=true
  # libFuzzer knows the clock only, which runs on while other programs have the processor: so in slices.
  while $sound && ((spent < seconds)); do
    slice=$((seconds - spent < 60 ? seconds - spent : 60))
    "$build/fuzz/fuzz_$target" -max_total_time="$slice" -timeout=120 -report_slow_units=120 -rss_limit_mb=2048 -max_len=1024 \
      -print_final_stats=1 -artifact_prefix="$findings/" "$corpus" "fuzz/corpus/$target" >"$log.slice" 2>&1 || sound=false
    cat "$log.slice" >>"$log"
    executions=$((executions + $(final number_of_executed_units "$log.slice")))
    measure_used
    spent=$((used - begin))
  done
  rm "$log.slice"
  found=$(find "$findings" -type f | wc -l)
  total=$((total + found))
  edges=$(sed -n 's/.* cov: \([0-9]*\).*/\1/p' "$log" | sort -n | tail -n 1)
  printf '| %-10s | %7s | %11s | %9s | %8s | %8s | %8s |\n' "$target" "$spent" "$executions" \
    $((executions / (spent > 0 ? spent : 1))) "${edges:-0}" "$(find "$corpus" -type f | wc -l)" "$found"
done
((total == 0)) || { echo "findings: $build/findings, logs: $build/*.log" >&2 && exit 1; }
