# shellcheck shell=sh
# Sourced by the tests: the consumers of the tree, and which version they must tell.
set -eu
consumers=$(pwd)/tests/package
EXPECTED_VERSION=$(sed -n '1s/.*(\(.*\)-.*/\1/p' debian/changelog)
export EXPECTED_VERSION

# with_pkg_config NAME PACKAGE SOURCE FIRST_ID COMPILER [INSTALLED_FORTRAN_SOURCE]
with_pkg_config() {
  echo "pkg-config $2: $1"
  libraries=$(dpkg-query -L libhgrid0 | sed -n 's|/libhgrid\.so\.0$||p')
  sh "$consumers/pkg_config.sh" "$2" "$consumers/$3" "$4" "$5" "$AUTOPKGTEST_TMP/pkg_config_$1" "$libraries/pkgconfig" \
    ${6+"$6"}
}

# with_cmake NAME FIRST_ID
with_cmake() {
  echo "find_package: $1"
  sh "$consumers/cmake_project.sh" cmake "$consumers/$1" "$2" "$AUTOPKGTEST_TMP/cmake_$1"
}
