// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Files of tabulated sizes: what they mean, and what is refused with which words.
#include "packing/size_law.hpp"
#include "packing/sizes/table.hpp"
#include "tests/support/frame.h"
#include "tests/support/refusal.hpp"

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

using packing::Measure;
using packing::SizeTable;

class File {
 public:
  explicit File(const std::string &text) { std::ofstream(path) << text; }
  ~File() { std::filesystem::remove(path); }
  File(const File &) = delete;
  File &operator=(const File &) = delete;

  const std::string path =
      (std::filesystem::temp_directory_path() / ("hgrid-test-sizes-" + std::to_string(getpid()) + ".csv")).string();
};

SizeTable read(const std::string &text) {
  const File file(text);
  return packing::read_size_table(file.path);
}

bool holds(const SizeTable &table, Measure measure, const std::vector<packing::Knot> &knots) {
  bool is_same = table.measure == measure && table.knots.size() == knots.size();
  for (size_t k = 0; is_same && k < knots.size(); k++)
    is_same = table.knots[k].radius == knots[k].radius && table.knots[k].share == knots[k].share;
  return is_same;
}

void what_columns_mean(void **) {
  assert_true(holds(read("# sieves\ndiameter,passing\n1,0\n\n2,25\n# wide\n4,100\n"), Measure::kVolume,
                    {{0.5, 0}, {1, 0.25}, {2, 1}}));
  assert_true(holds(read("Note;Volume;R\na;0.5;3\nb;1;4\n"), Measure::kVolume, {{3, 0.5}, {4, 1}}));
  assert_true(holds(read("number radius\n0 1\n50 2\n50 3\n100 5\n100 7"), Measure::kNumber,
                    {{1, 0}, {2, 0.5}, {3, 0.5}, {5, 1}, {7, 1}}));
  assert_true(holds(read("# number of sieves\n# Diameter passing\n# 1 mm\n1.0D0 0\n+4 1D2"), Measure::kVolume,
                    {{0.5, 0}, {2, 1}}));
}

// What is said about a faulty file, without its path.
bool is_refused(const std::string &text, const std::string &expected) {
  const File file(text);
  const std::string what = test::error_of([&] { packing::read_size_table(file.path); });
  if (what == file.path + expected) return true;
  std::fprintf(stderr, "refused with: %s\n", what.c_str());
  return false;
}

void faults_are_named_by_line_and_value(void **) {
  const std::string head = "d,passing\n";
  assert_true(is_refused(head + "1,0\n2,30\n4,29\n8,100\n", ":4: '29' in column 'passing' is below 30 before it"));
  assert_true(is_refused(head + "-1,0\n2,100\n", ":2: '-1' in column 'd' is not above 0"));
  assert_true(is_refused(head + "0,0\n2,100\n", ":2: '0' in column 'd' is not above 0"));
  assert_true(is_refused(head + "4,0\n2,100\n", ":3: '2' in column 'd' is not above 4 before it"));
  assert_true(is_refused(head + "2,0\n2,100\n", ":3: '2' in column 'd' is not above 2 before it"));
  assert_true(is_refused(head + "1,-3\n2,100\n", ":2: '-3' in column 'passing' is negative"));
  assert_true(is_refused(head + "1,0\n2,97\n", ":3: the last share in column 'passing' is 97, not 100 (percent) or 1"));
  assert_true(is_refused(head + "1,x\n2,100\n", ":2: 'x' in column 'passing' is not a number"));
  assert_true(is_refused(head + "1\n", ":2: 1 values in '1' where there should be 2"));
  assert_true(is_refused(head + "1,0,\n", ":2: 3 values in '1,0,' where there should be 2"));
  assert_true(is_refused(head + "1,100\n", ":2: a distribution needs two sizes or more"));
  assert_true(is_refused(head + "1,100\n2,100\n", ":3: nothing lies between the sizes: all shares are equal"));
}

void faults_of_columns_are_named(void **) {
  assert_true(is_refused("1,0\n2,100\n",
                         ":1: the first line must name the columns (such as diameter,passing), but it holds '1,0'"));
  assert_true(is_refused("#\n", ":1: no line names the columns (such as diameter,passing)"));
  assert_true(is_refused("d,retained\n", ":1: no column passing, volume or number among 'd, retained'"));
  assert_true(is_refused("d,passing,number\n", ":1: columns 'passing' and 'number' both give the share"));
  assert_true(is_refused("D,Passing,NUMBER\n", ":1: columns 'Passing' and 'NUMBER' both give the share"));
  assert_true(is_refused("radius,diameter,passing\n", ":1: columns 'radius' and 'diameter' both give the size"));
  assert_true(is_refused("# d passing\n1 0 3\n",
                         ":2: the first line must name the columns (such as diameter,passing), but it holds '1 0 3'"));
  assert_true(is_refused("sieve,passing\n", ":1: no column radius, r, diameter or d among 'sieve, passing'"));
  assert_true(is_refused("d,d,passing\n", ":1: column 'd' is named twice"));
  assert_true(is_refused("", ": the file is empty"));
}

void only_tables_take_a_file(void **) {
  const File file("diameter,passing\n1,0\n3,100\n");
  packing::SizeLaw mono = packing::usual_law("mono"), table = packing::usual_law("table");
  assert_string_equal(packing::set_sizes(mono, file.path).c_str(), "is for table, not for the law mono");
  assert_string_equal(packing::set_sizes(table, file.path).c_str(), "");
  assert_string_equal(packing::law_fault(table, 1).c_str(), "");
  table.from = 3;
  assert_string_equal(packing::law_fault(table, 1).c_str(), "sizes are taken from below the largest, 3, not from 3");
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(what_columns_mean),
      cmocka_unit_test(faults_are_named_by_line_and_value),
      cmocka_unit_test(faults_of_columns_are_named),
      cmocka_unit_test(only_tables_take_a_file),
  };
  return cmocka_run_group_tests_name("size_table", tests, nullptr, nullptr);
}
