# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Compiles a consumer against the installed copy with what pkg-config says, and runs it.
# pkg_config.sh PACKAGE SOURCE_FILE FIRST_ID COMPILER WORK_DIR PKGCONFIG_DIR [INSTALLED_FORTRAN_SOURCE]
set -eu
package=$1 source=$2 first=$3 compiler=$4 work=$5
here=$(dirname "$0")
. "$here/expect.sh"
export PKG_CONFIG_PATH="$6"

version=$(pkg-config --modversion "$package")
if [ "$version" != "$EXPECTED_VERSION" ]; then
  echo "pkg-config says version $version, the project $EXPECTED_VERSION"
  exit 1
fi
rm -rf "$work"
mkdir -p "$work"
# Module files go where the compiler runs.
cd "$work"
# shellcheck disable=SC2046  # a list of words
"$compiler" ${7:+"$(pkg-config --variable=fortrandir "$package")/$7"} "$source" $(pkg-config --cflags --libs "$package") -o "$work/contacts"
LD_LIBRARY_PATH=$(pkg-config --variable=libdir "$package")
export LD_LIBRARY_PATH
expect_contacts "$first" "$work/contacts"
