#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the plots of docs/evidence/benchmarks.md from what hgrid_compare --sweep has written:

    python3 programs/bench/plot/draw.py --output docs/evidence/images size.csv ratio.csv levels.csv threads.csv skin.csv

One picture for each sweep in the files. Bands hold the middle half of the runs.
"""

import argparse
import math
import pathlib

from chart import Line, draw_chart
from measured import in_order, read, system_text

TIME = "ns per particle"
NAMES = {"library": "libhgrid", "plain": "plain hierarchical", "classical": "linked cells"}
COLOURS = {"library": 0, "plain": 2, "classical": 3}
QUIET = 4
PAPER_OVERHEAD = 0.3  # K of Eq. 7


def label(row):
    threads = f", {row.threads:.0f} threads" if row.threads > 1 else ""
    return NAMES.get(row.contestant, row.contestant) + threads


def colour(row):
    return 1 if row.contestant == "library" and row.threads > 1 else COLOURS.get(row.contestant, QUIET)


def point(row, x):
    return (x, row.ns, *row.spread)


def panels_of(rows, title):
    """(title, rows) for each title, in order."""
    return [(name, [r for r in rows if title(r) == name]) for name in in_order(map(title, rows))]


def lines_of(rows, x):
    """A line for each contestant and number of threads."""
    groups = panels_of(rows, lambda r: (r.contestant, r.threads))
    return [Line(label(g[0]), [point(r, x(r)) for r in g], colour(g[0])) for _, g in groups]


def draw_size(rows, path):
    # The largest radius of a small sample stays below the law's: the systems of one law belong together.
    panels = panels_of(rows, lambda r: r.system.replace("-", " "))
    draw_chart(path, [(t, lines_of(g, lambda r: r.particles)) for t, g in panels], "particles N", TIME)


def draw_ratio(rows, path):
    panels = panels_of(rows, lambda r: system_text(r, with_ratio=False))
    lines = [(t, lines_of(g, lambda r: r.size_ratio)) for t, g in panels]
    draw_chart(path, lines, "largest / smallest radius", TIME)


def scaled(rows, cost, name, colour_index):
    """A predicted cost, brought to the measured times by one factor (least squares of the logarithms)."""
    known = [(r.levels, cost(r), r.ns) for r in rows if cost(r)]
    if not known:
        return []
    factor = math.exp(sum(math.log(ns / c) for _, c, ns in known) / len(known))
    return [Line(name, [(levels, factor * c) for levels, c, _ in known], colour_index, dashed=True)]


def paper_cost(row):
    return row.levels * (row.occupancy + PAPER_OVERHEAD) if row.occupancy is not None else None


def draw_levels(rows, path):
    panels = []
    for title, group in panels_of(rows, system_text):
        if len({r.levels for r in group}) < 2:
            continue  # one size has one level
        lines = lines_of(group, lambda r: r.levels)
        library = [r for r in group if r.contestant == "library"]
        plain = [r for r in group if r.contestant == "plain"]
        lines += scaled(library, lambda r: r.predicted_cost, "its cost model", 1)
        lines += scaled(library, paper_cost, "L (m + 0.3)", QUIET)
        lines += scaled(plain, paper_cost, "L (m + 0.3)", QUIET)
        panels.append((title, lines))
    draw_chart(path, panels, "levels L", TIME, x_log=False, whole=True)


def draw_threads(rows, path):
    panels = []
    for title, group in panels_of(rows, system_text):
        group = sorted(group, key=lambda r: r.threads)
        ideal = [(r.threads, group[0].ns * group[0].threads / r.threads) for r in group]
        lines = [Line("libhgrid", [point(r, r.threads) for r in group], 0), Line("ideal", ideal, QUIET, dashed=True)]
        panels.append((title, lines))
    draw_chart(path, panels, "threads", TIME, x_log=False, y_log=False, from_zero=True, whole=True)


def draw_skin(rows, path):
    panels = []
    for title, group in panels_of(rows, system_text):
        group = sorted(group, key=lambda r: r.skin)
        notes = [f"{r.searches_per_step:.2g}" for r in group]
        panels.append((title, [Line("libhgrid", [point(r, r.skin) for r in group], 0, notes=notes)]))
    words = "skin / smallest radius (numbers: searches per step)"
    draw_chart(path, panels, words, "ns per particle and step", x_log=False, y_log=False, from_zero=True)


SWEEPS = {"size": draw_size, "ratio": draw_ratio, "levels": draw_levels, "threads": draw_threads, "skin": draw_skin}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("csv", nargs="+", help="files written by hgrid_compare --sweep NAME --csv FILE")
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("."), help="folder of the pictures")
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)
    rows = [row for row in read(arguments.csv) if row.ns is not None]
    for sweep in in_order(row.sweep for row in rows if row.sweep):
        path = arguments.output / f"{sweep}.svg"
        SWEEPS[sweep]([row for row in rows if row.sweep == sweep], path)
        print(path)


if __name__ == "__main__":
    main()
