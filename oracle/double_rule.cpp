// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The expression in doubles that HG_DOUBLE promises, written out once more.
// It must be compiled without contraction, as all of the project is (-ffp-contract=off).
#include "oracle/cell.hpp"
#include "oracle/images.hpp"

#include <algorithm>
#include <cmath>

namespace oracle {
namespace {

double reach_of(const hg_grid_def &def, const Sphere &a, const Sphere &b) {
  const double base = def.interaction == HG_MAX_RANGE ? std::fmax(a.radius, b.radius) : a.radius + b.radius;
  return base + def.margin;
}

bool in_reach(const hg_grid_def &def, const double *d, double s) {
  const double distance2 = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
  return def.touching != 0 ? distance2 <= s * s : distance2 < s * s;
}

// The nearest image by each axis on its own, as axes at right angles allow.
bool nearest_in_reach(const hg_grid_def &def, const Sphere &a, const Sphere &b, double s) {
  double d[3] = {0, 0, 0};
  for (int axis = 0; axis < def.dimension; axis++) {
    d[axis] = a.center[axis] - b.center[axis];
    if (def.periodic[axis] != 0) {
      const double length = def.box_max[axis] - def.box_min[axis];
      d[axis] -= std::nearbyint(d[axis] / length) * length;
    }
  }
  return in_reach(def, d, s);
}

bool image_in_reach(const hg_grid_def &def, const Cell<double> &cell, const Sphere &a, const Sphere &b,
                    const Shift &shift, double s) {
  double d[3] = {0, 0, 0};
  for (int axis = 0; axis < def.dimension; axis++) {
    double moved = static_cast<double>(shift.n[axis]) * cell.edge[axis][axis];
    for (int edge = axis + 1; edge < def.dimension; edge++) {
      moved += static_cast<double>(shift.n[edge]) * cell.edge[axis][edge];
    }
    d[axis] = b.center[axis] - a.center[axis] + moved;
  }
  return in_reach(def, d, s);
}

}  // namespace

int double_interact(const hg_grid_def &def, const Sphere &a, const Sphere &b) {
  const double s = reach_of(def, a, b);
  const bool nearest = def.images == HG_NEAREST_IMAGE;
  if (nearest && !is_tilted(def)) return nearest_in_reach(def, a, b, s) ? 1 : 0;
  const Cell<double> cell(def);
  const auto in_reach = [&](const Shift &shift) { return image_in_reach(def, cell, a, b, shift, s); };
  if (nearest && in_reach(middle_image(def, a.center, b.center))) return 1;
  const std::vector<Shift> shifts = images_near(def, a.center, b.center, s);
  const auto count = static_cast<int>(std::count_if(shifts.begin(), shifts.end(), in_reach));
  return nearest ? std::min(count, 1) : count;
}

}  // namespace oracle
