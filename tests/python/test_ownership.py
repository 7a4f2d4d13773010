# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Who owns what: results outlive the grid, inputs are not kept, and closed grids give their memory back."""

import copy
import gc
import os
import pickle
import sys
import unittest
import weakref

import numpy as np
from oracle import polydisperse

import hgrid


class Results(unittest.TestCase):
    def setUp(self):
        self.x, self.r = polydisperse(81, 400, largest=0.2)
        self.grid = hgrid.Grid()
        self.grid.insert(self.x, self.r)

    def results(self):
        grid = self.grid
        probe = (0.5, 0.5, 0.5)
        spheres = grid.query_spheres([probe], [0.3])
        return [grid.query_pairs(), *grid.query_neighbors(), grid.query_sphere(probe, 0.3), *spheres]

    def test_results_stay_as_they_are(self):
        first = self.results()
        kept = [array.tobytes() for array in first]
        self.grid.move(self.x[::-1])
        second = self.results()
        self.grid.close()
        self.grid = None
        gc.collect()
        self.assertEqual([array.tobytes() for array in first], kept)
        self.assertNotEqual([array.tobytes() for array in second], kept)

    def test_results_belong_to_the_caller(self):
        before = self.grid.query_pairs().tobytes()
        for array in self.results():
            self.assertGreater(array.size, 0)
            self.assertTrue(array.flags.writeable)
            array[...] = -7
        self.assertEqual(self.grid.query_pairs().tobytes(), before)

    def test_records_stay_as_they_are(self):
        levels, stats = self.grid.levels, self.grid.stats
        self.grid.clear()
        self.grid.insert([[0, 0, 0]], [1])
        self.assertEqual(sum(level.particle_count for level in levels), 400)
        self.assertEqual(stats.particle_count, 400)
        self.assertEqual(self.grid.levels[0].largest_radius, 1)


class Inputs(unittest.TestCase):
    def test_inputs_are_copied_and_let_go(self):
        x, r = polydisperse(82, 300, largest=0.2)
        ids = np.array([1, 2, 3], dtype=np.int32)
        sizes = np.array([0.1, 0.5])
        counts = [sys.getrefcount(array) for array in (x, r, ids, sizes)]
        with hgrid.Grid(order="id", cell_sizes=sizes) as grid:
            grid.insert(x, r)
            grid.remove(ids)
            with self.assertRaises(hgrid.NotFoundError):
                grid.remove(ids)
            with self.assertRaises(hgrid.ArgumentError):
                grid.insert(x, -r)
            self.assertEqual([sys.getrefcount(array) for array in (x, r, ids, sizes)], counts)
            before = grid.query_pairs()
            x[...] = 0
            r[...] = 0
            sizes[...] = 0
            grid.build()
            np.testing.assert_array_equal(grid.query_pairs(), before)

    def test_visitor_is_let_go(self):
        class Visit:
            def __call__(self, pairs):
                return True

        visit = Visit()
        gone = weakref.ref(visit)
        with hgrid.Grid() as grid:
            grid.insert([[0, 0, 0], [1, 0, 0]], [1, 1])
            grid.visit_pairs(visit)
            del visit
            gc.collect()
            self.assertIsNone(gone())


class Handles(unittest.TestCase):
    def test_context_manager_closes(self):
        with hgrid.Grid() as grid:
            self.assertFalse(grid.closed)
        self.assertTrue(grid.closed)
        with self.assertRaisesRegex(ZeroDivisionError, "kept"):
            with hgrid.Grid() as grid:
                raise ZeroDivisionError("kept")
        self.assertTrue(grid.closed)

    def test_failed_construction_leaves_nothing_behind(self):
        for _ in range(100):
            with self.assertRaises(hgrid.ArgumentError):
                hgrid.Grid(margin=-1)

    def test_a_grid_cannot_be_copied_or_pickled(self):
        with hgrid.Grid() as grid:
            for attempt in (copy.copy, copy.deepcopy, pickle.dumps):
                with self.subTest(attempt=attempt.__name__), self.assertRaises(TypeError):
                    attempt(grid)

    @unittest.skipUnless(os.path.exists("/proc/self/statm"), "needs the process's memory size")
    def test_memory_is_given_back(self):
        def resident():
            with open("/proc/self/statm") as sizes:
                return int(sizes.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")

        x, r = polydisperse(83, 60000, largest=0.02)

        def use(close):
            grid = hgrid.Grid()
            grid.insert(x, r)
            grid.query_pairs()
            held = grid.stats.byte_count
            if close:
                grid.close()
            return held

        held = max(use(close=True) for _ in range(3))
        before = resident()
        for k in range(30):
            use(close=k % 2 == 0)
        self.assertLess(resident() - before, 10 * held)


if __name__ == "__main__":
    unittest.main()
