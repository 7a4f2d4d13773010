# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Periodic boxes as users write them: two corners and a tilt, or a matrix of edges."""

import numpy as np

from . import arrays
from .errors import ArgumentError


def _edges(matrix):
    """Corner, corner and tilt of the cell with these edges, whose corner is the origin."""
    for row, column in ((0, 1), (0, 2), (1, 2)):
        if matrix[row, column] != 0:
            raise ArgumentError(
                "a box of three edges must be lower triangular, ((ax, 0, 0), (bx, by, 0), (cx, cy, cz)), "
                f"but box[{row}][{column}] = {matrix[row, column]}: turn the cell and the particles"
            )
    return np.zeros(3), np.diagonal(matrix).copy(), np.array([matrix[1, 0], matrix[2, 0], matrix[2, 1]])


def _tilt(tilt, dimension):
    values = np.atleast_1d(tilt)
    if dimension == 2 and values.shape == (1,):
        values = np.append(values, [0.0, 0.0])
    return arrays.reals(values, "tilt", (3,))


def corners_and_tilt(box, tilt, dimension):
    """What users say of a box as box_min, box_max and tilt of the C interface, three numbers each.

    In two dimensions a matrix of edges would look like two corners: there, box is always the latter.
    """
    lean = np.zeros(3) if tilt is None else _tilt(tilt, dimension)
    if box is None:
        return np.zeros(3), np.zeros(3), lean
    numbers = np.asarray(box)
    if dimension == 3 and numbers.shape == (3, 3):
        if tilt is not None:
            raise ArgumentError("a box of three edges has its tilt in it, so tilt cannot be given")
        return _edges(arrays.reals(numbers, "box", (3, 3)))
    corners = np.zeros((2, 3))
    corners[:, :dimension] = arrays.reals(numbers, "box", (2, dimension))
    return corners[0], corners[1], lean
