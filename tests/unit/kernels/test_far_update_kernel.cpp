// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The update kernels where coordinates wrap and so do not tell how far a particle has moved: in rational numbers, for
// motion from less than a quantum to across the space and out of it.
#include "tests/unit/exact_place.hpp"
#include "tests/unit/kernels/any_space.hpp"
#include "tests/unit/kernels/moving_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace {

using namespace hgtest;

class FarMotion {
 public:
  FarMotion(uint64_t seed, size_t count)
      : rng_(seed), space_(rng_), points_(count, space_.domain.dimension), starts_(count * points_.dimension) {
    double extent = 0;
    for (const double length : space_.domain.length) extent = std::max(extent, length);
    points_.map = space_.wrapping(extent * std::pow(2, -rng_.uniform(0, 24)));
    points_.shuffle(rng_);
    for (size_t axis = 0; axis < points_.dimension; axis++) {
      points_.place[axis].resize(count);
      for (size_t p = 0; p < count; p++) {
        const auto a = static_cast<int>(axis);
        starts_[p * points_.dimension + axis] = points_.center(p, axis) = space_.any_center(rng_, a);
        points_.place[axis][p] = quanta_of(points_.map, a, points_.center(p, axis));
        points_.x[axis][p] = hg::low_word(place_of(points_.map, a, points_.center(p, axis)));
      }
    }
  }

  void check() {
    const size_t count = points_.slot.size(), begin = rng_.below(count + 1),
                 end = begin + rng_.below(count - begin + 1);
    for (size_t p = 0; p < count; p++) move(p, std::pow(2, rng_.uniform(-3, 46)));
    std::vector<hg::Point> now;
    points_.room = std::numeric_limits<float>::infinity();
    require(update(points_, false, begin, end, now), "no room is enough");
    double farthest = 0;
    for (size_t p = begin; p < end; p++) farthest = std::max(farthest, check_point(p, now[p]));
    farthest = std::min(farthest, kFarthest);
    points_.room = static_cast<float>(farthest * 1.00001 + 2);
    require(farthest == kFarthest || update(points_, false, begin, end, now), "room for all motion is refused");
    if (begin == end) return;
    points_.room = static_cast<float>(farthest * 0.99999 - 2);
    require(points_.room <= 0 || !update(points_, false, begin, end, now), "more motion than room is allowed");
    check_jump(begin + rng_.below(end - begin), begin, end);
  }

 private:
  static constexpr double kFarthest = 0x1p46;  // quanta that motion may be cut off at

  double &start(size_t p, size_t axis) { return starts_[p * points_.dimension + axis]; }

  // By so many quanta along each axis, and by any number of boxes; out of the space now and then.
  void move(size_t p, double quanta) {
    for (size_t axis = 0; axis < points_.dimension; axis++) {
      const auto a = static_cast<int>(axis);
      double &x = points_.center(p, axis);
      x = start(p, axis) + quanta / points_.map.scale * rng_.uniform(-1, 1);
      if (space_.domain.periodic[axis]) {
        if (rng_.chance(0.3)) x += rng_.integer(-1000, 1000) * space_.domain.length[axis];
        if (std::fabs(space_.domain.wraps(a, x)) >= hg::kMaxWraps) x = start(p, axis);
      } else if (rng_.chance(0.01)) {
        x = rng_.chance(0.5) ? -1.7e308 : 1.7e308;
      }
    }
  }

  // From the start to the nearest image of the centre, in quanta.
  mpq_class moved(size_t p, size_t axis) {
    const mpq_class way =
        (mpq_class(points_.center(p, axis)) - mpq_class(start(p, axis))) * mpq_class(points_.map.scale);
    if (!space_.domain.periodic[axis]) return way;
    const mpq_class period = (mpq_class(space_.domain.box_max[axis]) - mpq_class(space_.domain.box_min[axis])) *
                             mpq_class(points_.map.scale);
    return way - floor_of(way / period + mpq_class(1, 2)) * period;
  }

  // The coordinate has moved as the centre has, modulo 2^32; returns how far that is.
  double check_point(size_t p, const hg::Point &now) {
    const int32_t here[3] = {now.x, now.y, now.z};
    double square = 0;
    for (size_t axis = 0; axis < points_.dimension; axis++) {
      const bool periodic = space_.domain.periodic[axis];
      const mpq_class way = moved(p, axis);
      square += way.get_d() * way.get_d();
      if (abs(way) > mpq_class(kFarthest)) continue;
      mpq_class error = way - hg::near_difference(here[axis], points_.x[axis][p]);
      error -= floor_of(error / mpq_class(0x1p32) + mpq_class(1, 2)) * mpq_class(0x1p32);
      if (periodic && abs(error) > 4) {  // half a box away both images are right
        const auto other = way > 0 ? points_.map.period[axis] : -points_.map.period[axis];
        error += other;
        error -= floor_of(error / mpq_class(0x1p32) + mpq_class(1, 2)) * mpq_class(0x1p32);
        require(abs(2 * abs(way) - mpq_class(points_.map.period_place(static_cast<int>(axis)))) < 4,
                "axis %zu: not the nearest image", axis);
      }
      // Two places, rounded to whole ones, and a period.
      require(abs(error) < mpq_class(periodic ? 2.3 : 1.2), "axis %zu: %g quanta from where it is", axis,
              error.get_d());
    }
    require(points_.dimension == 3 || now.z == 0, "z = %d in 2D", now.z);
    return std::sqrt(square);
  }

  // By as much as coordinates cannot tell from nothing: once or a few times 2^32 quanta. A whole period is no motion.
  void check_jump(size_t who, size_t begin, size_t end) {
    for (size_t p = 0; p < points_.slot.size(); p++) {
      for (size_t axis = 0; axis < points_.dimension; axis++) points_.center(p, axis) = start(p, axis);
    }
    std::vector<hg::Point> now;
    points_.room = 0x1p20f;
    for (size_t axis = 0; axis < points_.dimension; axis++) {
      double &x = points_.center(who, axis);
      const double length = space_.domain.length[axis], jump = rng_.integer(1, 3) * 0x1p32 / points_.map.scale;
      x += rng_.chance(0.5) ? jump : -jump;
      const bool told = abs(moved(who, axis)) > mpq_class(0x1p21);
      require(!told || !update(points_, false, begin, end, now), "axis %zu: a jump by 2^32 quanta goes unnoticed",
              axis);
      x = start(who, axis);
      if (!space_.domain.periodic[axis]) continue;
      x += std::fabs(space_.domain.wraps(static_cast<int>(axis), x)) > 1000 ? 0 : rng_.integer(-9, 9) * length;
      require(update(points_, false, begin, end, now), "axis %zu: a whole period is taken for motion", axis);
      x = start(who, axis);
    }
  }

  Rng rng_;
  Space space_;
  Points points_;
  std::vector<double> starts_;
};

void any_motion(void **) {
  assert_true(sweep(500, [](uint64_t seed) { FarMotion(seed, Rng(seed).below(150)).check(); }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(any_motion)};
  return cmocka_run_group_tests_name("far_update_kernel", tests, nullptr, nullptr);
}
