// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Measuring many searches side by side: each in a process of its own, round after round over all of them, so that a
// slow moment of the machine touches all alike.
#pragma once

#include "programs/bench/search.hpp"
#include "programs/bench/verdict.hpp"

#include <string>
#include <vector>

namespace bench {

struct Effort {
  int repeats = 15;      // runs of each contestant
  double seconds = 3;    // a contestant that has taken so long is not run again
  double patience = 60;  // a single run that takes longer is given up
  double memory = 0;     // GiB that a contestant may ask for; 0: any
};

// A contestant, what it searches, and the pairs of that, or of where time steps end.
struct Entry {
  Contestant contestant;
  const particles::ParticleSet *particles;
  const Reference *reference;
};

struct Result {
  Contestant contestant;
  const particles::ParticleSet *particles = nullptr;  // of the entry
  // Of the runs that count. The first run warms up and counts only if it took all of Effort::seconds.
  std::vector<double> seconds;
  Details details;
  size_t pairs = 0;
  double peak_bytes = 0;    // that the process held above what it began with, in the first run
  bool chosen = true;       // false: another variant of the same name was measured instead
  bool gave_up = false;     // patience ended
  bool broke_down = false;  // the process ended
  std::string fault;        // "" if the pairs are right, else what went wrong
};

// One result for each entry that has something to do, in their order.
std::vector<Result> run_rounds(const std::vector<Entry> &entries, const Effort &effort);

}  // namespace bench
