#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Runs every block of shell of the tutorials in an empty folder with the examples in it: commands.sh FOLDER_OF_HGRID
# TUTORIALS. Pictures that POV-Ray renders are left out where it is missing.
set -euo pipefail
bin=$(cd "$1" && pwd) tutorials=$(cd "$2" && pwd) here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
export PATH=$bin:$PATH
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
blocks=0
for page in "$tutorials"/*.md; do
  commands=$(awk '/^```sh$/ { inside = 1; next } /^```$/ { inside = 0 } inside' "$page")
  [[ -n $commands ]] || continue
  if ! command -v povray >/dev/null; then
    echo "povray was not found: left out of $(basename "$page"): $(grep -F .png <<<"$commands" || true)"
    commands=$(grep -vF .png <<<"$commands")
  fi
  blocks=$((blocks + 1))
  folder=$work/$blocks
  mkdir "$folder"
  cp "$here"/*.toml "$folder"
  (cd "$folder" && bash -euxc "$commands") >"$work/log" 2>&1 || { cat "$work/log" && echo "$page fails" && exit 1; }
  # Everything that a command writes is there and holds something.
  for file in $(grep -oE -- '--output [^ ]+' <<<"$commands" | cut -d' ' -f2); do
    [[ -s $folder/$file ]] || { echo "$page: $file is not there" && exit 1; }
  done
done
((blocks >= 2)) || { echo "only $blocks tutorials with commands" && exit 1; }
