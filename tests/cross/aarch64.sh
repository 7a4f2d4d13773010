#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Builds the library for 64-bit ARM, runs its tests under qemu-user, and compares its pairs with those of this machine,
# byte for byte. Needs a Debian 12 on x86-64. Arguments choose other tests, e.g. tests/cross/aarch64.sh -L unit.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

for needed in /usr/bin/aarch64-linux-gnu-g++ /usr/bin/qemu-aarch64 /usr/lib/aarch64-linux-gnu/libcmocka.so \
  /usr/lib/aarch64-linux-gnu/libgmpxx.so; do
  if [[ ! -e $needed ]]; then
    echo "$needed is missing. As root:" >&2
    echo "  dpkg --add-architecture arm64 && apt-get update" >&2
    echo "  apt-get install g++-aarch64-linux-gnu qemu-user libcmocka-dev:arm64 libgmp-dev:arm64" >&2
    exit 1
  fi
done

only_tests=(-G Ninja -DHGRID_BUILD_FORTRAN=OFF -DHGRID_BUILD_PYTHON=OFF -DHGRID_BUILD_APP=OFF -DHGRID_BUILD_BENCH=OFF
  -DHGRID_INSTALL=OFF)
cmake -S . -B build-aarch64 --toolchain cmake/toolchains/aarch64-linux-gnu.cmake "${only_tests[@]}"
cmake --build build-aarch64
if [[ $# == 0 ]]; then
  # Where emulation is slow and instruction sets make no difference, tests are left out.
  set -- -L "unit|api|abi|property" -E "paper_systems"
fi
ctest --test-dir build-aarch64 --output-on-failure --no-tests=error -j"$(nproc)" "$@"

cmake -S . -B build-host "${only_tests[@]}"
cmake --build build-host --target pair_hash
there=$(sh tests/cross/same_bytes.sh scalar neon -- qemu-aarch64 -L / build-aarch64/tests/cross/pair_hash)
here=$(sh tests/cross/same_bytes.sh scalar sse2 avx2 avx512 -- build-host/tests/cross/pair_hash)
diff -u <(echo "$here") <(echo "$there")
echo "$there"
echo "The same bytes on $(uname -m) and aarch64."
