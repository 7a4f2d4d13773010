// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Extended XYZ: a count, a line of key=value, one row for each particle; one or several frames. Properties must name
// pos and radius (or r, diameter, d); Lattice, pbc and Origin set the box. The Lattice is that of hg_grid_def: its
// first edge along x, its second without z. As usual for the format, a Lattice without pbc is periodic on all axes.
#include "particles/files/columns.hpp"
#include "particles/files/reader.hpp"
#include "particles/files/row_writer.hpp"
#include "particles/text/number.hpp"
#include "particles/text/output.hpp"

#include <algorithm>
#include <map>

namespace particles {
namespace {

using Keys = std::map<std::string, std::string_view>;

// key=value and key="value with blanks"; a word without '=' stands for true.
Keys read_keys(const LineCursor &cursor, std::string_view line) {
  Keys keys;
  while (!(line = trimmed(line)).empty()) {
    const size_t end = line.find_first_of("= \t");
    const std::string key = lower_case(line.substr(0, end));
    line.remove_prefix(std::min(end, line.size()));
    std::string_view value = "T";
    if (!line.empty() && line.front() == '=') {
      line.remove_prefix(1);
      const bool is_quoted = !line.empty() && line.front() == '"';
      if (is_quoted) line.remove_prefix(1);
      const size_t last = line.find_first_of(is_quoted ? "\"" : " \t");
      if (is_quoted && last == std::string_view::npos)
        cursor.fail("the quote after " + in_quotes(key) + " does not end");
      value = line.substr(0, last);
      line.remove_prefix(last == std::string_view::npos ? line.size() : last + 1);
    }
    if (!keys.emplace(key, value).second) cursor.fail("the key " + in_quotes(key) + " is given twice");
  }
  return keys;
}

std::vector<double> numbers(const LineCursor &cursor, const std::string &key, std::string_view text, size_t count) {
  std::vector<double> values;
  for (const std::string_view word : split_words(text)) {
    values.push_back(0);
    if (const char *fault = number_fault(word, values.back())) cursor.fail(key + ": " + in_quotes(word) + " " + fault);
  }
  if (values.size() != count)
    cursor.fail(key + " must hold " + std::to_string(count) + " numbers, but it is " + in_quotes(text));
  return values;
}

void read_lattice(const LineCursor &cursor, std::string_view text, const Keys &keys, ParticleSet &box) {
  const std::vector<double> edges = numbers(cursor, "Lattice", text, 9);
  std::vector<double> origin(3, 0.0);
  if (const auto found = keys.find("origin"); found != keys.end()) origin = numbers(cursor, "Origin", found->second, 3);
  for (const size_t above : {1, 2, 5})
    if (edges[above] != 0)
      cursor.fail("the cell must be lower triangular ('ax 0 0 bx by 0 cx cy cz'), but the Lattice is " +
                  in_quotes(text));
  for (size_t axis = 0; axis < 3; axis++) {
    if (edges[4 * axis] < 0) cursor.fail("the Lattice " + in_quotes(text) + " has a negative edge");
    box.box_min[axis] = origin[axis];
    box.box_max[axis] = origin[axis] + edges[4 * axis];
    box.periodic[axis] = 1;
  }
  box.tilt[0] = edges[3];
  box.tilt[1] = edges[6];
  box.tilt[2] = edges[7];
  box.has_box = true;
}

void read_box(const LineCursor &cursor, const Keys &keys, ParticleSet &box) {
  if (const auto lattice = keys.find("lattice"); lattice != keys.end())
    read_lattice(cursor, lattice->second, keys, box);
  const auto pbc = keys.find("pbc");
  if (pbc == keys.end()) return;
  const std::vector<std::string_view> flags = split_words(pbc->second);
  if (flags.size() != 3) cursor.fail("pbc must hold three flags, but it is " + in_quotes(pbc->second));
  for (size_t axis = 0; axis < 3; axis++) {
    const std::string flag = lower_case(flags[axis]);
    const bool is_periodic = flag == "t" || flag == "true" || flag == "1";
    if (!is_periodic && flag != "f" && flag != "false" && flag != "0")
      cursor.fail("pbc: the flag " + in_quotes(flags[axis]) + " is neither T nor F");
    if (is_periodic && !box.has_box) cursor.fail("pbc has a periodic axis, but there is no Lattice");
    box.periodic[axis] = is_periodic;
  }
}

// Properties=species:S:1:pos:R:3:radius:R:1
Columns read_properties(const LineCursor &cursor, const Keys &keys) {
  const auto found = keys.find("properties");
  if (found == keys.end()) cursor.fail("no Properties=... that names pos and radius");
  Columns columns;
  std::string_view text = found->second;
  while (!text.empty()) {
    std::string_view part[3];
    for (std::string_view &piece : part) {
      piece = text.substr(0, text.find(':'));
      text.remove_prefix(std::min(piece.size() + 1, text.size()));
    }
    const std::string name = lower_case(part[0]);
    size_t width = 0;
    if (name.empty() || !read_count(part[2], width) || width == 0 || width > 1000)
      cursor.fail("Properties must be name:type:columns:..., but it is " + in_quotes(found->second));
    if (name == "pos") {
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
  if (columns.axis[0] < 0) cursor.fail("Properties " + in_quotes(found->second) + " does not name pos");
  find_size_column(cursor, columns);
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
  const Keys keys = read_keys(cursor, cursor.expect("the line of keys"));
  const Columns columns = read_properties(cursor, keys);
  ParticleSet particles;
  read_box(cursor, keys, particles);
  particles.dimension = settle_dimension(cursor, columns, options.dimension);
  const size_t expected = std::min(count, columns.most_rows(cursor.bytes_left()));
  particles.centers.reserve(expected * static_cast<size_t>(particles.dimension));
  particles.radii.reserve(expected);
  RowReader rows(cursor, columns, particles);
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
