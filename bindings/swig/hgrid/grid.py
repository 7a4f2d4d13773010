# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""The class Grid: a set of particles and the search for pairs among them."""

import threading

import numpy as np

from . import arrays, boxes, capi
from .definition import Defined
from .errors import StateError
from .records import Level, LevelCost, Stats, record


class Grid(Defined):
    """A set of particles (discs or spheres) and the search for pairs among them.

    dimension: 2 or 3. All other arguments go by name:

    periodic: one truth value per axis; a periodic axis needs `box`.
    box: the corners ((x, y, z), (x, y, z)), lowest first, or in 3D the edges of a cell with its corner at the origin, a
        lower triangular matrix ((ax, 0, 0), (bx, by, 0), (cx, cy, cz)). On open axes particles may lie anywhere.
    tilt: (xy, xz, yz), in 2D xy alone: the periodic cell between those corners has the edges (lx, 0, 0), (xy, ly, 0)
        and (xz, yz, lz).
    touching: whether particles that exactly touch are a pair: <= in place of <.
    images: 'nearest': two particles are a pair once at most; 'all': each periodic image in reach is a pair of its own,
        also a particle with its own image, and the box may be as short as you like.
    thread_count: 0 for all that the machine offers, 1 for serial.
    index_base: id of the first particle, 0 or 1.
    interaction: 'contact', |xi - xj| < ri + rj + margin, or 'max_range', |xi - xj| < max(ri, rj) + margin.
    accuracy: 'exact', as real arithmetic on the doubles given; 'double', as the plain expression in doubles;
        'float', which never misses a pair but adds some that all but touch.
    order: of the pairs: 'grid', as found, or 'id', ascending. Both are reproducible.
    levels: how cell sizes are chosen: 'auto', 'paper' or 'user'; by default 'user' with cell_sizes, else 'auto'.
    level_count: at most that many levels; 0 for the cheapest.
    cell_sizes: for levels='user': ascending cell edges, the last at least the largest diameter plus margin.
    margin: added to every reach, in your unit of length.
    skin: how far particles may move before stored candidates are searched anew; it changes the time, never the answer.
    cell_overhead: cost of visiting a cell over the cost of testing a particle, for 'paper' and, if it is not negative,
        for 'auto'.
    level_price, row_price: what a level and a look at a row of cells cost 'auto', in units of testing one candidate;
        negative for the library's own. They change the time, never the answer.

    Instead of the words the constants HG_... may be given. Ids count from index_base in the order of insertion and are
    not given out again before clear(). The comparison is strict, unless touching says otherwise: particles that just touch
    are no pair.

    Arrays may have any real type, order and strides. They are copied in, and results are copies that belong to you:
    they stay as they are whatever happens to the grid. Empty lists are fine. All lengths (x, r, box, tilt, margin, skin,
    vectors, reach) are in one unit, which is yours to choose.

    Errors, of every method: ArgumentError, a ValueError, for a wrong shape or a value out of range, such as a NaN, a
    negative radius, an integer that no double holds or a box too short for its particles, naming its index;
    TypeError for arrays that hold no numbers; StateError once the grid is closed or from inside a visitor of its own;
    LimitError for more particles than 2^31 - 1 or places too far apart; OutOfMemoryError. A call that fails has
    changed nothing.

    A grid may be used from several threads: calls on one grid wait for each other, those on different grids do not.
    build, query_pairs, query_neighbors, visit_pairs, visit_contacts, order, levels and level_costs run without the
    interpreter's global lock.

    A grid is its own context manager: leaving the block closes it.
    """

    def _create(self, definition, cell_sizes):
        self._lock = threading.RLock()
        self._visiting = False
        self._handle = capi.hg_make(definition, cell_sizes)

    def _open(self):
        if self._handle is None:
            raise StateError("the grid is closed")
        return self._handle

    def _call(self, call, *arguments):
        """A call of the C interface on this grid."""
        with self._lock:
            return call(self._open(), *arguments)

    def _query(self, call, *arguments):
        """What such a call lends, as arrays of the caller's own."""
        with self._lock:
            return arrays.copy_out(self._call(call, *arguments))

    def __reduce__(self):
        raise TypeError("a Grid can be neither copied nor pickled")

    @property
    def dimension(self):
        """2 or 3."""
        return self._dimension

    @property
    def closed(self):
        """Whether close() has been called."""
        return self._handle is None

    def close(self):
        """Frees the grid; every later call on it but close() raises StateError. Arrays it returned stay valid."""
        with self._lock:
            if self._visiting:
                raise StateError("a grid cannot be closed from inside one of its own visitors")
            self._handle = None

    def __enter__(self):
        self._open()
        return self

    def __exit__(self, *exception):
        self.close()

    def insert(self, x, r):
        """Adds particles with centres x, shape (n, dimension), and radii r, shape (n,). All or nothing."""
        centers = arrays.reals(x, "x", ("n", self._dimension))
        radii = arrays.reals(r, "r", (len(centers),))
        self._call(capi.hg_insert, centers, radii)

    def move(self, x, r=None):
        """Replaces the centres, and the radii if given, of all live particles in order of id. All or nothing."""
        centers = arrays.reals(x, "x", ("n", self._dimension))
        radii = None if r is None else arrays.reals(r, "r", (len(centers),))
        self._call(capi.hg_move, centers, radii)

    def set(self, x, r):
        """Makes the grid hold exactly these particles, whatever it held: row k has the id index_base + k.

        Any number in every step. Where number and radii are as before, stored candidates of a skin stay in use. All or
        nothing.
        """
        centers = arrays.reals(x, "x", ("n", self._dimension))
        radii = arrays.reals(r, "r", (len(centers),))
        self._call(capi.hg_set, centers, radii)

    def set_box(self, box, tilt=None):
        """Gives a periodic grid a new box, as the arguments of the class do; particles stay where they are.

        For barostats, shear and other deformation. With a skin, stored candidates stay in use while they are valid.
        All or nothing.
        """
        self._call(capi.hg_set_box, *boxes.corners_and_tilt(box, tilt, self._dimension))

    def set_groups(self, groups):
        """Says in which group each particle is, in order of id: integers of shape (n,), 0 to HG_MAX_GROUPS - 1.

        -1 means absent: in no query, at no cost. None: all in group 0. Particles inserted later are in group 0; set keeps
        groups only where it keeps the number of particles. All or nothing; ArgumentError names a group that is none.
        """
        self._call(capi.hg_set_groups, None if groups is None else arrays.numbers(groups, "groups"))

    def set_group_pair(self, group_a, group_b, interacts):
        """Says whether particles of two groups (or of one) are pairs at all. At first all are.

        What is no pair is not looked for. The table outlives set and clear; only pairs, neighbours and contacts know it.
        """
        self._call(capi.hg_set_group_pair, group_a, group_b, bool(interacts))

    def set_bodies(self, bodies):
        """Says to which rigid body each particle belongs, in order of id: integers of shape (n,), -1 for none.

        Two of the same body are no pair. None: none has a body. All or nothing.
        """
        self._call(capi.hg_set_bodies, None if bodies is None else arrays.numbers(bodies, "bodies"))

    def remove(self, ids):
        """Removes the particles with these ids, shape (n,). All or nothing; NotFoundError names an unknown id."""
        self._call(capi.hg_remove, arrays.ids(ids, "ids"))

    def clear(self):
        """Removes all particles; ids start anew at index_base. Memory, box and the table of group pairs stay."""
        self._call(capi.hg_clear)

    def build(self):
        """Chooses the levels and sorts the particles into cells. Queries do so by themselves when they must."""
        self._call(capi.hg_build)

    def query_pairs(self, vectors=False, shifts=False):
        """All pairs, each once, as int32 of shape (m, 2): ids (a, b) with a < b, in the grid's order.

        With images='all' a pair stands as often as images of the two are in reach, and a == b for images of one.

        With vectors=True or shifts=True a tuple: the pairs, then what leads from a to the image of b that it meets,
        float64 of shape (m, dimension), each component rounded once from the exact value; then which image that is, in
        whole edges of the periodic cell, int32 of shape (m, dimension).
        """
        if not (vectors or shifts):
            return self._query(capi.hg_query_pairs)
        with self._lock:
            pairs = self._query(capi.hg_query_pairs)
            shape = (len(pairs), self._dimension)
            lent = self._query(capi.hg_query_pair_vectors, len(pairs) * self._dimension)
        wanted = [flat.reshape(shape) for flat, asked in zip(lent, (vectors, shifts)) if asked]
        return (pairs, *wanted)

    def visit_pairs(self, visit):
        """Calls visit(pairs) with one batch after the other, int32 of shape (k, 2).

        With order='grid' the pairs are never all in memory at once. A true answer ends the visit; an exception ends it
        and passes on to the caller. Inside visit this grid refuses all calls with StateError.
        """
        self._visit(capi.hg_visit_pairs, visit, lambda batch: visit(arrays.copy_out(batch)))

    def visit_contacts(self, visit):
        """Calls visit(pairs, vectors, reach) with one batch after the other, in the order of query_pairs.

        pairs and vectors as query_pairs(vectors=True) gives them, at most HG_MAX_BATCH at a time; reach: float64 of
        shape (k,), how far the two reach together. The rest as visit_pairs.
        """

        def hand_over(batch):
            a, b, *components, reach = arrays.copy_out(batch)
            return visit(np.stack((a, b), axis=1), np.stack(components, axis=1), reach)

        self._visit(capi.hg_visit_contacts, visit, hand_over)

    def _visit(self, call, visit, hand_over):
        """A visit by the C interface, whose batches go through hand_over to visit."""
        if not callable(visit):
            raise TypeError(f"visit must be callable, not {type(visit).__name__}")
        with self._lock:
            outer, self._visiting = self._visiting, True
            try:
                self._call(call, hand_over)
            finally:
                self._visiting = outer

    def query_neighbors(self, full=False):
        """Neighbour lists (offsets, neighbors) in compressed rows, int64 of shape (n + 1,) and int32.

        The neighbours of the k-th live particle in ascending id are neighbors[offsets[k]:offsets[k + 1]], ascending.
        Every pair is listed once, in the row of its smaller id; with full=True it is listed in both rows.
        """
        with self._lock:
            kind = capi.HG_FULL if full else capi.HG_HALF
            return self._query(capi.hg_query_neighbors, kind, self.stats.particle_count)

    def query_sphere(self, center, radius):
        """Ids, ascending, of the particles that a sphere interacts with by the grid's own rule; int32 of shape (k,)."""
        point = arrays.reals(center, "center", (self._dimension,))
        return self._query(capi.hg_query_sphere, point, float(radius))

    def query_spheres(self, centers, radii):
        """Of many spheres at once, rows (offsets, ids) in the order given: int64 of shape (k + 1,) and int32.

        centers: shape (k, dimension); radii: shape (k,). What sphere n interacts with is ids[offsets[n]:offsets[n + 1]],
        as query_sphere gives it. Much faster than one by one, and on all threads of the grid.
        """
        points = arrays.reals(centers, "centers", ("n", self._dimension))
        return self._query(capi.hg_query_spheres, points, arrays.reals(radii, "radii", (len(points),)), len(points))

    def query_boxes(self, low, high):
        """Of many axis-aligned boxes, rows (offsets, ids) as those of query_spheres: the particles that meet them.

        low, high: the corners, shape (k, dimension); they may be infinite. Decided exactly: the box is nearer to the centre
        than radius + margin, or the centre lies in it. On periodic axes any image counts; not in a tilted cell.
        """
        shape = ("n", self._dimension)
        corner = arrays.reals(low, "low", shape)
        opposite = arrays.reals(high, "high", shape)
        arrays.check_shape(opposite, "high", corner.shape)
        return self._query(capi.hg_query_boxes, corner, opposite, len(corner))

    def query_triangles(self, corners):
        """Of many triangles, rows (offsets, ids) as those of query_spheres: the particles that meet them.

        corners: shape (k, 3, 3), the second axis counting corners. A particle counts if the triangle is nearer to its centre
        than radius + margin. None is missed; some may come that are farther by 2^-40 of reach and coordinates. In three
        dimensions only; on periodic axes any image counts; not in a tilted cell.
        """
        triangles = arrays.reals(corners, "corners", ("n", 3, 3))
        return self._query(capi.hg_query_triangles, triangles, len(triangles))

    def overlap(self, center_a, radius_a, center_b, radius_b):
        """Whether two spheres interact that the grid need not hold, by its own rule."""
        a = arrays.reals(center_a, "center_a", (self._dimension,))
        b = arrays.reals(center_b, "center_b", (self._dimension,))
        return bool(self._call(capi.hg_overlap, a, float(radius_a), b, float(radius_b)))

    @property
    def order(self):
        """The ids of all particles in an order in which near ones stand together; int32 of shape (n,).

        With arrays that were given by set, x[grid.order - index_base] is sorted along space, which makes most work on
        them faster.
        """
        return self._query(capi.hg_query_order)

    @property
    def levels(self):
        """The levels of the grid, finest first, as a list of Level; builds the grid if it must be."""
        return [record(Level, struct) for struct in self._call(capi.hg_query_levels)]

    @property
    def level_costs(self):
        """The predicted cost of each number of levels that the rule looked at, as a list of LevelCost."""
        return [record(LevelCost, struct) for struct in self._call(capi.hg_query_level_costs)]

    @property
    def stats(self):
        """The counters of the grid, as Stats."""
        return record(Stats, self._call(capi.hg_get_stats))
