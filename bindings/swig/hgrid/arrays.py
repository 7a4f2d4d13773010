# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Arrays in: any numeric type, order and stride, as contiguous arrays of the library's types. Arrays out: copies."""

import numpy as np

from .errors import ArgumentError, NotFoundError


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


def _index_text(index):
    return "".join(f"[{k}]" for k in index)


def _check_doubles(array, name):
    """Refuses integers that no double holds: those of more than 53 bits from the first to the last that is set."""
    magnitude = np.where(array < 0, -array, array).astype(np.uint64)
    large = magnitude > 2**53
    lowest = magnitude[large] & -magnitude[large]
    for place in np.flatnonzero(magnitude[large] // lowest > 2**53)[:1]:
        index = tuple(np.argwhere(large)[place])
        raise ArgumentError(f"{name}{_index_text(index)} = {array[index]}: a double cannot hold it exactly")


def reals(values, name, shape):
    """`values` as a contiguous float64 array of that shape; copied only if it is not one already."""
    array = _rows(values, shape)
    check_shape(array, name, shape)
    if not np.can_cast(array.dtype, np.float64, casting="same_kind"):
        raise TypeError(f"{name} must hold real numbers, not {array.dtype}")
    if array.dtype.kind in "iu" and array.dtype.itemsize == 8:
        _check_doubles(array, name)
    return np.require(array, np.float64, ["C_CONTIGUOUS", "ALIGNED"])


def _integers(array, name, kind, refuse):
    """`array` as contiguous integers of that kind; refuse(index, value) raises for the first that does not fit."""
    if array.size == 0:
        return np.empty(array.shape, dtype=kind)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name} must hold integers, not {array.dtype}")
    limits = np.iinfo(kind)
    outside = np.argwhere((array < limits.min) | (array > limits.max))
    if outside.size > 0:
        index = tuple(outside[0])
        refuse(_index_text(index), array[index])
    return np.require(array, kind, ["C_CONTIGUOUS", "ALIGNED"])


def ids(values, name):
    """`values` as a contiguous int32 array of shape (n,)."""

    def refuse(index, value):
        raise NotFoundError(f"{name}{index} = {value}: no particle has that id")

    array = np.asarray(values)
    check_shape(array, name, ("n",))
    return _integers(array, name, np.int32, refuse)


def _fitting(array, name, kind):
    """`array` as contiguous integers of that kind."""

    def refuse(index, value):
        raise ArgumentError(f"{name}{index} = {value}: does not fit in {np.iinfo(kind).bits} bits")

    return _integers(array, name, kind, refuse)


def numbers(values, name):
    """`values` as a contiguous int32 array of shape (n,)."""
    array = np.asarray(values)
    check_shape(array, name, ("n",))
    return _fitting(array, name, np.int32)


def gids(values, name, count):
    """`values` as a contiguous int64 array of shape (count,)."""
    array = np.asarray(values)
    check_shape(array, name, (count,))
    return _fitting(array, name, np.int64)


def contacts(values, name):
    """`values` as a contiguous array of pairs, int32 of shape (m, 2), or of keys, int64 of shape (m, 3)."""
    array = _rows(values, ("m", 2))
    keyed = array.ndim == 2 and array.shape[1] == 3
    check_shape(array, name, ("m", 3 if keyed else 2))
    return _fitting(array, name, np.int64 if keyed else np.int32)


def copy_out(lent):
    """What the library lends, a view of its memory or a list of them, as arrays that own theirs."""
    if isinstance(lent, list):
        return tuple(copy_out(view) for view in lent)
    with lent:
        return np.array(lent)
