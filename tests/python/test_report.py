# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""What a grid tells about itself, the version, and that everything public is explained."""

import inspect
import unittest

from oracle import exact_pairs, polydisperse

import hgrid


class Report(unittest.TestCase):
    def setUp(self):
        self.x, self.r = polydisperse(101, 500, ratio=200.0, largest=0.1)
        self.grid = hgrid.Grid()
        self.addCleanup(self.grid.close)
        self.grid.insert(self.x, self.r)

    def test_levels(self):
        levels = self.grid.levels
        self.assertIsInstance(levels[0], hgrid.Level)
        self.assertEqual(sum(level.particle_count for level in levels), 500)
        self.assertEqual(max(level.largest_radius for level in levels), self.r.max())
        sizes = [level.cell_size for level in levels]
        self.assertEqual(sizes, sorted(sizes))
        self.assertGreaterEqual(sizes[-1], 2 * self.r.max())

    def test_level_costs(self):
        costs = self.grid.level_costs
        self.assertIsInstance(costs[0], hgrid.LevelCost)
        self.assertEqual([cost.level_count for cost in costs], list(range(1, len(costs) + 1)))
        self.assertTrue(costs[0].reachable)
        self.assertGreater(costs[0].cost, 0)

    def test_no_level_costs_for_given_cells(self):
        with hgrid.Grid(cell_sizes=[0.2]) as grid:
            grid.insert(self.x, self.r)
            self.assertEqual(grid.level_costs, [])

    def test_stats(self):
        self.assertEqual(self.grid.stats.particle_count, 500)
        pairs = self.grid.query_pairs()
        stats = self.grid.stats
        self.assertIsInstance(stats, hgrid.Stats)
        self.assertEqual(stats.pair_count, len(pairs))
        self.assertEqual(stats.pair_count, len(exact_pairs(self.x, self.r)))
        self.assertGreaterEqual(stats.candidate_count, stats.pair_count)
        self.assertEqual(stats.level_count, len(self.grid.levels))
        self.assertGreaterEqual(stats.byte_count, 500 * 8 * 4)
        self.grid.remove([0, 1])
        self.assertEqual(self.grid.stats.particle_count, 498)

    def test_build_before_the_first_query(self):
        self.grid.build()
        stats = self.grid.stats
        self.assertEqual((stats.build_count, stats.search_count), (1, 0))
        self.grid.query_pairs()
        self.assertEqual(self.grid.stats.search_count, 1)


class Module(unittest.TestCase):
    def test_version(self):
        version = hgrid.version()
        self.assertEqual(len(version), 3)
        self.assertTrue(all(isinstance(number, int) and number >= 0 for number in version))
        self.assertEqual(hgrid.__version__, "{}.{}.{}".format(*version))

    def test_everything_public_exists_and_is_explained(self):
        for name in hgrid.__all__:
            with self.subTest(name=name):
                item = getattr(hgrid, name)
                if not name.startswith("HG_"):
                    self.assertTrue(inspect.getdoc(item))
        for name, item in inspect.getmembers(hgrid.Grid):
            if not name.startswith("_"):
                with self.subTest(member=name):
                    self.assertTrue(inspect.getdoc(item))


if __name__ == "__main__":
    unittest.main()
