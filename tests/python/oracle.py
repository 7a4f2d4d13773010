# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Every pair by brute force in exact integer arithmetic, and random particle sets."""

from fractions import Fraction

import numpy as np


def _scaled(values, scale):
    """The doubles times `scale`, a power of two that makes all of them integers, as Python integers."""
    flat = [int(Fraction(float(value)) * scale) for value in np.ravel(values)]
    return np.array(flat, dtype=object).reshape(np.shape(values))


def _common_scale(*arrays):
    return max(Fraction(float(value)).denominator for array in arrays for value in np.ravel(array))


def _cell(corners, tilt):
    """The edges of the periodic cell, one a row."""
    edges = np.zeros((len(corners[0]), len(corners[0])), dtype=object)
    np.fill_diagonal(edges, corners[1] - corners[0])
    edges[np.tril_indices(len(edges), -1)] = tilt[: len(edges) * (len(edges) - 1) // 2]
    return edges


def _images(gap, cell, periodic, around):
    """The gaps to the images up to `around` edges of each periodic axis beyond the one that rounding finds."""
    gaps = [gap]
    for axis in np.flatnonzero(periodic)[::-1]:
        length = cell[axis, axis]
        nearest = [-((2 * g[:, axis] + length) // (2 * length)) for g in gaps]
        steps = range(-around[axis], around[axis] + 1)
        gaps = [g + np.outer(n + k, cell[axis]) for g, n in zip(gaps, nearest) for k in steps]
    return gaps


def exact_pairs(
    x,
    r,
    margin=0.0,
    rule="contact",
    box=None,
    periodic=None,
    base=0,
    tilt=None,
    touching=False,
    images="nearest",
):
    """The pairs that real arithmetic on these doubles gives, as an int32 array in ascending (a, b)."""
    x, r = np.asarray(x, dtype=float), np.asarray(r, dtype=float)
    dimension = x.shape[1]
    corners = np.zeros((2, dimension)) if box is None else np.asarray(box, dtype=float)
    lean = np.zeros(3) if tilt is None else np.asarray(tilt, dtype=float)
    scale = _common_scale(x, r, [margin], corners, lean, [1.0])
    x, r, margin = _scaled(x, scale), _scaled(r, scale), int(Fraction(margin) * scale)
    cell = _cell(_scaled(corners, scale), _scaled(lean, scale))
    periodic = np.zeros(dimension) if periodic is None else periodic
    around = [0] * dimension
    if images == "all" or np.any(lean):
        farthest = 2 * max(r, default=0) + margin
        around = [farthest // cell[axis, axis] + 1 if periodic[axis] else 0 for axis in range(dimension)]

    def in_reach(a, others):
        """For each image, which of the others are in reach of a."""
        reach = (np.maximum(r[others], r[a]) if rule == "max_range" else r[others] + r[a]) + margin
        for gap in _images(x[others] - x[a], cell, periodic, around):
            square = (gap * gap).sum(axis=1)
            yield (square <= reach**2 if touching else square < reach**2).astype(bool)

    found = []
    for a in range(len(r)):
        others = np.arange(a + 1, len(r))
        meetings = sum(in_reach(a, others), np.zeros(len(others), dtype=int))
        if images == "all":
            # Itself at no distance is no pair, and two opposite images are one.
            found += [(a + base, a + base)] * ((sum(int(met[0]) for met in in_reach(a, np.array([a]))) - 1) // 2)
        else:
            meetings = np.minimum(meetings, 1)
        found += [(a + base, b + base) for b, times in zip(others, meetings) for _ in range(times)]
    return np.array(found, dtype=np.int32).reshape(-1, 2)


def ascending(pairs):
    """The same pairs in ascending (a, b)."""
    return pairs[np.lexsort((pairs[:, 1], pairs[:, 0]))]


def polydisperse(seed, count, dimension=3, ratio=100.0, edge=1.0, largest=0.15):
    """Centres in a box [0, edge)^dimension and radii spread evenly in log(r) over a factor of `ratio`."""
    rng = np.random.default_rng(seed)
    x = edge * rng.random((count, dimension))
    r = largest * edge * ratio ** (-rng.random(count))
    return x, r


def dyadic(values, bits=20):
    """The values rounded to multiples of 2^-bits, so that sums and squares of them are exact in doubles too."""
    return np.round(np.asarray(values) * 2.0**bits) / 2.0**bits
