# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Sourced by tests in shell, after they have made their arguments absolute: works in a folder that goes with the test,
# and counts what does not hold instead of stopping at it.
# shellcheck shell=bash
set -u
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
failures=0

fault() {
  echo "FAILED: $*" >&2
  failures=$((failures + 1))
}

# equal WHAT FOUND EXPECTED
equal() { [ "$2" = "$3" ] || fault "$1: found '$2', expected '$3'"; }

# fails CODE TEXT ARGUMENT...: $hgrid ends with this exit code, says TEXT on standard error, nothing on the other.
fails() {
  local code=$1 text=$2 found
  shift 2
  "${hgrid:?}" "$@" >out.txt 2>err.txt
  found=$?
  equal "exit code of $*" "$found" "$code"
  [ -s out.txt ] && fault "$*: standard output is not empty"
  grep -qF -- "$text" err.txt || fault "$*: no '$text' in '$(cat err.txt)'"
}

# contacts FILE OPTION...: how many $hgrid finds.
contacts() { "$hgrid" pairs "$@" --count | awk '$1 == "contacts" && NF == 2 { print $2 }'; }

# finish TEXT: ends the test, with the text if all held.
finish() {
  ((failures == 0)) || { echo "$failures checks failed" >&2 && exit 1; }
  echo "$1"
  exit 0
}

# field NAME FILE: the values of a column, without quotes. No text before the last columns holds a comma.
field() {
  awk -F, -v name="$1" 'NR == 1 { for (k = 1; k <= NF; ++k) if ($k == name) c = k; if (!c) exit 1; next }
    { gsub(/"/, "", $c); print $c }' "$2"
}
