#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# hgrid-mpi run: the same bits on any number of ranks, near to hgrid run; restarts on other numbers of ranks; a disk that
# is full on one rank; refusals. run.sh HGRID HGRID_MPI PYTHON WORK_DIR MPIRUN...
set -euo pipefail
hgrid=$1 hgrid_mpi=$2 python=$3 work=$4
shift 4
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
rm -rf "$work"
mkdir -p "$work"
cd "$work"
fail() {
  echo "run.sh: $*" >&2
  exit 1
}
states() { "$python" "$here/states.py" "$@"; }
on() {
  local ranks=$1
  shift
  "${mpirun[@]}" "$ranks" "$hgrid_mpi" run "$@" --quiet
}
mpirun=("$@")

# Rough spheres that collide, slide and roll from the first step on, over two periodic faces and on a floor.
cat >busy.toml <<'TOML'
[[material]]
name = "glass"
stiffness = 1e5
[[material]]
name = "rubber"
stiffness = 2e4
[[pair]]
materials = ["glass", "rubber"]
friction = 0.9
[[particles]]
lattice = { counts = [7, 7, 4], spacing = 2.05, origin = [1, 1, 1.1], jitter = 0.03 }
radius = 1
material = "glass"
temperature = 20
[[particles]]
lattice = { counts = [10, 10, 1], spacing = 1.45, origin = [0.7, 0.7, 9.2] }
radius = 0.5
material = "rubber"
[[particles]]
at = [[7.3, 7.3, 13]]
radius = 3
velocity = [0.5, 0, -15]
spin = [0, 3, 0]
material = "rubber"
[box]
max = [14.6, 14.6, 20]
[contact]
[dissipation]
restitution = 0.6
[friction]
coefficient = 0.4
[rolling]
coefficient = 0.1
[periodic]
axes = "xy"
[gravity]
acceleration = [0, 0, -10]
[time]
steps_per_contact = 20
steps = 120
[output]
every = 1e9
energy = 0.005
[run]
skin = 0.1
TOML
last=state-000000000120
"$hgrid" run busy.toml --quiet --set output.checkpoint=1e9 --output serial >/dev/null
for ranks in 1 2 3 4; do
  on "$ranks" busy.toml --balance 25 --output "r$ranks" >"log$ranks"
  states "r1/$last.pvtp" "r$ranks/$last.pvtp" || fail "$ranks ranks end elsewhere than one"
  cmp r1/energy.csv "r$ranks/energy.csv" || fail "$ranks ranks have other energies"
  [[ $(ls "r$ranks/$last"-*.vtp | wc -l) == "$ranks" ]] || fail "$ranks ranks leave $(ls "r$ranks")"
done
states "serial/$last.vtp" "r4/$last.pvtp" 1e-8 || fail "ranks end elsewhere than hgrid run"
"$python" - serial/energy.csv r4/energy.csv <<'PYTHON' || fail "ranks have other energies than hgrid run"
import csv, sys
one, many = (list(csv.reader(open(path))) for path in sys.argv[1:])
assert one[0] == many[0] and len(one) == len(many) > 5 and max(int(row[7]) for row in many[1:]) > 60, (one, many)
for row, other in zip(one[1:], many[1:]):
    scale = max(abs(float(number)) for number in row[2:7])
    assert all(abs(float(p) - float(q)) < 1e-8 * scale for p, q in zip(row[1:7], other[1:7])), (row, other)
    assert row[0] == other[0] and row[7:9] == other[7:9], (row, other)
PYTHON

# Stopped at a checkpoint, restarted on more and on fewer ranks, which own other particles.
on 3 busy.toml --balance 25 --steps 50 --set output.checkpoint=1e9 --output part >/dev/null
[[ $(ls part/checkpoint*) == $(printf 'part/checkpoint%s\n' '' -000000000050-000{0,1,2}) ]] || fail "left $(ls part)"
for ranks in 4 1; do
  rm -rf more
  cp -r part more
  on "$ranks" busy.toml --balance 35 --restart more/checkpoint --output more >/dev/null
  states "r1/$last.pvtp" "more/$last.pvtp" || fail "restarted on $ranks ranks: ended elsewhere"
  cmp <(tail -5 r1/energy.csv) <(tail -5 more/energy.csv) || fail "restarted on $ranks ranks: other energies"
done

# The disk is full for one rank at the second checkpoint: all end, the first one stays and is good.
every=$(awk '/ steps of / { print 30 * $7 }' log1)
on 2 busy.toml --set "output.checkpoint=$every" --steps 30 --output full >/dev/null
ln -s /dev/full full/checkpoint-000000000060-0001.partial
if on 2 busy.toml --set "output.checkpoint=$every" --restart full/checkpoint --output full >out 2>err; then
  fail "a full disk was not noticed"
fi
grep -qx 'hgrid-mpi: rank 1: full/checkpoint-000000000060-0001.partial: cannot write: No space left on device' err ||
  fail "a full disk is told so: $(cat err)"
[[ $(ls full/checkpoint*) == $(printf 'full/checkpoint%s\n' '' -000000000030-000{0,1}) ]] || fail "left $(ls full)"
on 3 busy.toml --restart full/checkpoint --output full >/dev/null
states "r1/$last.pvtp" "full/$last.pvtp" || fail "restarted after a full disk: ended elsewhere"

# Ended from outside: one rank is asked to end, and all leave a checkpoint; one rank is killed, and the last one is good.
for signal in TERM KILL; do
  rm -rf ended pids
  "${mpirun[@]}" 2 sh -c 'echo $$ >>pids; exec "$@"' sh "$hgrid_mpi" run busy.toml --quiet --steps 100000000 \
    --set "output.checkpoint=$every" --output ended >/dev/null 2>err &
  running=$!
  until [[ -e ended/checkpoint && $(wc -l <pids) == 2 ]]; do kill -0 "$running" || fail "ended early: $(cat err)"; done
  kill -s "$signal" "$(tail -1 pids)"
  wait "$running" && fail "a run that was ended by $signal left the exit code 0"
  if [[ $signal == TERM ]]; then
    grep -q 'interrupted at step [0-9]*; go on with hgrid-mpi run busy.toml --restart ended/checkpoint$' err ||
      fail "an interrupted run says: $(cat err)"
  fi
  step=$((10#$(grep -ao 'checkpoint-[0-9]\{12\}' ended/checkpoint | cut -d- -f2))) # the index names its parts
  on 3 busy.toml --steps $((step + 10)) --restart ended/checkpoint --output ended >/dev/null ||
    fail "after $signal: no restart from $(ls ended)"
  on 1 busy.toml --steps $((step + 10)) --overwrite --output undisturbed >/dev/null
  name=$(printf 'state-%012d.pvtp' $((step + 10)))
  states "ended/$name" "undisturbed/$name" || fail "after $signal at step $step: ended elsewhere"
done

# Two dimensions, Hertz contacts, drag, no memory.
cat >flat.toml <<'TOML'
dimension = 2
[[particles]]
lattice = { counts = [12, 12], spacing = 2.02, origin = [1.2, 1.2], jitter = 0.01 }
radius = 1
temperature = 1
[box]
max = [26, 26]
[hertz]
young_modulus = 1e5
poisson_ratio = 0.3
[drag]
viscosity = 0.001
[periodic]
axes = "y"
[time]
steps = 80
[output]
every = 1e9
TOML
"$hgrid" run flat.toml --quiet --output flat0 >/dev/null
for ranks in 1 3; do on "$ranks" flat.toml --balance 20 --output "flat$ranks" >/dev/null; done
states flat1/state-000000000080.pvtp flat3/state-000000000080.pvtp || fail "two dimensions: other bits on 3 ranks"
states flat0/state-000000000080.vtp flat3/state-000000000080.pvtp 1e-9 || fail "two dimensions: not as hgrid run"

# What is not done over ranks is told once, with its key.
refuses() {
  local text=$1
  shift
  if on 2 busy.toml "$@" >out 2>err; then fail "$* was taken"; fi
  grep -q "^hgrid-mpi: .*$text" err && (($(grep -c '^hgrid-mpi: ' err) == 1)) || fail "$* is refused so: $(cat err)"
}
refuses '\[shear\] is not done over ranks yet' --set periodic.axes=xyz --set shear.rate=0.1
refuses '\[\[region\]\] is not done over ranks' --set 'region=[{min=[0,0,0],max=[1,1,1]}]'
refuses 'the key bulk of \[output\]' --set output.bulk=true
refuses 'csv of \[output\]: over ranks' --set 'output.formats=["csv"]'
refuses 'holds an earlier run' --output r2
refuses 'nowhere' --restart nowhere/checkpoint
refuses 'is no checkpoint of a run over ranks' --restart serial/checkpoint
echo "run.sh: all is well"
