# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Completion of hgrid for bash, made by programs/completion/complete.py; bash finds it by its name once installed.
# shellcheck shell=bash

_hgrid() {
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
    '') options='-h --help --version' values='pairs levels pack bench calibrate slice run plot picture scenes accuracy' ;;
    pairs) options='-h --help -o --output --columns --count --base --format --frame --dimension --header --radius --diameter --type-radius --box --tilt --periodic --open --margin --max-range --touching --images --accuracy --order --levels --level-count --cell-sizes --cell-overhead --level-price --row-price --threads' ;;
    levels) options='-h --help --csv --costs --format --frame --dimension --header --radius --diameter --type-radius --box --tilt --periodic --open --margin --max-range --touching --images --accuracy --order --levels --level-count --cell-sizes --cell-overhead --level-price --row-price --threads' ;;
    pack) options='-h --help --law --ratio --exponent --sigma --modulus --d63 --uniformity --median --from --sizes --radius --count --arrangement --density --seed --offset --random-offset --method --sweeps --growth-rate --dimension --periodic -o --output --format' ;;
    bench) options='-h --help --repeats --most-levels --seconds --threads --accuracy --steps --skin --displacement --csv --format --frame --dimension --header --radius --diameter --type-radius --box --tilt --periodic --open --level-price --row-price' ;;
    calibrate) options='-h --help --count --repeats --most-levels --seconds --threads' ;;
    slice) options='-h --help -o --output --axis --at --levels --level-count --format --frame --dimension --header --radius --diameter --type-radius --box --tilt --periodic --open' ;;
    run) options='-h --help --restart --from --output --threads --skin --steps --quiet --strict --set --overwrite' ;;
    plot) options='-h --help -o --output --title' ;;
    picture) options='-h --help -o --output --color --stiffness --width --cut --no-walls --format --frame --dimension --header --radius --diameter --type-radius --box --tilt --periodic --open' ;;
    scenes) options='-h --help --keys' ;;
    accuracy) options='-h --help --knob --quick --count --truth-count --repeats --markdown --from --csv --svg --simulation' ;;
  esac
  case "$command $previous" in
    'pairs --columns') values='place id type distance overlap shift' ;;
    'pairs --base') values='0 1' ;;
    'pairs --format') values='csv lammps xyz data vtp vtk' ;;
    'pairs --dimension') values='2 3' ;;
    'pairs --images') values='nearest all' ;;
    'pairs --accuracy') values='exact double float' ;;
    'pairs --order') values='id grid' ;;
    'pairs --levels') values='auto paper' ;;
    'levels --format') values='csv lammps xyz data vtp vtk' ;;
    'levels --dimension') values='2 3' ;;
    'levels --images') values='nearest all' ;;
    'levels --accuracy') values='exact double float' ;;
    'levels --order') values='id grid' ;;
    'levels --levels') values='auto paper' ;;
    'pack --law') values='mono two-sizes uniform-size uniform-volume power-law log-normal one-giant fuller rosin-rammler log-normal-mass table' ;;
    'pack --arrangement') values='even gas clusters clumps crowd filaments film shell jet far outliers dust scales part part-across' ;;
    'pack --method') values='relax event' ;;
    'pack --format') values='csv lammps xyz vtp' ;;
    'bench --accuracy') values='exact double float' ;;
    'bench --format') values='csv lammps xyz data vtp vtk' ;;
    'bench --dimension') values='2 3' ;;
    'slice --axis') values='x y z' ;;
    'slice --levels') values='auto paper' ;;
    'slice --format') values='csv lammps xyz data vtp vtk' ;;
    'slice --dimension') values='2 3' ;;
    'picture --color') values='size speed contacts force' ;;
    'picture --format') values='csv lammps xyz data vtp vtk' ;;
    'picture --dimension') values='2 3' ;;
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
complete -o bashdefault -o default -F _hgrid hgrid
