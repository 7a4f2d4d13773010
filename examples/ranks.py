# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Contacts among spheres that the ranks of MPI own: mpirun -n 4 python3 ranks.py
import numpy as np
from mpi4py import MPI

import hgrid.mpi

comm = MPI.COMM_WORLD
rng = np.random.default_rng(1)  # the same on all ranks
x = rng.random((10000, 3))
r = 0.001 / (1 - 0.99 * rng.random(10000))
gids = np.arange(comm.rank, 10000, comm.size)  # dealt out in turn

with hgrid.mpi.Grid(comm, periodic=(True, True, False), box=((0, 0, 0), (1, 1, 1))) as grid:
    grid.set(gids, x[gids], r[gids])
    pairs = grid.query_pairs()  # each pair on one rank: of an owned particle and an owned one or a ghost
    neighbors = np.zeros((len(gids) + grid.stats.ghost_count, 1))
    np.add.at(neighbors, pairs, 1)
    count = neighbors[: len(gids)].copy()
    grid.reverse_add(neighbors[len(gids) :], count)  # what ghosts have got goes to their owners
    total = comm.allreduce(len(pairs))
    most = comm.allreduce(int(count.max()), op=MPI.MAX)
    if comm.rank == 0:
        print(total, "contacts, at most", most, "of one sphere")
