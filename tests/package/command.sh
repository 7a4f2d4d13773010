# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# The installed command starts without help from the environment, tells its version and finds the scenes that were moved
# with it.
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
prefix=$(cd "$(dirname "$1")/.." && pwd -P)
"$1" scenes | grep -F .toml | while IFS= read -r scene; do
  case $scene in
  "$prefix"/*) ;;
  *)
    echo "$1 scenes names $scene, which is not below $prefix"
    exit 1
    ;;
  esac
done
"$1" scenes | grep -qF .toml
