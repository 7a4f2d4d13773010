#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Times SciPy's cKDTree and the package hgrid on what hgrid_queries times: many spheres among equal ones at random
places. Needs both on the path of Python: PYTHONPATH=build/bindings/swig/python queries.py [--csv FILE]."""

import argparse
import csv
import time

COLUMNS = (
    "search particles spheres density radius periodic skin threads hits_per_sphere median_us min_us processor_us "
    "min_processor_us runs"
).split()


def parse():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=100000, help="number of particles")
    parser.add_argument("--spheres", type=int, default=20000, help="number of queries")
    parser.add_argument("--density", type=float, default=0.5, help="volume of the particles over that of the cube")
    parser.add_argument("--radius", type=float, default=1.0, help="of the queries, in radii of particles")
    parser.add_argument("--threads", type=int, default=1, help="of grid and tree")
    parser.add_argument("--runs", type=int, default=7, help="how often all are timed")
    parser.add_argument("--csv", help="where to write the measurements")
    return parser.parse_args()


def main():
    options = parse()
    # What --help does not need may be absent.
    import numpy as np
    import scipy
    from scipy.spatial import cKDTree

    import hgrid

    rng = np.random.default_rng(1)
    edge = (4 / 3 * np.pi * options.count / options.density) ** (1 / 3)
    x, queries = edge * rng.random((options.count, 3)), edge * rng.random((options.spheres, 3))
    radii = np.full(options.spheres, options.radius)
    tree, grid = cKDTree(x), hgrid.Grid(thread_count=options.threads)
    grid.insert(x, np.ones(options.count))
    grid.query_pairs()

    def ask_tree():
        rows = tree.query_ball_point(queries, 1 + options.radius, workers=options.threads, return_sorted=True)
        return sum(map(len, rows))

    contestants = {
        "hgrid.query_spheres": lambda: len(grid.query_spheres(queries, radii)[1]),
        "hgrid.query_sphere, one by one": lambda: sum(len(grid.query_sphere(q, options.radius)) for q in queries),
        f"SciPy {scipy.__version__} cKDTree.query_ball_point": ask_tree,
    }
    times = {name: ([], []) for name in contestants}
    hits = {}
    for _ in range(options.runs):  # in turns, so that all see the same machine
        for name, ask in contestants.items():
            start, processor = time.perf_counter(), time.process_time()
            hits[name] = ask()
            wall, used = time.perf_counter() - start, time.process_time() - processor
            for measured, seconds in zip(times[name], (wall, used)):
                measured.append(1e6 * seconds / options.spheres)
    if len(set(hits.values())) != 1:
        raise SystemExit(f"they find different numbers of particles: {hits}")
    rows = []
    for name, (wall, used) in times.items():
        found = hits[name] / options.spheres
        print(
            f"{name:40} {np.median(wall):8.3f} us each, {np.median(used):8.3f} of processors, {min(used):8.3f} at best, "
            f"{found:g} hits"
        )
        rows.append(
            [name, options.count, options.spheres, options.density, options.radius, 0, 0, options.threads, found]
            + [np.median(wall), min(wall), np.median(used), min(used), options.runs]
        )
    if options.csv:
        with open(options.csv, "w", newline="") as file:
            writer = csv.writer(file)
            writer.writerow(COLUMNS)
            writer.writerows(rows)


if __name__ == "__main__":
    main()
