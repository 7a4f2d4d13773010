// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Particles of files that hold arrays instead of rows, as those of VTK.
#include "particles/files/point_rows.hpp"

#include "particles/files/columns.hpp"
#include "particles/text/text_file.hpp"

#include <charconv>

namespace particles {
namespace {

void append_number(std::string &line, double number) {
  char digits[32];
  line.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
  line += ' ';
}

}  // namespace

ParticleSet particles_of_points(const std::string &file, const std::vector<double> &points,
                                const std::vector<PointArray> &arrays, const ReadOptions &options) {
  const size_t count = points.size() / 3;
  std::vector<const PointArray *> used;
  Columns columns;
  columns.names = {"x", "y", "z"};
  for (const PointArray &array : arrays) {
    if (array.values.size() != count * array.width) continue;
    used.push_back(&array);
    for (size_t n = 0; n < array.width; n++)
      columns.names.push_back(array.width == 1 ? array.name : array.name + "." + std::to_string(n));
  }
  const TextFile whole{file, {}}, each{file + ":point", {}};
  const LineCursor head(whole);
  rename_columns(head, columns, options);
  for (int axis = 0; axis < 3; axis++)
    columns.axis[axis] = options.header.empty() ? axis : find_column(head, columns, std::string(1, "xyz"[axis]));
  find_size(head, columns, options);
  find_further_columns(head, columns, options);
  ParticleSet particles;
  particles.dimension = settle_dimension(head, columns, options.dimension);
  LineCursor point(each);
  RowReader rows(point, columns, options, particles);
  std::string line;
  for (size_t k = 0; k < count; k++) {
    point.seek({0, k + 1});
    line.clear();
    for (size_t axis = 0; axis < 3; axis++) append_number(line, points[3 * k + axis]);
    for (const PointArray *array : used)
      for (size_t n = 0; n < array->width; n++) append_number(line, array->values[k * array->width + n]);
    rows.append(line);
  }
  return particles;
}

}  // namespace particles
