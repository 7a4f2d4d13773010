# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Configures and builds a consumer project with CMake, and runs it.
# cmake_project.sh CMAKE PROJECT_DIR FIRST_ID WORK_DIR OPTION...
set -eu
cmake=$1 project=$2 first=$3 work=$4
shift 4
here=$(dirname "$0")
. "$here/expect.sh"
rm -rf "$work"
"$cmake" -S "$project" -B "$work" -DEXPECTED_VERSION="$EXPECTED_VERSION" "$@"
"$cmake" --build "$work"
expect_contacts "$first" "$work/contacts"
