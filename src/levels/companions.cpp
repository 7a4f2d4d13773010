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

// How many of the sample lie in each cell, by open addressing.
class CellCounts {
 public:
  CellCounts() { std::fill(cell_, cell_ + kPlaces, kNone); }

  // Returns how many are there already.
  uint32_t add(uint64_t cell) {
    size_t at = static_cast<size_t>(cell * 0x9e3779b97f4a7c15u >> (64 - kPlaceBits));
    while (cell_[at] != cell && cell_[at] != kNone) at = (at + 1) % kPlaces;
    if (cell_[at] == kNone) count_[at] = 0;
    cell_[at] = cell;
    return count_[at]++;
  }

 private:
  static constexpr int kPlaceBits = 13;
  static constexpr size_t kPlaces = size_t{1} << kPlaceBits;  // twice as many as are looked at
  static_assert(kPlaces >= 2 * kSample);
  static constexpr uint64_t kNone = ~uint64_t{0};

  uint64_t cell_[kPlaces];
  uint16_t count_[kPlaces];
};

}  // namespace

double estimate_companions(const Participants &particles, const FixedPoint &map, int dimension, const CellTable &cells,
                           const RadiusRange &radii, size_t members, double enough) {
  const size_t count = particles.count(), looked_at = std::min(count, kSample);
  const auto mean = [members](double together, size_t sampled) {
    const double all_pairs = 0.5 * static_cast<double>(sampled) * static_cast<double>(sampled - 1);
    return static_cast<double>(members) * together / all_pairs;
  };
  CellCounts counts;
  size_t sampled = 0;
  double together = 0;  // pairs in a cell
  for (size_t n = 0; n < looked_at; n++) {
    const size_t slot = n * count / looked_at;
    const double radius = particles.radius(slot);
    if (!(radius > radii.above && radius <= radii.up_to)) continue;
    sampled++;
    together += counts.add(cell_number(particles.center(slot), map, dimension, cells));
    if (sampled > 1 && mean(together, looked_at) > enough) return mean(together, looked_at);
  }
  return sampled < 2 ? 0 : mean(together, sampled);
}

}  // namespace hg
