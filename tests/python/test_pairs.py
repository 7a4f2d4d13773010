# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pairs in open space against brute force in exact arithmetic, through all changes of the particle set."""

import unittest

import numpy as np
from oracle import ascending, exact_pairs, polydisperse

import hgrid


def pairs_of(x, r, **options):
    with hgrid.Grid(**options) as grid:
        grid.insert(x, r)
        return grid.query_pairs()


class Pairs(unittest.TestCase):
    def check(self, found, wanted):
        self.assertEqual(found.dtype, np.int32)
        np.testing.assert_array_equal(ascending(found), wanted)

    def test_random_sets_of_all_size_ratios(self):
        for seed, ratio in enumerate((1.0, 3.0, 50.0, 1e3, 1e6)):
            with self.subTest(seed=seed, ratio=ratio):
                x, r = polydisperse(seed, 250, ratio=ratio)
                wanted = exact_pairs(x, r)
                self.assertGreater(len(wanted), 0)
                self.check(pairs_of(x, r), wanted)

    def test_clusters_far_from_the_origin(self):
        for seed in range(3):
            with self.subTest(seed=seed):
                x, r = polydisperse(seed, 200, ratio=1e3)
                x[::2] += 1e7
                x[::5] -= 3e8
                self.check(pairs_of(x, r), exact_pairs(x, r))

    def test_touching_is_no_pair_and_one_bit_less_is(self):
        x = np.array([[0.0, 0.0, 0.0], [3.0, 4.0, 0.0]])
        self.assertEqual(len(pairs_of(x, [2.5, 2.5])), 0)
        self.assertEqual(len(pairs_of(x, [2.5, np.nextafter(2.5, 3)])), 1)
        x[1, 0] = np.nextafter(3.0, 0)
        self.assertEqual(len(pairs_of(x, [2.5, 2.5])), 1)

    def test_pairs_within_rounding_of_touching(self):
        rng = np.random.default_rng(11)
        x = rng.random((120, 3))
        x[60:] = x[:60] + 0.02 * rng.standard_normal((60, 3))
        half = np.sqrt(((x[60:] - x[:60]) ** 2).sum(axis=1)) / 2
        r = np.concatenate([half, half])
        self.check(pairs_of(x, r), exact_pairs(x, r))

    def test_margin(self):
        x, r = polydisperse(3, 200, ratio=30.0)
        wanted = exact_pairs(x, r, margin=0.03)
        self.assertGreater(len(wanted), len(exact_pairs(x, r)))
        self.check(pairs_of(x, r, margin=0.03), wanted)

    def test_max_range(self):
        x, r = polydisperse(4, 200, ratio=30.0)
        wanted = exact_pairs(x, r, rule="max_range", margin=0.01)
        self.check(pairs_of(x, r, interaction="max_range", margin=0.01), wanted)

    def test_order_by_id_needs_no_sorting(self):
        x, r = polydisperse(5, 250)
        np.testing.assert_array_equal(pairs_of(x, r, order="id"), exact_pairs(x, r))

    def test_grid_order_is_reproducible(self):
        x, r = polydisperse(6, 250)
        np.testing.assert_array_equal(pairs_of(x, r, thread_count=1), pairs_of(x, r, thread_count=2))

    def test_ids_count_from_index_base(self):
        x, r = polydisperse(7, 150)
        self.check(pairs_of(x, r, index_base=1), exact_pairs(x, r, base=1))

    def test_insert_move_remove_clear(self):
        x, r = polydisperse(8, 240)
        other_x, other_r = polydisperse(9, 240)
        with hgrid.Grid() as grid:
            grid.insert(x[:100], r[:100])
            grid.query_pairs()
            grid.insert(x[100:], r[100:])
            self.check(grid.query_pairs(), exact_pairs(x, r))
            grid.move(other_x)
            self.check(grid.query_pairs(), exact_pairs(other_x, r))
            grid.move(x, other_r)
            self.check(grid.query_pairs(), exact_pairs(x, other_r))
            gone = np.arange(0, 240, 3)
            kept = np.setdiff1d(np.arange(240), gone)
            grid.remove(gone)
            self.check(grid.query_pairs(), kept[exact_pairs(x[kept], other_r[kept])])
            grid.insert(other_x[:10], other_r[:10])
            ids = np.concatenate([kept, np.arange(240, 250)])
            all_x, all_r = np.concatenate([x[kept], other_x[:10]]), np.concatenate([other_r[kept], other_r[:10]])
            self.check(grid.query_pairs(), ids[exact_pairs(all_x, all_r)])
            grid.clear()
            self.assertEqual(grid.query_pairs().shape, (0, 2))
            grid.insert(x, r)
            self.check(grid.query_pairs(), exact_pairs(x, r))

    def test_few_particles(self):
        self.assertEqual(pairs_of(np.empty((0, 3)), []).shape, (0, 2))
        self.assertEqual(pairs_of([[1, 2, 3]], [5]).shape, (0, 2))
        self.assertEqual(pairs_of([[1, 2, 3], [1, 2, 3]], [0, 0]).shape, (0, 2))
        np.testing.assert_array_equal(pairs_of([[1, 2, 3], [1, 2, 3]], [0, 1]), [[0, 1]])


if __name__ == "__main__":
    unittest.main()
