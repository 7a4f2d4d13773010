# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Arrays in: any numeric type, order and stride, as contiguous arrays of the library's types. Arrays out: copies."""

import numpy as np

from .errors import ArgumentError, NotFoundError

_ID_RANGE = np.iinfo(np.int32)


def _shape_text(shape):
    return "(" + ", ".join(str(extent) for extent in shape) + (",)" if len(shape) == 1 else ")")


def check_shape(array, name, shape):
    """Refuses an array unless its shape is `shape`, in which a string stands for any extent."""
    extents = zip(shape, array.shape)
    if array.ndim != len(shape) or not all(isinstance(wanted, str) or wanted == has for wanted, has in extents):
        raise ArgumentError(f"{name} must have shape {_shape_text(shape)}, not {_shape_text(array.shape)}")


def _rows(values, shape):
    """`values` as an array. An empty list does not tell how long its rows would be: it has those of `shape`."""
    array = np.asarray(values)
    return array.reshape((0, *shape[1:])) if array.shape == (0,) and isinstance(shape[0], str) else array


def reals(values, name, shape):
    """`values` as a contiguous float64 array of that shape; copied only if it is not one already."""
    array = _rows(values, shape)
    check_shape(array, name, shape)
    if not np.can_cast(array.dtype, np.float64, casting="same_kind"):
        raise TypeError(f"{name} must hold real numbers, not {array.dtype}")
    return np.require(array, np.float64, ["C_CONTIGUOUS", "ALIGNED"])


def _int32(array, name, refuse):
    """`array` as contiguous int32; refuse(index, value) raises for the first value that does not fit."""
    if array.size == 0:
        return np.empty(array.shape, dtype=np.int32)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name} must hold integers, not {array.dtype}")
    outside = np.argwhere((array < _ID_RANGE.min) | (array > _ID_RANGE.max))
    if outside.size > 0:
        index = tuple(outside[0])
        refuse("".join(f"[{k}]" for k in index), array[index])
    return np.require(array, np.int32, ["C_CONTIGUOUS", "ALIGNED"])


def ids(values, name):
    """`values` as a contiguous int32 array of shape (n,)."""

    def refuse(index, value):
        raise NotFoundError(f"{name}{index} = {value}: no particle has that id")

    array = np.asarray(values)
    check_shape(array, name, ("n",))
    return _int32(array, name, refuse)


def _integers(values, name, shape):
    def refuse(index, value):
        raise ArgumentError(f"{name}{index} = {value}: does not fit in 32 bits")

    array = _rows(values, shape)
    check_shape(array, name, shape)
    return _int32(array, name, refuse)


def numbers(values, name):
    """`values` as a contiguous int32 array of shape (n,)."""
    return _integers(values, name, ("n",))


def pairs(values, name):
    """`values` as a contiguous int32 array of shape (m, 2)."""
    return _integers(values, name, ("m", 2))


def copy_out(lent):
    """What the library lends, a view of its memory or a list of them, as arrays that own theirs."""
    if isinstance(lent, list):
        return tuple(copy_out(view) for view in lent)
    with lent:
        return np.array(lent)
