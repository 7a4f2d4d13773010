# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Neighbour lists and the query of a single sphere."""

import unittest

import numpy as np
from oracle import exact_pairs, polydisperse

import hgrid


def rows(offsets, neighbors):
    return [neighbors[begin:end].tolist() for begin, end in zip(offsets[:-1], offsets[1:])]


def rows_of_pairs(ids, pairs, full):
    table = {i: [] for i in ids}
    for a, b in pairs.tolist():
        table[a].append(b)
        if full:
            table[b].append(a)
    return [sorted(table[i]) for i in ids]


class Neighbors(unittest.TestCase):
    def setUp(self):
        self.x, self.r = polydisperse(41, 250)
        self.pairs = exact_pairs(self.x, self.r)

    def test_half_and_full_lists(self):
        with hgrid.Grid() as grid:
            grid.insert(self.x, self.r)
            for full in (False, True):
                with self.subTest(full=full):
                    offsets, neighbors = grid.query_neighbors(full=full)
                    self.assertEqual((offsets.dtype, neighbors.dtype), (np.int64, np.int32))
                    self.assertEqual(offsets.shape, (251,))
                    self.assertEqual(rows(offsets, neighbors), rows_of_pairs(range(250), self.pairs, full))

    def test_half_is_the_default(self):
        with hgrid.Grid() as grid:
            grid.insert(self.x, self.r)
            self.assertEqual(len(grid.query_neighbors()[1]), len(self.pairs))
            self.assertEqual(len(grid.query_neighbors(True)[1]), 2 * len(self.pairs))

    def test_rows_of_live_particles_only(self):
        gone = np.arange(5, 250, 7)
        kept = np.setdiff1d(np.arange(250), gone)
        pairs = kept[exact_pairs(self.x[kept], self.r[kept])] + 1
        with hgrid.Grid(index_base=1) as grid:
            grid.insert(self.x, self.r)
            grid.remove(gone + 1)
            self.assertEqual(rows(*grid.query_neighbors(full=True)), rows_of_pairs((kept + 1).tolist(), pairs, True))

    def test_empty_grid(self):
        with hgrid.Grid() as grid:
            offsets, neighbors = grid.query_neighbors()
            self.assertEqual((offsets.tolist(), neighbors.tolist()), ([0], []))


class Sphere(unittest.TestCase):
    def test_against_brute_force(self):
        x, r = polydisperse(42, 250)
        probes, radii = polydisperse(43, 40, ratio=1e4)
        with hgrid.Grid(index_base=1) as grid:
            grid.insert(x, r)
            for k, (center, radius) in enumerate(zip(probes, radii)):
                with self.subTest(probe=k):
                    pairs = exact_pairs(np.vstack([x, center]), np.append(r, radius), base=1)
                    found = grid.query_sphere(center, radius)
                    self.assertEqual(found.dtype, np.int32)
                    self.assertEqual(found.tolist(), pairs[pairs[:, 1] == 251, 0].tolist())
            offsets, ids = grid.query_spheres(probes, radii)
            self.assertEqual((offsets.dtype, ids.dtype, offsets[0]), (np.int64, np.int32, 0))
            self.assertEqual(offsets.shape, (len(probes) + 1,))
            for k, (center, radius) in enumerate(zip(probes, radii)):
                row = ids[offsets[k] : offsets[k + 1]]
                self.assertEqual(row.tolist(), grid.query_sphere(center, radius).tolist())

    def test_touching_and_empty(self):
        with hgrid.Grid(dimension=2) as grid:
            self.assertEqual(grid.query_sphere((0, 0), 1).shape, (0,))
            self.assertEqual([rows.tolist() for rows in grid.query_spheres([], [])], [[0], []])
            grid.insert([[3, 4]], [2])
            self.assertEqual(grid.query_sphere((0, 0), 3).tolist(), [])
            self.assertEqual(grid.query_sphere((0, 0), np.nextafter(3, 4)).tolist(), [0])

    def test_nearest_image(self):
        with hgrid.Grid(periodic=(True, True, True), box=((0, 0, 0), (4, 4, 4))) as grid:
            grid.insert([[0.25, 2, 2]], [0.5])
            self.assertEqual(grid.query_sphere((3.75, 2, 2), 0.25).tolist(), [0])


if __name__ == "__main__":
    unittest.main()
