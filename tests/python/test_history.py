# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Contact histories against a dictionary from pairs to places."""

import copy
import pickle
import unittest

import numpy as np
from oracle import polydisperse

import hgrid

BEFORE = [(1, 2), (7, 9), (3, 4)]
AFTER = [(3, 4), (9, 7), (1, 2), (-1, -2147483648)]


class Matching(unittest.TestCase):
    def setUp(self):
        self.history = hgrid.History()
        self.history.update(BEFORE)
        self.previous = self.history.update(AFTER)

    def test_places(self):
        self.assertEqual(self.previous.dtype, np.int64)
        self.assertEqual(self.previous.tolist(), [2, -1, 0, -1])
        self.previous[...] = 7
        self.assertEqual(self.history.carry([10, 11, 12]).tolist(), [12, 0, 10, 0])

    def test_carries_any_type_and_shape(self):
        springs = np.arange(9.0).reshape(3, 3)
        self.assertEqual(self.history.carry(springs).tolist(), [[6, 7, 8], [0, 0, 0], [0, 1, 2], [0, 0, 0]])
        flags = self.history.carry(np.array([True, False, True]))
        self.assertEqual((flags.dtype, flags.tolist()), (np.dtype(bool), [True, False, True, False]))
        record = np.array([(1, 0.5), (2, 1.5), (3, 2.5)], dtype=[("age", "i4"), ("length", "f8")])
        self.assertEqual(self.history.carry(record)["age"].tolist(), [3, 0, 1, 0])
        self.assertEqual(self.history.carry(springs[:, ::-2]).tolist()[0], [8, 6])

    def test_pairs_and_restore(self):
        self.assertEqual(self.history.pairs.tolist(), [list(pair) for pair in AFTER])
        other = hgrid.History()
        self.assertEqual(other.pairs.shape, (0, 2))
        other.restore(self.history.pairs)
        self.assertEqual(other.update(BEFORE).tolist(), self.history.update(BEFORE).tolist())
        self.assertEqual(other.carry([5, 6, 7, 8]).tolist(), [7, 0, 5])

    def test_clear(self):
        self.history.clear()
        self.assertEqual(self.history.update(AFTER).tolist(), [-1] * 4)

    def test_empty_lists(self):
        self.assertEqual(self.history.update(np.empty((0, 2), dtype=np.int32)).tolist(), [])
        self.assertEqual(self.history.carry(np.zeros((4, 3))).shape, (0, 3))

    def test_follows_a_grid(self):
        x, r = polydisperse(91, 600, largest=0.1)
        rng = np.random.default_rng(91)
        history, places = hgrid.History(), {}
        with hgrid.Grid() as grid:
            grid.insert(x, r)
            for step in range(4):
                pairs = grid.query_pairs()
                expected = [places.get(tuple(pair), -1) for pair in pairs.tolist()]
                self.assertEqual(history.update(pairs).tolist(), expected)
                places = {tuple(pair): k for k, pair in enumerate(pairs.tolist())}
                x = x + rng.normal(scale=0.002, size=x.shape)
                grid.move(x)
        self.assertGreater(sum(place >= 0 for place in expected), 100)
        self.assertIn(-1, expected)


class Keys(unittest.TestCase):
    FIRST = [(1, 2, 0), (1, 2, 1), (2**40, 2, -3)]

    def setUp(self):
        self.history = hgrid.History()

    def test_sub_keys_tell_contacts_apart(self):
        self.assertEqual(self.history.update(self.FIRST).tolist(), [-1, -1, -1])
        self.assertEqual(self.history.update([(2**40, 2, -3), (1, 2, 7), (1, 2, 0)]).tolist(), [2, -1, 0])
        self.assertEqual(self.history.carry([1.5, 2.5, 3.5]).tolist(), [3.5, 0, 1.5])
        self.assertEqual(self.history.pairs.dtype, np.int64)
        other = hgrid.History()
        other.restore(self.history.pairs)
        self.assertEqual(other.pairs.tolist(), [[2**40, 2, -3], [1, 2, 7], [1, 2, 0]])

    def test_pairs_before_and_after_keys(self):
        self.history.update([(1, 2), (3, 4)])
        self.assertEqual(self.history.update([(3, 4, 1), (1, 2, 0)]).tolist(), [-1, 0])
        self.assertEqual(self.history.update([(1, 2), (3, 4)]).tolist(), [1, -1])
        pairs, places = self.history.ended()
        self.assertEqual((pairs.tolist(), places.tolist()), ([[3, 4, 1]], [0]))

    def test_images_of_a_pair(self):
        x = np.array([[0.25, 0, 0], [0.75, 0, 0]])
        with hgrid.Grid(periodic=(True, False, False), box=np.diag([1.0, 1, 1]), images="all") as grid:
            grid.set(x, [0.3, 0.3])
            for expected in ([-1, -1], [0, 1]):
                pairs, shifts = grid.query_pairs(shifts=True)
                self.assertRaises(hgrid.ArgumentError, self.history.update, pairs)
                keys = np.column_stack((pairs, shifts[:, 0]))
                self.assertEqual(self.history.update(keys).tolist(), expected)

    def test_errors(self):
        with self.assertRaisesRegex(hgrid.ArgumentError, r"keys\[1\] = \(1, 2, 3\) is already listed as keys\[0\]"):
            self.history.update([(1, 2, 3), (1, 2, 3)])
        with self.assertRaisesRegex(hgrid.ArgumentError, r"pairs\[0\]\[2\] = 9223372036854775808: .* in 64 bits"):
            self.history.update(np.array([(1, 2, 2**63)], dtype=np.uint64))
        with self.assertRaisesRegex(hgrid.ArgumentError, r"pairs must have shape \(m, 2\), not \(1, 4\)"):
            self.history.update([(1, 2, 3, 4)])


class Ended(unittest.TestCase):
    def test_contacts_that_are_no_more(self):
        history = hgrid.History()
        self.assertRaises(hgrid.StateError, history.ended)
        history.update(BEFORE)
        self.assertEqual(history.ended().pairs.shape, (0, 2))
        history.update(AFTER)
        ended = history.ended()
        self.assertEqual(ended.pairs.tolist(), [[7, 9]])
        self.assertEqual(np.array([0.5, 1.5, 2.5])[ended.places].tolist(), [1.5])
        self.assertRaises(hgrid.ArgumentError, history.update, [(0, 0), (0, 0)])
        self.assertEqual(history.ended().pairs.tolist(), [[7, 9]])
        history.update([])
        self.assertEqual(history.ended().places.tolist(), [0, 1, 2, 3])
        self.assertEqual(ended.pairs.tolist(), [[7, 9]])
        history.restore(BEFORE)
        self.assertRaises(hgrid.StateError, history.ended)


class Errors(unittest.TestCase):
    def setUp(self):
        self.history = hgrid.History()

    def test_a_pair_twice(self):
        for call in (self.history.update, self.history.restore):
            with self.assertRaisesRegex(hgrid.ArgumentError, r"pairs\[2\] = \(1, 2\) is already listed as pairs\[0\]"):
                call([(1, 2), (3, 4), (1, 2)])

    def test_a_failed_update_changes_nothing(self):
        self.history.update(BEFORE)
        self.history.update(AFTER)
        with self.assertRaises(hgrid.ArgumentError):
            self.history.update([(0, 0), (0, 0)])
        self.assertEqual(self.history.carry([10, 11, 12]).tolist(), [12, 0, 10, 0])

    def test_shapes_and_types(self):
        with self.assertRaisesRegex(hgrid.ArgumentError, r"pairs must have shape \(m, 2\), not \(3,\)"):
            self.history.update([1, 2, 3])
        with self.assertRaisesRegex(hgrid.ArgumentError, r"pairs\[1\]\[0\] = 2147483648"):
            self.history.update([(1, 2), (2147483648, 3)])
        with self.assertRaisesRegex(TypeError, "pairs must hold integers"):
            self.history.update([(1.5, 2)])

    def test_nothing_to_carry(self):
        for prepare in (lambda: None, self.history.clear, lambda: self.history.restore(BEFORE)):
            prepare()
            with self.assertRaises(hgrid.StateError):
                self.history.carry([1, 2, 3])

    def test_items_must_fit_the_former_list(self):
        self.history.update(BEFORE)
        self.history.update(AFTER)
        with self.assertRaisesRegex(hgrid.ArgumentError, r"items must have shape \(3, 2\), not \(4, 2\)"):
            self.history.carry(np.zeros((4, 2)))

    def test_cannot_be_copied(self):
        for attempt in (copy.copy, copy.deepcopy, pickle.dumps):
            with self.subTest(attempt=attempt.__name__), self.assertRaises(TypeError):
                attempt(self.history)


if __name__ == "__main__":
    unittest.main()
