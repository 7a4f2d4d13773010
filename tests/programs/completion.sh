#!/bin/bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# The files of completion are those that complete.py makes of --help now, and bash completes with them what --help lists:
# completion.sh PYTHON SOURCE_DIR PROGRAM...
set -u
python=$1 folder=$2/programs/completion
shift 2
failures=0
fault() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

# words LINE...: what bash offers for the last of these words.
words() {
  COMP_WORDS=("$@")
  COMP_CWORD=$(($# - 1))
  COMPREPLY=()
  "_${1//-/_}"
  printf '%s\n' "${COMPREPLY[@]}"
}

# same WHAT FOUND EXPECTED
same() { [ "$2" = "$3" ] || fault "$1: '$2' in place of '$3'"; }

for program in "$@"; do
  name=$(basename "$program")
  for shell in bash zsh; do
    file=$name.bash
    [ $shell = bash ] || file=_$name
    "$python" "$folder/complete.py" $shell "$program" | diff -u "$folder/$file" - ||
      fault "$file is out of date: python3 programs/completion/complete.py $shell build/bin/$name > programs/completion/$file"
  done
  # shellcheck disable=SC1090
  . "$folder/$name.bash"
  # Independent of complete.py: the words at the begin of lines of --help.
  commands=$("$program" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]\{1,\}\).*/\1/p')
  [ -n "$commands" ] || fault "$name --help lists no commands"
  same "commands of $name" "$(words "$name" '' | sort)" "$(sort <<<"$commands")"
  for command in $commands; do
    options=$("$program" "$command" --help | grep -oE '^  -[^ ]+' | tr ',' '\n' | tr -d ' ' | grep '^--' | sort)
    same "options of $name $command" "$(words "$name" "$command" -- | sort)" "$options"
  done
done
if [ "$name" = hgrid ] || [ "$(basename "$1")" = hgrid ]; then
  same 'a law by its begin' "$(words hgrid pack --law two)" two-sizes
  same 'a law behind =' "$(words hgrid pack --law = two)" two-sizes
  same 'the last of a list' "$(words hgrid pairs --columns id,dist)" id,distance
  same 'a file, left to the shell' "$(words hgrid pairs pack)" ''
fi
if command -v zsh >/dev/null; then
  for file in "$folder"/_hgrid*; do
    zsh -n "$file" || fault "zsh does not read $file"
  done
else
  echo "zsh was not found: its files are compared, but not read"
fi
((failures == 0)) || exit 1
