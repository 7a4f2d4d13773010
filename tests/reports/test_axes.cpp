// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Reports of pairs lost or made up where the axes differ: some periodic and some open, two dimensions, unequal edges,
// no extent along one.
#include "tests/reports/rebuild.hpp"

namespace {

using namespace hgtest;

using Systems = std::vector<System>;

std::vector<Point> square_lattice(int width, int depth, double spacing) {
  std::vector<Point> atoms;
  for (int i = 0; i < width; i++) {
    for (int j = 0; j < depth; j++) atoms.push_back({spacing * i, spacing * j, 0});
  }
  return atoms;
}

// With one open axis the periodic ones were forgotten: a cubic lattice of side 4 with each choice of periodic axes.
Systems pyiron_269() {
  Systems systems;
  for (int axes = 0; axes < 8; axes++) {
    System lattice = crystal(1.2, {{1, 1, 1}}, {{0, 0, 0}}, {4, 4, 4});
    size_t pairs = 0;
    for (int axis = 0; axis < 3; axis++) {
      lattice.def.periodic[axis] = axes >> axis & 1;
      pairs += lattice.def.periodic[axis] != 0 ? 64 : 48;
    }
    lattice.pairs = pairs;
    systems.push_back(named("axes " + std::to_string(axes), lattice));
  }
  return systems;
}

// Periodic squares: 36 neighbours within 3.5 spacings, 44 within 3.9, at the edges too.
Systems hoomd_317() {
  Systems systems = {within(3.5, square_lattice(16, 16, 1), 256 * 36 / 2),
                     within(3.9, square_lattice(16, 16, 1), 256 * 44 / 2)};
  for (System &system : systems) {
    system = periodic(system, {16, 16, 0});
    system.def.dimension = 2;
  }
  systems.push_back(named("in other images", in_other_images(systems[0], 1, 3)));
  return systems;
}

// Two periodic axes and an open one, a cut-off longer than the cell of two atoms, which is repeated here.
Systems vesin_154() {
  System sheet = crystal(15, {{8, 9, 100}}, {{0, 5, 0}, {4, 0, 0}}, {4, 4, 1});
  sheet.def.periodic[2] = 0;
  return {sheet};
}

// Water that carries a box of 1 although no axis is periodic, and a slab that sticks out of its box along the open
// axis.
Systems nvalchemi_104() {
  const std::vector<Point> atoms = {{0, 0, 0.119}, {0, 0.763, -0.477}, {0, -0.763, -0.477}};
  System bonds = within(1.2, atoms, 2), all = within(2, atoms, 3);
  System slab = periodic(within(1.5, cloud(2, 200, {0, 0, -6}, {6, 6, 6})), {6, 6, 0});
  for (System *system : {&bonds, &all}) system->def.box_max[0] = system->def.box_max[1] = system->def.box_max[2] = 1;
  slab.def.box_max[2] = 3;
  return {named("bonds", bonds), named("all", all), named("slab", slab)};
}

// Two atoms beyond a unit box that means nothing: one pair, and no image of it.
Systems matscipy_313() {
  System two = within(5, {{0, 0, 0}, {1.1, 1.2, 1.3}}, 1);
  two.def.box_max[0] = two.def.box_max[1] = two.def.box_max[2] = 1;
  return {two, within(5, {{0, 0, 0}, {1.1, 1.2, 1.3}}, 1)};
}

// Open sets in a box that is made for them must not meet themselves through its faces.
Systems celllistmap_95() {
  System sheet = within(1.5, square_lattice(12, 9, 1), 11 * 9 + 12 * 8 + 2 * 11 * 8);
  sheet.def.dimension = 2;
  return {named("two dimensions", sheet), named("three", within(1.5, square_lattice(12, 9, 1), sheet.pairs))};
}

// A box half as deep as it is wide: the pairs across the near faces were wrong.
Systems corrfunc_276() { return {periodic(within(10, cloud(3, 600, {0, 0, 0}, {100, 100, 50})), {100, 100, 50})}; }

// Two atoms in a line or in a plane: no extent along the other axes, hence no cells.
Systems kliff_37() {
  return {named("along x", within(1.5, {{3, 3, 3}, {4, 3, 3}}, 1)),
          named("in the plane", within(1.5, {{3, 3, 3}, {4, 4, 3}}, 1)),
          named("at a point", within(1.5, {{3, 3, 3}}, 0))};
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test((report<pyiron_269>)),   cmocka_unit_test((report<hoomd_317>)),
                              cmocka_unit_test((report<vesin_154>)),    cmocka_unit_test((report<nvalchemi_104>)),
                              cmocka_unit_test((report<matscipy_313>)), cmocka_unit_test((report<celllistmap_95>)),
                              cmocka_unit_test((report<corrfunc_276>)), cmocka_unit_test((report<kliff_37>))};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
