#!/bin/bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# hgrid pack, slice, bench and calibrate as a user calls them: commands.sh HGRID.
hgrid=$1
# shellcheck source=tests/support/checks.sh
. "$(dirname "${BASH_SOURCE[0]}")/../support/checks.sh"

works() { "$hgrid" "$@" >out.txt 2>err.txt || fault "$*: exit code $?: $(cat err.txt)"; }

small=(pack --count 3000 --ratio 10 --seed 5 --sweeps 20)
works "${small[@]}" --output one.csv
reported=$(awk '/ contacts, / { print $1 }' out.txt)
works "${small[@]}" --output again.csv
cmp -s one.csv again.csv || fault "the same seed gave other bytes"
works pack --count 3000 --ratio 10 --seed 6 --sweeps 20 --output other.csv
cmp -s one.csv other.csv && fault "another seed gave the same bytes"

# What was reported, what the file holds, and what the other formats hold.
[ "$(contacts one.csv)" = "$reported" ] || fault "pack reported $reported contacts, pairs found $(contacts one.csv)"
for name in one.lammpstrj one.dump one.xyz one.extxyz; do
  works "${small[@]}" --output "$name"
  [ "$(contacts "$name")" = "$reported" ] || fault "$name has $(contacts "$name") contacts, not $reported"
done
works "${small[@]}" --output one.vtp
grep -q 'NumberOfPoints="3000"' one.vtp || fault "one.vtp: $(head -c 300 one.vtp)"
"$hgrid" "${small[@]}" --output - --format csv 2>err.txt | cmp -s - one.csv || fault "standard output is not the file"

works pack --law two-sizes --count 2000 --dimension 2 --periodic xy --output disks.csv
works pack --law mono --count 500 --random-offset --output mono.csv
works pack --law uniform-size --count 500 --ratio 3 --density 0.4 --periodic z --offset 0.9 --output size.csv

works pack --law power-law --exponent 4 --count 500 --ratio 5 --sweeps 5 --output power.csv
works pack --law log-normal --sigma 0.5 --count 500 --sweeps 5 --output normal.csv
works pack --law one-giant --count 500 --ratio 5 --sweeps 5 --output giant.csv

# Curves: what is reported is what the file holds, in its unit, or scaled; grains too few for the coarse end are told.
works pack --law fuller --ratio 8 --radius 0.5 --count 2000 --sweeps 5 --output fuller.csv
in_file=$(awk -F, 'NR > 2 && $4 > 0.5 && $4 <= 1 { ++n } END { print n }' fuller.csv)
[ "$(awk '$1 == 0.5 && $2 == 1 { print $3 }' out.txt)" = "$in_file" ] || fault "not $in_file grains: $(cat out.txt)"
grep -q "^left out: 35.4 % of the curve's mass, finer" out.txt || fault "fuller: $(cat out.txt)"
works pack --law rosin-rammler --uniformity 1.2 --d63 5 --count 500 --sweeps 5 --output rosin.csv
works pack --law log-normal-mass --median 4 --sigma 0.6 --count 500 --dimension 2 --sweeps 5 --output normal.csv
printf 'diameter,passing\n0.25,8\n1,30\n4,53\n16,100\n' >sieves.csv
works pack --law table --sizes sieves.csv --count 200 --density 0.1 --sweeps 5 --output table.csv
grep -q "missing: .* without a particle" out.txt || fault "table: $(cat out.txt)"
works pack --law table --sizes sieves.csv --from 1 --count 1000 --method event --density 0.4 --output table.csv
awk -F, 'NR > 2 && !($4 >= 0.5 && $4 < 8) { bad = 1 } END { exit bad }' table.csv || fault "sizes of table.csv"
"$hgrid" pack --law table --sizes sieves.csv --from 1 --count 1000 --sweeps 5 --output - --format csv >x.csv 2>err.txt
grep -q "^left out: 30 %" err.txt || fault "table to standard output: $(cat err.txt)"
rm x.csv
printf 'diameter,passing\n1,0\n2,30\n4,97\n' >short.csv
fails 1 "short.csv:4: the last share in column 'passing' is 97" pack --law table --sizes short.csv --output x.csv
fails 1 "needs a file of sizes" pack --law table --output x.csv
fails 1 "below the largest, 16, not from 16" pack --law table --sizes sieves.csv --from 16 --output x.csv
fails 2 "--sizes: is for table, not for the law fuller" pack --law fuller --sizes sieves.csv --output x.csv
fails 2 "--radius" pack --law mono --radius 0 --output x.csv

# Uneven worlds: what is reported is what the file holds, and the options that they do not take.
for arrangement in $("$hgrid" pack --help | grep -oE '\{even,[a-z,-]*\}' | tr -d '{}' | tr , ' '); do
  options=(--law two-sizes --ratio 3 --count 2000 --arrangement "$arrangement")
  works pack "${options[@]}" --output "$arrangement.csv"
  told=$(awk '/ contacts, / { print $1 }' out.txt)
  [ "$(contacts "$arrangement.csv")" = "$told" ] || fault "$arrangement: pack reported $told contacts"
  grep -q "two-sizes, $arrangement, 2000 spheres" out.txt || fault "$arrangement: $(cat out.txt)"
  works pack "${options[@]}" --output again.csv
  cmp -s "$arrangement.csv" again.csv || fault "$arrangement: the same seed gave other bytes"
  ((worlds = ${worlds:-0} + 1))
done
[ "${worlds:-0}" -ge 15 ] || fault "only ${worlds:-0} arrangements found in the help"
grep -q '^# box: .* periodic 1 1 1$' part-across.csv || fault "part-across has no periodic box"
grep -q '^# box' film.csv && fault "film has a box"
works pack --arrangement film --density 0.3 --law mono --count 500 --dimension 2 --output film.csv
fails 2 "--density: is for arrangements that fill something, not for dust" pack --arrangement dust --density 0.3 --output x.csv
fails 2 "--sweeps: is for the arrangement even, not for jet" pack --arrangement jet --sweeps 3 --output x.csv
fails 2 "--periodic: is for the arrangement even, not for part" pack --arrangement part --periodic xyz --output x.csv
fails 2 "--arrangement: is for --method relax" pack --arrangement gas --method event --output x.csv
fails 1 "the density lies between 0 and 1, not at 1.5" pack --arrangement shell --density 1.5 --output x.csv
fails 2 "--exponent: is for power-law, not for the law mono" pack --law mono --exponent 4 --output x.csv
fails 2 "--sigma: is for log-normal, log-normal-mass, not for the law uniform-volume" pack --sigma 1 --output x.csv
fails 2 "log-normal-mass, not for the law log-normal" pack --law log-normal --ratio 4 --output x.csv
fails 1 "2 to 9, not 12" pack --law power-law --exponent 12 --output x.csv
fails 2 "heap" pack --arrangement heap --output x.csv
# Grown packings: no overlap, whatever the axes; the same seed, the same bytes.
grown=(pack --method event --law two-sizes --ratio 3 --count 1500 --density 0.55 --seed 5)
works "${grown[@]}" --output grown.csv
grep -q "^0 overlaps" out.txt || fault "a grown packing: $(cat out.txt)"
[ "$(contacts grown.csv)" = 0 ] || fault "a grown packing has $(contacts grown.csv) contacts"
works "${grown[@]}" --output grown2.csv
cmp -s grown.csv grown2.csv || fault "the same seed grew other bytes"
works pack --method event --law uniform-volume --ratio 4 --count 800 --dimension 2 --density 0.7 --periodic xy --output grown.csv
[ "$(contacts grown.csv)" = 0 ] || fault "grown disks have $(contacts grown.csv) contacts"
fails 2 "--sweeps" pack --method event --sweeps 3 --output x.csv
fails 2 "--growth-rate" pack --growth-rate 0.1 --output x.csv
fails 1 "rate of -1" pack --method event --growth-rate -1 --output x.csv

# Ctrl-C amid a growth too slow to end by itself: its state, smaller than asked for, without overlaps.
"$hgrid" pack --method event --law mono --count 300 --growth-rate 1e-9 --output stopped.csv >out.txt 2>err.txt &
growing=$!
# Ready once it is no more this shell's twin and catches signal 2.
until [ "$(cat "/proc/$growing/comm" 2>/dev/null)" = hgrid ] &&
  grep -q "^SigCgt:.*[2367abef]$" "/proc/$growing/status" 2>/dev/null; do
  kill -0 $growing || break
done
kill -INT $growing
wait $growing
[ $? = 1 ] || fault "a stopped growth ended with exit code 0"
grep -q "stopped at density .*stopped.csv holds its state" err.txt || fault "a stopped growth says: $(cat err.txt)"
[ "$(contacts stopped.csv)" = 0 ] || fault "a stopped growth left $(contacts stopped.csv) contacts"
awk -F, 'NR > 2 && !($4 > 0 && $4 < 1) { bad = 1 } END { exit bad || NR != 302 }' stopped.csv || fault "stopped.csv"

# A failing run leaves the file that was there and nothing else.
cp one.csv kept.csv
fails 1 "density" pack --density 1.2 --output kept.csv
cmp -s one.csv kept.csv || fault "a failed pack changed its output"
fails 1 "no/such" pack --count 10 --law mono --output no/such/place.csv
mkdir folder.csv
fails 1 "folder.csv" pack --count 10 --law mono --output folder.csv
compgen -G '*.partial*' >/dev/null && fault "a partial file is left: $(ls)"
fails 1 "not 0.5" pack --ratio 0.5 --output x.csv
fails 1 "more than 10 particles" pack --law two-sizes --count 10 --output x.csv
fails 2 "normal" pack --law normal --output x.csv
fails 2 "--ratio: is 1 for the law mono, not 3" pack --law mono --ratio 3 --output x.csv
fails 2 "no ending" pack --output x.unknown
fails 2 "'xx'" pack --periodic xx --output x.csv
fails 2 "'z'" pack --periodic z --dimension 2 --output x.csv
fails 2 "--output" pack
[ -e x.csv ] && fault "a refused pack left a file"

is_xml() { python3 -c 'import sys, xml.dom.minidom; xml.dom.minidom.parse(sys.argv[1])' "$1" || fault "$1 is no XML"; }
works slice one.csv --output z.svg
is_xml z.svg
works slice one.csv --axis x --at 0.25 --levels paper --output x.svg
is_xml x.svg
cmp -s x.svg z.svg && fault "two planes give the same picture"
works slice disks.csv --output disks.svg
is_xml disks.svg
fails 1 "cuts no particle" slice one.csv --at 0 --output none.svg
fails 2 "--at" slice one.csv --at 1.5 --output none.svg

works bench one.csv --repeats 2 --most-levels 3 --csv bench.csv
[ "$(head -n 1 bench.csv)" = "rule,levels,median_ns_per_particle,fastest_ns_per_particle,runs,paper_cost,fitted_cost,candidates_per_particle,pairs" ] ||
  fault "head of the CSV: $(head -n 1 bench.csv)"
awk -F, -v pairs="$reported" 'NR > 1 && ($3 <= 0 || $8 < $9 / 3000 || $9 != pairs) { bad = 1 } NR > 1 { ++rows }
  END { exit bad || rows != 4 }' bench.csv || fault "rows of the CSV: $(cat bench.csv)"
fails 1 "no/such.csv" bench no/such.csv

# Whether times of so little work give prices depends on what else the machine does; it must say so if they do not.
if "$hgrid" calibrate one.csv other.csv --repeats 2 --most-levels 3 >out.txt 2>err.txt; then
  grep -q '^prices, in hg_grid_def: level_price = ' out.txt || fault "no prices: $(cat out.txt)"
else
  grep -q 'the tests took no measurable time' err.txt || fault "calibrate: $(cat err.txt)"
fi
fails 1 "no/such.csv" calibrate no/such.csv
printf 'x,y,z,r\n' >empty.csv
fails 1 "no particles" bench empty.csv
fails 1 "no particles" calibrate empty.csv

finish "pack, slice, bench and calibrate do what they say"
