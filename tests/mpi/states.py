#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Compares two states, .vtp or .pvtp with its pieces: states.py FIRST SECOND [TOLERANCE].

Particles are put in order by their column id; without one they stand in order. Without a tolerance all numbers must
have the same bits; with one, columns that both have differ by less, relative to the largest number of the column, and
those of periodic places are not wrapped between the two.
"""

import base64
import pathlib
import struct
import sys
import xml.etree.ElementTree as xml


def piece(path):
    """Rows of each array of a .vtp."""
    arrays = {}
    tree = xml.parse(path)
    count = int(tree.find(".//Piece").get("NumberOfPoints"))
    for array in tree.findall(".//PointData/DataArray") + tree.findall(".//Points/DataArray"):
        raw = base64.b64decode(array.text)
        size = struct.unpack_from("<Q", raw)[0]
        numbers = struct.unpack_from(f"<{size // 8}d", raw, 8)
        width = int(array.get("NumberOfComponents"))
        assert len(numbers) == width * count, f"{path}: {array.get('Name')} has {len(numbers)} numbers"
        arrays[array.get("Name")] = [numbers[k : k + width] for k in range(0, len(numbers), width)]
    return arrays


def state(path):
    path = pathlib.Path(path)
    if path.suffix == ".vtp":
        return piece(path)
    tree = xml.parse(path)
    names = [array.get("Name") for array in tree.iter("PDataArray")]
    whole = {name: [] for name in names}
    for source in tree.iter("Piece"):
        part = piece(path.parent / source.get("Source"))
        assert list(part) == names, f"{source.get('Source')} has {list(part)}, its index {names}"
        for name in names:
            whole[name] += part[name]
    order = sorted(range(len(whole["id"])), key=lambda k: whole["id"][k])
    assert [whole["id"][k][0] for k in order] == list(range(len(order))), f"{path}: particles are missing or double"
    return {name: [rows[k] for k in order] for name, rows in whole.items()}


def main():
    first, second = state(sys.argv[1]), state(sys.argv[2])
    if len(sys.argv) < 4:
        if first == second:
            return 0
        print(f"{sys.argv[1]} and {sys.argv[2]} differ in", [name for name in first if first[name] != second.get(name)])
        return 1
    worst = 0
    common = [name for name in first if name in second and name != "id"]
    assert {"centers", "velocity", "radius"} <= set(common) and len(first["radius"]) == len(second["radius"])
    for name in common:
        scale = max(abs(number) for row in first[name] for number in row) or 1
        off = max(abs(p - q) for row, other in zip(first[name], second[name]) for p, q in zip(row, other)) / scale
        worst = max(worst, off)
    print(f"{len(first['radius'])} particles, {', '.join(common)}: differ by {worst:.2g}")
    return 0 if worst < float(sys.argv[3]) else 1


if __name__ == "__main__":
    sys.exit(main())
