# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""What grids and histories tell: named tuples, those about grids with the fields of the C structs of that name."""

from collections import namedtuple

Level = namedtuple("Level", "cell_size largest_radius occupancy particle_count")
Level.__doc__ = """One level of the hierarchical grid.

cell_size: edge of its cells, length. largest_radius: of the particles on the level, 0 if it is empty. occupancy:
particles per cell. particle_count: particles on the level."""

LevelCost = namedtuple("LevelCost", "level_count reachable occupancy cost")
LevelCost.__doc__ = """What the level rule expects of a number of levels.

reachable: 0 if the sizes cannot be split into that many levels (occupancy and cost are then 0), else 1. occupancy: the
largest of its levels'. cost: per particle, in units of one pair test."""

Stats = namedtuple(
    "Stats",
    "particle_count level_count row_count cell_count candidate_count undecided_count exact_count pair_count "
    "build_count search_count byte_count filter_count stored_count",
)
Stats.__doc__ = """Counters of a grid: as built, and of the last search or filtering (0 before the first).

particle_count: live particles. level_count, row_count, cell_count: levels, rows of cells and cells stored.
candidate_count: pairs tested; undecided_count: of these, too near to touching for the fast test; exact_count: of these,
too near even for double arithmetic. pair_count: pairs found. build_count, search_count: builds and searches of all
pairs since the grid was made. byte_count: memory that the grid holds, results included. filter_count: times stored
candidates were filtered instead of a search; stored_count: candidates stored now, 0 without a skin."""

Ended = namedtuple("Ended", "pairs places")
Ended.__doc__ = """Contacts that are no more.

pairs: as they stood in the list before, shape (k, 2) or (k, 3). places: in that list, int64 of shape (k,)."""


def record(kind, struct):
    """The named tuple `kind` from a C struct with the same fields."""
    return kind._make(getattr(struct, field) for field in kind._fields)
