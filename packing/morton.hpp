// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Places along Morton's curve (1966), on which points that are near in space mostly are near too.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace packing {

// The `bits` lowest bits of the cell numbers, in turn; dimension * bits <= 64.
inline uint64_t morton_place(const uint32_t *cell, int dimension, int bits) {
  uint64_t place = 0;
  for (int bit = 0; bit < bits; bit++) {
    for (int axis = 0; axis < dimension; axis++) place |= uint64_t{cell[axis] >> bit & 1u} << (dimension * bit + axis);
  }
  return place;
}

// The numbers of the points in ascending place; equal places keep their order.
template <class Number>
std::vector<Number> order_by_place(const std::vector<uint64_t> &places) {
  std::vector<Number> order(places.size());
  std::iota(order.begin(), order.end(), Number{0});
  std::stable_sort(order.begin(), order.end(), [&](Number a, Number b) { return places[a] < places[b]; });
  return order;
}

}  // namespace packing
