#!/bin/bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# hgrid accuracy --simulation as a user calls it, and the recorded points: simulation.sh HGRID PYTHON SOURCE.
set -euo pipefail
hgrid=$(realpath "$1") python=$2 source=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

"$hgrid" accuracy --simulation --quick --repeats 1 --knob state,rounding,skin --csv points.csv >report.txt 2>progress.txt
grep -q '^hgrid accuracy: rounding: float' progress.txt
grep -q '^Skin of the stored candidates' report.txt

"$python" - <<'END'
import csv

rows = list(csv.DictReader(open("points.csv", newline="")))
assert {row["knob"] for row in rows} == {"state", "rounding", "skin"}, rows
errors = {(row["knob"], row["setting"], row["error_of"]): float(row["error"]) for row in rows}
assert all(error == 0 for (knob, setting, _), error in errors.items() if knob == "skin" or setting == "double"), errors
assert 0 < errors["state", "float", "overlaps after one t_c"] < 0.01, errors
assert all(error > 0 for (knob, _, _), error in errors.items() if knob == "rounding"), errors
END

status=0
"$hgrid" accuracy --simulation --knob prefilter >out.txt 2>err.txt || status=$?
[[ $status == 2 ]] && grep -qF "'prefilter' is no knob" err.txt

# The recorded points hold what was derived: every law that has one agrees.
"$hgrid" accuracy --simulation --from "$source/programs/bench/results/amd-epyc/accuracy-simulation.csv" --markdown >laws.md
awk -F ' [|] ' '$1 == "| error of" && $3 == "derived" { laws = 1; next } !/^[|]/ { laws = 0 }
  laws && $3 ~ /n\^-/ { found = 1; if ($5 != "agrees") { print; bad = 1 } } END { exit bad || !found }' laws.md

