// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Reads a scene: its tables in the order in which they depend on each other.
#include "dem/scene/scene.hpp"

#include "dem/base/error.hpp"
#include "dem/scene/effect_tables.hpp"
#include "dem/scene/materials.hpp"
#include "dem/scene/particles.hpp"
#include "dem/scene/silent_units.hpp"
#include "dem/scene/table.hpp"
#include "dem/setup/time_step.hpp"
#include "particles/files/format.hpp"
#include "particles/text/lists.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace scene {
namespace {

// The box of the scene, or else that of the first source which has one.
void read_box(const Table &top, const std::vector<particles::ParticleSet> &sources, dem::Setup &setup) {
  const auto dimension = static_cast<size_t>(setup.dimension);
  const auto box = top.part("box");
  bool bounded = true;
  if (box) {
    const std::vector<double> low = box->vector("min", dimension, 0), high = box->vector("max", dimension);
    std::copy(low.begin(), low.end(), setup.box_min);
    std::copy(high.begin(), high.end(), setup.box_max);
    for (size_t axis = 0; axis < dimension; axis++) {
      if (!(high[axis] > low[axis])) box->fail("max", dem::text(high[axis]) + " is not above " + dem::text(low[axis]));
    }
  } else {
    const auto boxed =
        std::find_if(sources.begin(), sources.end(), [](const particles::ParticleSet &set) { return set.has_box; });
    bounded = boxed != sources.end();
    if (bounded) {
      if (boxed->is_tilted()) top.fail("box", "the box of the particles' file is tilted: give one along the axes");
      std::copy_n(boxed->box_min, 3, setup.box_min);
      std::copy_n(boxed->box_max, 3, setup.box_max);
    }
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
  const double smallest = *std::min_element(scene.setup.radii.begin(), scene.setup.radii.end());
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

void read_time(const Table &top, Scene &scene) {
  const auto time = top.part("time");
  if (!time) top.fail("time", "a scene needs the table [time] with end or steps");
  dem::Setup &setup = scene.setup;
  try {
    setup.scheme =
        dem::scheme_of_name(time->choice("scheme", {"velocity-verlet", "symplectic-euler", "leapfrog", "forest-ruth"}));
    scene.shortest_contact = dem::shortest_contact(setup).duration;
  } catch (const dem::Error &error) {
    top.fail("time", error.what());
  }
  if (time->has("step") && time->has("steps_per_contact")) time->fail("step", "stands instead of steps_per_contact");
  setup.time_step = time->number("step", dem::usual_step(setup));
  if (time->has("steps_per_contact")) {
    const double per_contact = time->number("steps_per_contact");
    if (!(per_contact > 0)) time->fail("steps_per_contact", dem::text(per_contact) + " is not above 0");
    setup.time_step = scene.shortest_contact / per_contact;
  }
  if (time->has("end") == time->has("steps")) time->fail("end", "give either end or steps");
  const double end = time->number("end", 0);
  if (time->has("end") && !(end > 0)) time->fail("end", dem::text(end) + " is not above 0");
  try {
    dem::require_time_step(setup);
  } catch (const dem::Error &error) {
    time->fail("step", error.what());
  }
  scene.steps = time->has("steps") ? time->count("steps")
                                   : steps_in(*time, "end", std::ceil(end / setup.time_step * (1 - 1e-12)));
}

uint64_t steps_of(const Table &output, const char *key, double time_step, uint64_t fallback) {
  if (!output.has(key)) return fallback;
  const double interval = output.number(key);
  if (!(interval > 0)) output.fail(key, dem::text(interval) + " is not above 0");
  return std::max<uint64_t>(1, steps_in(output, key, std::round(interval / time_step)));
}

void read_output(const Table &top, const std::string &path, Scene &scene) {
  OutputPlan &plan = scene.output;
  plan.directory = std::filesystem::path(path).stem().string() + "-output";
  plan.formats = {"vtp"};
  plan.energies = std::max<uint64_t>(1, scene.steps / 100);
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

}  // namespace

Scene read_scene(const std::string &path, const std::vector<Setting> &settings) {
  const SceneFile file(path, settings);
  const Table top = file.top();
  Scene scene;
  scene.title = top.text("title", "");
  const uint64_t dimension = top.count("dimension", 3);
  if (dimension != 2 && dimension != 3) top.fail("dimension", "is 2 or 3, not " + std::to_string(dimension));
  scene.setup.dimension = static_cast<int>(dimension);
  read_effects(top, scene.setup);
  read_materials(top, scene.setup);
  const std::vector<Table> groups = top.parts("particles");
  if (groups.empty()) top.fail("particles", "a scene needs at least one table [[particles]]");
  refuse_silent_units(top);
  const std::string folder = std::filesystem::path(path).parent_path().string();
  std::vector<particles::ParticleSet> sources;
  sources.reserve(groups.size());
  for (const Table &group : groups) sources.push_back(add_particles(group, folder, scene.setup));
  for (const particles::ParticleSet &source : sources)
    scene.unused.insert(scene.unused.end(), source.unused.begin(), source.unused.end());
  read_box(top, sources, scene.setup);
  settle_materials(top, scene.setup);
  add_shear_profile(scene.setup);
  read_run(top, scene);
  read_time(top, scene);
  read_output(top, path, scene);
  return scene;
}

}  // namespace scene
