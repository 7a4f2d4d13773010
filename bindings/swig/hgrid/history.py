# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""The class History: per-contact data that follows its contacts from list to list."""

import threading

import numpy as np

from . import arrays, capi
from .errors import StateError
from .records import Ended


def _by_kind(shape, of_pairs, of_keys):
    """The call for lists of that shape."""
    return of_keys if shape[1] == 3 else of_pairs


class History:
    """Matches each list of contacts to the one before, so that data of contacts can follow them.

        previous = history.update(pairs)      # int64 (m,): the place of each pair in the former list, -1 if it is new
        spring = history.carry(spring)        # one item for each pair of the new list, zero for new ones

    Pairs have shape (m, 2) and may be in any order; (a, b) is not (b, a). Any 32-bit integers will do, so that contacts
    with walls may stand in the same list, under ids that no particle has. Where two particles have several contacts at
    a time, lists of keys, shape (m, 3), tell them apart by a third number, a sub-key that stays the same while the
    contact lasts: the number of a triangle of a wall, a place on a clump, or which periodic image it is (the shifts of
    Grid.query_pairs tell that for positions that are never wrapped into the box). Keys may hold any 64-bit integers.
    Lists of both kinds may follow one another: (a, b) is (a, b, 0).

    Lists are copied, results belong to you. A history may be used from several threads; calls on one history wait for
    each other.
    """

    def __init__(self):
        """Creates a history that remembers an empty list."""
        self._lock = threading.RLock()
        self._handle = capi.hg_history_create()
        self._shape = self._former_shape = (0, 2)
        self._previous = None

    def __reduce__(self):
        raise TypeError("a History can be neither copied nor pickled; give its pairs to restore() of another")

    def update(self, pairs):
        """Matches a list, shape (m, 2) or (m, 3), to the remembered one, and remembers it instead.

        Returns the place of each contact in the former list, int64 of shape (m,), or -1 for a new one. ArgumentError
        names a contact listed twice or a number that does not fit; then nothing has changed.
        """
        wanted = arrays.contacts(pairs, "pairs")
        call = _by_kind(wanted.shape, capi.hg_history_update, capi.hg_history_update_keys)
        with self._lock:
            self._previous = arrays.copy_out(call(self._handle, wanted))
            self._former_shape, self._shape = self._shape, wanted.shape
            return self._previous.copy()

    def carry(self, items):
        """The items of the former list, shape (m, ...), in the order of the last list; zeros where a pair is new.

        Items may be of any type that numpy has. StateError if no list has been matched since the history was made,
        cleared or restored.
        """
        array = np.asarray(items)
        with self._lock:
            if self._previous is None:
                raise StateError("no list has been matched since the history was created, cleared or restored")
            arrays.check_shape(array, "items", (self._former_shape[0], *array.shape[1:]))
            kept = self._previous >= 0
            carried = np.zeros((len(kept), *array.shape[1:]), dtype=array.dtype)
            carried[kept] = array[self._previous[kept]]
            return carried

    def ended(self):
        """The contacts of the former list that the last update no longer found, as a named tuple (pairs, places).

        pairs: of the shape (k, 2) or (k, 3) of that list, in its order. places: int64 of shape (k,), where they stood:
        items[places] is what such contacts had last. StateError as for carry.
        """
        with self._lock:
            call = _by_kind(self._former_shape, capi.hg_history_ended, capi.hg_history_ended_keys)
            return Ended._make(arrays.copy_out(call(self._handle)))

    @property
    def pairs(self):
        """The remembered list as it was given, int32 (m, 2) or int64 (m, 3), e.g. for a checkpoint."""
        with self._lock:
            call = _by_kind(self._shape, capi.hg_history_pairs, capi.hg_history_keys)
            return arrays.copy_out(call(self._handle))

    def restore(self, pairs):
        """Remembers a list, shape (m, 2) or (m, 3), without matching it; the next update refers to it.

        For the list of a checkpoint. Errors as for update.
        """
        wanted = arrays.contacts(pairs, "pairs")
        call = _by_kind(wanted.shape, capi.hg_history_restore, capi.hg_history_restore_keys)
        with self._lock:
            call(self._handle, wanted)
            self._shape = wanted.shape
            self._previous = None

    def clear(self):
        """Remembers an empty list."""
        with self._lock:
            capi.hg_history_clear(self._handle)
            self._shape = (0, 2)
            self._previous = None
