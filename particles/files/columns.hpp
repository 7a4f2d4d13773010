// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Which columns of a table hold the particles, and the rows read through them.
#pragma once

#include "particles/files/reader.hpp"
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
  int size = -1;                   // the column of the radius or diameter; -1: another tells it
  bool is_diameter = false;
  int diameter = -1;  // beside a radius: must be twice as long
  int id = -1;
  int type = -1;  // the column on which ReadOptions::type_radii is looked up
  // Of what belongs to the motion: velocity, spin, mass, material; of the last two only the first.
  int motion[4][3] = {{-1, -1, -1}, {-1, -1, -1}, {-1, -1, -1}, {-1, -1, -1}};
  double radius = 0;                       // of all particles, where no column tells it
  bool scaled[3] = {false, false, false};  // the coordinate counts in edges of the box from its lower corner

  // No more rows than this fit in so many bytes, whatever a file claims: a value and what ends it take two.
  size_t most_rows(size_t bytes) const { return bytes / (2 * names.size()) + 1; }
};

// The fields between separators, without blanks around them.
std::vector<std::string_view> fields_of(std::string_view line, char separator);

// Reads the number in a field of a column. Fails naming both if it is none.
double number_in(const LineCursor &cursor, const Columns &columns, std::string_view field, int column);

// The names of the columns are those asked for (ReadOptions::header), if any. Fails if they are of another number.
void rename_columns(const LineCursor &cursor, Columns &columns, const ReadOptions &options);

// Finds what tells the size: what the options name, else a radius ("radius", "radii", "r") or a diameter, also as a
// variable of LAMMPS ("c_radius"). Whole words come before letters. Fails at the cursor's line if there is none.
void find_size(const LineCursor &cursor, Columns &columns, const ReadOptions &options);

// Finds what belongs to the motion, and ids and types, as far as the options ask for them. Fails at the cursor's line
// where ids or types are missing.
void find_further_columns(const LineCursor &cursor, Columns &columns, const ReadOptions &options);

// The column called `name`, -1 if there is none: spelled so, else whatever the case. Fails at the cursor's line if
// there are two.
int find_column(const LineCursor &cursor, const Columns &columns, std::string_view name);

// Settles the dimension of what is read: `asked` (0: as many axes as the table has). Fails if an axis is missing.
int settle_dimension(const LineCursor &cursor, const Columns &columns, int asked);

// Reads rows into a set whose dimension and box are set.
class RowReader {
 public:
  // All must outlive the reader.
  RowReader(const LineCursor &cursor, const Columns &columns, const ReadOptions &options, ParticleSet &particles);

  // Appends the particle of one row, the cursor's line. Fails naming column and value.
  void append(std::string_view line);

 private:
  enum Slot { kX, kY, kZ, kSize, kDiameter, kType, kId, kMotion, kSlots = kMotion + 12, kUnused };

  size_t split(std::string_view line, std::string_view (&fields)[kSlots]) const;
  double size(std::string_view field, int column) const;
  double radius(const std::string_view (&fields)[kSlots]) const;
  double radius_of_type(std::string_view type) const;
  double place(const double (&values)[3], int axis) const;
  void take(int column, Slot slot);
  void append_further(const std::string_view (&fields)[kSlots]);
  void append_center(const std::string_view (&fields)[kSlots]);

  const LineCursor &cursor_;
  const Columns &columns_;
  const ReadOptions &options_;
  ParticleSet &particles_;
  std::vector<Slot> slot_of_column_;
  bool has_plane_ = false;
  double plane_ = 0;  // the z of all rows, where z is left out
};

}  // namespace particles
