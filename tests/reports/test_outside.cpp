// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Reports of pairs lost or made up where coordinates are negative or lie outside of the box.
#include "tests/reports/rebuild.hpp"

#include <cmath>

namespace {

using namespace hgtest;

using Systems = std::vector<System>;

// Two atoms 1 apart along y in a box of 8: both inside, one outside, both outside.
Systems neighbourlists_6() {
  Systems systems;
  for (const double first : {3.5, 0.0, -0.25, -0.5, 7.75, 8.5, -8.0, 23.5}) {
    for (const double boxes : {-2.0, -1.0, 0.0, 1.0}) {
      systems.push_back(periodic(within(1.5, {{1, first, 1}, {1, first + 1 + 8 * boxes, 1}}, 1), {8, 8, 8}));
    }
  }
  return systems;
}

// Cells counted from 0, positions below it.
Systems jax_md_168() {
  return {named("around 0", within(1, cloud(1, 300, {-4, -4, -4}, {4, 4, 4}))),
          named("all below 0", within(1, cloud(2, 300, {-9, -9, -9}, {-1, -1, -1})))};
}

// A file whose atoms stick out of the box by a little.
Systems jax_md_171() {
  const double box = 31.298;
  return {periodic(within(4, cloud(3, 400, {-0.2, -0.2, -0.2}, {box + 0.2, box + 0.2, box + 0.2})), {box, box, box})};
}

// A rigid dimer: its centre is inside, one of its ends is not.
Systems jax_md_302() {
  Systems systems;
  for (int turn = 0; turn < 16; turn++) {
    const double angle = turn * 0.39269908169872414, x = 0.6 * std::cos(angle), y = 0.6 * std::sin(angle);
    systems.push_back(periodic(within(1.5, {{0.2 + x, 5 + y, 9.9}, {0.2 - x, 5 - y, 9.9}}, 1), {10, 10, 10}));
  }
  return systems;
}

// A chain of 14 atoms in a cell with right angles, its atoms in any image: each meets the next.
Systems pymatgen_2226() {
  std::vector<Point> atoms;
  atoms.reserve(14);
  for (int i = 0; i < 14; i++) atoms.push_back({0.3 * (i % 2), 0.5 + 0.9 * i, 1 + 1.1 * i});
  const System chain = periodic(within(1.6, atoms, 13), {6.90822086654748, 14.174561098843372, 20.018929340515705});
  return {named("as it is", chain), named("in other images", in_other_images(chain, 4, 1))};
}

// Coordinates that nobody has wrapped for long.
Systems nvalchemi_18() {
  return {in_other_images(periodic(within(2, cloud(5, 200, {0, 0, 0}, {9, 9, 9})), {9, 9, 9}), 6, 1000)};
}

// One of two atoms leaves a box that is just twice as long as the cut-off: the distance changes, the image too.
Systems openmm_ml_77() {
  Systems systems;
  for (int step = -60; step <= 60; step++) {
    systems.push_back(periodic(within(5, {{5, 5, 5}, {5 + 0.5 * step, 5.5, 5}}), {10, 10, 10}));
  }
  return systems;
}

// A molecule around 0 in a box that is nearly empty: one oxygen, two hydrogens.
Systems pyiron_1170() { return {periodic(within(1.3, {{0.7, 0.7, 0}, {-0.7, 0.7, 0}, {0, 0, 0}}, 2), {10, 10, 10})}; }

// -0.3 cut to an integer is cell 0, where floor gives -1: not found from 0.2.
Systems warp_1256() {
  return {named("across 0", within(0.6, {{-0.3, 0, 0}, {0.2, 0, 0}}, 1)),
          named("all axes", within(0.6, {{-0.2, -0.2, -0.2}, {0.1, 0.1, 0.1}}, 1)),
          named("below 0", within(1, cloud(7, 200, {-3, -3, -3}, {-0.1, -0.1, -0.1})))};
}

// An open axis, all coordinates along it negative.
Systems vesin_all_negative() { return {periodic(within(2, cloud(8, 200, {0, 0, -40}, {9, 9, -30})), {9, 9, 0})}; }

// A box of a hundredth, a molecule thousands of boxes long.
Systems mdanalysis_2670() {
  return {periodic(within(0.001, cloud(9, 400, {-20, -20, -20}, {30, 30, 30})), {0.01, 0.01, 0.01})};
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test((report<neighbourlists_6>)), cmocka_unit_test((report<jax_md_168>)),
      cmocka_unit_test((report<jax_md_171>)),       cmocka_unit_test((report<jax_md_302>)),
      cmocka_unit_test((report<pymatgen_2226>)),    cmocka_unit_test((report<nvalchemi_18>)),
      cmocka_unit_test((report<openmm_ml_77>)),     cmocka_unit_test((report<pyiron_1170>)),
      cmocka_unit_test((report<warp_1256>)),        cmocka_unit_test((report<vesin_all_negative>)),
      cmocka_unit_test((report<mdanalysis_2670>))};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
