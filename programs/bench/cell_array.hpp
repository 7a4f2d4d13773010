// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Particles sorted into a dense array of cells: what both baseline searches stand on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bench {

// The particles of one search, as the caller has them: [count][D] and [count].
struct Particles {
  size_t count = 0;
  const double *centers = nullptr;
  const double *radii = nullptr;
};

// The smallest box that holds all centres.
template <int D>
struct Bounds {
  std::array<double, D> low{}, high{};
};

template <int D>
Bounds<D> bounds_of(const Particles &particles);

// A copy of a particle, so that the candidates of a cell lie side by side in memory.
template <int D>
struct Sorted {
  double x[D];
  double r;
  int32_t id;
};

// The predicate of both baselines: strict, in plain doubles, terms added in the order x, y, z.
template <int D>
inline bool overlap(const Sorted<D> &p, const Sorted<D> &q) {
  const double dx = p.x[0] - q.x[0], dy = p.x[1] - q.x[1];
  const double s = p.r + q.r;
  if constexpr (D == 2) {
    return dx * dx + dy * dy < s * s;
  } else {
    const double dz = p.x[2] - q.x[2];
    return dx * dx + dy * dy + dz * dz < s * s;
  }
}

// Cells of one edge over a box, x running fastest; cell c holds particles[start[c]] .. particles[start[c + 1] - 1].
template <int D>
class CellArray {
 public:
  using Index = std::array<int64_t, D>;

  // Sorts the particles listed in `members` (indices into `all`). Cells are `edge` wide, or wider where a box so large
  // would need more than a few cells per particle.
  CellArray(const Particles &all, const std::vector<int32_t> &members, const Bounds<D> &bounds, double edge);

  // The cell of a coordinate, clamped to the array; monotone in x, so a range of coordinates is a range of cells.
  int64_t cell(int axis, double x) const {
    const size_t k = static_cast<size_t>(axis);
    const double c = (x - low_[k]) / edge_[k];
    if (!(c > 0)) return 0;
    return c < static_cast<double>(cells_[k] - 1) ? static_cast<int64_t>(c) : cells_[k] - 1;
  }
  size_t cell_number(const Index &c) const {
    int64_t number = c[D - 1];
    for (int k = D - 2; k >= 0; k--) {
      number = number * cells_[static_cast<size_t>(k)] + c[static_cast<size_t>(k)];
    }
    return static_cast<size_t>(number);
  }

  const Index &cells() const { return cells_; }
  const std::vector<uint32_t> &start() const { return start_; }
  const std::vector<Sorted<D>> &particles() const { return particles_; }

 private:
  Index cells_{};
  std::array<double, D> low_{}, edge_{};
  std::vector<uint32_t> start_;
  std::vector<Sorted<D>> particles_;
};

extern template class CellArray<2>;
extern template class CellArray<3>;

}  // namespace bench
