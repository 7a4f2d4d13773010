# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Sourced by the scripts of the paper's figures: packings, scenes and measurements, each made only if it is absent.
#
# build, work: the build folder and the folder for everything made on the way. HGRID_MEASURE, if set, is a command put
# before each measurement (e.g. "taskset -c 1").
# shellcheck shell=bash
# shellcheck disable=SC2154

hgrid=$build/bin/hgrid
hgrid_dem=$build/bin/hgrid_dem
for program in "$hgrid" "$hgrid_dem"; do
  [[ -x $program ]] || { echo "$program is not there: build with the command and the benchmarks" >&2; exit 1; }
done
mkdir -p "$work"

# system_name LAW RATIO COUNT: the paper's density stays unsaid.
system_name() { echo "$1-$2-$3${density:+@$density}"; }

# packing LAW RATIO COUNT: grows the packing by events, of density `density` (0.62), and prints its file's name.
packing() {
  local file
  file=$work/$(system_name "$@").csv
  if [[ ! -s $file ]]; then
    echo "growing $file" >&2
    "$hgrid" pack --method event --law "$1" --ratio "$2" --count "$3" --density "${density:-0.62}" \
      --output "$file.part.csv" >&2
    mv "$file.part.csv" "$file"
  fi
  echo "$file"
}

# settled LAW RATIO COUNT: makes the scene of that packing, lets its particles collide, and prints the scene's name.
# It stops after settle_steps steps (2000; 0: never), as a collision of each takes long where most particles are large.
settled() {
  local file scene
  scene=$work/$(system_name "$@").toml
  file=$(packing "$@")
  if [[ ! -s ${scene%.toml}.state ]]; then
    cat >"$scene" <<SCENE
title = "$1, ratio $2, $3 spheres"

[[particles]]
file = "$(basename "$file")"
overlap = 0.01

[contact]
stiffness = 1e5

[time]
steps = 1
SCENE
    echo "letting particles of $scene collide" >&2
    "$hgrid_dem" "$scene" --keep-state --settle-steps "${settle_steps:-2000}" --settle-only >&2
  fi
  echo "$scene"
}

started=$SECONDS
# measure PART PARTS CSV ARGUMENT...: runs hgrid_dem with these arguments unless CSV is there; tells what is left of so
# many parts.
measure() {
  local part=$1 parts=$2 csv=$3
  shift 3
  local left=$(((SECONDS - started) * (parts - part + 1) / (part > 1 ? part - 1 : 1)))
  echo "[$part of $parts] $(basename "$csv" .csv)$( ((part == 1)) || echo ", about $left s left")" >&2
  [[ ! -s $csv ]] || return 0
  # shellcheck disable=SC2086  # a command with its arguments
  ${HGRID_MEASURE:-} "$hgrid_dem" "$@" --keep-state --csv "$csv.part" >&2
  mv "$csv.part" "$csv"
}

# join CSV PART...: one file of all parts, the head once.
join() {
  local whole=$1
  shift
  head -n 1 "$1" >"$whole"
  local part
  for part in "$@"; do tail -n +2 "$part" >>"$whole"; done
  echo "$whole"
}
