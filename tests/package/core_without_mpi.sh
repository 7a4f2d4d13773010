# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Of the installed libraries that for MPI needs MPI, and no other one does.
# core_without_mpi.sh LIBRARY_DIR
set -eu
for library in "$1"/libhgrid*.so; do
  needed=$(ldd "$library")
  case $library in
  */libhgrid_mpi*) expected=1 ;;
  *) expected=0 ;;
  esac
  found=0
  if printf '%s\n' "$needed" | grep -qE 'libmpi|libmpich|zoltan'; then found=1; fi
  if [ "$found" -ne "$expected" ]; then
    echo "$library: needs MPI: $found, expected: $expected"
    printf '%s\n' "$needed"
    exit 1
  fi
done
