# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
from typing import Final

from .atoms import neighbor_list as neighbor_list
from .errors import (
    ArgumentError as ArgumentError,
    Error as Error,
    LimitError as LimitError,
    NotFoundError as NotFoundError,
    OutOfMemoryError as OutOfMemoryError,
    StateError as StateError,
)
from .grid import Grid as Grid
from .history import History as History
from .records import Ended as Ended, Level as Level, LevelCost as LevelCost, Stats as Stats

HG_ALL_IMAGES: Final[int]
HG_CONTACT: Final[int]
HG_DOUBLE: Final[int]
HG_ERR_ARGUMENT: Final[int]
HG_ERR_CAPACITY: Final[int]
HG_ERR_INTERNAL: Final[int]
HG_ERR_LIMIT: Final[int]
HG_ERR_MEMORY: Final[int]
HG_ERR_MPI: Final[int]
HG_ERR_NOT_FOUND: Final[int]
HG_ERR_NULL: Final[int]
HG_ERR_REMOTE: Final[int]
HG_ERR_STATE: Final[int]
HG_EXACT: Final[int]
HG_FLOAT: Final[int]
HG_LEVELS_AUTO: Final[int]
HG_LEVELS_PAPER: Final[int]
HG_LEVELS_USER: Final[int]
HG_MAX_BATCH: Final[int]
HG_MAX_GROUPS: Final[int]
HG_MAX_LEVELS: Final[int]
HG_MAX_RANGE: Final[int]
HG_NEAREST_IMAGE: Final[int]
HG_OK: Final[int]
HG_ORDER_GRID: Final[int]
HG_ORDER_ID: Final[int]

__version__: str

def version() -> tuple[int, int, int]: ...
