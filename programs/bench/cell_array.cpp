// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Counting sort of particles into dense cells.
#include "programs/bench/cell_array.hpp"

#include <algorithm>
#include <cmath>

namespace bench {
namespace {

// Cells of neighbouring particles must not differ by more than the exact cells do. A cell coordinate c carries a
// relative error below 3 * 2^-53, two of them 6 * 2^-53 * c; with c < 2^20 an edge wider by 1e-9 makes up for it.
constexpr double kEdgeMargin = 1 + 1e-9;
constexpr double kMostCellsPerAxis = 1 << 20;
constexpr double kMostCellsPerParticle = 16;

}  // namespace

template <int D>
Bounds<D> bounds_of(const Particles &particles) {
  Bounds<D> bounds;
  for (size_t k = 0; k < D && particles.count > 0; k++) bounds.low[k] = bounds.high[k] = particles.centers[k];
  for (size_t i = 0; i < particles.count; i++) {
    for (size_t k = 0; k < D; k++) {
      bounds.low[k] = std::min(bounds.low[k], particles.centers[i * D + k]);
      bounds.high[k] = std::max(bounds.high[k], particles.centers[i * D + k]);
    }
  }
  return bounds;
}

template <int D>
CellArray<D>::CellArray(const Particles &all, const std::vector<int32_t> &members, const Bounds<D> &bounds, double edge)
    : low_(bounds.low) {
  const double most_cells = kMostCellsPerParticle * static_cast<double>(all.count) + 1024;
  edge_.fill(edge * kEdgeMargin);
  double total = 0;
  for (;;) {
    total = 1;
    for (size_t k = 0; k < D; k++) {
      const double extent = bounds.high[k] - bounds.low[k];
      if (!(extent < edge_[k] * kMostCellsPerAxis)) edge_[k] = 2 * extent / kMostCellsPerAxis;
      cells_[k] = extent > 0 ? static_cast<int64_t>(extent / edge_[k]) + 1 : 1;
      total *= static_cast<double>(cells_[k]);
    }
    if (total <= most_cells) break;
    for (double &wide : edge_) wide *= 1.25;
  }

  start_.assign(static_cast<size_t>(total) + 1, 0);
  std::vector<uint32_t> cell_of(members.size());
  for (size_t m = 0; m < members.size(); m++) {
    Index c;
    for (int k = 0; k < D; k++) {
      c[static_cast<size_t>(k)] = cell(k, all.centers[static_cast<size_t>(members[m]) * D + static_cast<size_t>(k)]);
    }
    cell_of[m] = static_cast<uint32_t>(cell_number(c));
    ++start_[cell_of[m] + 1];
  }
  for (size_t c = 1; c < start_.size(); c++) start_[c] += start_[c - 1];

  particles_.resize(members.size());
  std::vector<uint32_t> next(start_.begin(), start_.end() - 1);
  for (size_t m = 0; m < members.size(); m++) {
    const size_t i = static_cast<size_t>(members[m]);
    Sorted<D> &place = particles_[next[cell_of[m]]++];
    std::copy_n(all.centers + i * D, D, place.x);
    place.r = all.radii[i];
    place.id = members[m];
  }
}

template Bounds<2> bounds_of<2>(const Particles &);
template Bounds<3> bounds_of<3>(const Particles &);
template class CellArray<2>;
template class CellArray<3>;

}  // namespace bench
