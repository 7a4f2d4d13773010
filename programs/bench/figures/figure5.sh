#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Fig. 5 of the paper, time relative to equal spheres against N: programs/bench/figures/figure5.sh [BUILD [WORK [OUTPUT [N...]]]].
# OUTPUT is the folder of figure5.csv and of the picture. About ten minutes, with the packings, up to the
# default N of 125 001; above, growing the packings takes longer in proportion.
set -euo pipefail
# shellcheck disable=SC2034  # systems.sh uses them
build=${1:-build} work=${2:-figures-work} output=${3:-$work}
here=$(dirname "${BASH_SOURCE[0]}")
# shellcheck source=programs/bench/figures/systems.sh
. "$here/systems.sh"
mkdir -p "$output"

counts=("${@:4}")
((${#counts[@]} > 0)) || counts=(1000 3000 10000 30000 125001)
systems=("mono 1" "two-sizes 10" "uniform-volume 10" "uniform-volume 50")
csvs=()
for count in "${counts[@]}"; do
  scenes=()
  for system in "${systems[@]}"; do
    read -r law ratio <<<"$system"
    # The largest of so few particles would stay far below the law's.
    if ((ratio < 50 || count >= 3000)); then
      scenes+=("$(settle_steps=$((count < 200000 ? 2000 : 400)) settled "$law" "$ratio" "$count")")
    fi
  done
  csv=$work/size-$count.csv
  csvs+=("$csv")
  # About as many moves of particles in each turn; with a skin, some searches anew are among them.
  measure ${#csvs[@]} ${#counts[@]} "$csv" "${scenes[@]}" --sweep size --skins 0.2 \
    --steps $((count < 60000 ? 12000000 / count : 100)) --repeats 5 --turn-seconds 1 --first-steps 5
done
join "$output/figure5.csv" "${csvs[@]}"
python3 "$here/../plot/figures.py" --output "$output" "$output/figure5.csv"
