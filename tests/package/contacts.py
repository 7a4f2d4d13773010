# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""A user's Python program: the version of the library and the two contacts among three spheres."""

import hgrid
import numpy

x = numpy.zeros((3, 3))
x[:, 0] = (0.0, 1.5, 3.0)
r = numpy.array((1.0, 0.8, 0.9))

grid = hgrid.Grid(order="id")
grid.insert(x, r)
print("hgrid", hgrid.__version__)
for a, b in grid.query_pairs():
    print(a, b)
