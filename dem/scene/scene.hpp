// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A scene: what a TOML file says about a simulation.
#pragma once

#include "dem/engine/engine.hpp"
#include "dem/scene/settings.hpp"
#include "dem/setup/setup.hpp"

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

struct Scene {
  std::string title;
  dem::Setup setup;
  dem::Precision precision = dem::Precision::kDouble;
  uint64_t steps = 0;
  double shortest_contact = 0;
  OutputPlan output;
  std::vector<std::string> unused;  // columns of its particle files
};

// Reads a scene and makes its particles; `settings` stand instead of what the file says. Throws dem::Error naming file
// and line of what is wrong.
Scene read_scene(const std::string &path, const std::vector<Setting> &settings = {});

}  // namespace scene
