// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Only edge c has a z component: the interval of z that counts gives all shifts along c. For each of them the interval
// of y gives those along b, and for each of these that of x those along a. With a tilt no image is taken for the
// nearest.
#include "oracle/images.hpp"

#include "oracle/cell.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace oracle {
namespace {

constexpr int kMostLookedAt = 1 << 22;

class Enumeration {
 public:
  Enumeration(const hg_grid_def &def, const double *a, const double *b, double distance)
      : def_(def),
        cell_(def),
        a_(a),
        b_(b),
        distance_(distance),
        nearest_by_axis_(def.images == HG_NEAREST_IMAGE && !is_tilted(def)) {}

  std::vector<Shift> run() {
    visit(def_.dimension - 1);
    return std::move(found_);
  }

 private:
  // All shifts along this axis and those before it, for what is chosen of those behind.
  void visit(int axis) {
    if (axis < 0) {
      found_.push_back(shift_);
      return;
    }
    double d = b_[axis] - a_[axis];
    double size = std::fabs(d) + distance_;
    for (int edge = axis + 1; edge < def_.dimension; edge++) {
      const double term = static_cast<double>(shift_.n[edge]) * cell_.edge[axis][edge];
      d += term;
      size += std::fabs(term);
    }
    // Each rounding, here and in a rule's own expression, costs at most 2^-53 of `size`; there are fewer than twenty.
    const double reach = distance_ + 0x1p-47 * size;
    if (def_.periodic[axis] == 0) {
      if (std::fabs(d) <= reach) visit(axis - 1);
      return;
    }
    const double length = cell_.edge[axis][axis];
    double first = std::ceil((-reach - d) / length - 0x1p-40), last = std::floor((reach - d) / length + 0x1p-40);
    if (nearest_by_axis_) {
      const double nearest = std::nearbyint(-d / length);
      first = std::fmax(first, nearest - 1);
      last = std::fmin(last, nearest + 1);
    }
    if (!(std::fabs(first) < 0x1p60 && last - first < kMostLookedAt)) throw std::length_error("too many images");
    for (double n = first; n <= last; n++) {
      if (++looked_at_ > kMostLookedAt) throw std::length_error("too many images");
      shift_.n[axis] = static_cast<int64_t>(n);
      visit(axis - 1);
    }
    shift_.n[axis] = 0;
  }

  const hg_grid_def &def_;
  const Cell<double> cell_;
  const double *a_, *b_;
  const double distance_;
  const bool nearest_by_axis_;
  Shift shift_{};
  int looked_at_ = 0;
  std::vector<Shift> found_;
};

}  // namespace

bool is_tilted(const hg_grid_def &def) { return def.tilt[0] != 0 || def.tilt[1] != 0 || def.tilt[2] != 0; }

Shift middle_image(const hg_grid_def &def, const double *a, const double *b) {
  const Cell<double> cell(def);
  Shift shift{};
  for (int axis = def.dimension - 1; axis >= 0; axis--) {
    if (def.periodic[axis] == 0) continue;
    double d = b[axis] - a[axis];
    for (int edge = axis + 1; edge < def.dimension; edge++) {
      d += static_cast<double>(shift.n[edge]) * cell.edge[axis][edge];
    }
    const double n = std::nearbyint(-d / cell.edge[axis][axis]);
    if (!(std::fabs(n) < 0x1p60)) throw std::length_error("too many images");
    shift.n[axis] = static_cast<int64_t>(n);
  }
  return shift;
}

std::vector<Shift> images_near(const hg_grid_def &def, const double *a, const double *b, double distance) {
  std::vector<Shift> shifts = Enumeration(def, a, b, distance).run();
  std::sort(shifts.begin(), shifts.end(),
            [](const Shift &s, const Shift &t) { return std::lexicographical_compare(s.n, s.n + 3, t.n, t.n + 3); });
  return shifts;
}

}  // namespace oracle
