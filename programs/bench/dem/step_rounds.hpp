// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Measuring programs that move the same particles side by side: each in a process of its own, some steps of each in
// turns, and whether all move them alike.
#pragma once

#include "programs/bench/dem/settled.hpp"
#include "programs/bench/dem/stepper.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace bench {

struct StepEffort {
  uint64_t first_steps = 10;  // after these, states are compared; they do not count
  uint64_t steps = 100;       // of each turn
  double turn_seconds = 10;   // a turn that would take longer has fewer steps
  int repeats = 5;            // turns that count
  double patience = 120;      // seconds after which a turn is given up
};

struct StepResult {
  StepContestant contestant;
  std::vector<double> seconds;  // per step, of each turn that counts
  uint64_t steps = 0;           // of a turn
  Details details;
  double energy_change = 0;  // relative, from the first steps to the end
  double contacts = 0;       // per particle, at the end
  bool chosen = true;        // false: another variant was measured instead
  std::string fault;         // "" if it moves the particles as the first contestant does
};

// One result for each contestant that has something to do. The states after the first steps are compared with those of
// the first contestant.
std::vector<StepResult> run_step_rounds(const SettledSystem &system, const std::vector<StepContestant> &contestants,
                                        const StepEffort &effort);

}  // namespace bench
