// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Fixed-point coordinates: integers of 2^-30 of the system's extent. Their differences are exact, they need half the
// memory of doubles, and what they cannot decide (docs/exactness.md) is decided on the doubles.
#pragma once

#include "src/exact/domain.hpp"
#include "src/space/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace hg {

inline constexpr double kFrameQuanta = 1073741824.0;  // 2^30, so that differences and periodic shifts fit in 32 bits

struct Frame {
  double scale = 1;                   // quanta per length: a power of two, so scaling rounds nothing
  double half_origin[3] = {0, 0, 0};  // half the position of coordinate 0; halves, so that differences are finite
  double extent[3] = {0, 0, 0};       // in quanta
  int32_t period[3] = {0, 0, 0};      // in quanta, rounded; 0 on open axes

  // `least_extent`: a length that must be well resolved even if the centres coincide; finite.
  static Frame over(const Bounds &bounds, const Domain &domain, double least_extent) {
    double half = 0.5 * least_extent;
    for (int k = 0; k < domain.dimension; k++) half = std::max(half, 0.5 * bounds.max[k] - 0.5 * bounds.min[k]);
    Frame frame;
    if (half > 0) {
      int exponent = 0;
      std::frexp(half, &exponent);  // half < 2^exponent
      frame.scale = std::ldexp(1.0, std::clamp(29 - exponent, -1020, 1000));
    }
    for (int k = 0; k < domain.dimension; k++) {
      frame.half_origin[k] = 0.5 * bounds.min[k];
      frame.extent[k] = (0.5 * bounds.max[k] - frame.half_origin[k]) * (2 * frame.scale);
      if (domain.periodic[k]) frame.period[k] = static_cast<int32_t>(std::nearbyint(domain.length[k] * frame.scale));
    }
    return frame;
  }

  double quanta(int axis, double position) const { return (0.5 * position - half_origin[axis]) * (2 * scale); }

  // The fixed-point coordinate of a position (Domain::position) within the bounds: at most one quantum away.
  int32_t coordinate(int axis, double position) const {
    return static_cast<int32_t>(std::min(std::max(quanta(axis, position), 0.0), kFrameQuanta - 1));
  }
};

}  // namespace hg
