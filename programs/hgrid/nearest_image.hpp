// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Where two particles in contact meet: the nearest image of one beside the other.
#pragma once

#include "particles/particle_set.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace command {

struct Meeting {
  double distance;
  int64_t shift[3];  // whole edges of the cell, added to the second particle's place
};

// `reach`: the images looked at are no farther than that. Of two as near the one with the smaller shift, x first.
// Computed in long double and rounded once.
inline Meeting nearest_image(const particles::ParticleSet &set, size_t a, size_t b, double reach) {
  using Real = long double;
  const int dimension = set.dimension;
  Real apart[3]{}, edge[3]{};
  for (int axis = 0; axis < dimension; axis++) {
    apart[axis] = Real{set.center(b)[axis]} - set.center(a)[axis];
    if (set.periodic[axis] != 0) edge[axis] = Real{set.box_max[axis]} - set.box_min[axis];
  }
  const Real far = Real{reach} * (1 + 1e-12L);
  // The numbers of edges that bring `place` nearer than `far`: the first and the last.
  const auto first = [&](int axis, Real place) { return edge[axis] > 0 ? std::ceil((-far - place) / edge[axis]) : 0; };
  const auto last = [&](int axis, Real place) { return edge[axis] > 0 ? std::floor((far - place) / edge[axis]) : 0; };
  Real least = INFINITY;
  Meeting result{};
  const auto precedes = [&](const int64_t(&shift)[3]) {
    for (int axis = 0; axis < 3; axis++)
      if (shift[axis] != result.shift[axis]) return shift[axis] < result.shift[axis];
    return false;
  };
  for (Real k = first(2, apart[2]); k <= last(2, apart[2]); k++) {
    const Real z = apart[2] + k * edge[2], y0 = apart[1] + k * set.tilt[2];
    for (Real j = first(1, y0); j <= last(1, y0); j++) {
      const Real y = y0 + j * edge[1], x0 = apart[0] + k * set.tilt[1] + j * set.tilt[0];
      for (Real i = first(0, x0); i <= last(0, x0); i++) {
        const Real x = x0 + i * edge[0], square = x * x + y * y + z * z;
        const int64_t shift[3] = {static_cast<int64_t>(i), static_cast<int64_t>(j), static_cast<int64_t>(k)};
        if (square > least || (square == least && !precedes(shift))) continue;
        least = square;
        result = {static_cast<double>(std::sqrt(square)), {shift[0], shift[1], shift[2]}};
      }
    }
  }
  return result;
}

}  // namespace command
