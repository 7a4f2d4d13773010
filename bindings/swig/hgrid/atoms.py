# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Neighbour lists of atoms in cells of any shape, in the manner of ASE, matscipy and vesin."""

import numpy as np

from . import arrays
from .errors import ArgumentError
from .grid import Grid

_SYMBOLS = (
    "H He Li Be B C N O F Ne Na Mg Al Si P S Cl Ar K Ca Sc Ti V Cr Mn Fe Co Ni Cu Zn Ga Ge As Se Br Kr Rb Sr Y Zr Nb "
    "Mo Tc Ru Rh Pd Ag Cd In Sn Sb Te I Xe Cs Ba La Ce Pr Nd Pm Sm Eu Gd Tb Dy Ho Er Tm Yb Lu Hf Ta W Re Os Ir Pt Au "
    "Hg Tl Pb Bi Po At Rn Fr Ra Ac Th Pa U Np Pu Am Cm Bk Cf Es Fm Md No Lr Rf Db Sg Bh Hs Mt Ds Rg Cn Nh Fl Mc Lv Ts "
    "Og"
)
_NUMBERS = {symbol: number for number, symbol in enumerate(_SYMBOLS.split(), start=1)} | {"X": 0}


def _kind(name):
    """Kinds are compared by atomic number where they are elements, else by what they are called."""
    return _NUMBERS.get(name, name) if isinstance(name, str) else name


def _check_cutoff(value, name):
    if not (np.isfinite(value) and value >= 0):
        raise ArgumentError(f"{name} = {value}: it must be a finite number that is not negative")


class _Cutoffs:
    """What `cutoff` says: spheres wide enough to find all neighbours, and how near those of each two must be."""

    def __init__(self, cutoff, count, kinds):
        if isinstance(cutoff, dict):
            values, self._codes = _codes(kinds, count)
            self._table = _table(cutoff, values)
            self.radii = self._table.max(axis=1, initial=0)[self._codes] / 2
            self.limits = self._by_kind
        elif np.ndim(cutoff) == 0:
            _check_cutoff(cutoff, "cutoff")
            self._cutoff = float(cutoff)
            self.radii = np.full(count, self._cutoff / 2)
            self.limits = self._same
        else:
            self.radii = arrays.reals(cutoff, "cutoff", (count,))
            for index in np.flatnonzero(~(np.isfinite(self.radii) & (self.radii >= 0)))[:1]:
                _check_cutoff(self.radii[index], f"cutoff[{index}]")
            self.limits = self._by_radius

    def _same(self, i, j):
        return np.full(len(i), self._cutoff)

    def _by_kind(self, i, j):
        return self._table[self._codes[i], self._codes[j]]

    def _by_radius(self, i, j):
        return self.radii[i] + self.radii[j]


def _codes(kinds, count):
    """The kinds that there are, and for each atom which of them it is."""
    if kinds is None:
        raise ArgumentError("a cutoff by kinds needs atoms with numbers or symbols, or the argument numbers")
    array = np.asarray(kinds)
    arrays.check_shape(array, "numbers", (count,))
    values, codes = np.unique(array, return_inverse=True)
    return [_kind(value) for value in values.tolist()], codes


def _table(cutoff, values):
    """Cutoffs for each two of these kinds; 0 for those that `cutoff` does not name."""
    table = np.zeros((len(values), len(values)))
    places = {value: place for place, value in enumerate(values)}
    paired = [isinstance(key, tuple) for key in cutoff]
    if any(paired) and not all(paired):
        raise ArgumentError("cutoff must be by kinds or by pairs of kinds, not by both")
    radii = np.full(len(values), -np.inf)
    for key, value in cutoff.items():
        _check_cutoff(value, f"cutoff[{key!r}]")
        both = key if isinstance(key, tuple) else (key,)
        if len(both) > 2:
            raise ArgumentError(f"cutoff[{key!r}]: a pair of kinds is needed")
        at = [places[_kind(name)] for name in both if _kind(name) in places]
        if len(at) < len(both):
            continue
        if len(both) == 2:
            table[at[0], at[1]] = table[at[1], at[0]] = value
        else:
            radii[at[0]] = value
    return table if all(paired) else np.maximum(radii[:, None] + radii, 0)


class _Cell:
    """The periodic edges of a cell, and a frame in which the library can take them.

    The frame is a rotation, or one with a reflection, that makes the periodic edges lower triangular and puts them
    first. What it rounds is made good by a margin, and by a decision on distances in the frame of the caller.
    """

    def __init__(self, cell, pbc):
        flags = np.asarray(False if pbc is None else pbc)
        if flags.shape not in ((), (3,)):
            raise ArgumentError(f"pbc must be one truth value or three, not of shape {flags.shape}")
        self.axes = np.flatnonzero(np.broadcast_to(flags, 3))
        self.edges = self._edges(cell)[self.axes]
        q, r = np.linalg.qr(self.edges.T, mode="complete")
        signs = np.ones(3)
        signs[: len(self.axes)] = np.where(np.diagonal(r) < 0, -1.0, 1.0)
        self.turn = q * signs
        self.lower = np.zeros((3, 3))
        self.lower[: len(self.axes), : len(self.axes)] = (r * signs[:, None])[: len(self.axes)].T
        lengths = np.linalg.norm(self.edges, axis=1)
        for k, axis in enumerate(self.axes):
            if not self.lower[k, k] > 1e-10 * lengths[k]:
                raise ArgumentError(f"cell[{axis}] = {self.edges[k]}: the edges of periodic axes must span a cell")

    def _edges(self, cell):
        if cell is None:
            if len(self.axes) > 0:
                raise ArgumentError(f"pbc[{self.axes[0]}] is true, but there is no cell")
            return np.zeros((3, 3))
        array = np.asarray(cell)
        edges = arrays.reals(np.diag(array) if array.shape == (3,) else array, "cell", (3, 3))
        for axis in self.axes[~np.isfinite(edges[self.axes]).all(axis=1)][:1]:
            raise ArgumentError(f"cell[{axis}] = {edges[axis]} is not finite")
        return edges

    def margin(self, extent, reach):
        """More than what rounding can add to a distance of `reach` in the frame, for places up to `extent` away.

        Such images are at most (reach + 2 extent) / height edges away, with the height of the cell along that edge.
        """
        periodic = self.lower[: len(self.axes), : len(self.axes)]
        per_height = np.linalg.norm(np.linalg.inv(periodic), axis=0)
        added = (reach + 2 * extent) * (per_height * np.linalg.norm(self.edges, axis=1)).sum()
        return 32 * np.finfo(float).eps * (extent + reach + added)

    def grid(self, x, radii):
        """A grid of these atoms, in the frame."""
        places = x @ self.turn
        margin = self.margin(np.abs(x).max(initial=0), 2 * radii.max(initial=0))
        grid = Grid(
            periodic=np.arange(3) < len(self.axes),
            box=(np.zeros(3), np.diagonal(self.lower)),
            tilt=self.lower[[1, 2, 2], [0, 0, 1]],
            images="all",
            order="id",
            margin=margin,
        )
        grid.insert(places, radii)
        return grid


def _half(x, cell, cutoffs):
    """Neighbours i <= j, each once: i, j, S, D, d."""
    with cell.grid(x, cutoffs.radii) as grid:
        pairs, lattice = grid.query_pairs(shifts=True)
    i, j = pairs.T.astype(np.intp)
    vectors = x[j] - x[i]
    if len(cell.axes) > 0:
        vectors += lattice[:, : len(cell.axes)] @ cell.edges
    distances = np.sqrt(np.sum(vectors * vectors, axis=1))
    shifts = np.zeros((len(i), 3), dtype=np.intp)
    shifts[:, cell.axes] = lattice[:, : len(cell.axes)]
    near = distances < cutoffs.limits(i, j)
    return [array[near] for array in (i, j, shifts, vectors, distances)]


def neighbor_list(
    quantities,
    a=None,
    cutoff=None,
    self_interaction=False,
    max_nbins=None,
    *,
    positions=None,
    cell=None,
    pbc=None,
    numbers=None,
):
    """All neighbours of all atoms, as the functions of this name in ASE, matscipy and vesin give them.

        i, j, D = hgrid.neighbor_list("ijD", atoms, 5.0)
        i = hgrid.neighbor_list("i", positions=x, cell=cell, pbc=True, cutoff=5.0)

    Atom j, or an image of it, is a neighbour of atom i if it is nearer than the cutoff: d < cutoff, where d is computed
    in doubles. Every neighbour is found, also through several images in a cell of any shape and size; each stands in
    the list of both atoms.

    quantities: what is wanted, a string of these letters:
        i: the first atom, int64 of shape (m,).
        j: the second atom, int64 of shape (m,).
        S: which image of j it is, in whole edges of the cell, int64 of shape (m, 3), 0 along open axes.
        D: the vector from i to that image, x[j] - x[i] + S @ cell, float64 of shape (m, 3), in your unit of length.
        d: its length, float64 of shape (m,).
    a: atoms, an object with positions, cell, pbc and, where cutoff is by kinds, numbers or symbols, such as ase.Atoms;
        or their positions alone, shape (n, 3).
    cutoff: a number; or a radius for each atom, shape (n,): the cutoff of two atoms is then the sum of their radii; or
        a dictionary of cutoffs by pairs of kinds, {("C", "H"): 1.3, (1, 1): 1.0}, or of radii by kinds, {"C": 0.8}. A
        kind is an atomic number, the symbol of an element, or any other name that numbers or symbols hold. Kinds that
        are not named have no neighbours.
    self_interaction: whether each atom is a neighbour of itself, with S = 0, if its cutoff is not 0.
    max_nbins: has no effect; ASE's function has it.
    positions, cell, pbc, numbers: what `a` would tell, or in place of what it tells. cell: the edges, one a row, or
        three lengths; edges of open axes do not matter. pbc: one truth value for each axis, or one for all; False by
        default. numbers: the kinds, shape (n,), numbers or names.

    The list is in ascending order of i, then of j. Returns one array for each letter, in a tuple if there are several.
    Errors: ArgumentError, a ValueError, names what cannot be used, such as a negative cutoff, periodic edges that do
    not span a cell, or a position that is not finite; LimitError if the cell is beyond what docs/theory/exactness.md
    allows, or if there are more than 2^31 - 1 atoms.
    """
    if unknown := set(quantities) - set("ijSDd"):
        raise ArgumentError(f"quantities is {quantities!r}; {min(unknown)!r} is none of i, j, S, D, d")
    if cutoff is None:
        raise ArgumentError("a cutoff is needed")
    if positions is None:
        positions = getattr(a, "positions", a)
    x = arrays.reals(positions, "positions", ("n", 3))
    for index in np.flatnonzero(~np.isfinite(x).all(axis=1))[:1]:
        raise ArgumentError(f"positions[{index}] = {x[index]} is not finite")
    lattice = _Cell(getattr(a, "cell", None) if cell is None else cell, getattr(a, "pbc", None) if pbc is None else pbc)
    if numbers is None and isinstance(cutoff, dict):
        numbers = getattr(a, "numbers", None)
        if numbers is None and hasattr(a, "symbols"):
            numbers = list(a.symbols)
    cutoffs = _Cutoffs(cutoff, len(x), numbers)

    i, j, shifts, vectors, distances = _half(x, lattice, cutoffs)
    every = np.arange(len(x))
    itself = every[cutoffs.limits(every, every) > 0] if self_interaction else every[:0]
    first = np.concatenate((j, itself, i))
    order = np.argsort(first, kind="stable")

    def listed(backward, forward):
        """Neighbours i >= j of both atoms, atoms themselves, then i <= j: in order, once sorted by i."""
        return np.concatenate((backward, np.zeros((len(itself), *forward.shape[1:]), forward.dtype), forward))[order]

    made = {
        "i": lambda: first[order],
        "j": lambda: np.concatenate((i, itself, j))[order],
        "S": lambda: listed(-shifts, shifts),
        "D": lambda: listed(-vectors, vectors),
        "d": lambda: listed(distances, distances),
    }
    wanted = tuple(made[letter]() for letter in quantities)
    return wanted[0] if len(wanted) == 1 else wanted
