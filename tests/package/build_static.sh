# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Builds the static library, unoptimised to be quick, for the tests that link it.
# build_static.sh CMAKE SOURCE_DIR WORK_DIR OPTION...
set -eu
cmake=$1 source=$2 work=$3
shift 3
rm -rf "$work"
"$cmake" -S "$source" -B "$work" -DBUILD_SHARED_LIBS=OFF -DCMAKE_BUILD_TYPE=Debug -DHGRID_BUILD_TESTS=OFF \
  -DHGRID_BUILD_APP=OFF -DHGRID_BUILD_BENCH=OFF -DHGRID_BUILD_PYTHON=OFF "$@"
"$cmake" --build "$work"
