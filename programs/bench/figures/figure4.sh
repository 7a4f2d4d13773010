#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Fig. 4 of the paper, slow-down against the number of levels: programs/bench/figures/figure4.sh [BUILD [WORK [OUTPUT]]].
# OUTPUT is the folder of figure4.csv and of the picture. About twenty minutes, with the packings.
set -euo pipefail
# shellcheck disable=SC2034  # systems.sh uses them
build=${1:-build} work=${2:-figures-work} output=${3:-$work}
here=$(dirname "${BASH_SOURCE[0]}")
# shellcheck source=programs/bench/figures/systems.sh
. "$here/systems.sh"
mkdir -p "$output"

# In groups: what stands in one is timed in turns.
groups=("1" "2,3,4,5,6" "7,8,9,10,11,12" "14,17,20,25" "30,40,50")
laws=(uniform-size uniform-volume)
csvs=()
for law in "${laws[@]}"; do
  scene=$(settled "$law" 50 125001)
  for levels in "${groups[@]}"; do
    csv=$work/levels-$law-$levels.csv
    csvs+=("$csv")
    # A step on one level takes seconds.
    repeats=7 first=3
    [[ $levels != 1 ]] || repeats=2 first=2
    measure ${#csvs[@]} $((${#laws[@]} * ${#groups[@]})) "$csv" "$scene" --sweep levels --levels "$levels" \
      --steps 10 --repeats $repeats --turn-seconds 0.5 --first-steps $first
  done
done
join "$output/figure4.csv" "${csvs[@]}"
python3 "$here/../plot/figures.py" --output "$output" "$output/figure4.csv"
