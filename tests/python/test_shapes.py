# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Boxes and triangles among particles, against brute force on numbers so round that doubles are exact."""

import unittest

import numpy as np
from oracle import dyadic, polydisperse

import hgrid


def rows(offsets, ids):
    return [ids[begin:end].tolist() for begin, end in zip(offsets[:-1], offsets[1:])]


class Boxes(unittest.TestCase):
    def test_against_brute_force(self):
        for dimension, touching, margin in ((2, False, 0.0), (3, True, 0.125), (3, False, 0.0625)):
            x, r = polydisperse(51, 300, dimension=dimension)
            x, r = dyadic(x, 6), dyadic(r, 6)
            low = x[::3] - dyadic(np.random.default_rng(52).random(x[::3].shape), 6) / 4
            high = x[::3] + np.where(np.arange(len(low)) % 4 == 0, np.inf, 0.0625)[:, None]
            gap = np.maximum(np.maximum(low[:, None] - x, x - high[:, None]), 0)
            square, reach = (gap**2).sum(axis=2), (r + margin) ** 2
            met = (square == 0) | (square < reach) | (touching & (square == reach))
            with self.subTest(dimension=dimension, touching=touching):
                with hgrid.Grid(dimension, touching=touching, margin=margin, interaction="max_range") as grid:
                    grid.insert(x, r)
                    offsets, ids = grid.query_boxes(low, high)
                self.assertEqual((offsets.dtype, ids.dtype), (np.int64, np.int32))
                self.assertEqual(rows(offsets, ids), [np.flatnonzero(row).tolist() for row in met])

    def test_periodic_and_empty(self):
        with hgrid.Grid(2, periodic=(True, False), box=((0, 0), (1, 1))) as grid:
            grid.insert([[0.125, 0.5]], [0.25])
            self.assertEqual(rows(*grid.query_boxes([[0.9, 0.5], [5.5, 0]], [[0.95, 0.6], [5.75, 1]])), [[0], []])
            self.assertEqual([part.tolist() for part in grid.query_boxes([], [])], [[0], []])

    def test_refusals(self):
        with hgrid.Grid(box=np.array([[1, 0, 0], [0.5, 1, 0], [0, 0, 1]]), periodic=(True, True, True)) as grid:
            with self.assertRaisesRegex(RuntimeError, "tilted"):
                grid.query_boxes([[0, 0, 0]], [[1, 1, 1]])
            with self.assertRaisesRegex(RuntimeError, "tilted"):
                grid.query_triangles(np.zeros((1, 3, 3)))
        with hgrid.Grid() as grid:
            with self.assertRaisesRegex(hgrid.ArgumentError, r"low\[1\]\[2\] = 2 is above high\[1\]\[2\] = 1"):
                grid.query_boxes([[0, 0, 0], [0, 0, 2]], np.ones((2, 3)))
            with self.assertRaisesRegex(hgrid.ArgumentError, r"high must have shape \(1, 3\), not \(2, 3\)"):
                grid.query_boxes([[0, 0, 0]], np.ones((2, 3)))


class Triangles(unittest.TestCase):
    def test_planes_and_corners(self):
        x, r = polydisperse(53, 300)
        heights = np.linspace(0.1, 0.9, 9)
        corners = np.array([[[-8, -8, z], [24, -8, z], [-8, 24, z]] for z in heights])
        points = x[:20] + 0.05
        corners = np.concatenate((corners, np.repeat(points[:, None], 3, axis=1)))
        with hgrid.Grid() as grid:
            grid.insert(x, r)
            found = rows(*grid.query_triangles(corners))
        distances = [np.abs(x[:, 2] - z) for z in heights] + [np.linalg.norm(x - point, axis=1) for point in points]
        self.assertEqual(found, [np.flatnonzero(d < r).tolist() for d in distances])

    def test_shapes_and_values(self):
        with hgrid.Grid() as grid:
            self.assertEqual([part.tolist() for part in grid.query_triangles([])], [[0], []])
            with self.assertRaisesRegex(hgrid.ArgumentError, r"corners must have shape \(n, 3, 3\), not \(2, 9\)"):
                grid.query_triangles(np.zeros((2, 9)))
            with self.assertRaisesRegex(hgrid.ArgumentError, r"corners\[0\]\[2\]\[1\] = nan"):
                grid.query_triangles([[[0, 0, 0], [1, 0, 0], [0, np.nan, 0]]])
        with hgrid.Grid(2) as grid, self.assertRaisesRegex(RuntimeError, "three dimensions"):
            grid.query_triangles(np.zeros((1, 3, 3)))


if __name__ == "__main__":
    unittest.main()
