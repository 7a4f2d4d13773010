#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# clang-tidy finds nothing in the C++ files of some folders, headers included. Exits with 77 where it is not installed.
# tests/structure/tidy.sh BUILD_DIR FOLDER...    BUILD_DIR: configured, so that it holds compile_commands.json
set -euo pipefail
build=$1
shift
for tool in clang-tidy-14 clang-tidy; do
  command -v "$tool" >/dev/null && "$tool" --version | grep -q 'version 14\.' && tidy=$tool && break
done
[[ -n ${tidy-} ]] || { echo "no clang-tidy 14; on Debian: apt-get install clang-tidy-14" && exit 77; }

# Only what is compiled here: the database does not know the instruction sets of other processors.
mapfile -t files < <(for folder in "$@"; do
  sed -n "s|^ *\"file\": \"\($(realpath "$folder")/.*\.cpp\)\".*|\1|p" "$build/compile_commands.json"
done | sort -u)
((${#files[@]} > 0)) || { echo "$build/compile_commands.json names no file in: $*" && exit 1; }
log=$(mktemp)
trap 'rm -f "$log"' EXIT
status=0
printf '%s\0' "${files[@]}" | xargs -0 -P "$(nproc)" -n 2 "$tidy" -p "$build" --quiet --warnings-as-errors='*' >"$log" 2>&1 ||
  status=1
((status == 0)) || cat "$log"
echo "${#files[@]} files"
exit "$status"
