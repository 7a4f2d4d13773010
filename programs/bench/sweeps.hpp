// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Which contestants are measured on which systems: all on one system, or a few along one axis of a plot.
#pragma once

#include "programs/bench/search.hpp"
#include "programs/bench/systems.hpp"

#include <functional>
#include <string>
#include <vector>

namespace bench {

struct Sweep {
  std::string name;  // "": everything, on the systems that the user names
  std::string help;
  std::vector<std::string> sources;  // systems, if the user names none
  std::function<std::vector<Contestant>(const System &, const std::vector<std::string> &isas)> contestants;
  // Steps of motion in each run, by up to this share of the smallest radius; 0 steps: nothing moves.
  int steps = 0;
  double step_length = 0;
};

// The first is the one without a name.
const std::vector<Sweep> &all_sweeps();

// The contestants whose NAME/VARIANT/ISA/THREADS match one of the patterns `only` (none: all) and none of `skip`;
// "best" stands for the first of `isas`. `*` and `?` as in a shell.
std::vector<Contestant> chosen(std::vector<Contestant> all, const std::vector<std::string> &isas,
                               const std::vector<std::string> &only, const std::vector<std::string> &skip);
std::string key_of(const Contestant &contestant);

}  // namespace bench
