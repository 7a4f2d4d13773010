#!/bin/bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# hgrid_compare on small packings: compare.sh HGRID HGRID_COMPARE.
set -u
hgrid=$1
compare=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
failures=0

fault() {
  echo "FAILED: $*" >&2
  failures=$((failures + 1))
}

# contacts FILE ACCURACY: what hgrid pairs finds without the box.
contacts() { "$hgrid" pairs "$1" --open --accuracy "$2" --count | awk '$1 == "contacts" && NF == 2 { print $2 }'; }

# Lines 2 and 3 of the table are the plain searches in doubles, 4 to 6 the library in exact arithmetic. Names hold
# commas, so columns count from the end.
check_counts() {
  awk -F, -v in_doubles="$(contacts set.csv double)" -v exact="$(contacts set.csv exact)" '
    NR > 1 && ($NF != (NR < 4 ? in_doubles : exact) || $NF == 0 || $(NF - 2) <= 0) { bad = 1 }
    END { exit bad || NR != 6 }' times.csv
}

for law in mono two-sizes uniform-size uniform-volume; do
  for dimension in 2 3; do
    "$hgrid" pack --law "$law" --count 3000 --dimension "$dimension" --sweeps 10 --output set.csv >/dev/null ||
      fault "packing $law"
    "$compare" set.csv --repeats 2 --csv times.csv >out.txt 2>&1 || fault "$law in $dimension D: $(cat out.txt)"
    grep -q '^all searches find the same pairs' out.txt || fault "$law in $dimension D: $(cat out.txt)"
    check_counts || fault "$law in $dimension D: the counts differ from those of hgrid pairs: $(cat times.csv)"
  done
done

"$compare" no/such.csv >out.txt 2>&1 && fault "a missing file is no failure"
grep -q 'no/such.csv' out.txt || fault "the missing file is not named: $(cat out.txt)"

[ "$failures" = 0 ] || exit 1
echo "hgrid_compare agrees on all laws"
