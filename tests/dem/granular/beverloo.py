#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""The flow out of a silo against Beverloo's law: beverloo.py HGRID SCENES [DIAMETER ...].

Runs scenes/silo.toml with holes of several diameters, counts the spheres below the floor by time, and fits
number per time = C sqrt(g) (D - k d)^n. Beverloo, Leniger and van de Velde (1961): n = 5/2, k about 1.4. Exits with 1
if the exponent for k = 1.4 is not within 0.25 of that."""

import glob
import math
import os
import subprocess
import sys
import tempfile

import stl

RADIUS, WIDTH, K = 1.0, 24.0, 1.4


def flow(hgrid, scene, diameter, folder):
    """Spheres per time, from a tenth to a half of them having left."""
    with open(os.path.join(folder, "silo-floor.stl"), "w") as out:
        out.write(stl.as_stl(stl.floor_with_hole(WIDTH, diameter)))
    path = os.path.join(folder, "silo.toml")
    with open(path, "w") as out:
        out.write(scene.replace("[stage.output]", '[output]\nformats = ["csv"]\n[stage.output]'))
    output = os.path.join(folder, "output-%g" % diameter)
    subprocess.run([hgrid, "run", path, "--quiet", "--output", output], check=True, stdout=subprocess.DEVNULL)
    times, below = [], []
    for name in sorted(glob.glob(output + "/state-*.csv")):
        with open(name) as table:
            lines = table.read().split("\n")
        head = next(k for k, line in enumerate(lines) if not line.startswith("#"))
        z = lines[head].split(",").index("z")
        heights = [float(line.split(",")[z]) for line in lines[head + 1 :] if line]
        times.append(time_of(lines))
        below.append(sum(height < -RADIUS for height in heights))
    total = len(heights)
    used = [k for k, count in enumerate(below) if 0.1 * total <= count <= 0.5 * total]
    if len(used) < 4:
        used = [k for k, count in enumerate(below) if 0 < count <= 0.5 * total][3:]
    return slope([times[k] for k in used], [below[k] for k in used]), len(used)


def time_of(lines):
    return next(float(line.split("time:")[1].split()[0]) for line in lines if line.startswith("# step:"))


def slope(x, y):
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x)


def main():
    hgrid, scenes = os.path.abspath(sys.argv[1]), sys.argv[2]
    diameters = [float(word) for word in sys.argv[3:]] or [8.0, 10.0, 12.0, 14.0]
    with open(os.path.join(scenes, "silo.toml")) as source:
        scene = source.read()
    flows = []
    with tempfile.TemporaryDirectory() as folder:
        for diameter in diameters:
            rate, pictures = flow(hgrid, scene, diameter, folder)
            flows.append(rate)
            print("D = %4.1f d: %8.2f spheres per time (%d pictures)" % (diameter / 2 / RADIUS, rate, pictures), flush=True)
    d = 2 * RADIUS
    exponent = slope([math.log(D - K * d) for D in diameters], [math.log(rate) for rate in flows])
    # W^(2/5) is a straight line in D that ends at k d.
    powers = [rate ** 0.4 for rate in flows]
    steep = slope(diameters, powers)
    k = (sum(diameters) / len(diameters) - sum(powers) / len(powers) / steep) / d
    print("exponent of (D - 1.4 d): %.3f (2.5); k of the exponent 5/2: %.2f (1.4)" % (exponent, k))
    sys.exit(abs(exponent - 2.5) > 0.25)


if __name__ == "__main__":
    main()
