#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Each exported function has a page in section 3, each command one in section 1, and no page a fault that mandoc or groff
# finds: pages.sh PYTHON SOURCE_DIR [HGRID]. Left out (77) where Doxygen is missing.
set -euo pipefail
python=$1 source=$(realpath "$2") hgrid=${3:+$(realpath "$3")}
command -v doxygen >/dev/null || { echo "doxygen was not found: the manual is not tested"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$source"
export HGRID_XML=$work PYTHONDONTWRITEBYTECODE=1
doxygen docs/doxygen/Doxyfile
"$python" docs/man/pages.py "$work/xml" "$work/man3" 1.2.3 2012-04-01
[[ -z $hgrid ]] || "$python" docs/man/commands.py "$work/man1" 1.2.3 2012-04-01 "$hgrid"

fail() {
  echo "$*"
  exit 1
}
cd "$work"
names=$(cat "$source/tests/abi/exported_symbols.txt" "$source/tests/mpi/exported_symbols.txt" | grep -oE '^hg_[a-z0-9_]+' | sort -u)
(($(wc -l <<<"$names") > 50)) || fail "tests/abi/exported_symbols.txt lists too few functions: $names"
for name in $names; do
  [[ -s man3/$name.3 ]] || fail "no page for $name"
  grep -q "^.*$name.*(.*" man3/"$name".3 || fail "the page of $name does not show how it is called"
done
if [[ -n $hgrid ]]; then
  for name in $("$hgrid" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]\{1,\}\).*/\1/p'); do
    [[ -s man1/hgrid-$name.1 ]] || fail "no page for hgrid $name"
  done
fi
# What the comment of one function says, under the headings that it has there; all of a comment that stands over three.
grep -qx '.SH ERRORS' man3/hg_insert.3 && grep -qx '.SH COMPLEXITY' man3/hg_insert.3 || fail "hg_insert(3) lacks a heading"
tr '\n' ' ' <man3/hg_move_arrays.3 | grep -q 'one array for each axis' || fail "hg_move_arrays(3) lacks its text"
grep -qx 'hg_query_pairs \\- all pairs, each once, a < b, in the order of def.pair_order' man3/hg_query_pairs.3 ||
  fail "hg_query_pairs(3) is summed up otherwise: $(sed -n '/SH NAME/,+1p' man3/hg_query_pairs.3)"

if command -v mandoc >/dev/null; then
  mandoc -T lint -W warning man?/* || fail "mandoc finds faults"
fi
if command -v groff >/dev/null; then
  said=$(groff -man -ww -z -Tutf8 man?/* 2>&1)
  [[ -z $said ]] || fail "groff finds faults: $said"
fi
command -v mandoc groff >/dev/null || echo "neither mandoc nor groff was found: what pages look like is not tested"
echo "$(ls man?/* | wc -l) pages"
