// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/particles/input_check.hpp"

#include "src/base/error.hpp"
#include "src/base/ordered_bits.hpp"
#include "src/base/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hg {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();

void include(Interval &all, const Interval &more) {
  all.least = std::min(all.least, more.least);
  all.greatest = std::max(all.greatest, more.greatest);
}

}  // namespace

void include(InputSummary &all, const InputSummary &more) {
  for (int axis = 0; axis < 3; axis++) include(all.center[axis], more.center[axis]);
  include(all.radius, more.radius);
  all.finite = all.finite && more.finite;
}

InputSummary InputCheck::summarise(const InputArrays &input) const {
  const auto dimension = static_cast<size_t>(domain_.dimension);
  InputCheckKernel *kernel = active_kernels().check_input[dimension - 2];
  const size_t tasks = parts_of(input.count);
  InputSummary found[kMostParts];
  parallel_for(input.count < kWorthThreads ? 1 : threads_, tasks, [&](size_t task, int) {
    const size_t first = input.count * task / tasks;
    const auto from = [first](auto *array, size_t columns) {
      return array == nullptr ? nullptr : array + first * columns;
    };
    found[task] = kernel({input.count * (task + 1) / tasks - first, from(input.centers, dimension),
                          from(input.radii, 1), from(input.center_copy, dimension), from(input.radius_copy, 1)});
  });
  for (size_t task = 1; task < tasks; task++) include(found[0], found[task]);
  return found[0];
}

InputSummary InputCheck::check(const InputArrays &input) const {
  const InputSummary found = summarise(input);
  check_numbers(input, found);
  check_wraps(input, found);
  if (input.radii != nullptr) check_largest(input, found.radius.greatest);
  return found;
}

void InputCheck::check_numbers(const InputArrays &input, const InputSummary &found) const {
  // Where a host has subnormals taken for zero, a least radius of 0 may be negative.
  const bool some_negative = input.radii != nullptr && !(found.radius.least > 0) &&
                             std::any_of(input.radii, input.radii + input.count, is_negative);
  if (found.finite && !some_negative) return;
  const auto dimension = static_cast<size_t>(domain_.dimension);
  const auto is_finite = [](double x) { return std::fabs(x) <= kLargest; };
  for (size_t i = 0; i < input.count; i++) {
    for (size_t axis = 0; axis < dimension; axis++) {
      const double x = input.centers[i * dimension + axis];
      if (!is_finite(x)) fail(HG_ERR_ARGUMENT, "centers[%zu][%zu] = %g is not finite", i, axis, x);
    }
    if (input.radii == nullptr) continue;
    const double r = input.radii[i];
    if (!is_finite(r)) fail(HG_ERR_ARGUMENT, "radii[%zu] = %g is not finite", i, r);
    if (is_negative(r)) fail(HG_ERR_ARGUMENT, "radii[%zu] = %g is negative", i, r);
  }
  fail(HG_ERR_INTERNAL, "a bad value was seen but not found again");
}

// Of the extremes on each axis: false if no particle between them lies too far outside.
bool InputCheck::may_be_outside(const InputSummary &found) const {
  double boxes[3] = {0, 0, 0};
  for (int axis = domain_.dimension - 1; axis >= 0; axis--) {
    if (!domain_.periodic[axis]) continue;
    double size = 0;
    for (const double x : {found.center[axis].least, found.center[axis].greatest}) {
      size = std::max(size, std::fabs(x - domain_.box_min[axis]));
    }
    for (int higher = axis + 1; higher < domain_.dimension; higher++) {
      size += boxes[higher] * std::fabs(domain_.tilt[kTiltOf[higher][axis]]);
    }
    boxes[axis] = size / domain_.length[axis] + 1;
    if (!(boxes[axis] <= domain_.most_outside())) return true;
  }
  return false;
}

void InputCheck::check_wraps(const InputArrays &input, const InputSummary &found) const {
  if (!domain_.any_periodic || !may_be_outside(found)) return;
  const auto dimension = static_cast<size_t>(domain_.dimension);
  for (size_t i = 0; i < input.count; i++) {
    const double *center = input.centers + i * dimension;
    const Domain::Outside outside = domain_.outside(center);
    if (outside.boxes <= domain_.most_outside()) continue;
    const int axis = outside.axis;
    fail(HG_ERR_LIMIT, "centers[%zu][%d] = %g: more than 2^%d box lengths outside the periodic box [%g, %g]", i, axis,
         center[axis], std::ilogb(domain_.most_outside()), domain_.box_min[axis], domain_.box_max[axis]);
  }
}

void InputCheck::check_largest(const InputArrays &input, double radius) const {
  const auto index = static_cast<size_t>(std::find(input.radii, input.radii + input.count, radius) - input.radii);
  const double diameter = interaction_.diameter(radius);
  if (!(diameter <= kLargest)) {
    fail(HG_ERR_LIMIT, "radii[%zu] = %g: its diameter with margin overflows", index, radius);
  }
  const double bare = Interaction{interaction_.kind, 0}.diameter(radius);
  if (bare > largest_diameter_) {
    fail(HG_ERR_ARGUMENT, "radii[%zu] = %g: its diameter is %g, but the last of cell_sizes is %g", index, radius, bare,
         largest_diameter_);
  }
}

}  // namespace hg
