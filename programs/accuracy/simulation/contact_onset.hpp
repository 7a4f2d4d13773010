// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What the onset of a contact, where the force has a corner, does to a scheme, to leading order in the time step h.
#pragma once

#include "dem/setup/scheme.hpp"

namespace accuracy {

// In contact a scheme of kicks and drifts follows the oscillator x'' = -omega^2 x. Before the surfaces meet, at x < 0,
// there is no force: the kicks k_j omega^2 |x_j| h that the oscillator would get there are missing. So the oscillator
// that a particle of speed 1 is on in contact has the energy v^2 + omega^2 x^2 = 1 - omega^2 h^2 g, where for a start
// at x = -b h, far enough ahead, g = 2 sum k_j |x_j / h| - b^2. It depends on the share of b beyond a whole number
// alone, that is on the moment within a step at which they meet. The order of the scheme plays no part.
struct OnsetEnergy {
  double mean = 0, variance = 0;  // of g over all moments
};

// For velocity Verlet g = p (1 - p), p in [0, 1): mean 1 / 6, variance 1 / 180.
OnsetEnergy onset_energy(const dem::Scheme &scheme);

}  // namespace accuracy
