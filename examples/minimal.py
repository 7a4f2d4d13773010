# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Finds the contacts among spheres whose radii differ by a factor of a hundred.
import numpy as np

import hgrid

rng = np.random.default_rng(1)
x = rng.random((10000, 3))  # centres in the unit cube
r = 0.001 / (1 - 0.99 * rng.random(10000))  # radii from 0.001 to 0.1

with hgrid.Grid(dimension=3, periodic=(True, True, False), box=((0, 0, 0), (1, 1, 1))) as grid:
    grid.insert(x, r)
    pairs = grid.query_pairs()  # int32, shape (m, 2)
    print(len(pairs), "contacts on", len(grid.levels), "levels")
