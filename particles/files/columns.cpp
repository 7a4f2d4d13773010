// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Which columns of a table hold the particles, and the rows read through them.
#include "particles/files/columns.hpp"

#include "particles/text/lists.hpp"
#include "particles/text/number.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <utility>

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

double number_in(const LineCursor &cursor, const Columns &columns, std::string_view field, int column) {
  double value = 0;
  const std::string_view text = columns.separator == kBlanks ? field : trimmed(field);
  if (const char *fault = number_fault(text, value))
    cursor.fail(in_quotes(text) + " in column " + in_quotes(columns.names[static_cast<size_t>(column)]) + " " + fault);
  return value;
}

int find_column(const LineCursor &cursor, const Columns &columns, std::string_view name) {
  for (const bool any_case : {false, true}) {
    int found = -1;
    for (size_t k = 0; k < columns.names.size(); k++) {
      if (columns.names[k] != name && !(any_case && lower_case(columns.names[k]) == lower_case(name))) continue;
      if (found >= 0) cursor.fail("column " + in_quotes(name) + " is named twice");
      found = static_cast<int>(k);
    }
    if (found >= 0) return found;
  }
  return -1;
}

void rename_columns(const LineCursor &cursor, Columns &columns, const ReadOptions &options) {
  if (options.header.empty()) return;
  if (options.header.size() != columns.names.size())
    cursor.fail(std::to_string(options.header.size()) + " names of columns were given, " +
                in_quotes(joined(options.header)) + ", but there are " + std::to_string(columns.names.size()));
  columns.names = options.header;
}

namespace {

int asked_column(const LineCursor &cursor, const Columns &columns, std::string_view name) {
  const int found = find_column(cursor, columns, name);
  if (found < 0) cursor.fail("no column " + in_quotes(name) + " among " + in_quotes(joined(columns.names)));
  return found;
}

// As a column or as a compute, variable, fix or property of LAMMPS.
int find_size_column(const LineCursor &cursor, const Columns &columns, std::string_view name) {
  for (const char *prefix : {"", "c_", "v_", "f_", "d_"}) {
    const int found = find_column(cursor, columns, std::string(prefix).append(name));
    if (found >= 0) return found;
  }
  return -1;
}

int first_column(const LineCursor &cursor, const Columns &columns, std::initializer_list<const char *> names) {
  int found = -1;
  for (const char *name : names)
    if (found < 0) found = find_size_column(cursor, columns, name);
  return found;
}

void find_type(const LineCursor &cursor, Columns &columns, const std::string &purpose) {
  for (const char *name : {"type", "species", "element"})
    if (columns.type < 0) columns.type = find_column(cursor, columns, name);
  if (columns.type < 0)
    cursor.fail("no column type, species or element among " + in_quotes(joined(columns.names)) + purpose);
}

// Whether the options tell the size.
bool take_asked_size(const LineCursor &cursor, Columns &columns, const ReadOptions &options) {
  if (!options.type_radii.empty()) {
    find_type(cursor, columns, " for the radii of types");
    return true;
  }
  if (!options.diameter.empty()) {
    columns.size = asked_column(cursor, columns, options.diameter);
    columns.is_diameter = true;
    return true;
  }
  if (options.radius.empty()) return false;
  const bool is_number = number_fault(options.radius, columns.radius) == nullptr && columns.radius >= 0;
  if (!is_number || find_column(cursor, columns, options.radius) >= 0)
    columns.size = asked_column(cursor, columns, options.radius);
  return true;
}

}  // namespace

void find_size(const LineCursor &cursor, Columns &columns, const ReadOptions &options) {
  if (take_asked_size(cursor, columns, options)) return;
  columns.size = first_column(cursor, columns, {"radius", "radii"});
  columns.diameter = first_column(cursor, columns, {"diameter", "diameters"});
  if (columns.size < 0 && columns.diameter < 0) {
    columns.size = first_column(cursor, columns, {"r"});
    columns.diameter = first_column(cursor, columns, {"d"});
  }
  if (columns.size >= 0) return;
  columns.is_diameter = true;
  columns.size = columns.diameter;
  columns.diameter = -1;
  if (columns.size < 0) cursor.fail("no column radius, r, diameter or d among " + in_quotes(joined(columns.names)));
}

int settle_dimension(const LineCursor &cursor, const Columns &columns, int asked) {
  for (int axis = 0; axis < (asked == 3 ? 3 : 2); axis++)
    if (columns.axis[axis] < 0)
      cursor.fail(std::string("no column ") + "xyz"[axis] + " among " + in_quotes(joined(columns.names)));
  if (asked != 0) return asked;
  return columns.axis[2] < 0 ? 2 : 3;
}

namespace {

// What a vector is called before the letter or number of its axis, and a number altogether.
struct Motion {
  const char *name;
  size_t width;
  std::initializer_list<const char *> stems;
};

const Motion kMotions[] = {{"velocity", 3, {"v", "velocity_", "velo.", "velocity.", "velocities.", "vel.", "v."}},
                           {"spin", 3, {"omega", "spin_", "spin.", "angular_velocity.", "omega."}},
                           {"mass", 1, {"mass"}},
                           {"material", 1, {"material"}}};
constexpr int kMotionCount = static_cast<int>(std::size(kMotions));

bool has_motion(const Columns &columns, int kind) {
  const int *axis = columns.motion[kind];
  return axis[0] >= 0 || axis[1] >= 0 || axis[2] >= 0;
}

// All components along axes that there are, else none.
void find_motion(const LineCursor &cursor, Columns &columns, int kind) {
  for (const std::string stem : kMotions[kind].stems) {
    if (kMotions[kind].width == 1) {
      columns.motion[kind][0] = find_column(cursor, columns, stem);
      continue;
    }
    const char *axes = stem.back() == '.' ? "012" : "xyz";
    int found[3];
    for (int axis = 0; axis < 3; axis++) found[axis] = find_column(cursor, columns, stem + axes[axis]);
    const bool is_plane = columns.axis[2] < 0;
    if (found[0] < 0 || found[1] < 0 || (found[2] < 0 && !(is_plane && kind == 0))) continue;
    std::copy_n(found, 3, columns.motion[kind]);
    return;
  }
}

}  // namespace

void find_further_columns(const LineCursor &cursor, Columns &columns, const ReadOptions &options) {
  if (options.ids) columns.id = asked_column(cursor, columns, "id");
  if (options.types && columns.type < 0) find_type(cursor, columns, "");
  for (int kind = 0; options.motion && kind < kMotionCount; kind++) find_motion(cursor, columns, kind);
}

RowReader::RowReader(const LineCursor &cursor, const Columns &columns, const ReadOptions &options,
                     ParticleSet &particles)
    : cursor_(cursor),
      columns_(columns),
      options_(options),
      particles_(particles),
      slot_of_column_(columns.names.size(), kUnused) {
  for (int axis = 0; axis < 3; axis++) take(columns.axis[axis], Slot(axis));
  take(columns.size, kSize);
  take(columns.diameter, kDiameter);
  take(columns.type, kType);
  take(columns.id, kId);
  for (int kind = 0; kind < kMotionCount; kind++) {
    for (int axis = 0; axis < 3; axis++) take(columns.motion[kind][axis], Slot(kMotion + 3 * kind + axis));
    if (has_motion(columns, kind)) particles.columns.push_back({kMotions[kind].name, kMotions[kind].width, {}});
  }
  if (!options.motion) return;
  for (size_t k = 0; k < columns.names.size(); k++)
    if (slot_of_column_[k] == kUnused) particles.unused.push_back(columns.names[k]);
}

void RowReader::take(int column, Slot slot) {
  if (column < 0) return;
  const auto place = static_cast<size_t>(column);
  if (slot_of_column_[place] != kUnused)
    cursor_.fail("column " + in_quotes(columns_.names[place]) + " cannot be a coordinate and the size");
  slot_of_column_[place] = slot;
}

void RowReader::append_further(const std::string_view (&fields)[kSlots]) {
  if (columns_.id >= 0) particles_.ids.emplace_back(without_quotes(trimmed(fields[kId])));
  if (options_.types) particles_.types.emplace_back(without_quotes(trimmed(fields[kType])));
  size_t place = 0;
  for (int kind = 0; kind < kMotionCount; kind++) {
    if (!has_motion(columns_, kind)) continue;
    std::vector<double> &values = particles_.columns[place++].values;
    for (size_t axis = 0; axis < kMotions[kind].width; axis++) {
      const int column = columns_.motion[kind][axis];
      const std::string_view field = column < 0 ? "0" : fields[static_cast<size_t>(kMotion + 3 * kind) + axis];
      // The mass of what nothing moves.
      const bool endless = kMotions[kind].width == 1 && trimmed(field) == "inf";
      values.push_back(endless ? HUGE_VAL : column < 0 ? 0 : number_in(cursor_, columns_, field, column));
    }
  }
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

double RowReader::size(std::string_view field, int column) const {
  const double value = number_in(cursor_, columns_, field, column);
  if (value < 0)
    cursor_.fail(in_quotes(trimmed(field)) + " in column " + in_quotes(columns_.names[static_cast<size_t>(column)]) +
                 " is negative");
  return value;
}

double RowReader::radius_of_type(std::string_view type) const {
  const auto found = options_.type_radii.find(type);
  if (found != options_.type_radii.end()) return found->second;
  std::string known;
  for (const auto &[name, radius] : options_.type_radii) known += (known.empty() ? "" : ", ") + name;
  cursor_.fail("no radius was given for the type " + in_quotes(type) + " but for " + in_quotes(known));
}

double RowReader::radius(const std::string_view (&fields)[kSlots]) const {
  if (!options_.type_radii.empty()) return radius_of_type(without_quotes(trimmed(fields[kType])));
  if (columns_.size < 0) return columns_.radius;
  const double value = size(fields[kSize], columns_.size);
  if (columns_.is_diameter) return value / 2;
  // Far more than rounding: the columns are not what their names say.
  constexpr double kSame = 0.01;
  if (columns_.diameter >= 0 && std::fabs(size(fields[kDiameter], columns_.diameter) / 2 - value) > kSame * value)
    cursor_.fail("the radius " + in_quotes(trimmed(fields[kSize])) + " is not half of the diameter " +
                 in_quotes(trimmed(fields[kDiameter])) + ": say which column to take (--radius or --diameter)");
  return value;
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
  const double size = radius(fields);
  append_center(fields);
  particles_.radii.push_back(size);
  append_further(fields);
}

}  // namespace particles
