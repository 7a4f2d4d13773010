# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""The class History: per-contact data that follows its contacts from list to list."""

import threading

import numpy as np

from . import arrays, capi
from .errors import StateError


class History:
    """Matches each list of pairs to the one before, so that data of contacts can follow them.

        previous = history.update(pairs)      # int64 (m,): the place of each pair in the former list, -1 if it is new
        spring = history.carry(spring)        # one item for each pair of the new list, zero for new ones

    Pairs have shape (m, 2) and may be in any order; (a, b) is not (b, a). Any 32-bit integers will do, so that contacts
    with walls may stand in the same list, under ids that no particle has. Lists are copied, results belong to you.

    A history may be used from several threads; calls on one history wait for each other.
    """

    def __init__(self):
        """Creates a history that remembers an empty list."""
        self._lock = threading.RLock()
        self._handle = capi.hg_history_create()
        self._former_count = 0
        self._previous = None

    def __reduce__(self):
        raise TypeError("a History can be neither copied nor pickled; give its pairs to restore() of another")

    def update(self, pairs):
        """Matches a list to the remembered one, and remembers it instead; ArgumentError names a pair listed twice."""
        wanted = arrays.pairs(pairs, "pairs")
        with self._lock:
            former_count = len(self.pairs)
            self._previous = arrays.copy_out(capi.hg_history_update(self._handle, wanted))
            self._former_count = former_count
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
            arrays.check_shape(array, "items", (self._former_count, *array.shape[1:]))
            kept = self._previous >= 0
            carried = np.zeros((len(kept), *array.shape[1:]), dtype=array.dtype)
            carried[kept] = array[self._previous[kept]]
            return carried

    @property
    def pairs(self):
        """The remembered list, int32 of shape (m, 2), e.g. for a checkpoint."""
        with self._lock:
            return arrays.copy_out(capi.hg_history_pairs(self._handle))

    def restore(self, pairs):
        """Remembers a list, e.g. that of a checkpoint, without matching it; the next update refers to it."""
        wanted = arrays.pairs(pairs, "pairs")
        with self._lock:
            capi.hg_history_restore(self._handle, wanted)
            self._previous = None

    def clear(self):
        """Remembers an empty list."""
        with self._lock:
            capi.hg_history_clear(self._handle)
            self._previous = None
