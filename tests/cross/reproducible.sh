#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# The committed tree built in two folders gives the same bytes: the installed files of the library, shared and static,
# its Fortran modules and its headers. tests/cross/reproducible.sh, about three minutes on two cores.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
options=(-DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr -DHGRID_BUILD_PYTHON=OFF -DHGRID_BUILD_APP=OFF
  -DHGRID_BUILD_TESTS=OFF -DHGRID_BUILD_DOCS=OFF)

# build_in FOLDER: leaves what it installs in FOLDER/shared and FOLDER/static.
build_in() {
  mkdir -p "$1/tree"
  git archive HEAD | tar -x -C "$1/tree"
  for kind in shared static; do
    [[ $kind == shared ]] && shared=ON || shared=OFF
    cmake -S "$1/tree" -B "$1/build-$kind" -G Ninja "${options[@]}" -DBUILD_SHARED_LIBS="$shared"
    cmake --build "$1/build-$kind"
    DESTDIR=$1/$kind cmake --install "$1/build-$kind"
  done >"$1/build.log" 2>&1 || { cat "$1/build.log" >&2 && return 1; }
}

# sums FOLDER: of every installed file, in the order of their names.
sums() { (cd "$1" && find shared static -type f -print0 | sort -z | xargs -0 sha256sum); }

build_in "$work/one"
sleep 2 # bytes that hold the time would differ
build_in "$work/another/place"
sums "$work/one" >"$work/sums"
diff "$work/sums" <(sums "$work/another/place") || { echo "these files differ" >&2 && exit 1; }
echo "$(wc -l <"$work/sums") files, the same bytes"
