# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Compares the binary interface with the one recorded in hgrid.abi. New functions pass, all else is reported. Where the
# report shows no more than a sized struct that grew at its end, or HGRID_SOVERSION was raised, record anew:
#   RECORD=1 sh tests/abi/abidiff.sh cc include build/include
# abidiff.sh CC SOURCE_INCLUDE_DIR BINARY_INCLUDE_DIR
set -eu
cc=$1 include=$(realpath "$2") generated=$(realpath "$3")
here=$(realpath "$(dirname "$0")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# A pointer to each function: what debug information says about these is the interface and no more.
{
  echo '#include <hgrid/hgrid.h>'
  sed 's/@@.*//; s/.*/__typeof__(\&&) abi_& = \&&;/' "$here/exported_symbols.txt"
} >"$work/interface.c"
cd "$work"
"$cc" -std=gnu11 -g -fPIC -shared -Wl,-z,lazy -I"$include" -I"$generated" -o interface.so interface.c

if [ -n "${RECORD:-}" ]; then
  abidw --no-show-locs --no-corpus-path --no-comp-dir-path --no-elf-needed --out-file "$here/hgrid.abi" interface.so
  exit
fi
status=0
abidiff --no-added-syms "$here/hgrid.abi" interface.so || status=$?
# 1 and 2: the comparison failed; 4: a change; 8: an incompatible one.
if [ "$status" -ne 0 ]; then
  echo "the interface is not the one of $here/hgrid.abi"
  exit 1
fi
