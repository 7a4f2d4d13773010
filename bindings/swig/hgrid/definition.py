# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""What defines a grid: the arguments that its users give, as a definition of the C interface."""

import operator

import numpy as np

from . import arrays, boxes, capi
from .errors import ArgumentError

_INTERACTIONS = {"contact": capi.HG_CONTACT, "max_range": capi.HG_MAX_RANGE}
_ACCURACIES = {"exact": capi.HG_EXACT, "double": capi.HG_DOUBLE, "float": capi.HG_FLOAT}
_ORDERS = {"grid": capi.HG_ORDER_GRID, "id": capi.HG_ORDER_ID}
_IMAGES = {"nearest": capi.HG_NEAREST_IMAGE, "all": capi.HG_ALL_IMAGES}
_LEVEL_RULES = {"auto": capi.HG_LEVELS_AUTO, "paper": capi.HG_LEVELS_PAPER, "user": capi.HG_LEVELS_USER}


def choice(name, value, words):
    """The constant for a word; a number passes through and is judged by the library."""
    if not isinstance(value, str):
        return operator.index(value)
    if value not in words:
        raise ArgumentError(f"{name} is {value!r}; it must be one of {', '.join(map(repr, words))}")
    return words[value]


def _flags(periodic, dimension):
    """One number per axis, 0 or 1; those that the dimension lacks stay open."""
    flags = np.asarray(periodic)
    arrays.check_shape(flags, "periodic", (dimension,))
    if flags.dtype.kind not in "biu":
        raise TypeError(f"periodic must hold truth values, not {flags.dtype}")
    return [float(bool(flag)) for flag in flags] + [0.0] * (3 - dimension)


class Defined:
    """What is made from the arguments of hgrid.Grid: it provides _create(definition, cell_sizes)."""

    def __init__(
        self,
        dimension=3,
        *,
        periodic=None,
        box=None,
        tilt=None,
        touching=False,
        images="nearest",
        thread_count=0,
        index_base=0,
        interaction="contact",
        accuracy="exact",
        order="grid",
        levels=None,
        level_count=0,
        cell_sizes=None,
        margin=0.0,
        skin=0.0,
        cell_overhead=-1.0,
        level_price=-1.0,
        row_price=-1.0,
    ):
        """Creates an empty grid; the arguments are explained at the class."""
        self._dimension = operator.index(dimension)
        if self._dimension not in (2, 3):
            raise ArgumentError(f"dimension is {self._dimension}; it must be 2 or 3")
        if levels is None:
            levels = "auto" if cell_sizes is None else "user"
        definition = capi.hg_grid_def()
        definition.dimension = self._dimension
        definition.thread_count = operator.index(thread_count)
        definition.index_base = operator.index(index_base)
        definition.interaction = choice("interaction", interaction, _INTERACTIONS)
        definition.accuracy = choice("accuracy", accuracy, _ACCURACIES)
        definition.pair_order = choice("order", order, _ORDERS)
        definition.level_rule = choice("levels", levels, _LEVEL_RULES)
        definition.level_count = operator.index(level_count)
        definition.margin = float(margin)
        definition.skin = float(skin)
        definition.cell_overhead = float(cell_overhead)
        definition.level_price = float(level_price)
        definition.row_price = float(row_price)
        if periodic is not None:
            definition.periodic = _flags(periodic, self._dimension)
        definition.box_min, definition.box_max, definition.tilt = boxes.corners_and_tilt(box, tilt, self._dimension)
        definition.touching = int(bool(touching))
        definition.images = choice("images", images, _IMAGES)
        sizes = arrays.reals([] if cell_sizes is None else cell_sizes, "cell_sizes", ("level_count",))
        if sizes.size > 0 and definition.level_rule != capi.HG_LEVELS_USER:
            raise ArgumentError("cell_sizes are given, but levels is not 'user'")
        if sizes.size > 0 and definition.level_count not in (0, sizes.size):
            raise ArgumentError(f"level_count is {definition.level_count}, but {sizes.size} cell_sizes are given")
        self._create(definition, sizes)
