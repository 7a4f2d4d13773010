#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Fig. 5 of the paper, time relative to equal spheres against N: bench/figures/figure5.sh [BUILD [WORK [OUTPUT]]].
# OUTPUT is the folder of figure5.csv, the picture goes to docs/images. About fifteen minutes, with the packings.
set -euo pipefail
# shellcheck disable=SC2034  # systems.sh uses them
build=${1:-build} work=${2:-figures-work} output=${3:-$work}
here=$(dirname "${BASH_SOURCE[0]}")
# shellcheck source=bench/figures/systems.sh
. "$here/systems.sh"
mkdir -p "$output"

counts=(1000 3000 10000 30000 125001 300000 1000000)
systems=("mono 1" "two-sizes 10" "uniform-volume 10" "uniform-volume 50")
csvs=()
for count in "${counts[@]}"; do
  scenes=()
  for system in "${systems[@]}"; do
    read -r law ratio <<<"$system"
    # The largest of so few particles would stay far below the law's.
    if ((ratio < 50 || count >= 3000)); then
      scenes+=("$(settle_steps=$((count < 100000 ? 2000 : count < 1000000 ? 1000 : 400)) settled "$law" "$ratio" "$count")")
    fi
  done
  csv=$work/size-$count.csv
  csvs+=("$csv")
  # About as many moves of particles in each turn; with a skin, some searches anew are among them.
  measure ${#csvs[@]} ${#counts[@]} "$csv" "${scenes[@]}" --sweep size --skins 0.2 \
    --steps $((count < 60000 ? 12000000 / count : 100)) --repeats 5 --turn-seconds 1 --first-steps 5
done
join "$output/figure5.csv" "${csvs[@]}"
python3 "$here/../plot/figures.py" --output "$here/../../docs/images" "$output/figure5.csv"
