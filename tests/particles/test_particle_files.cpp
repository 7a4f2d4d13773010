// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What all formats share: recognition, files that cannot be read or written, and every double surviving the round trip.
#include "particles/files/writer.hpp"
#include "particles/text/output.hpp"
#include "tests/particles/cmocka_cpp.hpp"
#include "tests/particles/reading.hpp"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <random>

using test::refuses;
using test::with_box;

namespace {

constexpr uint64_t kSeed = 20240611;

// Coordinates of every magnitude: random bits of finite doubles.
double any_finite(std::mt19937_64 &random) {
  for (;;) {
    const uint64_t bits = random();
    double value = 0;
    static_assert(sizeof bits == sizeof value);
    std::memcpy(&value, &bits, sizeof value);
    if (std::isfinite(value)) return value;
  }
}

particles::ParticleSet random_set(int dimension, size_t count) {
  std::mt19937_64 random(kSeed);
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

bool survives(particles::Format format, const particles::ParticleSet &set, const particles::ReadOptions &options = {}) {
  const test::ScratchFile file(".any", "");
  particles::write_particles(file.name(), format, set);
  const particles::ParticleSet found = particles::read_particles(file.name(), options);
  if (test::same(found, set)) return true;
  std::fprintf(stderr, "format %s, dimension %d, seed %llu: not the same\n", particles::format_name(format),
               set.dimension, static_cast<unsigned long long>(kSeed));
  return false;
}

void round_trip_without_box(void **) {
  bool ok = survives(particles::Format::kCsv, random_set(3, 500));
  assert_true(ok);
  ok = survives(particles::Format::kXyz, random_set(3, 500));
  assert_true(ok);
  ok = survives(particles::Format::kCsv, random_set(2, 500));
  assert_true(ok);
}

void round_trip_with_box(void **) {
  particles::ReadOptions flat;
  flat.dimension = 2;
  for (const particles::Format format :
       {particles::Format::kCsv, particles::Format::kLammps, particles::Format::kXyz}) {
    bool ok = survives(format, with_box(random_set(3, 500), {0, 0, -0.5}, {0.1, 1e-300, 0.5}, {1, 0, 1}));
    assert_true(ok);
    ok = survives(format, with_box(random_set(2, 500), {0, -8, 0}, {0.3, 8, 0}, {1, 0, 0}), flat);
    assert_true(ok);
  }
}

// No box: a dump must have bounds all the same, those of the spheres.
bool lammps_bounds_enclose_the_spheres() {
  const test::ScratchFile file(".dump", "");
  particles::write_particles(file.name(), particles::Format::kLammps, test::set_of(3, {0, 1, 2, 8, 1, -2}, {0.5, 1}));
  const particles::ParticleSet found = particles::read_particles(file.name());
  return test::same(found,
                    with_box(test::set_of(3, {0, 1, 2, 8, 1, -2}, {0.5, 1}), {-0.5, 0, -3}, {9, 2, 2.5}, {0, 0, 0}));
}

void lammps_without_box(void **) {
  const bool ok = lammps_bounds_enclose_the_spheres();
  assert_true(ok);
}

// -0.7 + (0.9 + 0.7) is not 0.9 in doubles.
bool xyz_refuses_a_box_it_would_change() {
  const test::ScratchFile file(".xyz", "kept");
  try {
    particles::write_particles(file.name(), particles::Format::kXyz,
                               with_box(test::set_of(3, {0.5, 0.5, 0.5}, {0.1}), {0, -0.7, 0}, {1, 0.9, 1}, {0, 1, 0}));
  } catch (const particles::Error &error) {
    return std::string(error.what()).find("axis y") != std::string::npos &&
           std::filesystem::file_size(file.name()) == 4;
  }
  return false;
}

void xyz_box_is_kept_or_refused(void **) {
  const bool ok = xyz_refuses_a_box_it_would_change();
  assert_true(ok);
}

void formats_are_recognised(void **) {
  assert_true(particles::format_of_name("a.csv") == particles::Format::kCsv);
  assert_true(particles::format_of_name("b.XYZ") == particles::Format::kXyz);
  assert_true(particles::format_of_name("dir.csv/c.lammpstrj") == particles::Format::kLammps);
  assert_false(particles::format_of_name("csv").has_value());
  assert_true(particles::format_of_content("ITEM: TIMESTEP\n") == particles::Format::kLammps);
  assert_true(particles::format_of_content("12\r\nProperties") == particles::Format::kXyz);
  assert_false(particles::format_of_content("x,y,z\n").has_value());
  for (const particles::Format format : {particles::Format::kCsv, particles::Format::kLammps, particles::Format::kXyz})
    assert_true(particles::format_of_word(particles::format_name(format)) == format);
  assert_false(particles::format_of_word("pdb").has_value());
}

void a_forced_format_wins(void **) {
  particles::ReadOptions csv;
  csv.format = particles::Format::kCsv;
  bool ok = refuses(".csv", "3\nProperties=pos:R:3\n",
                    "1: the first line must name the columns (such as x,y,z,radius), but it holds '3'", csv);
  assert_true(ok);
  particles::ReadOptions xyz;
  xyz.format = particles::Format::kXyz;
  ok = refuses(".csv", "x,y,z,r\n", "1: the number of particles should stand here, not 'x,y,z,r'", xyz);
  assert_true(ok);
}

bool refuses_path(const std::string &path, const std::string &message) {
  try {
    particles::read_particles(path);
  } catch (const particles::Error &error) {
    if (error.what() == message) return true;
    std::fprintf(stderr, "refused with %s\n", error.what());
  }
  return false;
}

void unreadable_files_are_refused(void **) {
  bool ok = refuses(".csv", "", " the file is empty");
  assert_true(ok);
  ok = refuses_path("no/such/file.csv", "no/such/file.csv: cannot open: No such file or directory");
  assert_true(ok);
  ok = refuses_path(".", ".: cannot read: Is a directory");
  assert_true(ok);
}

bool refuses_output(const std::string &path, const std::string &message) {
  try {
    particles::write_particles(path, particles::Format::kCsv, test::set_of(3, {0, 0, 0}, {1}));
  } catch (const particles::Error &error) {
    if (error.what() == message) return true;
    std::fprintf(stderr, "refused with %s\n", error.what());
  }
  return false;
}

void unwritable_files_are_reported(void **) {
  bool ok = refuses_output("no/such/file.csv", "no/such/file.csv: cannot write: No such file or directory");
  assert_true(ok);
  // The full disk that Linux always has.
  if (std::filesystem::exists("/dev/full"))
    ok = refuses_output("/dev/full", "/dev/full: cannot write: No space left on device");
  assert_true(ok);
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

void output_keeps_everything(void **) {
  const bool ok = long_output_is_complete();
  assert_true(ok);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(round_trip_without_box),       cmocka_unit_test(round_trip_with_box),
      cmocka_unit_test(lammps_without_box),           cmocka_unit_test(xyz_box_is_kept_or_refused),
      cmocka_unit_test(formats_are_recognised),       cmocka_unit_test(a_forced_format_wins),
      cmocka_unit_test(unreadable_files_are_refused), cmocka_unit_test(unwritable_files_are_reported),
      cmocka_unit_test(output_keeps_everything),
  };
  return cmocka_run_group_tests_name("particle_files", tests, nullptr, nullptr);
}
