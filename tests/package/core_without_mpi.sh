# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Of the installed libraries and modules those for MPI need MPI, and no other one does.
# core_without_mpi.sh LIBRARY_DIR [PYTHON_PACKAGE_DIR]
set -eu
for library in "$1"/libhgrid*.so ${2:+"$2"/_*.so}; do
  needed=$(ldd "$library")
  case $library in
  */libhgrid_mpi* | */_mpi_capi*) expected=1 ;;
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
