// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The expression in doubles that HG_DOUBLE promises, written out once more.
// It must be compiled without contraction, as all of the project is (-ffp-contract=off).
#include "oracle/rule.hpp"

#include <cmath>

namespace oracle {

bool double_interact(const hg_grid_def &def, const Sphere &a, const Sphere &b) {
  double d[3] = {0, 0, 0};
  for (int axis = 0; axis < def.dimension; axis++) {
    d[axis] = a.center[axis] - b.center[axis];
    if (def.periodic[axis] != 0) {
      const double length = def.box_max[axis] - def.box_min[axis];
      d[axis] -= std::nearbyint(d[axis] / length) * length;
    }
  }
  const double base = def.interaction == HG_MAX_RANGE ? std::fmax(a.radius, b.radius) : a.radius + b.radius;
  const double s = base + def.margin;
  return d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < s * s;
}

}  // namespace oracle
