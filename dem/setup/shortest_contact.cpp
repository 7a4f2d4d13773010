// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The contacts that are over soonest, of any two particles or of one with a wall.
#include "dem/setup/shortest_contact.hpp"

#include "dem/base/error.hpp"
#include "dem/effects/contact_law.hpp"
#include "dem/setup/materials.hpp"

#include <algorithm>
#include <cmath>

namespace dem {
namespace {

// Particles of one material.
struct Lot {
  double lightest = kInfinity, second = kInfinity;  // masses
  double largest = 0;                               // radius
  double columns = 0;                               // the largest r / m
  bool any = false;

  void add(double radius, double mass) {
    second = std::min(second, std::max(lightest, mass));
    lightest = std::min(lightest, mass);
    largest = std::max(largest, radius);
    columns = std::max(columns, radius / mass);
    any = true;
  }
};

std::vector<Lot> lots_of(const Setup &setup) {
  const bool several = has(setup.effects, kMaterials);
  std::vector<Lot> lots(several ? setup.materials.size() : 1);
  visit_particles(setup, [&](const ParticleArrays &particles, size_t i) {
    lots[several ? particles.material_ids[i] : 0].add(particles.radii[i], particles.masses[i]);
  });
  return lots;
}

// Contacts that follow one law, from the side of what makes them short.
struct Kind {
  ContactLaw<double> law;
  const ContactParameters *both;
  double mass;     // the smallest reduced mass
  double radius;   // the largest reduced radius
  double columns;  // the largest pi E r / m (modulus)
};

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
      visit_particles(setup, [&](const ParticleArrays &particles, size_t i) {
        low = std::min(low, particles.centers[i * dimension + axis]);
        high = std::max(high, particles.centers[i * dimension + axis]);
      });
    }
    square += 2 * std::fabs(setup.gravity[axis]) * (high - low);
  }
  return square;
}

// Of any point of the walls beside the box's; planes turn too slowly along themselves to matter.
double fastest_wall(const Setup &setup) {
  double fastest = 0;
  for (const WallBody &wall : setup.walls) {
    double reach = wall.shape == WallShape::kCylinder ? wall.radius : 0, speed = wall.fastest;
    for (size_t k = 0; k + 2 < wall.corners.size(); k += 3) {
      reach = std::max(reach, std::hypot(wall.corners[k] - wall.pivot[0], wall.corners[k + 1] - wall.pivot[1],
                                         wall.corners[k + 2] - wall.pivot[2]));
    }
    speed += std::hypot(wall.velocity[0], wall.velocity[1], wall.velocity[2]);
    speed += 2 * kPi * wall.frequency * std::hypot(wall.swing[0], wall.swing[1], wall.swing[2]);
    fastest = std::max(fastest, speed + std::fabs(wall.turning) * reach);
  }
  return fastest;
}

double fastest_approach(const Setup &setup) {
  if (setup.impact_speed > 0) return setup.impact_speed;
  const auto dimension = static_cast<size_t>(setup.dimension);
  double fastest = 0;
  visit_particles(setup, [&](const ParticleArrays &particles, size_t i) {
    double square = 0;
    for (size_t axis = 0; axis < dimension; axis++) square += std::pow(particles.velocities[i * dimension + axis], 2);
    fastest = std::max(fastest, square);
  });
  return std::sqrt(4 * fastest + square_of_fall(setup)) + fastest_wall(setup);
}

// How much faster the tangential spring of one contact swings than the normal one: it moves mu / (1 + m r^2 / I).
double tangential_speedup(const Setup &setup, double tangential_ratio) {
  if (!has(setup.effects, kFriction)) return 1;
  return std::max(1.0, std::sqrt(tangential_ratio * (1 + inverse_shape(setup.dimension))));
}

double damping_share(const Setup &setup, const ContactParameters &both) {
  if (!has(setup.effects, kDissipation)) return 0;
  const double log_e = std::log(both.restitution), share = -log_e / std::sqrt(kPi * kPi + log_e * log_e);
  // Hertz: gamma = sqrt5 share sqrt(2/3 mu S), S = dF/dd.
  return has(setup.effects, kHertz) ? std::sqrt(5.0 / 6) * share : share;
}

double columns_of(const Lot &lot, const ContactParameters &p) { return lot.columns * (kPi * p.modulus); }

const ContactParameters &material_of(const Setup &setup, size_t a) {
  return has(setup.effects, kMaterials) ? setup.materials[a].contact : setup.contact;
}

const ContactParameters &both_of(const Setup &setup, size_t a, size_t b) {
  return has(setup.effects, kMaterials) ? setup.pairs[setup.pair_of(a, b)] : setup.contact;
}

void add_pairs(const Setup &setup, const std::vector<Lot> &lots, std::vector<Kind> &kinds) {
  const LawTable<double> laws(setup, Partner::kParticle);
  for (size_t a = 0; a < lots.size(); a++) {
    for (size_t b = a; b < lots.size(); b++) {
      if (!lots[a].any || !lots[b].any) continue;
      const double other = a == b ? lots[a].second : lots[b].lightest;
      const double radius = lots[a].largest * (lots[b].largest / (lots[a].largest + lots[b].largest));
      kinds.push_back(
          {laws.at(a, b), &both_of(setup, a, b), 1 / (1 / lots[a].lightest + 1 / other), radius,
           std::max(columns_of(lots[a], material_of(setup, a)), columns_of(lots[b], material_of(setup, b)))});
    }
  }
}

// With Hertz the mass is that of a pair, and the modulus the larger one of pairs and walls.
void add_walls(const Setup &setup, const std::vector<Lot> &lots, std::vector<Kind> &kinds) {
  const LawTable<double> laws(setup, Partner::kWall), of_pairs(setup, Partner::kParticle);
  for (const int material : materials_of_walls(setup)) {
    const size_t b = material < 0 ? setup.materials.size() : static_cast<size_t>(material);
    for (size_t a = 0; a < lots.size(); a++) {
      if (!lots[a].any) continue;
      Kind kind{laws.at(a, b), &both_of(setup, a, b), 1 / (1 / lots[a].lightest + 1 / kInfinity), lots[a].largest,
                columns_of(lots[a], material_of(setup, a))};
      if (has(setup.effects, kHertz)) {
        kind.law.modulus = std::max(kind.law.modulus, of_pairs.at(a, a).modulus);
        kind.mass = 1 / (1 / lots[a].lightest + 1 / lots[a].second);
      }
      kinds.push_back(kind);
    }
  }
}

// Stiffest is the pair of largest modulus and largest radius at the smallest mass.
void set_hertz(const Kind &kind, ShortestContact &contact) {
  if (contact.speed == 0) {
    throw Error(
        "how long Hertz contacts last depends on the speed of impact, and no particle moves at the start: "
        "give an impact speed");
  }
  const double overlap =
      std::pow(15 * kind.mass * std::pow(contact.speed, 2) / (16 * kind.law.modulus * std::sqrt(kind.radius)), 0.4);
  contact.duration = 2.943275 * overlap / contact.speed;
  contact.frequency = std::sqrt(15.0 / 8) * contact.speed / overlap;
}

void set_linear(const Setup &setup, const Kind &kind, ShortestContact &contact) {
  contact.frequency = std::sqrt(has(setup.effects, kModulus) ? kind.columns : kind.law.stiffness / kind.mass);
  contact.duration = kPi / (contact.frequency * std::sqrt(1 - contact.damping * contact.damping));
}

ShortestContact shortest_of(const Setup &setup, const Kind &kind, double speed) {
  ShortestContact contact;
  if (!std::isfinite(kind.mass)) return contact;
  contact.damping = damping_share(setup, *kind.both);
  contact.speed = speed;
  if (has(setup.effects, kHertz)) {
    set_hertz(kind, contact);
  } else {
    set_linear(setup, kind, contact);
  }
  contact.duration /= tangential_speedup(setup, kind.law.tangential_ratio);
  if (has(setup.effects, kAdhesion)) {
    const double force = kind.both->adhesion_force, range = kind.both->adhesion_range;
    const double square = speed * speed + force * range / kind.mass;
    if (square > 0) contact.crossing = range / std::sqrt(square);
    contact.sinking = force / (contact.frequency * kind.mass);
  }
  return contact;
}

}  // namespace

std::vector<ShortestContact> shortest_contacts(const Setup &setup) {
  const std::vector<Lot> lots = lots_of(setup);
  std::vector<Kind> kinds;
  add_pairs(setup, lots, kinds);
  add_walls(setup, lots, kinds);
  const double speed = has(setup.effects, kHertz | kAdhesion) ? fastest_approach(setup) : 0;
  std::vector<ShortestContact> contacts(1);  // of no particles
  for (const Kind &kind : kinds) contacts.push_back(shortest_of(setup, kind, speed));
  if (contacts.size() > 1) contacts.erase(contacts.begin());
  return contacts;
}

ShortestContact shortest_contact(const Setup &setup) {
  const std::vector<ShortestContact> contacts = shortest_contacts(setup);
  return *std::min_element(contacts.begin(), contacts.end(),
                           [](const ShortestContact &a, const ShortestContact &b) { return a.duration < b.duration; });
}

double crowd_of_springs(const Setup &setup) {
  if (!has(setup.effects, kFriction)) return 1;
  const LawTable<double> laws(setup, Partner::kParticle);
  double tangential = 0;
  for (const ContactLaw<double> &law : laws.all()) tangential = std::max(tangential, law.tangential_ratio);
  // The arm of rolling is the reduced radius, half of that of equal neighbours.
  const double rolling = has(setup.effects, kRolling) ? setup.contact.rolling_stiffness / 4 : 0;
  const double along = setup.dimension - 1;  // directions of the tangent plane for each normal one
  return std::max(1 + along * tangential, along * inverse_shape(setup.dimension) * (tangential + rolling));
}

}  // namespace dem
