// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Which columns of a table hold the particles, and the rows read through them.
#include "particles/files/columns.hpp"

#include "particles/text/lists.hpp"
#include "particles/text/number.hpp"

#include <algorithm>
#include <cmath>

namespace particles {
namespace {

// The end of the field that starts at `first`.
size_t field_end(std::string_view line, size_t first, char separator) {
  if (separator != kBlanks) return std::min(line.find(separator, first), line.size());
  while (first < line.size() && line[first] != ' ' && line[first] != '\t') first++;
  return first;
}

size_t skip_blanks(std::string_view line, size_t first) {
  while (first < line.size() && (line[first] == ' ' || line[first] == '\t')) first++;
  return first;
}

char separator_of(std::string_view header) {
  for (const char letter : {',', ';', '\t'})
    if (header.find(letter) != std::string_view::npos) return letter;
  return kBlanks;
}

std::string_view without_quotes(std::string_view name) {
  if (name.size() >= 2 && name.front() == '"' && name.back() == '"') return name.substr(1, name.size() - 2);
  return name;
}

}  // namespace

std::vector<std::string_view> fields_of(std::string_view line, char separator) {
  if (separator == kBlanks) return split_words(line);
  std::vector<std::string_view> fields;
  for (size_t first = 0; first <= line.size();) {
    const size_t last = field_end(line, first, separator);
    fields.push_back(trimmed(line.substr(first, last - first)));
    first = last + 1;
  }
  return fields;
}

Columns columns_named(const LineCursor &cursor, std::string_view header, const char *example) {
  Columns columns;
  columns.separator = separator_of(header);
  for (const std::string_view name : fields_of(header, columns.separator))
    columns.names.push_back(lower_case(without_quotes(name)));
  double value = 0;
  if (number_fault(columns.names.front(), value) == nullptr)
    cursor.fail(std::string("the first line must name the columns (such as ") + example + "), but it holds " +
                in_quotes(header));
  return columns;
}

double number_in(const LineCursor &cursor, const Columns &columns, std::string_view field, int column) {
  double value = 0;
  const std::string_view text = columns.separator == kBlanks ? field : trimmed(field);
  if (const char *fault = number_fault(text, value))
    cursor.fail(in_quotes(text) + " in column " + in_quotes(columns.names[static_cast<size_t>(column)]) + " " + fault);
  return value;
}

int find_column(const LineCursor &cursor, const Columns &columns, std::string_view name) {
  int found = -1;
  for (size_t k = 0; k < columns.names.size(); k++) {
    if (columns.names[k] != name) continue;
    if (found >= 0) cursor.fail("column " + in_quotes(name) + " is named twice");
    found = static_cast<int>(k);
  }
  return found;
}

void find_size_column(const LineCursor &cursor, Columns &columns) {
  for (const char *name : {"r", "radius", "d", "diameter"}) {
    const int found = find_column(cursor, columns, name);
    if (found < 0) continue;
    if (columns.size >= 0)
      cursor.fail("columns " + in_quotes(columns.names[static_cast<size_t>(columns.size)]) + " and " + in_quotes(name) +
                  " both give the size");
    columns.size = found;
    columns.is_diameter = name[0] == 'd';
  }
  if (columns.size < 0) cursor.fail("no column radius, r, diameter or d among " + in_quotes(joined(columns.names)));
}

int settle_dimension(const LineCursor &cursor, const Columns &columns, int asked) {
  for (int axis = 0; axis < (asked == 3 ? 3 : 2); axis++)
    if (columns.axis[axis] < 0)
      cursor.fail(std::string("no column ") + "xyz"[axis] + " among " + in_quotes(joined(columns.names)));
  if (asked != 0) return asked;
  return columns.axis[2] < 0 ? 2 : 3;
}

RowReader::RowReader(const LineCursor &cursor, const Columns &columns, ParticleSet &particles)
    : cursor_(cursor), columns_(columns), particles_(particles), slot_of_column_(columns.names.size(), kUnused) {
  for (int axis = 0; axis < 3; axis++)
    if (columns.axis[axis] >= 0) slot_of_column_[static_cast<size_t>(columns.axis[axis])] = Slot(axis);
  slot_of_column_[static_cast<size_t>(columns.size)] = kSize;
}

size_t RowReader::split(std::string_view line, std::string_view (&fields)[kSlots]) const {
  const char separator = columns_.separator;
  const size_t expected = slot_of_column_.size();
  size_t count = 0;
  size_t first = separator == kBlanks ? skip_blanks(line, 0) : 0;
  while (separator != kBlanks || first < line.size()) {
    const size_t last = field_end(line, first, separator);
    if (count < expected && slot_of_column_[count] != kUnused)
      fields[slot_of_column_[count]] = line.substr(first, last - first);
    count++;
    if (last >= line.size()) break;
    first = separator == kBlanks ? skip_blanks(line, last) : last + 1;
  }
  return count;
}

// Scaled coordinates count edges of the box, of which those of later axes may lean over.
double RowReader::place(const double (&values)[3], int axis) const {
  if (!columns_.scaled[axis]) return values[axis];
  const double low = particles_.box_min[axis], high = particles_.box_max[axis], *tilt = particles_.tilt;
  double along = values[axis] * (high - low);
  if (axis == 0) along += values[1] * tilt[0] + values[2] * tilt[1];
  if (axis == 1) along += values[2] * tilt[2];
  if (!std::isfinite(low + along))
    cursor_.fail(in_quotes(text(values[axis])) + " times the box length is out of the range of a double");
  return low + along;
}

void RowReader::append_center(const std::string_view (&fields)[kSlots]) {
  double values[3] = {0, 0, 0};
  for (int axis = 0; axis < 3; axis++)
    if (columns_.axis[axis] >= 0) values[axis] = number_in(cursor_, columns_, fields[axis], columns_.axis[axis]);
  for (int axis = 0; axis < particles_.dimension; axis++) particles_.centers.push_back(place(values, axis));
  if (particles_.dimension == 3 || columns_.axis[2] < 0) return;
  const double z = place(values, kZ);
  if (!has_plane_) plane_ = z;
  has_plane_ = true;
  if (z != plane_)
    cursor_.fail("z is " + in_quotes(fields[kZ]) + ", not as in the first row: not a set in two dimensions");
}

void RowReader::append(std::string_view line) {
  std::string_view fields[kSlots];
  const size_t count = split(line, fields);
  if (count != slot_of_column_.size())
    cursor_.fail(std::to_string(count) + " values in " + in_quotes(line) + " where there should be " +
                 std::to_string(slot_of_column_.size()));
  const double size = number_in(cursor_, columns_, fields[kSize], columns_.size);
  if (size < 0)
    cursor_.fail(in_quotes(trimmed(fields[kSize])) + " in column " +
                 in_quotes(columns_.names[static_cast<size_t>(columns_.size)]) + " is negative");
  append_center(fields);
  particles_.radii.push_back(columns_.is_diameter ? size / 2 : size);
}

}  // namespace particles
