// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// An order in which particles that are near in space stand near in memory.
#pragma once

#include "packing/event/box.hpp"
#include "packing/event/vector.hpp"
#include "packing/morton.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace packing::event {

// The numbers of the points along Morton's curve, 1024 cells per axis of the box.
inline std::vector<size_t> spatial_order(const Box &box, const std::vector<Vector> &points) {
  constexpr int kBits = 10;
  std::vector<uint64_t> places;
  places.reserve(points.size());
  for (const Vector &point : points) {
    uint32_t cell[3] = {0, 0, 0};
    for (int k = 0; k < box.dimension(); k++) {
      const double place = point[k] / box.edge(k) * (1 << kBits);
      cell[k] = static_cast<uint32_t>(std::min(std::max(place, 0.0), (1 << kBits) - 1.0));
    }
    places.push_back(morton_place(cell, box.dimension(), kBits));
  }
  return order_by_place<size_t>(places);
}

// items[order[0]], items[order[1]] ...
template <class T>
std::vector<T> reordered(const std::vector<T> &items, const std::vector<size_t> &order) {
  std::vector<T> result;
  result.reserve(items.size());
  for (const size_t k : order) result.push_back(items[k]);
  return result;
}

}  // namespace packing::event
