#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Builds the library for other processors with Debian's cross compilers, into build-PROCESSOR/, and runs it under
# qemu-user: the golden hashes, the seeded scenes of pair_hash, whose pairs must be those in expected.txt byte for byte,
# random lives against the oracle, and unit tests of the exact arithmetic. Needs a Debian 12 on x86-64, no root; says
# which packages are missing. The libraries of the tests come from Debian's archive and stay in build-PROCESSOR/.
# tests/cross/processors.sh [PROCESSOR...]   e.g. armhf i386; all that have a compiler if none is given
# LIVES: how many (200). TARGETS: other programs of the tests to build and run, e.g. TARGETS="test_tilted_pairs".
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

# Debian's name, triplet, CMake's name of the processor, qemu, instruction sets, flags. Bytes of s390x are big-endian.
rows=(
  "i386 i686-linux-gnu i686 qemu-i386 scalar"
  "armhf arm-linux-gnueabihf armv7l qemu-arm scalar"
  "arm64 aarch64-linux-gnu aarch64 qemu-aarch64 scalar,neon"
  "riscv64 riscv64-linux-gnu riscv64 qemu-riscv64 scalar"
  "s390x s390x-linux-gnu s390x qemu-s390x scalar"
  "ppc64el powerpc64le-linux-gnu ppc64le qemu-ppc64le scalar"
)
libraries=(libgmp-dev libgmp10 libgmpxx4ldbl libcmocka-dev libcmocka0)
programs=(golden pair_hash hgrid_lives unit_wide unit_exact_sign unit_overlap)
read -ra more <<<"${TARGETS-}"
programs+=("${more[@]}")
only_tests=(-G Ninja -DCMAKE_BUILD_TYPE=Release -DHGRID_BUILD_FORTRAN=OFF -DHGRID_BUILD_F77=OFF -DHGRID_BUILD_PYTHON=OFF
  -DHGRID_BUILD_APP=OFF -DHGRID_BUILD_BENCH=OFF -DHGRID_BUILD_TESTS=ON -DHGRID_INSTALL=OFF)

# Packages of another architecture, unpacked into a folder; the package system of this machine is not touched.
# fetch_libraries ARCHITECTURE FOLDER
fetch_libraries() {
  local root=$2.apt suite=bookworm
  local wanted=("${libraries[@]}")
  # Debian 13 is the first that has it; its libraries need its C library.
  [[ $1 != riscv64 ]] || { suite=trixie && wanted+=(libc6 libgcc-s1 libstdc++6); }
  [[ ! -e $2 ]] || return 0
  mkdir -p "$root"/{lists/partial,archives/partial}
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/debian $suite main" >"$root/sources"
  : >"$root/status"
  local apt=(apt-get -q -o APT::Architecture="$1" -o APT::Architectures="$1" -o Dir::State="$root"
    -o Dir::State::status="$root/status" -o Dir::Cache="$root" -o Dir::Etc::sourcelist="$root/sources"
    -o Dir::Etc::sourceparts=/dev/null)
  "${apt[@]}" update
  (cd "$root" && "${apt[@]}" download "${wanted[@]}")
  mkdir "$2"
  for package in "$root"/*.deb; do dpkg -x "$package" "$2"; done
  [[ -e $2/lib ]] || ln -s usr/lib "$2/lib"
}

# Where the programs of a processor find their C library.
# system_of ARCHITECTURE TRIPLET
system_of() { if [[ $1 == riscv64 ]]; then echo "$PWD/build-$1/libraries"; else echo "/usr/$2"; fi; }

# build_for ARCHITECTURE TRIPLET PROCESSOR QEMU: into build-ARCHITECTURE.
build_for() {
  local work=$PWD/build-$1
  local files=$work/libraries
  mkdir -p "$work"
  fetch_libraries "$1" "$files"
  PKG_CONFIG_LIBDIR=$files/usr/lib/${2/i686/i386}/pkgconfig PKG_CONFIG_SYSROOT_DIR=$files cmake -S . -B "$work" "${only_tests[@]}" \
    -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR="$3" -DCMAKE_C_COMPILER="$2-gcc" -DCMAKE_CXX_COMPILER="$2-g++" \
    -DCMAKE_CXX_FLAGS="-isystem $files/usr/include/${2/i686/i386}" -DCMAKE_CROSSCOMPILING_EMULATOR="$4;-L;$(system_of "$1" "$2")" -DCMAKE_EXE_LINKER_FLAGS=-Wl,--allow-shlib-undefined -DCMAKE_FIND_ROOT_PATH="/usr/$2;$files" \
    -DCMAKE_FIND_ROOT_PATH_MODE_PROGRAM=NEVER -DCMAKE_FIND_ROOT_PATH_MODE_LIBRARY=ONLY
  cmake --build "$work" --target "${programs[@]}" -- -k 0
}

# Programs of a build, which it is asked where they are.
# program_of BUILD NAME
program_of() { find "$1" -type f -name "$2" -perm -u+x | head -1; }

# run_for ARCHITECTURE TRIPLET SETS COMMAND...: every program; the scenes must be those of the file `expected`.
run_for() {
  local work=$PWD/build-$1 library set program failed=0
  library=$work/libraries/usr/lib/${2/i686/i386}
  local run=("${@:4}" -E "LD_LIBRARY_PATH=$library")
  for set in ${3//,/ }; do
    HGRID_ISA=$set "${run[@]}" "$(program_of "$work" pair_hash)" | diff -u "$expected" - && echo "pair_hash, $set: same" || failed=1
    HGRID_ISA=$set "${run[@]}" "$(program_of "$work" golden)" tests/golden/hashes.txt || failed=1
    HGRID_ISA=$set "${run[@]}" "$(program_of "$work" hgrid_lives)" "${LIVES:-200}" || failed=1
  done
  for program in "${programs[@]:3}"; do
    "${run[@]}" "$(program_of "$work" "$program")" >"$work/$program.log" 2>&1 && echo "$program: passed" ||
      { tail -20 "$work/$program.log" && failed=1; }
  done
  return "$failed"
}

expected=$PWD/tests/cross/expected.txt
status=0 summary=()
for row in "${rows[@]}"; do
  read -r name triplet processor qemu sets <<<"$row"
  [[ $# == 0 || " $* " == *" $name "* ]] || continue
  if ! command -v "$triplet-g++" >/dev/null || ! command -v "$qemu" >/dev/null; then
    summary+=("$name: left out, needs g++-$triplet and qemu-user")
    (($# == 0)) || status=1
    continue
  fi
  echo "== $name"
  mkdir -p "build-$name"
  if (set -e; build_for "$name" "$triplet" "$processor" "$qemu") >"build-$name/build.log" 2>&1; then
    if run_for "$name" "$triplet" "$sets" "$qemu" -L "$(system_of "$name" "$triplet")"; then
      summary+=("$name: same")
    else
      summary+=("$name: DIFFERENT") status=1
    fi
  else
    tail -30 "build-$name/build.log" >&2
    summary+=("$name: does not build, see build-$name/build.log") status=1
  fi
done
printf '%s\n' "${summary[@]}"
exit "$status"
