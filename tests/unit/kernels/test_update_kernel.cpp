// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The update kernels of every instruction set that this machine runs: where points are now, in rational numbers, and
// whether one of them has used up its room, to the last quantum. Where coordinates wrap: test_far_update_kernel.cpp.
#include "tests/unit/exact_place.hpp"
#include "tests/unit/kernels/any_space.hpp"
#include "tests/unit/kernels/moving_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace {

using namespace hgtest;

// ---- any spaces: places and verdicts in real arithmetic

class AnyMotion {
 public:
  AnyMotion(uint64_t seed, size_t count)
      : rng_(seed), space_(rng_), points_(count, space_.domain.dimension), with_radii_(rng_.chance(0.5)) {
    points_.map = space_.map;
    points_.shuffle(rng_);
    const double quantum = 1 / space_.map.scale;
    points_.extra = rng_.chance(0.5) ? 0 : quantum * std::pow(2, rng_.uniform(0, 28));
    points_.extra_wide = points_.extra + quantum * std::pow(2, rng_.uniform(0, 28));
    for (size_t p = 0; p < count; p++) {
      int32_t x[3] = {0, 0, 0};
      space_.any_center(rng_, points_.center(p));
      space_.map.find_coordinates(points_.center(p), space_.domain.dimension, x);
      for (size_t axis = 0; axis < points_.dimension; axis++) points_.x[axis][p] = x[axis];
      points_.radius_now(p) = quantum * std::pow(2, rng_.uniform(0, 28));
      points_.radius[p] = static_cast<float>((points_.radius_now(p) + points_.extra_wide) * space_.map.scale);
    }
    move();
  }

  void check() {
    const size_t count = points_.slot.size(), begin = rng_.below(count + 1),
                 end = begin + rng_.below(count - begin + 1);
    std::vector<hg::Point> now;
    points_.room = std::numeric_limits<float>::infinity();
    require(update(points_, with_radii_, begin, end, now), "no room is enough");
    Used most{0, 0};
    for (size_t p = begin; p < end; p++) {
      check_place(p, now[p]);
      const Used used = used_by(p, now[p]);
      most = {std::max(most.at_least, used.at_least), std::max(most.at_most, used.at_most)};
    }
    points_.room = static_cast<float>(most.at_most * 1.00001L);
    require(update(points_, with_radii_, begin, end, now), "room for all motion is refused");
    points_.room = static_cast<float>(most.at_least * 0.99999L);
    require(most.at_least < 1 || !update(points_, with_radii_, begin, end, now), "more motion than room is allowed");
  }

 private:
  // By anything from a fraction of a quantum to across the space; out of it, too.
  void move() {
    const double step = std::pow(2, rng_.uniform(-3, 30)) / space_.map.scale;
    for (size_t p = 0; p < points_.slot.size(); p++) {
      double *center = points_.center(p);
      const bool anywhere = rng_.chance(0.3);
      if (anywhere) space_.any_center(rng_, center);
      for (size_t axis = 0; axis < points_.dimension; axis++) {
        const bool periodic = space_.domain.periodic[axis];
        if (!periodic && rng_.chance(0.02)) {
          center[axis] = rng_.chance(0.5) ? -1.7e308 : 1.7e308;
        } else if (!anywhere) {
          center[axis] += step * rng_.uniform(-1, 1);
        }
      }
      if (!space_.is_allowed(center)) space_.any_center(rng_, center);
      if (with_radii_) points_.radius_now(p) *= rng_.uniform(0, 3);
    }
  }

  static int32_t coordinate(const hg::Point &point, int axis) {
    return axis == 0 ? point.x : axis == 1 ? point.y : point.z;
  }

  void check_place(size_t p, const hg::Point &now) {
    const double *center = points_.center(p);
    // Periods are rounded, which adds half a quantum in other images than the box's own.
    const int32_t here[3] = {now.x, now.y, now.z};
    const auto errors = place_errors(space_.map, space_.domain, center, here, mpq_class(7, 8));
    for (int axis = 0; axis < space_.domain.dimension; axis++) {
      const mpq_class &error = errors[axis];
      const int32_t c = here[axis], start = points_.x[axis][p];
      if (space_.domain.periodic[axis]) {
        // The nearest image to the start.
        const int32_t half = space_.map.period[axis] / 2 + 1;
        require(is_floor(error, mpq_class(7, 8)), "axis %d: %a is %g quanta from %d", axis, center[axis], error.get_d(),
                c);
        require(std::abs(c - start) <= half, "axis %d: %d is not the nearest image to %d", axis, c, start);
        continue;
      }
      // Cut off at both ends of what 32 bits can tell from the space.
      const mpq_class exact = error + c;
      constexpr int32_t kLow = -(1 << 29), kHigh = INT32_MAX - (1 << 29);
      const mpq_class kept = exact < kLow ? mpq_class(kLow) : (exact > kHigh ? mpq_class(kHigh) : exact);
      require(is_floor(kept - c, place_slack(space_.domain, axis)), "axis %d: %a is %g quanta from %d", axis,
              center[axis], error.get_d(), c);
    }
    require(space_.domain.dimension == 3 || now.z == 0, "z = %d in 2D", now.z);
    if (!with_radii_) {
      require(now.radius == kUntouched.radius, "a radius that was not given is written");
      return;
    }
    const mpq_class folded =
        (mpq_class(points_.radius_now(p)) + mpq_class(points_.extra)) * mpq_class(space_.map.scale);
    require(abs(mpq_class(static_cast<double>(now.radius)) - folded) <= folded * mpq_class(1, 1 << 23),
            "radius %g instead of %g", static_cast<double>(now.radius), folded.get_d());
  }

  // How much room a point uses up by motion and growth; radii as floats may take a little more.
  struct Used {
    long double at_least, at_most;
  };
  Used used_by(size_t p, const hg::Point &now) {
    long double square = 0;
    for (int axis = 0; axis < space_.domain.dimension; axis++) {
      const long double d = static_cast<long double>(coordinate(now, axis)) - points_.x[axis][p];
      square += d * d;
    }
    const long double moved = std::sqrt(square);
    if (!with_radii_) return {moved, moved};
    const long double wide = (static_cast<long double>(points_.radius_now(p)) + points_.extra_wide) *
                             static_cast<long double>(space_.map.scale);
    const long double used = moved + std::max(0.0L, wide - static_cast<long double>(points_.radius[p]));
    return {used, used + wide * 0x1p-20L};
  }

  Rng rng_;
  Space space_;
  Points points_;
  bool with_radii_;
};

// ---- whole quanta: one particle, anywhere, uses up its room to the last quantum or exceeds it by one

class WholeSteps {
 public:
  explicit WholeSteps(uint64_t seed) : rng_(seed), points_(1 + rng_.below(150), rng_.integer(2, 3)) {
    points_.shuffle(rng_);
    for (size_t axis = 0; axis < points_.dimension; axis++) {
      if (!rng_.chance(0.5)) continue;
      points_.map.length[axis] = kPeriod;
      points_.map.period[axis] = kPeriod;
    }
    for (const auto &[higher, lower] : kTiltedAxes) {
      if (points_.map.period[higher] == 0 || points_.map.period[lower] == 0 || rng_.chance(0.5)) continue;
      points_.map.tilt[hg::kTiltOf[higher][lower]] = rng_.integer(-3 * kPeriod, 3 * kPeriod);
      points_.map.tilted = true;
    }
    for (size_t p = 0; p < points_.slot.size(); p++) {
      for (size_t axis = 0; axis < points_.dimension; axis++) {
        // At a face now and then, which a step then crosses.
        points_.x[axis][p] = rng_.chance(0.3) ? (rng_.chance(0.5) ? 0 : kPeriod - 1) : rng_.integer(0, kPeriod - 1);
        points_.center(p, axis) = points_.x[axis][p];
      }
      points_.radius_now(p) = rng_.integer(1, 1 << 12);
      points_.radius[p] = static_cast<float>(points_.radius_now(p));
    }
  }

  void check() {
    const size_t count = points_.slot.size(), who = rng_.below(count);
    const size_t begin = rng_.below(who + 1), end = who + 1 + rng_.below(count - who);
    // A Pythagorean triple in some plane, so that the length of the step is whole.
    const int scale = rng_.integer(1, 1000);
    int step[3] = {0, 0, 0};
    const size_t first = rng_.below(points_.dimension), second = (first + 1) % points_.dimension;
    step[first] = (rng_.chance(0.5) ? 3 : -3) * scale;
    step[second] = (rng_.chance(0.5) ? 4 : -4) * scale;
    move(who, step);
    check_room(begin, end, who, step, 5 * scale);

    // Growth takes from the room, and the floats' errors up to a quantum more; shrinking gives nothing back.
    const int growth = rng_.integer(1, 5 * scale);
    points_.radius_now(who) += growth;
    require(is_near(begin, end, true, 5 * scale + growth + 1), "the room holds a step and a growth");
    require(!is_near(begin, end, true, 5 * scale + growth - 1), "growth took no room");
    points_.radius_now(who) = 0;
    require(is_near(begin, end, true, 5 * scale + 1), "shrinking took room");
    require(!is_near(begin, end, true, 5 * scale - 1), "shrinking gave room");
    // More growth than room, without motion: the square of what is left is of no use.
    constexpr int kNowhere[3] = {0, 0, 0};
    move(who, kNowhere);
    points_.radius_now(who) = static_cast<double>(points_.radius[who]) + 10 * scale;
    require(!is_near(begin, end, true, 5 * scale), "growth of twice the room is allowed");
    // What is outside the range is not looked at.
    require(is_near(begin, who, true, 5 * scale) && is_near(who + 1, end, true, 5 * scale), "others have moved");
  }

 private:
  static constexpr int kPeriod = 1 << 20;

  // By `step` quanta from the start, in any box.
  void move(size_t p, const int *step) {
    const int farthest = rng_.chance(0.5) ? 1 : 100000;
    for (size_t axis = 0; axis < points_.dimension; axis++) points_.center(p, axis) = points_.x[axis][p] + step[axis];
    for (size_t axis = 0; axis < points_.dimension; axis++) {
      const double boxes = points_.map.period[axis] > 0 ? rng_.integer(-farthest, farthest) : 0;
      points_.center(p, axis) += boxes * kPeriod;
      for (size_t lower = 0; lower < axis; lower++) {
        points_.center(p, lower) += boxes * points_.map.tilt[hg::kTiltOf[axis][lower]];
      }
    }
  }

  bool is_near(size_t begin, size_t end, bool with_radii, int room) {
    points_.room = static_cast<float>(room);
    return update(points_, with_radii, begin, end, now_);
  }

  void check_room(size_t begin, size_t end, size_t who, const int *step, int length) {
    require(!is_near(begin, end, false, length - 1), "a quantum beyond the room is allowed");
    require(is_near(begin, end, false, length), "the room to the last quantum is refused");
    for (size_t p = begin; p < end; p++) {
      const int moved[3] = {p == who ? step[0] : 0, p == who ? step[1] : 0, p == who ? step[2] : 0};
      const hg::Point expected = {points_.x[0][p] + moved[0], points_.x[1][p] + moved[1],
                                  points_.dimension == 3 ? points_.x[2][p] + moved[2] : 0, kUntouched.radius};
      require(same_point(now_[p], expected), "point %zu is at (%d, %d, %d)", p, now_[p].x, now_[p].y, now_[p].z);
    }
  }

  Rng rng_;
  Points points_;
  std::vector<hg::Point> now_;
};

void any_motion(void **) {
  assert_true(sweep(500, [](uint64_t seed) { AnyMotion(seed, Rng(seed).below(150)).check(); }));
}
void whole_steps(void **) {
  assert_true(sweep(2000, [](uint64_t seed) { WholeSteps(seed).check(); }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(any_motion), cmocka_unit_test(whole_steps)};
  return cmocka_run_group_tests_name("update_kernel", tests, nullptr, nullptr);
}
