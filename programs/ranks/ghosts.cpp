// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/ranks/ghosts.hpp"

#include "mpi/selection.hpp"

#include <algorithm>

namespace ranks {

std::vector<Exchange> exchanges_of(const hgrid::mpi::ReachRule &rule, const std::vector<Part> &parts) {
  hgrid::mpi::BoxesOfRanks boxes{{}, {0}};
  for (const Part &part : parts) {
    const auto own = make_size_classes(rule.cell(), part.count(), part.centers.data(), part.radii.data()).boxes;
    boxes.boxes.insert(boxes.boxes.end(), own.begin(), own.end());
    boxes.begin.push_back(boxes.boxes.size());
  }
  std::vector<Exchange> exchanges(parts.size());
  for (size_t k = 0; k < parts.size(); k++) {
    const Part &own = parts[k];
    const hgrid::mpi::Selection selection(rule, own.count(), own.centers.data(), own.radii.data());
    const std::vector<std::vector<int32_t>> rows = selection.rows_for(boxes, k);
    exchanges[k].owned = static_cast<int64_t>(own.count());
    for (size_t other = 0; other < parts.size(); other++) {
      if (rows[other].empty()) continue;
      exchanges[k].sent += static_cast<int64_t>(rows[other].size());
      exchanges[k].send_ranks++;
      exchanges[other].ghosts += static_cast<int64_t>(rows[other].size());
      exchanges[other].receive_ranks++;
    }
  }
  return exchanges;
}

std::vector<Part> with_largest_radius(std::vector<Part> parts) {
  double largest = 0;
  for (const Part &part : parts) {
    for (const double radius : part.radii) largest = std::max(largest, radius);
  }
  for (Part &part : parts) std::fill(part.radii.begin(), part.radii.end(), largest);
  return parts;
}

}  // namespace ranks
