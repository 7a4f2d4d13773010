# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# A copy of the installed tree whose module files no compiler can read, as if another one had built it.
# foreign_modules.sh PREFIX COPY
set -eu
prefix=$1 copy=$2
rm -rf "$copy"
cp -r "$prefix" "$copy"
modules=$(find "$copy" -name '*.mod')
if [ -z "$modules" ]; then
  echo "no module files are installed"
  exit 1
fi
for module in $modules; do
  echo 'a module of another compiler' >"$module"
done
