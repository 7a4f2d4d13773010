# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""The arguments of Grid: defaults as in C, words and constants, and answers that do not depend on how they are got."""

import inspect
import unittest

import numpy as np
from oracle import ascending, dyadic, exact_pairs, polydisperse

import hgrid
from hgrid import capi


class Options(unittest.TestCase):
    def test_defaults_are_those_of_the_library(self):
        ours = {name: p.default for name, p in inspect.signature(hgrid.Grid).parameters.items()}
        library = capi.hg_grid_def()
        names = "dimension thread_count index_base touching level_count margin skin cell_overhead level_price row_price"
        for name in names.split():
            with self.subTest(name=name):
                self.assertEqual(ours[name], getattr(library, name))
        words = {
            "interaction": (library.interaction, {"contact": hgrid.HG_CONTACT}),
            "accuracy": (library.accuracy, {"exact": hgrid.HG_EXACT}),
            "images": (library.images, {"nearest": hgrid.HG_NEAREST_IMAGE}),
            "order": (library.pair_order, {"grid": hgrid.HG_ORDER_GRID}),
        }
        for name, (value, constants) in words.items():
            with self.subTest(name=name):
                self.assertEqual(constants[ours[name]], value)
        self.assertEqual(library.level_rule, hgrid.HG_LEVELS_AUTO)

    def test_how_levels_are_chosen_does_not_change_the_pairs(self):
        x, r = polydisperse(91, 300, ratio=1e3)
        wanted = exact_pairs(x, r)
        choices = (
            dict(levels="auto"),
            dict(levels="paper"),
            dict(levels=hgrid.HG_LEVELS_PAPER, level_count=3),
            dict(level_count=1),
            dict(cell_overhead=5.0),
            dict(level_price=0.0, row_price=0.0),
            dict(level_price=1e6),
            dict(levels="user", cell_sizes=[0.01, 0.02, 0.3], level_count=3),
            dict(cell_sizes=np.array([0.5])),
            dict(skin=0.01),
            dict(thread_count=1),
            dict(thread_count=3),
        )
        for options in choices:
            with self.subTest(**options), hgrid.Grid(**options) as grid:
                grid.insert(x, r)
                np.testing.assert_array_equal(ascending(grid.query_pairs()), wanted)

    def test_cell_sizes_are_used(self):
        x, r = polydisperse(92, 100, ratio=10.0, largest=0.1)
        with hgrid.Grid(cell_sizes=[0.05, 0.25]) as grid:
            grid.insert(x, r)
            self.assertEqual([level.cell_size for level in grid.levels], [0.05, 0.25])

    def test_accuracies_agree_where_doubles_are_exact(self):
        x, r = polydisperse(93, 250)
        x, r = dyadic(x), dyadic(r)
        wanted = exact_pairs(x, r)
        for accuracy in ("exact", "double", hgrid.HG_EXACT, hgrid.HG_DOUBLE):
            with self.subTest(accuracy=accuracy), hgrid.Grid(accuracy=accuracy) as grid:
                grid.insert(x, r)
                np.testing.assert_array_equal(ascending(grid.query_pairs()), wanted)

    def test_float_misses_nothing(self):
        x, r = polydisperse(94, 300)
        wanted = {tuple(pair) for pair in exact_pairs(x, r).tolist()}
        with hgrid.Grid(accuracy="float") as grid:
            grid.insert(x, r)
            found = {tuple(pair) for pair in grid.query_pairs().tolist()}
        self.assertLessEqual(wanted, found)
        wider = {tuple(pair) for pair in exact_pairs(x, 1.0001 * r).tolist()}
        self.assertLessEqual(found, wider)

    def test_skin_follows_small_moves(self):
        rng = np.random.default_rng(95)
        x, r = polydisperse(95, 200)
        with hgrid.Grid(skin=0.02) as grid:
            grid.insert(x, r)
            for step in range(6):
                with self.subTest(seed=95, step=step):
                    np.testing.assert_array_equal(ascending(grid.query_pairs()), exact_pairs(x, r))
                x = x + 0.004 * rng.standard_normal(x.shape)
                grid.move(x)


if __name__ == "__main__":
    unittest.main()
