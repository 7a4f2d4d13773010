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
    for (size_t axis = 0; axis < points_.dimension; axis++) points_.place[axis].resize(count);
    for (size_t p = 0; p < count; p++) {
      double quanta[3], place[3];
      space_.any_center(rng_, points_.center(p));
      points_.map.find_quanta(points_.center(p), space_.domain.dimension, quanta);
      points_.map.find_place(points_.center(p), space_.domain.dimension, place);
      for (size_t axis = 0; axis < points_.dimension; axis++) {
        start(p, axis) = points_.center(p, axis);
        points_.place[axis][p] = quanta[axis];
        points_.x[axis][p] = hg::low_word(place[axis]);
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
    double *center = points_.center(p);
    for (size_t axis = 0; axis < points_.dimension; axis++) {
      double &x = center[axis];
      x = start(p, axis) + quanta / points_.map.scale * rng_.uniform(-1, 1);
      if (space_.domain.periodic[axis]) {
        if (rng_.chance(0.3)) x += rng_.integer(-1000, 1000) * space_.domain.length[axis];
      } else if (rng_.chance(0.01)) {
        x = rng_.chance(0.5) ? -1.7e308 : 1.7e308;
      }
    }
    if (!space_.is_allowed(center)) std::copy_n(&start(p, 0), points_.dimension, center);
  }

  // From the start to the nearest image of the centre, in quanta: whole edges are taken off, the last first, each the
  // nearest number. Between two that are about as near, that of the kernel is right, if `moved_to` says where it went.
  std::array<mpq_class, 3> moved(size_t p, const hg::Point *moved_to) {
    const hg::Domain &domain = space_.domain;
    const mpq_class scale(points_.map.scale);
    std::array<mpq_class, 3> way;
    for (size_t axis = 0; axis < points_.dimension; axis++) {
      way[axis] = (mpq_class(points_.center(p, axis)) - mpq_class(start(p, axis))) * scale;
    }
    for (int edge = domain.dimension - 1; edge >= 0; edge--) {
      if (!domain.periodic[edge]) continue;
      const mpq_class period = exact_edge(domain, edge, edge) * scale;
      const auto a = static_cast<size_t>(edge);
      mpz_class edges = floor_of(way[a] / period + mpq_class(1, 2));
      const mpq_class left = way[a] - edges * period;
      if (moved_to != nullptr && period - 2 * abs(left) < 8 && abs(error_of(left, p, a, *moved_to)) > 4) {
        edges += left > 0 ? 1 : -1;
      }
      for (int axis = 0; axis <= edge; axis++)
        way[static_cast<size_t>(axis)] -= edges * exact_edge(domain, edge, axis) * scale;
    }
    return way;
  }

  // How far the coordinate is from having moved so far, modulo 2^32.
  mpq_class error_of(const mpq_class &way, size_t p, size_t axis, const hg::Point &now) const {
    const int32_t here[3] = {now.x, now.y, now.z};
    const mpq_class error = way - hg::near_difference(here[axis], points_.x[axis][p]);
    return error - floor_of(error / mpq_class(0x1p32) + mpq_class(1, 2)) * mpq_class(0x1p32);
  }

  // The coordinates have moved as the centre has; returns how far that is.
  double check_point(size_t p, const hg::Point &now) {
    const auto way = moved(p, &now);
    for (size_t axis = 0; axis < points_.dimension; axis++) {
      if (abs(way[axis]) > mpq_class(kFarthest)) continue;
      // Two places, rounded to whole ones, and a period.
      const mpq_class error = error_of(way[axis], p, axis, now);
      require(abs(error) < mpq_class(space_.domain.periodic[axis] ? 2.3 : 1.2), "axis %zu: %g quanta from where it is",
              axis, error.get_d());
    }
    require(points_.dimension == 3 || now.z == 0, "z = %d in 2D", now.z);
    return length_of(way);
  }
  static double length_of(const std::array<mpq_class, 3> &way) {
    double square = 0;
    for (const mpq_class &along : way) square += along.get_d() * along.get_d();
    return std::sqrt(square);
  }

  // By as much as coordinates cannot tell from nothing: once or a few times 2^32 quanta. A whole period is no motion.
  void check_jump(size_t who, size_t begin, size_t end) {
    for (size_t p = 0; p < points_.slot.size(); p++) {
      for (size_t axis = 0; axis < points_.dimension; axis++) points_.center(p, axis) = start(p, axis);
    }
    std::vector<hg::Point> now;
    points_.room = 0x1p20f;
    double *center = points_.center(who);
    for (size_t axis = 0; axis < points_.dimension; axis++) {
      const double jump = rng_.integer(1, 3) * 0x1p32 / points_.map.scale;
      center[axis] += rng_.chance(0.5) ? jump : -jump;
      const bool told = length_of(moved(who, nullptr)) > 0x1p21;
      require(!told || !update(points_, false, begin, end, now), "axis %zu: a jump by 2^32 quanta goes unnoticed",
              axis);
      center[axis] = start(who, axis);
      if (!space_.domain.periodic[axis]) continue;
      hg::Shift edges;
      edges.n[axis] = rng_.integer(-9, 9);
      for (int k = 0; k < space_.domain.dimension; k++) center[k] += space_.domain.shifted(k, edges);
      require(!space_.is_allowed(center) || update(points_, false, begin, end, now),
              "axis %zu: a whole period is taken for motion", axis);
      std::copy_n(&start(who, 0), points_.dimension, center);
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
