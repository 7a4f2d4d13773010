// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Reports of pairs lost or made up in periodic cells that are not right-angled: primitive cells of crystals, skewed
// cells, thin ones.
#include "tests/reports/rebuild.hpp"

namespace {

using namespace hgtest;

using Systems = std::vector<System>;

// The primitive cell of fcc, of one atom: no neighbours at all. 12 each, 18 with the second shell.
Systems matscipy_3() {
  const Edges cell = primitive_fcc(4);
  System one = all_images(crystal(3, cell, {{0, 0, 0}}, {1, 1, 1})),
         second = crystal(4.2, cell, {{1, 2, 3}}, {4, 4, 4});
  one.pairs = 12 / 2;
  second.pairs = 64 * 18 / 2;
  return {named("one atom", one), named("repeated", second), named("other images", in_other_images(second, 1, 3))};
}

// Clouds in cells that lean along each axis, then all given in other images: more neighbours were missed.
Systems openmm_5382() {
  Systems systems;
  for (const Point &tilts : {Point{4, 0, 0}, Point{-4, 3, 2}, Point{2, -4, 4}}) {
    const System cell = tilted(periodic(within(2, cloud(2, 300, {0, 0, 0}, {10, 9, 8})), {10, 9, 8}), tilts);
    systems.push_back(named("in the cell", cell));
    systems.push_back(named("in other images", in_other_images(cell, 3, 4)));
  }
  return systems;
}

// Edges much longer than the distance of the faces they join: cells by the one are too few, by the other right.
Systems jax_md_223() {
  const System sheet = tilted(periodic(within(1.2, cloud(4, 250, {0, 0, 0}, {12, 3, 12})), {12, 3, 12}), {9, 0, 0});
  System plane = tilted(periodic(within(1, cloud(5, 100, {0, 0, 0}, {20, 2.5, 0})), {20, 2.5, 0}), {9, 0, 0});
  plane.def.dimension = 2;
  return {named("sheet", sheet), named("plane", plane),
          named("leaning both ways",
                tilted(periodic(within(1.2, cloud(6, 250, {0, 0, 0}, {12, 12, 3})), {12, 12, 3}), {6, 5, -5}))};
}

// The image in the middle cell is 7.22 away, that one edge back 4.59.
Systems cassandra_110() {
  const System two = tilted(periodic(within(4.8, {{0, 0, 0}, {6.55, 3.03, 0}}, 1), {10, 8.66, 10}), {5, 0, 0});
  return {named("two atoms", two), named("in other images", in_other_images(two, 7, 5)),
          named("shorter", tilted(periodic(within(4.5, two.centers, 0), {10, 8.66, 10}), {5, 0, 0}))};
}

// Clouds in cells of every lean, some open along an axis.
Systems vesin_157() {
  Systems systems;
  int axes = 0;
  for (const Point &tilts : {Point{3, 0, 0}, Point{0, 3, 0}, Point{0, 0, 3}, Point{3, -2, 1}}) {
    System cell = periodic(within(1.7, cloud(8, 200, {-2, -2, -2}, {9, 9, 9})), {7, 7, 7});
    if (axes < 3) cell.def.periodic[2 - axes] = 0;  // the one that does not lean
    axes++;
    systems.push_back(named("tilt " + std::to_string(axes), tilted(cell, tilts)));
  }
  return systems;
}

// A small cell of one atom, too few copies of which were made: 56 of 64 edges. The first six shells of bcc are 64.
Systems kups_127() {
  System one = all_images(crystal(2.1, primitive_bcc(1), {{0, 0, 0}}, {1, 1, 1}));
  one.pairs = 64 / 2;
  System eight = all_images(crystal(2.1, primitive_bcc(1), {{0, 0, 0}}, {2, 2, 2}));
  eight.pairs = 8 * 64 / 2;
  return {named("one atom", one), named("eight", eight)};
}

// Cubic lattices by other edges, so skewed that the nearest images are many cells away.
Systems pymatgen_250() {
  Systems systems;
  for (const Point &tilts : {Point{3, -5, 4}, Point{-40, 7, 11}}) {
    const Edges cell = {{1, 1, 1}, tilts};
    System one = all_images(crystal(1.2, cell, {{0, 0, 0}}, {1, 1, 1})),
           second = crystal(1.5, cell, {{0, 0, 0}}, {4, 4, 4});
    one.pairs = 6 / 2;
    second.pairs = 64 * 18 / 2;
    systems.push_back(named("one atom", one));
    systems.push_back(named("repeated", second));
  }
  return systems;
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test((report<matscipy_3>)),  cmocka_unit_test((report<openmm_5382>)),
                              cmocka_unit_test((report<jax_md_223>)),  cmocka_unit_test((report<cassandra_110>)),
                              cmocka_unit_test((report<vesin_157>)),   cmocka_unit_test((report<kups_127>)),
                              cmocka_unit_test((report<pymatgen_250>))};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
