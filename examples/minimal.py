# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# The contacts of a large, a middle and a small sphere.
import hgrid

x = [[0, 0, 0], [10.5, 0, 0], [11.75, 0, 0]]
r = [10, 1, 0.5]

with hgrid.Grid() as grid:
    grid.insert(x, r)
    for a, b in grid.query_pairs():
        print(a, "meets", b)
