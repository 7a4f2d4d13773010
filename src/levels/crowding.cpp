// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/levels/crowding.hpp"

#include "src/space/level_cells.hpp"

#include <algorithm>

namespace hg {
namespace {

constexpr size_t kSample = 4096;

uint64_t cell_number(const double *center, const Domain &domain, const Frame &frame, const CellTable &cells) {
  uint64_t number = 0;
  for (int k = 0; k < domain.dimension; k++) {
    const int32_t x = frame.coordinate(k, domain.position(k, center[k]));
    number = number << 20 | static_cast<uint64_t>(cell_of(cells, k, static_cast<float>(x)));
  }
  return number;
}

}  // namespace

double estimate_crowding(const ParticleStore &store, const Domain &domain, const Frame &frame, const CellTable &cells,
                         const RadiusRange &radii, size_t particles) {
  const size_t stride = (particles + kSample - 1) / kSample;
  uint64_t sample[kSample];
  size_t seen = 0, sampled = 0;
  for (size_t slot = 0; slot < store.slots(); slot++) {
    const double radius = store.radius(slot);
    if (!(radius > radii.above && radius <= radii.up_to) || seen++ % stride != 0) continue;
    sample[sampled++] = cell_number(store.center(slot), domain, frame, cells);
  }
  if (sampled < 2) return 0;
  std::sort(sample, sample + sampled);
  double together = 0;
  for (size_t first = 0, i = 1; i <= sampled; i++) {
    if (i < sampled && sample[i] == sample[first]) continue;
    together += 0.5 * static_cast<double>(i - first) * static_cast<double>(i - first - 1);
    first = i;
  }
  const double all_pairs = 0.5 * static_cast<double>(sampled) * static_cast<double>(sampled - 1);
  return static_cast<double>(particles) * together / all_pairs;
}

}  // namespace hg
