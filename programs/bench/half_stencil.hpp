// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Pairs within one grid of cells: the own cell and half of its 3^d - 1 neighbours.
#pragma once

#include "programs/bench/cell_array.hpp"

#include <hgrid/types.h>

#include <algorithm>
#include <vector>

namespace bench {

template <int D>
inline void test_range(const Sorted<D> &p, const Sorted<D> *first, const Sorted<D> *last, std::vector<hg_pair> &pairs) {
  for (const Sorted<D> *q = first; q != last; q++) {
    if (overlap(p, *q)) pairs.push_back({std::min(p.id, q->id), std::max(p.id, q->id)});
  }
}

// Appends every overlapping pair and returns the number of candidates. Cells lie in rows along x, so the half stencil
// is the rest of the own cell with the next one (one range in memory), and three cells of each later row: one row in
// 2D, four in 3D.
template <int D>
int64_t half_stencil_pairs(const CellArray<D> &grid, std::vector<hg_pair> &pairs) {
  constexpr int64_t kLaterRows[4][2] = {{1, 0}, {-1, 1}, {0, 1}, {1, 1}};  // (dy, dz)
  constexpr int kRows = D == 2 ? 1 : 4;
  const auto &cells = grid.cells();
  const auto &start = grid.start();
  const Sorted<D> *particles = grid.particles().data();
  int64_t tested = 0;
  typename CellArray<D>::Index c{};
  for (size_t number = 0; number + 1 < start.size(); number++) {
    if (number > 0) {
      for (size_t k = 0; k < D && ++c[k] == cells[k]; k++) c[k] = 0;
    }
    if (start[number] == start[number + 1]) continue;

    const Sorted<D> *first[kRows]{};
    const Sorted<D> *last[kRows]{};
    int rows = 0;
    const int64_t x_low = std::max<int64_t>(c[0] - 1, 0), x_high = std::min(c[0] + 1, cells[0] - 1);
    for (int k = 0; k < kRows; k++) {
      typename CellArray<D>::Index row = c;
      row[0] = 0;
      row[1] += kLaterRows[k][0];
      if (row[1] < 0 || row[1] >= cells[1]) continue;
      if constexpr (D == 3) {
        row[2] += kLaterRows[k][1];
        if (row[2] >= cells[2]) continue;
      }
      const size_t base = grid.cell_number(row);
      first[rows] = particles + start[base + static_cast<size_t>(x_low)];
      last[rows] = particles + start[base + static_cast<size_t>(x_high) + 1];
      if (first[rows] != last[rows]) rows++;
    }

    const Sorted<D> *own_last = particles + start[number + (c[0] + 1 < cells[0] ? 2 : 1)];
    for (size_t i = start[number]; i < start[number + 1]; i++) {
      const Sorted<D> &p = particles[i];
      test_range(p, particles + i + 1, own_last, pairs);
      tested += own_last - (particles + i + 1);
      for (int k = 0; k < rows; k++) {
        test_range(p, first[k], last[k], pairs);
        tested += last[k] - first[k];
      }
    }
  }
  return tested;
}

}  // namespace bench
