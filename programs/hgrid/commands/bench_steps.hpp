// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// `hgrid bench --steps`: the time of a step against the skin.
#pragma once

#include "particles/particle_set.hpp"

#include <hgrid/hgrid.h>

#include <string>
#include <vector>

namespace command {

struct StepOptions {
  int steps = 0;  // 0: no steps are timed
  std::vector<double> skins = {0};
  double displacement = 0.01;
};

// Times the steps with each skin, prints a table and writes it to `csv` unless that is empty. `def` holds everything
// but the skin; `name` says what the particles are.
void bench_steps(const StepOptions &options, hg_grid_def def, const particles::ParticleSet &particles,
                 const std::string &name, const std::string &csv);

}  // namespace command
