// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/accuracy/simulation/contact_onset.hpp"

namespace accuracy {
namespace {

// Ahead of the inner stages of any scheme, the longest of which goes back by 1.7 steps.
constexpr int kFarSteps = 3;
constexpr int kPhases = 2000;

double energy_from(const dem::Scheme &scheme, double start) {
  double x = scheme.shared_drift - start;
  double lent = scheme.shared_kick;  // the part of the first kick that belongs to the step before
  double missing = 0;
  for (int step = 0; step < 2 * kFarSteps + 2; step++) {
    for (const dem::Stage &stage : scheme.stages) {
      if (x < 0) missing -= (stage.kick - lent) * x;
      lent = 0;
      x += stage.drift;
    }
  }
  return 2 * missing - start * start;
}

}  // namespace

OnsetEnergy onset_energy(const dem::Scheme &scheme) {
  OnsetEnergy result;
  double square = 0;
  for (int k = 0; k < kPhases; k++) {
    const double g = energy_from(scheme, kFarSteps + (k + 0.5) / kPhases);
    result.mean += g / kPhases;
    square += g * g / kPhases;
  }
  result.variance = square - result.mean * result.mean;
  return result;
}

}  // namespace accuracy
