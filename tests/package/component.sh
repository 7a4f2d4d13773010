# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# A component that there is not is named, with those that there are.
# component.sh CMAKE WORK_DIR PREFIX NAME OPTION...
set -eu
cmake=$1 work=$2 prefix=$3 name=$4
shift 4
rm -rf "$work"
mkdir -p "$work"
printf 'cmake_minimum_required(VERSION 3.20)\nproject(p LANGUAGES C)\nfind_package(hgrid REQUIRED COMPONENTS %s)\n' "$name" \
  >"$work/CMakeLists.txt"
if "$cmake" -S "$work" -B "$work/build" -DCMAKE_PREFIX_PATH="$prefix" "$@" >"$work/log" 2>&1; then
  echo "the component $name was found"
  exit 1
fi
tr -s '\n ' ' ' <"$work/log" | grep -qF "hgrid has no component '$name': its components are" || { cat "$work/log" && exit 1; }
