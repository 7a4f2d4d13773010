// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Reading LAMMPS text dumps: what is accepted, and the message for each thing that is not.
#include "tests/particles/reading.hpp"
#include "tests/support/frame.h"

using test::of_dimension;
using test::of_frame;
using test::reads;
using test::refuses;
using test::refuses_each;
using test::set_of;
using test::with_box;
using test::with_tilt;

namespace {

const std::string kHead =
    "ITEM: TIMESTEP\n100\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp ff pp\n-1 3\n0 4\n0.5 2.5\n";

particles::ParticleSet boxed(std::vector<double> centers, std::vector<double> radii) {
  return with_box(set_of(3, std::move(centers), std::move(radii)), {-1, 0, 0.5}, {3, 4, 2.5}, {1, 0, 1});
}

bool reads_one_frame() {
  const particles::ParticleSet two = boxed({1, 2, 1, 0, 1, 2}, {0.5, 0.25});
  return reads(".dump", kHead + "ITEM: ATOMS id type x y z radius\n2 1 1 2 1 0.5\n1 1 0 1 2 0.25\n", two) &&
         reads(".x", kHead + "ITEM: ATOMS diameter xu yu zu \n1 1 2 1 \n0.5 0 1 2 \n", two) &&
         reads(".x",
               "ITEM: UNITS\nsi\nITEM: TIME\n0.5\n" + kHead + "ITEM: ATOMS x y z radius\r\n1 2 1 .5\r\n0 1 2 .25\r\n",
               two);
}

bool reads_scaled_coordinates() {
  return reads(".dump", kHead + "ITEM: ATOMS xs ys zs radius\n0.5 0.5 0.25 0.5\n0.25 0.25 0.75 0.25\n",
               boxed({1, 2, 1, 0, 1, 2}, {0.5, 0.25}));
}

// The cell from (-1, 0, 0.5) to (3, 4, 2.5), in the bounds that LAMMPS writes for each tilt.
std::string tilted_head(const std::string &x, const std::string &y, const std::string &z) {
  return "ITEM: TIMESTEP\n100\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS xy xz yz pp pp pp\n" + x + '\n' + y + '\n' +
         z + "\nITEM: ATOMS ";
}

particles::ParticleSet tilted(std::vector<double> centers, const double (&tilt)[3]) {
  return with_tilt(with_box(set_of(3, std::move(centers), {0.5, 0.25}), {-1, 0, 0.5}, {3, 4, 2.5}, {1, 1, 1}), tilt);
}

bool reads_tilted_boxes() {
  const std::string rows = "x y z radius\n1 2 1 0.5\n0 1 2 0.25\n";
  const std::vector<double> centers = {1, 2, 1, 0, 1, 2};
  return reads(".dump", tilted_head("-1 4.5 1", "0 6 0.5", "0.5 2.5 2") + rows, tilted(centers, {1, 0.5, 2})) &&
         reads(".dump", tilted_head("-2.5 3 -1", "-2 4 -0.5", "0.5 2.5 -2") + rows, tilted(centers, {-1, -0.5, -2})) &&
         reads(".dump", tilted_head("-3 4 1", "0 4 -2", "0.5 2.5 0") + rows, tilted(centers, {1, -2, 0})) &&
         reads(".dump", tilted_head("-1.5 5 -0.5", "0 4.25 2", "0.5 2.5 0.25") + rows,
               tilted(centers, {-0.5, 2, 0.25})) &&
         reads(".dump", tilted_head("-1 3 0", "0 4 0", "0.5 2.5 0") + rows, tilted(centers, {0, 0, 0}));
}

// x = -1 + 4 xs + 1 ys + 0.5 zs, y = 4 ys + 2 zs, z = 0.5 + 2 zs.
bool reads_scaled_coordinates_in_tilted_boxes() {
  const std::string rows = "xs ys zs radius\n0.5 0.5 0.25 0.5\n0.25 0 1 0.25\n";
  return reads(".dump", tilted_head("-1 4.5 1", "0 6 0.5", "0.5 2.5 2") + rows,
               tilted({1.625, 2.5, 1, 0.5, 2, 2.5}, {1, 0.5, 2})) &&
         refuses(".dump", tilted_head("-1 4.5 1", "0 6 0.5", "0.5 2.5 2") + "xs y zs radius\n",
                 "9: in a tilted box x and y must be scaled both or neither");
}

std::string frame_of_radius(const std::string &radius) {
  return kHead + "ITEM: ATOMS x y z radius\n1 2 1 " + radius + "\n0 1 2 " + radius + "\n";
}

bool reads_the_frame_asked_for() {
  const std::string text = frame_of_radius("1") + frame_of_radius("2") + frame_of_radius("3");
  const std::vector<double> centers = {1, 2, 1, 0, 1, 2};
  return reads(".dump", text, boxed(centers, {3, 3})) && reads(".dump", text, boxed(centers, {1, 1}), of_frame(1)) &&
         reads(".dump", text, boxed(centers, {2, 2}), of_frame(2)) &&
         refuses(".dump", text, "33: frame 4 of a file with 3", of_frame(4));
}

bool reads_a_plane() {
  return reads(".dump", kHead + "ITEM: ATOMS x y z radius\n1 2 1 1\n0 1 1 1\n",
               with_box(set_of(2, {1, 2, 0, 1}, {1, 1}), {-1, 0, 0}, {3, 4, 0}, {1, 0, 0}), of_dimension(2));
}

bool reads_names_in_any_case() {
  const particles::ParticleSet two = boxed({1, 2, 1, 0, 1, 2}, {0.5, 0.25});
  return reads(".dump", kHead + "ITEM: ATOMS X Y Z Radius\n1 2 1 0.5\n0 1 2 0.25\n", two) &&
         reads(".dump", kHead + "ITEM: ATOMS x y z c_Radius\n1 2 1 0.5\n0 1 2 0.25\n", two) &&
         reads(".dump", kHead + "ITEM: ATOMS x y z v_diameter\n1 2 1 1D0\n0 1 2 0.5\n", two);
}

bool reads_the_size_asked_for() {
  const particles::ParticleSet two = boxed({1, 2, 1, 0, 1, 2}, {0.5, 0.25});
  particles::ReadOptions variable, types, names;
  variable.radius = "v_size";
  types.type_radii = {{"1", 0.5}, {"2", 0.25}};
  names.header = {"x", "y", "z", "r"};
  return reads(".dump", kHead + "ITEM: ATOMS x y z v_size\n1 2 1 0.5\n0 1 2 0.25\n", two, variable) &&
         reads(".dump", kHead + "ITEM: ATOMS type x y z\n1 1 2 1\n2 0 1 2\n", two, types) &&
         reads(".dump", kHead + "ITEM: ATOMS c_1[1] c_1[2] c_1[3] v_2\n1 2 1 0.5\n0 1 2 0.25\n", two, names);
}

// The cell of "dump custom ... triclinic/general".
bool passes_over_a_turned_box() {
  particles::ReadOptions options;
  options.needs_box = false;
  const std::string head =
      "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS abc origin pp pp pp\n"
      "0 4 0 0\n4 0 0 0\n0 0 4 0\nITEM: ATOMS ";
  particles::ParticleSet one = set_of(3, {1, 2, 3}, {0.5});
  for (int &flag : one.periodic) flag = 1;
  return reads(".dump", head + "x y z radius\n1 2 3 0.5\n", one, options) &&
         refuses(".dump", head + "xs ys zs radius\n1 2 3 0.5\n",
                 "9: scaled coordinates need the file's box, whose edges point elsewhere", options);
}

bool refuses_bad_heads() {
  const std::string start = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n";
  return refuses_each(
      ".dump",
      {{start + "two\n", "4: the number of atoms should stand here, not 'two'"},
       {start + "-2\n", "4: the number of atoms should stand here, not '-2'"},
       {start, "3: the file ends here, the number of atoms is missing"},
       {start + "1\nITEM: BOX BOUNDS abc origin pp pp pp\n1 0 0 0\n0 1 0 0\n0 0 1 0\n",
        "5: three boundary flags should stand here, in tilted boxes after 'xy xz yz', not "
        "'BOX BOUNDS abc origin pp pp pp'"},
       {start + "1\nITEM: BOX BOUNDS xy xz yz pp pp pp\n0 1 0\n0 1\n",
        "7: a lower and an upper bound and a tilt should stand here, not '0 1'"},
       {start + "1\nITEM: BOX BOUNDS xy xz yz pp pp pp\n0 1 0\n0 1 x\n", "7: 'x' is not a number"},
       {start + "1\nITEM: BOX BOUNDS xy xz yz pp pp pp\n0 1 2\n0 1 0\n0 1 0\n",
        "8: the bounds on axis x leave no room for a box of this tilt"},
       {start + "1\nITEM: BOX BOUNDS\n0 1\n0 1\n0 1\n", "5: the boundary flags (such as pp pp ff) are missing"},
       {start + "1\nITEM: BOX BOUNDS pp pp xx\n", "5: the boundary flag 'xx' is unknown"},
       {start + "1\nITEM: BOX BOUNDS pp pp pp\n0 1\n0 one\n", "7: 'one' is not a number"},
       {start + "1\nITEM: BOX BOUNDS pp pp pp\n0 1\n0 -1\n", "7: the upper bound '-1' lies below the lower bound '0'"},
       {start + "1\nITEM: BOX BOUNDS pp pp pp\n0 1 2\n",
        "6: a lower and an upper bound should stand here, not '0 1 2'"},
       {start + "1\nITEM: ATOMS x y z radius\n", "5: NUMBER OF ATOMS and BOX BOUNDS must stand before ATOMS"},
       {start + "1\nITEM: ENTRIES c_1\n", "5: the section 'ENTRIES c_1' is unknown"}});
}

bool refuses_missing_columns() {
  return refuses_each(
      ".dump", {{kHead + "ITEM: ATOMS id x y z\n1 0 0 0\n2 0 0 0\n",
                 "9: no column radius, r, diameter or d among 'id, x, y, z'"},
                {kHead + "ITEM: ATOMS id x z radius\n1 0 0 0\n2 0 0 0\n", "9: no column y among 'id, x, z, radius'"}});
}

bool refuses_bad_rows() {
  const std::string head = kHead + "ITEM: ATOMS x y z radius\n1 2 1 0.5\n";
  return refuses_each(".dump",
                      {{head + "1 2 NaN 0.5\n", "11: 'NaN' in column 'z' is not finite"},
                       {head + "1 2 3 -1\n", "11: '-1' in column 'radius' is negative"},
                       {head + "1 2 3\n", "11: 3 values in '1 2 3' where there should be 4"},
                       {head, "10: the file ends here with 1 of 2 atoms"},
                       {head + "0 1 2 1\n0 1 2 1\n", "12: a line 'ITEM: ...' should stand here, not '0 1 2 1'"},
                       {kHead, "8: the file ends here, the line 'ITEM: ATOMS ...' is missing"}});
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(passes<reads_one_frame>),
      cmocka_unit_test(passes<reads_scaled_coordinates>),
      cmocka_unit_test(passes<reads_the_frame_asked_for>),
      cmocka_unit_test(passes<reads_a_plane>),
      cmocka_unit_test(passes<reads_tilted_boxes>),
      cmocka_unit_test(passes<reads_scaled_coordinates_in_tilted_boxes>),
      cmocka_unit_test(passes<reads_names_in_any_case>),
      cmocka_unit_test(passes<reads_the_size_asked_for>),
      cmocka_unit_test(passes<passes_over_a_turned_box>),
      cmocka_unit_test(passes<refuses_bad_heads>),
      cmocka_unit_test(passes<refuses_missing_columns>),
      cmocka_unit_test(passes<refuses_bad_rows>),
  };
  return cmocka_run_group_tests_name("lammps_reader", tests, nullptr, nullptr);
}
