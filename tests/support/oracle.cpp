// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Loops of the oracle over all pairs.
#include "tests/support/oracle.hpp"

#include <numeric>

namespace hgtest {

Pairs all_pairs(const hg_grid_def &def, const Particles &particles, const std::vector<int32_t> &ids,
                Interact *interact) {
  Pairs pairs;
  for (size_t i = 0; i < particles.size(); i++) {
    for (size_t j = i + 1; j < particles.size(); j++) {
      if (interact(def, {particles.center(i), particles.radii[i]}, {particles.center(j), particles.radii[j]})) {
        pairs.push_back({ids[i], ids[j]});
      }
    }
  }
  return pairs;
}

Pairs all_pairs(const hg_grid_def &def, const Particles &particles, Interact *interact) {
  std::vector<int32_t> ids(particles.size());
  std::iota(ids.begin(), ids.end(), def.index_base);
  return all_pairs(def, particles, ids, interact);
}

std::vector<int32_t> all_in_sphere(const hg_grid_def &def, const Particles &particles, const Sphere &sphere,
                                   Interact *interact) {
  std::vector<int32_t> ids;
  for (size_t i = 0; i < particles.size(); i++) {
    if (interact(def, sphere, {particles.center(i), particles.radii[i]})) {
      ids.push_back(static_cast<int32_t>(i) + def.index_base);
    }
  }
  return ids;
}

}  // namespace hgtest
