// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What decides the course of a simulation besides its state: a checkpoint goes on in a setup of the same alone.
#pragma once

#include "dem/setup/setup.hpp"
#include "dem/state/checkpoint.hpp"

#include <cstdint>

namespace dem {

// As in checkpoints.
struct Fingerprint {
  uint64_t dimension, precision, effects, count;  // precision: bytes of a number
  double time_step;
};

// With the names of materials (materials): their numbers mean the same only where these are the same.
void save(const Fingerprint &fingerprint, const Setup &setup, Checkpoint &checkpoint);

// Throws Error naming what differs; the number of particles is compared only if there is one in `own`. Returns that of
// the checkpoint.
uint64_t require_same(const Fingerprint &own, const Setup &setup, const Checkpoint &checkpoint);

}  // namespace dem
