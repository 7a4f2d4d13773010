// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Boxes and triangles drawn among particles, and what a grid says of them against rational numbers.
#pragma once

#include "tests/support/compare.hpp"
#include "tests/support/rng.hpp"

#include <string>
#include <vector>

namespace hgtest {

// What a grid holds; the cell is not tilted.
struct Population {
  const std::string &name;
  const hg_grid_def &def;
  const Particles &particles;
  const std::vector<int32_t> &ids;
  const Grid &grid;
};

void check_boxes(Rng &rng, const Population &among);
// In two dimensions: they are refused.
void check_triangles(Rng &rng, const Population &among);

}  // namespace hgtest
