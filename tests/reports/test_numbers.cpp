// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Reports of pairs lost or made up by numbers that are very large, very small, equal, rounded or no numbers.
#include "tests/reports/rebuild.hpp"

#include <cmath>
#include <limits>

namespace {

using namespace hgtest;

using Systems = std::vector<System>;

// A box so large that its number of cells is beyond an integer, open and periodic.
Systems nvalchemi_74() {
  Systems systems;
  for (const double length : {1e4, 1e5, 1e9, 1e15}) {
    System open = within(8, cloud(1, 300, {-60, -60, -60}, {60, 60, 60}));
    for (double &edge : open.def.box_max) edge = length;
    systems.push_back(named("open " + std::to_string(length), open));
    systems.push_back(named("periodic " + std::to_string(length), periodic(open, {length, length, length})));
  }
  return systems;
}

// A crystal that comes apart: the box grows without bound, and the atoms with it.
Systems matscipy_5() {
  Systems systems;
  for (const double scale : {1.0, 1.3, 85.0, 2e3, 1e8, 1e200}) {
    System solid = crystal(3.1, {{4.05, 4.05, 4.05}}, fcc(4.05), {2, 2, 2});
    for (Point &center : solid.centers) center = {center[0] * scale, center[1] * scale, center[2] * scale};
    for (double &edge : solid.def.box_max) edge *= scale;
    if (scale > 1.1) solid.pairs = 0;
    systems.push_back(named(std::to_string(scale), solid));
  }
  return systems;
}

// A cut-off of 0, which made cells of width 0.
Systems hoomd_1446() {
  const std::vector<Point> atoms = {{0, 0, 0}, {0, 0, 0}, {1, 2, 3}};
  return {named("open", within(0, atoms, 0)), named("periodic", periodic(within(0, atoms, 0), {5, 5, 5}))};
}

// Cut-offs far below any distance, which made more cells than memory holds.
Systems pymatgen_2277() {
  std::vector<Point> atoms = cloud(2, 100, {0, 0, 0}, {20, 20, 20});
  atoms.push_back(atoms[7]);
  return {named("1e-8", periodic(within(1e-8, atoms, 1), {20, 20, 20})),
          named("1e-200", periodic(within(1e-200, atoms, 1), {20, 20, 20})),
          named("0.1", periodic(within(0.1, atoms), {20, 20, 20}))};
}

// Two atoms at one place are neighbours, whoever they are.
Systems pymatgen_1485() {
  const std::vector<Point> atoms = {{1, 1, 1}, {1, 1, 1}, {3, 3, 3}, {3, 3, 3}, {3, 3, 3}, {0, 0, 0}, {5, 5, 5}};
  return {periodic(within(0.05, atoms, 1 + 3 + 1), {5, 5, 5})};
}

// Survey coordinates: 1e5 from the origin, in floats.
Systems three_mesh_bvh_112() {
  std::vector<Point> points = cloud(3, 300, {100928, 99222, 3541}, {100948, 99242, 3561});
  return {named("floats", in_floats(within(2, points))), named("doubles", within(2, points))};
}

// A square lattice whose spacing, the root of 2, is the cut-off: by the doubles that are there, in any setting.
Systems scipy_16600() {
  const double spacing = std::sqrt(2);
  std::vector<Point> points;
  points.reserve(16);
  for (int i = 0; i < 16; i++) {
    const int row = i / 4;
    points.push_back({i % 4 * spacing, row * spacing, 0});
  }
  return {named("just the spacing", within(spacing, points)),
          named("a little more", within(spacing * (1 + 1e-15), points, 24)),
          named("a little less", within(spacing * (1 - 1e-15), points, 0))};
}

// A cut-off that is a distance: touching is no pair, one unit in the last place more is one.
Systems scikit_learn_7700() {
  const std::vector<Point> points = {{0, 0, 0}, {3, 4, 0}, {-12, 0, 5}};
  return {named("5", within(5, points, 0)), named("above 5", within(std::nextafter(5, 6), points, 1)),
          named("13", within(13, points, 1)), named("above 13", within(std::nextafter(13, 14), points, 2))};
}

// Spheres that overlap by less than a float can tell, or than a double can, or miss by that, in any direction.
Systems arborx_235() {
  Systems systems;
  Rng rng(5);
  for (const double overlap : {1e-9, 1e-12, 1e-16, 0.0, -1e-16, -1e-12, -1e-9}) {
    System pairs;
    pairs.name = std::to_string(overlap);
    for (int i = 0; i < 200; i++) {
      const int row = i / 8 % 8, layer = i / 64;
      const Point from = {2 * (i % 8) + rng.uniform(), 2 * row + rng.uniform(), 2 * layer + rng.uniform()};
      const Point by = {rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
      pairs.radii.insert(pairs.radii.end(), {rng.uniform(0.1, 0.5), rng.uniform(0.1, 0.5)});
      const double distance = pairs.radii[pairs.radii.size() - 2] + pairs.radii.back() - overlap;
      const double scale = distance / std::sqrt(by[0] * by[0] + by[1] * by[1] + by[2] * by[2]);
      pairs.centers.push_back(from);
      pairs.centers.push_back({from[0] + by[0] * scale, from[1] + by[1] * scale, from[2] + by[2] * scale});
    }
    systems.push_back(pairs);
  }
  return systems;
}

// Nothing near anything: no pairs, but a row for each atom, the last too.
Systems symmetrix_81() {
  return {named("two", within(5, {{0, 0, 0}, {10, 0, 0}}, 0)), named("none", within(5, {}, 0)),
          named("the last is alone", within(5, {{0, 0, 0}, {4, 0, 0}, {100, 0, 0}}, 1))};
}

// Coordinates that are no numbers made pairs of others vanish: they are refused, and the others keep their pairs.
void scipy_14793(void **) {
  assert_true(holds(0, [](uint64_t) {
    const Particles points = spheres(cloud(4, 400, {-2, -2, -2}, {2, 2, 2}), 0.15);
    const Particles none = spheres({{std::numeric_limits<double>::quiet_NaN(), 0, 0}}, 0.15);
    const hg_grid_def def = hg_default_grid_def();
    Grid grid = make_grid(def, points);
    const hg_status status = status_of([&] { grid.insert(1, none.centers.data(), none.radii.data()); });
    require(status == HG_ERR_ARGUMENT, "no number is taken");
    require_same("the others", sorted_pairs_of(grid), all_pairs(def, points, exact_interact));
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test((report<nvalchemi_74>)),
                              cmocka_unit_test((report<matscipy_5>)),
                              cmocka_unit_test((report<hoomd_1446>)),
                              cmocka_unit_test((report<pymatgen_2277>)),
                              cmocka_unit_test((report<pymatgen_1485>)),
                              cmocka_unit_test((report<three_mesh_bvh_112>)),
                              cmocka_unit_test((report<scipy_16600>)),
                              cmocka_unit_test((report<scikit_learn_7700>)),
                              cmocka_unit_test((report<arborx_235>)),
                              cmocka_unit_test((report<symmetrix_81>)),
                              cmocka_unit_test(scipy_14793)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
