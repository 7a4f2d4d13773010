# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
from typing import Any, NamedTuple, TypeVar

import numpy as np
import numpy.typing as npt

class Level(NamedTuple):
    cell_size: float
    largest_radius: float
    occupancy: float
    particle_count: int

class LevelCost(NamedTuple):
    level_count: int
    reachable: int
    occupancy: float
    cost: float

class Stats(NamedTuple):
    particle_count: int
    level_count: int
    row_count: int
    cell_count: int
    candidate_count: int
    undecided_count: int
    exact_count: int
    pair_count: int
    build_count: int
    search_count: int
    byte_count: int
    filter_count: int
    stored_count: int

class Ended(NamedTuple):
    pairs: npt.NDArray[np.int32] | npt.NDArray[np.int64]
    places: npt.NDArray[np.int64]

_Record = TypeVar("_Record", Level, LevelCost, Stats)

def record(kind: type[_Record], struct: Any) -> _Record: ...
