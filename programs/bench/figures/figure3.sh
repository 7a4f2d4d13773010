#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Fig. 3 of the paper, pictures of its four packings: programs/bench/figures/figure3.sh [BUILD [WORK [OUTPUT]]].
# OUTPUT is the folder of the pictures. Needs POV-Ray (Debian: povray). About four minutes, with the packings.
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
# shellcheck disable=SC2034  # systems.sh uses them
build=${1:-build} work=${2:-figures-work} output=${3:-$work}
# shellcheck source=programs/bench/figures/systems.sh
. "$here/systems.sh"
command -v povray >/dev/null || { echo "povray is not there (apt-get install povray)" >&2; exit 1; }
edge=${HGRID_PICTURE_EDGE:-425}  # pixels

for system in "mono 1" "two-sizes 10" "uniform-size 50" "uniform-volume 50"; do
  read -r law ratio <<<"$system"
  file=$(packing "$law" "$ratio" 125001)
  scene=$work/$law.pov picture=$output/packing-$law.png
  # All sizes of the uniform law are there in equal numbers: the logarithm would make nearly all of them light.
  options=()
  [[ $law != uniform-size ]] || options=(--linear)
  python3 "$here/scene.py" "${options[@]}" "$file" >"$scene"
  echo "rendering $picture" >&2
  povray +I"$scene" +O"$picture" +W"$edge" +H"$edge" +A0.1 +UA -D +FN8 >"$work/povray.log" 2>&1 ||
    { tail -20 "$work/povray.log" >&2; exit 1; }
  echo "$picture"
done
