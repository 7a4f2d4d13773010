// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Extended XYZ: a count, a line of key=value, one row for each particle; one or several frames. Properties must name
// pos and radius (or r, diameter, d); Lattice, pbc and Origin set the box. The Lattice is that of hg_grid_def: its
// first edge along x, its second without z. As usual for the format, a Lattice without pbc is periodic on all axes.
#include "particles/files/columns.hpp"
#include "particles/files/reader.hpp"
#include "particles/files/row_writer.hpp"
#include "particles/files/xyz_keys.hpp"
#include "particles/text/number.hpp"
#include "particles/text/output.hpp"

#include <algorithm>
#include <cmath>

namespace particles {
namespace {

// The words of a list, with blanks or commas between.
std::vector<std::string> list(std::string text) {
  std::replace(text.begin(), text.end(), ',', ' ');
  const std::vector<std::string_view> words = split_words(text);
  return {words.begin(), words.end()};
}

std::vector<double> numbers(const LineCursor &cursor, const std::string &key, const std::string &text, size_t count) {
  std::vector<double> values;
  for (const std::string &word : list(text)) {
    values.push_back(0);
    if (const char *fault = number_fault(word, values.back())) cursor.fail(key + ": " + in_quotes(word) + " " + fault);
  }
  if (values.size() != count)
    cursor.fail(key + " must hold " + std::to_string(count) + " numbers, but it is " + in_quotes(text));
  return values;
}

// Beside the longest edge an off-diagonal this short is what is left of the cosine of a right angle.
constexpr double kRounding = 1e-12;

void drop_rounding(std::vector<double> &edges) {
  const double longest = std::max({std::fabs(edges[0]), std::fabs(edges[4]), std::fabs(edges[8])});
  for (const size_t beside : {1, 2, 3, 5, 6, 7})
    if (std::fabs(edges[beside]) <= kRounding * longest) edges[beside] = 0;
}

void read_lattice(const LineCursor &cursor, const std::string &text, const XyzKeys &keys, const ReadOptions &options,
                  ParticleSet &box) {
  std::vector<double> edges = numbers(cursor, "Lattice", text, 9);
  drop_rounding(edges);
  std::vector<double> origin(3, 0.0);
  if (const std::string *found = keys.find(cursor, "Origin")) origin = numbers(cursor, "Origin", *found, 3);
  const bool is_turned = edges[1] != 0 || edges[2] != 0 || edges[5] != 0;
  const bool is_negative = edges[0] < 0 || edges[4] < 0 || edges[8] < 0;
  if (!options.needs_box && (is_turned || is_negative)) return;
  if (is_turned)
    cursor.fail("the cell must be lower triangular ('ax 0 0 bx by 0 cx cy cz'), but the Lattice is " + in_quotes(text));
  if (is_negative) cursor.fail("the Lattice " + in_quotes(text) + " has a negative edge");
  for (size_t axis = 0; axis < 3; axis++) {
    box.box_min[axis] = origin[axis];
    box.box_max[axis] = origin[axis] + edges[4 * axis];
  }
  box.tilt[0] = edges[3];
  box.tilt[1] = edges[6];
  box.tilt[2] = edges[7];
  box.has_box = true;
}

bool is_true(const LineCursor &cursor, const std::string &word) {
  const std::string flag = lower_case(word);
  const bool is_periodic = flag == "t" || flag == "true" || flag == "1";
  if (!is_periodic && flag != "f" && flag != "false" && flag != "0")
    cursor.fail("pbc: the flag " + in_quotes(word) + " is neither T nor F");
  return is_periodic;
}

void read_box(const LineCursor &cursor, const XyzKeys &keys, const ReadOptions &options, ParticleSet &box) {
  const std::string *lattice = keys.find(cursor, "Lattice"), *pbc = keys.find(cursor, "pbc");
  if (lattice != nullptr) {
    read_lattice(cursor, *lattice, keys, options, box);
    std::fill_n(box.periodic, 3, 1);
  }
  if (pbc == nullptr) return;
  std::vector<std::string> flags = list(*pbc);
  if (flags.size() == 1) flags.resize(3, flags.front());
  if (flags.size() != 3) cursor.fail("pbc must hold three flags, or one for all axes, but it is " + in_quotes(*pbc));
  for (size_t axis = 0; axis < 3; axis++) {
    box.periodic[axis] = is_true(cursor, flags[axis]);
    if (box.periodic[axis] && lattice == nullptr && options.needs_box)
      cursor.fail("pbc has a periodic axis, but there is no Lattice");
  }
}

// Properties=species:S:1:pos:R:3:radius:R:1
Columns read_properties(const LineCursor &cursor, const std::string &properties) {
  Columns columns;
  std::string_view text = properties;
  while (!text.empty()) {
    std::string_view part[3];
    for (std::string_view &piece : part) {
      piece = text.substr(0, text.find(':'));
      text.remove_prefix(std::min(piece.size() + 1, text.size()));
    }
    const std::string name(part[0]);
    size_t width = 0;
    if (name.empty() || !read_count(part[2], width) || width == 0 || width > 1000)
      cursor.fail("Properties must be name:type:columns:..., but it is " + in_quotes(properties));
    if (lower_case(name) == "pos") {
      if (width != 2 && width != 3) cursor.fail("pos must have 2 or 3 columns, not " + in_quotes(part[2]));
      for (size_t axis = 0; axis < width; axis++) {
        columns.axis[axis] = static_cast<int>(columns.names.size());
        columns.names.emplace_back(1, "xyz"[axis]);
      }
    } else {
      columns.names.insert(columns.names.end(), width == 1 ? 1 : 0, name);
      for (size_t k = 0; width > 1 && k < width; k++) columns.names.push_back(name + "." + std::to_string(k));
    }
  }
  return columns;
}

// Without Properties the rows are those of plain XYZ, in which nothing tells the size.
Columns read_columns(const LineCursor &cursor, const XyzKeys &keys, const ReadOptions &options) {
  const std::string *properties = keys.find(cursor, "Properties");
  const bool is_told = !options.header.empty() || !options.radius.empty() || !options.type_radii.empty();
  if (properties == nullptr && !is_told) cursor.fail("no Properties=... that names pos and radius");
  Columns columns;
  if (properties != nullptr) {
    columns = read_properties(cursor, *properties);
    rename_columns(cursor, columns, options);
  } else {
    columns.names = options.header.empty() ? std::vector<std::string>{"species", "x", "y", "z"} : options.header;
  }
  const bool is_named = properties == nullptr || !options.header.empty();
  for (int axis = 0; is_named && axis < 3; axis++)
    columns.axis[axis] = find_column(cursor, columns, std::string(1, "xyz"[axis]));
  if (columns.axis[0] < 0 && !is_named) cursor.fail("Properties " + in_quotes(*properties) + " does not name pos");
  find_size(cursor, columns, options);
  find_further_columns(cursor, columns, options);
  return columns;
}

[[noreturn]] void fail_short(const LineCursor &cursor, size_t got, size_t count) {
  cursor.fail("the file ends here with " + std::to_string(got) + " of " + std::to_string(count) + " particles");
}

// The start of the frame asked for, or of the last.
LineCursor::Position find_frame(LineCursor &cursor, long asked) {
  LineCursor::Position start = cursor.position(), chosen = start;
  long found = 0;
  std::string_view line;
  for (; cursor.next(line); start = cursor.position()) {
    if (trimmed(line).empty() && found > 0) continue;
    size_t count = 0;
    if (!read_count(trimmed(line), count))
      cursor.fail("the number of particles should stand here, not " + in_quotes(line));
    chosen = start;
    if (++found == asked) break;
    cursor.expect("the line of keys");
    const size_t got = cursor.skip(count);
    if (got < count) fail_short(cursor, got, count);
  }
  if (found < asked) cursor.fail("frame " + std::to_string(asked) + " of a file with " + std::to_string(found));
  return chosen;
}

}  // namespace

ParticleSet read_xyz(const TextFile &file, const ReadOptions &options) {
  LineCursor cursor(file);
  cursor.seek(find_frame(cursor, options.frame));
  size_t count = 0;
  const std::string_view first = trimmed(cursor.expect("the number of particles"));
  if (!read_count(first, count)) cursor.fail("the number of particles should stand here, not " + in_quotes(first));
  const XyzKeys keys(cursor, cursor.expect("the line of keys"));
  const Columns columns = read_columns(cursor, keys, options);
  ParticleSet particles;
  read_box(cursor, keys, options, particles);
  particles.dimension = settle_dimension(cursor, columns, options.dimension);
  const size_t expected = std::min(count, columns.most_rows(cursor.bytes_left()));
  particles.centers.reserve(expected * static_cast<size_t>(particles.dimension));
  particles.radii.reserve(expected);
  RowReader rows(cursor, columns, options, particles);
  std::string_view line;
  for (size_t k = 0; k < count; k++) {
    if (!cursor.next(line)) fail_short(cursor, k, count);
    rows.append(line);
  }
  return particles;
}

namespace {

void write_box(Output &out, const ParticleSet &particles) {
  const double *low = particles.box_min, *high = particles.box_max, *tilt = particles.tilt;
  out << "Lattice=\"" << high[0] - low[0] << " 0 0 " << tilt[0] << ' ' << high[1] - low[1] << " 0 " << tilt[1] << ' '
      << tilt[2] << ' ' << high[2] - low[2] << "\" ";
  out << "Origin=\"" << low[0] << ' ' << low[1] << ' ' << low[2] << "\" ";
}

// As ASE and OVITO call them.
std::string_view property_name(std::string_view name) {
  return name == "velocity" ? "velo" : name == "spin" ? "angular_velocity" : name;
}

}  // namespace

std::string loss_in_xyz(const ParticleSet &particles) {
  for (int axis = 0; axis < 3; axis++) {
    const double low = particles.box_min[axis], high = particles.box_max[axis];
    if (particles.periodic[axis] && low + (high - low) != high)
      return std::string("extended XYZ stores a corner and an edge, which cannot hold the periodic box on axis ") +
             "xyz"[axis] + " exactly; write CSV or a LAMMPS dump";
  }
  const double *low = particles.box_min, *high = particles.box_max;
  const double longest = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  for (const double edge : particles.tilt)
    if (edge != 0 && std::fabs(edge) <= kRounding * longest)
      return "extended XYZ cannot hold a tilt as small as rounding; write CSV or a LAMMPS dump";
  return "";
}

void write_xyz(Output &out, const ParticleSet &particles) {
  out << particles.count() << '\n';
  if (particles.has_box) write_box(out, particles);
  out << "Properties=species:S:1:pos:R:3:radius:R:1";
  for (const Column &column : particles.columns) out << ':' << property_name(column.name) << ":R:" << column.width;
  if (particles.moment) out << " Time=" << particles.moment->time;
  out << " pbc=\"";
  for (int axis = 0; axis < 3; axis++) out << (axis > 0 ? " " : "") << (particles.periodic[axis] ? 'T' : 'F');
  out << "\"\n";
  for (size_t k = 0; k < particles.count(); k++) {
    out << "X ";
    write_row(out, particles, k);
  }
}

}  // namespace particles
