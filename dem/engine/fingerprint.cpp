// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What decides the course of a simulation.
#include "dem/engine/fingerprint.hpp"

#include "dem/effects/table.hpp"
#include "dem/setup/materials.hpp"

#include <string>
#include <vector>

namespace dem {

void save(const Fingerprint &fingerprint, const Setup &setup, Checkpoint &checkpoint) {
  checkpoint.put_value("fingerprint", fingerprint);
  if (!has(setup.effects, kMaterials)) return;
  const std::string names = names_of(setup.materials);
  checkpoint.put("material names", names.data(), names.size());
}

uint64_t require_same(const Fingerprint &own, const Setup &setup, const Checkpoint &checkpoint) {
  const auto stored = checkpoint.get_value<Fingerprint>("fingerprint");
  if (stored.dimension != own.dimension || stored.precision != own.precision) {
    throw Error("the checkpoint is of " + std::to_string(stored.dimension) + " dimensions in numbers of " +
                std::to_string(stored.precision) + " bytes, the scene of " + std::to_string(own.dimension) + " in " +
                std::to_string(own.precision));
  }
  if (stored.effects != own.effects) {
    throw Error("the checkpoint has the effects " + names_of(static_cast<EffectSet>(stored.effects)) +
                ", the scene has " + names_of(static_cast<EffectSet>(own.effects)));
  }
  if (own.count > 0 && stored.count != own.count) {
    throw Error("the checkpoint holds " + std::to_string(stored.count) + " particles, the scene " +
                std::to_string(own.count));
  }
  if (stored.time_step != own.time_step) {
    throw Error("the checkpoint was made with the time step " + text(stored.time_step) + ", the scene has " +
                text(own.time_step));
  }
  if (!has(setup.effects, kMaterials)) return stored.count;
  std::vector<char> characters;
  checkpoint.get_all("material names", characters);
  const std::string names(characters.begin(), characters.end()), own_names = names_of(setup.materials);
  if (names != own_names) throw Error("the checkpoint has the materials " + names + ", the scene has " + own_names);
  return stored.count;
}

}  // namespace dem
