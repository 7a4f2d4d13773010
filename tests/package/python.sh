# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# The installed Python module is found by its folder alone and finds the library by itself.
# python.sh PYTHON MODULE_DIR SCRIPT
set -eu
here=$(dirname "$0")
. "$here/expect.sh"
unset LD_LIBRARY_PATH
# From another folder, so that no module of the source tree is taken.
cd /
PYTHONPATH=$2
export PYTHONPATH
expect_contacts 0 "$1" "$3"
# Tools know its version.
"$1" -c 'import importlib.metadata as metadata, hgrid; assert metadata.version("hgrid") == hgrid.__version__'
