// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Seeded scenes whose every bit is the same with any compiler: made with + - * / and square roots alone, which IEEE 754
// rounds in one way, and without functions of libm, which are not bound to.
#pragma once

#include "particles/particle_set.hpp"

#include <hgrid/hgrid.h>

#include <string>
#include <vector>

namespace golden {

struct GoldenScene {
  std::string name;
  hg_grid_def def;
  particles::ParticleSet particles;
};

std::vector<GoldenScene> all_scenes();

}  // namespace golden
