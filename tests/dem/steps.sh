#!/bin/bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# hgrid_dem on small scenes: steps.sh HGRID HGRID_DEM PYTHON BENCH_FOLDER PEER...
hgrid=$1
dem=$2
python=$3
bench=$4
shift 4
# shellcheck source=tests/support/checks.sh
. "$(dirname "${BASH_SOURCE[0]}")/../support/checks.sh"

# scene FILE LAW RATIO COUNT [MORE]: a small packing and its scene.
scene() {
  "$hgrid" pack --law "$2" --ratio "$3" --count "$4" --sweeps 20 --output "$1.csv" >/dev/null || fault "packing $1"
  printf '[[particles]]\nfile = "%s.csv"\noverlap = 0.01\n[contact]\nstiffness = 1e5\n[time]\nsteps = 1\n%s\n' \
    "$1" "${5:-}" >"$1.toml"
}
for count in 400 800; do
  scene mono-1-$count mono 1 $count
  scene uniform-volume-5-$count uniform-volume 5 $count
done
short=(--collisions 0.2 --settle-steps 200 --steps 20 --repeats 2 --skins 0.1)

# All programs move the particles alike and keep the energy.
"$dem" mono-1-800.toml uniform-volume-5-800.toml "${short[@]}" --csv steps.csv >out.txt 2>&1 || fault "$(cat out.txt)"
[ "$(grep -c '^all move the particles alike$' out.txt)" = 2 ] || fault "not alike: $(cat out.txt)"
programs="library c-loop plain"
case " $* " in *" lammps "*) programs="$programs lammps-bin lammps-multi" ;; esac
for program in $programs; do
  field contestant steps.csv | grep -qx "$program" || fault "$program does not take part"
done
paste -d, <(field verdict steps.csv) <(field energy_change steps.csv) <(field contacts_per_particle steps.csv) \
  <(field steps_per_second steps.csv) <(field chosen steps.csv) |
  awk -F, '$5 == 1 && ($1 != "same motion" || $2 > 1e-3 || $2 < -1e-3 || $3 <= 0 || $4 <= 0) { bad = 1; print }
    END { exit bad || NR < 4 }' >rows.txt || fault "rows: $(cat rows.txt)"

# The settled state is kept, and nothing else is taken for one.
"$dem" uniform-volume-5-800.toml "${short[@]}" --keep-state --settle-only >out.txt 2>&1 || fault "$(cat out.txt)"
state=uniform-volume-5-800.state
[ "$(stat -c %s $state)" = $((16 + 6 * 8 * 800)) ] || fault "the settled state has $(stat -c %s $state) bytes"
cp $state whole && head -c 1000 whole >$state
"$dem" uniform-volume-5-800.toml "${short[@]}" --keep-state >out.txt 2>&1 && fault "half a state is no failure"
grep -q "$state: not the settled state of 800 particles" out.txt || fault "half a state: $(cat out.txt)"
mv whole $state

# The sweeps and what is drawn from them.
"$dem" uniform-volume-5-800.toml "${short[@]}" --keep-state --sweep levels --levels 1,2,3,4 --csv levels.csv \
  >out.txt 2>&1 || fault "levels: $(cat out.txt)"
[ "$(field levels levels.csv | tr "\n" " ")" = "1 1 1 2 2 2 3 3 3 4 4 4 " ] || fault "levels: $(field levels levels.csv)"
"$dem" {mono-1,uniform-volume-5}-{400,800}.toml "${short[@]}" --sweep size --csv size.csv >out.txt 2>&1 ||
  fault "size: $(cat out.txt)"
"$python" "$bench/plot/figures.py" --output pictures levels.csv size.csv >out.txt 2>&1 || fault "figures.py: $(cat out.txt)"
for picture in figure4 figure5; do
  "$python" -c 'import sys, xml.dom.minidom; xml.dom.minidom.parse(sys.argv[1])' "pictures/$picture.svg" ||
    fault "$picture.svg is no XML"
done

scene sticky mono 1 400 '[drag]
viscosity = 1'
"$dem" sticky.toml "${short[@]}" >out.txt 2>&1 && fault "a scene with drag is no failure"
grep -q 'elastic spheres between walls' out.txt || fault "drag: $(cat out.txt)"

finish "all programs move the particles alike"
