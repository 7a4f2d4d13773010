// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A scene: what a TOML file says about a simulation, stage by stage.
#pragma once

#include "dem/engine/engine.hpp"
#include "dem/scene/departure.hpp"
#include "dem/scene/settings.hpp"
#include "dem/scene/table.hpp"
#include "dem/setup/setup.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace scene {

struct OutputPlan {
  std::string directory;
  std::vector<std::string> formats;
  bool work = false, bulk = false, contacts = false;  // written too
  std::vector<dem::Region> regions;                   // in which particles are counted
  // In steps; 0: never.
  uint64_t pictures = 0, energies = 0, checkpoints = 0;
};

// One stage of a scene, ready to run; a scene without stages is one.
struct Scene {
  std::string title;
  size_t stage = 0;
  std::string stage_name;  // empty where the scene has no stages
  // What it goes on from: what the stage before has left, or a checkpoint; none at the start of a scene.
  std::optional<dem::Handover> start;
  double former_shear_rate = 0;  // of the profile that its velocities have
  dem::Setup setup;
  std::vector<std::string> materials;  // their names
  int only_material = -1;              // of all particles, where one law holds for all and the setup has none
  dem::Precision precision = dem::Precision::kDouble;
  uint64_t steps = 0;  // at its end, those of the stages before included
  double shortest_contact = 0;
  OutputPlan output;
  std::vector<std::string> unused;  // columns of its particle files
};

// A scene file that has been read, and its particles. Each stage starts from what the one before has left.
class StagedScene {
 public:
  // `settings` stand instead of what the file says. Throws dem::Error naming file and line of what is wrong, in any
  // stage as far as that can be told from the particles at the start.
  // With `from` the particles are those that a run has left, instead of [[particles]].
  explicit StagedScene(const std::string &path, const std::vector<Setting> &settings = {},
                       std::optional<Departure> from = std::nullopt);
  StagedScene(const StagedScene &) = delete;
  StagedScene &operator=(const StagedScene &) = delete;

  size_t count() const { return stages_.empty() ? 1 : stages_.size(); }
  Scene first() const;
  // The next stage, from what the engine of the one before has left.
  Scene after(const Scene &before, dem::Handover left) const;
  // Stage `number`, counted from 0, with its start as the scene of that stage tells it.
  Scene at(size_t number, const dem::Handover &start) const;

 private:
  // What the file says about a stage.
  Table top_of(size_t number) const { return stages_.empty() ? top_ : top_.under(stages_[number]); }
  Scene read_stage(size_t number, const dem::Handover &before) const;
  void read_particles();
  void take_over(Departure from);

  SceneFile file_;
  std::string folder_;  // where relative file names start from
  Table top_;
  std::vector<Table> stages_;
  int dimension_ = 3;
  dem::ParticleArrays particles_;
  SourceBox source_box_;  // of the first source of particles that has one
  bool goes_on_ = false;  // from a checkpoint
  dem::Beginning beginning_;
  double former_shear_rate_ = 0;
  std::vector<std::string> unused_;
};

// Enough to go on from, to the same bits: the engine's state and how its stage began; and what other scenes can go on
// from.
void save(const Scene &scene, dem::Engine &engine, dem::Checkpoint &checkpoint);
// The same scene and the stage that a checkpoint of it was made in, into which an engine is to be restored.
std::optional<Departure> start_in(const dem::Checkpoint &checkpoint);
Scene stage_of(const StagedScene &stages, const dem::Checkpoint &checkpoint);
// What another scene goes on from, at time 0. Throws dem::Error if an earlier version has made the checkpoint.
Departure end_in(const dem::Checkpoint &checkpoint);

// The first stage of a scene.
Scene read_scene(const std::string &path, const std::vector<Setting> &settings = {});

}  // namespace scene
