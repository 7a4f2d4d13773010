// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Linked cells with the usual half stencil; particles are copied in cell order, so that candidates are read in a row.
#include "programs/bench/linked_cell.hpp"

#include "programs/bench/half_stencil.hpp"

#include <algorithm>
#include <numeric>

namespace bench {
namespace {

template <int D>
std::vector<hg_pair> search(const Particles &particles, int64_t *tested) {
  std::vector<hg_pair> pairs;
  int64_t candidates = 0;
  const double largest =
      particles.count > 0 ? *std::max_element(particles.radii, particles.radii + particles.count) : 0;
  if (largest > 0) {  // points overlap nothing
    std::vector<int32_t> members(particles.count);
    std::iota(members.begin(), members.end(), 0);
    const CellArray<D> cells(particles, members, bounds_of<D>(particles), 2 * largest);
    candidates = half_stencil_pairs(cells, pairs);
  }
  if (tested != nullptr) *tested = candidates;
  return pairs;
}

}  // namespace

std::vector<hg_pair> linked_cell_pairs(int dimension, const Particles &particles, int64_t *tested) {
  return dimension == 2 ? search<2>(particles, tested) : search<3>(particles, tested);
}

}  // namespace bench
