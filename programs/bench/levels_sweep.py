#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Compares the number of levels that the library chooses with the best one found by a sweep, on many size laws and
arrangements: levels_sweep.py HGRID FOLDER. Packings are made in FOLDER once and kept."""

import argparse
import csv
import os
import pathlib
import subprocess
import sys

RELAXED = ["--sweeps", "30"]
# Particles laid onto each other overlap more than any packing; less dense ones have contacts in usual numbers.
LAID = ["--density", "0.2"]
SYSTEMS = {
    "mono": ["--law", "mono"],
    "two-sizes-10": ["--law", "two-sizes"],
    "uniform-size-50": ["--law", "uniform-size"],
    "uniform-volume-10": ["--law", "uniform-volume", "--ratio", "10"],
    "uniform-volume-50": ["--law", "uniform-volume"],
    "log-normal-0.3": ["--law", "log-normal", "--sigma", "0.3", *RELAXED],
    "log-normal-1": ["--law", "log-normal", "--sigma", "1", *RELAXED],
    "power-law-2": ["--law", "power-law", "--exponent", "2", *RELAXED],
    "power-law-3": ["--law", "power-law", "--exponent", "3", "--ratio", "100", *RELAXED],
    "power-law-4": ["--law", "power-law", "--exponent", "4", *RELAXED],
    "power-law-5": ["--law", "power-law", "--exponent", "5", *RELAXED],
    "one-giant-30": ["--law", "one-giant", "--ratio", "30", *RELAXED],
    "clusters-mono": ["--arrangement", "clusters", "--law", "mono", *LAID],
    "clusters-uv-10": ["--arrangement", "clusters", "--ratio", "10", *LAID],
    "film-mono": ["--arrangement", "film", "--law", "mono", *LAID],
    "film-uv-10": ["--arrangement", "film", "--ratio", "10", *LAID],
    "shell-uv-10": ["--arrangement", "shell", "--ratio", "10", *LAID],
    "crowd-mono": ["--arrangement", "crowd", "--law", "mono", *LAID],
    "crowd-uv-10": ["--arrangement", "crowd", "--ratio", "10", *LAID],
}


def packing_of(options, name):
    """The file of a system, made if it is not there."""
    path = options.folder / f"{name}-{options.count}.csv"
    if not path.exists():
        command = [options.hgrid, "pack", "--count", str(options.count), *SYSTEMS[name], "--output", str(path)]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return path


def sweep(options, path, isa):
    """Runs hgrid bench; returns the rows asked for and the row chosen."""
    table = options.folder / "sweep.csv"
    command = [options.hgrid, "bench", str(path), "--most-levels", str(options.most_levels), "--csv", str(table)]
    command += ["--repeats", str(options.repeats), "--seconds", str(options.seconds)]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, env={**os.environ, "HGRID_ISA": isa})
    with open(table, newline="") as file:
        rows = list(csv.DictReader(file))
    return [row for row in rows if row["rule"] == "asked"], next(row for row in rows if row["rule"] == "chosen")


def print_system(name, isa, asked, chosen):
    """One line; returns the time chosen over the best."""
    time = lambda row: float(row["median_ns_per_particle"])
    best = min(asked, key=time)
    ratio = time(chosen) / time(best)
    print(f"| {name} | {isa} | {time(asked[0]):.0f} | {best['levels']} | {time(best):.1f} | {chosen['levels']} | "
          f"{time(chosen):.1f} | {ratio:.3f} |", flush=True)
    return ratio


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("hgrid", help="the command hgrid")
    parser.add_argument("folder", type=pathlib.Path, help="where packings are kept")
    parser.add_argument("--count", type=int, default=125000, help="particles of each packing (125000)")
    parser.add_argument("--systems", default=",".join(SYSTEMS), help="names with commas (all)")
    parser.add_argument("--isa", default="avx512,avx2,sse2", help="instruction sets with commas (avx512,avx2,sse2)")
    parser.add_argument("--most-levels", type=int, default=8, help="largest number of levels tried (8)")
    parser.add_argument("--repeats", type=int, default=9, help="runs per number of levels; the median counts (9)")
    parser.add_argument("--seconds", type=float, default=1, help="a row that has taken so long is not run again (1)")
    parser.add_argument("--make-only", action="store_true", help="make the packings, time nothing")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    names = options.systems.split(",")
    paths = {name: packing_of(options, name) for name in names}
    if options.make_only:
        return 0
    print("| system | ISA | one level | best L | ns per particle | L chosen | ns per particle | chosen / best |")
    print("|---|---|---|---|---|---|---|---|")
    worst = 0
    for isa in options.isa.split(","):
        for name in names:
            worst = max(worst, print_system(name, isa, *sweep(options, paths[name], isa)))
    print(f"\nworst: {worst:.3f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
