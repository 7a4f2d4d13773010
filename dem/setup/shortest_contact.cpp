// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The contact that is over soonest, of any two particles or of one with a wall.
#include "dem/setup/shortest_contact.hpp"

#include "dem/base/error.hpp"
#include "dem/effects/contact_law.hpp"

#include <algorithm>
#include <cmath>

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

// What a fall through the box adds to the square of a speed; through the particles where there is no box.
double square_of_fall(const Setup &setup) {
  if (!has(setup.effects, kGravity)) return 0;
  const auto dimension = static_cast<size_t>(setup.dimension);
  double square = 0;
  for (size_t axis = 0; axis < dimension; axis++) {
    double low = setup.box_min[axis], high = setup.box_max[axis];
    if (!setup.walled[axis] && !setup.periodic[axis]) {
      low = kInfinity;
      high = -kInfinity;
      for (size_t i = 0; i < setup.count(); i++) {
        low = std::min(low, setup.centers[i * dimension + axis]);
        high = std::max(high, setup.centers[i * dimension + axis]);
      }
    }
    square += 2 * std::fabs(setup.gravity[axis]) * (high - low);
  }
  return square;
}

double fastest_approach(const Setup &setup) {
  if (setup.impact_speed > 0) return setup.impact_speed;
  const auto dimension = static_cast<size_t>(setup.dimension);
  double fastest = 0;
  for (size_t i = 0; i < setup.count(); i++) {
    double square = 0;
    for (size_t axis = 0; axis < dimension; axis++) square += std::pow(setup.velocities[i * dimension + axis], 2);
    fastest = std::max(fastest, square);
  }
  return std::sqrt(4 * fastest + square_of_fall(setup));
}

// How much faster the tangential spring of one contact swings than the normal one: it moves mu / (1 + m r^2 / I).
double tangential_speedup(const Setup &setup, double tangential_ratio) {
  if (!has(setup.effects, kFriction)) return 1;
  return std::max(1.0, std::sqrt(tangential_ratio * (1 + inverse_shape(setup.dimension))));
}

double damping_share(const Setup &setup) {
  if (!has(setup.effects, kDissipation)) return 0;
  const double log_e = std::log(setup.contact.restitution), share = -log_e / std::sqrt(kPi * kPi + log_e * log_e);
  // Hertz: gamma = sqrt5 share sqrt(2/3 mu S), S = dF/dd.
  return has(setup.effects, kHertz) ? std::sqrt(5.0 / 6) * share : share;
}

// Stiffest is the pair of largest modulus and largest radius at the smallest mass.
void set_hertz(const Setup &setup, double mass, ShortestContact &contact) {
  if (contact.speed == 0) {
    throw Error(
        "how long Hertz contacts last depends on the speed of impact, and no particle moves at the start: "
        "give an impact speed");
  }
  const bool walled = has(setup.effects, kWalls);
  const double pairs = make_law<double>(setup, Partner::kParticle).modulus;
  const double modulus = walled ? std::max(pairs, make_law<double>(setup, Partner::kWall).modulus) : pairs;
  const double largest = *std::max_element(setup.radii.begin(), setup.radii.end());
  const double radius = walled ? largest : largest / 2;
  const double overlap = std::pow(15 * mass * std::pow(contact.speed, 2) / (16 * modulus * std::sqrt(radius)), 0.4);
  contact.duration = 2.943275 * overlap / contact.speed;
  contact.frequency = std::sqrt(15.0 / 8) * contact.speed / overlap;
}

void set_linear(const Setup &setup, double mass, ShortestContact &contact) {
  double square = setup.contact.stiffness / mass;
  if (has(setup.effects, kModulus)) {
    square = 0;
    for (size_t i = 0; i < setup.count(); i++) square = std::max(square, setup.radii[i] / setup.masses[i]);
    square *= kPi * setup.contact.modulus;
  }
  contact.frequency = std::sqrt(square);
  contact.duration = kPi / (contact.frequency * std::sqrt(1 - contact.damping * contact.damping));
}

}  // namespace

ShortestContact shortest_contact(const Setup &setup) {
  ShortestContact contact;
  const double mass = smallest_reduced_mass(setup);
  if (!std::isfinite(mass)) return contact;
  contact.damping = damping_share(setup);
  if (has(setup.effects, kHertz | kAdhesion)) contact.speed = fastest_approach(setup);
  if (has(setup.effects, kHertz)) {
    set_hertz(setup, mass, contact);
  } else {
    set_linear(setup, mass, contact);
  }
  contact.duration /= tangential_speedup(setup, make_law<double>(setup, Partner::kParticle).tangential_ratio);
  if (has(setup.effects, kAdhesion)) {
    const ContactParameters &p = setup.contact;
    const double square = contact.speed * contact.speed + p.adhesion_force * p.adhesion_range / mass;
    if (square > 0) contact.crossing = p.adhesion_range / std::sqrt(square);
    contact.sinking = p.adhesion_force / (contact.frequency * mass);
  }
  return contact;
}

double crowd_of_springs(const Setup &setup) {
  if (!has(setup.effects, kFriction)) return 1;
  const ContactLaw<double> law = make_law<double>(setup, Partner::kParticle);
  // The arm of rolling is the reduced radius, half of that of equal neighbours.
  const double rolling = has(setup.effects, kRolling) ? law.rolling_ratio / 4 : 0;
  const double along = setup.dimension - 1;  // directions of the tangent plane for each normal one
  return std::max(1 + along * law.tangential_ratio,
                  along * inverse_shape(setup.dimension) * (law.tangential_ratio + rolling));
}

}  // namespace dem
