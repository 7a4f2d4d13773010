# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Every overlapping pair among particles of very different sizes.

    import hgrid
    with hgrid.Grid(dimension=3) as grid:
        grid.insert(x, r)               # numpy (n, 3) and (n,)
        pairs = grid.query_pairs()      # numpy int32 (m, 2)

The class Grid does the work, the class History lets data follow contacts; help(hgrid.Grid) tells all. Failures raise hgrid.Error or one of its subclasses. The
constants HG_... are those of the C interface.
"""

from .capi import (
    HG_ALL_IMAGES,
    HG_CONTACT,
    HG_DOUBLE,
    HG_ERR_ARGUMENT,
    HG_ERR_CAPACITY,
    HG_ERR_INTERNAL,
    HG_ERR_LIMIT,
    HG_ERR_MEMORY,
    HG_ERR_MPI,
    HG_ERR_NOT_FOUND,
    HG_ERR_NULL,
    HG_ERR_REMOTE,
    HG_ERR_STATE,
    HG_EXACT,
    HG_FLOAT,
    HG_LEVELS_AUTO,
    HG_LEVELS_PAPER,
    HG_LEVELS_USER,
    HG_MAX_BATCH,
    HG_MAX_GROUPS,
    HG_MAX_LEVELS,
    HG_MAX_RANGE,
    HG_NEAREST_IMAGE,
    HG_OK,
    HG_ORDER_GRID,
    HG_ORDER_ID,
    hg_version as _hg_version,
)
from .atoms import neighbor_list
from .errors import ArgumentError, Error, LimitError, NotFoundError, OutOfMemoryError, StateError
from .grid import Grid
from .history import History
from .records import Ended, Level, LevelCost, Stats


def version():
    """The version of the loaded library as a tuple (major, minor, patch)."""
    return tuple(_hg_version())


__version__ = ".".join(str(number) for number in version())

__all__ = [name for name in dir() if name.startswith("HG_")] + [
    "ArgumentError",
    "Ended",
    "Error",
    "Grid",
    "History",
    "Level",
    "LevelCost",
    "LimitError",
    "NotFoundError",
    "OutOfMemoryError",
    "StateError",
    "Stats",
    "neighbor_list",
    "version",
]
