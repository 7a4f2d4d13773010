# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""The exceptions, one for each kind of status of the C interface."""

from . import capi


class Error(Exception):
    """A call of the library failed. `status` is its HG_ERR_... value; the text names the index and value at fault."""

    status = capi.HG_ERR_INTERNAL

    def __str__(self):
        # KeyError, a base of NotFoundError, would print the text in quotes.
        return Exception.__str__(self)


class ArgumentError(Error, ValueError):
    """A value is out of its range or an array has the wrong shape."""

    status = capi.HG_ERR_ARGUMENT


class OutOfMemoryError(Error, MemoryError):
    """Memory could not be had; the grid is as it was before the call."""

    status = capi.HG_ERR_MEMORY


class StateError(Error, RuntimeError):
    """The call is not allowed now: the grid is closed, or one of its own visitors is running."""

    status = capi.HG_ERR_STATE


class NotFoundError(Error, KeyError):
    """No particle has that id."""

    status = capi.HG_ERR_NOT_FOUND


class LimitError(Error, OverflowError):
    """A documented limit is exceeded: number of particles, of levels, of box lengths."""

    status = capi.HG_ERR_LIMIT


_CLASSES = {kind.status: kind for kind in (ArgumentError, OutOfMemoryError, StateError, NotFoundError, LimitError)}


def from_status(status, text):
    """The exception for a status of the C interface; called by the extension module."""
    error = _CLASSES.get(status, Error)(text or capi.hg_status_string(status))
    error.status = status
    return error
