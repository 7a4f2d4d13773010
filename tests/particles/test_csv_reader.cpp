// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Reading CSV: what is accepted, and the message for each thing that is not.
#include "tests/particles/cmocka_cpp.hpp"
#include "tests/particles/reading.hpp"

using test::reads;
using test::refuses;
using test::set_of;
using test::with_box;

namespace {

void reads_columns_in_any_order(void **) {
  const particles::ParticleSet two = set_of(3, {1, 2, 3, -4, 5e-3, 6}, {0.5, 0.25});
  bool ok = reads(".csv", "x,y,z,r\n1,2,3,0.5\n-4,5e-3,6,0.25\n", two);
  assert_true(ok);
  ok = reads(".csv", "id,Radius,z,name,y,x\n7,0.5,3,a b,2,1\n8,.25,6,,+5E-3,-4\n", two);
  assert_true(ok);
  ok = reads(".csv", "x,y,z,diameter\n1,2,3,1\n-4,5e-3,6,0.5", two);
  assert_true(ok);
}

void reads_every_separator(void **) {
  const particles::ParticleSet one = set_of(3, {1, 2, 3}, {0.5});
  bool ok = reads(".csv", "x;y;z;d\n1;2; 3 ;1\n", one);
  assert_true(ok);
  ok = reads(".tsv", "x\ty\tz\tr\n1\t2\t3\t0.5\n", one);
  assert_true(ok);
  ok = reads(".txt", "  x y   z r \n 1   2 3 0.5  \n", one);
  assert_true(ok);
  ok = reads(".csv", "\"x\",\"y\",\"z\",\"radius\"\n1,2,3,0.5\n", one);
  assert_true(ok);
}

void reads_line_ends_comments_and_blank_lines(void **) {
  const particles::ParticleSet one = set_of(3, {1, 2, 3}, {0.5});
  bool ok = reads(".csv", "\xEF\xBB\xBFx,y,z,r\r\n1,2,3,0.5\r\n", one);
  assert_true(ok);
  ok = reads(".csv", "# a comment\n\nx,y,z,r\n  # one more\n1,2,3,0.5\n\n", one);
  assert_true(ok);
  ok = reads(".csv", "x,y,z,r\n", set_of(3, {}, {}));
  assert_true(ok);
}

void reads_two_dimensions(void **) {
  particles::ReadOptions flat;
  flat.dimension = 2;
  bool ok = reads(".csv", "x,y,r\n1,2,0.5\n3,4,0.25\n", set_of(2, {1, 2, 3, 4}, {0.5, 0.25}));
  assert_true(ok);
  ok = reads(".csv", "x,y,z,r\n1,2,7,0.5\n3,4,7,0.25\n", set_of(2, {1, 2, 3, 4}, {0.5, 0.25}), flat);
  assert_true(ok);
  ok = refuses(".csv", "x,y,z,r\n1,2,7,0.5\n3,4,8,0.25\n",
               "3: z is '8', not as in the first row: not a set in two dimensions", flat);
  assert_true(ok);
  particles::ReadOptions solid;
  solid.dimension = 3;
  ok = refuses(".csv", "x,y,r\n1,2,0.5\n", "1: no column z among 'x, y, r'", solid);
  assert_true(ok);
}

void reads_the_box(void **) {
  bool ok = reads(".csv", "# box: -1 0 0.5 1 2 3 periodic 1 0 1\nx,y,z,r\n0,0,1,0.5\n",
                  with_box(set_of(3, {0, 0, 1}, {0.5}), {-1, 0, 0.5}, {1, 2, 3}, {1, 0, 1}));
  assert_true(ok);
  ok = reads(".csv", "# box: -1 0 0.5 1 2 3 periodic 1 0 1\nx,y,r\n0,0,0.5\n",
             with_box(set_of(2, {0, 0}, {0.5}), {-1, 0, 0}, {1, 2, 0}, {1, 0, 0}));
  assert_true(ok);
  ok = refuses(".csv", "# box: 0 0 0 1 1 periodic 1 0 1\n",
               "1: the box must be six numbers, the word periodic and three flags, but the line is "
               "'# box: 0 0 0 1 1 periodic 1 0 1'");
  assert_true(ok);
  ok = refuses(".csv", "# box: 0 0 0 1 1 one periodic 1 0 1\n", "1: box: 'one' is not a number");
  assert_true(ok);
  ok = refuses(".csv", "# box: 0 0 0 1 -1 1 periodic 1 0 1\n",
               "1: box: the upper corner '-1' lies below the lower corner '0'");
  assert_true(ok);
  ok = refuses(".csv", "# box: 0 0 0 1 1 1 periodic 1 yes 1\n", "1: box: the flag 'yes' is neither 0 nor 1");
  assert_true(ok);
  ok = refuses(".csv", "# box: 0 0 0 1 1 1 periodic 1 1 1\n# box: 0 0 0 1 1 1 periodic 1 1 1\n", "2: a second box");
  assert_true(ok);
}

void refuses_bad_headers(void **) {
  bool ok = refuses(".csv", "1,2,3,0.5\n",
                    "1: the first line must name the columns (such as x,y,z,radius), but it holds '1,2,3,0.5'");
  assert_true(ok);
  ok = refuses(".csv", "x,y,z\n1,2,3\n", "1: no column radius, r, diameter or d among 'x, y, z'");
  assert_true(ok);
  ok = refuses(".csv", "x,z,r\n1,2,3\n", "1: no column y among 'x, z, r'");
  assert_true(ok);
  ok = refuses(".csv", "x,y,z,r,x\n1,2,3,4,5\n", "1: column 'x' is named twice");
  assert_true(ok);
  ok = refuses(".csv", "x,y,z,r,d\n1,2,3,4,8\n", "1: columns 'r' and 'd' both give the size");
  assert_true(ok);
  ok = refuses(".csv", "# nothing but this\n", "1: no line names the columns (such as x,y,z,radius)");
  assert_true(ok);
}

void refuses_bad_values(void **) {
  const std::string head = "x,y,z,radius\n0,0,0,1\n";
  bool ok = refuses(".csv", head + "0,abc,0,1\n", "3: 'abc' in column 'y' is not a number");
  assert_true(ok);
  ok = refuses(".csv", head + "0,0,nan,1\n", "3: 'nan' in column 'z' is not finite");
  assert_true(ok);
  ok = refuses(".csv", head + "-inf,0,0,1\n", "3: '-inf' in column 'x' is not finite");
  assert_true(ok);
  ok = refuses(".csv", head + "0,1e999,0,1\n", "3: '1e999' in column 'y' is out of the range of a double");
  assert_true(ok);
  ok = refuses(".csv", head + "0,0,0,-0.5\n", "3: '-0.5' in column 'radius' is negative");
  assert_true(ok);
  ok = refuses(".csv", head + "0,,0,1\n", "3: '' in column 'y' is not a number");
  assert_true(ok);
  ok = refuses(".csv", head + "0,1.5.2,0,1\n", "3: '1.5.2' in column 'y' is not a number");
  assert_true(ok);
  ok = refuses(".csv", head + "0,+-1,0,1\n", "3: '+-1' in column 'y' is not a number");
  assert_true(ok);
}

void refuses_wrong_row_lengths(void **) {
  bool ok = refuses(".csv", "x,y,z,r\n1,2,3\n", "2: 3 values in '1,2,3' where there should be 4");
  assert_true(ok);
  ok = refuses(".csv", "x,y,z,r\n1,2,3,4,5\n", "2: 5 values in '1,2,3,4,5' where there should be 4");
  assert_true(ok);
  ok = refuses(".txt", "x y z r\n1 2 3\n", "2: 3 values in '1 2 3' where there should be 4");
  assert_true(ok);
}

void refuses_frames(void **) {
  particles::ReadOptions second;
  second.frame = 2;
  const bool ok = refuses(".csv", "x,y,z,r\n1,2,3,4\n", " frame 2 of a CSV file, which has only one", second);
  assert_true(ok);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(reads_columns_in_any_order),
      cmocka_unit_test(reads_every_separator),
      cmocka_unit_test(reads_line_ends_comments_and_blank_lines),
      cmocka_unit_test(reads_two_dimensions),
      cmocka_unit_test(reads_the_box),
      cmocka_unit_test(refuses_bad_headers),
      cmocka_unit_test(refuses_bad_values),
      cmocka_unit_test(refuses_wrong_row_lengths),
      cmocka_unit_test(refuses_frames),
  };
  return cmocka_run_group_tests_name("csv_reader", tests, nullptr, nullptr);
}
