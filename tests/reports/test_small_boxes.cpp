// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Reports of pairs that came twice, or not at all, in periodic boxes of few cells or of cells that do not fill them,
// and of single atoms.
#include "tests/reports/rebuild.hpp"

namespace {

using namespace hgtest;

using Systems = std::vector<System>;

// An atom just on the corner of the box was put into two cells: its pair came twice.
Systems celllistmap_84() {
  System two = periodic(within(5, {{0, 0, 0}, {-1, 0, 0}}, 1), {14.01, 14.02, 0});
  two.def.dimension = 2;
  return {two};
}

// The same crystal in different images of its atoms: neighbours were counted twice.
Systems fortnet_48() {
  const System salt = crystal(3, {{5.6, 5.6, 5.6}}, fcc(5.6), {2, 2, 2}),
               wide = crystal(4.5, {{5.6, 5.6, 5.6}}, fcc(5.6), {2, 2, 2});
  return {named("nearest", salt), named("nearest, other images", in_other_images(salt, 1, 2)), named("12 each", wide),
          named("12 each, other images", in_other_images(wide, 2, 1))};
}

// A box between 2.5 cut-offs and 2.5 cut-offs with skin.
Systems gpumd_1370() {
  Systems systems;
  for (const double thickness : {10.0, 10.5, 11.0, 12.0, 12.5}) {
    const Point box = {thickness, 40, 40};
    systems.push_back(named(std::to_string(thickness), periodic(within(4, cloud(3, 300, {0, 0, 0}, box)), box)));
  }
  return systems;
}

// Two to three cells along an axis: the cell on the left is the one on the right.
Systems pq_274() {
  Systems systems;
  for (const double cells : {2.0, 2.25, 2.75, 3.0, 3.5}) {
    const Point box = {cells, cells, cells};
    systems.push_back(named(std::to_string(cells), periodic(within(1, cloud(4, 120, {0, 0, 0}, box)), box)));
  }
  return systems;
}

// Pairs up to just below half the box.
Systems corrfunc_192() {
  const Point box = {205, 205, 205};
  return {periodic(within(100, cloud(5, 150, {0, 0, 0}, box)), box)};
}

// A box that its cells do not divide: a part of a cell is left at a face, and neighbours across it were lost.
Systems trixiparticles_211() {
  Systems systems;
  for (const double length : {2.1, 3.3, 3.9, 4.6}) {
    System strip = periodic(within(1, cloud(6, 100, {0, 0, 0}, {length, 5, 0})), {length, 0, 0});
    strip.centers.insert(strip.centers.end(), {{0.05, 2.5, 0}, {length - 0.05, 2.5, 0}, {length - 0.6, 2.5, 0}});
    strip.def.dimension = 2;
    systems.push_back(named(std::to_string(length), strip));
  }
  return systems;
}

// One atom, in a box of just two cut-offs, on its corner or anywhere: it is not its own neighbour.
Systems pymatgen_2036() {
  Systems systems;
  for (const double x : {0.0, 1.0, 2.0, -0.3, 17.0}) {
    systems.push_back(periodic(within(1, {{x, 0.5, x}}, 0), {2, 2, 2}));
  }
  return systems;
}

// The diamond crystal of the report, repeated until its cut-off is half the box: 28 neighbours each, 112 in a cell.
Systems sisl_1016() {
  const double edge = 3.567, half = edge / 1.4142135623730951;
  const std::vector<Point> atoms = {
      {0, 0, 0}, {half / 2, 0, edge / 4}, {half / 2, half / 2, edge / 2}, {0, half / 2, edge * 3 / 4}};
  System diamond = crystal(3, {{half, half, edge}}, atoms, {3, 7, 2});
  diamond.pairs = 3 * 7 * 2 * 112 / 2;
  return {diamond};
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test((report<celllistmap_84>)), cmocka_unit_test((report<fortnet_48>)),
      cmocka_unit_test((report<gpumd_1370>)),     cmocka_unit_test((report<pq_274>)),
      cmocka_unit_test((report<corrfunc_192>)),   cmocka_unit_test((report<trixiparticles_211>)),
      cmocka_unit_test((report<pymatgen_2036>)),  cmocka_unit_test((report<sisl_1016>))};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
