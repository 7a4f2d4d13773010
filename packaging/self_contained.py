#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Holds libraries against what every Linux has: self_contained.py FILE...

A FILE is a shared library or a wheel, of which all libraries are looked at. One is self-contained if it needs nothing
but the C library and the runtime of gcc, and looks for libraries in no place of its own. Prints what each needs and the
newest versions of symbols it asks for, which tell how old a system it runs on; exits with 1 if one is not
self-contained, or a wheel holds none or tells another version than its name.
"""

import pathlib
import re
import subprocess
import sys
import tempfile
import zipfile

ALLOWED = re.compile(r"(libc|libm|libpthread|libdl|librt|libstdc\+\+|libgcc_s|ld-linux.*)\.so(\.\d+)*")
VERSIONED = re.compile(r"Name: (GLIBC|GLIBCXX|CXXABI|GCC)_([\d.]+)")


def readelf(option, path):
    return subprocess.run(["readelf", "-W", option, path], check=True, capture_output=True, text=True).stdout


def faults_of_library(name, path):
    dynamic = readelf("-d", path)
    needed = re.findall(r"\(NEEDED\).*\[(.*)\]", dynamic)
    newest = {}
    for family, version in VERSIONED.findall(readelf("-V", path)):
        key = tuple(map(int, version.split(".")))
        newest[family] = max(newest.get(family, key), key)
    asked = ", ".join(f"{family} {'.'.join(map(str, key))}" for family, key in sorted(newest.items()))
    print(f"{name}: needs {' '.join(needed) or 'nothing'}; {asked}")
    yield from (f"{name} needs {library}" for library in needed if not ALLOWED.fullmatch(library))
    yield from (f"{name} looks for libraries in {place}" for place in re.findall(r"R(?:UN)?PATH\).*\[(.*)\]", dynamic))


def faults_of_wheel(path):
    told = path.name.split("-")[1]
    with tempfile.TemporaryDirectory() as folder, zipfile.ZipFile(path) as wheel:
        wheel.extractall(folder)
        libraries = sorted(pathlib.Path(folder).rglob("*.so*"))
        if not libraries:
            yield f"{path.name} holds no library"
        for library in libraries:
            yield from faults_of_library(f"{path.name}: {library.name}", library)
        metadata = [text.read_text(encoding="utf-8") for text in pathlib.Path(folder).glob("*.dist-info/METADATA")]
        if len(metadata) != 1 or f"\nVersion: {told}\n" not in metadata[0]:
            yield f"{path.name}: its metadata do not tell version {told}, once"


def main():
    if len(sys.argv) < 2 or "--help" in sys.argv:
        sys.exit(__doc__)
    faults = []
    for path in map(pathlib.Path, sys.argv[1:]):
        faults += faults_of_wheel(path) if path.suffix == ".whl" else faults_of_library(path.name, path)
    sys.exit("\n".join(faults) or 0)


if __name__ == "__main__":
    main()
