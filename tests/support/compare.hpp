// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Grids filled at once, and comparisons that throw a text which says what differs.
#pragma once

#include "tests/support/frame.h"
#include "tests/support/holds.hpp"
#include "tests/support/oracle.hpp"

#include <hgrid/hgrid.h>
#include <hgrid/hgrid.hpp>

#include <string>

namespace hgtest {

void require(bool condition, const std::string &what);
void require_same(const char *what, const Pairs &got, const Pairs &expected);
void require_same(const char *what, const std::vector<int32_t> &got, const std::vector<int32_t> &expected);

// What the library lends, as lists that stay.
inline std::vector<int32_t> list_of(hgrid::View<int32_t> ids) { return {ids.begin(), ids.end()}; }
void require_rows(const std::string &what, const hgrid::Rows &got, const std::vector<std::vector<int32_t>> &expected);

// The status with which the library refuses a call; HG_OK if it does not.
template <class Call>
hg_status status_of(Call call) {
  try {
    call();
    return HG_OK;
  } catch (const hgrid::Error &error) {
    return error.status();
  }
}

using hgrid::Grid;
inline Grid make_grid(const hg_grid_def &def, const Particles &particles) {
  Grid grid(def);
  grid.insert(particles.count(), particles.centers.data(), particles.radii.data());
  return grid;
}
// Gives the grid the box of the definition.
void set_box(const Grid &grid, const hg_grid_def &def);

// The pairs in the order of the library, and sorted by id.
Pairs pairs_of(const Grid &grid);
Pairs sorted_pairs_of(const Grid &grid);
Pairs sorted(Pairs pairs);

// The rows of hg_query_neighbors as pairs (row, neighbour); throws if a row descends.
Pairs pairs_of_rows(const Grid &grid, int32_t list);

// What HG_FLOAT may return: each pair once, all of `expected`, and of others only such as nearly touch.
void require_superset(const std::string &what, const hg_grid_def &def, const Particles &particles, const Pairs &got,
                      const Pairs &expected);

// A grid of these particles finds the pairs of exact arithmetic.
void require_exact(const std::string &what, const hg_grid_def &def, const Particles &particles);

}  // namespace hgtest
