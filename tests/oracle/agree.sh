#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# The pairs of the command against those of the oracle, byte for byte, on files full of near ties.
# agree.sh HGRID ORACLE TOUCHING
set -euo pipefail
hgrid=$(realpath "$1") oracle=$(realpath "$2") touching=$(realpath "$3")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

"$touching" 1500 0 1 >equal.csv
"$touching" 1500 0 1e6 >ratio.csv
"$touching" 1500 1048576 10 >far.csv
"$touching" 1500 1e15 10 >coarse.csv
"$hgrid" pack --law uniform-volume --ratio 50 --count 2500 --output relaxed.csv >pack.log 2>&1
"$hgrid" pack --law two-sizes --ratio 4 --count 1500 --periodic xyz --output periodic.csv >pack.log 2>&1

status=0
for file in *.csv; do
  "$oracle" "$file" >expected
  for accuracy in exact double; do
    "$hgrid" pairs "$file" --order id --accuracy "$accuracy" --output found >pack.log 2>&1
    printf '%-13s %-6s pairs %6d, missing %d, extra %d\n' "$file" "$accuracy" "$(($(wc -l <found) - 1))" \
      "$(LC_ALL=C comm -23 <(LC_ALL=C sort expected) <(LC_ALL=C sort found) | wc -l)" \
      "$(LC_ALL=C comm -13 <(LC_ALL=C sort expected) <(LC_ALL=C sort found) | wc -l)"
    if [[ $accuracy == exact ]] && ! cmp -s expected found; then
      echo "$file: not the pairs of the oracle"
      status=1
    fi
  done
done
exit "$status"
