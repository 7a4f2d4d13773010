#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Fig. 5 of the paper, time relative to equal spheres against N: bench/figures/figure5.sh [BUILD [WORK [OUTPUT]]].
# OUTPUT is the folder of figure5.csv, the picture goes to docs/images. About fifteen minutes, with the packings.
set -euo pipefail
build=${1:-build} work=${2:-figures-work} output=${3:-bench/results/measured}
here=$(dirname "${BASH_SOURCE[0]}")
. "$here/systems.sh"
mkdir -p "$output"

counts=(1000 3000 10000 30000 125001 300000 1000000)
systems=("mono 1" "two-sizes 10" "uniform-volume 10" "uniform-volume 50")
csvs=()
for count in "${counts[@]}"; do
  for system in "${systems[@]}"; do
    read -r law ratio <<<"$system"
    csv=$work/size-$law-$ratio-$count.csv
    csvs+=("$csv")
    # The largest of so few particles would stay far below the law's.
    if [[ $system == "uniform-volume 50" ]] && ((count < 3000)); then
      unset 'csvs[-1]'
      continue
    fi
    scene=$(settle_steps=$((count < 100000 ? 2000 : 200000000 / count)) settled "$law" "$ratio" "$count")
    # About as many moves of particles in each turn, and a few searches anew with a skin.
    steps=$((count < 60000 ? 12000000 / count : 100))
    measure ${#csvs[@]} $((${#systems[@]} * ${#counts[@]} - 1)) "$csv" "$scene" --sweep size --skins 0.2 \
      --steps "$steps" --repeats 7 --turn-seconds 1.5 --first-steps 5
  done
done
join "$output/figure5.csv" "${csvs[@]}"
python3 "$here/../plot/figures.py" --output "$here/../../docs/images" "$output/figure5.csv"
