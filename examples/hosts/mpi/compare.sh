#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Runs the hosts on 1, 2, 3, 4 and 8 ranks; fails if a byte of what they leave or print differs.
# compare.sh WORK_DIR "MPIRUN..." HOST...
set -euo pipefail
work=$1
read -ra mpirun <<<"$2"
shift 2
rm -rf "$work"
mkdir -p "$work"
first=
for host in "$@"; do
  name=$(basename "$host")
  for ranks in 1 2 3 4 8; do
    run=$work/$name.$ranks
    "${mpirun[@]}" "$ranks" "$host" "$run.grains" 4000 120 >"$run.log"
    first=${first:-$run}
    cmp "$first.grains" "$run.grains"
    cmp "$first.log" "$run.log"
  done
done
cat "$first.log"
