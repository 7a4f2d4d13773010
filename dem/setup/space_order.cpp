// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// An order of particles in which neighbours in space are neighbours in memory.
#include "dem/setup/space_order.hpp"

#include "packing/morton.hpp"

#include <algorithm>
#include <cmath>

namespace dem {
namespace {

constexpr int kBits = 21;  // per axis: three fit into a word

template <class Item>
void reorder_rows(std::vector<Item> &rows, size_t count, const std::vector<uint32_t> &order) {
  if (rows.empty()) return;
  const size_t width = rows.size() / count;
  std::vector<Item> result;
  result.reserve(width * order.size());
  for (const uint32_t i : order) {
    const auto row = rows.begin() + static_cast<ptrdiff_t>(i * width);
    result.insert(result.end(), row, row + static_cast<ptrdiff_t>(width));
  }
  rows.swap(result);
}

}  // namespace

std::vector<uint32_t> space_order(const std::vector<double> &centers, int dimension) {
  const auto width = static_cast<size_t>(dimension);
  const size_t count = centers.size() / width;
  double low[3], extent = 0;
  for (size_t axis = 0; axis < width; axis++) {
    double least = kInfinity, most = -kInfinity;
    for (size_t i = 0; i < count; i++) {
      least = std::min(least, centers[i * width + axis]);
      most = std::max(most, centers[i * width + axis]);
    }
    low[axis] = least;
    extent = std::max(extent, most - least);
  }
  const double scale = extent > 0 ? ((1 << kBits) - 1) / extent : 0;
  std::vector<uint64_t> places(count);
  for (size_t i = 0; i < count; i++) {
    uint32_t cell[3]{};
    for (size_t axis = 0; axis < width; axis++) {
      cell[axis] = static_cast<uint32_t>((centers[i * width + axis] - low[axis]) * scale);
    }
    places[i] = packing::morton_place(cell, dimension, kBits);
  }
  return packing::order_by_place<uint32_t>(places);
}

Setup reordered(const Setup &setup, const std::vector<uint32_t> &order) {
  Setup result = setup;
  reorder(result, order);
  return result;
}

void reorder(ParticleArrays &particles, const std::vector<uint32_t> &order) {
  const size_t count = particles.count();
  for (auto *rows :
       {&particles.centers, &particles.velocities, &particles.radii, &particles.masses, &particles.spins}) {
    reorder_rows(*rows, count, order);
  }
  reorder_rows(particles.material_ids, count, order);
}

std::vector<uint32_t> inverse(const std::vector<uint32_t> &order) {
  std::vector<uint32_t> result(order.size());
  for (size_t k = 0; k < order.size(); k++) result[order[k]] = static_cast<uint32_t>(k);
  return result;
}

}  // namespace dem
