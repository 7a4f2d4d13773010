#!/bin/bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# hgrid_compare on small packings: compare.sh HGRID HGRID_COMPARE PYTHON BENCH_FOLDER PEER...
hgrid=$1
compare=$2
python=$3
bench=$4
shift 4
# shellcheck source=tests/support/checks.sh
. "$(dirname "${BASH_SOURCE[0]}")/../support/checks.sh"

# Every row found the pairs of `hgrid pairs`: the library in its accuracy, all others as doubles decide.
check_rows() {
  paste -d, <(field variant times.csv) <(field contestant times.csv) <(field pairs times.csv) \
    <(field verdict times.csv) <(field median_ns_per_particle times.csv) |
    awk -F, -v in_doubles="$(contacts "$1" --open --accuracy double)" \
      -v exact="$(contacts "$1" --open --accuracy exact)" '
      { expected = $2 == "library" && $1 !~ /double/ ? exact : in_doubles; if ($1 ~ /float/) expected = $3 }
      $3 != expected || $3 == 0 || $4 != "same pairs" || $5 <= 0 { bad = 1; print "bad row: " $0 }
      END { exit bad || NR < 4 }'
}

head_of_csv="sweep,system,size_ratio,particles,pairs,contestant,variant,isa,threads,chosen,levels,occupancy,\
predicted_cost,candidates_per_particle,skin,searches_per_step,runs,median_ns_per_particle,min_ns_per_particle,\
q1_ns_per_particle,q3_ns_per_particle,peak_bytes_per_particle,verdict,machine,processors,compiler,commit"

# Everything that this build has, on one small packing.
"$hgrid" pack --law uniform-volume --ratio 8 --count 3000 --sweeps 10 --output polydisperse.csv >/dev/null || fault "packing"
"$compare" polydisperse.csv --repeats 1 --csv times.csv >out.txt 2>&1 || fault "all contestants: $(cat out.txt)"
[ "$(head -n 1 times.csv)" = "$head_of_csv" ] || fault "head of the CSV: $(head -n 1 times.csv)"
check_rows polydisperse.csv || fault "all contestants: $(cat out.txt)"
for peer in library classical plain "$@"; do
  field contestant times.csv | grep -q "^$peer" || fault "$peer does not take part"
done
for variant in grid-exact grid-double grid-float id-exact id-double id-float; do
  [ "$(field variant times.csv | grep -cx "$variant")" -ge 2 ] || fault "$variant does not run with 1 and 2 threads"
done

for law in mono two-sizes uniform-size uniform-volume; do
  for dimension in 2 3; do
    "$hgrid" pack --law "$law" --count 3000 --dimension "$dimension" --sweeps 10 --output set.csv >/dev/null ||
      fault "packing $law"
    "$compare" set.csv --repeats 1 --csv times.csv --only 'classical/*' 'plain/*' 'library/grid*/best/1' \
      >out.txt 2>&1 || fault "$law in $dimension D: $(cat out.txt)"
    grep -q '^all searches find the pairs that they must find$' out.txt || fault "$law in $dimension D: $(cat out.txt)"
    check_rows set.csv || fault "$law in $dimension D: the counts differ from those of hgrid pairs: $(cat out.txt)"
  done
done

# Periodic boxes: all others get images; `--open` takes them away again. Uneven worlds, by name.
for options in "--dimension 3 --periodic xyz" "--dimension 3 --periodic y" "--dimension 2 --periodic xy"; do
  # shellcheck disable=SC2086
  "$hgrid" pack --ratio 4 --count 3000 --sweeps 10 $options --output box.csv >/dev/null || fault "packing $options"
  "$compare" box.csv --repeats 1 --csv world.csv --only 'library/grid-exact/best/1' '[!l]*' 'lammps-*' >out.txt 2>&1 ||
    fault "$options: $(cat out.txt)"
  [ "$(field pairs world.csv | sort -u)" = "$(contacts box.csv)" ] || fault "$options: $(cat out.txt)"
  [ "$(contacts box.csv)" -gt "$(contacts box.csv --open)" ] || fault "$options: no pair across the box"
  "$compare" box.csv --open --repeats 1 --csv world.csv --only 'plain/*' >out.txt 2>&1 || fault "--open: $(cat out.txt)"
  [ "$(field pairs world.csv)" = "$(contacts box.csv --open)" ] || fault "--open: $(cat out.txt)"
done
"$compare" mono:1:2000:film uniform-volume:3:1000:part-across --beside mono:1:900 --repeats 1 --csv world.csv \
  --only 'library/grid-exact/best/1' '[!l]*' >out.txt 2>&1 || fault "worlds by name: $(cat out.txt)"
[ "$(field system world.csv | uniq | tr '\n' ' ')" = "film-mono mono part-across-uniform-volume mono " ] ||
  fault "worlds by name: $(field system world.csv | uniq)"
[ "$(field verdict world.csv | sort -u)" = "same pairs" ] || fault "worlds by name: $(cat out.txt)"
# What a program cannot do is told with its reason, and is no fault of the pairs.
"$compare" mono:1:20000 --only 'classical/*' --memory 0.001 --csv world.csv >out.txt 2>&1 ||
  fault "out of memory: $(cat out.txt)"
[ "$(field verdict world.csv)" = "broke down: exit code 1: classical : std::bad_alloc" ] ||
  fault "out of memory: $(field verdict world.csv)"

# The sweeps, on systems made on the way, and what is drawn and written from them.
for sweep in size ratio levels threads skin; do
  "$compare" --sweep "$sweep" mono:1:600 uniform-volume:4:1000 --repeats 1 --csv "$sweep.csv" >out.txt 2>&1 ||
    fault "sweep $sweep: $(cat out.txt)"
  [ "$(field verdict "$sweep.csv" | sort -u)" = "same pairs" ] || fault "sweep $sweep: $(cat out.txt)"
  [ "$(field sweep "$sweep.csv" | sort -u)" = "$sweep" ] || fault "sweep $sweep is not named in its rows"
done
"$python" "$bench/plot/draw.py" --output pictures size.csv ratio.csv levels.csv threads.csv skin.csv >out.txt 2>&1 || fault "draw.py: $(cat out.txt)"
for picture in size ratio levels threads skin; do
  "$python" -c 'import sys, xml.dom.minidom; xml.dom.minidom.parse(sys.argv[1])' "pictures/$picture.svg" ||
    fault "$picture.svg is no XML"
done
"$python" "$bench/plot/table.py" times.csv >table.md 2>out.txt || fault "table.py: $(cat out.txt)"
grep -q '^| set, ' table.md || fault "table.py: $(cat table.md)"

# The table and the picture of worlds.
HGRID_WORLD_COUNT=4000 HGRID_WORLD_REPEATS=1 "$bench/worlds.sh" "$(dirname "$(dirname "$compare")")" worlds table \
  mono part-across far >out.txt 2>&1 || fault "worlds.sh: $(cat out.txt)"
[ "$(field world table/worlds.csv | tr '\n' ' ')" = "mono part-across far " ] || fault "worlds: $(cat table/worlds.csv)"
[ "$(field reference table/worlds.csv | tr '\n' ' ')" = " part-open mono " ] || fault "references: $(cat table/worlds.csv)"
awk -F, 'NR > 1 && !($5 > 0 && (NR == 2 || $8 > 0)) { exit 1 }' table/worlds.csv || fault "times: $(cat table/worlds.csv)"
"$bench/worlds.sh" "$(dirname "$(dirname "$compare")")" worlds table nowhere >out.txt 2>&1 && fault "a world that is none"
grep -q 'no world is called nowhere' out.txt || fault "the world is not named: $(cat out.txt)"
"$python" "$bench/plot/worlds.py" --output pictures table/worlds.csv >worlds.md 2>out.txt || fault "worlds.py: $(cat out.txt)"
grep -q '^| part across | 4' worlds.md || fault "worlds.py: $(cat worlds.md)"
"$python" -c 'import sys, xml.dom.minidom; xml.dom.minidom.parse(sys.argv[1])' pictures/worlds.svg || fault "worlds.svg is no XML"

"$compare" no/such.csv >out.txt 2>&1 && fault "a missing file is no failure"
grep -q 'no/such.csv' out.txt || fault "the missing file is not named: $(cat out.txt)"
"$compare" mono:1:x >out.txt 2>&1 && fault "a count that is no number is no failure"
grep -q "'x' is no number" out.txt || fault "the number is not named: $(cat out.txt)"
"$compare" polydisperse.csv --only 'nobody/*' >out.txt 2>&1 && fault "measuring nobody is no failure"
HGRID_ISA=none "$compare" polydisperse.csv --repeats 1 >out.txt 2>&1 && fault "an unknown instruction set is no failure"

finish "hgrid_compare agrees on all laws"
