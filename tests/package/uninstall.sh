# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Components are installed apart, and what was installed is removed, nothing else.
# uninstall.sh CMAKE BUILD_DIR SOURCE_DIR PREFIX
set -eu
cmake=$1 build=$2 source=$3 prefix=$4

# files: of the prefix, but for what was there before.
files() {
  find "$prefix" ! -type d ! -name others
}

rm -rf "$prefix"
mkdir -p "$prefix/include/hgrid"
: >"$prefix/include/hgrid/others"
for component in runtime development; do
  "$cmake" --install "$build" --prefix "$prefix" --component "$component" >"$prefix.log"
  case $component in
  runtime)
    files | grep -q '/libhgrid\.' || { files && echo "the component runtime lacks the library" && exit 1; }
    ! files | grep -E '\.(h|hpp|cmake|pc|mod)$' || { echo "the component runtime has files of others" && exit 1; }
    ;;
  development)
    for name in hgrid.h hgridConfig.cmake hgrid.pc; do
      files | grep -q "/$name$" || { files && echo "the component development lacks $name" && exit 1; }
    done
    ;;
  esac
done
for component in runtime development; do
  "$cmake" -DBUILD="$build" -DCOMPONENT="$component" -P "$source/cmake/Uninstall.cmake"
done
[ -z "$(files)" ] || { files && echo "not removed" && exit 1; }
[ -e "$prefix/include/hgrid/others" ] || { echo "files of others were removed" && exit 1; }
left=$(find "$prefix" -mindepth 1 -name '*hgrid*')
[ "$left" = "$prefix/include/hgrid" ] || { echo "$left" && echo "folders are left" && exit 1; }
