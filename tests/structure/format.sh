#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# clang-format leaves all C and C++ unchanged. Exits with 77 where the version that the style is written for is missing.
# tests/structure/format.sh [SOURCE_DIR]
set -euo pipefail
cd "${1:-.}"
for tool in clang-format-14 clang-format; do
  command -v "$tool" >/dev/null && "$tool" --version | grep -q 'version 14\.' && format=$tool && break
done
[[ -n ${format-} ]] || { echo "no clang-format 14; on Debian: apt-get install clang-format-14" && exit 77; }

# Folders of builds may lie beside the sources.
mapfile -t files < <(find ./*/ -path './build*' -prune -o -type f \
  \( -name '*.c' -o -name '*.h' -o -name '*.cpp' -o -name '*.hpp' \) -print)
((${#files[@]} > 300)) || { echo "only ${#files[@]} files found: is this the source tree?" && exit 1; }
"$format" --dry-run --Werror "${files[@]}"
echo "${#files[@]} files"
