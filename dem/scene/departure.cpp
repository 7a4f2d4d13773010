// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What a run leaves to a scene that goes on from it.
#include "dem/scene/departure.hpp"

#include "dem/base/error.hpp"
#include "dem/setup/materials.hpp"

#include <algorithm>
#include <cstdint>

namespace scene {
namespace {

// As in checkpoints.
struct Numbers {
  uint64_t dimension, has_box, is_tilted;
  double min[3], max[3], shear_rate;
};

}  // namespace

void save(const Departure &departure, const std::string &when, dem::Checkpoint &checkpoint) {
  const SourceBox &box = departure.box;
  Numbers numbers{static_cast<uint64_t>(departure.dimension),
                  box.is_there ? 1u : 0u,
                  box.is_tilted ? 1u : 0u,
                  {},
                  {},
                  departure.shear_rate};
  std::copy_n(box.min, 3, numbers.min);
  std::copy_n(box.max, 3, numbers.max);
  checkpoint.put_value(when + " numbers", numbers);
  checkpoint.put_texts(when + " material names", departure.materials);
  save_handover(departure.state, when, checkpoint);
}

std::optional<Departure> departure_in(const dem::Checkpoint &checkpoint, const std::string &when) {
  if (!checkpoint.holds(when + " numbers")) return std::nullopt;
  const auto numbers = checkpoint.get_value<Numbers>(when + " numbers");
  Departure departure;
  departure.dimension = static_cast<int>(numbers.dimension);
  departure.box.is_there = numbers.has_box != 0;
  departure.box.is_tilted = numbers.is_tilted != 0;
  std::copy_n(numbers.min, 3, departure.box.min);
  std::copy_n(numbers.max, 3, departure.box.max);
  departure.shear_rate = numbers.shear_rate;
  departure.materials = checkpoint.get_texts(when + " material names");
  departure.state = dem::restore_handover(when, checkpoint);
  return departure;
}

void renumber_materials(Departure &departure, const dem::Setup &setup) {
  std::vector<uint8_t> &ids = departure.state.particles.material_ids;
  if (setup.materials.empty()) {
    ids.clear();
    return;
  }
  if (ids.empty() && setup.materials.size() > 1) {
    throw dem::Error("what the checkpoint holds is of no material, and the scene has several: " +
                     dem::names_of(setup.materials));
  }
  ids.resize(departure.state.particles.count(), 0);
  for (uint8_t &id : ids) {
    if (departure.materials.empty()) continue;
    const std::string &name = departure.materials.at(id);
    const auto found = std::find_if(setup.materials.begin(), setup.materials.end(),
                                    [&](const dem::Material &material) { return material.name == name; });
    if (found == setup.materials.end()) {
      throw dem::Error("the checkpoint holds particles of the material '" + name + "', and the scene has " +
                       dem::names_of(setup.materials));
    }
    id = static_cast<uint8_t>(found - setup.materials.begin());
  }
}

}  // namespace scene
