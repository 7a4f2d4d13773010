#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""One table of what programs/bench/worlds.sh has measured, as CSV on standard output: worlds_csv.py NAME.measured.csv ...

Each file holds the world NAME and, if it has one, its reference. All times are medians in ns per particle. What a program
could not do stands in its column in words; LAMMPS multi takes no part where all sizes are one."""

import argparse
import csv
import pathlib
import sys

from measured import OURS, TITLES, read

OTHERS = [name for name in TITLES if name != "library"]
HEAD = ["world", "particles", "size_ratio", "pairs", "ns", "reference", "reference_ns", "ratio"]
FASTEST = ["fastest_peer", "peer_ns", "peer_ratio"]
WHERE = ["machine", "processors", "compiler", "commit"]


def time_or_reason(rows, name):
    """Of a contestant: the fastest of its settings, else why it has none."""
    own = [row for row in rows if row.contestant == name]
    done = [row for row in own if row.ns is not None and row.verdict == "same pairs"]
    if done:
        return min(row.ns for row in done)
    return own[0].verdict if own else "took no part"


def library_row(rows, path):
    found = [row for row in rows if row.contestant == "library"]
    if len(found) != 1 or found[0].verdict != "same pairs":
        raise SystemExit(f"{path}: the library must be there once, with the same pairs")
    return found[0]


def line_of(path):
    name = path.name.removesuffix(".measured.csv")
    rows = read([path])
    own, others = [r for r in rows if r.system == name], [r for r in rows if r.system != name]
    world = library_row(own, path)
    reference = library_row(others, path) if others else None
    times = {who: time_or_reason(own, who) for who in OTHERS}
    done = {who: time for who, time in times.items() if who not in OURS and not isinstance(time, str)}
    fastest = min(done, key=done.get, default="")
    line = [name, f"{world.particles:.0f}", f"{world.size_ratio:.4g}", f"{world.pairs:.0f}", f"{world.ns:.1f}"]
    line += [reference.system, f"{reference.ns:.1f}", f"{world.ns / reference.ns:.3f}"] if reference else [""] * 3
    line += [fastest, f"{done[fastest]:.1f}", f"{done[fastest] / world.ns:.2f}"] if fastest else [""] * 3
    line += [time if isinstance(time, str) else f"{time:.1f}" for time in times.values()]
    return line + [world.machine, f"{world.processors:.0f}", world.compiler, world.commit]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("csv", nargs="+", type=pathlib.Path, help="files of worlds.sh")
    out = csv.writer(sys.stdout, lineterminator="\n")
    lines = [line_of(path) for path in parser.parse_args().csv]
    out.writerow(HEAD + FASTEST + OTHERS + WHERE)
    out.writerows(lines)


if __name__ == "__main__":
    main()
