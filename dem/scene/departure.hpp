// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What a run leaves to a scene that goes on from it, whatever its effects, walls and parameters.
#pragma once

#include "dem/setup/setup.hpp"
#include "dem/state/checkpoint.hpp"
#include "dem/state/handover.hpp"

#include <optional>
#include <string>
#include <vector>

namespace scene {

// The box that particles come in, if they come in one.
struct SourceBox {
  bool is_there = false, is_tilted = false;
  double min[3]{}, max[3]{};
};

struct Departure {
  int dimension = 3;
  dem::Handover state;
  SourceBox box;
  double shear_rate = 0;               // of the profile that the velocities have
  std::vector<std::string> materials;  // by the numbers of the particles' materials
};

// Under the name `when`.
void save(const Departure &departure, const std::string &when, dem::Checkpoint &checkpoint);
// None if the checkpoint holds none of this name.
std::optional<Departure> departure_in(const dem::Checkpoint &checkpoint, const std::string &when);

// Gives the particles the numbers that their materials have in a setup. Throws dem::Error if it lacks one.
void renumber_materials(Departure &departure, const dem::Setup &setup);

}  // namespace scene
