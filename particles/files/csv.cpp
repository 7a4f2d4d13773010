// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Tables with a header line: CSV and its relatives. A header names the columns x, y, z (optional) and radius, r,
// diameter or d, in any order and among others; it may be a comment. Separators are commas, semicolons, tabs or blanks,
// as in the first line.
// Lines that begin with '#' are comments; the one that the writer leaves ("# box: ...") sets the box.
#include "particles/error.hpp"
#include "particles/files/columns.hpp"
#include "particles/files/header.hpp"
#include "particles/files/reader.hpp"
#include "particles/text/number.hpp"
#include "particles/text/output.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace particles {
namespace {

// Begins the comment line that holds the box: lower corner, upper corner, "periodic" and three flags, and where it is
// tilted "tilt" and xy, xz, yz.
constexpr char kBoxComment[] = "# box:";

bool names_axes(const std::vector<std::string> &names) { return has_name(names, {"x"}) && has_name(names, {"y"}); }

Header header_of_particles(bool known) { return {"x,y,z,radius", names_axes, known}; }

void find_columns(const LineCursor &cursor, const ReadOptions &options, Columns &columns) {
  rename_columns(cursor, columns, options);
  for (int axis = 0; axis < 3; axis++)
    columns.axis[axis] = find_column(cursor, columns, std::string_view("xyz").substr(static_cast<size_t>(axis), 1));
  find_size(cursor, columns, options);
  find_further_columns(cursor, columns, options);
}

// "# box: xmin ymin zmin xmax ymax zmax periodic 0 0 0", or so and "tilt xy xz yz".
void read_box(const LineCursor &cursor, std::string_view line, ParticleSet &particles) {
  const std::vector<std::string_view> words = split_words(line.substr(sizeof kBoxComment - 1));
  const bool is_tilted = words.size() == 14 && words[10] == "tilt";
  if ((words.size() != 10 && !is_tilted) || words[6] != "periodic")
    cursor.fail(
        "the box must be six numbers, periodic and three flags, then perhaps tilt and three numbers, but it is " +
        in_quotes(line));
  const auto read = [&](std::string_view word, double &number) {
    if (const char *fault = number_fault(word, number)) cursor.fail("box: " + in_quotes(word) + " " + fault);
  };
  for (size_t axis = 0; axis < 3; axis++) {
    read(words[axis], particles.box_min[axis]);
    read(words[axis + 3], particles.box_max[axis]);
    if (is_tilted) read(words[axis + 11], particles.tilt[axis]);
    if (particles.box_max[axis] < particles.box_min[axis])
      cursor.fail("box: the upper corner " + in_quotes(words[axis + 3]) + " lies below the lower corner " +
                  in_quotes(words[axis]));
    const std::string_view flag = words[axis + 7];
    if (flag != "0" && flag != "1") cursor.fail("box: the flag " + in_quotes(flag) + " is neither 0 nor 1");
    particles.periodic[axis] = flag == "1";
  }
  particles.has_box = true;
}

void take_box(const LineCursor &cursor, std::string_view line, const ReadOptions &options, ParticleSet &particles) {
  ParticleSet with_box = particles;
  try {
    read_box(cursor, line, with_box);
    particles = std::move(with_box);
  } catch (const Error &) {
    if (options.needs_box) throw;
  }
}

}  // namespace

bool names_columns(std::string_view text) {
  Header header = header_of_particles(false);
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    const std::string_view content = trimmed(line.substr(0, line.find_last_not_of('\r') + 1));
    const bool is_comment = !content.empty() && content.front() == '#';
    if (is_comment && header.take_comment(content)) return true;
    if (!content.empty() && !is_comment) return names_axes(names_in_line(content));
  }
  return false;
}

ParticleSet read_csv(const TextFile &file, const ReadOptions &options) {
  LineCursor cursor(file);
  ParticleSet particles;
  if (options.frame > 1)
    cursor.fail(0, "frame " + std::to_string(options.frame) + " of a CSV file, which has only one");
  Columns columns;
  Header header = header_of_particles(!options.header.empty());
  std::optional<RowReader> rows;
  std::string_view line;
  while (cursor.next(line)) {
    if (line.substr(0, sizeof kBoxComment - 1) == kBoxComment) {
      if (particles.has_box) cursor.fail("a second box");
      take_box(cursor, line, options, particles);
      continue;
    }
    const std::string_view content = trimmed(line);
    if (!content.empty() && content.front() == '#') header.take_comment(content);
    if (content.empty() || content.front() == '#') continue;
    if (rows) {
      rows->append(line);
      continue;
    }
    const bool has_values = header.take_line(cursor, line, columns);
    find_columns(cursor, options, columns);
    particles.dimension = settle_dimension(cursor, columns, options.dimension);
    rows.emplace(cursor, columns, options, particles);
    if (has_values) rows->append(line);
  }
  if (!rows) cursor.fail("no line names the columns (such as x,y,z,radius)");
  return particles;
}

namespace {

void write_box(Output &out, const ParticleSet &particles) {
  out << kBoxComment;
  for (const double corner : particles.box_min) out << ' ' << corner;
  for (const double corner : particles.box_max) out << ' ' << corner;
  out << " periodic";
  for (const int flag : particles.periodic) out << ' ' << flag;
  if (particles.is_tilted()) {
    out << " tilt";
    for (const double edge : particles.tilt) out << ' ' << edge;
  }
  out << '\n';
}

}  // namespace

void write_csv(Output &out, const ParticleSet &particles) {
  if (particles.has_box) write_box(out, particles);
  if (particles.moment) out << "# step: " << particles.moment->step << " time: " << particles.moment->time << '\n';
  const auto dimension = static_cast<size_t>(particles.dimension);
  out << (dimension == 3 ? "x,y,z,radius" : "x,y,radius");
  for (const Column &column : particles.columns) {
    for (size_t n = 0; n < column.width; n++) {
      out << ',' << column.name;
      if (column.width > 1) out << '_' << "xyz"[n];
    }
  }
  out << '\n';
  for (size_t k = 0; k < particles.count(); k++) {
    for (size_t axis = 0; axis < dimension; axis++) out << particles.centers[k * dimension + axis] << ',';
    out << particles.radii[k];
    for (const Column &column : particles.columns)
      for (size_t n = 0; n < column.width; n++) out << ',' << column.values[k * column.width + n];
    out << '\n';
  }
}

}  // namespace particles
