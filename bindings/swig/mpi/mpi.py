# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Every overlapping pair among particles that several ranks of MPI own, with mpi4py.

    from mpi4py import MPI
    import hgrid.mpi
    with hgrid.mpi.Grid(MPI.COMM_WORLD, skin=0.1) as grid:
        grid.set(gids, x, r)            # what this rank owns: (n,), (n, 3), (n,)
        pairs = grid.query_pairs()      # 0 .. n - 1 owned, n .. ghosts

The union of all ranks' pairs is that of one hgrid.Grid with all particles, each pair on exactly one rank.
"""

import collections
import contextlib
import operator
import warnings

import numpy as np

try:
    from mpi4py import MPI
except ImportError as error:
    raise ImportError(f"hgrid.mpi needs mpi4py (Debian: python3-mpi4py): {error}") from error

from . import arrays, mpi_capi
from .definition import Defined, choice
from .errors import ArgumentError, Error, StateError
from .records import record

Owned = collections.namedtuple("Owned", "gids x r")
Owned.__doc__ = """The particles of this rank, row by row: int64 (n,), float64 (n, dimension), float64 (n,)."""

Ghosts = collections.namedtuple("Ghosts", "gids owners x r")
Ghosts.__doc__ = """Copies of particles of other ranks, rank by rank, with the bits that their owners hold.

gids: int64 (g,); owners: ranks, int32 (g,); x: float64 (g, dimension); r: float64 (g,)."""

Stats = collections.namedtuple(
    "Stats",
    "owned_count ghost_count pair_count send_rank_count receive_rank_count sent_byte_count selection_count "
    "update_count opened_axis_count imbalance",
)
Stats.__doc__ = """Counters of this rank.

owned_count, ghost_count, pair_count: particles, ghosts, and pairs of the last query or complete visit.
send_rank_count: ranks with ghosts of this one's particles; receive_rank_count: ranks whose particles are ghosts here.
sent_byte_count: rows sent to other ranks so far. selection_count: times ghosts were chosen; update_count: times that
their places alone were sent. opened_axis_count: periodic axes that need not be periodic here now. imbalance: largest
over mean of all ranks, of the weights that balance() left, else of owned particles."""

_BALANCERS = {"bisection": mpi_capi.HG_MPI_BISECTION, "curve": mpi_capi.HG_MPI_CURVE}


def _family(vendor):
    """Which handles an MPI has: those of Open MPI, or of MPICH and all that are built to replace it."""
    return "MPICH" if vendor in ("MPICH", "MPICH2", "Intel MPI", "MVAPICH", "MVAPICH2") else vendor


if _family(MPI.get_vendor()[0]) != mpi_capi.HG_MPI_FAMILY:
    raise ImportError(
        f"hgrid.mpi was built with {mpi_capi.HG_MPI_FAMILY}, mpi4py with {MPI.get_vendor()[0]}: "
        "build libhgrid_mpi with the MPI of mpi4py, or mpi4py with that of libhgrid_mpi"
    )


class Grid(Defined):
    """Particles that the ranks of a communicator own, and the pairs among all of them.

    comm: an mpi4py communicator, which is duplicated. The definition is that of hgrid.Grid, with its arguments
    (dimension, periodic, box, margin, skin, ...), the same on all ranks in all that bears on pairs; images='all' is
    refused. The skin is that of ghosts, too: they are chosen anew when a particle of any rank has moved plus grown by
    half of it. Besides, the same on all ranks:

    balancer: 'bisection' or 'curve': how balance() cuts space.
    verify: whether set() checks that no gid stands twice.
    imbalance: largest over mean weight of a rank that balance() may leave.

    Each particle has a gid, any 64-bit integer that no other has, and is owned by one rank, whichever. Rows of a rank
    are its owned particles, n of them, in the order given; ids in pairs are index_base + row, ghosts go on counting.

    Collective, that is made by all ranks in the same order, are: creating, close, set, balance, migrate, move, forward,
    reverse_add, set_groups, set_group_pair, set_bodies. They succeed on all ranks or fail on all, also where the arrays
    of one rank alone have a wrong shape: that one gets its own exception, the others hgrid.Error whose text names it.
    All others are local. Lengths, arrays and errors are those of hgrid.Grid; what is returned is a copy.

    Threads: one at a time on one object. From inside a visitor all calls on its object raise StateError.

    Leave a block or call close() on all ranks: an object that is only forgotten keeps its communicator, with a
    ResourceWarning, because freeing it is collective and the garbage collector is not. Where an exception leaves the
    block, the object stays as well: that rank may be the only one.
    """

    def __init__(self, comm, dimension=3, *, balancer="bisection", verify=False, imbalance=1.05, **definition):
        """Creates an object without particles; collective on comm."""
        self._handle = None
        if not isinstance(comm, MPI.Comm):
            raise TypeError(f"comm must be an mpi4py communicator, not {type(comm).__name__}")
        if comm == MPI.COMM_NULL:
            raise ArgumentError("comm is MPI.COMM_NULL")
        self._comm = comm.py2f()
        with self._in_step(mpi_capi.hg_mpi_refuse_create, self._comm):
            self._ranks = (choice("balancer", balancer, _BALANCERS), int(bool(verify)), float(imbalance))
            super().__init__(dimension, **definition)
        self._create_together()

    def _create(self, definition, cell_sizes):
        self._definition = definition, cell_sizes

    def _create_together(self):
        self._handle = mpi_capi.hg_mpi_make(self._comm, *self._definition, *self._ranks)
        self._count = self._former_count = 0

    @staticmethod
    @contextlib.contextmanager
    def _in_step(refuse, target):
        """Around what may fail on this rank alone, before a collective call: then the others must fail, too."""
        try:
            yield
        except BaseException:
            with contextlib.suppress(Error):
                refuse(target)
            raise

    def _open(self):
        if self._handle is None:
            raise StateError("the object is closed")
        return self._handle

    def __reduce__(self):
        raise TypeError("a Grid can be neither copied nor pickled")

    def __enter__(self):
        self._open()
        return self

    def __exit__(self, kind, *exception):
        # What was raised may have been raised here alone: then nobody else would come.
        if kind is None:
            self.close()
        else:
            self._handle = None

    def __del__(self):
        if getattr(self, "_handle", None) is None:
            return
        if MPI.Is_finalized():
            mpi_capi.hg_mpi_destroy(self._handle)
        else:
            warnings.warn("a hgrid.mpi.Grid was not closed: its communicator stays", ResourceWarning, source=self)

    @property
    def dimension(self):
        """2 or 3."""
        return self._dimension

    @property
    def closed(self):
        """Whether close() has been called."""
        return self._handle is None

    def close(self):
        """Frees the object; collective. Arrays that it returned stay valid."""
        if self._handle is not None:
            mpi_capi.hg_mpi_destroy(self._handle)
            self._handle = None

    def set(self, gids, x, r):
        """The particles that this rank owns from now on: gids (n,), integers, x (n, dimension), r (n,); collective.

        Any rank may own any particles, none, or all. All are in group 0 then, and in no body.
        """
        handle = self._open()
        with self._in_step(mpi_capi.hg_mpi_refuse_set, handle):
            centers = arrays.reals(x, "x", ("n", self._dimension))
            radii = arrays.reals(r, "r", (len(centers),))
            names = arrays.gids(gids, "gids", len(centers))
        mpi_capi.hg_mpi_set(handle, names, centers, radii)
        self._count, self._former_count = len(names), 0

    def balance(self, weights=None):
        """Chooses new owners by Zoltan and sends particles to them; collective. Returns the new n.

        weights: of each owned particle, (n,), >= 0; None on all ranks: 1 + 2 for each pair that its rank finds of it as the
        first. Rows are others then: owned() tells which, migrate() sends what else there is of each. StateError if the
        library was built without Zoltan.
        """
        handle = self._open()
        if weights is not None:
            # Where there are no particles, there is nothing to refuse together.
            with self._in_step(self._refuse_balance, handle):
                weights = arrays.reals(weights if self._count > 0 else [], "weights", (self._count,))
        count = mpi_capi.hg_mpi_balance(handle, weights)
        self._former_count, self._count = self._count, count
        return count

    def _refuse_balance(self, handle):
        mpi_capi.hg_mpi_balance(handle, np.full(self._count, -1.0))

    def migrate(self, rows):
        """Rows follow their particles as the last balance() sent them; collective. Returns those of the new n.

        rows: what there was of each particle before, (n before, ...), of any type that numpy has but objects; of the
        same type and shape but for n on all ranks.
        """
        handle = self._open()
        with self._in_step(mpi_capi.hg_mpi_refuse_migrate, handle):
            before, after = _rows(rows, self._former_count), self._count
            after = np.empty((after, *before.shape[1:]), before.dtype)
        mpi_capi.hg_mpi_migrate(handle, _row_bytes(before), before, after)
        return after

    def move(self, x, r=None):
        """New centres of this rank's particles, and new radii if given; collective.

        Returns whether ghosts were chosen anew, so that ids of ghosts mean others now; the same on all ranks. Which rank
        finds a pair goes by the radii at the last choice.
        """
        handle = self._open()
        with self._in_step(mpi_capi.hg_mpi_refuse_move, handle):
            centers = arrays.reals(x, "x", (self._count, self._dimension))
            radii = None if r is None else arrays.reals(r, "r", (self._count,))
        return bool(mpi_capi.hg_mpi_move(handle, centers, radii))

    def set_groups(self, groups):
        """As hgrid.Grid.set_groups, of owned particles, (n,): 0 to HG_MPI_MAX_GROUPS - 1, or -1: absent; collective."""
        self._give(mpi_capi.hg_mpi_set_groups, mpi_capi.hg_mpi_refuse_set_groups, groups, "groups")

    def set_bodies(self, bodies):
        """As hgrid.Grid.set_bodies, of owned particles, (n,): a number of all ranks, or -1: none; collective."""
        self._give(mpi_capi.hg_mpi_set_bodies, mpi_capi.hg_mpi_refuse_set_bodies, bodies, "bodies")

    def _give(self, call, refuse, values, name):
        handle = self._open()
        with self._in_step(refuse, handle):
            numbers = None if values is None else arrays.numbers(values, name)
        call(handle, numbers)

    def set_group_pair(self, group_a, group_b, interacts):
        """As hgrid.Grid.set_group_pair, the same on all ranks; collective."""
        handle = self._open()
        with self._in_step(mpi_capi.hg_mpi_refuse_set_group_pair, handle):
            told = operator.index(group_a), operator.index(group_b), int(bool(interacts))
            if not all(abs(group) < 2**31 for group in told):
                raise ArgumentError(f"there is no pair of groups ({group_a}, {group_b})")
        mpi_capi.hg_mpi_set_group_pair(handle, *told)

    def forward(self, rows):
        """Rows of owned particles, (n, ...), to where these are ghosts; collective. Returns the ghosts', (g, ...).

        Of any type that numpy has but objects; of the same type and shape but for n on all ranks.
        """
        handle = self._open()
        with self._in_step(mpi_capi.hg_mpi_refuse_forward, handle):
            owned = _rows(rows, self._count)
            ghosts = np.empty((self.stats.ghost_count, *owned.shape[1:]), owned.dtype)
        mpi_capi.hg_mpi_forward(handle, _row_bytes(owned), owned, ghosts)
        return ghosts

    def reverse_add(self, ghost_rows, rows):
        """Adds what ghosts have got, (g, ...), to the rows of their owners, (n, ...), in place; collective.

        rows: a C-contiguous float64 array, which changes. Added by ascending rank of the ghost, so that two runs on as
        many ranks have the same bits.
        """
        handle = self._open()
        with self._in_step(mpi_capi.hg_mpi_refuse_reverse_add, handle):
            if not isinstance(rows, np.ndarray) or rows.dtype != np.float64 or not rows.flags.carray:
                raise TypeError("rows must be a C-contiguous, writable float64 array, which changes in place")
            arrays.check_shape(rows, "rows", (self._count, *rows.shape[1:]))
            ghosts = arrays.reals(ghost_rows, "ghost_rows", (self.stats.ghost_count, *rows.shape[1:]))
        mpi_capi.hg_mpi_reverse_add(handle, _row_bytes(rows) // 8, ghosts, rows)

    def query_pairs(self):
        """The pairs that this rank finds, int32 (m, 2), a < b: a is owned, b is owned or a ghost. Local."""
        return arrays.copy_out(mpi_capi.hg_mpi_query_pairs(self._open()))

    def visit_pairs(self, visit):
        """Calls visit(pairs) with one batch of them after the other, as hgrid.Grid.visit_pairs. Local."""
        if not callable(visit):
            raise TypeError(f"visit must be callable, not {type(visit).__name__}")
        mpi_capi.hg_mpi_visit_pairs(self._open(), lambda batch: visit(arrays.copy_out(batch)))

    def owned(self):
        """The particles of this rank, as a named tuple (gids, x, r). Local."""
        return Owned._make(arrays.copy_out(mpi_capi.hg_mpi_owned(self._open(), self._dimension)))

    def ghosts(self):
        """The ghosts, as a named tuple (gids, owners, x, r); ghost k has the id index_base + n + k. Local."""
        return Ghosts._make(arrays.copy_out(mpi_capi.hg_mpi_ghosts(self._open(), self._dimension)))

    @property
    def stats(self):
        """The counters of this rank, as Stats. Local."""
        return record(Stats, mpi_capi.hg_mpi_get_stats(self._open()))


def _rows(values, count):
    """`values` as a contiguous array of that many rows."""
    array = np.ascontiguousarray(values)
    if array.dtype.hasobject:
        raise TypeError("rows of Python objects cannot travel")
    arrays.check_shape(array, "rows", (count, *array.shape[1:]))
    return array


def _row_bytes(array):
    return array.dtype.itemsize * int(np.prod(array.shape[1:], dtype=np.int64))
