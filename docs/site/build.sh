#!/usr/bin/env bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Builds the site from docs and the comments of the sources, and checks every link in it: docs/site/build.sh [FOLDER].
# A warning of Doxygen or Sphinx is an error. FOLDER, by default build/site, can be read without a server: open
# index.html.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
out=$(realpath -m "${1-$root/build/site}")
cd "$root"
. cmake/bootstrap.sh
hgrid_require_packages doxygen furo python3 python3-breathe python3-myst-parser python3-numpy python3-sphinx \
  python3-sphinx-copybutton python3-sphinx-inline-tabs

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export HGRID_XML=$work/doxygen PYTHONDONTWRITEBYTECODE=1
mkdir "$HGRID_XML"
doxygen docs/doxygen/Doxyfile
rm -rf "$out"
# Debian's packages; a python3 that stands before Debian's on the path does not see them.
/usr/bin/python3 -m sphinx -W --keep-going -q -j auto -b html -c docs/site -d "$work/doctrees" docs "$out"
/usr/bin/python3 docs/site/links.py "$out"
