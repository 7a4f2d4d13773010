#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# What effects of the simulation cost: programs/bench/effects.sh [BUILD_DIR]. Needs valgrind.
#
# First: the elastic system on the full program and on one with all other effects compiled out: instructions per
# particle and step as callgrind counts them, bytes, final state. Exits with 1 if instructions differ by more than
# 0.1 % or states at all. Then: a table of what each effect adds when it is on.
set -euo pipefail
build=${1:-build}
edge=12 few=20 many=60
particles=$((edge * edge * edge))
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Instructions of PROGRAM under EFFECTS in so many steps.
instructions() {
  HGRID_ISA=sse2 valgrind --tool=callgrind --callgrind-out-file="$work/callgrind" "$1" "$2" "$edge" "$3" \
    >"$work/out" 2>"$work/err" || { cat "$work/err" >&2; exit 1; }
  sed -n 's/^summary: //p' "$work/callgrind"
}

# Of one particle in one step: what more steps add, so that the start does not count.
per_particle_step() {
  local less more
  less=$(instructions "$1" "$2" "$few")
  more=$(instructions "$1" "$2" "$many")
  awk "BEGIN { printf \"%.3f\", ($more - $less) / ($particles * ($many - $few)) }"
}

field() { sed -n "s/.* $1=\([^ ]*\).*/\1/p" "$work/out"; }

echo "unused effects, linear elastic contacts between walls:"
full=$(per_particle_step "$build/bin/hgrid_steps" walls)
full_bytes=$(field bytes) full_state=$(field state)
alone=$(per_particle_step "$build/bin/hgrid_steps_elastic" walls)
alone_bytes=$(field bytes) alone_state=$(field state)
printf '%-22s %14s %18s %18s\n' program instructions 'bytes/particle' 'final state'
printf '%-22s %14s %18s %18s\n' 'all effects built' "$full" "$full_bytes" "$full_state"
printf '%-22s %14s %18s %18s\n' 'others left out' "$alone" "$alone_bytes" "$alone_state"
[[ $full_state == "$alone_state" && $full_bytes == "$alone_bytes" ]] || { echo "states or bytes differ" >&2; exit 1; }
awk "BEGIN { d = ($full - $alone) / $alone; exit !(d < 1e-3 && d > -1e-3) }" ||
  { echo "instructions differ by more than 0.1 %" >&2; exit 1; }

echo
echo "effects that are on, per particle and step (3 contacts per particle, shortest time of five):"
printf '%-42s %12s %8s %8s\n' effects instructions ns bytes
for effects in none walls periodic periodic,shear dissipation hertz adhesion friction friction,rolling \
  gravity drag growth materials dissipation,materials dissipation,friction,rolling,gravity,walls; do
  count=$(per_particle_step "$build/bin/hgrid_steps" "$effects")
  for repeat in 1 2 3 4 5; do
    "$build/bin/hgrid_steps" "$effects" 40 20 >"$work/out"
    field ns
  done >"$work/ns"
  printf '%-42s %12s %8s %8s\n' "$effects" "$count" "$(sort -g "$work/ns" | head -1)" "$(field bytes)"
done
