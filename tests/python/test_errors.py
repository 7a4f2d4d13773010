# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Failures as exceptions: class, status, text, and a grid that is as it was before."""

import pickle
import unittest

import numpy as np
from oracle import exact_pairs, polydisperse

import hgrid


class Failures(unittest.TestCase):
    def setUp(self):
        self.x, self.r = polydisperse(71, 60, largest=0.3)
        self.grid = hgrid.Grid(order="id")
        self.addCleanup(self.grid.close)
        self.grid.insert(self.x, self.r)

    def tearDown(self):
        if not self.grid.closed:
            np.testing.assert_array_equal(self.grid.query_pairs(), exact_pairs(self.x, self.r))

    def fails(self, kind, status, call, *texts):
        with self.assertRaises(kind) as caught:
            call()
        self.assertIsInstance(caught.exception, hgrid.Error)
        self.assertEqual(caught.exception.status, status)
        for text in texts:
            self.assertIn(text, str(caught.exception))

    def refused(self, call, *texts):
        self.fails(ValueError, hgrid.HG_ERR_ARGUMENT, call, *texts)

    def test_bad_values_are_named(self):
        for value, text in ((np.nan, "nan"), (np.inf, "inf"), (-np.inf, "-inf")):
            x = self.x.copy()
            x[41, 1] = value
            self.refused(lambda: self.grid.insert(x, self.r), "41", text)
            self.refused(lambda: self.grid.move(x), "41", text)
        for value, text in ((np.nan, "nan"), (np.inf, "inf"), (-0.25, "-0.25")):
            r = self.r.copy()
            r[37] = value
            self.refused(lambda: self.grid.insert(self.x, r), "37", text)
            self.refused(lambda: self.grid.move(self.x, r), "37", text)

    def test_count_of_move(self):
        self.refused(lambda: self.grid.move(self.x[:59]), "59", "60")

    def test_unknown_ids(self):
        def missing(ids, *texts):
            self.fails(KeyError, hgrid.HG_ERR_NOT_FOUND, lambda: self.grid.remove(ids), *texts)

        missing([3, 60], "60")
        missing([-1], "-1")
        missing([4, 4], "4")
        missing([0, 5_000_000_000], "ids[1]", "5000000000")
        missing(np.array([2**63 + 7], dtype=np.uint64), str(2**63 + 7))

    def test_text_of_an_unknown_id_is_not_quoted(self):
        with self.assertRaises(hgrid.NotFoundError) as caught:
            self.grid.remove([99])
        self.assertFalse(str(caught.exception).startswith(("'", '"')))

    def test_bad_sphere(self):
        self.refused(lambda: self.grid.query_sphere((0, 0, 0), -1), "-1")
        self.refused(lambda: self.grid.query_sphere((0, np.nan, 0), 1), "nan")
        self.refused(lambda: self.grid.query_spheres([(0, 0, 0), (0, np.nan, 0)], [1, 1]), "centers[1][1]", "nan")
        self.refused(lambda: self.grid.query_spheres([(0, 0, 0), (0, 1, 0)], [1, -2]), "radii[1]", "-2")

    def test_closed_grid(self):
        grid = self.grid
        grid.close()
        grid.close()
        self.assertTrue(grid.closed)
        calls = (
            lambda: grid.insert(self.x, self.r),
            lambda: grid.move(self.x),
            lambda: grid.remove([0]),
            grid.clear,
            grid.build,
            grid.query_pairs,
            lambda: grid.visit_pairs(lambda pairs: None),
            grid.query_neighbors,
            lambda: grid.query_sphere((0, 0, 0), 1),
            lambda: grid.query_spheres([(0, 0, 0)], [1]),
            lambda: grid.levels,
            lambda: grid.level_costs,
            lambda: grid.stats,
            grid.__enter__,
        )
        for call in calls:
            self.fails(RuntimeError, hgrid.HG_ERR_STATE, call, "closed")

    def test_bad_definitions(self):
        box = ((0, 0, 0), (1, 1, 1))
        self.refused(lambda: hgrid.Grid(dimension=4), "dimension", "4")
        self.refused(lambda: hgrid.Grid(index_base=2), "index_base", "2")
        self.refused(lambda: hgrid.Grid(thread_count=-1), "thread_count", "-1")
        self.refused(lambda: hgrid.Grid(margin=-0.5), "margin", "-0.5")
        self.refused(lambda: hgrid.Grid(skin=np.nan), "skin", "nan")
        self.refused(lambda: hgrid.Grid(cell_overhead=np.inf), "cell_overhead", "inf")
        self.refused(lambda: hgrid.Grid(row_price=np.inf), "row_price", "inf")
        self.refused(lambda: hgrid.Grid(periodic=(True, False, False)), "box")
        self.refused(lambda: hgrid.Grid(periodic=(True, False, False), box=box[::-1]), "box")
        self.refused(lambda: hgrid.Grid(interaction="touch"), "interaction", "'touch'", "'contact'", "'max_range'")
        self.refused(lambda: hgrid.Grid(accuracy="best"), "accuracy", "'best'", "'exact'")
        self.refused(lambda: hgrid.Grid(accuracy=17), "accuracy", "17")
        self.refused(lambda: hgrid.Grid(order="none"), "order", "'none'", "'id'")
        self.refused(lambda: hgrid.Grid(levels="many"), "levels", "'many'", "'paper'")
        self.refused(lambda: hgrid.Grid(levels="user"), "cell_sizes")
        self.refused(lambda: hgrid.Grid(levels="auto", cell_sizes=[1.0]), "cell_sizes")
        self.refused(lambda: hgrid.Grid(level_count=3, cell_sizes=[1.0, 2.0]), "level_count", "3", "2")
        self.refused(lambda: hgrid.Grid(cell_sizes=[2.0, 1.0]), "cell_sizes")

    def test_wrong_kinds_of_arguments(self):
        with self.assertRaises(TypeError):
            hgrid.Grid(thread_count=1.5)
        with self.assertRaises(TypeError):
            hgrid.Grid(3, (True, False, False))
        with self.assertRaises(TypeError):
            hgrid.Grid(unknown=1)

    def test_limits(self):
        sizes = np.arange(1.0, hgrid.HG_MAX_LEVELS + 2)
        self.fails(OverflowError, hgrid.HG_ERR_LIMIT, lambda: hgrid.Grid(cell_sizes=sizes), str(hgrid.HG_MAX_LEVELS))

    def test_box_too_short_for_the_reach(self):
        with hgrid.Grid(periodic=(True, False, False), box=((0, 0, 0), (1, 1, 1))) as grid:
            self.refused(lambda: grid.insert([[0.5, 0.5, 0.5], [0.2, 0.5, 0.5]], [0.45, 0.45]))
            self.assertEqual(grid.stats.particle_count, 0)


class Classes(unittest.TestCase):
    def test_statuses(self):
        kinds = {
            hgrid.ArgumentError: hgrid.HG_ERR_ARGUMENT,
            hgrid.OutOfMemoryError: hgrid.HG_ERR_MEMORY,
            hgrid.StateError: hgrid.HG_ERR_STATE,
            hgrid.NotFoundError: hgrid.HG_ERR_NOT_FOUND,
            hgrid.LimitError: hgrid.HG_ERR_LIMIT,
        }
        for kind, status in kinds.items():
            self.assertTrue(issubclass(kind, hgrid.Error))
            self.assertEqual(kind("text").status, status)
        self.assertTrue(issubclass(hgrid.OutOfMemoryError, MemoryError))

    def test_errors_survive_pickling(self):
        try:
            hgrid.Grid(margin=-1)
        except hgrid.Error as error:
            copy = pickle.loads(pickle.dumps(error))
            self.assertEqual((type(copy), str(copy), copy.status), (type(error), str(error), error.status))
        else:
            self.fail("a negative margin was accepted")


if __name__ == "__main__":
    unittest.main()
