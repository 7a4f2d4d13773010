// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Reports of pairs lost or made up among bodies of unequal size or reach, and among very many neighbours.
#include "tests/reports/rebuild.hpp"

#include <utility>

namespace {

using namespace hgtest;

using Systems = std::vector<System>;

System of_spheres(std::vector<Point> centers, std::vector<double> radii, std::optional<size_t> pairs = {}) {
  System system;
  system.centers = std::move(centers);
  system.radii = std::move(radii);
  system.pairs = pairs;
  return system;
}

// A small body wholly inside of one a little larger.
Systems godot_54898() {
  return {named("centred", of_spheres({{100, 100, 0}, {100, 100, 0}}, {8, 6}, 1)),
          named("aside", of_spheres({{100, 100, 0}, {101.5, 99, 0}}, {8, 6}, 1)),
          named("far smaller", of_spheres({{100, 100, 0}, {103, 99, 2}}, {8, 1e-9}, 1))};
}

// Two kinds of atoms: the longer range of a pair counts.
Systems lammps_4437() {
  System alloy = crystal(6, {{3.61, 3.61, 3.61}}, fcc(3.61), {5, 5, 5});
  alloy.pairs.reset();
  alloy.def.interaction = HG_MAX_RANGE;
  alloy.radii = {3.6, 6, 3.6};
  System of_one_kind = alloy;
  of_one_kind.radii = {6};
  of_one_kind.pairs = crystal(6, {{3.61, 3.61, 3.61}}, fcc(3.61), {5, 5, 5}).pairs;
  return {named("two kinds", alloy), named("the longer alone", of_one_kind)};
}

// Grains that hold on to each other beyond contact.
Systems lammps_4685() {
  System grains = of_spheres(cloud(1, 300, {0, 0, 0}, {10, 10, 10}), {0.5, 0.2, 0.3, 0.05});
  grains.def.margin = 0.11;
  return {named("open", grains), named("periodic", periodic(grains, {10, 10, 10})), named("a bond", [] {
            System two = of_spheres({{0, 0, 0}, {1.05, 0, 0}}, {0.5}, 1);
            two.def.margin = 0.1;
            return two;
          }())};
}

// Bodies larger than the cells made for the others.
Systems ecell4_147() {
  std::vector<Point> centers = cloud(2, 400, {0, 0, 0}, {20, 20, 20});
  std::vector<double> radii(400, 0.3);
  radii[11] = 4;
  radii[12] = 9;
  radii[399] = 2;
  return {of_spheres(centers, radii), named("periodic", periodic(of_spheres(centers, radii), {40, 40, 40}))};
}

// A body without an end, as a half-space has none, among small ones.
Systems coal_750() {
  std::vector<Point> centers = cloud(3, 100, {-10, -10, -10}, {10, 10, 10});
  std::vector<double> radii(100, 0.01);
  radii[0] = 1e150;
  radii[1] = 1e100;
  centers[1] = {-1e100, 0, 0};
  return {of_spheres(centers, radii)};
}

// More neighbours than a fixed length of lists: all meet all, around and beyond the widths of vectors and blocks.
Systems timemachine_663() {
  Systems systems;
  for (size_t count : {1, 2, 3, 5, 8, 9, 15, 16, 17, 31, 32, 33, 34, 63, 64, 65, 97, 129}) {
    systems.push_back(
        named(std::to_string(count), within(4, cloud(count, count, {0, 0, 0}, {2, 2, 2}), count * (count - 1) / 2)));
    if (count < 100) continue;
    systems.back().cutoff = 0;
    systems.back().radii = {4, 3.5};
  }
  return systems;
}

// 34 points near each other: lists ended after 32.
Systems pytorch_geometric_1867() { return {within(10, cloud(4, 34, {-2, -2, -2}, {2, 2, 2}), 34 * 33 / 2)}; }

// Enough points for several threads: each counted all pairs.
Systems corrfunc_264() {
  const Point box = {20, 20, 20};
  System many = of_spheres(cloud(5, 3000, {0, 0, 0}, box), {0.5, 0.3, 0.9});
  return {named("open", many), named("periodic", periodic(many, box))};
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test((report<godot_54898>)),
                              cmocka_unit_test((report<lammps_4437>)),
                              cmocka_unit_test((report<lammps_4685>)),
                              cmocka_unit_test((report<ecell4_147>)),
                              cmocka_unit_test((report<coal_750>)),
                              cmocka_unit_test((report<timemachine_663>)),
                              cmocka_unit_test((report<pytorch_geometric_1867>)),
                              cmocka_unit_test((report<corrfunc_264>))};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
