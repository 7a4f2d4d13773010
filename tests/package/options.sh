# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# What is asked for and missing is an error that names it; what is on by default and missing is said; folders may be
# absolute. Configures only.
# options.sh CMAKE SOURCE_DIR WORK_DIR OPTION...
set -eu
cmake=$1 source=$2 work=$3
shift 3
log=$work/log

# configure OPTION...: the library alone, but for these.
configure() {
  rm -rf "$work"
  mkdir -p "$work"
  "$cmake" -S "$source" -B "$work" -DHGRID_BUILD_TESTS=OFF -DHGRID_BUILD_FORTRAN=OFF -DHGRID_BUILD_F77=OFF \
    -DHGRID_BUILD_PYTHON=OFF -DHGRID_BUILD_APP=OFF "$@" >"$log" 2>&1
}

# says TEXT: on one line, however CMake broke it.
says() {
  tr -s '\n ' ' ' <"$log" | grep -qF -- "$1" || { cat "$log" && echo "configuring does not say '$1'" && exit 1; }
}

# refused TEXT OPTION...
refused() {
  text=$1
  shift
  if configure "$@"; then
    echo "configured in spite of $*" && exit 1
  fi
  says "$text"
}

refused "HGRID_BUILD_PYTHON is ON, but SWIG" "$@" -DHGRID_BUILD_PYTHON=ON -DCMAKE_DISABLE_FIND_PACKAGE_SWIG=ON
refused "HGRID_BUILD_LUA is ON, but SWIG" "$@" -DHGRID_BUILD_LUA=ON -DCMAKE_DISABLE_FIND_PACKAGE_SWIG=ON
refused "HGRID_BUILD_APP is ON, but not found: CLI11" "$@" -DHGRID_BUILD_APP=ON -DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON
refused "HGRID_BUILD_BENCH is ON, but the command hgrid" "$@" -DHGRID_BUILD_BENCH=ON

# One build in which nothing of what it would like is there, with folders as Nix has them.
configure "$@" -DHGRID_BUILD_PYTHON=AUTO -DHGRID_BUILD_LUA=AUTO -DHGRID_BUILD_OCTAVE=AUTO -DHGRID_BUILD_APP=AUTO \
  -DHGRID_THREADS=OFF -DCMAKE_DISABLE_FIND_PACKAGE_SWIG=ON -DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON -DCMAKE_INSTALL_PREFIX=/store/out \
  -DCMAKE_INSTALL_LIBDIR=/store/lib/lib -DCMAKE_INSTALL_INCLUDEDIR=/store/dev/include || { cat "$log" && exit 1; }
says "threads no (HGRID_THREADS)"
for language in Python Lua Octave; do
  says "$language no: SWIG"
done
says "command hgrid no: not found: CLI11"
says "benchmarks no: the command hgrid"
for line in libdir=/store/lib/lib includedir=/store/dev/include threads=no; do
  grep -qx "$line" "$work/cmake/hgrid.pc" || { cat "$work/cmake/hgrid.pc" && echo "hgrid.pc has no line $line" && exit 1; }
done
