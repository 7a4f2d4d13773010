// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Scene files: what they mean, and what is refused with which words.
#include "dem/effects/table.hpp"
#include "dem/scene/keys.hpp"
#include "dem/scene/suggestion.hpp"
#include "dem/scene/units.hpp"
#include "packing/size_law.hpp"
#include "tests/dem/scene_text.hpp"
#include "tests/particles/page.hpp"
#include "tests/support/frame.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

using scene_text::error_of;
using scene_text::is_refused;
using scene_text::kBasic;
using scene_text::read;

void unknown_keys_are_refused_with_line_and_suggestion(void **) {
  assert_true(is_refused(kBasic + "[gravty]\nacceleration = [0, 0, 1]\n", ":9: 'gravty' is no key", "'gravity'?"));
  assert_true(is_refused(kBasic + "[dissipation]\nrestitutoin = 1\n", ":10: 'restitutoin'", "'restitution'?"));
  assert_true(is_refused(kBasic + "[box]\nmax = [1, 1, 1]\nxyzzy = 2\n", ":11: 'xyzzy'", "known are min, max, walls"));
}

void missing_keys_are_named(void **) {
  assert_true(is_refused(kBasic + "[dissipation]\n", ":9: [dissipation] needs the key 'restitution'"));
  assert_true(is_refused("[contact]\nstiffness = 1\n[time]\nsteps = 1\n", "", "at least one table [[particles]]"));
  assert_true(is_refused(kBasic + "[adhesion]\nforce = 1\n", ":9: [adhesion] needs the key 'range'"));
}

// A box of the scene stands instead.
void tilted_boxes_of_files_are_refused(void **) {
  const std::string name =
      (std::filesystem::temp_directory_path() / ("hgrid-test-scene-" + std::to_string(getpid()) + ".csv")).string();
  std::ofstream(name) << "# box: 0 0 0 9 9 9 periodic 1 1 1 tilt 1 0 0\nx,y,z,radius\n1,1,1,1\n";
  const std::string text = "[[particles]]\nfile = \"" + name +
                           "\"\n[contact]\nstiffness = 1e4\n[time]\nsteps = 10\n[periodic]\naxes = \"xyz\"\n";
  const bool refused = is_refused(text, ":1: box: the box of the particles' file is tilted");
  const std::string of_boxed = error_of(text + "[box]\nmax = [9, 9, 9]\n");
  std::filesystem::remove(name);
  assert_true(refused);
  assert_string_equal(of_boxed.c_str(), "");
}

void wrong_values_are_named(void **) {
  assert_true(
      is_refused(kBasic + "[dissipation]\nrestitution = 1.5\n", ":10: dissipation.restitution: lies in (0, 1]", "1.5"));
  assert_true(is_refused(kBasic + "[gravity]\nacceleration = [0, 1]\n", ":10: gravity.acceleration is a list of 2"));
  assert_true(is_refused(kBasic + "[gravity]\nacceleration = true\n", ":10: gravity.acceleration is true or false"));
  assert_true(is_refused(kBasic + "[run]\nthreads = -1\n", ":10: run.threads is negative"));
  assert_true(
      is_refused(kBasic + "[run]\nprecision = \"flaot\"\n", ":10: run.precision cannot be 'flaot'", "'float'?"));
  assert_true(is_refused(kBasic + "[box]\nmax = [1, 1, 1]\nwalls = \"xw\"\n", ":11: box.walls: 'xw'"));
  assert_true(is_refused("title = \n", ":1: "));
}

void what_does_not_go_together_is_refused(void **) {
  assert_true(is_refused(kBasic + "[rolling]\ncoefficient = 0.1\n", ":9: rolling: needs [friction]"));
  assert_true(is_refused(kBasic + "[hertz]\nyoung_modulus = 1\npoisson_ratio = 0.3\n", ":9: hertz: stands instead"));
  assert_true(is_refused(kBasic + "[shear]\nrate = 1\n", ":9: shear: needs the periodic axes"));
  assert_true(is_refused(kBasic + "[periodic]\naxes = \"x\"\n", ":9: periodic: periodic axes need a [box]"));
}

// The table of an effect, one key a line; `changed` has another value, or is left out if that is empty.
std::string text_of(dem::Effect effect, const std::string &changed = "", const std::string &value = "") {
  std::string text = std::string("[") + dem::table_of(effect) + "]\n";
  for (const dem::Parameter &p : dem::kParameters) {
    if (p.effect != effect || (p.key == changed && value.empty())) continue;
    const bool vector = std::holds_alternative<double(dem::Physics::*)[3]>(p.place);
    const bool axes = std::holds_alternative<bool(dem::Physics::*)[3]>(p.place);
    text += std::string(p.key) + " = " +
            (p.key == changed ? value
             : vector         ? "[0, 0, 1]"
             : axes           ? "\"xy\""
                              : "0.5") +
            "\n";
  }
  return text;
}

// A scene of an effect and all that it needs, its own table from line 8 on.
std::string scene_of(const dem::EffectRow &row, const std::string &table) {
  std::string text =
      "[[particles]]\nat = [[0, 0, 0], [3, 0, 0]]\nradius = 1\n[time]\nsteps = 10\n[box]\nmax = [9, 9, 9]\n" + table;
  if (row.effect != dem::kHertz) text += "[contact]\nstiffness = 1e4\n";
  for (const dem::EffectRow &other : dem::kEffects) text += has(row.needs, other.effect) ? text_of(other.effect) : "";
  return text;
}

// A number out of its range or of no kind, or a key that is left out, is refused at its line.
bool faults_are_named(const dem::EffectRow &row) {
  bool good = error_of(scene_of(row, text_of(row.effect))).empty();
  int line = 8;
  for (const dem::Parameter &p : dem::kParameters) {
    if (p.effect != row.effect) continue;
    const std::string place = ":" + std::to_string(++line) + ": " + row.name + "." + p.key;
    const auto refused = [&](const char *value, const std::string &start, const char *part) {
      return is_refused(scene_of(row, text_of(row.effect, p.key, value)), start, part);
    };
    good = good && refused("true", place + " is true or false", "wanted");
    if (std::isfinite(p.range.low)) good = good && refused("-7", place + ": lies ", ", not at -7");
    if (p.needed()) good = good && refused("", ":8: [" + std::string(row.name) + "] needs the key", p.meaning);
  }
  return good && line > 8;
}

void faults_of_every_effect_are_named(void **) {
  for (const dem::EffectRow &row : dem::kEffects) assert_true(row.meaning == nullptr || faults_are_named(row));
}

void too_large_a_step_is_refused_with_its_line(void **) {
  std::string text = kBasic;
  text += "step = 1\n";
  assert_true(is_refused(text, ":9: time.step: the time step 1 is too large", "is the limit"));
}

void units_are_turned_to_si(void **) {
  using namespace scene;
  assert_true(in_si("2 mm", kLength) == 2e-3);
  assert_true(std::fabs(in_si("9.81 m/s^2", kAcceleration) - 9.81) < 1e-15);
  assert_true(std::fabs(in_si("72 km/h", kVelocity) - 20) < 1e-12);
  assert_true(in_si("1 kg m^-3", kDensity) == 1);
  assert_true(std::fabs(in_si("3 kN/mm", kStiffness) - 3e6) < 1e-6);
  assert_true(in_si("5 mPa s", kViscosity) == 5e-3);
  assert_true(in_si("3 \u00b5m", kLength) == in_si("3 um", kLength));  // the sign of micro
  assert_true(in_si("3 \u03bcs", kTime) == in_si("3 us", kTime));      // the Greek letter
}

std::string unit_error(const char *text, scene::Unit wanted) {
  return test::error_of([&] { scene::in_si(text, wanted); });
}

void wrong_units_are_refused(void **) {
  using namespace scene;
  assert_true(unit_error("2 s", kLength) == "'2 s' is in time (s) where length (m) is wanted");
  assert_true(unit_error("2", kLength).find("a pure number") != std::string::npos);
  assert_true(unit_error("2 Mm", kLength).find("'Mm' is no unit: did you mean") != std::string::npos);
  assert_true(unit_error("mm", kLength).find("does not begin with a number") != std::string::npos);
  assert_true(unit_error("2 m^x", kLength).find("no power") != std::string::npos);
  assert_true(unit_error("2 m/", kLength).find("ends with '/'") != std::string::npos);
  assert_true(
      is_refused(kBasic + "[gravity]\nacceleration = [0, 0, \"1 m/s\"]\n", ":10: gravity.acceleration: '1 m/s'"));
}

void a_scene_says_what_it_means(void **) {
  double mass = 0, step = 0, contact = 0, gravity = 0;
  unsigned effects = 0;
  size_t count = 0;
  {
    const scene::Scene scene = read(
        "[[particles]]\nat = [[\"5 mm\", 0, 0]]\nradius = \"1 mm\"\ndensity = \"2500 kg/m^3\"\n"
        "[[particles]]\nlattice = { counts = [2, 3, 4] }\nradius = 0.001\nfixed = true\n"
        "[contact]\nstiffness = \"100 N/m\"\n[gravity]\nacceleration = [0, 0, \"-9.81 m/s^2\"]\n"
        "[time]\nend = \"1 ms\"\nsteps_per_contact = 25\n");
    mass = scene.setup.masses[0];
    step = scene.setup.time_step;
    contact = scene.shortest_contact;
    gravity = scene.setup.gravity[2];
    effects = scene.setup.effects;
    count = scene.setup.count();
  }
  assert_true(std::fabs(mass / (4 * 3.14159265358979 / 3 * 1e-9 * 2500) - 1) < 1e-12);
  assert_true(count == 25);
  assert_true(std::fabs(contact / (3.14159265358979 * std::sqrt(mass / 100)) - 1) < 1e-12);  // with a fixed one
  assert_true(std::fabs(step / (contact / 25) - 1) < 1e-12);
  assert_true(gravity == -9.81);
  assert_true(effects == dem::kGravity);
}

std::string packed(const std::string &keys) {
  return "[[particles]]\npack = { count = 400, fraction = 0.3, sweeps = 1, " + keys +
         " }\n[contact]\nstiffness = 1\n[time]\nsteps = 1\n";
}

void counts_are_whole_numbers_in_any_writing(void **) {
  std::string text = kBasic;
  text.replace(text.find("steps = 10"), 10, "steps = 1e5");
  assert_true(read(text).steps == 100000);
  text.replace(text.find("steps = 1e5"), 11, "steps = 1.5");
  assert_true(is_refused(text, ":8: time.steps is a number where a whole number is wanted"));
  text.replace(text.find("steps = 1.5"), 11, "steps = 1e300");
  assert_true(is_refused(text, ":8: time.steps is a number where a whole number is wanted"));
}

// A group of so many particles at a radius, beside a stiffness with a unit.
std::string with_units(const std::string &group) {
  return "[[particles]]\n" + group + "\n[contact]\nstiffness = \"1 N/m\"\n[time]\nsteps = 1\n";
}

// A density or radius that nobody gave would be 1 in SI.
void nothing_is_silent_beside_units(void **) {
  const std::string ball = "at = [[0, 0, 0]]\nradius = 0.01\n", pack = "pack = { count = 20, fraction = 0.1 }\n";
  assert_true(is_refused(with_units(ball), ":1: particles.density: is needed beside numbers with units"));
  assert_string_equal(error_of(with_units(ball + "density = 2500")).c_str(), "");
  assert_string_equal(
      error_of(with_units(ball + "fixed = true\n[[particles]]\nat = [[1, 0, 0]]\nradius = 0.01\ndensity = 1")).c_str(),
      "");
  assert_true(is_refused(with_units(pack + "density = 2500"), ":1: particles.radius: is needed beside numbers with"));
  assert_string_equal(error_of(with_units(pack + "density = 2500\nradius = 0.01")).c_str(), "");
  assert_string_equal(error_of(packed("law = \"mono\"")).c_str(), "");  // bare numbers throughout
  const std::string stone = "material = \"stone\"\n[[material]]\nname = \"stone\"\n";
  assert_true(is_refused(with_units(ball + stone), ":1: particles.density: is needed beside numbers with units"));
  assert_string_equal(error_of(with_units(ball + stone + "density = 2500")).c_str(), "");
  // In a list, too.
  std::string bare = with_units(ball);
  bare.replace(bare.find("\"1 N/m\""), 7, "1");
  assert_string_equal(error_of(bare).c_str(), "");
  bare.replace(bare.find("[[0, 0, 0]]"), 11, "[[0, \"1 cm\", 0]]");
  assert_true(is_refused(bare, ":1: particles.density: is needed"));
}

void more_particles_than_memory_are_refused(void **) {
  const std::string head = "[[particles]]\nradius = 1\n", tail = "\n[contact]\nstiffness = 1\n[time]\nsteps = 1\n";
  assert_true(is_refused(head + "lattice = { counts = [1000000, 1000000, 1000000] }" + tail,
                         ":3: particles.lattice.counts: 1e+18 particles would take about 3e+11 GB",
                         "this machine has"));
  assert_true(is_refused(head + "pack = { count = 1e15, fraction = 0.1 }" + tail,
                         ":3: particles.pack.count: 1e+15 particles would take about 3e+08 GB"));
}

std::string error_with(const std::string &path, const std::string &value) {
  const std::string name = scene_text::write_file(kBasic);
  std::string what = test::error_of([&] { scene::read_scene(name, {{path, value}}); });
  if (what.compare(0, name.size(), name) == 0) what.erase(0, name.size());
  std::filesystem::remove(name);
  return what;
}

void settings_stand_instead_of_the_file(void **) {
  const std::string name = scene_text::write_file(kBasic + "[[particles]]\nat = [[9, 0, 0]]\nradius = 1\n");
  const scene::Scene scene = scene::read_scene(name, {{"contact.stiffness", "2e4"},
                                                      {"gravity.acceleration", "[0, 0, -1]"},
                                                      {"particles.2.radius", "2"},
                                                      {"particles.density", "3"},
                                                      {"title", "another"}});
  std::filesystem::remove(name);
  assert_true(scene.setup.contact.stiffness == 2e4 && scene.title == "another");
  assert_true(scene.setup.effects == dem::kGravity && scene.setup.gravity[2] == -1);
  assert_true(scene.setup.radii == (std::vector<double>{1, 1, 2}));
  assert_true(std::fabs(scene.setup.masses[0] / (4 * 3.14159265358979 / 3 * 3) - 1) < 1e-12);
  assert_string_equal(error_with("contact.stifness", "1").c_str(),
                      " with --set: 'stifness' is no key of [contact]: did you mean 'stiffness'?");
  assert_string_equal(error_with("particles.3.radius", "1").c_str(),
                      "--set particles.3.radius=1: there are 1 of these tables, counted from 1");
  assert_string_equal(error_with("title.x", "1").c_str(), "--set title.x=1: 'x' lies in no table");
  assert_string_equal(error_with("contact.stiffness", "much").c_str(),
                      " with --set: contact.stiffness: 'much' does not begin with a number");
}

// Velocities and spins of a file are added to those of its group; what is not used is named.
void files_bring_velocities(void **) {
  const std::string table =
      (std::filesystem::temp_directory_path() / ("hgrid-motion-" + std::to_string(getpid()))).string() + ".csv";
  std::ofstream(table) << "ID,x,y,z,r,VX,VY,VZ,omegax,omegay,omegaz\n1,0,0,0,1,1,2,3,4,5,6\n2,3,0,0,1,-1,-2,-3,0,0,7\n";
  const std::string text =
      "[[particles]]\nfile = \"" + table + "\"\nvelocity = [10, 0, 0]\n[contact]\nstiffness = 1e4\n[time]\nsteps = 1\n";
  bool plain = false, rotating = false;
  {
    const scene::Scene scene = read(text);
    plain = scene.setup.velocities == std::vector<double>{11, 2, 3, 9, -2, -3} &&
            scene.unused == std::vector<std::string>{"ID", "spin"};
    const scene::Scene with_spin = read(text + "[friction]\ncoefficient = 0.3\n");
    rotating = with_spin.setup.spins == std::vector<double>{4, 5, 6, 0, 0, 7} &&
               with_spin.unused == std::vector<std::string>{"ID"};
  }
  std::filesystem::remove(table);
  assert_true(plain);
  assert_true(rotating);
}

// The largest radius of a packing of this law; the smallest is 1.
double largest_radius(const std::string &keys) {
  const scene::Scene scene = read(packed(keys));
  return *std::max_element(scene.setup.radii.begin(), scene.setup.radii.end());
}

void scenes_take_every_law(void **) {
  for (const packing::LawRow &row : packing::size_laws()) {
    if (row.law == packing::Law::kTable) continue;
    const std::string keys = std::string("law = \"") + row.name + "\"";
    assert_int_equal(read(packed(keys + (row.takes.front().usual > 5 ? ", ratio = 5" : ""))).setup.count(), 400);
  }
  const double steep = largest_radius("law = \"power-law\", ratio = 5, exponent = 6");
  const double flat = largest_radius("law = \"power-law\", ratio = 5, exponent = 2");
  const double wide = largest_radius("law = \"log-normal\", sigma = 0.5");
  assert_true(steep < 4 && flat > 4.9 && flat < 5);
  assert_true(wide > 4 && wide < 5);
  assert_true(is_refused(packed("law = \"log-normal\", ratio = 5"), ":2: particles.pack.ratio: is for two-sizes, "));
  assert_true(
      is_refused(packed("law = \"mono\", ratio = 5"), ":2: particles.pack.ratio: is 1 for the law mono, not 5"));
  assert_true(
      is_refused(packed("law = \"power-law\", exponent = 12"), ":2: particles.pack: the exponent is ", "not 12"));
  assert_true(is_refused(packed("law = \"log-norml\""), ":2: particles.pack.law cannot be", "'log-normal'?"));
}

// Beside the scenes that are written here.
constexpr const char *kSizesName = "hgrid-test-scene-sizes.csv";

void scenes_take_tables_of_sizes(void **) {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / kSizesName;
  std::ofstream(path) << "diameter,passing\n2,0\n4,30\n6,100\n";
  const std::string keys = std::string("law = \"table\", sizes = \"") + kSizesName + "\"";
  const double largest = largest_radius(keys), cut_and_scaled = largest_radius(keys + ", from = 4 }\nradius = 20 #");
  const std::string unasked = error_of(packed(std::string("law = \"fuller\", sizes = \"") + kSizesName + "\""));
  std::ofstream(path) << "diameter,passing\n2,0\n4,30\n6,20\n";
  const std::string falling = error_of(packed(keys));
  std::filesystem::remove(path);
  assert_true(largest > 2.9 && largest < 3);
  assert_true(cut_and_scaled > 29.8 && cut_and_scaled < 30);
  assert_string_equal(unasked.c_str(), ":2: particles.pack.sizes: is for table, not for the law fuller");
  assert_string_equal(
      falling.c_str(),
      (":2: particles.pack.sizes: " + path.string() + ":4: '20' in column 'passing' is below 30 before it").c_str());
  assert_true(is_refused(packed("law = \"table\""), ":2: particles.pack: the law table needs a file of sizes"));
  assert_true(is_refused(packed(keys), ":2: particles.pack.sizes: ", "cannot open"));
}

void outputs_take_every_format(void **) {
  assert_true(read(kBasic + "[output]\nformats = [\"csv\", \"vtp\", \"lammps\"]\n").output.formats ==
              (std::vector<std::string>{"csv", "vtp", "lammps"}));
  assert_true(read(kBasic + "[output]\nevery = 1\n").output.formats == std::vector<std::string>{"vtp"});
  assert_true(is_refused(kBasic + "[output]\nformats = [\"vtk\"]\n", ":10: output.formats cannot be 'vtk'"));
}

void words_are_compared_by_edits(void **) {
  assert_int_equal(scene::edit_distance("kitten", "sitting"), 3);
  assert_int_equal(scene::edit_distance("axse", "axes"), 1);
  assert_int_equal(scene::edit_distance("", "abc"), 3);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(unknown_keys_are_refused_with_line_and_suggestion),
      cmocka_unit_test(missing_keys_are_named),
      cmocka_unit_test(tilted_boxes_of_files_are_refused),
      cmocka_unit_test(wrong_values_are_named),
      cmocka_unit_test(what_does_not_go_together_is_refused),
      cmocka_unit_test(faults_of_every_effect_are_named),
      cmocka_unit_test(too_large_a_step_is_refused_with_its_line),
      cmocka_unit_test(units_are_turned_to_si),
      cmocka_unit_test(wrong_units_are_refused),
      cmocka_unit_test(a_scene_says_what_it_means),
      cmocka_unit_test(counts_are_whole_numbers_in_any_writing),
      cmocka_unit_test(nothing_is_silent_beside_units),
      cmocka_unit_test(more_particles_than_memory_are_refused),
      cmocka_unit_test(settings_stand_instead_of_the_file),
      cmocka_unit_test(files_bring_velocities),
      cmocka_unit_test(scenes_take_every_law),
      cmocka_unit_test(scenes_take_tables_of_sizes),
      cmocka_unit_test(outputs_take_every_format),
      cmocka_unit_test(words_are_compared_by_edits),
  };
  return cmocka_run_group_tests_name("scene", tests, nullptr, nullptr);
}
