# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Compiles hgrid/mpi.h alone and twice in a row, in each language standard that users may choose, with each MPI there is.
# header.sh SOURCE_DIR BINARY_INCLUDE_DIR COMPILER...    COMPILER: a wrapper for C, then its one for C++, and so on
set -eu
source=$1 generated=$2
shift 2
flags="-pedantic-errors -Wall -Wextra -Wshadow -Werror -fsyntax-only"

# compile LANGUAGE STANDARD COMPILER
compile() {
  # shellcheck disable=SC2086  # flags are lists of words
  printf '#include <hgrid/mpi.h>\n#include <hgrid/mpi.h>\nextern int declared;\n' |
    "$3" -x "$1" -std="$2" $flags -DOMPI_SKIP_MPICXX -DMPICH_SKIP_MPICXX -I"$source/mpi/include" -I"$source/include" \
      -I"$generated" -
}

while [ $# -ge 2 ]; do
  for standard in c99 c11 c17; do compile c "$standard" "$1"; done
  for standard in c++11 c++17 c++20; do compile c++ "$standard" "$2"; done
  shift 2
done
