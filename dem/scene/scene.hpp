// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A scene: what a TOML file says about a simulation, stage by stage.
#pragma once

#include "dem/engine/engine.hpp"
#include "dem/scene/settings.hpp"
#include "dem/scene/table.hpp"
#include "dem/setup/setup.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace scene {

struct OutputPlan {
  std::string directory;
  std::vector<std::string> formats;
  bool work = false, bulk = false, contacts = false;  // written too
  // In steps; 0: never.
  uint64_t pictures = 0, energies = 0, checkpoints = 0;
};

// One stage of a scene, ready to run; a scene without stages is one.
struct Scene {
  std::string title;
  size_t stage = 0;
  std::string stage_name;  // empty where the scene has no stages
  dem::Handover start;     // what the stage before has left; of the first one empty
  dem::Setup setup;
  std::vector<uint8_t> material_ids;  // of all particles, also where one law holds for all and the setup has none
  dem::Precision precision = dem::Precision::kDouble;
  uint64_t steps = 0;  // at its end, those of the stages before included
  double shortest_contact = 0;
  OutputPlan output;
  std::vector<std::string> unused;  // columns of its particle files
};

// The box of the first source of particles that has one.
struct SourceBox {
  bool is_there = false, is_tilted = false;
  double min[3]{}, max[3]{};
};

// A scene file that has been read, and its particles. Each stage starts from what the one before has left.
class StagedScene {
 public:
  // `settings` stand instead of what the file says. Throws dem::Error naming file and line of what is wrong, in any
  // stage as far as that can be told from the particles at the start.
  explicit StagedScene(const std::string &path, const std::vector<Setting> &settings = {});
  StagedScene(const StagedScene &) = delete;
  StagedScene &operator=(const StagedScene &) = delete;

  size_t count() const { return stages_.empty() ? 1 : stages_.size(); }
  Scene first() const { return read_stage(0, {particles_, {}}); }
  // The next stage, from what the engine of the one before has left.
  Scene after(const Scene &before, dem::Handover left) const;
  // Stage `number`, counted from 0, with its start as the scene of that stage tells it.
  Scene at(size_t number, const dem::Handover &start) const;

 private:
  // What the file says about a stage.
  Table top_of(size_t number) const { return stages_.empty() ? top_ : top_.under(stages_[number]); }
  Scene read_stage(size_t number, const dem::Handover &before) const;
  void read_particles();

  SceneFile file_;
  std::string folder_;  // where relative file names start from
  Table top_;
  std::vector<Table> stages_;
  int dimension_ = 3;
  dem::ParticleArrays particles_;
  SourceBox source_box_;
  std::vector<std::string> unused_;
};

// Enough to go on from, to the same bits: the engine's state and how its stage began.
void save(const Scene &scene, const dem::Engine &engine, dem::Checkpoint &checkpoint);
// The stage that a checkpoint was made in.
Scene stage_of(const StagedScene &stages, const dem::Checkpoint &checkpoint);

// The first stage of a scene.
Scene read_scene(const std::string &path, const std::vector<Setting> &settings = {});

}  // namespace scene
