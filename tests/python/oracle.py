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


def exact_pairs(x, r, margin=0.0, rule="contact", box=None, periodic=None, base=0):
    """The pairs that real arithmetic on these doubles gives, as an int32 array in ascending (a, b)."""
    x, r = np.asarray(x, dtype=float), np.asarray(r, dtype=float)
    corners = np.zeros((2, x.shape[1])) if box is None else np.asarray(box, dtype=float)
    scale = _common_scale(x, r, [margin], corners, [1.0])
    x, r, corners = _scaled(x, scale), _scaled(r, scale), _scaled(corners, scale)
    margin = int(Fraction(margin) * scale)
    found = []
    for a in range(len(r) - 1):
        gap = abs(x[a + 1 :] - x[a])
        for axis in np.flatnonzero(periodic if periodic is not None else []):
            length = corners[1, axis] - corners[0, axis]
            turned = gap[:, axis] % length
            gap[:, axis] = np.minimum(turned, length - turned)
        reach = np.maximum(r[a + 1 :], r[a]) if rule == "max_range" else r[a + 1 :] + r[a]
        near = (gap * gap).sum(axis=1) < (reach + margin) ** 2
        found += [(a + base, a + 1 + k + base) for k in np.flatnonzero(near.astype(bool))]
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
