#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes a packing as a scene for POV-Ray: scene.py [--linear] PACKING.csv > scene.pov

Spheres are coloured by their size or its logarithm, in the shades of `hgrid slice` (programs/draw/palette.hpp). Those with
their centre in the eighth of the box towards the camera are left out, so that one sees inside.
"""

import argparse
import math
import pathlib
import re
import sys

PALETTE = pathlib.Path(__file__).resolve().parents[2] / "draw" / "palette.hpp"
STEPS = 64  # of colour
ONE_SIZE = 2  # the shade of equal spheres, as in the slice

# The box is scaled to the unit cube around the origin, z up; the camera sees three faces.
HEAD = """#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 2 }
background { color rgbt <1, 1, 1, 1> }
camera { orthographic location <4, -6, 4.2> right 1.72*x up 1.72*y sky z look_at <0, 0, -0.03> }
light_source { <5, -14, 16> color rgb 0.86 parallel point_at 0 }
light_source { <12, -4, 3> color rgb 0.3 parallel point_at 0 shadowless }
#default { finish { ambient 0.16 diffuse 0.72 specular 0.12 roughness 0.05 } }
"""


def shades():
    """From the coarsest to the finest."""
    table = re.search(r"kShades\[\] = \{(.*?)\};", PALETTE.read_text(encoding="utf-8"), re.DOTALL)
    return [tuple(int(v) for v in triple) for triple in re.findall(r"\{(\d+), (\d+), (\d+)\}", "{" + table[1] + "}")]


def srgb(share, palette):
    """share: 0 for the smallest, 1 for the largest. Components from 0 to 255."""
    place = (1 - share) * (len(palette) - 1)
    below = min(int(place), len(palette) - 2)
    return [a + (place - below) * (b - a) for a, b in zip(palette[below], palette[below + 1])]


def colour(share, palette):
    return "srgb <{:.3f}, {:.3f}, {:.3f}>".format(*(v / 255 for v in srgb(share, palette)))


def read_packing(path):
    """(low corner, edge) of the box and a list of (x, y, z, radius)."""
    box, spheres = None, []
    with open(path, encoding="utf-8") as file:
        for line in file:
            if line.startswith("# box:"):
                numbers = [float(word) for word in line.split()[2:8]]
                box = numbers[:3], max(high - low for low, high in zip(numbers[:3], numbers[3:]))
            elif line[0] in "-+.0123456789":
                spheres.append(tuple(float(word) for word in line.split(",")[:4]))
    if box is None or not spheres:
        raise SystemExit(f"{path}: no packing of hgrid pack, which begins with its box")
    return box, spheres


def share_of(radius, smallest, largest, linear):
    """From 0 for the smallest to 1 for the largest."""
    if not largest > smallest:
        return 0
    if linear:
        return (radius - smallest) / (largest - smallest)
    return math.log(radius / smallest) / math.log(largest / smallest)


def write_scene(path, linear, out):
    (low, edge), spheres = read_packing(path)
    smallest, largest = min(s[3] for s in spheres), max(s[3] for s in spheres)
    palette = shades()
    out.write(HEAD)
    for step in range(STEPS + 1):
        share = step / STEPS if largest > smallest else 1 - ONE_SIZE / (len(palette) - 1)
        out.write(f"#declare T{step} = texture {{ pigment {{ color {colour(share, palette)} }} }}\n")
    for *center, radius in spheres:
        x, y, z = ((c - l) / edge - 0.5 for c, l in zip(center, low))
        if x > 0 and y < 0 and z > 0:
            continue
        step = round(STEPS * share_of(radius, smallest, largest, linear))
        out.write(f"sphere{{<{x:.5f},{y:.5f},{z:.5f}>,{radius / edge:.5f} texture{{T{step}}}}}\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("packing", help="CSV file of hgrid pack")
    parser.add_argument("--linear", action="store_true", help="colours by size, not by its logarithm")
    arguments = parser.parse_args()
    write_scene(arguments.packing, arguments.linear, sys.stdout)


if __name__ == "__main__":
    main()
