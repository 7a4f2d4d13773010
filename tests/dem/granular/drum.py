#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Mixing and segregation in a drum: drum.py HGRID SCENES. Runs scenes/drum.toml and prints for each picture, turns after
the start of turning: the slope of the surface; how well the sizes are mixed round the bed; the mean distance of small
discs from the middle of the bed, over that of large ones.

Mixed is measured by Lacey's index (J. Appl. Chem. 4 (1954) 257) of sectors about the middle of the bed: with s^2 the
variance of the share of small discs by sector, s0^2 = p (1 - p) of sizes apart and sr^2 = s0^2 / n of n discs a sector
put down at random, it is (s0^2 - s^2) / (s0^2 - sr^2): 0 apart, 1 at random. Sectors do not see a core of small discs.
Exits with 1 unless the surface slopes by 15 to 45 degrees, the index of the last quarter is nearer to 1 than to that of
the start, and small discs lie nearer to the core than large ones by a tenth."""

import math
import os
import sys
import tempfile

import states

RADIUS, TURNING, START, SECTORS = 30.0, 0.04, 20.0, 8


def surface_slope(discs):
    """Of the line through the highest discs of strips across the middle of the drum, in degrees."""
    tops = {}
    for disc in discs:
        x, top = disc["x"], disc["y"] + disc["radius"]
        strip = math.floor(x / 3)
        if abs(x) < RADIUS / 2 and top > tops.get(strip, (0, -RADIUS))[1]:
            tops[strip] = (x, top)
    return math.degrees(math.atan(states.slope(*zip(*tops.values()))))


def middle(discs):
    area = sum(disc["radius"] ** 2 for disc in discs)
    return tuple(sum(disc[axis] * disc["radius"] ** 2 for disc in discs) / area for axis in "xy")


def is_small(disc):
    return disc["radius"] < 0.75


def mixing(discs):
    """Lacey's index of sectors."""
    core = middle(discs)
    counts = [[0, 0] for _ in range(SECTORS)]
    for disc in discs:
        angle = math.atan2(disc["y"] - core[1], disc["x"] - core[0]) / (2 * math.pi)
        counts[math.floor(angle * SECTORS) % SECTORS][is_small(disc)] += 1
    share = sum(map(is_small, discs)) / len(discs)
    apart = share * (1 - share)
    found = sum(sum(count) / len(discs) * (count[1] / sum(count) - share) ** 2 for count in counts if sum(count))
    return (apart - found) / (apart - apart / (len(discs) / SECTORS))


def core_ratio(discs):
    core = middle(discs)
    away = []
    for wanted in (True, False):
        part = [math.hypot(d["x"] - core[0], d["y"] - core[1]) for d in discs if is_small(d) == wanted]
        away.append(sum(part) / len(part))
    return away[0] / away[1]


def main():
    hgrid, scene = os.path.abspath(sys.argv[1]), os.path.join(sys.argv[2], "drum.toml")
    with tempfile.TemporaryDirectory() as folder:
        output = os.path.join(folder, "out")
        states.run(hgrid, scene, output)
        pictures = states.pictures(output)
    print("turns  slope  mixed  small/large from the core")
    found = []
    for time, discs in pictures:
        found.append((surface_slope(discs), mixing(discs), core_ratio(discs)))
        print("%5.2f  %5.1f  %5.3f  %.3f" % ((TURNING * (time - START) / (2 * math.pi),) + found[-1]))
    late = found[-len(found) // 4 :]
    slope, mixed, core = (sum(row[k] for row in late) / len(late) for k in (0, 1, 2))
    print("last quarter: slope %.1f degrees, mixed %.3f (at first %.3f), core %.3f" % (slope, mixed, found[0][1], core))
    sys.exit(not (15 < abs(slope) < 45 and 1 - mixed < mixed - found[0][1] and core < 0.9))


if __name__ == "__main__":
    main()
