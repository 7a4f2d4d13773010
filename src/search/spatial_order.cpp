// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/search/spatial_order.hpp"

#include <algorithm>

namespace hg {
namespace {

struct PlacedSlot {
  uint64_t place[3];
  uint32_t slot;
};

// Beyond any place of a map.
constexpr double kMostQuanta = 0x1p48;

// Is the highest bit of x below that of y? (Chan 2002)
bool has_lower_bit(uint64_t x, uint64_t y) { return x < y && x < (x ^ y); }

// The axis on which the two differ most decides.
bool comes_before(const PlacedSlot &p, const PlacedSlot &q) {
  int axis = 0;
  uint64_t most = p.place[0] ^ q.place[0];
  for (int k = 1; k < 3; k++) {
    const uint64_t here = p.place[k] ^ q.place[k];
    if (!has_lower_bit(most, here)) continue;
    axis = k;
    most = here;
  }
  return most == 0 ? p.slot < q.slot : p.place[axis] < q.place[axis];
}

}  // namespace

void SpatialOrder::find(const BuiltGrid &grid) {
  const Index &index = grid.index;
  const size_t count = grid.store.slots();
  Buffer<PlacedSlot> placed(memory_);
  placed.require(count);
  ids_.require_room(count);
  for (size_t slot = 0; slot < count; slot++) {
    double center[3], quanta[3] = {0, 0, 0};
    for (int axis = 0; axis < index.domain.dimension; axis++) {
      const double x = grid.store.center(slot)[axis];
      center[axis] = index.is_squeezed(axis) ? index.squeezed.position(axis, x) : x;
    }
    index.map.find_quanta(center, index.domain.dimension, quanta);
    for (size_t k = 0; k < 3; k++) {
      placed[slot].place[k] = static_cast<uint64_t>(std::clamp(quanta[k], 0.0, kMostQuanta));
    }
    placed[slot].slot = static_cast<uint32_t>(slot);
  }
  std::sort(placed.data(), placed.data() + count, comes_before);
  for (size_t k = 0; k < count; k++) ids_[k] = grid.store.id(placed[k].slot);
  found_ = true;
}

}  // namespace hg
