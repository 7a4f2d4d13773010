#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Mixing and segregation in a drum: drum.py HGRID SCENES. Runs scenes/drum.toml and prints for each picture, turns after
the start of turning: the slope of the surface; how far the middles of large and small discs are apart, over the drum's
radius; the mean distance of small discs from the middle of the bed, over that of large ones. Exits with 1 unless the
surface slopes by 15 to 45 degrees, the sizes are less than three quarters as far apart as at first (not mixed wholly,
since they segregate), and the small ones end up nearer to the core."""

import glob
import math
import os
import subprocess
import sys
import tempfile

RADIUS, TURNING, START = 30.0, 0.04, 20.0


def read(name):
    with open(name) as table:
        lines = table.read().split("\n")
    time = next(float(line.split("time:")[1].split()[0]) for line in lines if line.startswith("# step:"))
    rows = [line.split(",") for line in lines if line and not line.startswith("#")]
    columns = [rows[0].index(word) for word in ("x", "y", "radius")]
    return time, [tuple(float(row[k]) for k in columns) for row in rows[1:]]


def surface_slope(discs):
    """Of the line through the highest discs of strips across the middle of the drum, in degrees."""
    tops = {}
    for x, y, radius in discs:
        strip = math.floor(x / 3)
        if abs(x) < RADIUS / 2 and y + radius > tops.get(strip, (0, -RADIUS))[1]:
            tops[strip] = (x, y + radius)
    points = list(tops.values())
    mean_x, mean_y = (sum(point[k] for point in points) / len(points) for k in (0, 1))
    rise = sum((x - mean_x) * (y - mean_y) for x, y in points) / sum((x - mean_x) ** 2 for x, y in points)
    return math.degrees(math.atan(rise))


def middle(discs):
    area = sum(radius**2 for x, y, radius in discs)
    return tuple(sum(disc[k] * disc[2] ** 2 for disc in discs) / area for k in (0, 1))


def main():
    hgrid, scenes = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    with open(os.path.join(scenes, "drum.toml")) as source:
        text = source.read() + '[output]\nformats = ["csv"]\n'
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "drum.toml"), "w") as out:
            out.write(text)
        output = os.path.join(folder, "out")
        subprocess.run([hgrid, "run", out.name, "--quiet", "--output", output], check=True, stdout=subprocess.DEVNULL)
        pictures = [read(name) for name in sorted(glob.glob(output + "/state-*.csv"))]
    print("turns  slope  apart  small/large from the core")
    found = []
    for time, discs in pictures:
        large, small = ([disc for disc in discs if (disc[2] > 0.75) == wanted] for wanted in (True, False))
        core = middle(discs)
        away = [sum(math.hypot(x - core[0], y - core[1]) for x, y, r in part) / len(part) for part in (small, large)]
        (x1, y1), (x2, y2) = middle(large), middle(small)
        apart = math.hypot(x1 - x2, y1 - y2) / RADIUS
        found.append((surface_slope(discs), apart, away[0] / away[1]))
        print("%5.2f  %5.1f  %5.3f  %.3f" % ((TURNING * (time - START) / (2 * math.pi),) + found[-1]))
    late = found[-len(found) // 4 :]
    slope, apart, core = (sum(row[k] for row in late) / len(late) for k in (0, 1, 2))
    print("last quarter: slope %.1f degrees, apart %.3f (at first %.3f), core %.3f" % (slope, apart, found[0][1], core))
    sys.exit(not (15 < abs(slope) < 45 and apart < 0.75 * found[0][1] and core < 0.9))


if __name__ == "__main__":
    main()
