# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Completion of hgrid-mpi for bash, made by programs/completion/complete.py; bash finds it by its name once installed.
# shellcheck shell=bash

_hgrid_mpi() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command='' word
  local options='' values='' head=''
  # bash splits --law=mono into three words.
  if [[ $current == = ]]; then
    current=''
  elif [[ $previous == = ]]; then
    previous=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    [[ $word == -* ]] || { command=$word && break; }
  done
  case $command in
    '') options='-h --help --version' values='pairs plan run' ;;
    pairs) options='-h --help -o --output --count --base --format --frame --dimension --header --radius --diameter --type-radius --box --tilt --periodic --open --margin --max-range --touching --images --accuracy --order --levels --level-count --cell-sizes --cell-overhead --level-price --row-price --threads' ;;
    plan) options='-h --help --ranks --weak --weigh-pairs --skin --format --frame --dimension --header --radius --diameter --type-radius --box --tilt --periodic --open --margin --max-range --touching --images --accuracy --order --levels --level-count --cell-sizes --cell-overhead --level-price --row-price --threads --particle-ns --pair-ns --search-ns --choice-ns --interval --forward-bytes --back-bytes --node-ranks --node-bandwidth --rank-bandwidth --latency' ;;
    run) options='-h --help --restart --output --skin --steps --balance --quiet --strict --set --overwrite' ;;
  esac
  case "$command $previous" in
    'pairs --base') values='0 1' ;;
    'pairs --format') values='csv lammps xyz data vtp vtk' ;;
    'pairs --dimension') values='2 3' ;;
    'pairs --images') values='nearest all' ;;
    'pairs --accuracy') values='exact double float' ;;
    'pairs --order') values='id grid' ;;
    'pairs --levels') values='auto paper' ;;
    'plan --format') values='csv lammps xyz data vtp vtk' ;;
    'plan --dimension') values='2 3' ;;
    'plan --images') values='nearest all' ;;
    'plan --accuracy') values='exact double float' ;;
    'plan --order') values='id grid' ;;
    'plan --levels') values='auto paper' ;;
  esac
  COMPREPLY=()
  if [[ -n $values && $current != -* ]]; then
    # Of lists the word behind the last comma.
    [[ $current != *,* ]] || head=${current%,*},
    mapfile -t COMPREPLY < <(compgen -P "$head" -W "$values" -- "${current##*,}")
  elif [[ $current == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
  fi
}
# Everything else is a file.
complete -o bashdefault -o default -F _hgrid_mpi hgrid-mpi
