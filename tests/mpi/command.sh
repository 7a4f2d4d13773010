#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# hgrid-mpi: its pairs are the bytes of hgrid pairs on any number of ranks, its plan is what ranks hold, and what is
# wrong is told once. command.sh HGRID HGRID_MPI WORK_DIR MPIRUN...
set -euo pipefail
hgrid=$1 hgrid_mpi=$2 work=$3
shift 3
rm -rf "$work"
mkdir -p "$work"
cd "$work"
fail() {
  echo "$1"
  exit 1
}

"$hgrid" pack --law uniform-volume --ratio 20 --count 3000 --periodic xyz --sweeps 5 --output packing.csv >log
"$hgrid" pairs packing.csv --order id --base 1 --output one.csv 2>>log
(($(wc -l <one.csv) > 500)) || fail 'too few pairs to compare'
for ranks in 2 4; do
  "$@" "$ranks" "$hgrid_mpi" pairs packing.csv --base 1 --output many.csv
  cmp one.csv many.csv
  "$@" "$ranks" "$hgrid_mpi" pairs packing.csv --count >counts
  grep -qx "$(($(wc -l <one.csv) - 1)) contacts" counts || fail "$ranks ranks count otherwise"
  # Ghosts of all ranks over the particles, and the most a rank owns: as planned on one process.
  "$hgrid_mpi" plan packing.csv --ranks "$ranks" >plan
  awk -F, 'NR > 1 && NF == 6 { n += $2; g += $3; if ($2 > m) m = $2 } END { printf "%d %.3f\n", m, g / n }' counts >held
  awk -F' *[|] *' '$5 == "by size" { print $3, $6 }' plan >planned
  cmp held planned || fail "$(cat held planned)"
done

# The same system, many times: ghosts per particle as many as on ranks of that size, and fewer where ranks are larger.
"$hgrid_mpi" plan packing.csv --weak --ranks 64,4096 >weak
awk -F' *[|] *' '$5 == "by size" { weak[++k] = $6 } $5 == "one width" { if ($6 <= weak[k]) exit 1 }
  END { exit !(k == 2 && weak[1] > 0.1 && weak[1] == weak[2]) }' weak || fail "$(cat weak)"

said_once() {
  local code=0
  "$@" >out 2>&1 || code=$?
  ((code != 0)) || fail "$*: must fail"
  (($(grep -c '^hgrid-mpi: ' out) == 1)) || fail "$(cat out)"
}
said_once "$@" 2 "$hgrid_mpi" pairs nowhere.csv
said_once "$@" 2 "$hgrid_mpi" pairs packing.csv --output nowhere/many.csv
said_once "$@" 2 "$hgrid_mpi" pairs packing.csv --images all
said_once "$@" 2 "$hgrid_mpi" pairs packing.csv --margin 1e9
