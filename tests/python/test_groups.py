# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Groups, absent particles and bodies: of all pairs those that may be, and errors."""

import unittest

import numpy as np
from oracle import ascending, exact_pairs, polydisperse

import hgrid


class Company(unittest.TestCase):
    def test_of_all_pairs_those_that_may_be(self):
        rng = np.random.default_rng(5)
        for dimension in (2, 3):
            x, r = polydisperse(dimension, 300, largest=0.3)
            x = x[:, :dimension]
            groups, bodies = rng.integers(-1, 3, len(r)), rng.integers(-1, 60, len(r))
            with self.subTest(dimension=dimension), hgrid.Grid(dimension) as grid:
                grid.set(x, r)
                pairs = exact_pairs(x, r)
                grid.set_groups(groups)
                grid.set_group_pair(0, 2, False)
                grid.set_group_pair(1, 1, False)
                a, b = groups[pairs].T
                apart = (np.minimum(a, b) < 0) | ((a == 1) & (b == 1)) | ((np.minimum(a, b) == 0) & (np.maximum(a, b) == 2))
                left = pairs[~apart]
                self.assertGreater(len(left), 0)
                np.testing.assert_array_equal(ascending(grid.query_pairs()), left)
                grid.set_bodies(bodies)
                a, b = bodies[left].T
                np.testing.assert_array_equal(ascending(grid.query_pairs()), left[(a != b) | (a < 0)])
                grid.set_groups(None)
                grid.set_bodies(None)
                grid.set_group_pair(0, 0, True)
                np.testing.assert_array_equal(ascending(grid.query_pairs()), pairs)

    def test_nothing(self):
        with hgrid.Grid() as grid:
            grid.set_groups([])
            grid.set_bodies([])
            self.assertEqual(grid.query_pairs().shape, (0, 2))

    def test_errors(self):
        with hgrid.Grid() as grid:
            grid.set([[0, 0, 0], [1, 0, 0]], [1, 1])
            self.assertRaisesRegex(ValueError, r"groups\[1\] = 64", grid.set_groups, [0, hgrid.HG_MAX_GROUPS])
            self.assertRaisesRegex(ValueError, "count is 1", grid.set_groups, [0])
            self.assertRaisesRegex(ValueError, r"groups must have shape \(n,\)", grid.set_groups, [[0, 0]])
            self.assertRaisesRegex(ValueError, r"groups\[0\] = 4294967296", grid.set_groups, [2**32, 0])
            self.assertRaisesRegex(ValueError, r"bodies\[0\] = -2", grid.set_bodies, [-2, 0])
            self.assertRaisesRegex(TypeError, "bodies must hold integers", grid.set_bodies, [0.5, 0])
            self.assertRaisesRegex(ValueError, "group_a = -1", grid.set_group_pair, -1, 0, True)
            self.assertEqual(len(grid.query_pairs()), 1)


if __name__ == "__main__":
    unittest.main()
