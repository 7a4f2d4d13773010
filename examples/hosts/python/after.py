# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Molecular dynamics of a liquid as a notebook holds it, with neighbour lists called as in ASE. Arguments: [COUNT
# [STEPS]]. Prints energies and where each atom ends, with all digits; on standard error, the seconds that the search
# and the whole took.

# %% Imports
import sys
import time

import numpy as np
from hgrid import neighbor_list


# %% The atoms, with the attributes of ase.Atoms that are used here
class Atoms:
    def __init__(self, positions, cell, pbc):
        self.positions, self.cell, self.pbc = positions, cell, pbc

    def __len__(self):
        return len(self.positions)


def make_liquid(count, density, rng):
    side = int(np.ceil(count ** (1 / 3)))
    lattice = np.stack(np.meshgrid(*[np.arange(side)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)[:count]
    positions = (lattice + rng.uniform(-0.05, 0.05, (count, 3))) / density ** (1 / 3)
    return Atoms(positions, np.diag([side / density ** (1 / 3)] * 3), (True, True, True))


# %% Lennard-Jones forces
search_seconds = 0.0


def forces(atoms, cutoff=2.5):
    global search_seconds
    start = time.perf_counter()
    i, j, S = neighbor_list("ijS", atoms, cutoff)
    search_seconds += time.perf_counter() - start
    order = np.lexsort((j, i))  # so that sums do not depend on how the pairs were found
    i, j, S = i[order], j[order], S[order]
    D = atoms.positions[j] - atoms.positions[i] + S @ atoms.cell
    inverse = 1 / np.einsum("ij,ij->i", D, D) ** 3
    energy = 2 * np.sum(inverse * (inverse - 1))
    pull = (24 * inverse * (1 - 2 * inverse) * inverse ** (1 / 3))[:, np.newaxis] * D
    return energy, np.stack([np.bincount(i, pull[:, k], len(atoms)) for k in range(3)], axis=1)


# %% A run
def run(count=3000, steps=5, dt=0.004):
    rng = np.random.default_rng(1)
    atoms = make_liquid(count, 0.8, rng)
    velocities = rng.normal(0, 1, (count, 3))
    energy, f = forces(atoms)
    for step in range(1, steps + 1):
        velocities += dt / 2 * f
        atoms.positions += dt * velocities
        energy, f = forces(atoms)
        velocities += dt / 2 * f
        print(step, repr(float(energy / count)), repr(float(np.sum(velocities**2) / (2 * count))))
    for position in atoms.positions:
        print(*position.tolist())


# %%
start = time.perf_counter()
run(*map(int, sys.argv[1:]))
print(f"search {search_seconds:.3f} s, all {time.perf_counter() - start:.3f} s", file=sys.stderr)
