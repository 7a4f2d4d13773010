# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Contact counts that are known in closed form."""

import unittest

import numpy as np

import hgrid


def count_pairs(x, r, **options):
    with hgrid.Grid(**options) as grid:
        grid.insert(x, np.broadcast_to(r, len(x)))
        return len(grid.query_pairs())


def block(n, basis):
    """n^3 unit cells with these sites each."""
    corners = np.stack(np.meshgrid(*3 * [np.arange(n)], indexing="ij"), axis=-1).reshape(-1, 1, 3)
    return (corners + np.array(basis)).reshape(-1, 3)


SIMPLE = [(0, 0, 0)]
BODY = [(0, 0, 0), (0.5, 0.5, 0.5)]
FACE = [(0, 0, 0), (0, 0.5, 0.5), (0.5, 0, 0.5), (0.5, 0.5, 0)]


class Lattices(unittest.TestCase):
    n = 8

    def test_simple_cubic(self):
        n, x = self.n, block(self.n, SIMPLE)
        self.assertEqual(count_pairs(x, 0.5), 0)
        self.assertEqual(count_pairs(x, 0.6), 3 * n * n * (n - 1))
        second = 6 * n * (n - 1) ** 2
        self.assertEqual(count_pairs(x, 0.75), 3 * n * n * (n - 1) + second)

    def test_body_centred(self):
        self.assertEqual(count_pairs(block(self.n, BODY), 0.45), (2 * self.n - 1) ** 3)

    def test_face_centred(self):
        n = self.n
        self.assertEqual(count_pairs(block(n, FACE), 0.4), 24 * n**3 - 24 * n**2 + 6 * n)

    def test_periodic_lattices(self):
        n = self.n
        options = dict(periodic=(True, True, True), box=((0, 0, 0), (n, n, n)))
        for basis, radius, neighbors in ((SIMPLE, 0.6, 6), (BODY, 0.45, 8), (FACE, 0.4, 12)):
            with self.subTest(sites=len(basis)):
                x = block(n, basis)
                self.assertEqual(count_pairs(x, radius, **options), len(x) * neighbors // 2)

    def test_points_in_a_ball(self):
        # 515 lattice points have |x|^2 <= 25; the 30 at distance 5 only touch the big sphere.
        lattice = block(15, SIMPLE) - 7
        x = np.concatenate([lattice, [(0, 0, 0)]])
        r = np.concatenate([np.full(len(lattice), 0.25), [4.75]])
        self.assertEqual(count_pairs(x, r), 515 - 30)


if __name__ == "__main__":
    unittest.main()
