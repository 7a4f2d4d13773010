#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Fig. 4 of the paper at its other densities, 0.1 and 0.4: programs/bench/figures/density.sh [BUILD [WORK [OUTPUT [N]]]].
# OUTPUT is the folder of density.csv and of the picture; N: particles (30000). About five minutes, with the packings.
set -euo pipefail
# shellcheck disable=SC2034  # systems.sh uses them
build=${1:-build} work=${2:-figures-work} output=${3:-$work} count=${4:-30000}
here=$(dirname "${BASH_SOURCE[0]}")
# shellcheck source=programs/bench/figures/systems.sh
. "$here/systems.sh"
mkdir -p "$output"

groups=("1" "2,3,4,5" "6,7,8,10,14,20")  # in groups: what stands in one is timed in turns
csvs=()
for density in 0.1 0.4; do
  scene=$(settled uniform-volume 50 "$count")
  for levels in "${groups[@]}"; do
    csv=$work/density-$density-$levels.csv
    csvs+=("$csv")
    repeats=7 first=3
    [[ $levels != 1 ]] || repeats=2 first=2
    measure ${#csvs[@]} $((2 * ${#groups[@]})) "$csv" "$scene" --sweep levels --levels "$levels" \
      --steps 10 --repeats $repeats --turn-seconds 0.2 --first-steps $first
  done
done
join "$output/density.csv" "${csvs[@]}"
python3 "$here/../plot/figures.py" --output "$output" "$output/density.csv"
