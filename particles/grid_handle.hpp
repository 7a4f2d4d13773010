// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A grid of the library with C++ manners: freed by its destructor, failures thrown as particles::Error.
#pragma once

#include "particles/grid_pointer.hpp"
#include "particles/particle_set.hpp"

#include <hgrid/hgrid.h>

#include <cstddef>

namespace particles {

inline void check(hg_status status) { particles::require(status); }

// A borrowed array of the library: valid until the grid changes.
template <typename T>
struct Borrowed {
  const T *data = nullptr;
  size_t count = 0;
  const T *begin() const { return data; }
  const T *end() const { return data + count; }
};

class Grid {
 public:
  explicit Grid(const hg_grid_def &def) : grid_(particles::create_grid(def)) {}

  void insert(const ParticleSet &particles) {
    check(hg_insert(get(), particles.count(), particles.centers.data(), particles.radii.data()));
  }
  void move(const ParticleSet &particles) {
    check(hg_move(get(), particles.count(), particles.centers.data(), particles.radii.data()));
  }
  void build() { check(hg_build(get())); }

  Borrowed<hg_pair> pairs() {
    Borrowed<hg_pair> result;
    check(hg_query_pairs(get(), &result.data, &result.count));
    return result;
  }
  Borrowed<hg_level> levels() {
    Borrowed<hg_level> result;
    check(hg_query_levels(get(), &result.data, &result.count));
    return result;
  }
  Borrowed<hg_level_cost> level_costs() {
    Borrowed<hg_level_cost> result;
    check(hg_query_level_costs(get(), &result.data, &result.count));
    return result;
  }
  hg_grid_stats stats() {
    hg_grid_stats result{};
    check(hg_get_stats(get(), &result, sizeof result));
    return result;
  }
  void visit_pairs(hg_pair_visitor *visit, void *context) { check(hg_visit_pairs(get(), visit, context)); }

  hg_grid *get() const { return grid_.get(); }

 private:
  particles::GridPointer grid_;
};

}  // namespace particles
