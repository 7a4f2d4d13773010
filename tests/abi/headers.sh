# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Compiles every public header alone and twice in a row, in each language standard that users may choose.
# headers.sh CC CXX SOURCE_INCLUDE_DIR BINARY_INCLUDE_DIR
set -eu
cc=$1 cxx=$2 include=$3 generated=$4
flags="-pedantic-errors -Wall -Wextra -Wshadow -Wconversion -Werror -fsyntax-only"
status=0

# compile_alone HEADER LANGUAGE STANDARD COMPILER EXTRA_FLAGS
compile_alone() {
  # A header of macros alone would leave a translation unit empty, which C forbids.
  # shellcheck disable=SC2086  # flags are lists of words
  if ! printf '#include <hgrid/%s>\n#include <hgrid/%s>\nextern int declared;\n' "$1" "$1" |
    "$4" -x "$2" -std="$3" $flags $5 -I"$include" -I"$generated" -; then
    echo "hgrid/$1 does not compile alone as $3"
    status=1
  fi
}

for path in "$include"/hgrid/*.h "$generated"/hgrid/*.h; do
  header=$(basename "$path")
  for standard in c99 c11 c17; do
    compile_alone "$header" c "$standard" "$cc" "-Wstrict-prototypes -Wmissing-prototypes"
  done
  for standard in c++11 c++17; do
    compile_alone "$header" c++ "$standard" "$cxx" "-Wold-style-cast"
  done
done
for path in "$include"/hgrid/*.hpp; do
  for standard in c++17 c++20; do
    compile_alone "$(basename "$path")" c++ "$standard" "$cxx" "-Wold-style-cast"
  done
done
exit "$status"
