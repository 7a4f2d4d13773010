// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The errors of an integration scheme against the steps per contact, and the laws that they are expected to follow.
#pragma once

#include "dem/setup/scheme.hpp"
#include "programs/accuracy/simulation/power_law.hpp"

#include <string>
#include <vector>

namespace accuracy {

enum class Contacts { kLinear, kHertz, kRough };

// One kind of error of one scheme.
struct ErrorCurve {
  std::string error_of;
  std::vector<double> steps;  // per contact
  std::vector<double> errors;
  Contacts contacts = Contacts::kLinear;
};

// Laws are of leading order: they are fitted to the errors from here on.
constexpr double kFittedFrom = 20;

// e of the collisions with a dashpot: a damping ratio of 0.2.
constexpr double kDampedRestitution = 0.527;

// e of the collisions of Hertz contacts with a dashpot, and of rough spheres.
constexpr double kRestitution = 0.8;

// Single collisions: rms over 400 moments within a step at which they begin. Hertz contacts and friction with the
// default scheme only.
std::vector<ErrorCurve> collision_curves(const dem::Scheme &scheme, const std::vector<double> &steps);

// The energy of an elastic gas of 125 spheres of different masses over as many spans of 25 t_c.
std::vector<ErrorCurve> energy_curves(const dem::Scheme &scheme, const std::vector<double> &steps, int spans);

// The law derived for a kind of error of a curve. Order 0: none; factor 0: only the order is derived.
PowerLaw expected_law(const dem::Scheme &scheme, const std::string &error_of);

// The law of the part of the curve from kFittedFrom on.
PowerLaw fitted_law(const std::vector<double> &steps, const std::vector<double> &errors);

}  // namespace accuracy
