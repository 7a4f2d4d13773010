# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""The table of docs/guide/porting.md: what a host's own test finds among all pairs, found by the library as it says."""

import unittest

import numpy as np

import hgrid

COUNT = 600
F32 = np.float32


def places(seed, dimension=3, real=float):
    """Nodes of a lattice with the pitch 0.1, each in one of a few decimal ways: distances all but tie with sums of
    sizes that are multiples of 0.05."""
    rng = np.random.default_rng(seed)
    nodes = rng.integers(0, 10, (COUNT, dimension))
    ways = (nodes * real(0.1), nodes / real(10), real(1) - (10 - nodes) * real(0.1))
    return np.choose(rng.integers(0, 3, (COUNT, 1)), [way.astype(real) for way in ways])


def sizes(seed, real=float):
    return (np.random.default_rng(seed + 100).integers(1, 5, COUNT) * real(0.05)).astype(real)


def square(x, i, j):
    """As a host writes it: the sum in this order."""
    return sum((x[j, axis] - x[i, axis]) ** 2 for axis in range(x.shape[1]))


def ascending(i, j):
    order = np.lexsort((j, i))
    return np.stack((i[order], j[order]), axis=1)


class YourCodesTest(unittest.TestCase):
    def assert_same(self, x, test, radii, keep=True, **options):
        """What `test` says of all pairs is what the library finds; if `keep`, with the test behind it."""
        i, j = np.triu_indices(len(x), 1)
        true = test(i, j)
        i, j = i[true], j[true]
        self.assertGreater(len(i), 100)
        with hgrid.Grid(x.shape[1], **options) as grid:
            grid.set(x, np.broadcast_to(radii, len(x)))
            a, b = grid.query_pairs().T
        if keep:
            true = test(a, b)
            a, b = a[true], b[true]
        np.testing.assert_array_equal(ascending(a, b), ascending(i, j))

    def test_plain_doubles(self):
        x, r = places(1), sizes(1)
        self.assert_same(x, lambda i, j: square(x, i, j) < (r[i] + r[j]) ** 2, r, keep=False, accuracy="double")

    def test_scaled_radii(self):
        x, r = places(2), sizes(2)
        self.assert_same(x, lambda i, j: square(x, i, j) < (1.1 * (r[i] + r[j])) ** 2, 1.1 * r, margin=1e-12)

    def test_gap(self):
        x, r = places(3), sizes(3)
        self.assert_same(x, lambda i, j: np.sqrt(square(x, i, j)) < r[i] + r[j] + 0.1, r, margin=0.1 + 1e-12)

    def test_mean_of_ranges(self):
        x, h = places(4), sizes(4)
        self.assert_same(x, lambda i, j: square(x, i, j) < (2 * 0.5 * (h[i] + h[j])) ** 2, 2 * h / 2, margin=1e-12)

    def test_largest_range(self):
        x, h = places(5), sizes(5)
        rule = dict(interaction="max_range", margin=1e-12)
        self.assert_same(x, lambda i, j: square(x, i, j) < (2 * np.maximum(h[i], h[j])) ** 2, 2 * h, **rule)

    def test_smaller_means(self):
        x, h = places(6), sizes(6)
        for mean in (np.minimum, lambda a, b: np.sqrt(a * b)):
            self.assert_same(x, lambda i, j: square(x, i, j) < (2 * mean(h[i], h[j])) ** 2, 2 * h / 2, margin=1e-12)

    def test_cutoff(self):
        x = places(7)
        self.assert_same(x, lambda i, j: square(x, i, j) < 0.2**2, 0.2 / 2, margin=1e-12)

    def test_table_of_cutoffs(self):
        x, kind = places(8), np.arange(COUNT) % 3
        table = np.array(((0.1, 0.2, 0.1), (0.2, 0.3, 0.1), (0.1, 0.1, 0.2)))
        radii = table.max(axis=1)[kind] / 2
        self.assert_same(x, lambda i, j: square(x, i, j) < table[kind[i], kind[j]] ** 2, radii, margin=1e-12)

    def test_touching(self):
        x, r = np.rint(10 * places(9)), np.rint(20 * sizes(9)) / 2  # nothing is rounded
        self.assert_same(x, lambda i, j: square(x, i, j) <= (r[i] + r[j]) ** 2, r, keep=False, touching=True)

    def test_square_root(self):
        x, r = places(10), sizes(10)
        self.assert_same(x, lambda i, j: np.sqrt(square(x, i, j)) < r[i] + r[j], r, margin=1e-12)

    def test_single_precision(self):
        x, r = places(11, real=F32), sizes(11, real=F32)
        self.assert_same(x, lambda i, j: square(x, i, j) < (r[i] + r[j]) ** 2, r, margin=1e-6)

    def test_nearest_image(self):
        for real, margin in ((float, 1e-12), (F32, 1e-6)):
            x, r, length = places(12, real=real), sizes(12, real=real), real(1)

            def test(i, j):
                gap = x[j] - x[i]
                gap = gap - length * np.rint(gap / length)
                return sum(gap[:, axis] ** 2 for axis in range(3)) < (r[i] + r[j]) ** 2

            box = dict(box=((0, 0, 0), (1, 1, 1)), periodic=(True, True, True))
            self.assert_same(x, test, r, margin=margin, **box)

    def test_one_dimension(self):
        x, r = places(13, dimension=1), sizes(13) / 8
        line = np.concatenate((x, np.zeros_like(x)), axis=1)
        self.assert_same(line, lambda i, j: np.abs(x[j, 0] - x[i, 0]) < r[i] + r[j], r, margin=1e-12)


if __name__ == "__main__":
    unittest.main()
