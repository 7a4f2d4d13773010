#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Builds the library and the Octave module alone, and runs the tests of that and the blocks of its page. Octave is a
# large package, which ./check does not install; on Debian: apt-get install octave-dev
# tests/octave/run.sh [BUILD_DIR]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
build=${1:-build-octave}
cmake -S . -B "$build" -DCMAKE_BUILD_TYPE=Release -DHGRID_BUILD_OCTAVE=ON -DHGRID_BUILD_TESTS=ON -DHGRID_BUILD_APP=OFF \
  -DHGRID_BUILD_BENCH=OFF -DHGRID_BUILD_FORTRAN=OFF -DHGRID_BUILD_F77=OFF -DHGRID_BUILD_PYTHON=OFF
cmake --build "$build" --target hgrid hgrid_octave -j"$(nproc)"
ctest --test-dir "$build" --output-on-failure --no-tests=error -R '^octave\.|^package\.guide_octave$'
