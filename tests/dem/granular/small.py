#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes that take long show on a small scale what they must: small.py HGRID SCENES. Each check says what; exits with 1
if one fails."""

import os
import sys
import tempfile

import drum_regimes
import states


def compression(run):
    """The plane comes to bear its force, in either stage."""
    out = run("compression", "particles.1.lattice.counts=[5,5,12]", "box.max=[10.5,10.5,40]", "stage.2.wall.force=5e3",
              "stage.3.wall.force=1e4")
    rows = states.table(out, "walls.csv")
    borne = [-float(max((row for row in rows if float(row["time"]) <= end), key=lambda row: float(row["time"]))["force_z"])
             for end in (55, 75)]
    print("compression: the plane bears %.2f (5000), then %.2f (10000)" % tuple(borne))
    return abs(borne[0] / 5e3 - 1) < 1e-3 and abs(borne[1] / 1e4 - 1) < 1e-3


def sedimentation(run):
    """Large ones sink first and lie below; at rest overlaps are below 1 % of the smaller radius."""
    out = run("sedimentation", "particles.1.pack.ratio=5", "particles.1.pack.count=630")
    discs = states.pictures(out)[-1][1]
    heights = [[disc["z"] for disc in discs if (disc["radius"] > 2) == large] for large in (True, False)]
    large, small = (sum(of) / len(of) for of in heights)
    end = states.table(out, "energy.csv")[-1]
    overlap, kinetic = float(end["largest_overlap"]), float(end["translation"]) / abs(float(end["gravity"]))
    print("sedimentation: large at %.2f, small at %.2f, overlap %.4f, kinetic %.1e of the potential energy" %
          (large, small, overlap, kinetic))
    return large < 0.95 * small and overlap < 0.01 and kinetic < 1e-3


def paper(run, name):
    """No overlaps at first, and the energy stays; less dense, since growth to the density of the paper takes long."""
    out = run(name, "particles.1.pack.count=1000", "particles.1.pack.fraction=0.5", *(["particles.1.pack.ratio=5"] if name != "paper-mono" else []))
    rows = states.table(out, "energy.csv")
    energies = [float(row["energy"]) for row in rows]
    drift = max(abs(energy / energies[0] - 1) for energy in energies)
    print("%s: contact energy at first %s, energy within %.1e" % (name, rows[0]["contact"], drift))
    return float(rows[0]["contact"]) == 0 and drift < 1e-3 and int(rows[-1]["contacts"]) > 0


def drum(hgrid, folder):
    """At Froude number 2 teeth take the bed round with the drum within two turns; a drum without them does not."""
    found = [drum_regimes.turn(hgrid, folder, 2.0, 2, tooth) for tooth in (1.0, 0.0)]
    regimes = [drum_regimes.regime(flight, speed, slope) for flight, speed, _, slope, _ in found]
    print("drum: goes round at %.3f of its speed (%s), without teeth at %.3f (%s)" %
          (found[0][1], regimes[0], found[1][1], regimes[1]))
    return regimes[0] == "centrifuging" != regimes[1]


def main():
    hgrid, scenes = os.path.abspath(sys.argv[1]), sys.argv[2]
    with tempfile.TemporaryDirectory() as folder:

        def run(name, *settings):
            out = os.path.join(folder, name)
            states.run(hgrid, os.path.join(scenes, name + ".toml"), out, settings)
            return out

        good = [compression(run), sedimentation(run)]
        good += [paper(run, "paper-" + law) for law in ("mono", "two-sizes", "uniform-size", "uniform-volume")]
        good.append(drum(hgrid, folder))
    sys.exit(not all(good))


if __name__ == "__main__":
    main()
