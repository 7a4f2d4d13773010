# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# All that a Fortran library exports bears the name of a module of ours and a version; and it knows no folder of the
# build.
# fortran_symbols.sh NM LIBRARY NODE BUILD_DIR SOURCE_DIR
set -eu
nm=$1 library=$2 node=$3 build=$4 source=$5
exported=$("$nm" -D --defined-only --with-symbol-versions "$library" | awk '$2 != "A" { print $3 }')
count=$(printf '%s\n' "$exported" | wc -l)
if printf '%s\n' "$exported" | grep -vE "^__hgrid[a-z_0-9]*_MOD_.*@@$node\$"; then
  echo "$library exports these beside those of its modules under $node"
  exit 1
fi
if [ "$count" -lt 3 ]; then
  echo "$library exports $count symbols"
  exit 1
fi
# Neither does its code; debug information and the path for libraries of a build are another matter.
objcopy --dump-section .rodata="$build/rodata.bin" "$library" "$build/rodata.copy"
if grep -aqF -e "$build" -e "$source" "$build/rodata.bin"; then
  echo "$library holds the name of a folder of the build:"
  strings "$build/rodata.bin" | grep -F -e "$build" -e "$source"
  exit 1
fi
rm "$build/rodata.bin" "$build/rodata.copy"
