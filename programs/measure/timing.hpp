// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The clock, and the turns in which things are timed that shall be compared.
#pragma once

#include <chrono>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace measure {

using Clock = std::chrono::steady_clock;

inline double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Seconds that a call takes.
template <class Work>
double seconds_of(Work &&work) {
  const auto start = Clock::now();
  std::forward<Work>(work)();
  return seconds_since(start);
}

// Calls run() of each, round after round over all, so that a slow moment of the machine touches all alike. What has
// taken `patience` seconds is not run again.
template <class Timers>
void in_turns(Timers &timers, int rounds, double patience = std::numeric_limits<double>::infinity()) {
  std::vector<double> spent(timers.size(), 0.0);
  for (int round = 0; round < rounds; round++) {
    for (size_t k = 0; k < timers.size(); k++) {
      if (round == 0 || spent[k] < patience) spent[k] += seconds_of([&] { timers[k].run(); });
    }
  }
}

}  // namespace measure
