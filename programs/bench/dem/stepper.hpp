// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What every contestant of a measurement of whole steps is: a program that moves particles, and the label of its
// results.
#pragma once

#include "dem/setup/setup.hpp"
#include "programs/bench/search.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace bench {

// Of all particles in the order of the scene, at the time of a step.
struct MotionState {
  std::vector<double> centers, velocities;
};

struct Stepper {
  // Search, forces and motion of so many steps. Empty if the variant makes no sense for these particles.
  std::function<void(uint64_t)> run;
  std::function<MotionState()> state;
  std::function<Details()> details;
};

struct StepContestant {
  std::string name;     // of the program: one word
  std::string variant;  // of its settings, "" if there is but one
  std::string isa;      // instruction set of the library, "" = it is not used
  int threads = 1;
  double skin = 0;     // of stored neighbours, in units of the smallest radius; 0: searched in each step
  bool tuned = false;  // one of several variants of a name and number of threads: only the fastest of them goes on
  // Called in a process of its own, once.
  std::function<Stepper(const dem::Setup &)> prepare;
};

// How one differs from the engine's and the library's defaults.
struct StepSetting {
  int threads = 1;
  double skin = 0;
  int level_count = 0;  // 0: as the rule chooses
  bool tuned = false;
};

// The engine of `hgrid run`.
StepContestant engine_steps(const StepSetting &setting, const std::string &isa);

// A search in each step with the levels of the paper (at most `level_count`, 0: as its rule chooses), and plain scalar
// code for forces and motion, on one thread. `plain` searches among particles sorted by cell and keeps them sorted
// along a curve through space, as the other programs do; `hashed` goes through linked lists in a hash table, and its
// particles stand in memory as they were given: the paper speaks of no order.
StepContestant plain_steps(int level_count);
StepContestant hashed_steps(int level_count);

// The plain loop in C of examples/elastic_steps.c over the library's contacts.
StepContestant loop_steps(const StepSetting &setting, const std::string &isa);

// LAMMPS, pair_style gran/hooke: collections 0 for lists of the style `bin`, else their number for `multi`.
StepContestant lammps_steps(const StepSetting &setting, int collections);

}  // namespace bench
