# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""hgrid.mpi on the ranks of mpirun, against hgrid on one process and brute force."""

import sys
import traceback

import numpy as np
from mpi4py import MPI
from oracle import ascending, exact_pairs, polydisperse

import hgrid
import hgrid.mpi

COMM = MPI.COMM_WORLD
RANK, SIZE = COMM.Get_rank(), COMM.Get_size()
BOX = dict(periodic=(True, False, True), box=((0, 0, 0), (1, 1, 1)))


def scene(seed, count=250):
    """The same on all ranks: gids, places, radii; and which rows this rank owns, by lot, the last of many ranks none."""
    x, r = polydisperse(seed, count, ratio=50.0)
    rng = np.random.default_rng(seed + 100)
    gids = rng.permutation(count).astype(np.int64) * 2**33 - 2**40
    mine = rng.integers(0, SIZE - 1 if SIZE > 2 else SIZE, count) == RANK
    return gids, x, r, mine


def local_gids(grid):
    return np.concatenate((grid.owned().gids, grid.ghosts().gids))


def union(grid, pairs=None):
    """The pairs of all ranks by gids, the lower first, ascending, as they came: twice is twice."""
    found = local_gids(grid)[grid.query_pairs() if pairs is None else pairs]
    return ascending(np.sort(np.concatenate(COMM.allgather(found)), axis=1))


def wanted(gids, x, r, brute=True, **options):
    """The same by one process, the first, where brute force agrees (slow: not in each step)."""
    pairs = None
    if RANK == 0:
        with hgrid.Grid(x.shape[1], order="id", thread_count=1, **options) as grid:
            grid.set(x, r)
            pairs = grid.query_pairs()
        if brute:
            np.testing.assert_array_equal(pairs, exact_pairs(x, r, **options))
        assert len(pairs) > 0
    return ascending(np.sort(gids[COMM.bcast(pairs)], axis=1))


def test_pairs():
    gids, x, r, mine = scene(1)
    with hgrid.mpi.Grid(COMM, **BOX) as grid:
        grid.set(gids[mine], x[mine], r[mine])
        np.testing.assert_array_equal(union(grid), wanted(gids, x, r, **BOX))
        batches = []
        grid.visit_pairs(batches.append)
        np.testing.assert_array_equal(np.concatenate((np.empty((0, 2), np.int32), *batches)), grid.query_pairs())
        ghosts, place = grid.ghosts(), {gid: k for k, gid in enumerate(gids)}
        rows = [place[gid] for gid in ghosts.gids]
        np.testing.assert_array_equal(ghosts.x, x[rows])
        np.testing.assert_array_equal(ghosts.r, r[rows])
        assert (ghosts.owners != RANK).all()
        assert np.all(grid.query_pairs()[:, 0] < mine.sum())
        assert grid.stats.ghost_count == len(ghosts.gids) and grid.stats.owned_count == mine.sum()


def test_plane_and_ids_from_one():
    x, r = polydisperse(2, 300, dimension=2, ratio=20.0)
    gids, mine = np.arange(300), np.arange(300) % SIZE == RANK
    with hgrid.mpi.Grid(COMM, 2, index_base=1, margin=0.01, verify=True) as grid:
        grid.set(gids[mine], x[mine], r[mine])
        np.testing.assert_array_equal(union(grid, grid.query_pairs() - 1), wanted(gids, x, r, margin=0.01))


def test_steps():
    """Motion under a skin, data to ghosts, forces back: each pair pulls by 1, so that sums are exact."""
    gids, x, r, mine = scene(3)
    rng = np.random.default_rng(33)
    with hgrid.mpi.Grid(COMM, skin=0.02, **BOX) as grid:
        grid.set(gids[mine], x[mine], r[mine])
        chosen = 0
        for step in range(6):
            x = x + 0.004 * rng.random(x.shape)
            chosen += grid.move(x[mine])
            listed = wanted(gids, x, r, brute=step == 5, **BOX)
            np.testing.assert_array_equal(union(grid), listed)
            ghosts = grid.ghosts()
            np.testing.assert_array_equal(grid.forward(gids[mine]), ghosts.gids)
            np.testing.assert_array_equal(grid.forward(x[mine]), ghosts.x)
            pulls = np.zeros((mine.sum() + len(ghosts.gids), 2))
            for column, sign in enumerate((1, -1)):
                np.add.at(pulls[:, column], grid.query_pairs()[:, 0], 1)
                np.add.at(pulls[:, column], grid.query_pairs()[:, 1], sign)
            force = pulls[: mine.sum()].copy()
            grid.reverse_add(pulls[mine.sum() :], force)
            number = np.array([(listed == gid).any(axis=1).sum() for gid in gids[mine]])
            np.testing.assert_array_equal(force[:, 0], number)
        assert 0 < chosen < 6, f"ghosts chosen {chosen} times"
        grid.move(x[mine], 1.5 * r[mine])
        np.testing.assert_array_equal(union(grid), wanted(gids, x, 1.5 * r, **BOX))


def test_balance():
    gids, x, r, mine = scene(4)
    with hgrid.mpi.Grid(COMM, **BOX) as grid:
        grid.set(gids[mine], x[mine], r[mine])
        try:
            count = grid.balance()
        except hgrid.StateError as error:
            assert "Zoltan" in str(error)
            return
        owned = grid.owned()
        assert count == len(owned.gids) and COMM.allreduce(count) == len(gids)
        assert SIZE == 1 or COMM.allreduce(count, op=MPI.MAX) < len(gids) * 0.8
        np.testing.assert_array_equal(grid.migrate(gids[mine]), owned.gids)
        np.testing.assert_array_equal(grid.migrate(x[mine].astype(np.float32)), owned.x.astype(np.float32))
        np.testing.assert_array_equal(union(grid), wanted(gids, x, r, **BOX))
        grid.balance(np.ones(count))
        np.testing.assert_array_equal(union(grid), wanted(gids, x, r, brute=False, **BOX))


def test_groups_and_bodies():
    gids, x, r, mine = scene(5)
    groups, bodies = np.arange(len(gids)) % 3 - 1, np.arange(len(gids)) // 40
    with hgrid.Grid(**BOX) as alone, hgrid.mpi.Grid(COMM, **BOX) as grid:
        alone.set(x, r)
        grid.set(gids[mine], x[mine], r[mine])
        for each, rows in ((alone, slice(None)), (grid, mine)):
            each.set_groups(groups[rows])
            each.set_group_pair(0, 0, False)
            each.set_bodies(bodies[rows])
        listed = ascending(np.sort(gids[alone.query_pairs()], axis=1))
        assert len(listed) > 0
        np.testing.assert_array_equal(union(grid), listed)
        grid.set_groups(None)
        grid.set_bodies(None)


def refused(kind, call, *arguments):
    """A call that the last rank alone makes wrong: it gets `kind`, the others an error that names it."""
    try:
        call(*arguments)
    except kind if RANK == SIZE - 1 else hgrid.Error as error:
        assert RANK == SIZE - 1 or (error.status == hgrid.HG_ERR_REMOTE and f"rank {SIZE - 1}" in str(error)), error
        return
    raise AssertionError(f"{call} was not refused")


def test_errors_of_one_rank_are_errors_of_all():
    gids, x, r, mine = scene(6)
    listed = wanted(gids, x, r, brute=False, **BOX)
    wrong = RANK == SIZE - 1
    refused(ValueError, lambda: hgrid.mpi.Grid(COMM, margin=-1.0 if wrong else 0.0))
    refused(ValueError, lambda: hgrid.mpi.Grid(COMM, order="none" if wrong else "id"))
    with hgrid.mpi.Grid(COMM, **BOX) as grid:
        grid.set(gids[mine], x[mine], r[mine])
        n, g = int(mine.sum()), grid.stats.ghost_count
        nan = np.full((1, 3), np.nan)
        refused(ValueError, grid.set, *(([1], nan, [1]) if wrong else (gids[mine], x[mine], r[mine])))
        refused(ValueError, grid.set, *(([1, 2], [[0, 0, 0]], [1]) if wrong else (gids[mine], x[mine], r[mine])))
        refused(TypeError, grid.set, *(([0.5], [[0, 0, 0]], [1]) if wrong else (gids[mine], x[mine], r[mine])))
        refused(ValueError, grid.move, np.zeros((n + 1, 3)) if wrong else x[mine])
        refused(ValueError, grid.set_groups, np.zeros(n + wrong, int))
        refused(TypeError, grid.set_groups, np.full(n, 0.5) if wrong and n else [None] if wrong else np.zeros(n, int))
        refused(ValueError, grid.set_bodies, np.zeros(n + wrong, int))
        refused(ValueError, grid.set_group_pair, 0, -2 if wrong else 0, True)
        refused(ValueError, grid.forward, np.zeros(n + wrong))
        refused(ValueError, grid.reverse_add, np.zeros((g + wrong, 2)), np.zeros((n, 2)))
        refused(TypeError, grid.reverse_add, np.zeros((g, 2)), np.zeros((n, 2), np.float32 if wrong else np.float64))
        np.testing.assert_array_equal(union(grid), listed, "what is refused changes nothing")
        try:
            grid.migrate(np.zeros(0))
        except hgrid.StateError:
            pass


def test_objects():
    half = COMM.Split(RANK % 2, RANK)
    x, r = polydisperse(7, 100)
    mine = np.arange(100) % half.Get_size() == half.Get_rank()
    with hgrid.mpi.Grid(half) as grid, hgrid.mpi.Grid(COMM) as other:
        grid.set(np.flatnonzero(mine), x[mine], r[mine])
        other.set([], np.empty((0, 3)), [])
        assert half.allreduce(len(grid.query_pairs())) == len(exact_pairs(x, r))
        assert len(other.query_pairs()) == 0
        for call in (grid.query_pairs, grid.close):
            try:
                grid.visit_pairs(lambda batch: call())
                assert len(grid.query_pairs()) == 0
            except hgrid.Error as error:
                assert error.status == hgrid.HG_ERR_STATE
    assert grid.closed
    half.Free()
    for kind, comm in ((TypeError, 3), (ValueError, MPI.COMM_NULL)):
        try:
            hgrid.mpi.Grid(comm)
            raise AssertionError("not refused")
        except kind:
            pass
    try:
        grid.query_pairs()
        raise AssertionError("not refused")
    except hgrid.StateError:
        pass


def main():
    for name, test in list(globals().items()):
        if name.startswith("test_"):
            try:
                test()
            except Exception:
                # The others may wait for this rank: all end.
                print(f"rank {RANK} of {SIZE}: {name}\n{traceback.format_exc()}", file=sys.stderr, flush=True)
                COMM.Abort(1)
    if RANK == 0:
        print("all right on", SIZE, "ranks")


if __name__ == "__main__":
    main()
