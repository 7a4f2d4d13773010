# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Runs a program under each instruction set and compares what it prints with a file.
# same_bytes.sh EXPECTED SET... -- PROGRAM [ARGUMENT...]
set -eu
expected=$1 sets=
shift
while [ "$1" != -- ]; do
  sets="$sets $1"
  shift
done
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for set in $sets; do
  if ! HGRID_ISA=$set "$@" >"$work/$set" 2>"$work/errors"; then
    if grep -q "this machine cannot run it" "$work/$set" "$work/errors"; then
      echo "$set: this machine cannot run it" >&2
      continue
    fi
    cat "$work/$set" "$work/errors" >&2
    exit 1
  fi
  if ! diff -u "$expected" "$work/$set" >&2; then
    echo "$set gives other pairs, or another order" >&2
    exit 1
  fi
done
