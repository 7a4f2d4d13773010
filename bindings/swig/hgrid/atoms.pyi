# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
from collections.abc import Mapping
from typing import Any

import numpy.typing as npt

def neighbor_list(
    quantities: str,
    a: Any = None,
    cutoff: float | npt.ArrayLike | Mapping[Any, float] | None = None,
    self_interaction: bool = False,
    max_nbins: float | None = None,
    *,
    positions: npt.ArrayLike | None = None,
    cell: npt.ArrayLike | None = None,
    pbc: npt.ArrayLike | None = None,
    numbers: npt.ArrayLike | None = None,
) -> Any: ...
