// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Points that move, as the update kernels see them, and the one answer of the kernels of all instruction sets.
#pragma once

#include "tests/support/rng.hpp"
#include "tests/unit/checks.hpp"
#include "tests/unit/kernels/any_space.hpp"
#include "tests/unit/kernels/kernel_sets.hpp"

#include <numeric>
#include <utility>
#include <vector>

namespace hgtest {

inline constexpr hg::Point kUntouched = {-77, -78, -79, -80.0f};

inline bool same_point(const hg::Point &p, const hg::Point &q) {
  return p.x == q.x && p.y == q.y && p.z == q.z && p.radius == q.radius;
}

// Points in a shuffled order of their particles, and the room that they have.
struct Points {
  explicit Points(size_t number, int dimensions)
      : dimension(static_cast<size_t>(dimensions)),
        centers(number * dimension),
        radii(number, 0),
        slot(number),
        radius(number, 0) {
    std::iota(slot.begin(), slot.end(), 0u);
    for (auto &column : x) column.resize(number);
  }
  void shuffle(Rng &rng) {
    for (size_t k = slot.size(); k > 1; k--) std::swap(slot[k - 1], slot[rng.below(k)]);
  }
  double *center(size_t p) { return centers.data() + slot[p] * dimension; }
  double &center(size_t p, size_t axis) { return center(p)[axis]; }
  double &radius_now(size_t p) { return radii[slot[p]]; }

  hg::UpdateInput input(bool with_radii, const hg::Interval *extent) const {
    return {centers.data(),
            with_radii ? radii.data() : nullptr,
            extent,
            slot.data(),
            {x[0].data(), x[1].data(), x[2].data()},
            {place[0].empty() ? nullptr : place[0].data(), place[1].empty() ? nullptr : place[1].data(),
             place[2].empty() ? nullptr : place[2].data()},
            radius.data(),
            map,
            extra,
            extra_wide,
            room};
  }

  size_t dimension;
  std::vector<double> centers, radii;
  std::vector<uint32_t> slot;
  std::vector<int32_t> x[3];     // at the start
  std::vector<double> place[3];  // likewise, where coordinates wrap
  std::vector<float> radius;     // likewise
  hg::FixedPoint map;
  double extra = 0, extra_wide = 0;
  float room = 0;
};

// The verdict, the same from all sets, and the points if it is true; points outside [begin, end) stay as they are.
inline bool update(const Points &points, bool with_radii, size_t begin, size_t end, std::vector<hg::Point> &now) {
  const std::array<hg::Interval, 3> extent = extent_of(points.centers, static_cast<int>(points.dimension));
  bool first = false;
  float first_left = 0;
  for (const hg::KernelSet *set : kernel_sets()) {
    std::vector<hg::Point> moved(points.slot.size(), kUntouched);
    const float left =
        set->update[points.dimension - 2](points.input(with_radii, extent.data()), begin, end, moved.data());
    const bool near = left >= 0;
    if (set == &hg::kScalarKernels) {
      first = near;
      first_left = left;
      now = moved;
    }
    require(near == first, "%s: %d instead of %d", set->name, near, first);
    require(left == first_left, "%s: %g quanta are left instead of %g", set->name, static_cast<double>(left),
            static_cast<double>(first_left));
    for (size_t p = 0; p < moved.size(); p++) {
      const bool inside = p >= begin && p < end;
      require(inside || same_point(moved[p], kUntouched), "%s: point %zu, outside the range, is written", set->name, p);
      require(!inside || !near || same_point(moved[p], now[p]), "%s: point %zu differs", set->name, p);
    }
  }
  return first;
}

}  // namespace hgtest
