#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Builds libhgrid.dll with mingw-w64 into build-windows/ and runs it under wine: the seeded scenes of pair_hash with each
# instruction set, whose pairs must be those in expected.txt byte for byte, and the plain C program many_particles with
# all threads. On Debian 12: apt-get install cmake ninja-build g++-mingw-w64-x86-64-posix wine64 libcmocka-dev
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
here=$PWD work=$PWD/build-windows target=x86_64-w64-mingw32
wine=$(command -v wine64 || echo /usr/lib/wine/wine64)
mkdir -p "$work/headers"
export WINEPREFIX=$work/wine WINEDEBUG=-all

only_library=(-DHGRID_BUILD_FORTRAN=OFF -DHGRID_BUILD_F77=OFF -DHGRID_BUILD_PYTHON=OFF -DHGRID_BUILD_APP=OFF
  -DHGRID_BUILD_BENCH=OFF -DHGRID_BUILD_TESTS=OFF -DHGRID_INSTALL=OFF)
cmake -S . -B "$work" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_SYSTEM_NAME=Windows -DCMAKE_SYSTEM_PROCESSOR=x86_64 \
  -DCMAKE_C_COMPILER=$target-gcc-posix -DCMAKE_CXX_COMPILER=$target-g++-posix "${only_library[@]}"
cmake --build "$work"

# Beside the library, where Windows looks for what programs need. Of cmocka the programs take declarations, no code.
programs=$work/bindings/c
for runtime in libstdc++-6.dll libgcc_s_seh-1.dll libwinpthread-1.dll; do
  cp "$($target-g++-posix -print-file-name=$runtime)" "$programs"
done
cp /usr/include/cmocka.h "$work/headers"
include=(-I. -Iinclude "-I$work/include" "-I$work/headers")
$target-g++-posix -std=c++17 -O2 -ffp-contract=off -Wno-format "${include[@]}" tests/cross/pair_hash.cpp \
  -o "$programs/pair_hash.exe" "-L$programs" -lhgrid
$target-gcc-posix -std=c99 -O2 "${include[@]}" tests/cross/many_particles.c -o "$programs/many_particles.exe" \
  "-L$programs" -lhgrid

status=0
for set in scalar sse2 avx2 avx512; do
  grep -qE "\\b${set}f?\\b" /proc/cpuinfo || [[ $set == scalar ]] || continue
  if HGRID_ISA=$set "$wine" "$programs/pair_hash.exe" | tr -d '\r' | diff -u "$here/tests/cross/expected.txt" -; then
    echo "pair_hash, $set: same"
  else
    status=1
  fi
done
"$wine" "$programs/many_particles.exe" || status=1
exit "$status"
