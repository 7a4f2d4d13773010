#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Builds the library and the golden scenes with each compiler and optimisation level into build-golden/ and prints
# whether all hashes, for each instruction set that the machine runs and 1 to 8 threads, are those in the tree.
# tests/golden/matrix.sh [NAME...]   NAME: one of the rows, e.g. gcc-O2; all if none is given
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
hashes=$PWD/tests/golden/hashes.txt
work=build-golden
mkdir -p "$work"

# Name, C compiler, C++ compiler, build type, flags.
rows=(
  "gcc-Debug gcc g++ Debug -g"
  "gcc-O1 gcc g++ None -O1"
  "gcc-O2 gcc g++ None -O2"
  "gcc-Release gcc g++ Release -O3"
  "gcc-native gcc g++ Release -O3 -march=native"
  "clang-Debug clang clang++ Debug -g"
  "clang-O1 clang clang++ None -O1"
  "clang-O2 clang clang++ None -O2"
  "clang-Release clang clang++ Release -O3"
  "clang-native clang clang++ Release -O3 -march=native"
)

isas=()
for isa in scalar sse2 avx2 avx512; do
  case $isa in
    avx2) grep -qw avx2 /proc/cpuinfo || continue ;;
    avx512) grep -qw avx512dq /proc/cpuinfo || continue ;;
  esac
  isas+=("$isa")
done

status=0
printf '| %-13s | %-32s |' build flags
printf ' %-9s |' "${isas[@]}" "libm base"
printf '\n|---|---|%s---|\n' "$(printf -- '---|%.0s' "${isas[@]}")"
for row in "${rows[@]}"; do
  read -r name cc cxx type flags <<<"$row"
  [[ $# == 0 || " $* " == *" $name "* ]] || continue
  build=$work/$name
  {
    cmake -S . -B "$build" -G Ninja -DCMAKE_C_COMPILER="$cc" -DCMAKE_CXX_COMPILER="$cxx" -DCMAKE_BUILD_TYPE="$type" \
      -DCMAKE_C_FLAGS="$flags" -DCMAKE_CXX_FLAGS="$flags" -DHGRID_BUILD_FORTRAN=OFF -DHGRID_BUILD_PYTHON=OFF \
      -DHGRID_BUILD_APP=OFF -DHGRID_BUILD_BENCH=OFF -DHGRID_INSTALL=OFF &&
      cmake --build "$build" --target golden
  } >"$build.log" 2>&1 || { cat "$build.log" >&2 && exit 1; }
  printf '| %-13s | %-32s |' "$name" "$flags"
  for isa in "${isas[@]}" base; do
    # The last column: the default instruction set, but libm as on a machine without fused multiply-add.
    if [[ $isa == base ]]; then
      run=(env GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4 "$build/tests/golden/golden")
    else
      run=(env HGRID_ISA="$isa" "$build/tests/golden/golden")
    fi
    if "${run[@]}" "$hashes" >>"$build.log" 2>&1; then result=same; else result=DIFFERENT status=1; fi
    printf ' %-9s |' "$result"
  done
  printf '\n'
done
exit "$status"
