#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Four regimes of a drum, rendered at the ends of their runs: programs/bench/figures/drum.sh [BUILD [WORK [OUTPUT]]].
# OUTPUT is the folder of the pictures, drum-froude-F.png. Needs POV-Ray and pngquant (Debian: povray, pngquant). Three
# minutes.
set -euo pipefail
build=${1:-build} work=${2:-figures-work} output=${3:-$work}
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
mkdir -p "$work" "$output"

rm -rf "$work/drum"
python3 "$source/tests/dem/granular/drum_regimes.py" "$build/bin/hgrid" "$work/drum"
for froude in 0.003 0.05 0.7 2; do
  picture=$output/drum-froude-$froude.png
  "$build/bin/hgrid" picture "$(ls "$work/drum/froude-$froude"/state-*.csv | tail -1)" --color speed --width 240 --output "$picture"
  pngquant --force --ext .png --nofs 128 "$picture"
done
