// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Stages of a scene: what they take over, what they change, what is refused.
#include "dem/scene/scene.hpp"
#include "tests/dem/gas.hpp"
#include "tests/support/frame.h"
#include "tests/support/refusal.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

namespace {

constexpr uint64_t kSeed = 3;

// A ball that falls and rolls, far from anything.
const std::string kBall =
    "[[particles]]\nat = [[0, 0, 0]]\nradius = 1\nvelocity = [1, 0, 0]\n[contact]\nstiffness = 1e4\n";

std::string write_file(const std::string &text) {
  std::string path =
      (std::filesystem::temp_directory_path() / ("hgrid-test-stages-" + std::to_string(getpid()) + ".toml")).string();
  std::ofstream(path) << text;
  return path;
}

// All stages one after the other; what is left at the end of each.
std::vector<dem::Handover> ends_of_stages(const std::string &text, std::vector<dem::EffectSet> *effects = nullptr) {
  const std::string path = write_file(text);
  const scene::StagedScene stages(path);
  std::filesystem::remove(path);  // it has been read
  std::vector<dem::Handover> ends;
  scene::Scene last;
  for (size_t k = 0; k < stages.count(); k++) {
    const scene::Scene scene = k == 0 ? stages.first() : stages.after(last, ends.back());
    const auto engine = dem::make_engine(scene.setup, scene.precision);
    engine->run(scene.steps - engine->steps_done());
    ends.push_back(engine->hand_over());
    last = scene;
    if (effects != nullptr) effects->push_back(scene.setup.effects);
  }
  return ends;
}

std::string error_of(const std::string &text) {
  const std::string path = write_file(text);
  std::string what = test::error_of([&] { scene::StagedScene stages(path); });
  if (what.compare(0, path.size(), path) == 0) what.erase(0, path.size());
  std::filesystem::remove(path);
  return what;
}

bool near(double value, double expected) {
  const bool good = std::fabs(value - expected) < 1e-9 * std::max(1.0, std::fabs(expected));
  if (!good) std::printf("%.17g where %.17g is expected\n", value, expected);
  return good;
}

// Falls for a time T, flies on without weight for 2 T, rises under the opposite weight for T.
bool falls_and_flies_on() {
  std::vector<dem::EffectSet> effects;
  const std::vector<dem::Handover> ends =
      ends_of_stages(kBall +
                         "[gravity]\nacceleration = [0, 0, -2]\n[time]\nstep = 0.00390625\n"
                         "[[stage]]\nname = \"fall\"\nduration = 0.5\n"
                         "[[stage]]\nname = \"fly\"\nsteps = 256\ngravity = false\n"
                         "[[stage]]\nname = \"rise\"\nduration = 0.5\n[stage.gravity]\nacceleration = [0, 0, 2]\n"
                         "[stage.time]\nstep = 0.001953125\n",
                     &effects);
  const double T = 0.5, fall = -2 * T * T / 2, speed = -2 * T;
  const auto &x = [&](size_t k) { return ends[k].particles.centers; };
  const auto &v = [&](size_t k) { return ends[k].particles.velocities; };
  return effects == std::vector<dem::EffectSet>{dem::kGravity, 0, dem::kGravity} &&  //
         near(x(0)[2], fall) && near(v(0)[2], speed) && near(x(0)[0], T) &&          //
         near(x(1)[2], fall + 2 * T * speed) && near(v(1)[2], speed) &&              //
         near(x(2)[2], 2 * fall + 2 * T * speed) && near(v(2)[2], 0) &&              //
         near(ends[2].beginning.time, 4 * T) && ends[2].beginning.step == 128 + 256 + 256;
}

void each_stage_has_effects_and_steps_of_its_own(void **) { assert_true(falls_and_flies_on()); }

// A stage says what differs, key by key.
bool keys_lie_over_those_of_the_scene() {
  const std::string path =
      write_file(kBall +
                 "[friction]\ncoefficient = 0.5\nstiffness = 0.25\n"
                 "[[stage]]\nsteps = 1\n[[stage]]\nsteps = 1\n[stage.friction]\ncoefficient = 0.1\n"
                 "[stage.contact]\nstiffness = false\nmodulus = 1e4\n");
  const scene::StagedScene stages(path);
  std::filesystem::remove(path);
  const dem::Setup before = stages.first().setup, after = stages.at(1, {stages.first().setup, {}}).setup;
  return before.contact.friction == 0.5 && after.contact.friction == 0.1 &&
         after.contact.tangential_stiffness == 0.25 && after.effects == (before.effects | dem::kModulus);
}

void a_stage_says_only_what_differs(void **) { assert_true(keys_lie_over_those_of_the_scene()); }

bool particles_change() {
  const std::vector<dem::Handover> ends = ends_of_stages(
      "[[particles]]\nat = [[0, 0, 0], [5, 0, 0], [10, 0, 0]]\nradius = 1\ndensity = 2\n"
      "[contact]\nstiffness = 1e4\n[[stage]]\nsteps = 1\n"
      "[[stage]]\nsteps = 1\nremove = [[4, -1, -1], [6, 1, 1]]\n"
      "[[stage.particles]]\nat = [[0, 7, 0]]\nradius = 2\nvelocity = [0, 0, 3]\n");
  const dem::ParticleArrays &last = ends[1].particles;
  return ends[0].particles.count() == 3 && last.radii == std::vector<double>{1, 1, 2} && last.centers[3] == 10 &&
         last.centers[7] == 7 && last.velocities == std::vector<double>{0, 0, 0, 0, 0, 0, 0, 0, 3} &&
         near(last.masses[1], 8 * bodies::kPi / 3);
}

void particles_go_and_come_where_stages_meet(void **) { assert_true(particles_change()); }

// All of one material at first, which leaves one law for all; then another comes in.
bool materials_go_along() {
  const std::string path = write_file(
      "[[material]]\nname = \"glass\"\nstiffness = 1e4\n[[material]]\nname = \"steel\"\nstiffness = 2e4\n"
      "[[particles]]\nat = [[0, 0, 0], [5, 0, 0]]\nradius = 1\nmaterial = \"glass\"\n"
      "[[stage]]\nsteps = 1\n[[stage]]\nsteps = 1\n"
      "[[stage.particles]]\nat = [[0, 7, 0]]\nradius = 1\nmaterial = \"steel\"\n");
  const scene::StagedScene stages(path);
  std::filesystem::remove(path);
  const scene::Scene first = stages.first();
  const auto engine = dem::make_engine(first.setup);
  engine->run(1);
  const dem::Setup second = stages.after(first, engine->hand_over()).setup;
  return first.setup.effects == 0 && second.effects == dem::kMaterials &&
         second.material_ids == std::vector<uint8_t>{0, 0, 1};
}

void materials_go_along_from_stage_to_stage(void **) { assert_true(materials_go_along()); }

// What is left without the second of three particles, and what its contacts remember.
bool contacts_stay_with_their_particles() {
  dem::Handover all;
  all.particles.centers = {0, 1, 2, 3, 4, 5};
  all.particles.radii = {1, 2, 3};
  all.beginning.pairs.pairs = {{0, 1}, {0, 2}, {1, 2}};
  all.beginning.pairs.rows[0] = {1, 2, 3, 4, 5, 6};
  all.beginning.walls.pairs = {{1, 0}, {2, 3}};
  all.beginning.walls.rows[0] = {7, 8, 9, 10};
  const dem::Handover rest = dem::without(all, {false, true, false});
  const dem::ContactMemory &pairs = rest.beginning.pairs, &walls = rest.beginning.walls;
  return rest.particles.centers == std::vector<double>{0, 1, 4, 5} &&
         rest.particles.radii == std::vector<double>{1, 3} && pairs.pairs.size() == 1 && pairs.pairs[0].a == 0 &&
         pairs.pairs[0].b == 1 && pairs.rows[0] == std::vector<double>{3, 4} && walls.pairs.size() == 1 &&
         walls.pairs[0].a == 1 && walls.pairs[0].b == 3 && walls.rows[0] == std::vector<double>{9, 10};
}

void who_stays_keeps_its_contacts(void **) { assert_true(contacts_stay_with_their_particles()); }

// A dense gas with everything that contacts remember. Without dashpots, since these take velocities half a step old,
// but at the beginning those of the time.
dem::Setup rough_setup(int dimension) {
  bodies::Gas gas;
  gas.dimension = dimension;
  gas.edge = dimension == 3 ? 6 : 16;
  gas.spacing = 1.98;
  gas.temperature = 4;
  gas.effects = dem::kFriction | dem::kRolling;
  dem::Setup setup = bodies::make_gas(gas, kSeed);
  setup.contact.friction = 0.4;
  setup.contact.rolling_friction = 0.1;
  for (int axis = 0; axis < dimension; axis++) {
    bodies::set_walls(setup, axis, setup.box_min[axis], setup.box_max[axis]);
  }
  bodies::set_steps_per_contact(setup, 50);
  return setup;
}

dem::Setup taking_over(dem::Setup setup, const dem::Handover &handover) {
  static_cast<dem::ParticleArrays &>(setup) = handover.particles;
  setup.beginning = handover.beginning;
  return setup;
}

double largest_difference(const dem::Snapshot &a, const dem::Snapshot &b) {
  double largest = 0;
  for (const auto &[x, y] :
       {std::pair(&a.centers, &b.centers), std::pair(&a.velocities, &b.velocities), std::pair(&a.spins, &b.spins)}) {
    for (size_t k = 0; k < x->size(); k++) largest = std::max(largest, std::fabs((*x)[k] - (*y)[k]));
  }
  return largest;
}

struct Seam {
  double with_memory = 0, without = 0;
  size_t springs = 0;
};

// A stage that changes nothing against none at all: only rounding may differ. Particles are sorted anew in between, so
// pairs change their order; without what contacts remember the states differ.
Seam seam(const dem::Setup &setup) {
  const auto whole = dem::make_engine(setup), first = dem::make_engine(setup);
  whole->run(200);
  first->run(160);
  dem::Handover handover = first->hand_over();
  Seam result;
  result.springs = handover.beginning.pairs.pairs.size();
  const auto second = dem::make_engine(taking_over(setup, handover));
  second->run(40);
  result.with_memory = largest_difference(whole->snapshot(), second->snapshot());
  handover.beginning.pairs = handover.beginning.walls = {};
  const auto forgetful = dem::make_engine(taking_over(setup, handover));
  forgetful->run(40);
  result.without = largest_difference(whole->snapshot(), forgetful->snapshot());
  std::printf("seam: %.3g with the springs of %zu contacts, %.3g without\n", result.with_memory, result.springs,
              result.without);
  return result;
}

void a_stage_that_changes_nothing_leaves_no_seam(void **) {
  for (const int dimension : {2, 3}) {
    const Seam result = seam(rough_setup(dimension));
    assert_true(result.springs > 20);
    assert_true(result.with_memory < 1e-10);
    assert_true(result.without > 1e-5);
  }
}

double seam_of_shear() {
  bodies::Gas gas;
  gas.edge = 5;
  gas.spacing = 2.02;
  return seam(bodies::make_sheared_gas(gas, 1.5, kSeed)).with_memory;
}

void images_stay_where_shear_has_moved_them(void **) { assert_true(seam_of_shear() < 1e-10); }

// Rough balls of two materials in a swinging box; what follows differs in gravity and friction.
const std::string kBegins =
    "[[particles]]\nlattice = {counts = [4, 4, 4], spacing = 1.99, origin = [1, 1, 1]}\nradius = 1\ntemperature = 2\n"
    "material = \"glass\"\n[[particles]]\nat = [[4, 4, 9.2]]\nradius = 1\nmaterial = \"steel\"\n"
    "[dissipation]\nrestitution = 0.7\n[friction]\ncoefficient = 0.3\n[rolling]\ncoefficient = 0.1\n"
    "[contact]\nstiffness = 1e4\n[box]\nmax = [8, 8, 20]\n"
    "[[wall]]\nname = \"floor\"\npoint = [0, 0, 0.1]\nnormal = [0, 0, 1]\nvelocity = [0.1, 0, 0.2]\n";
const std::string kGlass = "[[material]]\nname = \"glass\"\ndensity = 2\n",
                  kSteel = "[[material]]\nname = \"steel\"\ndensity = 7\n";
const std::string kGravity = "gravity]\nacceleration = [0, 0, -3]\n", kRougher = "friction]\ncoefficient = 0.6\n";

dem::Checkpoint checkpoint_after(const scene::StagedScene &stages, size_t stage_count) {
  scene::Scene scene = stages.first();
  for (size_t stage = 0;; stage++) {
    const auto engine = dem::make_engine(scene.setup, scene.precision);
    engine->run(scene.steps - engine->steps_done());
    if (stage + 1 < stage_count) {
      scene = stages.after(scene, engine->hand_over());
      continue;
    }
    dem::Checkpoint checkpoint;
    scene::save(scene, *engine, checkpoint);
    return checkpoint;
  }
}

// Another scene goes on from a checkpoint as a stage would, without particles of its own, its materials in another
// order.
bool goes_on_as_a_stage() {
  const std::string whole =
      write_file(kBegins + kGlass + kSteel + "[[stage]]\nsteps = 300\n[[stage]]\nsteps = 200\n[stage." + kGravity +
                 "[stage." + kRougher);
  const dem::Checkpoint expected = checkpoint_after(scene::StagedScene(whole), 2);
  const std::string begins = write_file(kBegins + kGlass + kSteel + "[time]\nsteps = 300\n");
  const dem::Checkpoint left = checkpoint_after(scene::StagedScene(begins), 1);
  std::string text =
      kBegins.substr(kBegins.find("[dissipation]")) + kSteel + kGlass + "[time]\nsteps = 200\n[" + kGravity;
  text.replace(text.find("[friction]\ncoefficient = 0.3"), 28, "[friction]\ncoefficient = 0.6");
  const std::string goes_on = write_file(text);
  const scene::StagedScene stages(goes_on, {}, scene::end_in(left));
  const dem::Checkpoint found = checkpoint_after(stages, 1);
  const dem::Handover a = scene::end_in(expected).state, b = scene::end_in(found).state;
  const bool same = a.particles.centers == b.particles.centers && a.particles.velocities == b.particles.velocities &&
                    a.particles.spins == b.particles.spins && a.particles.masses == b.particles.masses &&
                    a.beginning.pairs.rows[0] == b.beginning.pairs.rows[0];
  std::printf("from a checkpoint: %zu springs, floor at %.3f\n", b.beginning.pairs.pairs.size(),
              b.beginning.wall_places[0].place.shift[2]);
  // And it can be restarted, though it has no particles of its own.
  const scene::StagedScene again(goes_on, {}, scene::start_in(found));
  const scene::Scene scene = scene::stage_of(again, found);
  const auto engine = dem::make_engine(scene.setup);
  engine->restore(found);
  std::filesystem::remove(whole);
  return same && b.beginning.pairs.pairs.size() > 20 && b.particles.material_ids.back() == 0 &&
         engine->snapshot().centers == b.particles.centers;
}

void another_scene_goes_on_as_a_stage_would(void **) { assert_true(goes_on_as_a_stage()); }

bool strangers_are_refused() {
  const std::string begins = write_file(kBegins + kGlass + kSteel + "[time]\nsteps = 1\n");
  const dem::Checkpoint left = checkpoint_after(scene::StagedScene(begins), 1);
  const auto refused = [&](const std::string &text, const char *part) {
    const std::string path = write_file(text);
    return test::is_refused(part, [&] { scene::StagedScene(path, {}, scene::end_in(left)); });
  };
  const std::string rest = kBegins.substr(kBegins.find("[dissipation]")) + "[time]\nsteps = 1\n";
  const bool all = refused(rest + kSteel,
                           ": material: the checkpoint holds particles of the material 'glass', and the "
                           "scene has steel") &&
                   refused("dimension = 2\n" + rest, ": dimension: the checkpoint is of 3 dimensions");
  std::filesystem::remove(begins);
  return all;
}

void checkpoints_that_do_not_fit_are_refused(void **) { assert_true(strangers_are_refused()); }

void faults_of_stages_are_named(void **) {
  const std::string two = kBall + "[[stage]]\nsteps = 1\n[[stage]]\nsteps = 1\n";
  const auto refused = [&](const std::string &text, const char *start) {
    const std::string what = error_of(text);
    const bool fits = what.compare(0, std::string(start).size(), start) == 0;
    if (!fits) std::printf("refused with: %s\n", what.c_str());
    return fits;
  };
  assert_string_equal(error_of(two).c_str(), "");
  assert_true(
      refused(two + "[stage.frictoin]\ncoefficient = 1\n", ":11: 'frictoin' is no key of [stage]: did you mean"));
  assert_true(refused(two + "[stage.friction]\ncoefficient = -1\n", ":12: friction.coefficient: lies at 0 or above"));
  assert_true(refused(two + "[stage.friction]\n", ":11: [friction] needs the key 'coefficient'"));
  assert_true(refused(two + "contact = false\n", ":1: contact: a scene needs [contact] or [hertz]"));
  assert_true(refused(two + "[stage.time]\nsteps = 1\n", ":12: time.steps: stands in the [[stage]] itself"));
  assert_true(refused(two + "[stage.output]\ndirectory = \"a\"\n", ":12: output.directory: is one for all stages"));
  assert_true(refused(two + "[time]\nend = 1\n", ":12: time.end: each [[stage]] has a duration of its own"));
  assert_true(refused(kBall + "[[stage]]\nname = \"a\"\n", ":7: stage.duration: give either duration or steps"));
  assert_true(refused(kBall + "[box]\nmax = [9, 9, 9]\n[periodic]\naxes = \"xyz\"\n[shear]\nrate = 1\n[[stage]]\n"
                              "steps = 1\n[[stage]]\nsteps = 1\nshear = false\n",
                      ":17: stage.shear: the images stay where shear has moved them"));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(each_stage_has_effects_and_steps_of_its_own),
      cmocka_unit_test(a_stage_says_only_what_differs),
      cmocka_unit_test(particles_go_and_come_where_stages_meet),
      cmocka_unit_test(materials_go_along_from_stage_to_stage),
      cmocka_unit_test(who_stays_keeps_its_contacts),
      cmocka_unit_test(a_stage_that_changes_nothing_leaves_no_seam),
      cmocka_unit_test(images_stay_where_shear_has_moved_them),
      cmocka_unit_test(another_scene_goes_on_as_a_stage_would),
      cmocka_unit_test(checkpoints_that_do_not_fit_are_refused),
      cmocka_unit_test(faults_of_stages_are_named),
  };
  return cmocka_run_group_tests_name("stages", tests, nullptr, nullptr);
}
