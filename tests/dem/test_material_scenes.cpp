// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Materials in scene files: what [[material]] and [[pair]] mean, and what is refused with which words.
#include "dem/base/vector.hpp"
#include "tests/dem/scene_text.hpp"
#include "tests/support/frame.h"

#include <cmath>

namespace {

using scene_text::is_refused;
using scene_text::read;

const std::string kSpheres =
    "[[particles]]\nat = [[1, 1, 1], [4, 1, 1]]\nradius = 1\nmaterial = \"glass\"\n"
    "[[particles]]\nat = [[1, 4, 1]]\nradius = 1\nmaterial = \"steel\"\n[time]\nsteps = 10\n[dissipation]\n";
const std::string kGlass = "[[material]]\nname = \"glass\"\ndensity = 2\nstiffness = 1e4\n";
const std::string kSteel = "[[material]]\nname = \"steel\"\ndensity = 8\nstiffness = 5e4\n";
const std::string kPairs =
    "[[pair]]\nmaterials = [\"glass\", \"glass\"]\nrestitution = 0.9\n"
    "[[pair]]\nmaterials = [\"steel\", \"steel\"]\nrestitution = 0.7\n"
    "[[pair]]\nmaterials = [\"glass\", \"steel\"]\nrestitution = 0.5\n";

bool is(double value, double expected) { return std::fabs(value - expected) <= 1e-12 * std::fabs(expected); }

void scenes_have_materials(void **) {
  bool good = true;
  {
    const dem::Setup setup = read(kSpheres + kGlass + kSteel + kPairs).setup;
    good = setup.effects == (dem::kDissipation | dem::kMaterials) &&
           setup.material_ids == std::vector<uint8_t>{0, 0, 1} && is(setup.masses[2] / setup.masses[0], 4) &&
           is(setup.materials[1].contact.stiffness, 5e4) && is(setup.pairs[setup.pair_of(0, 0)].restitution, 0.9) &&
           is(setup.pairs[setup.pair_of(0, 1)].restitution, 0.5) &&
           is(setup.pairs[setup.pair_of(1, 0)].restitution, 0.5) &&
           is(setup.pairs[setup.pair_of(1, 1)].restitution, 0.7);
  }
  assert_true(good);
}

// What the tables of effects say holds for all that say nothing else.
void other_tables_say_what_holds_for_all(void **) {
  bool good = true;
  {
    const std::string steel = "[[material]]\nname = \"steel\"\n[[material]]\nname = \"glass\"\nstiffness = 1e4\n";
    const dem::Setup setup = read(kSpheres + "restitution = 0.6\n[contact]\nstiffness = 3e4\n" + steel +
                                  "[[pair]]\nmaterials = [\"steel\", \"steel\"]\nrestitution = 0.7\n")
                                 .setup;
    good = is(setup.materials[0].contact.stiffness, 3e4) && is(setup.materials[1].contact.stiffness, 1e4) &&
           is(setup.pairs[setup.pair_of(0, 1)].restitution, 0.6) &&
           is(setup.pairs[setup.pair_of(0, 0)].restitution, 0.7);
  }
  assert_true(good);
}

// A picture of a run has masses and materials, which stay unless the group says something else.
bool files_bring_them() {
  const std::string file =
      (std::filesystem::temp_directory_path() / ("hgrid-test-masses-" + std::to_string(getpid()) + ".csv")).string();
  std::ofstream(file) << "x,y,z,radius,mass,material\n0,0,0,1,5,1\n9,0,0,1,inf,0\n0,9,0,1,3,1\n";
  const std::string group = "[[particles]]\nfile = \"" + file + "\"\n", time = "[time]\nsteps = 1\n",
                    rest = time + "[contact]\nstiffness = 1e4\n",
                    steel = "[[material]]\nname = \"steel\"\nstiffness = 5e4\n";
  const dem::Setup plain = read(group + rest).setup, dense = read(group + "density = 3\n" + rest).setup,
                   both = read(group + rest + kGlass + steel).setup,
                   glass = read(group + "material = \"glass\"\n" + rest + kGlass + steel).setup,
                   light = read(group + "material = \"steel\"\n" + rest + kGlass + steel).setup;
  const std::vector<double> masses = {5, dem::kImmovable, 3};
  const bool stay = plain.masses == masses && both.masses == masses && light.masses == masses &&
                    both.material_ids == std::vector<uint8_t>{1, 0, 1};
  const bool give_way = is(dense.masses[1], 4 * dem::kPi) && is(glass.masses[0], 8 * dem::kPi / 3);
  const bool refused =
      is_refused(group + rest + kGlass, ":2: particles.file: particle 1 is of material 1, and the scene has 1");
  const std::string in_units = group + time + "[contact]\nstiffness = \"1e4 N/m\"\n";
  const bool in_si = read(in_units).setup.masses == masses;
  std::ofstream(file) << "x,y,z,radius\n0,0,0,1\n";
  const bool silent = is_refused(in_units, ":1: particles.density: is needed beside numbers with units");
  std::filesystem::remove(file);
  return stay && give_way && refused && in_si && silent;
}

void files_bring_masses_and_materials(void **) { assert_true(files_bring_them()); }

void walls_name_their_material(void **) {
  bool good = true;
  {
    const std::string box = "[box]\nmax = [9, 9, 9]\nwalls = \"z\"\n";
    const dem::Setup setup = read(kSpheres + kGlass + kSteel + kPairs + box + "material = \"steel\"\n").setup;
    good = setup.wall_materials[4] == 1 && setup.wall_materials[5] == 1;
  }
  assert_true(good);
}

const std::string kOne =
    "[[particles]]\nat = [[1, 1, 1], [4, 1, 1]]\nradius = 1\nmaterial = \"glass\"\n[time]\n"
    "steps = 10\n[dissipation]\nrestitution = 0.6\n[box]\nmax = [9, 9, 9]\n";
const std::string kGlassModulus = "[[material]]\nname = \"glass\"\ndensity = 2\nmodulus = 1e5\n";

// One material for all is that of a scene without any; another one of walls is not.
void one_material_is_no_effect(void **) {
  bool plain = false, of_walls = false, apart = false, paired = false;
  {
    const dem::Setup setup = read(kOne + kGlassModulus).setup;
    plain = setup.effects == (dem::kDissipation | dem::kModulus | dem::kWalls) && is(setup.contact.modulus, 1e5) &&
            setup.contact.wall_modulus == 0 && setup.material_ids.empty() && setup.materials.empty();
    const dem::Setup same = read(kOne + "material = \"glass\"\n" + kGlassModulus +
                                 "[[pair]]\nmaterials = [\"glass\", \"glass\"]\nrestitution = 0.9\n")
                                .setup;
    of_walls = !has(same.effects, dem::kMaterials) && is(same.contact.wall_modulus, 1e5) &&
               is(same.contact.restitution, 0.9) && same.wall_materials[0] == -1;
    const std::string steel = "[[material]]\nname = \"steel\"\nmodulus = 2e5\n";
    apart = has(read(kOne + "material = \"steel\"\n" + kGlassModulus + steel).setup.effects, dem::kMaterials);
    const std::string pair = "[[pair]]\nmaterials = [\"glass\", \"glass\"]\nrestitution = 0.9\n";
    paired = has(read(kOne + kGlassModulus + pair).setup.effects, dem::kMaterials);  // plain walls have 0.6
  }
  assert_true(plain && of_walls && apart && paired);
}

void faults_of_materials_are_named(void **) {
  const std::string all = kSpheres + kGlass + kSteel;
  assert_true(is_refused(kSpheres + kGlass + kGlass, ":17: material.name: there are two materials 'glass'"));
  assert_true(is_refused(kSpheres + kGlass, ":8: particles.material cannot be 'steel'", "known are glass"));
  assert_true(is_refused(scene_text::kBasic + kGlass, ":2: particles.material: each group of a scene with", "glass"));
  assert_true(is_refused(kSpheres + kGlass + "[[material]]\nname = \"steel\"\n",
                         ":16: material.stiffness: is needed, here or for all materials in [contact]"));
  assert_true(is_refused(all + "modulus = 1\n", ":15: material.stiffness: stands beside a modulus"));
  assert_true(is_refused(all + "young_modulus = 1\n", ":20: material.young_modulus: means nothing without [hertz]"));
  assert_true(is_refused(all + "desnity = 1\n", ":20: 'desnity' is no key", "'density'?"));
  assert_true(is_refused(kSpheres + kGlass + "[[material]]\ndensity = 1\n", ":16: material.name: each material needs"));
  assert_true(is_refused(kSpheres + kGlass + "[[material]]\nname = \"steel\"\nstiffness = -1\n",
                         ":18: material.stiffness: lies above 0, not at -1"));
  assert_true(is_refused("[[particles]]\nat = [[0, 0, 0]]\nradius = 1\nmaterial = \"glass\"\ndensity = 3\n" + kGlass +
                             "[time]\nsteps = 1\n",
                         ":5: particles.density: stands in the material of the group"));
  assert_true(is_refused(scene_text::kBasic + "[box]\nmax = [9, 9, 9]\nmaterial = \"glass\"\n",
                         ":11: box.material: the scene has no [[material]]"));
}

void faults_of_pairs_are_named(void **) {
  const std::string all = kSpheres + kGlass + kSteel;
  const std::string glass = "[[pair]]\nmaterials = [\"glass\", \"glass\"]\n";
  assert_true(is_refused(all,
                         ":1: pair: restitution of glass with glass is given neither in a [[pair]] nor for all in "
                         "[dissipation]"));
  assert_true(
      is_refused(all + glass + "restitution = 0.9\n", ":20: pair: restitution of glass with steel is given neither"));
  assert_true(is_refused(all + kPairs + "[box]\nmax = [9, 9, 9]\n", "", "restitution of glass with walls is given"));
  assert_true(is_refused(all + kPairs + glass, ":30: pair.materials: the pair glass, glass is given twice"));
  assert_true(
      is_refused(all + "[[pair]]\nmaterials = [\"steel\", \"wood\"]\n", ":21: pair.materials cannot be 'wood'"));
  assert_true(is_refused(all + "[[pair]]\nmaterials = [\"steel\"]\n", ":21: pair.materials: a pair is of two"));
  assert_true(is_refused(all + glass + "restitution = 2\n", ":22: pair.restitution: lies in (0, 1], not at 2"));
  assert_true(is_refused(all + glass + "friction = 1\n", ":22: pair.friction: means nothing without [friction]"));
  assert_true(is_refused(scene_text::kBasic + glass, ":9: pair: needs [[material]]"));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(scenes_have_materials),
      cmocka_unit_test(other_tables_say_what_holds_for_all),
      cmocka_unit_test(files_bring_masses_and_materials),
      cmocka_unit_test(walls_name_their_material),
      cmocka_unit_test(one_material_is_no_effect),
      cmocka_unit_test(faults_of_materials_are_named),
      cmocka_unit_test(faults_of_pairs_are_named),
  };
  return cmocka_run_group_tests_name("material scenes", tests, nullptr, nullptr);
}
