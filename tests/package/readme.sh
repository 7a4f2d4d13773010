# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Takes every fenced block of one language out of a page, builds it against the installed copy and runs it. A block of
# language "text" right behind it holds what the program prints.
# PACKAGE in the environment: what pkg-config is asked for, where that is not the package of the language.
# readme.sh PAGE LANGUAGE WORK_DIR PKGCONFIG_DIR COMPILER_OR_INTERPRETER [MODULE_DIR]
set -eu
page=$1 language=$2 work=$3 compiler=$5
export PKG_CONFIG_PATH="$4"
LD_LIBRARY_PATH=$(pkg-config --variable=libdir hgrid)
export LD_LIBRARY_PATH PYTHONPATH="${6-}" LUA_CPATH="${6-}/?.so" OCTAVE_PATH="${6-}"

rm -rf "$work"
mkdir -p "$work"
# Writes block_1.LANGUAGE, block_2.LANGUAGE ... and the text that follows block k as block_k.expected.
awk -v language="$language" -v work="$work" '
  !inside && /^```[a-z0-9]+$/ {
    inside = 1
    kind = substr($0, 4)
    file = ""
    if (kind == language) {
      count++
      file = work "/block_" count "." language
    } else if (kind == "text" && previous == language) {
      file = work "/block_" count ".expected"
    }
    previous = kind
    next
  }
  inside && /^```$/ { inside = 0; next }
  inside && file != "" { print > file }
' "$page"

# build_block SOURCE PROGRAM
build_block() {
  # shellcheck disable=SC2046  # lists of words
  case $language in
  c) "$compiler" -std=c99 -Wall -Wextra -Werror -x c "$1" -x none $(pkg-config --cflags --libs "${PACKAGE:-hgrid}") -o "$2" ;;
  cpp) "$compiler" -std=c++17 -Wall -Wextra -Werror -x c++ "$1" -x none $(pkg-config --cflags --libs hgrid) -o "$2" ;;
  fortran77) "$compiler" -std=legacy -x f77 "$1" -x none $(pkg-config --libs hgrid-f77) -o "$2" ;;
  fortran) "$compiler" -x f95 -ffree-form "$1" -x none $(pkg-config --cflags --libs "${PACKAGE:-hgrid-fortran}") -o "$2" ;;
  python | lua | octave) printf '#!/bin/sh\nexec "%s" "%s"\n' "$compiler" "$1" >"$2" && chmod +x "$2" ;;
  *) echo "no way to run a block of language '$language'" && exit 1 ;;
  esac
}

found=0
for block in "$work"/block_*."$language"; do
  [ -e "$block" ] || continue
  found=$((found + 1))
  program=${block%."$language"}
  echo "block $found of language $language"
  build_block "$block" "$program"
  (cd "$work" && "$program") >"$program.printed"
  if [ -e "$program.expected" ]; then
    diff -u "$program.expected" "$program.printed"
  fi
done
if [ "$found" -eq 0 ]; then
  echo "$page has no block of language $language"
  exit 1
fi
