# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Compares what the shared library exports, with version nodes, with the list in the tree.
# exported_symbols.sh NM LIBRARY LIST
set -eu
nm=$1 library=$2 list=$3
exported=$("$nm" -D --defined-only --with-symbol-versions "$library")
# The node itself stands in the table as an absolute symbol.
if ! printf '%s\n' "$exported" | awk '$2 != "A" { print $3 }' | LC_ALL=C sort | diff -u "$list" -; then
  echo "$library does not export what $list says (- missing, + not listed)"
  exit 1
fi
