// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The line that names the columns of a table: the first that is no comment, or a comment before it.
#pragma once

#include "particles/files/columns.hpp"
#include "particles/text/text_file.hpp"

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace particles {

// The names in a line, as they are spelled; its separator is a comma, a semicolon, a tab or blanks.
std::vector<std::string> names_in_line(std::string_view line);

// Whether one of `wanted`, in lower case, is among the names, whatever their case.
bool has_name(const std::vector<std::string> &names, std::initializer_list<const char *> wanted);

class Header {
 public:
  // Tells whether names are those of the table and not words or values.
  using Test = bool (*)(const std::vector<std::string> &names);

  // `example` is what a header may look like. Where the names are `known`, the file need not tell them.
  Header(const char *example, Test names_table, bool known = false)
      : example_(example), names_table_(names_table), known_(known) {}

  // Takes a comment before the rows. Whether it names the columns, as numpy.savetxt ("# x y z r") and Yade
  // ("#format x_y_z_r") leave them.
  bool take_comment(std::string_view line);

  // Takes the first line that is no comment. Whether it is already one of values; fails if nothing tells their names.
  bool take_line(const LineCursor &cursor, std::string_view line, Columns &columns);

 private:
  bool is_row(const std::vector<std::string> &fields) const;

  const char *example_;
  Test names_table_;
  bool known_, is_open_ = false;
  std::vector<std::string> comment_;  // the names in it
};

}  // namespace particles
