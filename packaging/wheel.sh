#!/bin/sh
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Builds the wheel, sees that it needs nothing but the system's own libraries, installs it in a clean environment and
# runs it there: wheel.sh OUT_DIR
# Needs swig, and for $PYTHON (default: python3) pip, venv, numpy and scikit-build-core: on Debian 12 the package
# python3-scikit-build-core of bookworm-backports. With ISOLATED=1 pip fetches all of these itself.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
if [ $# -ne 1 ]; then
  sed -n '4,7s/^# //p' "$0" >&2
  exit 2
fi
python=${PYTHON:-python3}
mkdir -p "$1"
out=$(cd "$1" && pwd)
rm -rf "$out"/hgrid-*.whl "$out/venv"

isolation=--no-build-isolation
sites=--system-site-packages # numpy is the system's
if [ "${ISOLATED:-0}" = 1 ]; then
  isolation='' sites=''
fi
# shellcheck disable=SC2086  # words or nothing
"$python" -m pip wheel $isolation --no-deps --wheel-dir "$out" "$root"
"$python" "$root/packaging/self_contained.py" "$out"/hgrid-*.whl

# shellcheck disable=SC2086
"$python" -m venv $sites "$out/venv"
if [ -n "$isolation" ]; then
  "$out/venv/bin/pip" install --no-index --no-deps "$out"/hgrid-*.whl
else
  "$out/venv/bin/pip" install "$out"/hgrid-*.whl
fi
EXPECTED_VERSION=$(sed -n 's/^project(hgrid VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")
export EXPECTED_VERSION
sh "$root/tests/package/python.sh" "$out/venv/bin/python" "" "$root/tests/package/contacts.py"
echo "the wheel's package runs in $out/venv"
