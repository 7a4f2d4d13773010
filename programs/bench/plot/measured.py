# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""The CSV files of hgrid_compare and hgrid_dem, read into rows."""

import csv

# Of the contestants, ours first.
TITLES = {
    "library": "libhgrid",
    "plain": "plain hierarchical grid",
    "classical": "classical linked cells",
    "boost-rtree": "Boost rtree",
    "bullet": "Bullet btDbvt",
    "cgal": "CGAL box_intersection_d",
    "embree": "Embree rtcCollide",
    "lammps-bin": "LAMMPS bin",
    "lammps-multi": "LAMMPS multi",
    "nanoflann": "nanoflann by size class",
}
OURS = {"library", "plain", "classical"}

NUMBERS = {
    "size_ratio", "particles", "pairs", "threads", "chosen", "levels", "occupancy", "predicted_cost",
    "candidates_per_particle", "skin", "searches_per_step", "runs", "median_ns_per_particle", "min_ns_per_particle",
    "q1_ns_per_particle", "q3_ns_per_particle", "peak_bytes_per_particle", "processors",
}  # fmt: skip
# Of hgrid_dem, which has no list of pairs.
STEP_NUMBERS = NUMBERS - {"pairs", "peak_bytes_per_particle"} | {
    "collisions_before", "steps", "steps_per_second", "contacts_per_particle", "energy_change",
}  # fmt: skip


class Row:
    """One contestant on one system; fields by name, numbers as float or None."""

    def __init__(self, fields):
        for name, text in fields.items():
            setattr(self, name, (float(text) if text else None) if name in NUMBERS | STEP_NUMBERS else text)

    @property
    def ns(self):
        return self.median_ns_per_particle

    @property
    def spread(self):
        return self.q1_ns_per_particle, self.q3_ns_per_particle


def read(paths, numbers=frozenset(NUMBERS), program="hgrid_compare"):
    """All rows that were measured through; a file that is no CSV of the program is an error."""
    rows = []
    for path in paths:
        with open(path, encoding="utf-8", newline="") as file:
            reader = csv.DictReader(file)
            missing = (numbers | {"sweep", "system", "contestant", "verdict"}) - set(reader.fieldnames or ())
            if missing:
                raise SystemExit(f"{path}: not written by {program}, no column {', '.join(sorted(missing))}")
            rows += [Row(fields) for fields in reader]
    return [row for row in rows if row.chosen]


def in_order(values):
    """The different ones, in the order of their first appearance."""
    return list(dict.fromkeys(values))


def system_text(row, with_ratio=True):
    ratio = f", ratio {row.size_ratio:.0f}" if with_ratio and row.size_ratio > 1 else ""
    count = f"{row.particles:,.0f}".replace(",", "\u202f")
    return f"{row.system.replace('-', ' ')}{ratio}, N = {count}"
