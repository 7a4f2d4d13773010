# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# The installed command starts without help from the environment and tells its version.
# command.sh COMMAND
set -eu
unset LD_LIBRARY_PATH
printed=$("$1" --version)
case $printed in
*"$EXPECTED_VERSION"*) ;;
*)
  echo "$1 --version printed '$printed', expected version $EXPECTED_VERSION"
  exit 1
  ;;
esac
