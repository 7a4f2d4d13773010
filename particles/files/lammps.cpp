// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// LAMMPS text dumps ("dump custom"), in tilted boxes, too. Read: one or several frames with columns x or xu or xs or
// xsu (and so on) and radius or diameter. Written: one frame with the columns id, type, x, y, z, radius and further
// ones.
#include "particles/files/columns.hpp"
#include "particles/files/reader.hpp"
#include "particles/files/row_writer.hpp"
#include "particles/text/number.hpp"
#include "particles/text/output.hpp"

#include <algorithm>
#include <cmath>

namespace particles {
namespace {

struct Frame {
  size_t count = 0;
  Columns columns;
  bool has_bounds = false;
  ParticleSet box;  // dimension 3, no particles
  LineCursor::Position rows;
};

std::string_view section_name(const LineCursor &cursor, std::string_view line) {
  if (line.substr(0, 6) != "ITEM: ") cursor.fail("a line 'ITEM: ...' should stand here, not " + in_quotes(line));
  return trimmed(line.substr(6));
}

bool begins(std::string_view text, std::string_view start) { return text.substr(0, start.size()) == start; }

// How far a tilted box reaches beyond its two corners. A dump tells the bounds of all of it.
struct Overhang {
  double low[3], high[3];
};

Overhang overhang_of(const double (&tilt)[3]) {
  const auto [x_low, x_high] = std::minmax({0.0, tilt[0], tilt[1], tilt[0] + tilt[1]});
  const auto [y_low, y_high] = std::minmax({0.0, tilt[2]});
  return {{x_low, y_low, 0}, {x_high, y_high, 0}};
}

void take_off_overhang(const LineCursor &cursor, ParticleSet &box) {
  const Overhang beyond = overhang_of(box.tilt);
  for (int axis = 0; axis < 3; axis++) {
    double &low = box.box_min[axis], &high = box.box_max[axis];
    low -= beyond.low[axis];
    high -= beyond.high[axis];
    if (!(low <= high) || !std::isfinite(low) || !std::isfinite(high))
      cursor.fail(std::string("the bounds on axis ") + "xyz"[axis] + " leave no room for a box of this tilt");
  }
}

// "BOX BOUNDS pp pp ff" and three lines "low high", or "BOX BOUNDS xy xz yz pp pp pp" and three lines "low high tilt".
// A cell turned in space ("abc origin") is passed over where another box is used.
void read_bounds(LineCursor &cursor, std::string_view name, const ReadOptions &options, ParticleSet &box) {
  std::vector<std::string_view> flags = split_words(name.substr(std::string_view("BOX BOUNDS").size()));
  const bool is_turned = !options.needs_box && flags.size() == 5 && flags[0] == "abc" && flags[1] == "origin";
  if (is_turned) flags.erase(flags.begin(), flags.begin() + 2);
  const bool is_tilted = flags.size() == 6 && flags[0] == "xy" && flags[1] == "xz" && flags[2] == "yz";
  if (is_tilted) flags.erase(flags.begin(), flags.begin() + 3);
  if (flags.empty()) cursor.fail("the boundary flags (such as pp pp ff) are missing");
  if (flags.size() != 3)
    cursor.fail("three boundary flags should stand here, in tilted boxes after 'xy xz yz', not " + in_quotes(name));
  for (size_t axis = 0; axis < 3; axis++) {
    if (flags[axis].size() != 2 || flags[axis].find_first_not_of("pfsm") != std::string_view::npos)
      cursor.fail("the boundary flag " + in_quotes(flags[axis]) + " is unknown");
    box.periodic[axis] = flags[axis] == "pp";
  }
  if (is_turned) {
    cursor.skip(3);
    return;
  }
  for (size_t axis = 0; axis < 3; axis++) {
    const std::string_view line = cursor.expect("a line of the box bounds");
    const std::vector<std::string_view> ends = split_words(line);
    if (ends.size() != (is_tilted ? 3 : 2))
      cursor.fail(std::string("a lower and an upper bound ") + (is_tilted ? "and a tilt " : "") +
                  "should stand here, not " + in_quotes(line));
    if (const char *fault = number_fault(ends[0], box.box_min[axis])) cursor.fail(in_quotes(ends[0]) + " " + fault);
    if (const char *fault = number_fault(ends[1], box.box_max[axis])) cursor.fail(in_quotes(ends[1]) + " " + fault);
    if (box.box_max[axis] < box.box_min[axis])
      cursor.fail("the upper bound " + in_quotes(ends[1]) + " lies below the lower bound " + in_quotes(ends[0]));
    if (!is_tilted) continue;
    if (const char *fault = number_fault(ends[2], box.tilt[axis])) cursor.fail(in_quotes(ends[2]) + " " + fault);
  }
  if (is_tilted) take_off_overhang(cursor, box);
  box.has_box = true;
}

// x, xu (unwrapped), xs (scaled) or xsu; the first that is there.
void find_axis(const LineCursor &cursor, Columns &columns, int axis) {
  for (const char *kind : {"", "u", "s", "su"}) {
    columns.axis[axis] = find_column(cursor, columns, std::string(1, "xyz"[axis]) + kind);
    columns.scaled[axis] = kind[0] == 's';
    if (columns.axis[axis] >= 0) return;
  }
}

// Where edges lean over, a place is known by its scaled coordinates together.
void refuse_half_scaled(const LineCursor &cursor, const Columns &columns) {
  const int *axis = columns.axis;
  for (int k = 1; k < 3; k++)
    if (axis[k] >= 0 && columns.scaled[k] != columns.scaled[0])
      cursor.fail(std::string("in a tilted box x and ") + "xyz"[k] + " must be scaled both or neither");
}

// Reads the head of a frame up to the rows, which it leaves to the caller. False at the end of the file.
bool read_head(LineCursor &cursor, const ReadOptions &options, Frame &frame) {
  bool has_count = false;
  std::string_view line;
  while (cursor.next(line)) {
    if (trimmed(line).empty()) continue;
    const std::string_view name = section_name(cursor, line);
    if (name == "TIMESTEP" || name == "TIME" || name == "UNITS") {
      cursor.expect("the value of " + in_quotes(name));
    } else if (name == "NUMBER OF ATOMS") {
      const std::string_view count = trimmed(cursor.expect("the number of atoms"));
      has_count = read_count(count, frame.count);
      if (!has_count) cursor.fail("the number of atoms should stand here, not " + in_quotes(count));
    } else if (begins(name, "BOX BOUNDS")) {
      read_bounds(cursor, name, options, frame.box);
      frame.has_bounds = true;
    } else if (begins(name, "ATOMS")) {
      if (!has_count || !frame.has_bounds) cursor.fail("NUMBER OF ATOMS and BOX BOUNDS must stand before ATOMS");
      for (const std::string_view word : split_words(name.substr(5))) frame.columns.names.emplace_back(word);
      rename_columns(cursor, frame.columns, options);
      for (int axis = 0; axis < 3; axis++) find_axis(cursor, frame.columns, axis);
      const bool *scaled = frame.columns.scaled;
      if (!frame.box.has_box && (scaled[0] || scaled[1] || scaled[2]))
        cursor.fail("scaled coordinates need the file's box, whose edges point elsewhere");
      if (frame.box.is_tilted()) refuse_half_scaled(cursor, frame.columns);
      find_size(cursor, frame.columns, options);
      find_further_columns(cursor, frame.columns, options);
      frame.rows = cursor.position();
      return true;
    } else {
      cursor.fail("the section " + in_quotes(name) + " is unknown");
    }
  }
  if (has_count || frame.has_bounds) cursor.fail("the file ends here, the line 'ITEM: ATOMS ...' is missing");
  return false;
}

[[noreturn]] void fail_short(const LineCursor &cursor, size_t got, size_t count) {
  cursor.fail("the file ends here with " + std::to_string(got) + " of " + std::to_string(count) + " atoms");
}

// The frame asked for, or the last; the cursor is put at its rows.
Frame find_frame(LineCursor &cursor, const ReadOptions &options) {
  const long asked = options.frame;
  Frame chosen, frame;
  long found = 0;
  while ((asked == 0 || found < asked) && read_head(cursor, options, frame)) {
    found++;
    chosen = std::move(frame);
    frame = Frame();
    const size_t got = cursor.skip(chosen.count);
    if (got < chosen.count) fail_short(cursor, got, chosen.count);
  }
  if (found == 0) cursor.fail("the file has no frame");
  if (found < asked) cursor.fail("frame " + std::to_string(asked) + " of a file with " + std::to_string(found));
  cursor.seek(chosen.rows);
  return chosen;
}

}  // namespace

ParticleSet read_lammps(const TextFile &file, const ReadOptions &options) {
  LineCursor cursor(file);
  const Frame frame = find_frame(cursor, options);
  ParticleSet particles = frame.box;
  particles.dimension = settle_dimension(cursor, frame.columns, options.dimension);
  const size_t expected = std::min(frame.count, frame.columns.most_rows(cursor.bytes_left()));
  particles.centers.reserve(expected * static_cast<size_t>(particles.dimension));
  particles.radii.reserve(expected);
  RowReader rows(cursor, frame.columns, options, particles);
  std::string_view line;
  for (size_t k = 0; k < frame.count; k++) {
    if (!cursor.next(line)) fail_short(cursor, k, frame.count);
    rows.append(line);
  }
  return particles;
}

namespace {

// A dump must have bounds: where the set has no box, those of its particles (boundary "ss", shrink-wrapped).
void bounds_of(const ParticleSet &particles, int axis, double &low, double &high) {
  const auto dimension = static_cast<size_t>(particles.dimension);
  low = high = 0;
  if (axis >= particles.dimension) return;
  for (size_t k = 0; k < particles.count(); k++) {
    const double place = particles.centers[k * dimension + static_cast<size_t>(axis)];
    const double radius = particles.radii[k];
    low = k == 0 ? place - radius : std::min(low, place - radius);
    high = k == 0 ? place + radius : std::max(high, place + radius);
  }
}

// As LAMMPS calls them: vx, omegaz, mass.
void write_titles(Output &out, const Column &column) {
  const std::string name = column.name == "velocity" ? "v" : column.name == "spin" ? "omega" : column.name;
  for (size_t n = 0; n < column.width; n++) {
    out << ' ' << name;
    if (column.width > 1) out << "xyz"[n];
  }
}

}  // namespace

std::string loss_in_lammps(const ParticleSet &particles) {
  const Overhang beyond = overhang_of(particles.tilt);
  for (int axis = 0; axis < 3; axis++) {
    const double low = particles.box_min[axis], high = particles.box_max[axis];
    if (particles.periodic[axis] &&
        (low + beyond.low[axis] - beyond.low[axis] != low || high + beyond.high[axis] - beyond.high[axis] != high))
      return std::string("a LAMMPS dump stores the bounds of a tilted box, which cannot hold this one on axis ") +
             "xyz"[axis] + " exactly; write CSV";
  }
  return "";
}

void write_lammps(Output &out, const ParticleSet &particles) {
  const Moment moment = particles.moment.value_or(Moment{0, 0});
  if (particles.moment) out << "ITEM: TIME\n" << moment.time << '\n';
  out << "ITEM: TIMESTEP\n" << moment.step << "\nITEM: NUMBER OF ATOMS\n" << particles.count();
  out << "\nITEM: BOX BOUNDS" << (particles.is_tilted() ? " xy xz yz" : "");
  for (const int flag : particles.periodic) out << (flag ? " pp" : particles.has_box ? " ff" : " ss");
  out << '\n';
  const Overhang beyond = overhang_of(particles.tilt);
  for (int axis = 0; axis < 3; axis++) {
    double low = particles.box_min[axis] + beyond.low[axis], high = particles.box_max[axis] + beyond.high[axis];
    if (!particles.has_box) bounds_of(particles, axis, low, high);
    out << low << ' ' << high;
    if (particles.is_tilted()) out << ' ' << particles.tilt[axis];
    out << '\n';
  }
  out << "ITEM: ATOMS id type x y z radius";
  for (const Column &column : particles.columns) write_titles(out, column);
  out << '\n';
  for (size_t k = 0; k < particles.count(); k++) {
    out << k + 1 << " 1 ";
    write_row(out, particles, k);
  }
}

}  // namespace particles
