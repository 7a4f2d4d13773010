// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Reports of cut-offs longer than half the box, where two meet through several images and an atom meets itself: other
// codes counted one of them, none, or some twice. All images count here; without HG_ALL_IMAGES such boxes are refused.
#include "tests/reports/rebuild.hpp"

namespace {

using namespace hgtest;

using Systems = std::vector<System>;

// Diamond in its cubic cell of 8 atoms: 140 of 224 neighbours were found.
Systems sisl_1016() {
  const double edge = 3.567;
  System cell = all_images(crystal(3, {{edge, edge, edge}}, diamond(edge), {1, 1, 1}));
  cell.pairs = 224 / 2;
  return {cell};
}

// An edge shorter than two cut-offs: each atom is 1 from the other on both sides.
Systems sisl_706() { return {all_images(periodic(within(1.1, {{0, 0, 0}, {3, 0, 0}}, 2), {2, 10, 10}))}; }

// A cut-off longer than the edges of the sheet, which is open above and below.
Systems vesin_153() {
  System sheet = all_images(crystal(15, {{8, 9, 100}}, {{0, 5, 0}, {4, 0, 0}}, {1, 1, 1}));
  sheet.def.periodic[2] = 0;
  return {sheet};
}

// A square lattice of side 4: half of the third shell was lost, as two of its atoms are images of one. 12 each.
Systems freebird_150() {
  System lattice = all_images(crystal(2.1, {{1, 1, 10}}, {{0, 0, 0}}, {4, 4, 1}));
  lattice.pairs = 16 * 12 / 2;
  return {lattice};
}

// An atom and its own images, each once: shells of the cubic lattice.
Systems featomic_240() {
  return {named("6", all_images(periodic(within(1.2, {{0, 0, 0}}, 6 / 2), {1, 1, 1}))),
          named("18", all_images(periodic(within(1.5, {{0.3, -0.2, 7}}, 18 / 2), {1, 1, 1}))),
          named("32", all_images(periodic(within(2.1, {{0, 0, 0}}, 32 / 2), {1, 1, 1})))};
}

// Cut-offs of one to three edges: a crystal, of known shells, and a cloud.
Systems nvalchemi_2() {
  System first = all_images(crystal(0.9, {{1, 1, 1}}, fcc(1), {1, 1, 1})),
         sixth = all_images(crystal(1.8, {{1, 1, 1}}, fcc(1), {1, 1, 1}));
  first.pairs = 4 * 12 / 2;
  sixth.pairs = 4 * 86 / 2;
  const std::vector<Point> atoms = cloud(9, 12, {0, 0, 0}, {3, 3, 3});
  return {named("first shell", first), named("six shells", sixth),
          named("one edge", all_images(periodic(within(3, atoms), {3, 3, 3}))),
          named("three edges", all_images(periodic(within(9, atoms), {3, 3, 3})))};
}

// Clouds in boxes of one to two cut-offs.
Systems apax_121() {
  Systems systems;
  for (const double edge : {6.0, 7.5, 9.0, 11.9}) {
    const Point box = {edge, edge, edge};
    systems.push_back(named(std::to_string(edge), all_images(periodic(within(6, cloud(7, 20, {0, 0, 0}, box)), box))));
  }
  return systems;
}

// The same boxes where a pair may be one only once.
void boxes_too_short_are_refused(void **) {
  assert_true(holds(0, [](uint64_t) {
    for (const auto rebuild : {sisl_1016, sisl_706, vesin_153, freebird_150, nvalchemi_2, apax_121}) {
      for (System system : rebuild()) {
        system.def.images = HG_NEAREST_IMAGE;
        const Particles particles = spheres(system.centers, system.cutoff / 2);
        require(status_of([&] { make_grid(system.def, particles); }) == HG_ERR_ARGUMENT, system.name + " is taken");
      }
    }
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test((report<sisl_1016>)),    cmocka_unit_test((report<sisl_706>)),
                              cmocka_unit_test((report<vesin_153>)),    cmocka_unit_test((report<freebird_150>)),
                              cmocka_unit_test((report<featomic_240>)), cmocka_unit_test((report<nvalchemi_2>)),
                              cmocka_unit_test((report<apax_121>)),     cmocka_unit_test(boxes_too_short_are_refused)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
