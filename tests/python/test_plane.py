# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Discs in the plane: brute force in exact arithmetic and counts known in closed form."""

import unittest

import numpy as np
from oracle import ascending, exact_pairs, polydisperse

import hgrid


def pairs_of(x, r, **options):
    with hgrid.Grid(dimension=2, **options) as grid:
        grid.insert(x, r)
        return ascending(grid.query_pairs())


class Plane(unittest.TestCase):
    def test_random_discs(self):
        for seed, ratio in ((31, 1.0), (32, 100.0), (33, 1e6)):
            with self.subTest(seed=seed, ratio=ratio):
                x, r = polydisperse(seed, 300, dimension=2, ratio=ratio, largest=0.1)
                np.testing.assert_array_equal(pairs_of(x, r), exact_pairs(x, r))

    def test_square_lattice(self):
        n = 12
        x = np.array([(i, j) for i in range(n) for j in range(n)])
        self.assertEqual(len(pairs_of(x, np.full(n * n, 0.5))), 0)
        self.assertEqual(len(pairs_of(x, np.full(n * n, 0.6))), 2 * n * (n - 1))
        periodic = dict(periodic=(True, True), box=((0, 0), (n, n)))
        self.assertEqual(len(pairs_of(x, np.full(n * n, 0.6), **periodic)), 2 * n * n)

    def test_points_in_a_circle(self):
        # Gauss: 81 lattice points have i^2 + j^2 <= 25; 12 of them lie on the circle and only touch.
        lattice = np.array([(i, j) for i in range(-8, 9) for j in range(-8, 9)])
        x = np.concatenate([lattice, [(0, 0)]])
        r = np.concatenate([np.full(len(lattice), 0.125), [4.875]])
        self.assertEqual(len(pairs_of(x, r)), 81 - 12)

    def test_dimension_is_told(self):
        self.assertEqual(hgrid.Grid(dimension=2).dimension, 2)
        self.assertEqual(hgrid.Grid().dimension, 3)


if __name__ == "__main__":
    unittest.main()
