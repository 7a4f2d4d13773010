#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Whole steps per second of the paper's systems beside LAMMPS: programs/bench/figures/steps.sh [BUILD [WORK [OUTPUT]]].
# OUTPUT is the folder of steps.csv. About eight minutes, with the packings.
set -euo pipefail
# shellcheck disable=SC2034  # systems.sh uses them
build=${1:-build} work=${2:-figures-work} output=${3:-$work}
# shellcheck source=programs/bench/figures/systems.sh
. "$(dirname "${BASH_SOURCE[0]}")/systems.sh"
mkdir -p "$output"

# Helpers inherit the cores of the thread that first called the library: bound to one core, none would get another.
unset OMP_PROC_BIND OMP_PLACES GOMP_CPU_AFFINITY

systems=("mono 1" "uniform-volume 50")
csvs=()
for ((k = 0; k < ${#systems[@]}; ++k)); do
  read -r law ratio <<<"${systems[k]}"
  scene=$(settle_steps=0 settled "$law" "$ratio" 125001)
  csvs+=("$work/steps-$law.csv")
  measure $((k + 1)) ${#systems[@]} "${csvs[k]}" "$scene" --steps 400 --repeats 5 --turn-seconds 6 --first-steps 5
done
join "$output/steps.csv" "${csvs[@]}"
