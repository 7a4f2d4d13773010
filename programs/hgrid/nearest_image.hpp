// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Where two particles in contact meet: the nearest image of one beside the other.
#pragma once

#include "particles/error.hpp"
#include "particles/particle_set.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace command {

struct Meeting {
  double distance;
  int64_t shift[3];  // whole edges of the cell, added to the second particle's place
};

// Throws particles::Error where doubles no longer count edges one by one.
inline int64_t whole(long double edges) {
  if (!(std::fabs(edges) < 0x1p53L)) throw particles::Error("a particle lies too many edges of the box away from it");
  return static_cast<int64_t>(edges);
}

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
  const auto first = [&](int axis, Real place) {
    return edge[axis] > 0 ? whole(std::ceil((-far - place) / edge[axis])) : 0;
  };
  const auto last = [&](int axis, Real place) {
    return edge[axis] > 0 ? whole(std::floor((far - place) / edge[axis])) : 0;
  };
  Real least = INFINITY;
  Meeting result{};
  const auto precedes = [&](const int64_t(&shift)[3]) {
    for (int axis = 0; axis < 3; axis++)
      if (shift[axis] != result.shift[axis]) return shift[axis] < result.shift[axis];
    return false;
  };
  for (int64_t k = first(2, apart[2]); k <= last(2, apart[2]); k++) {
    const Real z = apart[2] + Real(k) * edge[2], y0 = apart[1] + Real(k) * set.tilt[2];
    for (int64_t j = first(1, y0); j <= last(1, y0); j++) {
      const Real y = y0 + Real(j) * edge[1], x0 = apart[0] + Real(k) * set.tilt[1] + Real(j) * set.tilt[0];
      for (int64_t i = first(0, x0); i <= last(0, x0); i++) {
        const Real x = x0 + Real(i) * edge[0], square = x * x + y * y + z * z;
        const int64_t shift[3] = {i, j, k};
        if (square > least || (square == least && !precedes(shift))) continue;
        least = square;
        result = {static_cast<double>(std::sqrt(square)), {i, j, k}};
      }
    }
  }
  return result;
}

}  // namespace command
