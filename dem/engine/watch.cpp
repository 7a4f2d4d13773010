// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Watches a run for what no sound simulation shows.
#include "dem/engine/watch.hpp"

#include "dem/base/error.hpp"

#include <algorithm>
#include <cmath>

namespace dem {
namespace {

constexpr double kMuchOverlap = 0.1, kMuchRise = 0.01;

bool has_moving_walls(const Setup &setup) {
  const auto dimension = static_cast<size_t>(setup.dimension);
  for (size_t k = 0; k < setup.velocities.size(); k++) {
    if (setup.velocities[k] != 0 && !std::isfinite(setup.masses[k / dimension])) return true;
  }
  return false;
}

// Three digits are enough to judge by.
std::string rounded(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.3g", value);
  return digits;
}

}  // namespace

bool Watch::Sight::note(double value, double bound, uint64_t now) {
  if (value > worst) {
    worst = value;
    step = now;
  }
  if (warned || !(value > bound)) return false;
  return warned = true;
}

Watch::Watch(const Setup &setup)
    : gains_(has(setup.effects, kShear | kGrowth) || setup.exchanges() || has_moving_walls(setup)) {}

std::vector<std::string> Watch::look(uint64_t step, const Measurement &m) {
  std::vector<std::string> warnings;
  if (overlap_.note(m.largest_overlap, kMuchOverlap, step)) {
    warnings.push_back("surfaces overlap by " + rounded(m.largest_overlap) +
                       " of the smaller radius: contacts are too soft for what presses them, or particles start inside "
                       "each other");
  }
  if (outside_.note(static_cast<double>(m.behind_walls), 0, step)) {
    warnings.push_back("centres of particles lie behind walls: " + std::to_string(m.behind_walls));
  }
  if (load_.note(m.step_load, 1, step)) {
    warnings.push_back("so many contacts at once may make the time step unstable: it is " +
                       rounded(std::sqrt(m.step_load)) + " of what they allow or more");
  }
  if (press_.note(m.press_load, 1, step)) {
    warnings.push_back("a plane that presses swings without end: its speed is " + rounded(m.press_load) +
                       " times what its force allows for with these springs and dashpots");
  }
  scale_ = std::max(scale_, m.translation + m.rotation + std::fabs(m.contact));
  const double energy = m.energy() - m.wall_work;
  lowest_ = std::min(lowest_, energy);
  const double rise = scale_ > 0 && !gains_ ? (energy - lowest_) / scale_ : 0;
  if (rise_.note(rise, kMuchRise, step)) {
    warnings.push_back("the energy has risen by " + rounded(rise) +
                       " of what is in motion and in contacts, and nothing puts any in: the time step is too large");
  }
  return warnings;
}

std::string Watch::summary() const {
  const auto at = [](const Sight &sight) {
    return sight.worst > 0 ? rounded(sight.worst) + " (step " + std::to_string(sight.step) + ")" : std::string("0");
  };
  return "overlap over radius " + at(overlap_) + ", centres behind walls " + at(outside_) + ", load on the step " +
         at(load_) + ", rise of energy " + (gains_ ? "not judged" : at(rise_));
}

bool Watch::has_warned() const {
  return overlap_.warned || outside_.warned || load_.warned || press_.warned || rise_.warned;
}

}  // namespace dem
