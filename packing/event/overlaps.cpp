// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A packing handed to the library to be searched for overlaps.
#include "packing/event/overlaps.hpp"

#include <hgrid/hgrid.hpp>

namespace packing::event {

size_t count_overlaps(const Box &box, const std::vector<Vector> &centers, const std::vector<double> &radii) {
  hg_grid_def def = hg_default_grid_def();
  box.describe(def);
  def.accuracy = HG_EXACT;
  hgrid::Grid grid(def);
  std::vector<double> flat;
  flat.reserve(centers.size() * static_cast<size_t>(box.dimension()));
  for (const Vector &center : centers) flat.insert(flat.end(), center.data(), center.data() + box.dimension());
  grid.insert(radii.size(), flat.data(), radii.data());
  return grid.query_pairs().size();
}

size_t count_beyond_walls(const Box &box, const std::vector<Vector> &centers, const std::vector<double> &radii) {
  size_t count = 0;
  for (size_t i = 0; i < centers.size(); i++) {
    bool beyond = false;
    for (int axis = 0; axis < box.dimension(); axis++) {
      if (box.is_periodic(axis)) continue;
      beyond = beyond || centers[i][axis] - radii[i] < 0 || centers[i][axis] + radii[i] > box.edge(axis);
    }
    if (beyond) count++;
  }
  return count;
}

}  // namespace packing::event
