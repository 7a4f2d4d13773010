// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Reading LAMMPS data files: what is accepted, and the message for each thing that is not.
#include "tests/particles/reading.hpp"
#include "tests/support/frame.h"

using test::reads;
using test::refuses;
using test::refuses_each;
using test::set_of;
using test::with_box;
using test::with_tilt;

namespace {

const std::string kHead =
    "LAMMPS data file via write_data\n\n2 atoms\n2 atom types\n1 bonds\n\n-1 3 xlo xhi\n0 4 ylo yhi # a note\n0.5 2.5 "
    "zlo "
    "zhi\n";
const std::string kMasses = "\nMasses\n\n1 1.5 # stone\n2 2\n\nPair Coeffs # granular\n\n1 3 4\n";

particles::ParticleSet two() {
  return with_box(set_of(3, {1, 2, 1, 0, 1, 2}, {0.5, 0.25}), {-1, 0, 0.5}, {3, 4, 2.5}, {0, 0, 0});
}

bool reads_spheres() {
  const std::string rows = "1 1 1 2500 1 2 1\n2 2 0.5 2500 0 1 2\n";
  const std::string images = "1 1 1 2500 1 2 1 0 0 -1\n2 2 0.5 2500 0 1 2 0 1 0 # the second\n";
  const std::string after = "\nVelocities\n\n1 0 0 0 0 0 0\n2 0 0 0 0 0 0\n\nBonds\n\n1 1 1 2\n";
  return reads(".data", kHead + kMasses + "\nAtoms # sphere\n\n" + rows + after, two()) &&
         reads(".any", kHead + "\nAtoms # sphere\n\n" + images, two()) &&
         reads(".any", kHead + "\nAtoms  # bpm/sphere\n\n1 7 1 1 2500 1 2 1\n2 7 2 0.5 2500 0 1 2\n\n", two()) &&
         reads(".any", kHead + "1 -0.5 2 xy xz yz\n\nAtoms # granular\n\n" + rows, with_tilt(two(), {1, -0.5, 2}));
}

bool reads_other_styles() {
  particles::ReadOptions types, names;
  types.type_radii = {{"1", 0.5}, {"2", 0.25}};
  names.header = {"id", "type", "diameter", "density", "x", "y", "z"};
  return reads(".any", kHead + "\nAtoms # atomic\n\n1 1 1 2 1\n2 2 0 1 2\n", two(), types) &&
         reads(".any", kHead + "\nAtoms # charge\n\n1 1 8 1 2 1\n2 2 9 0 1 2\n", two(), types) &&
         reads(".any", kHead + "\nAtoms # full\n\n1 5 1 8 1 2 1 0 0 0\n2 5 2 9 0 1 2 0 0 0\n", two(), types) &&
         reads(".any", kHead + "\nAtoms # molecular\n\n1 5 1 1 2 1\n2 5 2 0 1 2\n", two(), types) &&
         reads(".any", kHead + "\nAtoms\n\n1 1 1 2500 1 2 1\n2 2 0.5 2500 0 1 2\n", two(), names);
}

bool refuses_bad_files() {
  const std::string head = kHead + "\nAtoms # sphere\n\n1 1 1 2500 1 2 1\n";
  return refuses_each(
      ".data",
      {{kHead + "\nAtoms\n\n1 1 1 2500 1 2 1\n",
        "11: nothing tells the style of the atoms ('Atoms # sphere'); name its columns (--header "
        "id,type,diameter,density,x,y,z)"},
       {kHead + "\nAtoms # hybrid sphere bond\n",
        "11: the atom style 'hybrid sphere bond' is unknown; name its columns (--header "
        "id,type,diameter,density,x,y,z)"},
       {kHead + "\nAtoms # atomic\n\n1 1 1 2 1\n", "13: no column radius, r, diameter or d among 'id, type, x, y, z'"},
       {head, "13: the file ends here with 1 of 2 atoms"},
       {head + "2 1 1 2500 one 2 1\n", "14: 'one' in column 'x' is not a number"},
       {head + "2 1 -1 2500 1 2 1\n", "14: '-1' in column 'diameter' is negative"},
       {head + "2 1 1 2500 1 2\n", "14: 6 values in '2 1 1 2500 1 2' where there should be 7"},
       {head + "2 1 1 2500 1 2 1\n3 1 1 2500 1 2 1\n",
        "15: a section should begin here after 2 atoms, not '3 1 1 2500 1 2 1'"},
       {"a title\n\n2 atoms\n3 -1 xlo xhi\n\nAtoms # sphere\n",
        "4: the upper bound '-1' lies below the lower bound '3'"},
       {"a title\n\n2 atoms\n0 one xlo xhi\n\nAtoms # sphere\n", "4: 'one' is not a number"},
       {kHead, "9: the file ends here, the section Atoms is missing"},
       {"a title\n\n0 1 xlo xhi\n\nAtoms # sphere\n", "5: no line 'N atoms' stands before the section Atoms"}});
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(passes<reads_spheres>),
      cmocka_unit_test(passes<reads_other_styles>),
      cmocka_unit_test(passes<refuses_bad_files>),
  };
  return cmocka_run_group_tests_name("lammps_data_reader", tests, nullptr, nullptr);
}
