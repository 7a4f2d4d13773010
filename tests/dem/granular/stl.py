# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Walls as STL files. As a program it writes the floor of a silo: stl.py WIDTH DIAMETER [SEGMENTS] > silo-floor.stl. A
square from 0 to WIDTH at z = 0 with a round hole in its middle."""

import math
import sys


def floor_with_hole(width, diameter, segments=32):
    """Triangles between the circle and the square, two for each segment; segments is a multiple of 8, so that the
    square's corners are met."""
    middle = width / 2

    def on_circle(k):
        angle = 2 * math.pi * k / segments
        return (middle + diameter / 2 * math.cos(angle), middle + diameter / 2 * math.sin(angle), 0.0)

    def on_square(k):
        angle = 2 * math.pi * k / segments
        x, y = math.cos(angle), math.sin(angle)
        stretch = middle / max(abs(x), abs(y))
        return (middle + stretch * x, middle + stretch * y, 0.0)

    triangles = []
    for k in range(segments):
        a, b, c, d = on_circle(k), on_square(k), on_square(k + 1), on_circle(k + 1)
        triangles += [(a, b, c), (a, c, d)]
    return triangles


def toothed_drum(radius, depth, teeth, height):
    """Triangles of a drum about the y axis from 0 to depth; between its teeth, which stick out inwards, it has the
    radius."""
    triangles = []
    for k in range(2 * teeth):
        (x, z), (u, w) = (
            (r * math.cos(math.pi * n / teeth), r * math.sin(math.pi * n / teeth))
            for n, r in ((n % (2 * teeth), radius - height * (n % 2)) for n in (k, k + 1))
        )
        a, b, c, d = (x, 0.0, z), (u, 0.0, w), (u, depth, w), (x, depth, z)
        triangles += [(a, b, c), (a, c, d)]
    return triangles


def as_stl(triangles):
    lines = ["solid floor"]
    for corners in triangles:
        lines += ["facet normal 0 0 1", "outer loop"]
        lines += ["vertex %.9g %.9g %.9g" % tuple(x + 0.0 for x in corner) for corner in corners]
        lines += ["endloop", "endfacet"]
    return "\n".join(lines + ["endsolid floor"]) + "\n"


if __name__ == "__main__":
    segments = int(sys.argv[3]) if len(sys.argv) > 3 else 32
    sys.stdout.write(as_stl(floor_with_hole(float(sys.argv[1]), float(sys.argv[2]), segments)))
