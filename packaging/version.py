#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Keeps the version one: version.py [NEW]

CMakeLists.txt states the version and HGRID_SOVERSION; files that other tools read must repeat them. Without NEW each
such place is compared, and every disagreement printed; exits with 1 if there is one. With NEW (X.Y.Z) it is written to
all of them, with a new entry in Debian's changelog.
"""

import datetime
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCE = "CMakeLists.txt"
VERSION = r"^project\(hgrid VERSION (\d+\.\d+\.\d+) "
SOVERSION = r"^set\(HGRID_SOVERSION (\d+)\)"
DEBIAN = "packaging/debian/changelog"
DEBIAN_ENTRY = r"\Alibhgrid \((\d+\.\d+\.\d+)-\d+\) "
# Where the version stands, as one group.
PLACES = {
    SOURCE: VERSION,
    "CITATION.cff": r"^version: (\S+)$",
    "fpm.toml": r'^version = "(.*)"$',
    "packaging/conda/recipe.yaml": r'^  version: "(.*)"$',
    "packaging/spack/package.py": r'^    version\("(\d.*?)"',
    DEBIAN: DEBIAN_ENTRY,
}
FORTRAN = "bindings/fortran/hgrid_types.f90"
FORTRAN_PARTS = [rf"public :: HG_VERSION_{part} = (\d+)$" for part in ("MAJOR", "MINOR", "PATCH")]
# Files that read it by themselves, and the text of theirs that does so.
READERS = {"pyproject.toml": 'input = "CMakeLists.txt"', "packaging/nix/package.nix": "readFile ../../CMakeLists.txt"}


def read(name):
    return (ROOT / name).read_text(encoding="utf-8")


def find(name, pattern):
    found = re.findall(pattern, read(name), re.MULTILINE)
    if len(found) != 1:
        sys.exit(f"{name}: {len(found)} places match {pattern}, one is wanted")
    return found[0]


def write(name, pattern, value):
    text = read(name)
    start, end = re.search(pattern, text, re.MULTILINE).span(1)
    (ROOT / name).write_text(text[:start] + value + text[end:], encoding="utf-8")


def version_faults(version):
    for name, pattern in PLACES.items():
        found = find(name, pattern)
        if found != version:
            yield f"{name} says {found}, {SOURCE} {version}"
    found = ".".join(find(FORTRAN, pattern) for pattern in FORTRAN_PARTS)
    if found != version:
        yield f"{FORTRAN} says {found}, {SOURCE} {version}"
    for name, text in READERS.items():
        if text not in read(name):
            yield f"{name} does not read the version from {SOURCE}"
    dated = re.findall(r"^## (\d+\.\d+\.\d+) ", read("CHANGELOG.md"), re.MULTILINE)
    if dated and dated[0] != version:
        yield f"CHANGELOG.md: its newest release is {dated[0]}, {SOURCE} says {version}"


def interface_faults(number):
    """That the nodes of symbols and the names of Debian's packages carry HGRID_SOVERSION."""
    for path in sorted((ROOT / "cmake").glob("*.map")):
        node = f"{path.stem.upper()}_{number}"
        if not re.search(rf"^{node} {{$", path.read_text(encoding="utf-8"), re.MULTILINE):
            yield f"{path.relative_to(ROOT)} has no node {node}"
        package = path.stem.replace("_", "-") + ("-" if path.stem[-1].isdigit() else "") + number
        symbols = ROOT / f"packaging/debian/lib{package}.symbols"
        head = f"lib{path.stem}.so.{number} lib{package} "
        if not symbols.exists() or not symbols.read_text(encoding="utf-8").startswith(head):
            yield f"packaging/debian/{symbols.name} is not there, or does not begin with '{head}'"
        if f"\nPackage: lib{package}\n" not in read("packaging/debian/control"):
            yield f"packaging/debian/control has no package lib{package}"
    symbols = ROOT / f"packaging/debian/libhgrid{number}.symbols"
    listed = set(re.findall(r"hg_\S+@\S+", symbols.read_text(encoding="utf-8") if symbols.exists() else ""))
    exported = set(read("tests/abi/exported_symbols.txt").replace("@@", "@").split())
    for symbol in sorted(exported ^ listed):
        where = "is missing in" if symbol in exported else "is no export, but stands in"
        yield f"{symbol} {where} packaging/debian/libhgrid{number}.symbols"


def set_version(version):
    if not re.fullmatch(r"\d+\.\d+\.\d+", version):
        sys.exit(f"'{version}' is no version like 1.2.3")
    for name, pattern in PLACES.items():
        if name != DEBIAN:
            write(name, pattern, version)
    for pattern, part in zip(FORTRAN_PARTS, version.split(".")):
        write(FORTRAN, pattern, part)
    if find(DEBIAN, DEBIAN_ENTRY) != version:
        former = read(DEBIAN)
        signed = re.search(r"^ -- (.*>)  ", former, re.MULTILINE)[1]
        date = datetime.datetime.now(datetime.timezone.utc).strftime("%a, %d %b %Y %H:%M:%S +0000")
        entry = f"libhgrid ({version}-1) unstable; urgency=medium\n\n  * New release.\n\n -- {signed}  {date}\n\n"
        (ROOT / DEBIAN).write_text(entry + former, encoding="utf-8")


def main():
    if len(sys.argv) > 2 or "--help" in sys.argv:
        sys.exit(__doc__)
    if len(sys.argv) == 2:
        set_version(sys.argv[1])
    version, number = find(SOURCE, VERSION), find(SOURCE, SOVERSION)
    faults = [*version_faults(version), *interface_faults(number)]
    print(f"version {version}, binary interface {number}")
    sys.exit("\n".join(faults) or 0)


if __name__ == "__main__":
    main()
