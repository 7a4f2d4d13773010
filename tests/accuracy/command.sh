#!/bin/bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# hgrid accuracy as a user calls it: command.sh HGRID PYTHON.
set -euo pipefail
hgrid=$(realpath "$1") python=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

"$hgrid" accuracy --quick --repeats 1 --csv points.csv --svg picture.svg --markdown >report.md 2>progress.txt
grep -q '^hgrid accuracy: skin: ' progress.txt
grep -q '^### What ten times more accuracy costs' report.md

"$python" - <<'END'
import csv
import xml.etree.ElementTree as xml

rows = list(csv.DictReader(open("points.csv", newline="")))
assert {row["knob"] for row in rows} == {"accuracy", "skin", "optimiser", "levels", "prefilter"}, rows
for row in rows:
    assert float(row["error"]) >= 0 and row["is_default"] in "01" and None not in row.values(), row
exact = [row for row in rows if row["setting"] == "HG_EXACT"]
assert len(exact) >= 4 and all(float(row["error"]) == 0 for row in exact), exact
double = [row for row in rows if row["setting"] == "HG_DOUBLE"]
assert any(float(row["error"]) > 0 for row in double), "the truth finds nothing wrong with doubles"
skins = [row for row in rows if row["setting"].startswith("skin ")]
assert len(skins) >= 6 and all(float(row["error"]) == 0 for row in skins), skins
kept = [row for row in rows if row["setting"] == "every 20 steps"]
assert all(float(row["error"]) > 0 for row in kept), kept
boxes = [row for row in rows if row["knob"] == "prefilter"]
assert all(float(row["error"]) == 0 for row in boxes), boxes
assert xml.parse("picture.svg").getroot().tag.endswith("svg")
widths = {line.count("|") - 1 for line in open("report.md") if line.startswith("|")}
assert widths == {5, 6, 8}, widths  # one kind of error, two, and the table of what ten times more accuracy costs
END

# The points of a file are told as they were when measured.
"$hgrid" accuracy --from points.csv --csv again.csv --svg again.svg --markdown >again.md 2>err.txt
cmp points.csv again.csv
cmp picture.svg again.svg
cmp report.md again.md
[[ ! -s err.txt ]]

status=0
"$hgrid" accuracy --knob nonsense >out.txt 2>err.txt || status=$?
[[ $status == 2 ]] && grep -qF "'nonsense' is no knob" err.txt
status=0
printf 'knob,system,setting,number,error_of,error,ns,is_default,note\na,b,c,0,d,often,1,0,\n' >wrong.csv
"$hgrid" accuracy --from wrong.csv >out.txt 2>err.txt || status=$?
[[ $status == 1 ]] && grep -qF "wrong.csv:2: 'often' in column 'error' is not a number" err.txt
"$hgrid" accuracy --quick --repeats 1 --knob prefilter --csv one.csv >out.txt 2>err.txt
[[ $(cut -d, -f1 one.csv | sort -u | tr '\n' ' ') == "knob prefilter " ]]
