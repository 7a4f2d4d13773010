#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# What each world costs, even and uneven, open and periodic: programs/bench/worlds.sh [BUILD [WORK [OUTPUT [WORLD...]]]].
#
# Each world is measured in one run of hgrid_compare with all other programs and, in turns with them, with the library on
# its reference: even packings of the same sizes, or the same particles with open axes. OUTPUT is the folder of worlds.csv,
# programs/bench/results/PROCESSOR unless said. WORK keeps packings and measurements; what is there is not made again.
# HGRID_MEASURE, if set, is a command put before each measurement (e.g. "taskset -c 1"). About an hour for all.
set -euo pipefail
shopt -s inherit_errexit
build=${1:-build} work=${2:-figures-work}
here=$(dirname "${BASH_SOURCE[0]}")
processor=$(sed -n '/^model name/ { s/.*: //; p; q }' /proc/cpuinfo | tr '[:upper:]' '[:lower:]' |
  sed 's/([^)]*)//g; s/ processor//; s/[^a-z0-9]\+/-/g; s/^-\|-$//g')
output=${3:-$here/results/${processor:-unknown}}
wanted=("${@:4}")
count=${HGRID_WORLD_COUNT:-125000} large=${HGRID_WORLD_LARGE:-1000000}

hgrid=$build/bin/hgrid
compare=$build/bin/hgrid_compare
for program in "$hgrid" "$compare"; do
  [[ -x $program ]] || { echo "$program is not there: build with the command and the benchmarks" >&2; exit 1; }
done
mkdir -p "$work" "$output"

# NAME REFERENCE OPTION...: a world, what it is measured against (-: nothing), how hgrid pack makes it. NAME-open is the
# same with open axes; names that end in -1M have that many particles.
uv50="--law uniform-volume --ratio 50" uv10="--law uniform-volume --ratio 10" two="--law two-sizes --ratio 10"
mono="--law mono"
worlds="
mono                    -                     $mono
two-sizes-10            -                     $two
uniform-volume-10       -                     $uv10
uniform-volume-50       -                     $uv50
mono-1M                 mono                  $mono
uniform-volume-50-1M    uniform-volume-50     $uv50
mono-x                  mono-x-open           $mono --periodic x
mono-xyz                mono-xyz-open         $mono --periodic xyz
two-sizes-10-xyz        two-sizes-10-xyz-open $two --periodic xyz
uniform-volume-50-xyz   uniform-volume-50-xyz-open $uv50 --periodic xyz
part                    part-open             $mono --arrangement part
part-across             part-open             $mono --arrangement part-across
clusters                mono                  $mono --arrangement clusters
filaments               mono                  $mono --arrangement filaments
jet                     mono                  $mono --arrangement jet
clumps                  mono                  $mono --arrangement clumps
far                     mono                  $mono --arrangement far
clusters-10             uniform-volume-10     $uv10 --arrangement clusters
filaments-10            uniform-volume-10     $uv10 --arrangement filaments
jet-10                  uniform-volume-10     $uv10 --arrangement jet
clumps-10               uniform-volume-10     $uv10 --arrangement clumps
far-10                  uniform-volume-10     $uv10 --arrangement far
film                    mono                  $mono --arrangement film
film-1M                 mono-1M               $mono --arrangement film
shell                   mono                  $mono --arrangement shell
crowd                   mono                  $mono --arrangement crowd
gas                     mono                  $mono --arrangement gas
dust                    mono                  $mono --arrangement dust
outliers                mono                  $mono --arrangement outliers
scales                  mono                  $mono --arrangement scales
"

# packing NAME: prints the name of its file, made if it is not there.
packing() {
  local file=$work/$1.csv from particles=$count options
  if [[ ! -s $file && $1 == *-open ]]; then
    from=$(packing "${1%-open}")
    sed '1s/periodic [01] [01] [01]/periodic 0 0 0/' "$from" >"$file.part.csv"
  elif [[ ! -s $file ]]; then
    [[ $1 != *-1M ]] || particles=$large
    read -r _ _ options < <(grep "^$1 " <<<"$worlds")
    # shellcheck disable=SC2086  # several options
    "$hgrid" pack $options --count "$particles" --output "$file.part.csv" >&2
  fi
  [[ -s $file ]] || mv "$file.part.csv" "$file"
  echo "$file"
}

# measured NAME REFERENCE: writes WORK/NAME.measured.csv unless it is there. A program that ran out of time or memory, or
# broke down, is told in there; pairs that differ end all.
measured() {
  local csv=$work/$1.measured.csv file reference beside=()
  [[ ! -s $csv ]] || return 0
  file=$(packing "$1")
  if [[ $2 != - ]]; then
    reference=$(packing "$2")
    beside=(--beside "$reference")
  fi
  # shellcheck disable=SC2086  # a command with its arguments
  ${HGRID_MEASURE:-} "$compare" "$file" "${beside[@]}" --csv "$csv.part" --repeats "${HGRID_WORLD_REPEATS:-11}" \
    --seconds 2 --patience 20 --memory 6 --only 'library/grid-exact/best/1' '[!l]*' 'lammps-*' >&2
  mv "$csv.part" "$csv"
}

for name in "${wanted[@]}"; do
  grep -q "^$name " <<<"$worlds" || { echo "no world is called $name" >&2; exit 1; }
done
csvs=()
while read -r name reference _; do
  [[ -n $name ]] || continue
  ((${#wanted[@]} == 0)) || [[ " ${wanted[*]} " == *" $name "* ]] || continue
  echo "measuring $name" >&2
  measured "$name" "$reference" </dev/null
  csvs+=("$work/$name.measured.csv")
done <<<"$worlds"
python3 "$here/plot/worlds_csv.py" "${csvs[@]}" >"$output/worlds.csv.part"
mv "$output/worlds.csv.part" "$output/worlds.csv"
echo "$output/worlds.csv"
