// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// An order in which particles that are near in space stand near in memory.
#ifndef HGRID_SIM_EVENT_SPATIAL_ORDER_HPP
#define HGRID_SIM_EVENT_SPATIAL_ORDER_HPP

#include "sim/box.hpp"
#include "sim/vector.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace hgrid_sim::event {

// The place of a point on Morton's curve: the bits of its cell numbers, 1024 cells per axis, in turn.
inline std::uint32_t morton_place(const Box &box, const Vector &point) {
  constexpr int kBits = 10;
  std::uint32_t place = 0;
  for (int k = 0; k < box.dimension(); ++k) {
    const double cell = point[k] / box.edge(k) * (1 << kBits);
    const auto number = static_cast<std::uint32_t>(std::min(std::max(cell, 0.0), (1 << kBits) - 1.0));
    for (int bit = 0; bit < kBits; ++bit) place |= ((number >> bit) & 1u) << (box.dimension() * bit + k);
  }
  return place;
}

// The numbers of the points along that curve.
inline std::vector<std::size_t> spatial_order(const Box &box, const std::vector<Vector> &points) {
  std::vector<std::uint32_t> places;
  places.reserve(points.size());
  for (const Vector &point : points) places.push_back(morton_place(box, point));
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return places[a] < places[b]; });
  return order;
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
