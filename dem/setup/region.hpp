// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Parts of space, at rest: where particles come in, where they go out, and where they are counted.
#pragma once

#include "dem/effects/effects.hpp"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace dem {

// The box low <= x < high or, with a normal, what lies behind a plane. Vectors have as many components that count as
// the setup has dimensions.
struct Region {
  std::string name;
  double low[3]{}, high[3]{};
  bool is_box = true;
  double point[3]{}, normal[3]{};  // of the plane

  bool holds(const double *center, int dimension) const {
    double height = 0;
    for (int axis = 0; axis < dimension; axis++) {
      if (is_box && !(center[axis] >= low[axis] && center[axis] < high[axis])) return false;
      height += normal[axis] * (center[axis] - point[axis]);
    }
    return is_box || height < 0;
  }
};

// Where particles appear, each wholly in the box, with this velocity and without spin.
struct Inflow {
  Region box;
  double rate = 0;  // particles per time
  uint64_t most = std::numeric_limits<uint64_t>::max();
  double until = kInfinity;  // in the time of the run
  double velocity[3]{};
  std::vector<double> radii, masses;  // one after the other, and from the start again
  int material = -1;                  // -1: none (materials)
  uint64_t seed = 1;                  // of the places
};

}  // namespace dem
