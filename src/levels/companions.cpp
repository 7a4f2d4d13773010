// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/levels/companions.hpp"

#include "src/kernels/lanes_scalar.hpp"

#include <algorithm>

namespace hg {
namespace {

constexpr size_t kSample = 4096;

uint64_t cell_number(const double *center, const FixedPoint &map, int dimension, const CellTable &cells) {
  uint64_t number = 0;
  int32_t x[3];
  map.find_coordinates(center, dimension, x);
  for (int axis = 0; axis < dimension; axis++) {
    const auto here = static_cast<float>(x[axis]);
    const int32_t cell = cell_of<ScalarLanes>(here, cells.inverse_width[axis], last_of(cells, axis));
    number = number << 20 | static_cast<uint64_t>(cell);
  }
  return number;
}

}  // namespace

double estimate_companions(const ParticleStore &store, const FixedPoint &map, int dimension, const CellTable &cells,
                           const RadiusRange &radii, size_t particles) {
  const size_t count = store.slots(), looked_at = std::min(count, kSample);
  uint64_t sample[kSample];
  size_t sampled = 0;
  for (size_t n = 0; n < looked_at; n++) {
    const size_t slot = n * count / looked_at;
    const double radius = store.radius(slot);
    if (!(radius > radii.above && radius <= radii.up_to)) continue;
    sample[sampled++] = cell_number(store.center(slot), map, dimension, cells);
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
