// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What a simulation leaves to the next one, which may have other effects, walls and parameters.
#pragma once

#include "dem/setup/setup.hpp"
#include "dem/state/checkpoint.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace dem {

// The state at the time of a step, particles in the order they were given in.
struct Handover {
  ParticleArrays particles;
  Beginning beginning;
};

constexpr uint32_t kGone = static_cast<uint32_t>(-1);

// What is left without some of the particles and their contacts.
Handover without(const Handover &handover, const std::vector<bool> &gone);

// The same contacts, but for those of particles with the number kGone, where particle i is called numbers[i]; of pairs
// both are, of walls the particle alone.
ContactMemory renumbered_pairs(const ContactMemory &memory, const std::vector<uint32_t> &numbers);
ContactMemory renumbered_walls(const ContactMemory &memory, const std::vector<uint32_t> &numbers);

// Beside what a simulation itself has saved; `when` tells one of several from the others.
void save_handover(const Handover &handover, const std::string &when, Checkpoint &checkpoint);
Handover restore_handover(const std::string &when, const Checkpoint &checkpoint);

}  // namespace dem
