# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# A Fortran program that meets a library of another version stops with both versions. The library is played by one call
# that is loaded before the true one.
# other_version.sh CC PROGRAM WORK_DIR LIBRARY_DIR
set -eu
mkdir -p "$3"
printf 'void hg_version(int *a, int *b, int *c) { *a = 77; *b = 5; *c = 0; }\n' >"$3/version.c"
"$1" -shared -fPIC "$3/version.c" -o "$3/libversion.so"
if LD_LIBRARY_PATH=$4 LD_PRELOAD=$3/libversion.so "$2" >"$3/printed" 2>&1; then
  echo "the program runs with a library of version 77.5"
  exit 1
fi
grep -qE 'module hgrid has version [0-9]+\.[0-9]+, the library that is loaded 77\.5' "$3/printed" || { cat "$3/printed" && exit 1; }
