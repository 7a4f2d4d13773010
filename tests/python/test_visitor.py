# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Visiting the pairs in batches: completeness, stopping, exceptions, and calls from inside."""

import unittest

import numpy as np
from oracle import ascending, exact_pairs, polydisperse

import hgrid


class Stop(Exception):
    pass


class Visitor(unittest.TestCase):
    def setUp(self):
        self.x, self.r = polydisperse(51, 300, largest=0.3)
        self.grid = hgrid.Grid()
        self.grid.insert(self.x, self.r)
        self.addCleanup(self.grid.close)

    def test_batches_are_all_pairs_and_stay_valid(self):
        batches = []
        self.assertIsNone(self.grid.visit_pairs(batches.append))
        for batch in batches:
            self.assertEqual((batch.dtype, batch.shape[1]), (np.int32, 2))
            self.assertGreater(len(batch), 0)
        self.grid.clear()
        np.testing.assert_array_equal(ascending(np.concatenate(batches)), exact_pairs(self.x, self.r))

    def test_order_by_id(self):
        batches = []
        with hgrid.Grid(order="id") as grid:
            grid.insert(self.x, self.r)
            grid.visit_pairs(batches.append)
        np.testing.assert_array_equal(np.concatenate(batches), exact_pairs(self.x, self.r))

    def use_a_set_of_many_batches(self):
        n = 20
        sites = np.indices((n, n, n)).reshape(3, -1).T
        self.grid.clear()
        self.grid.insert(sites, np.full(n**3, 0.75))
        batches = []
        self.grid.visit_pairs(batches.append)
        self.assertEqual(sum(map(len, batches)), 3 * n * n * (n - 1) + 6 * n * (n - 1) ** 2)
        self.assertGreater(len(batches), 1)

    def test_true_answer_stops(self):
        self.use_a_set_of_many_batches()
        for answer in (True, 1, "yes", np.bool_(True)):
            with self.subTest(answer=answer):
                calls = []
                self.grid.visit_pairs(lambda pairs: calls.append(pairs) or answer)
                self.assertEqual(len(calls), 1)

    def test_exception_ends_the_visit_and_passes_on(self):
        self.use_a_set_of_many_batches()
        calls = []

        def visit(pairs):
            calls.append(pairs)
            raise Stop("enough")

        count = len(self.grid.query_pairs())
        with self.assertRaisesRegex(Stop, "enough"):
            self.grid.visit_pairs(visit)
        self.assertEqual(len(calls), 1)
        self.assertEqual(len(self.grid.query_pairs()), count)

    def test_answer_without_truth_value(self):
        with self.assertRaisesRegex(ValueError, "truth value"):
            self.grid.visit_pairs(lambda pairs: pairs == pairs)

    def test_calls_from_inside_are_refused(self):
        grid = self.grid
        calls = {
            "set": lambda: grid.set([[0, 0, 0]], [1]),
            "insert": lambda: grid.insert([[0, 0, 0]], [1]),
            "move": lambda: grid.move(self.x),
            "remove": lambda: grid.remove([0]),
            "clear": grid.clear,
            "build": grid.build,
            "query_pairs": grid.query_pairs,
            "vectors": lambda: grid.query_pairs(vectors=True),
            "visit_pairs": lambda: grid.visit_pairs(lambda pairs: None),
            "visit_contacts": lambda: grid.visit_contacts(lambda *batch: None),
            "order": lambda: grid.order,
            "overlap": lambda: grid.overlap((0, 0, 0), 1, (0, 0, 0), 1),
            "query_neighbors": grid.query_neighbors,
            "query_sphere": lambda: grid.query_sphere((0, 0, 0), 1),
            "levels": lambda: grid.levels,
            "level_costs": lambda: grid.level_costs,
            "stats": lambda: grid.stats,
            "close": grid.close,
        }
        refused = []

        def visit(pairs):
            for name, call in calls.items():
                try:
                    call()
                except hgrid.StateError:
                    refused.append(name)
            return True

        grid.visit_pairs(visit)
        self.assertEqual(refused, list(calls))
        np.testing.assert_array_equal(ascending(grid.query_pairs()), exact_pairs(self.x, self.r))

    def test_refusal_passes_through_the_visit(self):
        with self.assertRaises(hgrid.StateError) as caught:
            self.grid.visit_pairs(lambda pairs: self.grid.build())
        self.assertEqual(caught.exception.status, hgrid.HG_ERR_STATE)

    def test_another_grid_may_be_used_inside(self):
        found = []

        def visit(pairs):
            with hgrid.Grid() as other:
                other.insert(self.x, self.r)
                other.visit_pairs(found.append)
            return True

        self.grid.visit_pairs(visit)
        np.testing.assert_array_equal(ascending(np.concatenate(found)), exact_pairs(self.x, self.r))

    def test_not_callable(self):
        with self.assertRaisesRegex(TypeError, "callable"):
            self.grid.visit_pairs(3)

    def test_no_pairs_no_call(self):
        with hgrid.Grid() as grid:
            grid.visit_pairs(lambda pairs: self.fail("called without pairs"))


if __name__ == "__main__":
    unittest.main()
