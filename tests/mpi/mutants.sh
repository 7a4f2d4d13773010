#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Wrong variants of the rule, each put into a copy of one source file: the tests must notice every one of them.
# mutants.sh SOURCE_DIR WORK_DIR "COMPILER FLAGS..." "MPIRUN OPTIONS..." "LIBRARIES..." TEST_DIR OBJECT...
set -euo pipefail
source=$1 work=$2 tests=$6
read -ra compiler <<<"$3"
read -ra mpirun <<<"$4"
read -ra libraries <<<"$5"
shift 6
objects=("$@")
rm -rf "$work"
mkdir -p "$work"
for program in fuzz steps; do
  "${compiler[@]}" -c "$tests/$program.cpp" -o "$work/$program.o"
done
fuzz=$work/fuzz.o steps=$work/steps.o

# mutant NAME FILE SED_SCRIPT PROGRAM_OBJECT MESSAGE RANKS ARGUMENT...: the program must fail and say the message.
mutant() {
  local name=$1 file=$2 script=$3 program=$4 message=$5 ranks=$6
  shift 6
  sed "$script" "$source/mpi/$file" >"$work/$name.cpp"
  if cmp -s "$source/mpi/$file" "$work/$name.cpp"; then
    echo "$name: the line to change is no longer in mpi/$file"
    exit 1
  fi
  "${compiler[@]}" -c "$work/$name.cpp" -o "$work/$name.o"
  local others=()
  for object in "${objects[@]}"; do
    [[ $object == */"$file".o ]] || others+=("$object")
  done
  ((${#others[@]} == ${#objects[@]} - 1)) || { echo "$name: no object of mpi/$file" && exit 1; }
  "${compiler[@]}" "$program" "$work/$name.o" "${others[@]}" "${libraries[@]}" -o "$work/$name"
  if timeout 60 "${mpirun[@]}" "$ranks" "$work/$name" "$@" >"$work/$name.log" 2>&1; then
    echo "$name: not noticed"
    exit 1
  fi
  grep -q "$message" "$work/$name.log" || { echo "$name: failed otherwise" && cat "$work/$name.log" && exit 1; }
  echo "$name: $(grep -c "$message" "$work/$name.log") times: $message"
}

pairs='pairs are wrong'
mutant reach selection.cpp 's/rule_.reach(\(.*)\))\(.*;\)/(0.98 * rule_.reach(\1))\2/' \
  "$fuzz" "$pairs" 3 200
mutant lost_ties local_search.cpp 's/return ra != rb ? ra < rb : .*;/return ra < rb;/' "$fuzz" "$pairs" 3 40
mutant doubled_ties local_search.cpp 's/return ra != rb ? ra < rb : .*;/return ra <= rb;/' "$fuzz" "$pairs" 3 40
mutant radii_of_now local_search.cpp 's/^void LocalSearch::move.*/&\n  ranking_radii_ = particles.radii;/' \
  "$fuzz" "$pairs" 3 200
mutant no_skin world.cpp 's/rule_(grid_def)/rule_([\&] { hg_grid_def def = grid_def; def.skin = 0; return def; }())/' \
  "$fuzz" "$pairs" 3 200
shift='for (int axis = 0; axis < 3; axis++) if (grid_def_.periodic[axis] != 0) sent.center[axis] += '
shift+='grid_def_.box_max[axis] - grid_def_.box_min[axis];'
mutant shifted_copies world.cpp "s/return particles_.pack(row, 0);/{ auto sent = particles_.pack(row, 0); $shift return sent; }/" \
  "$fuzz" "$pairs" 3 40
# Boxes of where particles were when owners or ghosts were chosen last, as the cuts of a partition are.
cuts='(chosen_centers_.size() == owned_ * particles_.dimension ? chosen_centers_ : particles_.centers)'
mutant cuts world.cpp "s/selection.emplace(rule_, owned_, particles_.centers/selection.emplace(rule_, owned_, $cuts/" \
  "$fuzz" "$pairs" 3 200
# Right, but with more ghosts than the rule needs.
mutant no_smallest selection.cpp '/if (.*smallest.*) return/d' "$steps" 'one giant is the only ghost' 3
