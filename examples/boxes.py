# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# Periodic boxes: through a face, tilted, sheared. docs/tutorials/boxes.md goes through the parts.
import hgrid

# %% Through a face
x = [[0.1, 0.5], [0.9, 0.5]]
r = [0.15, 0.1]
with hgrid.Grid(2, box=((0, 0), (1, 1)), periodic=(True, False)) as grid:
    grid.insert(x, r)
    pairs, vectors, shifts = grid.query_pairs(vectors=True, shifts=True)
    print(len(pairs), "contact, from a to b", vectors[0].round(3), "edges crossed", shifts[0])

# %% A tilted cell
a = 2.0  # discs of radius 1 in a triangular lattice, in a cell of 4 by 4 of them
height = 3**0.5
x = [[a * (i + 0.5 * j), height * j] for j in range(4) for i in range(4)]
cell = {"box": ((0, 0), (4 * a, 4 * height)), "tilt": 2 * a, "periodic": (True, True)}
with hgrid.Grid(2, margin=1e-9, **cell) as grid:
    grid.insert(x, [1.0] * len(x))
    offsets, neighbors = grid.query_neighbors(full=True)
    print("neighbours of each disc:", {int(n) for n in offsets[1:] - offsets[:-1]})

# %% Shear
box = ((0, 0), (1, 1))
with hgrid.Grid(2, box=box, periodic=(True, True)) as grid:
    grid.insert([[0.2, 0.1], [0.7, 0.9]], [0.12, 0.12])
    for step in range(5):
        offset = 0.125 * step  # how far the images above have slid
        grid.set_box(box, tilt=offset)
        print("offset", offset, "contacts", len(grid.query_pairs()))
