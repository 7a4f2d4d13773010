# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Sets of particles, vectors and shifts of pairs, contacts in batches, the order along space, verdicts on two spheres."""

import unittest

import numpy as np
from oracle import ascending, dyadic, exact_pairs, polydisperse

import hgrid

EVERY_AXIS = (True, True, True)


def column_of(edges, shifts):
    """What whole edges add to a place, exactly as long as all are multiples of a not too small power of two."""
    return np.asarray(shifts) @ np.asarray(edges)


class Sets(unittest.TestCase):
    def test_any_number_in_every_step(self):
        with hgrid.Grid(index_base=1) as grid:
            for step, count in enumerate((50, 200, 0, 200, 1, 0, 100)):
                x, r = polydisperse(step, count, largest=0.3)
                with self.subTest(step=step):
                    self.assertIsNone(grid.set(x, r))
                    self.assertEqual(grid.stats.particle_count, count)
                    np.testing.assert_array_equal(ascending(grid.query_pairs()), exact_pairs(x, r, base=1))

    def test_any_kind_of_array(self):
        x, r = polydisperse(61, 150, largest=0.3)
        x, r = dyadic(x), dyadic(r)
        wanted = exact_pairs(x, r)
        forms = {
            "float32": (x.astype(np.float32), r.astype(np.float32)),
            "float32 radii": (x, r.astype(np.float32)),
            "column by column": (np.asfortranarray(x), r),
            "every other": (np.repeat(x, 2, axis=0)[::2], np.repeat(r, 2)[::2]),
            "backwards": (x[::-1].copy()[::-1], r[::-1].copy()[::-1]),
            "lists": (x.tolist(), r.tolist()),
        }
        with hgrid.Grid() as grid:
            for name, (centers, radii) in forms.items():
                with self.subTest(name):
                    grid.set([], [])
                    grid.set(centers, radii)
                    np.testing.assert_array_equal(ascending(grid.query_pairs()), wanted)

    def test_empty_lists(self):
        for dimension in (2, 3):
            with hgrid.Grid(dimension) as grid:
                for nothing in ([], (), np.empty((0, dimension)), np.empty(0, dtype=np.float32)):
                    for call in (grid.set, grid.insert, grid.move):
                        call(nothing, [])
                    grid.move(nothing)
                    grid.remove([])
                    self.assertEqual(grid.query_pairs().shape, (0, 2))
                self.assertRaises(ValueError, grid.set, [[]], [])
                self.assertRaises(ValueError, grid.set, [], [1])
        history = hgrid.History()
        self.assertEqual(history.update([]).shape, (0,))

    def test_candidates_of_a_skin_stay_in_use(self):
        with hgrid.Grid(skin=0.2) as grid:
            for x in (0.0, 0.05, 0.0):
                grid.set([[x, 0, 0], [1, 0, 0]], [0.6, 0.6])
                self.assertEqual(len(grid.query_pairs()), 1)
            self.assertEqual((grid.stats.search_count, grid.stats.filter_count), (1, 2))

    def test_a_refusal_changes_nothing(self):
        with hgrid.Grid() as grid:
            grid.set([[0, 0, 0], [1, 0, 0]], [1, 1])
            with self.assertRaisesRegex(ValueError, r"radii\[1\] = -1"):
                grid.set([[0, 0, 0], [9, 0, 0], [0, 0, 0]], [1, -1, 1])
            with self.assertRaisesRegex(ValueError, r"r must have shape \(2,\)"):
                grid.set([[0, 0, 0], [9, 0, 0]], [1])
            self.assertEqual(grid.query_pairs().tolist(), [[0, 1]])


class Vectors(unittest.TestCase):
    def expect(self, x, r, edges, **options):
        """Pairs, vectors and shifts agree with each other and with the oracle; lengths are dyadic, so all is exact."""
        with hgrid.Grid(len(edges), order="id", **options) as grid:
            grid.set(x, r)
            pairs, vectors, shifts = grid.query_pairs(vectors=True, shifts=True)
            oracle = {name: value for name, value in options.items() if name != "dimension"}
            np.testing.assert_array_equal(pairs, exact_pairs(x, r, **oracle))
            self.assertEqual((vectors.dtype, vectors.shape), (np.float64, (len(pairs), len(edges))))
            self.assertEqual((shifts.dtype, shifts.shape), (np.int32, (len(pairs), len(edges))))
            a, b = pairs.T
            np.testing.assert_array_equal(vectors, x[b] - x[a] + column_of(edges, shifts))
            self.assertTrue((np.linalg.norm(vectors, axis=1) < r[a] + r[b] + 1e-9).all())
            self.assertTrue(shifts.any())
            for k in range(1, len(pairs)):
                if (pairs[k] == pairs[k - 1]).all():
                    self.assertLess(shifts[k - 1].tolist(), shifts[k].tolist())
            only_vectors, only_shifts = grid.query_pairs(vectors=True), grid.query_pairs(shifts=True)
            np.testing.assert_array_equal(only_vectors[1], vectors)
            np.testing.assert_array_equal(only_shifts[1], shifts)
            self.assertEqual((len(only_vectors), len(only_shifts)), (2, 2))

    def test_upright_and_tilted(self):
        for dimension in (2, 3):
            x, r = polydisperse(62, 150, dimension=dimension, ratio=20.0, largest=0.24)
            x, r = dyadic(x) + 3, dyadic(r)
            edges = np.eye(dimension)
            corners = (np.zeros(dimension), np.ones(dimension))
            with self.subTest(dimension=dimension):
                self.expect(x, r, edges, box=corners, periodic=(True,) * dimension)
                edges[1, 0] = 0.25
                self.expect(x, r, edges, box=corners, tilt=(0.25, 0, 0), periodic=(True,) * dimension)

    def test_all_images(self):
        x, r = polydisperse(63, 10, ratio=10.0, largest=0.6)
        self.expect(dyadic(x), dyadic(r), np.eye(3), box=((0, 0, 0), (1, 1, 1)), periodic=EVERY_AXIS, images="all")

    def test_nothing(self):
        with hgrid.Grid(2) as grid:
            pairs, vectors, shifts = grid.query_pairs(vectors=True, shifts=True)
            self.assertEqual((pairs.shape, vectors.shape, shifts.shape), ((0, 2), (0, 2), (0, 2)))

    def test_results_are_copies(self):
        with hgrid.Grid() as grid:
            grid.set([[0, 0, 0], [1, 0, 0]], [1, 1])
            _, vectors, shifts = grid.query_pairs(vectors=True, shifts=True)
            grid.clear()
        self.assertEqual((vectors.tolist(), shifts.tolist()), ([[1, 0, 0]], [[0, 0, 0]]))
        vectors[0] = 5


class Contacts(unittest.TestCase):
    def test_batches_are_the_list(self):
        for dimension in (2, 3):
            for images in ("nearest", "all"):
                x, r = polydisperse(64, 600, dimension=dimension, largest=0.1)
                options = dict(box=(np.zeros(dimension), np.ones(dimension)), periodic=(True,) * dimension)
                with self.subTest(dimension=dimension, images=images):
                    with hgrid.Grid(dimension, margin=0.125, images=images, **options) as grid:
                        grid.set(x, r)
                        batches = []
                        self.assertIsNone(grid.visit_contacts(lambda *batch: batches.append(batch)))
                        self.assertGreater(len(batches), 1)
                        self.assertLessEqual(max(len(batch[0]) for batch in batches), 1024)
                        pairs, vectors = grid.query_pairs(vectors=True)
                    np.testing.assert_array_equal(np.concatenate([batch[0] for batch in batches]), pairs)
                    np.testing.assert_array_equal(np.concatenate([batch[1] for batch in batches]), vectors)
                    reach = r[pairs[:, 0]] + r[pairs[:, 1]] + 0.125
                    np.testing.assert_array_equal(np.concatenate([batch[2] for batch in batches]), reach)

    def test_how_a_visit_ends(self):
        with hgrid.Grid() as grid:
            grid.set(np.zeros((60, 3)), np.ones(60))
            calls = []
            grid.visit_contacts(lambda *batch: calls.append(batch) or True)
            self.assertEqual(len(calls), 1)
            with self.assertRaises(ZeroDivisionError):
                grid.visit_contacts(lambda *batch: 1 / 0)
            with self.assertRaises(hgrid.StateError):
                grid.visit_contacts(lambda *batch: grid.query_pairs())
            with self.assertRaises(TypeError):
                grid.visit_contacts(lambda pairs: None)
            with self.assertRaisesRegex(TypeError, "callable"):
                grid.visit_contacts(3)
            self.assertEqual(len(grid.query_pairs()), 60 * 59 // 2)


class Order(unittest.TestCase):
    def test_near_ones_stand_together(self):
        x, r = polydisperse(65, 2000, largest=0.01)
        with hgrid.Grid(index_base=1) as grid:
            self.assertEqual(grid.order.shape, (0,))
            grid.set(x, r)
            order = grid.order
        self.assertEqual(order.dtype, np.int32)
        np.testing.assert_array_equal(np.sort(order), np.arange(1, 2001))
        steps = np.linalg.norm(np.diff(x[order - 1], axis=0), axis=1)
        self.assertLess(np.median(steps), 1.5 * 2000 ** (-1 / 3))


class Overlap(unittest.TestCase):
    def test_the_rule_of_the_grid(self):
        with hgrid.Grid(2, box=((0, 0), (1, 1)), periodic=(True, False)) as grid:
            self.assertIs(grid.overlap((0.25, 0), 0.25, (0.875, 0), 0.25), True)
            self.assertIs(grid.overlap((0.25, 0), 0.125, (0.875, 0), 0.25), False)
            with self.assertRaisesRegex(ValueError, "radius_b = -1"):
                grid.overlap((0.25, 0), 0.125, (0.875, 0), -1)
            with self.assertRaisesRegex(ValueError, r"center_b must have shape \(2,\)"):
                grid.overlap((0.25, 0), 0.125, (0.875, 0, 0), 1)


if __name__ == "__main__":
    unittest.main()
