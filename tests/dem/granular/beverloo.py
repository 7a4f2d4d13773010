#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""The flow out of a silo against Beverloo's law: beverloo.py HGRID SCENES [DIAMETER ...].

Runs scenes/silo.toml with holes of several diameters, counts by time the spheres that are out, and fits
number per time = C sqrt(g) (D - k d)^n. Beverloo, Leniger and van de Velde (1961): n = 5/2, k about 1.4. Exits with 1
if the exponent for k = 1.4 is not within 0.25 of that, or if the mass that flows through the region below the hole is
not within 5 % of what goes out."""

import math
import os
import sys
import tempfile

import states
import stl

RADIUS, WIDTH, K = 1.0, 24.0, 1.4
MASS = 4 * math.pi / 3 * RADIUS**3


def flow(hgrid, scene, diameter, folder):
    """Spheres per time once 20 of them are out, while less than half are; the same by what flows below the hole."""
    floor = os.path.join(folder, "floor-%g.stl" % diameter)
    with open(floor, "w") as out:
        out.write(stl.as_stl(stl.floor_with_hole(WIDTH, diameter)))
    output = os.path.join(folder, "output-%g" % diameter)
    states.run(hgrid, scene, output, ["wall.1.file=" + floor])
    gone = [(float(row["time"]), int(row["count"])) for row in states.table(output, "exchange.csv")]
    passing = {float(row["time"]): -float(row["flow_z"]) / MASS for row in states.table(output, "regions.csv")}
    total = len(states.pictures(output)[0][1])
    used = [(time, count) for time, count in gone if 20 <= count <= 0.5 * total]
    inside = [passing[time] for time, count in used]
    return states.slope(*zip(*used)), sum(inside) / len(inside), len(used)


def main():
    hgrid, scene = os.path.abspath(sys.argv[1]), os.path.join(sys.argv[2], "silo.toml")
    diameters = [float(word) for word in sys.argv[3:]] or [8.0, 10.0, 12.0, 14.0]
    flows, agree = [], True
    with tempfile.TemporaryDirectory() as folder:
        for diameter in diameters:
            rate, passing, rows = flow(hgrid, scene, diameter, folder)
            flows.append(rate)
            agree = agree and abs(passing / rate - 1) < 0.05
            print("D = %4.1f d: %8.2f spheres per time are out, %8.2f pass below the hole (%d rows)" %
                  (diameter / 2 / RADIUS, rate, passing, rows), flush=True)
    d = 2 * RADIUS
    exponent = states.slope([math.log(D - K * d) for D in diameters], [math.log(rate) for rate in flows])
    # W^(2/5) is a straight line in D that ends at k d.
    powers = [rate ** 0.4 for rate in flows]
    steep = states.slope(diameters, powers)
    k = (sum(diameters) / len(diameters) - sum(powers) / len(powers) / steep) / d
    print("exponent of (D - 1.4 d): %.3f (2.5); k of the exponent 5/2: %.2f (1.4)" % (exponent, k))
    sys.exit(abs(exponent - 2.5) > 0.25 or not agree)


if __name__ == "__main__":
    main()
