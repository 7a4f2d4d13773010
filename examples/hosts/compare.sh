#!/bin/sh
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Runs a host with its own search and with the library, prints the times of both and the size of the change, and fails
# if they print other things or if the change takes more than ten new lines.
# compare.sh BUILD_DIR HOST [ARGUMENT_OF_THE_HOST]...
set -eu
here=$(dirname "$0")
programs=$1/examples/hosts/$2 sources=$here/$2 host=$2
shift 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

for search in before after; do
  printf '%-6s ' "$search"
  if [ "$host" = python ]; then
    "${PYTHON-python3}" "$sources/$search.py" "$@" >"$work/$search"
  else
    "$programs/$search" "$@" >"$work/$search"
  fi
done 2>&1
cmp "$work/before" "$work/after"
[ -s "$work/before" ]
echo "both print the same $(wc -c <"$work/before") bytes"

# Lines with something on them.
diff "$sources"/before.* "$sources"/after.* >"$work/change" || true
new=$(grep -c '^> *[^ ]' "$work/change")
echo "$new new lines, $(grep -c '^< *[^ ]' "$work/change") old ones gone"
[ "$new" -le 10 ]
