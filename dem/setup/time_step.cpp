// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How long the shortest contact lasts, and what time steps follow from it.
#include "dem/setup/time_step.hpp"

#include "dem/base/error.hpp"
#include "dem/effects/body_force.hpp"
#include "dem/effects/contact_law.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace dem {
namespace {

// The two lightest particles: their reduced mass is the smallest of all pairs.
double smallest_reduced_mass(const Setup &setup) {
  double lightest = kInfinity, second = kInfinity;
  for (const double m : setup.masses) {
    if (m < lightest) {
      second = lightest;
      lightest = m;
    } else {
      second = std::min(second, m);
    }
  }
  return 1 / (1 / lightest + 1 / second);
}

double fastest_approach(const Setup &setup) {
  if (setup.impact_speed > 0) return setup.impact_speed;
  const auto dimension = static_cast<size_t>(setup.dimension);
  double fastest = 0;
  for (size_t i = 0; i < setup.count(); i++) {
    double square = 0;
    for (size_t axis = 0; axis < dimension; axis++) square += std::pow(setup.velocities[i * dimension + axis], 2);
    fastest = std::max(fastest, std::sqrt(square));
  }
  if (fastest == 0) {
    throw Error(
        "how long Hertz contacts last depends on the speed of impact, and no particle moves at the start: "
        "give an impact speed");
  }
  return 2 * fastest;
}

// How much faster the tangential spring swings than the normal one.
double tangential_speedup(const Setup &setup, double tangential_ratio) {
  if (!has(setup.effects, kFriction)) return 1;
  const double inverse_shape = setup.dimension == 3 ? 2.5 : 2;  // m r^2 / I
  return std::max(1.0, std::sqrt(tangential_ratio * (1 + inverse_shape)));
}

double hertz_contact(const Setup &setup, double mass) {
  // Stiffest is the pair of largest modulus and largest radius at the smallest mass.
  const ContactLaw<double> pairs = make_law<double>(setup, Partner::kParticle);
  const ContactLaw<double> walls = make_law<double>(setup, Partner::kWall);
  const bool walled = has(setup.effects, kWalls);
  const double modulus = walled ? std::max(pairs.modulus, walls.modulus) : pairs.modulus;
  const double largest = *std::max_element(setup.radii.begin(), setup.radii.end());
  const double radius = walled ? largest : largest / 2;
  const double speed = fastest_approach(setup);
  const double overlap = std::pow(15 * mass * speed * speed / (16 * modulus * std::sqrt(radius)), 0.4);
  return 2.943275 * overlap / speed / tangential_speedup(setup, pairs.tangential_ratio);
}

}  // namespace

double shortest_contact(const Setup &setup) {
  const double mass = smallest_reduced_mass(setup);
  if (!std::isfinite(mass)) return kInfinity;
  if (has(setup.effects, kHertz)) return hertz_contact(setup, mass);
  const double log_e = has(setup.effects, kDissipation) ? std::log(setup.contact.restitution) : 0;
  const double normal = std::sqrt(mass * (kPi * kPi + log_e * log_e) / setup.contact.stiffness);
  return normal / tangential_speedup(setup, setup.contact.tangential_stiffness);
}

void require_time_step(const Setup &setup) {
  if (!(setup.time_step > 0) || !std::isfinite(setup.time_step)) {
    throw Error("the time step is above 0, not " + text(setup.time_step));
  }
  const double contact = shortest_contact(setup);
  if (setup.time_step > contact / kFewestStepsPerContact) {
    throw Error("the time step " + text(setup.time_step) + " is too large: the shortest contact lasts " +
                text(contact) + ", so " + text(contact / kFewestStepsPerContact) + " is the limit and " +
                text(contact / kUsualStepsPerContact) + " is usual");
  }
  if (has(setup.effects, kDrag)) {
    double fastest = 0;  // how fast drag slows a particle
    for (size_t i = 0; i < setup.count(); i++) {
      fastest = std::max(fastest, drag_of(setup) * setup.radii[i] / setup.masses[i]);
    }
    if (setup.time_step * fastest > 0.1) {
      throw Error("the time step " + text(setup.time_step) + " is too large: drag stops the lightest particle within " +
                  text(1 / fastest) + ", so " + text(0.1 / fastest) + " is the limit");
    }
  }
}

}  // namespace dem
