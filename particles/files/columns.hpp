// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Which columns of a table hold the particles, and the rows read through them.
#pragma once

#include "particles/particle_set.hpp"
#include "particles/text/text_file.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace particles {

constexpr char kBlanks = ' ';  // separator: any run of blanks and tabs

struct Columns {
  std::vector<std::string> names;  // of all columns, for messages
  char separator = kBlanks;        // or ',' ';' '\t'
  int axis[3] = {-1, -1, -1};      // the column of each coordinate; -1: the table has none
  int size = -1;                   // the column of the radius or diameter
  bool is_diameter = false;
  bool scaled[3] = {false, false, false};  // the coordinate counts in edges of the box from its lower corner

  // No more rows than this fit in so many bytes, whatever a file claims: a value and what ends it take two.
  size_t most_rows(size_t bytes) const { return bytes / (2 * names.size()) + 1; }
};

// The fields between separators.
std::vector<std::string_view> fields_of(std::string_view line, char separator);

// Names and separator as in the line that names the columns: quotes taken off, in lower case. Fails where that holds a
// number first, saying what it may look like.
Columns columns_named(const LineCursor &cursor, std::string_view header, const char *example);

// Reads the number in a field of a column. Fails naming both if it is none.
double number_in(const LineCursor &cursor, const Columns &columns, std::string_view field, int column);

// Finds the radius ("r", "radius") or diameter ("d", "diameter") among lower-case names. Fails at the cursor's line if
// there is none or more than one.
void find_size_column(const LineCursor &cursor, Columns &columns);

// The column called `name`, -1 if there is none. Fails at the cursor's line if there are two.
int find_column(const LineCursor &cursor, const Columns &columns, std::string_view name);

// Settles the dimension of what is read: `asked` (0: as many axes as the table has). Fails if an axis is missing.
int settle_dimension(const LineCursor &cursor, const Columns &columns, int asked);

// Reads rows into a set whose dimension and box are set.
class RowReader {
 public:
  // `cursor` and `particles` must outlive the reader.
  RowReader(const LineCursor &cursor, const Columns &columns, ParticleSet &particles);

  // Appends the particle of one row, the cursor's line. Fails naming column and value.
  void append(std::string_view line);

 private:
  enum Slot { kX, kY, kZ, kSize, kSlots, kUnused };

  size_t split(std::string_view line, std::string_view (&fields)[kSlots]) const;
  double place(const double (&values)[3], int axis) const;
  void append_center(const std::string_view (&fields)[kSlots]);

  const LineCursor &cursor_;
  const Columns &columns_;
  ParticleSet &particles_;
  std::vector<Slot> slot_of_column_;
  bool has_plane_ = false;
  double plane_ = 0;  // the z of all rows, where z is left out
};

}  // namespace particles
