# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# A program built by another Fortran compiler than the library's.
# other_compiler.sh COMPILER WORK_DIR F77_LIBRARY C_LIBRARY SOURCE...
set -eu
compiler=$1 work=$2 f77=$3 c=$4
shift 4
rm -rf "$work"
mkdir -p "$work"
case $compiler in
*flang-new*) set -- -flang-experimental-exec "$@" ;;
esac
"$compiler" "$@" "$f77" "$c" -o "$work/program"
LD_LIBRARY_PATH=$(dirname "$f77"):$(dirname "$c") "$work/program"
