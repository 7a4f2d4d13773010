# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Tilted periodic cells, touching spheres, all images, and a box that changes, against brute force over images."""

import itertools
import unittest

import numpy as np
from oracle import ascending, dyadic, exact_pairs, polydisperse

import hgrid

BOX = ((-0.5, 0.25, 1.0), (0.75, 1.25, 2.5))
TILT = (0.5, -0.25, 0.375)
EVERY_AXIS = (True, True, True)


def pairs_of(x, r, **options):
    with hgrid.Grid(**options) as grid:
        grid.insert(x, r)
        return ascending(grid.query_pairs())


class Tilted(unittest.TestCase):
    def test_space(self):
        x, r = polydisperse(31, 150, ratio=40.0, largest=0.12)
        for touching, images in itertools.product((False, True), ("nearest", "all")):
            options = dict(box=BOX, tilt=TILT, periodic=EVERY_AXIS, touching=touching, images=images)
            with self.subTest(seed=31, **options):
                np.testing.assert_array_equal(pairs_of(x, r, **options), exact_pairs(x, r, **options))

    def test_plane(self):
        x, r = polydisperse(32, 200, dimension=2, ratio=40.0, largest=0.1)
        options = dict(box=((0.0, 0.0), (1.0, 1.0)), periodic=(True, True))
        wanted = exact_pairs(x, r, tilt=(0.25, 0, 0), **options)
        self.assertFalse(np.array_equal(wanted, exact_pairs(x, r, **options)))
        for tilt in (0.25, (0.25,), (0.25, 0.0, 0.0), np.float32(0.25)):
            with self.subTest(seed=32, tilt=tilt):
                np.testing.assert_array_equal(pairs_of(x, r, dimension=2, tilt=tilt, **options), wanted)

    def test_one_axis_open(self):
        x, r = polydisperse(33, 150, ratio=40.0, largest=0.12)
        options = dict(box=BOX, tilt=(0.5, 0.0, 0.0), periodic=(True, True, False))
        np.testing.assert_array_equal(pairs_of(x, r, **options), exact_pairs(x, r, **options))

    def test_a_matrix_of_edges(self):
        x, r = polydisperse(34, 150, ratio=40.0, largest=0.12)
        wanted = exact_pairs(x, r, box=((0, 0, 0), (1, 1.25, 1.5)), tilt=(0.5, 0.25, -0.5), periodic=EVERY_AXIS)
        edges = ((1, 0, 0), (0.5, 1.25, 0), (0.25, -0.5, 1.5))
        np.testing.assert_array_equal(pairs_of(x, r, box=edges, periodic=EVERY_AXIS), wanted)


class AllImages(unittest.TestCase):
    def test_boxes_of_any_length(self):
        x, r = polydisperse(35, 12, ratio=10.0, largest=0.3)
        for edge in (0.125, 0.25, 0.5, 1.0):
            options = dict(box=((0, 0, 0), (edge, 1.0, 1.0)), tilt=(edge / 2, 0, 0.25), images="all", margin=0.0625)
            options["periodic"] = EVERY_AXIS
            with self.subTest(seed=35, edge=edge):
                np.testing.assert_array_equal(pairs_of(x, r, **options), exact_pairs(x, r, **options))

    def test_rows_list_each_image(self):
        with hgrid.Grid(box=np.eye(3), periodic=EVERY_AXIS, images="all", touching=True) as grid:
            grid.insert([[0.5, 0.5, 0.5]], [0.5])
            self.assertEqual(grid.query_pairs().tolist(), [[0, 0]] * 3)
            self.assertEqual(grid.query_neighbors()[1].tolist(), [0] * 3)
            self.assertEqual(grid.query_neighbors(full=True)[1].tolist(), [0] * 6)
            self.assertEqual(grid.query_sphere([0.0, 0.0, 0.0], 0.5).tolist(), [0])


class Touching(unittest.TestCase):
    def test_across_the_tilted_boundary(self):
        # The image of the second above the first is 0.25 higher, and no less.
        x = [[0.25, 0.125, 0.5], [0.75, 0.875, 0.5]]
        options = dict(box=np.array([[1, 0, 0], [0.5, 1, 0], [0, 0, 1]]), periodic=EVERY_AXIS)
        self.assertEqual(len(pairs_of(x, [0.125, 0.125], **options)), 0)
        self.assertEqual(len(pairs_of(x, [0.125, 0.125], touching=True, **options)), 1)


class BoxThatChanges(unittest.TestCase):
    def test_shear_and_growth(self):
        x, r = polydisperse(36, 150, ratio=40.0, largest=0.1)
        x, r = dyadic(x), dyadic(r)
        for skin in (0.0, 0.05):
            with hgrid.Grid(box=((0, 0, 0), (1, 1, 1)), periodic=EVERY_AXIS, skin=skin) as grid:
                grid.insert(x, r)
                for step in range(6):
                    box = ((0, 0, 0), (1 + step / 64, 1 - step / 128, 1))
                    tilt = (step / 32 - 0.0625, 0, step / 256)
                    grid.set_box(box, tilt)
                    wanted = exact_pairs(x, r, box=box, tilt=tilt, periodic=EVERY_AXIS)
                    with self.subTest(seed=36, skin=skin, step=step):
                        np.testing.assert_array_equal(ascending(grid.query_pairs()), wanted)

    def test_every_form(self):
        x, r = polydisperse(37, 150, ratio=40.0, largest=0.12)
        upright = exact_pairs(x, r, box=((0, 0, 0), (1, 1, 1)), periodic=EVERY_AXIS)
        tilted = exact_pairs(x, r, box=((0, 0, 0), (1, 1, 1)), periodic=EVERY_AXIS, tilt=(0.5, 0, 0))
        self.assertFalse(np.array_equal(upright, tilted))
        with hgrid.Grid(box=2 * np.eye(3), periodic=EVERY_AXIS) as grid:
            grid.insert(x, r)
            grid.set_box(((0, 0, 0), (1, 1, 1)), (0.5, 0, 0))
            np.testing.assert_array_equal(ascending(grid.query_pairs()), tilted)
            grid.set_box(np.eye(3))
            np.testing.assert_array_equal(ascending(grid.query_pairs()), upright)
            grid.set_box([[1, 0, 0], [0.5, 1, 0], [0, 0, 1]])
            np.testing.assert_array_equal(ascending(grid.query_pairs()), tilted)
            grid.set_box(((0, 0, 0), (1, 1, 1)))
            np.testing.assert_array_equal(ascending(grid.query_pairs()), upright)


class Refused(unittest.TestCase):
    def refused(self, words, **options):
        with self.assertRaisesRegex(ValueError, words):
            hgrid.Grid(periodic=EVERY_AXIS, **options)

    def test_boxes(self):
        edges = np.eye(3)
        edges[0, 1] = 0.25
        self.refused(r"lower triangular.*box\[0\]\[1\] = 0.25", box=edges)
        self.refused("tilt cannot be given", box=np.eye(3), tilt=(0, 0, 0))
        self.refused(r"box must have shape \(2, 3\), not \(2, 2\)", box=np.eye(2))
        self.refused(r"tilt must have shape \(3,\), not \(2,\)", box=BOX, tilt=(0.5, 0.5))
        self.refused("box_max", box=-np.eye(3))
        self.refused("images is 'every'; it must be one of 'nearest', 'all'", box=BOX, images="every")
        with self.assertRaisesRegex(ValueError, "tilt"):
            hgrid.Grid(periodic=(True, False, True), box=BOX, tilt=(0.5, 0, 0))

    def test_a_new_box_that_is_refused_changes_nothing(self):
        x, r = [[0.125, 0.5, 0.5], [0.875, 0.5, 0.5]], [0.2, 0.2]
        with hgrid.Grid(periodic=EVERY_AXIS, box=np.eye(3)) as grid:
            grid.insert(x, r)
            for box, tilt in ((0.5 * np.eye(3), None), (-np.eye(3), None), (BOX, (np.nan, 0, 0)), (None, None)):
                with self.subTest(box=box), self.assertRaises(ValueError):
                    grid.set_box(box, tilt)
            self.assertEqual(len(grid.query_pairs()), 1)
            grid.close()
            with self.assertRaises(hgrid.StateError):
                grid.set_box(np.eye(3))


if __name__ == "__main__":
    unittest.main()
