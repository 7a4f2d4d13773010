// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Mapping phase and contact detection phase of the paper on linked lists in a hash table.
#include "programs/bench/hashed_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace bench {
namespace {

// Eq. 1: indices of the cell along the axes, and its level.
using Cell = std::array<int32_t, 4>;
constexpr int32_t kNobody = -1;

class HashedGrid {
 public:
  HashedGrid(const Particles &particles, const std::vector<double> &cell_sizes)
      : particles_(particles), sizes_(cell_sizes), cell_of_(particles.count), next_(particles.count, kNobody) {
    size_t slots = 2;
    while (slots < 2 * particles.count) slots *= 2;
    slots_.assign(slots, {{}, kNobody});
    for (size_t i = 0; i < particles.count; i++) put(static_cast<int32_t>(i));
  }

  std::vector<hg_pair> search() {
    for (int32_t p = 0; p < static_cast<int32_t>(particles_.count); p++) {
      search_own_level(p);
      for (int32_t level = 0; level < cell_of(p)[3]; level++) search_finer(p, level);
    }
    return std::move(pairs_);
  }
  int64_t tested() const { return tested_; }

 private:
  struct Slot {
    Cell cell;
    int32_t first;  // particle of the list
  };

  const Cell &cell_of(int32_t p) const { return cell_of_[static_cast<size_t>(p)]; }
  const double *center(int32_t p) const { return particles_.centers + 3 * static_cast<size_t>(p); }
  double radius(int32_t p) const { return particles_.radii[p]; }

  Cell cell_at(const std::array<double, 3> &x, int32_t level) const {
    const double size = sizes_[static_cast<size_t>(level)];
    Cell cell{0, 0, 0, level};
    for (size_t k = 0; k < 3; k++) cell[k] = static_cast<int32_t>(std::floor(x[k] / size));
    return cell;
  }

  size_t slot_of(const Cell &cell) const {
    uint64_t hash = 0;
    for (const int32_t part : cell) hash = (hash ^ static_cast<uint32_t>(part)) * 0x9e3779b97f4a7c15u;
    size_t slot = static_cast<size_t>(hash >> 20) & (slots_.size() - 1);
    while (slots_[slot].first != kNobody && slots_[slot].cell != cell) slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }

  // Level of insertion, Eq. 3.
  void put(int32_t p) {
    const auto level = std::lower_bound(sizes_.begin(), sizes_.end(), 2 * radius(p));
    if (level == sizes_.end()) {
      throw std::invalid_argument("particle " + std::to_string(p) + " is larger than the cells of the last level");
    }
    const double *x = center(p);
    const Cell cell = cell_at({x[0], x[1], x[2]}, static_cast<int32_t>(level - sizes_.begin()));
    Slot &slot = slots_[slot_of(cell)];
    cell_of_[static_cast<size_t>(p)] = cell;
    next_[static_cast<size_t>(p)] = slot.first;
    slot = {cell, p};
  }

  void test(int32_t p, int32_t q) {
    tested_++;
    const double *a = center(p), *b = center(q);
    const double reach = radius(p) + radius(q);
    const double dx = a[0] - b[0], dy = a[1] - b[1], dz = a[2] - b[2];
    if (std::abs(dx) >= reach || std::abs(dy) >= reach || std::abs(dz) >= reach) return;
    if (dx * dx + dy * dy + dz * dz < reach * reach) pairs_.push_back({std::min(p, q), std::max(p, q)});
  }

  void test_list(int32_t p, int32_t first) {
    for (int32_t q = first; q != kNobody; q = next_[static_cast<size_t>(q)]) test(p, q);
  }

  // What follows in the own cell, and half of the cells around it: those behind in the order of (z, y, x).
  void search_own_level(int32_t p) {
    test_list(p, next_[static_cast<size_t>(p)]);
    for (int n = 14; n < 27; n++) {
      Cell cell = cell_of(p);
      cell[0] += n % 3 - 1;
      cell[1] += n / 3 % 3 - 1;
      cell[2] += n / 9 - 1;
      test_list(p, slots_[slot_of(cell)].first);
    }
  }

  // Eqs. 4 and 5.
  void search_finer(int32_t p, int32_t level) {
    const double a = radius(p) + 0.5 * sizes_[static_cast<size_t>(level)];
    const double *x = center(p);
    const Cell low = cell_at({x[0] - a, x[1] - a, x[2] - a}, level);
    const Cell high = cell_at({x[0] + a, x[1] + a, x[2] + a}, level);
    for (Cell cell = low; cell[2] <= high[2]; ++cell[2]) {
      for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1]) {
        for (cell[0] = low[0]; cell[0] <= high[0]; ++cell[0]) test_list(p, slots_[slot_of(cell)].first);
      }
    }
  }

  Particles particles_;
  const std::vector<double> &sizes_;
  std::vector<Slot> slots_;
  std::vector<Cell> cell_of_;
  std::vector<int32_t> next_;
  std::vector<hg_pair> pairs_;
  int64_t tested_ = 0;
};

}  // namespace

std::vector<hg_pair> hashed_grid_pairs(const Particles &particles, const std::vector<double> &cell_sizes,
                                       int64_t *tested) {
  HashedGrid grid(particles, cell_sizes);
  std::vector<hg_pair> pairs = grid.search();
  if (tested != nullptr) *tested = grid.tested();
  return pairs;
}

}  // namespace bench
