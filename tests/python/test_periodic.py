# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Periodic axes, in any mix, against brute force over nearest images in exact arithmetic."""

import itertools
import unittest

import numpy as np
from oracle import ascending, dyadic, exact_pairs, polydisperse

import hgrid

BOX = ((0.0, 0.0, 0.0), (1.0, 1.0, 1.0))


def pairs_of(x, r, **options):
    with hgrid.Grid(**options) as grid:
        grid.insert(x, r)
        return ascending(grid.query_pairs())


class Periodic(unittest.TestCase):
    def test_every_mix_of_axes(self):
        x, r = polydisperse(21, 200, ratio=40.0)
        for periodic in itertools.product((False, True), repeat=3):
            with self.subTest(seed=21, periodic=periodic):
                wanted = exact_pairs(x, r, box=BOX, periodic=periodic)
                np.testing.assert_array_equal(pairs_of(x, r, periodic=periodic, box=BOX), wanted)

    def test_periodic_axes_add_pairs(self):
        x, r = polydisperse(21, 200, ratio=40.0)
        periodic = (True, True, True)
        self.assertGreater(len(pairs_of(x, r, periodic=periodic, box=BOX)), len(pairs_of(x, r)))

    def test_plane(self):
        x, r = polydisperse(22, 250, dimension=2, ratio=40.0)
        box = ((0.0, 0.0), (1.0, 1.0))
        for periodic in itertools.product((False, True), repeat=2):
            with self.subTest(seed=22, periodic=periodic):
                wanted = exact_pairs(x, r, box=box, periodic=periodic)
                np.testing.assert_array_equal(pairs_of(x, r, dimension=2, periodic=periodic, box=box), wanted)

    def test_positions_outside_the_box_are_wrapped(self):
        rng = np.random.default_rng(23)
        x, r = polydisperse(23, 200, ratio=40.0)
        x, r = dyadic(x), dyadic(r)
        moved = x + rng.integers(-3, 4, x.shape)
        periodic = (True, True, True)
        wanted = exact_pairs(x, r, box=BOX, periodic=periodic)
        np.testing.assert_array_equal(pairs_of(moved, r, periodic=periodic, box=BOX), wanted)

    def test_touching_across_the_boundary_is_no_pair(self):
        x = [[0.125, 0.5, 0.5], [0.875, 0.5, 0.5]]
        options = dict(periodic=(True, False, False), box=BOX)
        self.assertEqual(len(pairs_of(x, [0.125, 0.125], **options)), 0)
        self.assertEqual(len(pairs_of(x, [0.125, np.nextafter(0.125, 1)], **options)), 1)

    def test_box_away_from_the_origin(self):
        shift = np.array([-5.0, 8.0, 100.0])
        x, r = polydisperse(24, 150, ratio=40.0)
        x, r = dyadic(x) + shift, dyadic(r)
        box = (shift, shift + 1)
        periodic = (True, False, True)
        wanted = exact_pairs(x, r, box=box, periodic=periodic)
        np.testing.assert_array_equal(pairs_of(x, r, periodic=periodic, box=box), wanted)


if __name__ == "__main__":
    unittest.main()
