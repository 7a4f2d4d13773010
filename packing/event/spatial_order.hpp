// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// An order in which particles that are near in space stand near in memory.
#pragma once

#include "packing/box.hpp"
#include "packing/morton.hpp"
#include "packing/vector.hpp"

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
    for (int axis = 0; axis < box.dimension(); axis++) {
      const double place = point[axis] / box.edge(axis) * (1 << kBits);
      cell[axis] = static_cast<uint32_t>(std::min(std::max(place, 0.0), (1 << kBits) - 1.0));
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
