# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Installs a build, moves the tree elsewhere, and makes sure that it remembers neither place.
# install.sh CMAKE BUILD_DIR SOURCE_DIR PREFIX
set -eu
cmake=$1 build=$2 source=$3 prefix=$4
origin=$prefix-before-move
rm -rf "$prefix" "$origin"
"$cmake" --install "$build" --prefix "$origin"
mv "$origin" "$prefix"

if grep -rIF -e "$build" -e "$source" -e "$origin" "$prefix"; then
  echo "installed files name a folder of the build"
  exit 1
fi
# Programs and libraries, but for debug information.
stripped=$prefix-stripped
find "$prefix" -type f \( -path '*/bin/*' -o -name '*.so*' \) | while IFS= read -r file; do
  strip -o "$stripped" "$file"
  if grep -aqF -e "$build" -e "$source" -e "$origin" "$stripped"; then
    echo "$file holds the name of a folder of the build:"
    strings "$stripped" | grep -F -e "$build" -e "$source" -e "$origin"
    exit 1
  fi
done
rm -f "$stripped"
find "$prefix" -type f \( -path '*/bin/*' -o -name '*.so*' \) | while IFS= read -r file; do
  runpaths=$(readelf -d "$file" | sed -n 's/.*\(RPATH\|RUNPATH\).*\[\(.*\)\]/\2/p' | tr ':' '\n')
  for path in $runpaths; do
    case $path in
    \$ORIGIN*) ;;
    *)
      echo "$file looks for libraries in $path"
      exit 1
      ;;
    esac
  done
done
