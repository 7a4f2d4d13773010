// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Seeded scenes whose every bit is the same with any compiler: made with + - * / and square roots alone, which IEEE 754
// rounds in one way, and without functions of libm, which are not bound to.
#pragma once

#include "tests/support/oracle.hpp"

#include <string>
#include <vector>

namespace golden {

struct GoldenScene {
  std::string name;
  hg_grid_def def;
  hgtest::Particles particles;
};

std::vector<GoldenScene> all_scenes();

}  // namespace golden
