// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Reports of pairs lost or made up where a number is rounded at the face of a cell or of the box.
#include "tests/reports/rebuild.hpp"

#include <cmath>

namespace {

using namespace hgtest;

using Systems = std::vector<System>;

const double kRoot3 = std::sqrt(3);

double below(double x) { return std::nextafter(x, -1e300); }
double above(double x) { return std::nextafter(x, 1e300); }

// Atoms of a perfect lattice that lie on the faces of the box, each given in another image: two images of one atom
// differ in their last bits, so that a search which orders them by position may refuse a pair both ways. In cells with
// right angles, and in tilted ones as in the report.
Systems lammps_2759() {
  const System lattice = crystal(6.5, {{3.6, 3.6, 3.6}}, fcc(3.6), {5, 5, 5});
  const System two = periodic(within(2, {{-0.4, 2.6, above(2.6)}, {5.1, below(2.6), 2.6}}, 1), {5.3, 5.3, 5.3});
  System leaning = crystal(6.5, primitive_fcc(3.6), {{0, 0, 0}}, {6, 6, 6});
  leaning.pairs = 216 * 86 / 2;
  const System two_leaning = tilted(two, {below(2.65), 1.3, -2.6});
  return {named("as a lattice", lattice),
          named("in other images", in_other_images(lattice, 1, 2)),
          named("off the faces", moved(lattice, {0.1, -0.1, 0.7})),
          named("two atoms", two),
          named("tilted", leaning),
          named("tilted, in other images", in_other_images(leaning, 2, 2)),
          named("two atoms, tilted", two_leaning)};
}

// Hexagonal close packing of edges a and c: its cell of two atoms.
System hexagonal(double cutoff, double a, double c, const std::array<int, 3> &repeats) {
  return crystal(cutoff, {{a, a * kRoot3 / 2, c}, {-a / 2, 0, 0}}, {{0, 0, 0}, {0, a / kRoot3, c / 2}}, repeats);
}

// Hexagonal close packing in cells with right angles and in hexagonal ones: 12 neighbours at any place of the origin.
Systems atomman_12() {
  const double a = 3.2, c = a * std::sqrt(8.0 / 3);
  const std::vector<Point> atoms = {
      {0, 0, 0}, {a / 2, a * kRoot3 / 2, 0}, {0, a / kRoot3, c / 2}, {a / 2, a * kRoot3 * 5 / 6, c / 2}};
  System lattice = crystal(1.1 * a, {{a, a * kRoot3, c}}, atoms, {3, 3, 3});
  System tilted_cells = hexagonal(1.1 * a, a, c, {3, 3, 3});
  Systems systems;
  for (System *each : {&lattice, &tilted_cells}) {
    each->pairs = each->centers.size() * 12 / 2;
    systems.insert(systems.end(), {named("at the origin", *each), named("moved along x", moved(*each, {1, 0, 0})),
                                   named("moved along z", moved(*each, {0, 0, 1}))});
  }
  return systems;
}

// The same crystal a little flattened, cut off at 1.01 of its shortest edge: 12 neighbours, not 10.
Systems atomman_11() {
  const double a = 3.1790434213597902, c = 5.100201896236235;
  const std::vector<Point> atoms = {
      {0, 0, 0}, {a / 2, a * kRoot3 / 2, 0}, {0, a / kRoot3, c / 2}, {a / 2, a * kRoot3 * 5 / 6, c / 2}};
  System lattice = crystal(1.01 * a, {{a, a * kRoot3, c}}, atoms, {3, 2, 2});
  lattice.pairs = lattice.centers.size() * 12 / 2;
  System tilted_cells = hexagonal(1.01 * a, a, c, {3, 3, 2});
  tilted_cells.pairs = tilted_cells.centers.size() * 12 / 2;
  return {named("right angles", lattice), named("hexagonal", tilted_cells)};
}

// One atom on the corner of the box, one near the far face, a box whose length is a float: a pair in either order.
Systems mdanalysis_2229() {
  const Point box = {static_cast<double>(57.45585f), 50, 50};
  return {periodic(within(3, {{0, 0, 0}, {55, 0, 0}}, 1), box), periodic(within(3, {{55, 0, 0}, {0, 0, 0}}, 1), box)};
}

// An atom just in the middle of the box, which is a face of cells: pairs came twice.
Systems mdanalysis_2919() {
  std::vector<Point> atoms = cloud(2, 250, {0, 0, 0}, {16, 16, 16});
  atoms[0] = {8, 8, 8};
  return {named("2.8", periodic(within(2.8, atoms), {16, 16, 16})),
          named("3.2", periodic(within(3.2, atoms), {16, 16, 16}))};
}

// Close-packed layers stored as floats, open above and below: 9 neighbours outside, 12 inside.
Systems mdanalysis_2345() {
  const double d = 4.09 / std::sqrt(2);
  std::vector<Point> atoms;
  for (int layer = 0; layer < 4; layer++) {
    for (int i = 0; i < 6; i++) {
      for (int j = 0; j < 6; j++) {
        atoms.push_back(
            {d * (i + j % 2 * 0.5), d * kRoot3 / 2 * j + layer * d / kRoot3, 10 + layer * d * std::sqrt(2.0 / 3)});
      }
    }
  }
  System slab = periodic(within(2.9, atoms, 36 * (9 + 12 + 12 + 9) / 2), {6 * d, 3 * kRoot3 * d, 0});
  const System tilted_slab = tilted(slab, {3 * d, 0, 0});  // the six rows lean by three atoms
  return {named("floats", in_floats(slab)), named("doubles", slab), named("tilted, floats", in_floats(tilted_slab)),
          named("tilted, doubles", tilted_slab)};
}

// Just below a face, and on it once something has been added: 2 - 2e-12 < 2, and 1 - 1e-17 = 1.
Systems librascal_310() {
  std::vector<Point> atoms;
  for (const double x : {0.0, 2e-12, 1 - 2e-12, below(1), 1.0, 2 - 2e-12, below(2), 2.0, 4 - 2e-12, below(4), -1e-17}) {
    for (const double y : {1e-18, below(3), 3.0}) atoms.push_back({x, y, below(4)});
  }
  return {named("open", within(1, atoms)), named("periodic", periodic(within(1, atoms), {4, 4, 4}))};
}

// On the faces of a unit box, and one unit in the last place off them.
Systems pointneighbors_146() {
  std::vector<Point> points = {{0.5, 0.5, 0}};
  for (const double x : {below(0), 0.0, above(0), below(1), 1.0, above(1)}) {
    points.insert(points.end(), {{x, 0.5, 0}, {0.5, x, 0}, {x, x, 0}, {x, 1 - x, 0}});
  }
  Systems systems;
  for (const double cutoff : {0.1, 0.25, 1.0 / 3, 0.5}) {
    systems.push_back(named(std::to_string(cutoff), periodic(within(cutoff, points), {1, 1, 0})));
    systems.back().def.dimension = 2;
  }
  return systems;
}

// -5e-17 of a box length wraps to 1 in doubles, the upper face: its neighbours are at both faces. Of the first four
// atoms all but one pair meet, of the last three all.
Systems neighbourlists_38() {
  const double x = -5e-17 * 8;
  const std::vector<Point> atoms = {{x, 4, 4}, {1, 4, 4},   {7.2, 4, 4}, {8 + x, 5, 4},
                                    {4, x, 4}, {4, 7.5, 4}, {4, 0.4, 4}};
  return {periodic(within(1.5, atoms, 5 + 3), {8, 8, 8})};
}

// Zinc blende, one coordinate 4e-52 below the face: 4 neighbours each, as with 0.
Systems atomistica_30() {
  const double edge = 4.52743486;
  const System with_zero = crystal(2.2, {{edge, edge, edge}}, diamond(edge), {1, 1, 1});
  System with_less = with_zero;
  for (Point &center : with_less.centers) {
    if (center[0] == 0) center[0] = -4.4e-52;
  }
  with_less.pairs = 8 * 4 / 2;
  return {named("0", with_zero), named("-4.4e-52", with_less)};
}

// Four atoms, one just outside of a box as long as 700 cut-offs, as they are and wrapped in floats: all meet all.
Systems jax_md_322() {
  const Point box = {2892, static_cast<double>(36.15f), static_cast<double>(36.15f)};
  std::vector<Point> atoms = {{-2.60451931e-05, 34.8159984, 35.6217908},
                              {1.87087577, 34.99960922, 33.83063715},
                              {2.07860043, 33.19639737, 35.40671674},
                              {0.0568514, 33.07733668, 33.69007949}};
  System given = in_floats(periodic(within(4, atoms, 6), box));
  System wrapped = given;
  wrapped.centers[0][0] = static_cast<double>(static_cast<float>(2892 + wrapped.centers[0][0]));
  return {named("given", given), named("wrapped", wrapped)};
}

// A cut-off that is a multiple of the spacing, up to rounding: each pair is decided by the doubles that are there.
Systems lsms_50() {
  std::vector<Point> atoms;
  atoms.reserve(125);
  for (int i = 0; i < 125; i++) {
    const int row = i / 5 % 5, layer = i / 25;
    atoms.push_back({0.1 * (i % 5), 0.1 * row, 0.1 * layer});
  }
  return {named("0.1", within(0.1, atoms)), named("0.2", within(0.2, atoms)), named("0.3", within(0.3, atoms))};
}

// A box a little shorter than nine cut-offs, atoms that had drifted out before they were sorted into cells: those near
// 0 had too few neighbours.
Systems gpumd_190() {
  const Point box = {80.9, 40, 40};
  std::vector<Point> atoms = cloud(3, 200, {-0.5, 0, 0}, {0.5, 40, 40});
  for (const Point &atom : cloud(4, 200, {72, 0, 0}, {81.4, 40, 40})) atoms.push_back(atom);
  return {periodic(within(9, atoms), box)};
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test((report<lammps_2759>)),       cmocka_unit_test((report<atomman_12>)),
      cmocka_unit_test((report<atomman_11>)),        cmocka_unit_test((report<mdanalysis_2229>)),
      cmocka_unit_test((report<mdanalysis_2919>)),   cmocka_unit_test((report<mdanalysis_2345>)),
      cmocka_unit_test((report<librascal_310>)),     cmocka_unit_test((report<pointneighbors_146>)),
      cmocka_unit_test((report<neighbourlists_38>)), cmocka_unit_test((report<atomistica_30>)),
      cmocka_unit_test((report<jax_md_322>)),        cmocka_unit_test((report<lsms_50>)),
      cmocka_unit_test((report<gpumd_190>))};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
