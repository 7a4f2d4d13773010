// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What all formats share: recognition, files that cannot be read or written, and every double surviving the round trip.
#include "particles/files/writer.hpp"
#include "particles/text/output.hpp"
#include "particles/text/text_file.hpp"
#include "tests/particles/page.hpp"
#include "tests/particles/reading.hpp"
#include "tests/support/frame.h"
#include "tests/support/refusal.hpp"
#include "tests/support/rng.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>

using test::of_dimension;
using test::refuses;
using test::with_box;
using test::with_tilt;

namespace {

constexpr uint64_t kSeed = 20240611;

// Coordinates of every magnitude: random bits of finite doubles.
double any_finite(hgtest::Rng &random) {
  for (;;) {
    const uint64_t bits = random.next();
    double value = 0;
    static_assert(sizeof bits == sizeof value);
    std::memcpy(&value, &bits, sizeof value);
    if (std::isfinite(value)) return value;
  }
}

particles::ParticleSet random_set(int dimension, size_t count) {
  hgtest::Rng random(kSeed);
  particles::ParticleSet set;
  set.dimension = dimension;
  for (size_t k = 0; k < count * static_cast<size_t>(dimension); k++) set.centers.push_back(any_finite(random));
  for (size_t k = 0; k < count; k++) set.radii.push_back(std::fabs(any_finite(random)));
  set.centers[0] = -0.0;
  set.centers[1] = std::numeric_limits<double>::denorm_min();
  set.radii[0] = std::numeric_limits<double>::max();
  set.radii[1] = 0;
  return set;
}

const particles::Format &format(const char *word) { return *particles::format_of_word(word); }

// Those that hold a box and are read and written.
std::vector<particles::Format> boxed_formats() { return {format("csv"), format("lammps"), format("xyz")}; }

bool survives(const particles::Format &format, const particles::ParticleSet &set,
              const particles::ReadOptions &options = {}) {
  const test::ScratchFile file(".any", "");
  particles::write_particles(file.name(), format, set);
  const particles::ParticleSet found = particles::read_particles(file.name(), options);
  if (test::same(found, set)) return true;
  std::fprintf(stderr, "format %s, dimension %d, seed %llu: not the same\n", format.name, set.dimension,
               static_cast<unsigned long long>(kSeed));
  return false;
}

bool round_trip_without_box() {
  return survives(format("csv"), random_set(3, 500)) && survives(format("xyz"), random_set(3, 500)) &&
         survives(format("csv"), random_set(2, 500)) && survives(format("vtp"), random_set(3, 500)) &&
         survives(format("vtp"), random_set(2, 500), of_dimension(2));
}

bool round_trip_with_box() {
  const std::vector<particles::Format> formats = boxed_formats();
  return std::all_of(formats.begin(), formats.end(), [](const particles::Format &format) {
    return survives(format, with_box(random_set(3, 500), {0, 0, -0.5}, {0.1, 1e-300, 0.5}, {1, 0, 1})) &&
           survives(format,
                    with_tilt(with_box(random_set(3, 500), {0, 0, -0.5}, {4, 5, 0.5}, {1, 1, 1}), {2, -0.75, 3})) &&
           survives(format, with_box(random_set(2, 500), {0, -8, 0}, {0.3, 8, 0}, {1, 0, 0}), of_dimension(2));
  });
}

// No box: a dump must have bounds all the same, those of the spheres.
bool lammps_bounds_enclose_the_spheres() {
  const test::ScratchFile file(".dump", "");
  particles::write_particles(file.name(), format("lammps"), test::set_of(3, {0, 1, 2, 8, 1, -2}, {0.5, 1}));
  const particles::ParticleSet found = particles::read_particles(file.name());
  return test::same(found,
                    with_box(test::set_of(3, {0, 1, 2, 8, 1, -2}, {0.5, 1}), {-0.5, 0, -3}, {9, 2, 2.5}, {0, 0, 0}));
}

// -0.7 + (0.9 + 0.7) is not 0.9 in doubles.
bool xyz_refuses_a_box_it_would_change() {
  const test::ScratchFile file(".xyz", "kept");
  const auto set = with_box(test::set_of(3, {0.5, 0.5, 0.5}, {0.1}), {0, -0.7, 0}, {1, 0.9, 1}, {0, 1, 0});
  return test::is_refused("axis y", [&] { particles::write_particles(file.name(), format("xyz"), set); }) &&
         std::filesystem::file_size(file.name()) == 4;
}

std::string text_of(const char *word, const particles::ParticleSet &set) {
  const test::ScratchFile file(".any", "");
  particles::write_particles(file.name(), format(word), set);
  return particles::load_text(file.name()).text;
}

// 0.1 + -0.7 + 0.7 is not 0.1 in doubles.
bool lammps_refuses_a_tilted_box_it_would_change() {
  const test::ScratchFile file(".dump", "kept");
  const auto set =
      with_tilt(with_box(test::set_of(3, {0.5, 0.5, 0.5}, {0.1}), {0.1, 0, 0}, {2, 2, 2}, {1, 1, 1}), {-0.7, 0, 0});
  return test::is_refused("axis x", [&] { particles::write_particles(file.name(), format("lammps"), set); }) &&
         std::filesystem::file_size(file.name()) == 4;
}

// What LAMMPS, ASE and OVITO read: the bounds of all of the cell, and its edges.
void tilted_boxes_are_written(void **) {
  const auto set =
      with_tilt(with_box(test::set_of(3, {1, 2, 3}, {0.5}), {0, 1, 2}, {4, 6, 8}, {1, 1, 1}), {1, -3, 0.5});
  assert_string_equal(text_of("csv", set).c_str(),
                      "# box: 0 1 2 4 6 8 periodic 1 1 1 tilt 1 -3 0.5\nx,y,z,radius\n1,2,3,0.5\n");
  assert_string_equal(text_of("lammps", set).c_str(),
                      "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS xy xz yz pp pp pp\n"
                      "-3 5 1\n1 6.5 -3\n2 8 0.5\nITEM: ATOMS id type x y z radius\n1 1 1 2 3 0.5\n");
  assert_string_equal(text_of("xyz", set).c_str(),
                      "1\nLattice=\"4 0 0 1 5 0 -3 0.5 6\" Origin=\"0 1 2\" Properties=species:S:1:pos:R:3:radius:R:1 "
                      "pbc=\"T T T\"\nX 1 2 3 0.5\n");
}

bool upright_boxes_are_asked_for() {
  auto set = with_tilt(with_box(test::set_of(3, {1, 2, 3}, {0.5}), {0, 0, 0}, {4, 4, 4}, {0, 1, 0}), {0, 0, 0});
  particles::require_upright(set, "a.csv");
  set.tilt[0] = 1;
  const bool refused = test::error_of([&] { particles::require_upright(set, "a.csv"); }) ==
                       "a.csv: the periodic box is tilted, and only boxes along the axes can be used here";
  set.periodic[1] = 0;
  particles::require_upright(set, "a.csv");
  return refused;
}

bool is(const particles::Format *found, const char *word) { return found == &format(word); }

void formats_are_recognised(void **) {
  assert_true(is(particles::format_of_name("a.csv"), "csv"));
  assert_true(is(particles::format_of_name("b.XYZ"), "xyz"));
  assert_true(is(particles::format_of_name("dir.csv/c.lammpstrj"), "lammps"));
  assert_null(particles::format_of_name("csv"));
  assert_null(particles::format_of_name(".csv"));
  assert_true(is(particles::format_of_content("ITEM: TIMESTEP\n"), "lammps"));
  assert_true(is(particles::format_of_content("12\r\nProperties"), "xyz"));
  assert_null(particles::format_of_content("x,y,z\n"));
  assert_true(is(particles::format_of_content("# vtk DataFile Version 3.0\n"), "vtk"));
  assert_true(is(particles::format_of_content("<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\">"), "vtp"));
  assert_true(is(particles::format_of_content("LAMMPS data file\n\n12 atoms\n2 atom types\n"), "data"));
  assert_null(particles::format_of_content("12 atoms\n"));
  // Its name is one of its endings: files of a run are called so.
  for (const particles::Format &format : particles::all_formats()) {
    assert_true(is(particles::format_of_word(format.name), format.name));
    assert_true(is(particles::format_of_name(std::string("state.") + format.name), format.name));
  }
  assert_null(particles::format_of_word("pdb"));
}

particles::ReadOptions as(const char *word) {
  particles::ReadOptions options;
  options.format = &format(word);
  return options;
}

bool a_forced_format_wins() {
  return refuses(".csv", "3\nProperties=pos:R:3\n",
                 "1: the first line must name the columns (such as x,y,z,radius), but it holds '3'", as("csv")) &&
         refuses(".csv", "x,y,z,r\n", "1: the number of particles should stand here, not 'x,y,z,r'", as("xyz"));
}

bool refuses_path(const std::string &path, const std::string &message) {
  return test::error_of([&] { particles::read_particles(path); }) == path + message;
}

// Two disks of a simulation in a flat box, one of which nothing moves.
particles::ParticleSet disks_in_motion() {
  particles::ParticleSet set = with_box(test::set_of(2, {0, 1, 2, 3}, {0.5, 0.25}), {0, 0, 0}, {4, 5, 1}, {1, 0, 0});
  set.columns = {{"velocity", 3, {1, 2, 0, 3, 4, 0}}, {"mass", 1, {7, INFINITY}}, {"spin", 3, {0, 0, 8, 0, 0, 9}}};
  set.moment = particles::Moment{40, 0.125};
  return set;
}

// Each format names the columns as its readers know them. Only CSV is for readers that know infinity.
void further_columns_are_written(void **) {
  assert_string_equal(text_of("csv", disks_in_motion()).c_str(),
                      "# box: 0 0 0 4 5 1 periodic 1 0 0\n# step: 40 time: 0.125\n"
                      "x,y,radius,velocity_x,velocity_y,velocity_z,mass,spin_x,spin_y,spin_z\n"
                      "0,1,0.5,1,2,0,7,0,0,8\n2,3,0.25,3,4,0,inf,0,0,9\n");
  assert_string_equal(text_of("lammps", disks_in_motion()).c_str(),
                      "ITEM: TIME\n0.125\nITEM: TIMESTEP\n40\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp ff ff\n"
                      "0 4\n0 5\n0 1\nITEM: ATOMS id type x y z radius vx vy vz mass omegax omegay omegaz\n"
                      "1 1 0 1 0 0.5 1 2 0 7 0 0 8\n2 1 2 3 0 0.25 3 4 0 0 0 0 9\n");
  assert_string_equal(text_of("xyz", disks_in_motion()).c_str(),
                      "2\nLattice=\"4 0 0 0 5 0 0 0 1\" Origin=\"0 0 0\" Properties=species:S:1:pos:R:3:radius:R:1:"
                      "velo:R:3:mass:R:1:angular_velocity:R:3 Time=0.125 pbc=\"T F F\"\n"
                      "X 0 1 0 0.5 1 2 0 7 0 0 8\nX 2 3 0 0.25 3 4 0 0 0 0 9\n");
}

// Readers pass over them.
bool columns_are_skipped() {
  particles::ParticleSet expected = disks_in_motion();
  expected.box_max[2] = 0;
  for (const particles::Format &format : boxed_formats()) {
    const test::ScratchFile file(".any", text_of(format.name, disks_in_motion()));
    if (test::same(particles::read_particles(file.name(), of_dimension(2)), expected)) continue;
    std::fprintf(stderr, "format %s: not the same\n", format.name);
    return false;
  }
  return true;
}

// What `hgrid run` takes of its own files, and what it names as not used.
bool motion_is_read() {
  particles::ReadOptions options = of_dimension(2);
  options.motion = true;
  particles::ParticleSet written = disks_in_motion();
  written.columns.push_back({"material", 1, {1, 0}});
  written.columns.push_back({"charge", 1, {3, 4}});
  for (const char *name : {"csv", "lammps", "xyz", "vtp"}) {
    const test::ScratchFile file(".any", text_of(name, written));
    const particles::ParticleSet found = particles::read_particles(file.name(), options);
    // What nothing moves has an infinite mass, which most readers of these formats know as 0.
    const bool same = found.columns.size() == 4 && found.columns[0].name == "velocity" &&
                      found.columns[0].values == written.columns[0].values && found.columns[1].name == "spin" &&
                      found.columns[1].values == written.columns[2].values && found.columns[2].name == "mass" &&
                      found.columns[2].values[0] == 7 &&
                      (found.columns[2].values[1] == 0 || found.columns[2].values[1] == INFINITY) &&
                      found.columns[3].name == "material" && found.columns[3].values == std::vector<double>{1, 0};
    const auto &unused = found.unused;
    if (same && std::find(unused.begin(), unused.end(), "charge") != unused.end()) continue;
    std::fprintf(stderr, "format %s: other velocities, spins, masses or names\n", name);
    return false;
  }
  return true;
}

// docs/guide/command.md has a line for every row of the table.
bool page_tells_all() {
  for (const particles::Format &format : particles::all_formats()) {
    const std::string needs = format.read != nullptr ? format.needs : "only written, never read";
    const std::string line = std::string("| ") + format.name + " | " + format.title + " | " + format.endings + " | ";
    if (!test::page_has(HGRID_COMMAND_PAGE, line + needs + " |\n")) return false;
  }
  return true;
}

bool unreadable_files_are_refused() {
  return refuses(".csv", "", " the file is empty") &&
         refuses_path("no/such/file.csv", ": cannot open: No such file or directory") &&
         refuses_path(".", ": cannot read: Is a directory") &&
         refuses(".vtp", "<?xml", "1: no sound XML: Error parsing document declaration/processing instruction");
}

// The same text as each kind of file, with every mark and line end.
bool marks_and_line_ends_are_alike() {
  const auto expected = with_box(test::set_of(3, {1, 2, 3, 4, 5, 6}, {0.5, 0.25}), {0, 0, 0}, {8, 8, 8}, {1, 1, 1});
  for (const particles::Format &format : boxed_formats()) {
    const std::string plain = text_of(format.name, expected);
    for (const std::string end : {"\n", "\r\n", "\r"}) {
      std::string text;
      for (const char letter : plain) text += letter == '\n' ? end : std::string(1, letter);
      if (!test::reads(".any", text, expected) || !test::reads(".any", "\xEF\xBB\xBF" + text + end + end, expected)) {
        std::fprintf(stderr, "format %s\n", format.name);
        return false;
      }
    }
  }
  return refuses(".csv", std::string("\xFF\xFEx\0,\0", 6), " the text is in UTF-16; save it in UTF-8");
}

// After the last row nothing may stand but blank lines.
bool text_after_the_rows_is_refused() {
  const auto set = with_box(test::set_of(3, {1, 2, 3}, {0.5}), {0, 0, 0}, {8, 8, 8}, {1, 1, 1});
  return refuses(".any", text_of("csv", set) + "the end\n", "4: 1 values in 'the end' where there should be 4") &&
         refuses(".any", text_of("xyz", set) + "the end\n",
                 "4: the number of particles should stand here, not 'the end'") &&
         refuses(".any", text_of("lammps", set) + "the end\n",
                 "11: a line 'ITEM: ...' should stand here, not 'the end'");
}

bool unknown_files_are_named() {
  std::string looked_for;
  for (const particles::Format &format : particles::readable_formats())
    looked_for += std::string(format.title) + " with " + format.needs + "; ";
  const std::string message =
      "1: neither the content nor the name tells what kind of file this is. Looked for: " + looked_for +
      "but it begins with ";
  return refuses(".h5", "\x89HDF\r\n\x1a\n", message + "'\x89HDF?'") &&
         refuses(".pdb", "HEADER  A MOLECULE\nATOM 1\n", message + "'HEADER  A MOLECULE'");
}

bool refuses_output(const std::string &path, const std::string &message) {
  return test::error_of([&] {
           particles::write_particles(path, format("csv"), test::set_of(3, {0, 0, 0}, {1}));
         }) == path + message;
}

// The full disk that Linux always has.
bool unwritable_files_are_reported() {
  return refuses_output("no/such/file.csv", ": cannot write: No such file or directory") &&
         (!std::filesystem::exists("/dev/full") ||
          refuses_output("/dev/full", ": cannot write: No space left on device"));
}

// More than one buffer of text and of numbers.
bool long_output_is_complete() {
  const std::string word(1000, 'w');
  const test::ScratchFile file(".txt", "");
  particles::Output out(file.name());
  size_t expected = 0;
  for (int k = 10000; k < 20000; k++) {
    out << word << k << 0.25 << '\n';
    expected += word.size() + 5 + 4 + 1;
  }
  out.close();
  return std::filesystem::file_size(file.name()) == expected;
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(passes<round_trip_without_box>),
      cmocka_unit_test(passes<round_trip_with_box>),
      cmocka_unit_test(passes<lammps_bounds_enclose_the_spheres>),
      cmocka_unit_test(passes<xyz_refuses_a_box_it_would_change>),
      cmocka_unit_test(passes<lammps_refuses_a_tilted_box_it_would_change>),
      cmocka_unit_test(tilted_boxes_are_written),
      cmocka_unit_test(passes<upright_boxes_are_asked_for>),
      cmocka_unit_test(formats_are_recognised),
      cmocka_unit_test(passes<a_forced_format_wins>),
      cmocka_unit_test(passes<unreadable_files_are_refused>),
      cmocka_unit_test(passes<marks_and_line_ends_are_alike>),
      cmocka_unit_test(passes<text_after_the_rows_is_refused>),
      cmocka_unit_test(passes<unknown_files_are_named>),
      cmocka_unit_test(passes<unwritable_files_are_reported>),
      cmocka_unit_test(further_columns_are_written),
      cmocka_unit_test(passes<columns_are_skipped>),
      cmocka_unit_test(passes<motion_is_read>),
      cmocka_unit_test(passes<long_output_is_complete>),
      cmocka_unit_test(passes<page_tells_all>),
  };
  return cmocka_run_group_tests_name("particle_files", tests, nullptr, nullptr);
}
