// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Ranks of a system too large to be held: side^d copies of one periodic cell, each the part of one rank. All ranks then
// have the same ghosts, so that one of them tells everything.
#pragma once

#include "programs/ranks/ghosts.hpp"

#include <hgrid/types.h>

namespace ranks {

struct Repeated {
  Exchange exchange;
  Part ghosts;  // where they are, around the cell of the rank
};

// def: with the cell of one copy, of which all axes are periodic and none is tilted.
Repeated repeat(const hg_grid_def &def, const Part &copy, int side);

// The cell of all copies.
hg_grid_def cell_of_all(hg_grid_def def, int side);

}  // namespace ranks
