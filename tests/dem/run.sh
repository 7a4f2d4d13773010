#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# The command run from end to end: run.sh HGRID PYTHON SCENES. Scenes run a few steps, what they write is read back by
# readers that are not ours, and a run that is stopped and restarted ends with the same bytes.
set -euo pipefail
hgrid=$1 python=$2 scenes=$3
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

fail() {
  echo "run.sh: $*" >&2
  exit 1
}

# The large systems of the paper are only listed: making them takes seconds each.
"$hgrid" scenes >list.txt
for scene in "$scenes"/*.toml; do
  grep -qF "$(basename "$scene")" list.txt || fail "hgrid scenes does not list $scene"
  case $scene in
    */paper-*) continue ;;
  esac
  "$hgrid" run "$scene" --steps 20 --quiet --strict --overwrite --output out >summary.txt || fail "$scene does not run"
  grep -q 'ns per particle and step' summary.txt || fail "$scene: no summary"
done

cat >busy.toml <<'TOML'
dimension = 3
[[particles]]
pack = { law = "uniform-size", ratio = 3, count = 400, fraction = 0.5 }
temperature = 1
[contact]
stiffness = 1e4
[dissipation]
restitution = 0.8
[friction]
coefficient = 0.3
[periodic]
axes = "xy"
[gravity]
acceleration = [0, 0, -1]
[time]
steps = 300
[output]
every = 0.1
formats = ["vtp", "xyz", "csv", "lammps"]
checkpoint = 0.1
work = true
bulk = true
contacts = true
TOML
"$hgrid" run busy.toml --quiet --output whole >/dev/null
"$python" "$here/read_back.py" whole || fail "the pictures do not read back"
last=$(basename "$(ls whole/state-*.xyz | tail -1)" .xyz)
for format in xyz csv lammps; do
  "$hgrid" pairs "whole/$last.$format" --output "$format.csv" || fail "hgrid pairs does not read $last.$format"
  cmp xyz.csv "$format.csv" || fail "$last.$format holds other contacts than $last.xyz"
done

# Stopped halfway and restarted, with another number of threads.
"$hgrid" run busy.toml --quiet --steps 150 --output part >/dev/null
[[ -s part/checkpoint ]] || fail "no checkpoint"
"$hgrid" run busy.toml --quiet --threads 2 --restart part/checkpoint --output part >/dev/null
last=$(basename "$(ls whole/state-*.xyz | tail -1)")
cmp "whole/$last" "part/$last" || fail "the restarted run ended elsewhere"
cmp <(tail -1 whole/energy.csv) <(tail -1 part/energy.csv) || fail "the restarted run has another energy"

# In stages: stopped within each and where they meet, and restarted.
sed '/^\[time\]/,/^steps/d' busy.toml >staged.toml
cat >>staged.toml <<'TOML'
[[stage]]
name = "fall"
steps = 100
[[stage]]
name = "slide"
steps = 120
[stage.gravity]
acceleration = [1, 0, -1]
[stage.friction]
coefficient = 0.6
[[stage]]
steps = 80
friction = false
[stage.dissipation]
restitution = 0.3
[stage.output]
energy = 0.01
TOML
"$hgrid" run staged.toml --quiet --output stages >out.txt
grep -q '^stage 2: slide, from step 100 on' out.txt || fail "stages are not told: $(cat out.txt)"
last=$(basename "$(ls stages/state-*.xyz | tail -1)")
[[ $last == state-000000000300.xyz ]] || fail "the stages end with $last"
for stop in 50 100 101 200 220 290; do
  rm -rf part
  "$hgrid" run staged.toml --quiet --steps "$stop" --output part >/dev/null
  "$hgrid" run staged.toml --quiet --threads 2 --restart part/checkpoint --output part >/dev/null
  cmp "stages/$last" "part/$last" || fail "stages, restarted at step $stop: ended elsewhere"
  cmp <(tail -1 stages/energy.csv) <(tail -1 part/energy.csv) || fail "stages, restarted at step $stop: other energy"
done

# Ctrl-C in the middle: a checkpoint and whole files; going on from it leaves the folder of an undisturbed run.
"$hgrid" run busy.toml --quiet --steps 1000000000 --output stopped >/dev/null 2>err.txt &
running=$!
until [[ -e stopped/energy.csv && $(wc -l <stopped/energy.csv) -ge 40 ]]; do
  kill -0 "$running" 2>/dev/null || break
done
kill -INT "$running"
wait "$running" && fail "an interrupted run ended with exit code 0"
step=$(sed -n 's/.*interrupted at step \([0-9]*\); go on with hgrid run .* --restart stopped.checkpoint$/\1/p' err.txt)
[[ $step -gt 100 ]] || fail "an interrupted run says: $(cat err.txt)"
echo "$((step + 3)),1,1,1,1,1,1,1,1,1" >>stopped/energy.csv # as of a run that was killed later than its last checkpoint
"$hgrid" run busy.toml --quiet --steps $((step + 20)) --restart stopped/checkpoint --output stopped >/dev/null
"$hgrid" run busy.toml --quiet --steps $((step + 20)) --output undisturbed >/dev/null
diff -r stopped undisturbed || fail "interrupted at step $step and restarted: another folder than undisturbed"

# A folder of an earlier run is neither mixed with another nor lost by a slip of the hand.
if "$hgrid" run busy.toml --quiet --steps 5 --output part >out.txt 2>err.txt; then fail "two runs were mixed"; fi
grep -q 'part: holds an earlier run, [0-9]* files such as .*--overwrite removes it' err.txt || fail "says: $(cat err.txt)"
touch part/notes.txt
"$hgrid" run busy.toml --quiet --steps 5 --output part --overwrite >/dev/null
[[ -e part/notes.txt && $(ls part | grep -c '^state-') -le 8 && $(wc -l <part/energy.csv) -le 7 ]] ||
  fail "--overwrite left or took too much: $(ls part)"

# A sweep: a folder for each combination, each as if it had been run alone, and a table of their ends.
"$hgrid" run busy.toml --quiet --set friction.coefficient=0.1,0.2 --set dissipation.restitution=0.7,0.9 --steps 30 \
  --output sweep >out.txt
[[ $(ls sweep | wc -l) == 4 ]] || fail "a sweep of four made $(ls sweep)"
sed 's/coefficient = 0.3/coefficient = 0.2/; s/restitution = 0.8/restitution = 0.7/' busy.toml >alone.toml
"$hgrid" run alone.toml --quiet --steps 30 --output alone >/dev/null
diff -r alone "sweep/friction.coefficient=0.2,dissipation.restitution=0.7" || fail "a run of a sweep differs from itself"
grep -qE '^friction.coefficient  dissipation.restitution  time +energy' out.txt || fail "no table: $(cat out.txt)"
[[ $(grep -cE '^0\.[12] +0\.[79] ' out.txt) == 4 ]] || fail "the table has other rows: $(cat out.txt)"
if "$hgrid" run busy.toml --set friction >out.txt 2>err.txt; then fail "a setting without value was taken"; fi
grep -q "'friction' is not TABLE.KEY=VALUE" err.txt || fail "the setting is not named: $(cat err.txt)"

# Pictures: of the table a line for each column that is not 0, of a state a sphere for each particle.
"$hgrid" plot whole --output plot.svg
columns=$(awk -F, 'FNR > 1 { for (k = 3; k <= NF; k++) if ($k != 0) shown[FILENAME, k] } END { print length(shown) }' \
  whole/energy.csv whole/bulk.csv)
[[ $columns -ge 8 && $(grep -c '<polyline' plot.svg) == "$columns" ]] || fail "the plot has other lines than $columns"
for color in size speed contacts force; do
  "$hgrid" picture "whole/$last" --color $color --output $color.pov >out.txt || fail "no picture by $color"
  [[ $(grep -c '^sphere{' $color.pov) == 400 ]] || fail "the picture by $color holds other spheres"
done
if "$hgrid" picture wrong.csv --output x.pov 2>err.txt; then fail "an absent file was drawn"; fi
if command -v povray >/dev/null; then
  "$hgrid" picture "whole/$last" --width 64 --output state.png >out.txt
  [[ $(head -c 4 state.png | tail -c 3) == PNG && ! -e state.png.pov ]] || fail "no PNG: $(ls)"
fi

# Walls stand in their own files beside the states, where they were then, and in the pictures: without them the scene
# has its spheres alone.
cat >paddle.stl <<'STL'
solid paddle
facet normal 0 1 0
outer loop
vertex 0 0 0
vertex 2 0 0
vertex 0 0 1
endloop
endfacet
endsolid paddle
STL
cat >walled.toml <<'TOML'
[[particles]]
at = [[0, 0, 3], [1.5, 0.2, 2]]
radius = 0.3
[box]
min = [-3, -3, 0]
max = [3, 3, 40]
walls = "z"
[[wall]]
name = "piston"
point = [0, 0, 5]
normal = [0, 0, -1]
velocity = [0, 0, -0.5]
[[wall]]
point = [0, 0, 0]
axis = [0, 0, 1]
radius = 2.5
[[wall]]
name = "paddle"
file = "paddle.stl"
turning = 0.7
[contact]
stiffness = 1e3
[time]
end = 1.5
[output]
every = 0.5
energy = 0.5
TOML
"$hgrid" run walled.toml --quiet --output walled >/dev/null
"$python" "$here/read_walls.py" walled || fail "walls do not read back"
last=$(basename "$(ls walled/state-*.vtp | tail -1)")
"$hgrid" picture "walled/$last" --output walled.pov >out.txt
"$hgrid" picture "walled/$last" --no-walls --output bare.pov >out.txt
read -r lines faces < <(awk '/^cylinder/ { lines++ } /^triangle/ { faces++ } END { print lines, faces }' walled.pov)
[[ $lines -ge 150 && $faces -ge 150 ]] || fail "the picture shows $lines lines and $faces triangles of walls"
# Faces and lines let light through, and no bar of colours is there.
[[ $(grep -c '^sphere' walled.pov) == 2 && $(grep -c no_shadow walled.pov) == 2 ]] || fail "walls cast shadows"
[[ $(grep -c rgbt walled.pov) == 2 ]] || fail "walls are not seen through"
grep -qE '^(cylinder|triangle|mesh)' bare.pov && fail "--no-walls shows walls"
cp "walled/$last" elsewhere.vtp
"$hgrid" picture elsewhere.vtp --output elsewhere.pov >out.txt
cmp bare.pov elsewhere.pov || fail "a state without walls beside it is another picture"

# An absurd start is warned of, and refused when asked: a ball half a metre under the floor.
cat >under.toml <<'TOML'
[[particles]]
at = [["1 m", "1 m", "-0.5 m"]]
radius = "10 mm"
density = "1000 kg/m^3"
[box]
max = ["2 m", "2 m", "2 m"]
[contact]
stiffness = "1e4 N/m"
[time]
steps = 1
TOML
"$hgrid" run under.toml --quiet --output under >out.txt 2>err.txt || fail "warnings end a run: $(cat err.txt)"
grep -q 'hgrid: warning: step 0: surfaces overlap by 51 of the smaller radius' err.txt || fail "no warning: $(cat err.txt)"
grep -q 'hgrid: warning: step 0: centres of particles lie behind walls: 1' err.txt || fail "no warning: $(cat err.txt)"
grep -q '^worst seen, see the warnings: overlap over radius 51 (step 0), centres behind walls 1' out.txt ||
  fail "the end does not say what was seen: $(cat out.txt)"
if "$hgrid" run under.toml --quiet --strict --overwrite --output under >out.txt 2>err.txt; then fail "--strict lets it pass"; fi
grep -q 'step 0: surfaces overlap by 51' err.txt || fail "--strict says: $(cat err.txt)"

# Refusals: exit code 1, the file and line, no trace of success.
sed 's/restitution = 0.8/restitutoin = 0.8/' busy.toml >wrong.toml
if "$hgrid" run wrong.toml >out.txt 2>err.txt; then fail "a wrong key was taken"; fi
grep -q "wrong.toml:8: 'restitutoin' is no key of \[dissipation\]: did you mean 'restitution'?" err.txt ||
  fail "the wrong key is not named: $(cat err.txt)"
if "$hgrid" run absent.toml >out.txt 2>err.txt; then fail "an absent scene was run"; fi
grep -q 'absent.toml' err.txt || fail "the absent scene is not named"
echo "run.sh: all is well"
