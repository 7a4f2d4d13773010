// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Reads a scene: its tables in the order in which they depend on each other.
#include "dem/scene/scene.hpp"

#include "dem/base/error.hpp"
#include "dem/scene/effect_tables.hpp"
#include "dem/scene/materials.hpp"
#include "dem/scene/particles.hpp"
#include "dem/scene/regions.hpp"
#include "dem/scene/silent_units.hpp"
#include "dem/scene/table.hpp"
#include "dem/scene/walls.hpp"
#include "dem/setup/time_step.hpp"
#include "particles/files/format.hpp"
#include "particles/text/lists.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace scene {
namespace {

// The box of the scene, or else that of the first source which has one.
void read_box(const Table &top, const SourceBox &source, dem::Setup &setup) {
  const auto dimension = static_cast<size_t>(setup.dimension);
  const auto box = top.part("box");
  const bool bounded = box || source.is_there;
  if (box) {
    const std::vector<double> low = box->vector("min", dimension, 0), high = box->vector("max", dimension);
    std::copy(low.begin(), low.end(), setup.box_min);
    std::copy(high.begin(), high.end(), setup.box_max);
    for (size_t axis = 0; axis < dimension; axis++) {
      if (!(high[axis] > low[axis])) box->fail("max", dem::text(high[axis]) + " is not above " + dem::text(low[axis]));
    }
  } else if (bounded) {
    if (source.is_tilted) top.fail("box", "the box of the particles' file is tilted: give one along the axes");
    std::copy_n(source.min, 3, setup.box_min);
    std::copy_n(source.max, 3, setup.box_max);
  }
  if (!bounded && has(setup.effects, dem::kPeriodic)) top.fail("periodic", "periodic axes need a [box]");
  if (box && box->has("walls")) {
    box->axes("walls", setup.dimension, setup.walled);
    for (size_t axis = 0; axis < dimension; axis++) {
      if (setup.walled[axis] && setup.periodic[axis]) box->fail("walls", "a periodic axis has no walls");
    }
  } else {
    for (size_t axis = 0; axis < dimension; axis++) setup.walled[axis] = bounded && !setup.periodic[axis];
  }
  if (setup.walled[0] || setup.walled[1] || setup.walled[2]) setup.effects |= dem::kWalls;
  if (box) std::fill(std::begin(setup.wall_materials), std::end(setup.wall_materials), material_in(*box, setup));
}

void read_run(const Table &top, Scene &scene) {
  double smallest = dem::kInfinity;
  visit_particles(scene.setup, [&](const dem::ParticleArrays &particles, size_t i) {
    smallest = std::min(smallest, particles.radii[i]);
  });
  scene.setup.skin = 0.1 * smallest;
  const auto run = top.part("run");
  if (!run) return;
  scene.setup.threads = static_cast<int>(std::min<uint64_t>(run->count("threads", 1), 1024));
  scene.setup.skin = run->number("skin", scene.setup.skin);
  if (scene.setup.skin < 0) run->fail("skin", dem::text(scene.setup.skin) + " is negative");
  if (run->choice("precision", {"double", "float"}) == "float") scene.precision = dem::Precision::kFloat;
}

// How many steps an interval is, which must be a number that a double counts to.
uint64_t steps_in(const Table &table, const char *key, double steps) {
  if (!(steps < 0x1p53)) table.fail(key, "is " + dem::text(steps) + " time steps, more than can be counted");
  return static_cast<uint64_t>(steps);
}

void read_time_step(const Table &top, Scene &scene) {
  const auto time = top.part("time");
  dem::Setup &setup = scene.setup;
  std::string scheme = setup.scheme.name;
  if (time) scheme = time->choice("scheme", {"velocity-verlet", "symplectic-euler", "leapfrog", "forest-ruth"});
  try {
    setup.scheme = dem::scheme_of_name(scheme);
    scene.shortest_contact = dem::shortest_contact(setup).duration;
  } catch (const dem::Error &error) {
    top.fail("time", error.what());
  }
  setup.time_step = dem::usual_step(setup);
  if (!time) return;
  if (time->has("step") && time->has("steps_per_contact")) time->fail("step", "stands instead of steps_per_contact");
  setup.time_step = time->number("step", setup.time_step);
  if (time->has("steps_per_contact")) {
    const double per_contact = time->number("steps_per_contact");
    if (!(per_contact > 0)) time->fail("steps_per_contact", dem::text(per_contact) + " is not above 0");
    setup.time_step = scene.shortest_contact / per_contact;
  }
  try {
    dem::require_time_step(setup);
  } catch (const dem::Error &error) {
    time->fail("step", error.what());
  }
}

// How many steps the scene or one stage of it takes: its key "steps", or by the time that its key `end` gives.
uint64_t read_length(const Table &table, const char *end, double time_step) {
  if (table.has(end) == table.has("steps")) table.fail(end, std::string("give either ") + end + " or steps");
  if (table.has("steps")) return table.count("steps");
  const double length = table.number(end);
  if (!(length > 0)) table.fail(end, dem::text(length) + " is not above 0");
  return steps_in(table, end, std::ceil(length / time_step * (1 - 1e-12)));
}

uint64_t steps_of(const Table &output, const char *key, double time_step, uint64_t fallback) {
  if (!output.has(key)) return fallback;
  const double interval = output.number(key);
  if (!(interval > 0)) output.fail(key, dem::text(interval) + " is not above 0");
  return std::max<uint64_t>(1, steps_in(output, key, std::round(interval / time_step)));
}

void read_output(const Table &top, const std::string &path, uint64_t length, Scene &scene) {
  OutputPlan &plan = scene.output;
  plan.directory = std::filesystem::path(path).stem().string() + "-output";
  plan.formats = {"vtp"};
  plan.energies = std::max<uint64_t>(1, length / 100);
  plan.regions = read_regions(top, scene.setup.dimension);
  const auto output = top.part("output");
  if (!output) return;
  plan.directory = output->text("directory", plan.directory);
  if (output->has("formats"))
    plan.formats = output->choices("formats", particles::names_of(particles::writable_formats()));
  plan.work = output->flag("work", false);
  plan.bulk = output->flag("bulk", false);
  plan.contacts = output->flag("contacts", false);
  for (int axis = 0; plan.bulk && axis < scene.setup.dimension; axis++) {
    if (!(scene.setup.box_max[axis] > scene.setup.box_min[axis])) output->fail("bulk", "averages are over a [box]");
  }
  plan.pictures = steps_of(*output, "every", scene.setup.time_step, 0);
  plan.energies = steps_of(*output, "energy", scene.setup.time_step, plan.energies);
  plan.checkpoints = steps_of(*output, "checkpoint", scene.setup.time_step, 0);
}

// Keys that hold for the whole run stand in no stage, and those that a stage has itself not beside stages.
void check_stages(const Table &top, const std::vector<Table> &stages) {
  if (stages.empty()) return;
  const auto refuse = [](const Table &table, const char *part, const char *key, const char *why) {
    const auto inner = table.part(part);
    if (inner && inner->has(key)) inner->fail(key, why);
  };
  refuse(top, "time", "end", "each [[stage]] has a duration of its own");
  refuse(top, "time", "steps", "each [[stage]] has steps of its own");
  for (const Table &stage : stages) {
    refuse(stage, "time", "end", "a [[stage]] has a duration instead");
    refuse(stage, "time", "steps", "stands in the [[stage]] itself");
    refuse(stage, "output", "directory", "is one for all stages");
    for (const char *key : {"formats", "work", "bulk", "contacts"}) {
      refuse(stage, "output", key, "is the same for all stages");
    }
  }
}

// Particles rotate only with friction.
void fit_spins(dem::Setup &setup) {
  const size_t size = setup.count() * (setup.dimension == 3 ? 3 : 1);
  setup.spins.resize(has(setup.effects, dem::kFriction) ? size : 0);
}

// What a stage starts from: without the particles that it removes.
dem::Handover thinned(const Table &stage, int dimension, const dem::Handover &start) {
  if (!stage.has("remove")) return start;
  const auto width = static_cast<size_t>(dimension);
  const std::vector<std::vector<double>> corners = stage.list("remove", width);
  if (corners.size() != 2) stage.fail("remove", "is a list of two corners, not " + std::to_string(corners.size()));
  const size_t count = start.particles.count();
  std::vector<bool> gone(count, true);
  for (size_t k = 0; k < count * width; k++) {
    const double x = start.particles.centers[k];
    if (x < corners[0][k % width] || x > corners[1][k % width]) gone[k / width] = false;
  }
  return without(start, gone);
}

// Files tell whether they hold masses only when they are read.
particles::ParticleSet add_group(const Table &top, const Table &group, const std::string &folder, dem::Setup &setup) {
  particles::ParticleSet source = add_particles(group, folder, setup);
  if (group.has("file") && source.column("mass") == nullptr) refuse_silent_density(top, group);
  return source;
}

// Where one law holds for all, the engine knows of no materials.
dem::Handover with_materials(const Scene &scene, dem::Handover left) {
  if (scene.only_material >= 0)
    left.particles.material_ids.assign(left.particles.count(), static_cast<uint8_t>(scene.only_material));
  return left;
}

// Who may come in a stage is there in those after it.
void add_expected(const Scene &scene, dem::ParticleArrays &particles) {
  dem::ParticleArrays more = scene.setup.expected;
  if (scene.only_material >= 0) more.material_ids.assign(more.count(), static_cast<uint8_t>(scene.only_material));
  const auto append = [](auto &all, const auto &some) { all.insert(all.end(), some.begin(), some.end()); };
  append(particles.centers, more.centers);
  append(particles.velocities, more.velocities);
  append(particles.radii, more.radii);
  append(particles.masses, more.masses);
  append(particles.material_ids, more.material_ids);
  particles.spins.clear();  // at rest
}

Departure departure_of(const Scene &scene, dem::Handover state) {
  const dem::Setup &setup = scene.setup;
  Departure departure{setup.dimension, std::move(state), {}, 0, scene.materials};
  if (has(setup.effects, dem::kShear)) departure.shear_rate = setup.shear_rate;
  departure.box.is_there = setup.box_max[0] > setup.box_min[0];
  std::copy_n(setup.box_min, 3, departure.box.min);
  std::copy_n(setup.box_max, 3, departure.box.max);
  return departure;
}

}  // namespace

StagedScene::StagedScene(const std::string &path, const std::vector<Setting> &settings, std::optional<Departure> from)
    : file_(path, settings),
      folder_(std::filesystem::path(path).parent_path().string()),
      top_(file_.top()),
      stages_(top_.parts(kStage)) {
  const uint64_t dimension = top_.count("dimension", 3);
  if (dimension != 2 && dimension != 3) top_.fail("dimension", "is 2 or 3, not " + std::to_string(dimension));
  dimension_ = static_cast<int>(dimension);
  if (stages_.empty() && !top_.has("time")) {
    top_.fail("time", "a scene needs the table [time] with end or steps, or [[stage]]");
  }
  check_stages(top_, stages_);
  if (from) {
    take_over(std::move(*from));
  } else {
    read_particles();
  }
  dem::ParticleArrays met = particles_;
  for (size_t number = 0; number < stages_.size(); number++) add_expected(read_stage(number, {met, {}}), met);
}

// Made with the effects of the first stage.
void StagedScene::read_particles() {
  dem::Setup setup;
  setup.dimension = dimension_;
  read_effects(top_of(0), setup);
  read_materials(top_of(0), setup);
  const std::vector<Table> groups = top_.parts("particles");
  const auto has_inflow = [](const Table &table) { return table.has("inflow"); };
  if (groups.empty() && !has_inflow(top_) && std::none_of(stages_.begin(), stages_.end(), has_inflow))
    top_.fail("particles", "a scene needs at least one table [[particles]] or [[inflow]]");
  refuse_silent_units(top_);
  for (const Table &group : groups) {
    const particles::ParticleSet source = add_group(top_, group, folder_, setup);
    unused_.insert(unused_.end(), source.unused.begin(), source.unused.end());
    if (!source.has_box || source_box_.is_there) continue;
    source_box_.is_there = true;
    source_box_.is_tilted = source.is_tilted();
    std::copy_n(source.box_min, 3, source_box_.min);
    std::copy_n(source.box_max, 3, source_box_.max);
  }
  particles_ = setup;
}

void StagedScene::take_over(Departure from) {
  if (from.dimension != dimension_) {
    top_.fail("dimension", "the checkpoint is of " + std::to_string(from.dimension) + " dimensions");
  }
  dem::Setup setup;
  setup.dimension = dimension_;
  read_effects(top_of(0), setup);
  read_materials(top_of(0), setup);
  try {
    renumber_materials(from, setup);
  } catch (const dem::Error &error) {
    top_.fail("material", error.what());
  }
  goes_on_ = true;
  particles_ = std::move(from.state.particles);
  beginning_ = std::move(from.state.beginning);
  source_box_ = from.box;
  former_shear_rate_ = from.shear_rate;
}

Scene StagedScene::first() const {
  const dem::Handover start{particles_, beginning_};
  return goes_on_ ? at(0, start) : read_stage(0, start);
}

Scene StagedScene::read_stage(size_t number, const dem::Handover &before) const {
  const Table top = top_of(number);
  Scene scene;
  scene.title = top_.text("title", "");
  scene.stage = number;
  scene.unused = unused_;
  dem::Setup &setup = scene.setup, former;
  setup.dimension = former.dimension = dimension_;
  const dem::Handover start = stages_.empty() ? before : thinned(stages_[number], dimension_, before);
  static_cast<dem::ParticleArrays &>(setup) = start.particles;
  setup.beginning = start.beginning;
  read_effects(top, setup);
  read_materials(top, setup);
  fit_spins(setup);
  read_box(top, source_box_, setup);
  if (number > 0) read_effects(top_of(number - 1), former);
  scene.former_shear_rate = number > 0 ? former.shear_rate : former_shear_rate_;
  if (has(former.effects, dem::kShear) && !has(setup.effects, dem::kShear)) {
    stages_[number].fail("shear", "the images stay where shear has moved them: instead of false give a rate of 0");
  }
  if (before.beginning.image_offset != 0 && !has(setup.effects, dem::kShear)) {
    top.fail("shear", "the images stay where shear has moved them: give a rate of 0 at least");
  }
  add_shear_profile(setup, scene.former_shear_rate);
  if (!stages_.empty()) {
    for (const Table &group : stages_[number].parts("particles")) add_group(top_, group, folder_, setup);
  }
  read_walls(top, folder_, setup);
  read_exchange(top, folder_, setup);
  if (setup.count() + setup.expected.count() == 0) {
    const Table &place = stages_.empty() ? top_ : stages_[number];
    place.fail(place.has("remove") ? "remove" : "particles", "leaves nothing to simulate: no particle, no [[inflow]]");
  }
  for (const dem::Material &material : setup.materials) scene.materials.push_back(material.name);
  const int first_material = setup.first_material();
  settle_materials(top, setup);
  if (!has(setup.effects, dem::kMaterials)) scene.only_material = first_material;
  read_run(top, scene);
  read_time_step(top, scene);
  uint64_t length = 0;
  if (stages_.empty()) {
    length = read_length(*top_.part("time"), "end", setup.time_step);
  } else {
    scene.stage_name = stages_[number].text("name", std::to_string(number + 1));
    length = read_length(stages_[number], "duration", setup.time_step);
  }
  scene.steps = start.beginning.step + length;
  read_output(top, file_.path(), length, scene);
  return scene;
}

Scene StagedScene::at(size_t number, const dem::Handover &start) const {
  if (number >= count()) throw dem::Error(file_.path() + ": there is no stage " + std::to_string(number + 1));
  Scene scene = read_stage(number, start);
  scene.start = start;
  return scene;
}

Scene StagedScene::after(const Scene &before, dem::Handover left) const {
  return at(before.stage + 1, with_materials(before, std::move(left)));
}

void save(const Scene &scene, dem::Engine &engine, dem::Checkpoint &checkpoint) {
  engine.save(checkpoint);
  checkpoint.put_value("stage", static_cast<uint64_t>(scene.stage));
  if (scene.start) {
    Departure start = departure_of(scene, *scene.start);
    start.shear_rate = scene.former_shear_rate;
    save(start, "start", checkpoint);
  }
  save(departure_of(scene, with_materials(scene, engine.hand_over())), "end", checkpoint);
}

std::optional<Departure> start_in(const dem::Checkpoint &checkpoint) { return departure_in(checkpoint, "start"); }

Scene stage_of(const StagedScene &stages, const dem::Checkpoint &checkpoint) {
  const auto number = static_cast<size_t>(checkpoint.get_value<uint64_t>("stage"));
  const std::optional<Departure> start = start_in(checkpoint);
  return start ? stages.at(number, start->state) : stages.first();
}

Departure end_in(const dem::Checkpoint &checkpoint) {
  std::optional<Departure> end = departure_in(checkpoint, "end");
  if (!end) throw dem::Error("the checkpoint is of an earlier version, which only --restart goes on from");
  end->state.beginning.step = 0;
  end->state.beginning.time = 0;
  return std::move(*end);
}

Scene read_scene(const std::string &path, const std::vector<Setting> &settings) {
  return StagedScene(path, settings).first();
}

}  // namespace scene
