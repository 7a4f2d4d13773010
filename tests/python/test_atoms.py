# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Neighbour lists of atoms against brute force over images, known lattices, and ASE where it is installed."""

import itertools
import unittest
from types import SimpleNamespace

import numpy as np

import hgrid

try:
    from ase import Atoms
    from ase.neighborlist import neighbor_list as list_of_ase
except ImportError:
    Atoms = None


def brute_force(x, cell, pbc, limits, self_interaction=False):
    """Every (i, j, S) by trying all images that can be near enough, with limits[i, j] the cutoff of two atoms."""
    edges = np.where(np.c_[np.broadcast_to(pbc, 3)], np.asarray(cell, dtype=float), 0)
    # Along an edge the cell is 1 / |column of the inverse| high.
    heights = np.linalg.norm(np.linalg.pinv(edges), axis=0)
    reach = limits.max(initial=0) + np.linalg.norm(np.ptp(x, axis=0) if len(x) else 0)
    around = (np.ceil(reach * heights) * np.broadcast_to(pbc, 3)).astype(int)
    images = itertools.product(*(range(-n, n + 1) for n in around))
    found = []
    for shift in images:
        vectors = x[None] - x[:, None] + np.array(shift) @ edges
        near = np.sqrt(np.sum(vectors * vectors, axis=2)) < limits
        if not (any(shift) or self_interaction):
            np.fill_diagonal(near, False)
        found += [(i, j, *shift) for i, j in np.argwhere(near).tolist()]
    return sorted(found)


def as_rows(i, j, shifts):
    return sorted(zip(i.tolist(), j.tolist(), *shifts.T.tolist()))


def any_cell(rng):
    """Edges of any direction, left or right handed, sometimes flat or needle-like."""
    while True:
        cell = rng.normal(size=(3, 3)) * rng.uniform(0.5, 3, size=(3, 1))
        if abs(np.linalg.det(cell)) > 0.1 * np.prod(np.linalg.norm(cell, axis=1)):
            return cell


class AnyCells(unittest.TestCase):
    def check(self, x, cell, pbc, cutoff, limits, **options):
        itself = options.get("self_interaction", False)
        i, j, shifts, vectors, distances = hgrid.neighbor_list(
            "ijSDd", positions=x, cell=cell, pbc=pbc, cutoff=cutoff, **options
        )
        self.assertEqual(as_rows(i, j, shifts), brute_force(x, cell, pbc, limits, itself))
        np.testing.assert_array_equal(vectors, x[j] - x[i] + shifts @ np.where(np.c_[pbc], cell, 0))
        np.testing.assert_array_equal(distances, np.sqrt(np.sum(vectors * vectors, axis=1)))
        self.assertTrue(np.all(np.diff(i) >= 0))
        self.assertTrue(np.all(np.diff(j)[np.diff(i) == 0] >= 0))

    def test_one_cutoff(self):
        rng = np.random.default_rng(11)
        for trial in range(40):
            with self.subTest(trial=trial):
                x, cutoff = rng.normal(size=(rng.integers(0, 9), 3)) * 2, rng.uniform(0.1, 3)
                limits, itself = np.full((len(x), len(x)), cutoff), trial % 2 == 0
                self.check(x, any_cell(rng), rng.random(3) < 0.7, cutoff, limits, self_interaction=itself)

    def test_radii_of_atoms(self):
        rng = np.random.default_rng(12)
        for trial in range(20):
            with self.subTest(trial=trial):
                x = rng.normal(size=(rng.integers(1, 9), 3)) * 2
                r = rng.uniform(0, 1.2, size=len(x))
                self.check(x, any_cell(rng), rng.random(3) < 0.7, r, r[:, None] + r)

    def test_pairs_of_kinds(self):
        rng = np.random.default_rng(13)
        table = {("C", "H"): 1.3, (1, 1): 0.4, (6, "C"): 2.5, ("Og", 6): 7, ("wall", 8): 1.0}
        reach = {(1, 6): 1.3, (1, 1): 0.4, (6, 6): 2.5}
        for trial in range(20):
            with self.subTest(trial=trial):
                x = rng.normal(size=(rng.integers(1, 9), 3)) * 2
                kinds = rng.choice([1, 6, 8], size=len(x))
                limits = np.array([[reach.get((min(p, q), max(p, q)), 0) for p in kinds] for q in kinds], dtype=float)
                self.check(x, any_cell(rng), rng.random(3) < 0.7, table, limits, numbers=kinds, self_interaction=True)

    def test_radii_of_kinds(self):
        x = np.array([[0, 0, 0], [1, 0, 0], [2, 0, 0], [2.25, 0, 0]])
        names = ["H", "sand", "H", "O"]
        i, j = hgrid.neighbor_list("ij", x, {"H": 0.5, "sand": 0.625, 26: 9}, numbers=names)
        self.assertEqual((i.tolist(), j.tolist()), ([0, 1, 1, 2], [1, 0, 2, 1]))

    def test_turned_atoms_have_the_same_neighbors(self):
        rng = np.random.default_rng(14)
        for trial in range(20):
            cell, x = any_cell(rng), rng.uniform(-40, 40, size=(30, 3))
            wanted = as_rows(*hgrid.neighbor_list("ijS", positions=x, cell=cell, pbc=True, cutoff=1.7))
            turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
            found = as_rows(*hgrid.neighbor_list("ijS", positions=x @ turn, cell=cell @ turn, pbc=True, cutoff=1.7))
            with self.subTest(trial=trial):
                self.assertEqual(found, wanted)


class Lattices(unittest.TestCase):
    def test_strictly_nearer(self):
        for cell in (np.eye(3), np.eye(3)[[2, 0, 1]], -np.eye(3), [1, 1, 1]):
            for shells, cutoff in ((0, 1.0), (6, np.nextafter(1, 2)), (6, np.sqrt(2)), (18, 1.5), (26, 1.75)):
                i = hgrid.neighbor_list("i", [[0.3, 7.25, -2]], cutoff, cell=cell, pbc=True)
                self.assertEqual(len(i), shells, (cell, cutoff))

    def test_face_centred_cubic(self):
        """Shells of 12, 6 and 24 neighbours at sqrt(1/2), 1 and sqrt(3/2), in the primitive cell."""
        cell = np.array([[0, 0.5, 0.5], [0.5, 0, 0.5], [0.5, 0.5, 0]])
        distances = hgrid.neighbor_list("d", np.zeros((1, 3)), 1.3, cell=cell, pbc=True)
        shells, counts = np.unique(np.round(distances, 12), return_counts=True)
        np.testing.assert_allclose(shells, np.sqrt([0.5, 1, 1.5]))
        self.assertEqual(counts.tolist(), [12, 6, 24])

    def test_one_and_two_periodic_axes(self):
        cell = [[0, 0, 0], [0, 2, 0], [0, 1, 1]]
        # A square lattice: four neighbours at the square root of 2, four at 2.
        i, shifts = hgrid.neighbor_list("iS", [[5, 5, 5]], 2.1, cell=cell, pbc=(False, True, True))
        self.assertEqual(len(i), 8)
        self.assertFalse(shifts[:, 0].any())
        shifts = hgrid.neighbor_list("S", [[5, 5, 5]], 2.1, cell=cell, pbc=(False, True, False))
        self.assertEqual(sorted(shifts.tolist()), [[0, -1, 0], [0, 1, 0]])


class Arguments(unittest.TestCase):
    def test_objects_like_atoms(self):
        x = np.array([[0.0, 0, 0], [0, 0, 1.25]])
        atoms = SimpleNamespace(positions=x, cell=np.diag([9, 9, 2.0]), pbc=(False, False, True), symbols=["C", "O"])
        self.assertEqual(hgrid.neighbor_list("j", atoms, 1).tolist(), [1, 0])
        self.assertEqual(hgrid.neighbor_list("j", atoms, {("C", "O"): 1}).tolist(), [1, 0])
        self.assertEqual(hgrid.neighbor_list("j", atoms, {("C", "O"): 1}, numbers=[6, 7]).tolist(), [])
        self.assertEqual(hgrid.neighbor_list("j", atoms, 1, pbc=False).tolist(), [])
        self.assertEqual(hgrid.neighbor_list("j", atoms, 1, cell=[9, 9, 5]).tolist(), [])

    def test_what_is_returned(self):
        x = np.array([[0.0, 0, 0], [0, 0, 1]])
        self.assertIsInstance(hgrid.neighbor_list("i", x, 2), np.ndarray)
        self.assertEqual(hgrid.neighbor_list("", x, 2), ())
        for letters in ("ijSDd", "dDSji", "ii"):
            self.assertEqual(len(hgrid.neighbor_list(letters, x, 2)), len(letters))
        i, j, shifts, vectors, distances = hgrid.neighbor_list("ijSDd", [], 2, self_interaction=True)
        for array, kind, shape in zip(
            (i, j, shifts, vectors, distances), (int, int, int, float, float), ((0,), (0,), (0, 3), (0, 3), (0,))
        ):
            self.assertEqual((array.dtype, array.shape), (np.dtype(kind), shape))
        self.assertEqual(hgrid.neighbor_list("i", [], {("H", "H"): 2}, numbers=[]).shape, (0,))
        self.assertEqual(hgrid.neighbor_list("i", [], [], cell=np.eye(3), pbc=True).shape, (0,))

    def test_refused(self):
        x = np.zeros((2, 3))
        for text, arguments in (
            (r"quantities is 'ix'; 'x' is none of", dict(quantities="ix")),
            (r"a cutoff is needed", dict(cutoff=None)),
            (r"cutoff = -1.*not negative", dict(cutoff=-1)),
            (r"cutoff = nan", dict(cutoff=np.nan)),
            (r"cutoff must have shape \(2,\), not \(3,\)", dict(cutoff=[1, 2, 3])),
            (r"cutoff\[1\] = -2", dict(cutoff=[1, -2])),
            (r"cutoff\[\('C', 'C'\)\] = inf", dict(cutoff={("C", "C"): np.inf}, numbers=[6, 6])),
            (r"pair of kinds", dict(cutoff={("C", "C", "C"): 1}, numbers=[6, 6])),
            (r"not by both", dict(cutoff={("C", "C"): 1, "H": 2}, numbers=[6, 6])),
            (r"needs atoms with numbers or symbols", dict(cutoff={"H": 2})),
            (r"numbers must have shape \(2,\)", dict(cutoff={"H": 2}, numbers=[1])),
            (r"positions must have shape \(n, 3\), not \(2, 2\)", dict(a=np.zeros((2, 2)))),
            (r"positions\[1\] = \[ *0. +nan", dict(a=[[0, 0, 0], [0, np.nan, 0]])),
            (r"positions\[1\]\[2\] = 9007199254740993", dict(a=[[0, 0, 0], [0, 0, 2**53 + 1]])),
            (r"there is no cell", dict(pbc=True)),
            (r"cell\[1\] = .*must span a cell", dict(pbc=True, cell=[[1, 0, 0], [2, 0, 0], [0, 0, 1]])),
            (r"cell\[2\] = .*must span a cell", dict(pbc=True, cell=[[1, 0, 0], [0, 1, 0], [0, 0, 0]])),
            (r"cell\[0\] = .*not finite", dict(pbc=True, cell=[[np.inf, 0, 0], [0, 1, 0], [0, 0, 1]])),
            (r"cell must have shape \(3, 3\), not \(2, 2\)", dict(pbc=True, cell=np.eye(2))),
            (r"pbc must be one truth value or three", dict(pbc=[True, False])),
        ):
            with self.subTest(text), self.assertRaisesRegex(hgrid.ArgumentError, text):
                hgrid.neighbor_list(**{"quantities": "i", "a": x, "cutoff": 1.0, **arguments})


@unittest.skipIf(Atoms is None, "ASE is not installed")
class BesideAse(unittest.TestCase):
    def test_the_same_list(self):
        rng = np.random.default_rng(15)
        cutoffs = (2.5, rng.uniform(0, 1.5, size=20), {("C", "H"): 2.1, (1, 1): 1.0, ("O", 6): 3.0})
        for trial in range(12):
            atoms = Atoms(
                numbers=rng.choice([1, 6, 8], size=20),
                positions=rng.normal(size=(20, 3)) * 3,
                cell=any_cell(rng),
                pbc=rng.random(3) < 0.7,
            )
            cutoff, itself = cutoffs[trial % 3], bool(trial % 2)
            ours = hgrid.neighbor_list("ijSDd", atoms, cutoff, itself)
            theirs = list_of_ase("ijSDd", atoms, cutoff, itself)
            with self.subTest(trial=trial):
                self.assertEqual([a.dtype for a in ours], [a.dtype for a in theirs])
                order, other = (np.lexsort((*a[2].T, a[1], a[0])) for a in (ours, theirs))
                for mine, yours in zip(ours, theirs):
                    np.testing.assert_array_equal(mine[order], yours[other])


if __name__ == "__main__":
    unittest.main()
