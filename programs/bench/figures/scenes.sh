#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Runs scenes to their end and renders what is there: programs/bench/figures/scenes.sh [BUILD [WORK [OUTPUT [SCENE...]]]].
# OUTPUT is the folder of the pictures, scene-NAME.png and scene-NAME.svg; SCENE: names, all but paper-* if there is
# none. Needs POV-Ray and pngquant (Debian: povray, pngquant). About fifteen minutes, ten of them for sedimentation and
# aggregate.
set -euo pipefail
build=${1:-build} work=${2:-figures-work} output=${3:-$work}
scenes=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)/scenes
hgrid=$build/bin/hgrid
[[ -x $hgrid ]] || { echo "$hgrid is not there: build with the command" >&2; exit 1; }
mkdir -p "$work" "$output"

names=("${@:4}")
if ((${#names[@]} == 0)); then
  for scene in "$scenes"/*.toml; do
    name=$(basename "$scene" .toml)
    [[ $name == paper-* ]] || names+=("$name")
  done
fi
for name in "${names[@]}"; do
  run=$work/scene-$name
  # An interval longer than any run: the first state and the last.
  if [[ ! -e $run/finished ]]; then
    "$hgrid" run "$scenes/$name.toml" --set output.every=1e6 --output "$run" --overwrite >"$work/scene-$name.txt"
    touch "$run/finished"
  fi
  color=speed width=320
  case $name in
    aggregate | drum | sedimentation) color=size width=400 ;;
    heap | pile) color=contacts width=640 ;;
    compression) color=contacts ;;
  esac
  "$hgrid" picture "$(ls "$run"/state-*.vtp | tail -1)" --color $color --width $width --output "$output/scene-$name.png"
  pngquant --force --ext .png --nofs 128 "$output/scene-$name.png"
  "$hgrid" plot "$run" --title "$name" --output "$output/scene-$name.svg"
done
