# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Arrays in: every real type, order, stride and sequence, and the refusal of wrong shapes and types."""

import unittest

import numpy as np
from oracle import ascending, exact_pairs, polydisperse

import hgrid


def pairs_of(x, r):
    with hgrid.Grid() as grid:
        grid.insert(x, r)
        return ascending(grid.query_pairs())


class Accepted(unittest.TestCase):
    def setUp(self):
        self.x, self.r = polydisperse(61, 120)
        self.wanted = exact_pairs(self.x, self.r)

    def test_types(self):
        whole_x = np.floor(20 * self.x)
        whole_r = np.ceil(10 * self.r)
        wanted = exact_pairs(whole_x, whole_r)
        for dtype in "f2 f4 f8 g i1 i2 i4 i8 u1 u2 u4 u8 >f8 >f4 >i4".split():
            with self.subTest(dtype=dtype):
                np.testing.assert_array_equal(pairs_of(whole_x.astype(dtype), whole_r.astype(dtype)), wanted)

    def test_float32_values_are_taken_as_they_are(self):
        x, r = self.x.astype(np.float32), self.r.astype(np.float32)
        np.testing.assert_array_equal(pairs_of(x, r), exact_pairs(x, r))

    def test_orders_and_strides(self):
        wide = np.zeros((240, 6))
        wide[::2, ::2] = self.x
        radii = np.zeros(360)
        radii[::3] = self.r
        unaligned = np.frombuffer(b"-" + self.x.tobytes(), dtype=np.uint8)[1:].view(np.float64).reshape(-1, 3)
        variants = {
            "column major": np.asfortranarray(self.x),
            "columns stacked": np.array(self.x.T, order="C").T,
            "every second": wide[::2, ::2],
            "backwards": self.x[::-1].copy()[::-1],
            "not aligned": unaligned,
        }
        for name, x in variants.items():
            with self.subTest(name):
                np.testing.assert_array_equal(pairs_of(x, radii[::3]), self.wanted)

    def test_read_only_arrays_and_lists(self):
        self.x.flags.writeable = False
        self.r.flags.writeable = False
        np.testing.assert_array_equal(pairs_of(self.x, self.r), self.wanted)
        np.testing.assert_array_equal(pairs_of(self.x.tolist(), tuple(self.r)), self.wanted)

    def test_ids_of_every_integer_type(self):
        for dtype in (np.int8, np.uint8, np.int32, np.int64, np.uint64):
            with self.subTest(dtype=dtype), hgrid.Grid() as grid:
                grid.insert(self.x, self.r)
                grid.remove(np.arange(0, 100, 2, dtype=dtype)[::-1])
                self.assertEqual(grid.stats.particle_count, 70)
        with hgrid.Grid() as grid:
            grid.insert(self.x, self.r)
            grid.remove([])
            grid.remove((3, 5))
            self.assertEqual(grid.stats.particle_count, 118)


class Refused(unittest.TestCase):
    def setUp(self):
        self.grid = hgrid.Grid()
        self.addCleanup(self.grid.close)
        self.x, self.r = polydisperse(62, 5)
        self.grid.insert(self.x, self.r)

    def refuse_shape(self, call, text):
        with self.assertRaises(hgrid.ArgumentError) as caught:
            call()
        self.assertIn(text, str(caught.exception))

    def test_shapes(self):
        grid, x, r = self.grid, self.x, self.r
        self.refuse_shape(lambda: grid.insert(x[:, :2], r), "x must have shape (n, 3), not (5, 2)")
        self.refuse_shape(lambda: grid.insert(x.ravel(), r), "x must have shape (n, 3), not (15,)")
        self.refuse_shape(lambda: grid.insert(x[None], r), "x must have shape (n, 3), not (1, 5, 3)")
        self.refuse_shape(lambda: grid.insert(x, r[:4]), "r must have shape (5,), not (4,)")
        self.refuse_shape(lambda: grid.insert(x, r[:, None]), "r must have shape (5,), not (5, 1)")
        self.refuse_shape(lambda: grid.insert(x, 0.5), "r must have shape (5,), not ()")
        self.refuse_shape(lambda: grid.move(x.T), "x must have shape (n, 3), not (3, 5)")
        self.refuse_shape(lambda: grid.move(x, r[:2]), "r must have shape (5,), not (2,)")
        self.refuse_shape(lambda: grid.remove([[1, 2]]), "ids must have shape (n,), not (1, 2)")
        self.refuse_shape(lambda: grid.remove(1), "ids must have shape (n,), not ()")
        self.refuse_shape(lambda: grid.query_sphere((1, 2), 1), "center must have shape (3,), not (2,)")
        self.refuse_shape(lambda: grid.query_spheres(x, 1), "radii must have shape (5,), not ()")
        self.refuse_shape(lambda: grid.query_spheres(x[:, :2], r), "centers must have shape (n, 3), not (5, 2)")
        self.refuse_shape(lambda: hgrid.Grid(box=((0, 0), (1, 1))), "box must have shape (2, 3), not (2, 2)")
        self.refuse_shape(lambda: hgrid.Grid(periodic=(True,)), "periodic must have shape (3,), not (1,)")
        self.refuse_shape(lambda: hgrid.Grid(cell_sizes=[[1]]), "cell_sizes must have shape (level_count,), not (1, 1)")
        self.assertEqual(grid.stats.particle_count, 5)

    def test_integers_that_no_double_holds(self):
        held = np.array([0, 1, -1, 2**53, -(2**53), 2**53 + 2, 2**62 + 2**10, -(2**63), 2**63 - 2**10])
        for value in (2**53 + 1, -(2**53) - 1, 2**62 + 2**9, 2**63 - 1, 2**63 + 1, 2**64 - 1):
            x = np.zeros((5, 3), dtype=np.int64 if value < 2**63 else np.uint64)
            x[3, 1] = value
            with self.subTest(value=value):
                text = rf"x\[3\]\[1\] = {value}: a double cannot hold it exactly"
                self.assertRaisesRegex(hgrid.ArgumentError, text, self.grid.move, x)
        hgrid.arrays.reals(held, "held", (len(held),))
        hgrid.arrays.reals(np.array([2**63, 2**64 - 2**11], dtype=np.uint64), "held", (2,))
        text = r"center\[2\] = 9007199254740993"
        self.assertRaisesRegex(hgrid.ArgumentError, text, self.grid.query_sphere, [0, 0, 2**53 + 1], 1)

    def test_types(self):
        for wrong in (self.x.astype(complex), self.x.astype(str), self.x.astype(object), self.x.astype("M8[s]")):
            with self.subTest(dtype=wrong.dtype), self.assertRaisesRegex(TypeError, "x must hold real numbers"):
                self.grid.insert(wrong, self.r)
        with self.assertRaisesRegex(TypeError, "ids must hold integers, not float64"):
            self.grid.remove([0.0])
        with self.assertRaisesRegex(TypeError, "ids must hold integers, not bool"):
            self.grid.remove([True, False])
        with self.assertRaisesRegex(TypeError, "periodic must hold truth values"):
            hgrid.Grid(periodic=("yes", "no", "no"))
        self.assertEqual(self.grid.stats.particle_count, 5)


if __name__ == "__main__":
    unittest.main()
