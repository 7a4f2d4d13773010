// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A level whose particles fill space so unevenly that a table of cells would be mostly empty: only occupied rows are
// stored, sorted, with 64-bit cell numbers. Memory is O(N_h) whatever the extent; finding a row is a binary search.
#pragma once

#include "src/base/memory.hpp"
#include "src/exact/domain.hpp"
#include "src/particles/particle_store.hpp"

#include <cstddef>
#include <cstdint>

namespace hg {

// Positions in the box, and the cells of rows, of one sparse level.
struct SparseLevel {
  double width = 1;  // of a row; at least s_h
  double origin[3] = {0, 0, 0};
  size_t first_slab = 0, end_slab = 0;  // rows with the same z lie together in a slab
  uint32_t begin = 0, end = 0;          // particles, in the sorted order of the index
  size_t offset = 0;                    // of particle `begin` in SparseRows::x

  // Monotone, never undefined: numbers beyond 2^62 share the outermost row.
  int64_t row_of(int axis, double position) const;
};

class SparseRows {
 public:
  explicit SparseRows(Memory &memory)
      : order_(memory), x_(memory), row_y_(memory), row_begin_(memory), slab_z_(memory), slab_row_(memory) {}

  void clear() { particles_ = rows_ = slabs_ = 0; }
  // Sorts slots[0 .. count) into row order and stores their rows.
  SparseLevel add_level(const ParticleStore &store, const Domain &domain, const double *origin, double width,
                        uint32_t *slots, uint32_t begin, uint32_t count);
  size_t rows() const { return rows_; }

  // Calls visit(begin, end) for runs of particles that hold all those of the level whose centres lie in
  // [low, high] (a box of [dimension]). visit returns false to stop. Returns false if stopped.
  template <class Visit>
  bool visit_box(const SparseLevel &level, int dimension, const double *low, const double *high, Visit &&visit) const {
    const int64_t first_z = dimension == 3 ? level.row_of(2, low[2]) : 0;
    const int64_t last_z = dimension == 3 ? level.row_of(2, high[2]) : 0;
    const int64_t first_y = level.row_of(1, low[1]), last_y = level.row_of(1, high[1]);
    for (size_t slab = lower_slab(level, first_z); slab < level.end_slab && slab_z_[slab] <= last_z; slab++) {
      for (size_t row = lower_row(slab, first_y); row < slab_row_[slab + 1] && row_y_[row] <= last_y; row++) {
        if (!visit_row(level, row, low[0], high[0], visit)) return false;
      }
    }
    return true;
  }

  // Where a particle of the level stands; moves on as visit_after is called for particles in ascending order.
  struct Place {
    size_t slab, row;
  };
  Place place_of(const SparseLevel &level, uint32_t i) const;

  // As visit_box, for particle i of the level itself: only what comes after it in sorted order.
  template <class Visit>
  bool visit_after(const SparseLevel &level, int dimension, uint32_t i, Place &place, const double *low,
                   const double *high, Visit &&visit) const {
    size_t &row = place.row, &slab = place.slab;
    while (row_begin_[row + 1] <= i) row++;
    while (slab_row_[slab + 1] <= row) slab++;

    const uint32_t own_end = upper_particle(level, row, high[0]);
    if (own_end > i + 1 && !visit(i + 1, own_end)) return false;
    const int64_t last_y = level.row_of(1, high[1]);
    for (size_t next = row + 1; next < slab_row_[slab + 1] && row_y_[next] <= last_y; next++) {
      if (!visit_row(level, next, low[0], high[0], visit)) return false;
    }
    if (dimension == 2) return true;
    const int64_t last_z = level.row_of(2, high[2]), first_y = level.row_of(1, low[1]);
    for (size_t later = slab + 1; later < level.end_slab && slab_z_[later] <= last_z; later++) {
      for (size_t next = lower_row(later, first_y); next < slab_row_[later + 1] && row_y_[next] <= last_y; next++) {
        if (!visit_row(level, next, low[0], high[0], visit)) return false;
      }
    }
    return true;
  }

 private:
  size_t lower_slab(const SparseLevel &level, int64_t z) const;
  size_t lower_row(size_t slab, int64_t y) const;
  uint32_t lower_particle(const SparseLevel &level, size_t row, double x) const;
  uint32_t upper_particle(const SparseLevel &level, size_t row, double x) const;

  template <class Visit>
  bool visit_row(const SparseLevel &level, size_t row, double low, double high, Visit &visit) const {
    const uint32_t begin = lower_particle(level, row, low), end = upper_particle(level, row, high);
    return end <= begin || visit(begin, end);
  }

  struct Key {
    int64_t z, y;
    double x;
    uint32_t slot;
  };
  Buffer<Key> order_;  // scratch
  Buffer<double> x_;   // positions in the box, sorted within each row
  Buffer<int64_t> row_y_;
  Buffer<uint32_t> row_begin_;  // in the sorted order of the index
  Buffer<int64_t> slab_z_;
  Buffer<size_t> slab_row_;  // first row of the slab
  size_t particles_ = 0, rows_ = 0, slabs_ = 0;
};

}  // namespace hg
