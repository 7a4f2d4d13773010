// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/space/fixed_point.hpp"

#include <algorithm>
#include <cmath>

namespace hg {

FixedPoint FixedPoint::over(const Bounds &bounds, const Domain &domain, double least_extent) {
  double half = 0.5 * least_extent;
  for (int axis = 0; axis < domain.dimension; axis++) {
    half = std::max(half, 0.5 * bounds.max[axis] - 0.5 * bounds.min[axis]);
  }
  FixedPoint map;
  if (half > 0) {
    int exponent = 0;
    std::frexp(half, &exponent);  // half < 2^exponent
    map.scale = std::ldexp(1.0, std::clamp(29 - exponent, -1020, 1000));
  }
  for (int axis = 0; axis < domain.dimension; axis++) {
    map.half_origin[axis] = 0.5 * bounds.min[axis];
    map.extent[axis] = (0.5 * bounds.max[axis] - map.half_origin[axis]) * (2 * map.scale);
    if (!domain.periodic[axis]) continue;
    map.box_min[axis] = domain.box_min[axis];
    map.length[axis] = domain.length[axis];
    map.period[axis] = static_cast<int32_t>(std::nearbyint(domain.length[axis] * map.scale));
  }
  return map;
}

}  // namespace hg
