#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# The layer and its tests once more, compiled with another MPI, without Zoltan, under sanitizers.
# other_mpi.sh SOURCE_DIR BUILD_DIR WORK_DIR MPICXX MPIRUN "LIBRARIES..."
set -euo pipefail
source=$1 build=$2 work=$3 compiler=$4 mpirun=$5
read -ra libraries <<<"$6"
rm -rf "$work"
mkdir -p "$work"
flags=(-std=c++17 -O1 -ffp-contract=off -DMPICH_SKIP_MPICXX -DOMPI_SKIP_MPICXX
  "-fsanitize=address,undefined" -fno-sanitize-recover=all
  -I"$source" -I"$source/mpi/include" -I"$source/include" -I"$build/include")

# compile FILE...
compile() {
  local file
  for file in "$@"; do
    "$compiler" "${flags[@]}" -c "$file" -o "$work/$(basename "$file").o"
  done
}
mapfile -t layer < <(printf '%s\n' "$source"/mpi/*.cpp | grep -v zoltan)
compile "${layer[@]}" "$source"/tests/mpi/{scene,random_scene}.cpp
shared=("$work"/*.o)
for program in fuzz steps errors killed; do
  compile "$source/tests/mpi/$program.cpp"
  "$compiler" -fsanitize=address,undefined "$work/$program.cpp.o" "${shared[@]}" "${libraries[@]}" -o "$work/$program"
done
# MPI keeps memory of its own until the end.
export ASAN_OPTIONS=detect_leaks=0
# Ranks of MPICH that wait keep their cores busy: more ranks than cores take long.
timeout 90 "$mpirun" -n 2 "$work/fuzz" 40
timeout 90 "$mpirun" -n 3 "$work/fuzz" 5
timeout 90 "$mpirun" -n 2 "$work/steps"
timeout 90 "$mpirun" -n 2 "$work/errors"
# The rank that is killed takes the others along, whatever they wait for.
status=0
timeout 60 "$mpirun" -n 2 "$work/killed" >"$work/killed.log" 2>&1 || status=$?
if ((status == 0 || status == 124)) || ! grep -q 'signal 9' "$work/killed.log"; then
  cat "$work/killed.log"
  exit 1
fi
