// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Reading CSV: what is accepted, and the message for each thing that is not.
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

bool reads_columns_in_any_order() {
  const particles::ParticleSet two = set_of(3, {1, 2, 3, -4, 5e-3, 6}, {0.5, 0.25});
  return reads(".csv", "x,y,z,r\n1,2,3,0.5\n-4,5e-3,6,0.25\n", two) &&
         reads(".csv", "id,Radius,z,name,y,x\n7,0.5,3,a b,2,1\n8,.25,6,,+5E-3,-4\n", two) &&
         reads(".csv", "x,y,z,diameter\n1,2,3,1\n-4,5e-3,6,0.5", two);
}

bool reads_every_separator() {
  const particles::ParticleSet one = set_of(3, {1, 2, 3}, {0.5});
  return reads(".csv", "x;y;z;d\n1;2; 3 ;1\n", one) && reads(".tsv", "x\ty\tz\tr\n1\t2\t3\t0.5\n", one) &&
         reads(".txt", "  x y   z r \n 1   2 3 0.5  \n", one) &&
         reads(".csv", "\"x\",\"y\",\"z\",\"radius\"\n1,2,3,0.5\n", one);
}

bool reads_line_ends_comments_and_blank_lines() {
  const particles::ParticleSet one = set_of(3, {1, 2, 3}, {0.5});
  return reads(".csv", "\xEF\xBB\xBFx,y,z,r\r\n1,2,3,0.5\r\n", one) &&
         reads(".csv", "# a comment\n\nx,y,z,r\n  # one more\n1,2,3,0.5\n\n", one) &&
         reads(".csv", "x,y,z,r\n", set_of(3, {}, {}));
}

bool reads_two_dimensions() {
  const particles::ParticleSet two = set_of(2, {1, 2, 3, 4}, {0.5, 0.25});
  return reads(".csv", "x,y,r\n1,2,0.5\n3,4,0.25\n", two) &&
         reads(".csv", "x,y,z,r\n1,2,7,0.5\n3,4,7,0.25\n", two, of_dimension(2)) &&
         refuses(".csv", "x,y,z,r\n1,2,7,0.5\n3,4,8,0.25\n",
                 "3: z is '8', not as in the first row: not a set in two dimensions", of_dimension(2)) &&
         refuses(".csv", "x,y,r\n1,2,0.5\n", "1: no column z among 'x, y, r'", of_dimension(3));
}

bool reads_the_box() {
  return reads(".csv", "# box: -1 0 0.5 1 2 3 periodic 1 0 1\nx,y,z,r\n0,0,1,0.5\n",
               with_box(set_of(3, {0, 0, 1}, {0.5}), {-1, 0, 0.5}, {1, 2, 3}, {1, 0, 1})) &&
         reads(".csv", "# box: -1 0 0.5 1 2 3 periodic 1 0 1\nx,y,r\n0,0,0.5\n",
               with_box(set_of(2, {0, 0}, {0.5}), {-1, 0, 0}, {1, 2, 0}, {1, 0, 0})) &&
         reads(".csv", "# box: -1 0 0.5 1 2 3 periodic 1 1 0 tilt -0.5 1 2\nx,y,z,r\n0,0,1,0.5\n",
               with_tilt(with_box(set_of(3, {0, 0, 1}, {0.5}), {-1, 0, 0.5}, {1, 2, 3}, {1, 1, 0}), {-0.5, 1, 2})) &&
         reads(".csv", "# box: -1 0 0.5 1 2 3 periodic 1 1 0 tilt -0.5 1 2\nx,y,r\n0,0,0.5\n",
               with_tilt(with_box(set_of(2, {0, 0}, {0.5}), {-1, 0, 0}, {1, 2, 0}, {1, 1, 0}), {-0.5, 0, 0}));
}

// As numpy.savetxt and Yade leave them.
bool reads_names_in_a_comment() {
  const particles::ParticleSet two = set_of(3, {1, 2, 3, -4, 5e-3, 6}, {0.5, 0.25});
  const std::string rows = "1 2 3 0.5\n-4 5e-3 6 0.25\n";
  return reads(".csv", "# x y z r\n" + rows, two) &&
         reads(".any", "# a note on x and y\r\n# X, Y, Z, R\r\n" + rows, two) &&
         reads(".txt", "#x y z r\n1,2,3,.5\n-4,5e-3,6,.25\n", two) && reads(".any", "#format x_y_z_r\n" + rows, two) &&
         reads(".any", "#format x_y_z_r_attrs\n1\t2\t3\t0.5\t7\t8\n-4\t5e-3\t6\t.25\t7\t8\n", two) &&
         reads(".txt", "# species x y z r\nA 1 2 3 0.5\nB -4 5e-3 6 0.25\n", two) &&
         refuses(".csv", "# x y z r\n1,2,3\n",
                 "2: the first line must name the columns (such as x,y,z,radius), but it holds '1,2,3'");
}

bool reads_numbers_of_fortran() {
  return reads(".csv", "x,y,z,r\n1.0D0,2d+00,30.D-1,.5D0\n", set_of(3, {1, 2, 3}, {0.5})) &&
         refuses_each(".csv", {{"x,y,r\n1D,2,3\n", "2: '1D' in column 'x' is not a number"},
                               {"x,y,r\n1D2D3,2,3\n", "2: '1D2D3' in column 'x' is not a number"},
                               {"x,y,r\nD3,2,3\n", "2: 'D3' in column 'x' is not a number"},
                               {"x,y,r\ninfD3,2,3\n", "2: 'infD3' in column 'x' is not a number"},
                               {"x,y,r\n1D999,2,3\n", "2: '1D999' in column 'x' is out of the range of a double"}});
}

bool reads_names_in_any_case() {
  const particles::ParticleSet one = set_of(3, {1, 2, 3}, {0.5});
  return reads(".csv", "X,Y,Z,RADIUS\n1,2,3,0.5\n", one) &&
         reads(".csv", "x,y,z,radius,X,Radius\n1,2,3,0.5,8,9\n", one) &&
         refuses(".csv", "X,X,y,r\n1,2,3,4\n", "1: column 'x' is named twice");
}

bool reads_every_word_for_the_size() {
  const particles::ParticleSet one = set_of(3, {1, 2, 3}, {0.5});
  for (const char *name : {"radii", "Radius", "r", "R", "c_radius", "v_r", "f_radii", "d_radius"})
    if (!reads(".csv", std::string("x,y,z,") + name + "\n1,2,3,0.5\n", one)) return false;
  for (const char *name : {"diameter", "D", "diameters", "c_diameter", "v_d"})
    if (!reads(".csv", std::string("x,y,z,") + name + "\n1,2,3,1\n", one)) return false;
  return reads(".csv", "x,y,z,d,radius,r\n1,2,3,7,0.5,8\n", one) &&
         reads(".csv", "x,y,z,radius,diameter\n1,2,3,0.5,1.001\n", one) &&
         refuses(".csv", "x,y,z,radius,diameter\n1,2,3,0.5,0.5\n",
                 "2: the radius '0.5' is not half of the diameter '0.5': say which column to take (--radius or "
                 "--diameter)");
}

particles::ReadOptions with_radius(const char *radius) {
  particles::ReadOptions options;
  options.radius = radius;
  return options;
}

particles::ReadOptions with_types() {
  particles::ReadOptions options;
  options.type_radii = {{"1", 0.5}, {"B", 0.25}};
  return options;
}

bool reads_the_size_asked_for() {
  const particles::ParticleSet two = set_of(2, {1, 2, 3, 4}, {0.5, 0.25});
  particles::ReadOptions diameter;
  diameter.diameter = "size";
  return reads(".csv", "x,y,size,r\n1,2,.5,8\n3,4,.25,8\n", two, with_radius("SIZE")) &&
         reads(".csv", "x,y,size\n1,2,1\n3,4,0.5\n", two, diameter) &&
         reads(".csv", "x,y\n1,2\n3,4\n", set_of(2, {1, 2, 3, 4}, {0.5, 0.5}), with_radius("0.5")) &&
         reads(".csv", "x,y,r,type\n1,2,8,\"1\"\n3,4,8,B\n", two, with_types()) &&
         refuses(".csv", "x,y,r\n1,2,8\n", "1: no column 'size' among 'x, y, r'", with_radius("size")) &&
         refuses(".csv", "x,y,r\n1,2,8\n", "1: no column '-1' among 'x, y, r'", with_radius("-1")) &&
         refuses(".csv", "x,y,r\n1,2,8\n", "1: column 'x' cannot be a coordinate and the size", with_radius("x")) &&
         refuses(".csv", "x,y,r\n1,2,8\n",
                 "1: no column type, species or element among 'x, y, r' for the radii of types", with_types()) &&
         refuses(".csv", "x,y,type\n1,2,b\n", "2: no radius was given for the type 'b' but for '1, B'", with_types());
}

bool reads_under_other_names() {
  particles::ReadOptions options;
  options.header = {"x", "y", "r"};
  const particles::ParticleSet one = set_of(2, {1, 2}, {0.5});
  return reads(".any", "1 2 0.5\n", one, options) && reads(".csv", "a,b,c\n1,2,0.5\n", one, options) &&
         reads(".csv", "y,x,d\n1,2,0.5\n", one, options) &&
         refuses(".csv", "1,2,3,4\n", "1: 3 names of columns were given, 'x, y, r', but there are 4", options);
}

bool passes_over_the_box() {
  particles::ReadOptions options;
  options.needs_box = false;
  return reads(".csv", "# box: none\nx,y,r\n1,2,0.5\n", set_of(2, {1, 2}, {0.5}), options);
}

bool refuses_bad_boxes() {
  return refuses_each(
      ".csv",
      {{"# box: 0 0 0 1 1 periodic 1 0 1\n",
        "1: the box must be six numbers, periodic and three flags, then perhaps tilt and three numbers, but it is "
        "'# box: 0 0 0 1 1 periodic 1 0 1'"},
       {"# box: 0 0 0 1 1 1 periodic 1 0 1 tilt 0 0\n",
        "1: the box must be six numbers, periodic and three flags, then perhaps tilt and three numbers, but it is "
        "'# box: 0 0 0 1 1 1 periodic 1 0 1 tilt 0...'"},
       {"# box: 0 0 0 1 1 1 periodic 1 0 1 tilt 0 zero 0\n", "1: box: 'zero' is not a number"},
       {"# box: 0 0 0 1 1 one periodic 1 0 1\n", "1: box: 'one' is not a number"},
       {"# box: 0 0 0 1 -1 1 periodic 1 0 1\n", "1: box: the upper corner '-1' lies below the lower corner '0'"},
       {"# box: 0 0 0 1 1 1 periodic 1 yes 1\n", "1: box: the flag 'yes' is neither 0 nor 1"},
       {"# box: 0 0 0 1 1 1 periodic 1 1 1\n# box: 0 0 0 1 1 1 periodic 1 1 1\n", "2: a second box"}});
}

bool refuses_bad_headers() {
  return refuses_each(
      ".csv",
      {{"1,2,3,0.5\n", "1: the first line must name the columns (such as x,y,z,radius), but it holds '1,2,3,0.5'"},
       {"x,y,z\n1,2,3\n", "1: no column radius, r, diameter or d among 'x, y, z'"},
       {"x,z,r\n1,2,3\n", "1: no column y among 'x, z, r'"},
       {"x,y,z,r,x\n1,2,3,4,5\n", "1: column 'x' is named twice"},
       {"# nothing but this\n", "1: no line names the columns (such as x,y,z,radius)"}});
}

bool refuses_bad_values() {
  const std::string head = "x,y,z,radius\n0,0,0,1\n";
  return refuses_each(".csv", {{head + "0,abc,0,1\n", "3: 'abc' in column 'y' is not a number"},
                               {head + "0,0,nan,1\n", "3: 'nan' in column 'z' is not finite"},
                               {head + "-inf,0,0,1\n", "3: '-inf' in column 'x' is not finite"},
                               {head + "0,1e999,0,1\n", "3: '1e999' in column 'y' is out of the range of a double"},
                               {head + "0,0,0,-0.5\n", "3: '-0.5' in column 'radius' is negative"},
                               {head + "0,,0,1\n", "3: '' in column 'y' is not a number"},
                               {head + "0,1.5.2,0,1\n", "3: '1.5.2' in column 'y' is not a number"},
                               {head + "0,+-1,0,1\n", "3: '+-1' in column 'y' is not a number"}});
}

bool refuses_wrong_row_lengths() {
  return refuses(".csv", "x,y,z,r\n1,2,3\n", "2: 3 values in '1,2,3' where there should be 4") &&
         refuses(".csv", "x,y,z,r\n1,2,3,4,5\n", "2: 5 values in '1,2,3,4,5' where there should be 4") &&
         refuses(".txt", "x y z r\n1 2 3\n", "2: 3 values in '1 2 3' where there should be 4");
}

bool refuses_frames() {
  return refuses(".csv", "x,y,z,r\n1,2,3,4\n", " frame 2 of a CSV file, which has only one", of_frame(2));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(passes<reads_columns_in_any_order>),
      cmocka_unit_test(passes<reads_every_separator>),
      cmocka_unit_test(passes<reads_line_ends_comments_and_blank_lines>),
      cmocka_unit_test(passes<reads_two_dimensions>),
      cmocka_unit_test(passes<reads_the_box>),
      cmocka_unit_test(passes<reads_names_in_a_comment>),
      cmocka_unit_test(passes<reads_numbers_of_fortran>),
      cmocka_unit_test(passes<reads_names_in_any_case>),
      cmocka_unit_test(passes<reads_every_word_for_the_size>),
      cmocka_unit_test(passes<reads_the_size_asked_for>),
      cmocka_unit_test(passes<reads_under_other_names>),
      cmocka_unit_test(passes<passes_over_the_box>),
      cmocka_unit_test(passes<refuses_bad_boxes>),
      cmocka_unit_test(passes<refuses_bad_headers>),
      cmocka_unit_test(passes<refuses_bad_values>),
      cmocka_unit_test(passes<refuses_wrong_row_lengths>),
      cmocka_unit_test(passes<refuses_frames>),
  };
  return cmocka_run_group_tests_name("csv_reader", tests, nullptr, nullptr);
}
