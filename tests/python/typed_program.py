# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""A program as users write them, which type checkers must accept; test_types.py shows it to mypy."""

import numpy as np
import numpy.typing as npt

import hgrid

with hgrid.Grid(periodic=(True, True, False), box=((0, 0, 0), (4, 4, 4)), images="all", order="id") as grid:
    grid.set([[0.5, 0.5, 0.5], [1, 0.5, 0.5]], np.array([0.3, 0.3], dtype=np.float32))
    grid.set_groups([0, 1])
    pairs: npt.NDArray[np.int32] = grid.query_pairs()
    same, vectors = grid.query_pairs(vectors=True)
    all_three = grid.query_pairs(vectors=True, shifts=True)
    lengths: npt.NDArray[np.float64] = np.sqrt((vectors**2).sum(axis=1))
    shifts: npt.NDArray[np.int32] = all_three[2]
    offsets, neighbors = grid.query_neighbors(full=True)
    count: int = grid.stats.pair_count
    finest: float = grid.levels[0].cell_size

history = hgrid.History()
previous: npt.NDArray[np.int64] = history.update(pairs)
ended: npt.NDArray[np.int64] = history.ended().places
try:
    i, j = hgrid.neighbor_list("ij", [[0, 0, 0], [1, 0, 0]], 1.5)
except hgrid.ArgumentError as error:
    print(error.status, hgrid.HG_EXACT, hgrid.__version__)
