// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Lists of partners against a comparison of all hulls, while particles wander far beyond their outer hulls.
#include "packing/event/hull_lists.hpp"
#include "packing/random.hpp"
#include "tests/support/frame.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace {

using packing::Box;
using packing::Random;
using packing::Vector;
using packing::event::HullLists;
using packing::event::Row;
using packing::event::Sphere;

constexpr uint64_t kSeed = 4711;
constexpr int32_t kCount = 300;
constexpr double kEdge = 20;

std::vector<int32_t> all_partners(const Box &box, const HullLists &lists, int32_t i) {
  std::vector<int32_t> partners;
  const Sphere &a = lists.hull(i);
  for (int32_t j = 0; j < kCount; j++) {
    const Sphere &b = lists.hull(j);
    double square = 0;
    for (int k = 0; k < 3; k++) {
      double x = b.center[k] - a.center[k];
      if (box.is_periodic(k)) x = std::remainder(x, kEdge);
      square += x * x;
    }
    if (j != i && square < (a.radius + b.radius) * (a.radius + b.radius)) partners.push_back(j);
  }
  return partners;
}

bool lists_are_complete(const Box &box, const HullLists &lists, int step) {
  for (int32_t i = 0; i < kCount; i++) {
    const Row row = lists.partners(i);
    std::vector<int32_t> found(row.begin(), row.end());
    std::sort(found.begin(), found.end());
    if (found == all_partners(box, lists, i)) continue;
    std::fprintf(stderr, "seed %llu, step %d: %zu partners of %d, should be %zu\n",
                 static_cast<unsigned long long>(kSeed), step, found.size(), static_cast<int>(i),
                 all_partners(box, lists, i).size());
    return false;
  }
  return true;
}

bool wander(int dimension, std::array<bool, 3> periodic) {
  const Box box(dimension, Vector(kEdge, kEdge, kEdge), periodic);
  Random random(kSeed);
  std::vector<Sphere> spheres;
  for (int32_t i = 0; i < kCount; i++) {
    Sphere sphere{Vector::Zero(), i < 5 ? 2.0 : 0.2};
    for (int k = 0; k < dimension; k++) sphere.center[k] = kEdge * random.uniform();
    spheres.push_back(sphere);
  }
  HullLists lists(box, spheres.size());
  const std::vector<double> inner(spheres.size(), 0.5), outer(spheres.size(), 1.25);
  size_t most_strays = 0;
  for (int round = 0; round < 3; round++) {
    lists.rebuild(spheres, inner, outer);
    if (lists.stray_count() != 0 || !lists_are_complete(box, lists, 0)) return false;
    for (int step = 1; step <= 400; step++) {
      const auto i = static_cast<int32_t>(random.below(kCount));
      Sphere &sphere = spheres[static_cast<size_t>(i)];
      for (int k = 0; k < dimension; k++) sphere.center[k] += 0.4 * random.normal();
      box.wrap(sphere.center);
      lists.renew(i, sphere, 0.5);
      if (step % 20 == 0 && !lists_are_complete(box, lists, step)) return false;
      // The hull holds its particle with room to spare.
      if (lists.hull(i).radius < sphere.radius + 0.25 || lists.hull(i).radius > sphere.radius + 0.5) return false;
    }
    most_strays = std::max(most_strays, lists.stray_count());
  }
  return most_strays > 20;  // else strays have not been tested
}

bool partners_in_open_space() { return wander(3, {false, false, false}); }

bool partners_through_periodic_boundaries() { return wander(3, {true, true, true}) && wander(3, {false, true, false}); }

bool partners_of_disks() { return wander(2, {true, false, false}); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(passes<partners_in_open_space>),
      cmocka_unit_test(passes<partners_through_periodic_boundaries>),
      cmocka_unit_test(passes<partners_of_disks>),
  };
  return cmocka_run_group_tests_name("hull_lists", tests, nullptr, nullptr);
}
