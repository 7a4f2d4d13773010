// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// LAMMPS data files ("write_data"): the box and the section Atoms, whose columns its style tells. They do not tell
// which axes are periodic.
#include "particles/files/columns.hpp"
#include "particles/files/reader.hpp"
#include "particles/text/number.hpp"

#include <algorithm>

namespace particles {
namespace {

struct AtomStyle {
  const char *names;  // as they stand after "Atoms #", with blanks around each
  const char *columns;
};

constexpr AtomStyle kStyles[] = {
    {" sphere granular ", "id type diameter density x y z"},
    {" bpm/sphere ", "id molecule type diameter density x y z"},
    {" atomic ", "id type x y z"},
    {" charge ", "id type q x y z"},
    {" bond angle molecular ", "id molecule type x y z"},
    {" full ", "id molecule type q x y z"},
    {" dipole ", "id type q x y z mux muy muz"},
    {" ellipsoid ", "id type ellipsoid density x y z"},
};

std::vector<std::string_view> words_before_comment(std::string_view line) {
  return split_words(line.substr(0, line.find('#')));
}

// "Atoms", "Bond Coeffs": a line that begins with a letter. Lines of the head and of sections begin with numbers.
bool is_section(const std::vector<std::string_view> &words) {
  if (words.empty()) return false;
  const char first = words[0].front();
  return (first >= 'A' && first <= 'Z') || (first >= 'a' && first <= 'z');
}

struct Head {
  bool has_count = false;
  size_t count = 0;
  ParticleSet box;
};

double number_of(const LineCursor &cursor, std::string_view word) {
  double value = 0;
  if (const char *fault = number_fault(word, value)) cursor.fail(in_quotes(word) + " " + fault);
  return value;
}

void read_head_line(const LineCursor &cursor, const std::vector<std::string_view> &words, Head &head) {
  const size_t size = words.size();
  if (size == 2 && words[1] == "atoms") {
    head.has_count = read_count(words[0], head.count);
    if (!head.has_count) cursor.fail("the number of atoms should stand here, not " + in_quotes(words[0]));
  }
  for (size_t axis = 0; axis < 3; axis++) {
    const std::string name(1, "xyz"[axis]);
    if (size != 4 || words[2] != name + "lo" || words[3] != name + "hi") continue;
    head.box.box_min[axis] = number_of(cursor, words[0]);
    head.box.box_max[axis] = number_of(cursor, words[1]);
    if (head.box.box_max[axis] < head.box.box_min[axis])
      cursor.fail("the upper bound " + in_quotes(words[1]) + " lies below the lower bound " + in_quotes(words[0]));
    head.box.has_box = true;
  }
  if (size == 6 && words[3] == "xy" && words[4] == "xz" && words[5] == "yz")
    for (size_t k = 0; k < 3; k++) head.box.tilt[k] = number_of(cursor, words[k]);
}

// Up to the line "Atoms # style", which is returned.
std::string_view find_atoms(LineCursor &cursor, Head &head) {
  cursor.expect("the title");
  bool in_head = true;
  std::string_view line;
  while (cursor.next(line)) {
    const std::vector<std::string_view> words = words_before_comment(line);
    if (is_section(words)) in_head = false;
    if (words.size() == 1 && words[0] == "Atoms") return line;
    if (in_head) read_head_line(cursor, words, head);
  }
  cursor.fail("the file ends here, the section Atoms is missing");
}

std::vector<std::string> names_of_style(const LineCursor &cursor, std::string_view line) {
  const size_t mark = std::min(line.find('#'), line.size());
  const std::string_view style = trimmed(line.substr(std::min(mark + 1, line.size())));
  for (const AtomStyle &known : kStyles) {
    if (style.empty() || std::string_view(known.names).find(" " + std::string(style) + " ") == std::string_view::npos)
      continue;
    const std::vector<std::string_view> words = split_words(known.columns);
    return {words.begin(), words.end()};
  }
  const std::string ask = "; name its columns (--header id,type,diameter,density,x,y,z)";
  if (style.empty()) cursor.fail("nothing tells the style of the atoms ('Atoms # sphere')" + ask);
  cursor.fail("the atom style " + in_quotes(style) + " is unknown" + ask);
}

Columns columns_of(const LineCursor &cursor, std::vector<std::string> names, size_t in_first_row,
                   const ReadOptions &options) {
  Columns columns;
  columns.names = std::move(names);
  // Which image of the box a place is in: the coordinates are inside already.
  if (in_first_row == columns.names.size() + 3) columns.names.insert(columns.names.end(), {"nx", "ny", "nz"});
  for (int axis = 0; axis < 3; axis++) columns.axis[axis] = find_column(cursor, columns, std::string(1, "xyz"[axis]));
  find_size(cursor, columns, options);
  find_further_columns(cursor, columns, options);
  return columns;
}

// The next line that is not blank.
bool next_row(LineCursor &cursor, std::string_view &line) {
  while (cursor.next(line)) {
    line = trimmed(line.substr(0, line.find('#')));
    if (!line.empty()) return true;
  }
  return false;
}

}  // namespace

// A title, then soon a line "N atoms".
bool begins_lammps_data(std::string_view text) {
  for (int number = 0; number < 40 && !text.empty(); number++) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    line = line.substr(0, line.find_last_not_of('\r') + 1);
    const std::vector<std::string_view> words = words_before_comment(line);
    size_t count = 0;
    if (number > 0 && words.size() == 2 && words[1] == "atoms" && read_count(words[0], count)) return true;
    if (number > 0 && is_section(words)) return false;
  }
  return false;
}

ParticleSet read_lammps_data(const TextFile &file, const ReadOptions &options) {
  LineCursor cursor(file);
  if (options.frame > 1)
    cursor.fail(0, "frame " + std::to_string(options.frame) + " of a LAMMPS data file, which has only one");
  Head head;
  const std::string_view section = find_atoms(cursor, head);
  if (!head.has_count) cursor.fail("no line 'N atoms' stands before the section Atoms");
  std::vector<std::string> names = options.header.empty() ? names_of_style(cursor, section) : options.header;
  ParticleSet particles = head.box;
  particles.notes.emplace_back("a LAMMPS data file does not tell which axes are periodic; all are taken as open");
  Columns columns;
  columns.names = names;
  const size_t expected = std::min(head.count, columns.most_rows(cursor.bytes_left()));
  std::string_view line;
  LineCursor::Position start = cursor.position();
  const bool has_rows = head.count > 0 && next_row(cursor, line);
  columns = columns_of(cursor, std::move(names), has_rows ? split_words(line).size() : 0, options);
  particles.dimension = settle_dimension(cursor, columns, options.dimension);
  particles.centers.reserve(expected * static_cast<size_t>(particles.dimension));
  particles.radii.reserve(expected);
  cursor.seek(start);
  RowReader rows(cursor, columns, options, particles);
  for (size_t k = 0; k < head.count; k++) {
    if (!next_row(cursor, line))
      cursor.fail("the file ends here with " + std::to_string(k) + " of " + std::to_string(head.count) + " atoms");
    rows.append(line);
  }
  if (next_row(cursor, line) && !is_section(split_words(line)))
    cursor.fail("a section should begin here after " + std::to_string(head.count) + " atoms, not " + in_quotes(line));
  for (bool more = options.motion; more; more = next_row(cursor, line))
    if (line == "Velocities") particles.unused.emplace_back("section Velocities");
  return particles;
}

}  // namespace particles
