// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Squeezed axes against rational numbers: near particles keep their distances, others stay a gap apart, and positions
// between particles keep their order.
#include "src/index/squeezed_axes.hpp"
#include "tests/unit/checks.hpp"
#include "tests/unit/domains.hpp"
#include "tests/unit/stores.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace {

using namespace hgtest;

class Scene {
 public:
  Scene(uint64_t seed, hg::Memory &memory)
      : rng_(seed), domain_(any_domain()), store_(make_store(memory, domain_)), axes_(memory) {}

  // Twice, as buffers are used again.
  void check() {
    for (int round = 0; round < 2; round++) {
      store_.clear();
      insert();
      require(!axes_.in_use(), "in use before squeezing");
      bounds_ = axes_.squeeze(store_, domain_, gap_);
      require(axes_.in_use(), "squeezed, but not in use");
      for (int axis = 0; axis < domain_.dimension; axis++) {
        if (domain_.periodic[axis]) {
          check_periodic(axis);
        } else {
          check_distances(axis);
          check_positions(axis);
        }
      }
      axes_.release();
    }
  }

 private:
  hg::Domain any_domain() {
    hg::Domain domain = open_space(rng_.integer(2, 3));
    for (int axis = 0; axis < domain.dimension; axis++) {
      if (rng_.chance(0.2)) set_box(domain, axis, -5, 5);
    }
    return domain;
  }

  // Groups of coincident, near and less near particles, anywhere from the origin to 1e300; chains with steps of the
  // gap.
  void insert() {
    gap_ = std::pow(10, rng_.chance(0.3) ? rng_.uniform(-300, 290) : rng_.uniform(-3, 3));
    std::vector<double> centers, radii;
    const int groups = rng_.integer(1, 6);
    for (int g = 0; g < groups; g++) {
      double place[3];
      for (double &x : place) x = gap_ * std::pow(10, rng_.uniform(-1, 10)) * rng_.uniform(-1, 1);
      if (rng_.chance(0.3)) place[rng_.below(3)] = rng_.uniform(-1, 1) * std::pow(10, rng_.uniform(200, 300));
      const double step = gap_ * std::pow(10, rng_.uniform(-6, 1));
      const bool chain = rng_.chance(0.3);
      const int count = rng_.integer(1, 40);
      for (int i = 0; i < count; i++) {
        for (int axis = 0; axis < domain_.dimension; axis++) {
          double x = chain ? place[axis] + i * gap_ : place[axis] + step * rng_.uniform(-1, 1);
          if (rng_.chance(0.1)) x = place[axis];
          if (rng_.chance(0.05)) x = rng_.chance(0.5) ? 0.0 : -0.0;
          if (rng_.chance(0.02)) x = rng_.chance(0.5) ? 5e-324 : -5e-324;
          centers.push_back(domain_.periodic[axis] ? rng_.uniform(-5, 5) : x);
        }
        radii.push_back(0);
      }
    }
    store_.insert(radii.size(), centers.data(), radii.data());
  }

  double center(size_t slot, int axis) const { return store_.center(slot)[axis]; }
  double squeezed(size_t slot, int axis) const {
    return axes_.centers()[slot * static_cast<size_t>(domain_.dimension) + static_cast<size_t>(axis)];
  }

  void check_periodic(int axis) const {
    for (size_t slot = 0; slot < store_.slots(); slot++) {
      require(squeezed(slot, axis) == center(slot, axis), "axis %d is periodic and was squeezed", axis);
    }
    require(bounds_.min[axis] == 0 && bounds_.max[axis] == domain_.length[axis], "bounds of a periodic axis");
  }

  // What sums and differences of squeezed places may be off by, and whether a distance is a gap.
  void check_pair(int axis, size_t a, size_t b) const {
    const mpq_class distance = mpq_class(center(b, axis)) - mpq_class(center(a, axis));
    const mpq_class here = mpq_class(squeezed(b, axis)) - mpq_class(squeezed(a, axis));
    const mpq_class slack = mpq_class(bounds_.max[axis]) * mpq_class(0x1p-50) + mpq_class(1e-323);
    if (distance <= mpq_class(gap_)) {
      require(abs(here - distance) <= slack, "axis %d: %a and %a are near, and now %g instead of %g apart", axis,
              center(a, axis), center(b, axis), here.get_d(), distance.get_d());
    } else {
      require(here >= mpq_class(gap_) - slack, "axis %d: %a and %a are far, and now %g apart", axis, center(a, axis),
              center(b, axis), here.get_d());
    }
  }

  void check_distances(int axis) {
    std::vector<size_t> order(store_.slots());
    std::iota(order.begin(), order.end(), size_t{0});
    std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return center(a, axis) < center(b, axis); });
    require(squeezed(order.front(), axis) == 0 && bounds_.min[axis] == 0, "axis %d does not begin at 0", axis);
    require(squeezed(order.back(), axis) == bounds_.max[axis], "axis %d ends at %g, its bounds at %g", axis,
            squeezed(order.back(), axis), bounds_.max[axis]);
    require(bounds_.max[axis] <= gap_ * static_cast<double>(order.size()), "axis %d: %zu particles take %g gaps", axis,
            order.size(), bounds_.max[axis] / gap_);
    for (size_t k = 1; k < order.size(); k++) {
      require(squeezed(order[k - 1], axis) <= squeezed(order[k], axis), "axis %d: order is not kept", axis);
      check_pair(axis, order[k - 1], order[k]);
    }
    for (int n = 0; n < 50; n++) {
      const size_t j = rng_.below(order.size()), i = rng_.below(j + 1);
      check_pair(axis, order[i], order[j]);
    }
  }

  // At, between and beside particles, and as far as doubles go.
  void check_positions(int axis) {
    constexpr double kFar = std::numeric_limits<double>::max(), kInfinity = std::numeric_limits<double>::infinity();
    std::vector<double> x = {-kInfinity, -kFar, -0.0, 0.0, kFar, kInfinity};
    for (size_t slot = 0; slot < store_.slots(); slot++) {
      const double at = center(slot, axis);
      require(axes_.position(axis, at) == squeezed(slot, axis), "axis %d: position of %a is %a instead of %a", axis, at,
              axes_.position(axis, at), squeezed(slot, axis));
      x.insert(x.end(), {at, std::nextafter(at, -kFar), std::nextafter(at, kFar), at + gap_ * rng_.uniform(-2, 2),
                         0.5 * at + 0.5 * center(rng_.below(store_.slots()), axis)});
    }
    std::sort(x.begin(), x.end());
    for (size_t k = 1; k < x.size(); k++) {
      require(axes_.position(axis, x[k - 1]) <= axes_.position(axis, x[k]), "axis %d: %a comes after %a", axis,
              x[k - 1], x[k]);
    }
  }

  Rng rng_;
  hg::Domain domain_;
  hg::ParticleStore store_;
  hg::SqueezedAxes axes_;
  double gap_ = 0;
  hg::Bounds bounds_;
};

void check_scene(uint64_t seed) {
  hg::Memory memory(hg::system_allocator());
  Scene(seed, memory).check();
}

void near_and_far_particles(void **) { assert_true(sweep(300, check_scene)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(near_and_far_particles)};
  return cmocka_run_group_tests_name("squeezed_axes", tests, nullptr, nullptr);
}
