// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// An order in which particles that are near in space stand near in memory.
#ifndef HGRID_SIM_EVENT_SPATIAL_ORDER_HPP
#define HGRID_SIM_EVENT_SPATIAL_ORDER_HPP

#include "sim/box.hpp"
#include "sim/morton.hpp"
#include "sim/vector.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace hgrid_sim::event {

// The numbers of the points along Morton's curve, 1024 cells per axis of the box.
inline std::vector<std::size_t> spatial_order(const Box &box, const std::vector<Vector> &points) {
  constexpr int kBits = 10;
  std::vector<std::uint64_t> places;
  places.reserve(points.size());
  for (const Vector &point : points) {
    std::uint32_t cell[3] = {0, 0, 0};
    for (int k = 0; k < box.dimension(); ++k) {
      const double place = point[k] / box.edge(k) * (1 << kBits);
      cell[k] = static_cast<std::uint32_t>(std::min(std::max(place, 0.0), (1 << kBits) - 1.0));
    }
    places.push_back(morton_place(cell, box.dimension(), kBits));
  }
  return order_by_place<std::size_t>(places);
}

// items[order[0]], items[order[1]] ...
template <class T>
std::vector<T> reordered(const std::vector<T> &items, const std::vector<std::size_t> &order) {
  std::vector<T> result;
  result.reserve(items.size());
  for (const std::size_t k : order) result.push_back(items[k]);
  return result;
}

}  // namespace hgrid_sim::event

#endif
