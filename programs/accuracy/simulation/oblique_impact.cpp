// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/accuracy/simulation/oblique_impact.hpp"

#include "dem/engine/engine.hpp"
#include "packing/random.hpp"
#include "programs/accuracy/simulation/oscillator.hpp"

#include <algorithm>
#include <cmath>

namespace accuracy {
namespace {

// A contact with a wall at some overlap, from the material's numbers (docs/guide/simulation.md, What is computed).
struct Law {
  double normal, normal_damping;          // the spring's force, force per closing speed
  double tangential, tangential_damping;  // force per stretch and per its rate
};

Law law_at(const dem::Setup &setup, double mass, double radius, double overlap) {
  const dem::ContactParameters &p = setup.contact;
  const double log_e = std::log(p.restitution);
  const double loss = -log_e / std::sqrt(kPi * kPi + log_e * log_e);
  if (!dem::has(setup.effects, dem::kHertz)) {
    const double damping = 2 * loss * std::sqrt(mass * p.stiffness), q = p.tangential_stiffness;
    return {p.stiffness * overlap, damping, q * p.stiffness, q * damping};
  }
  // Against a rigid wall E* = E / (1 - nu^2), G* = E / (2 (1 + nu) (2 - nu)); k_t = 8 G* a, k = 2 E* a.
  const double nu = p.poisson_ratio, contact_radius = std::sqrt(radius * overlap);
  const double e_star = p.young_modulus / (1 - nu * nu), g_star = p.young_modulus / (2 * (1 + nu) * (2 - nu));
  const double root = std::sqrt(mass * 4 / 3 * e_star * std::sqrt(radius)) * std::pow(overlap, 0.25);
  const double damping = std::sqrt(5.0) * loss * root;
  return {4.0 / 3 * e_star * contact_radius * overlap, damping, 8 * g_star * contact_radius,
          4 * g_star / e_star * damping};
}

// How fast the spring along the surface stretches: with the surface as long as spring and dashpot bear no more than the
// slider does, else as fast as the rest of the limit drives the dashpot.
double stretching(const Law &law, double limit, double stretch, double slip) {
  const double sticking = law.tangential * stretch + law.tangential_damping * slip;
  if (std::fabs(sticking) <= limit) return slip;
  return (std::copysign(limit, sticking) - law.tangential * stretch) / law.tangential_damping;
}

// Two equal spheres that meet symmetrically each move as if they met a wall half-way between them: there the same force
// belongs to half the overlap and half the slip, so the wall's contact is twice as stiff.
// The radius and mass are 1: so slow that the line of centres does not turn meanwhile.
constexpr double kSpeed = 1e-6, kStiffness = 1;

double slip_of(const Motion &motion, double radius) { return motion.tangential - radius * motion.spin; }

dem::Setup rough_law(const RoughCase &what, double stiffness) {
  dem::Setup setup;
  setup.effects = dem::kDissipation | dem::kFriction;
  setup.contact.stiffness = stiffness;
  setup.contact.restitution = what.restitution;
  setup.contact.friction = what.friction;
  return setup;
}

// Of each pair the right sphere comes second.
dem::Setup rough_pairs(const RoughCase &what, double duration) {
  dem::Setup setup = rough_law(what, kStiffness);
  setup.time_step = duration / what.steps;
  packing::Random random(1);
  for (size_t i = 0; i < what.impacts; i++) {
    const double phase = (static_cast<double>(i) + random.uniform()) / static_cast<double>(what.impacts);
    const double x = 1 + kSpeed * setup.time_step * (1 + phase), z = 3 * static_cast<double>(i);
    const double slip = what.slip * kSpeed;
    setup.centers.insert(setup.centers.end(), {-x, 0, z, x, 0, z});
    setup.velocities.insert(setup.velocities.end(), {kSpeed, -slip, 0, -kSpeed, slip, 0});
    setup.radii.insert(setup.radii.end(), 2, 1.0);
    setup.masses.insert(setup.masses.end(), 2, 1.0);
  }
  return setup;
}

}  // namespace

Motion integrate(const dem::Setup &setup, const Impact &impact, double duration) {
  const double h = duration / 400000, inertia = 0.4 * impact.mass * impact.radius * impact.radius;
  double closing = impact.normal, overlap = h * closing, v = impact.tangential, spin = impact.spin, stretch = 0;
  while (overlap > 0) {
    const Law law = law_at(setup, impact.mass, impact.radius, overlap);
    const double arm = impact.radius - overlap, slip = v - arm * spin, limit = setup.contact.friction * law.normal;
    double rate = 0;
    if (law.tangential_damping > 0) {
      rate = stretching(law, limit, stretch, slip);
      stretch += h * rate;
    } else {
      stretch = std::clamp(stretch + h * slip, -limit / law.tangential, limit / law.tangential);
    }
    const double force = -law.tangential * stretch - law.tangential_damping * rate;
    closing -= h * (law.normal + law.normal_damping * closing) / impact.mass;
    v += h * force / impact.mass;
    spin -= h * arm * force / inertia;
    overlap += h * closing;
  }
  return {-closing, v, spin};
}

double slip_error(const RoughCase &what) {
  const double duration = Oscillator(2 * kStiffness, 1, what.restitution).duration();
  const auto engine = dem::make_engine(rough_pairs(what, duration));
  engine->run(static_cast<uint64_t>(1.2 * what.steps) + 5);
  const dem::Snapshot after = engine->snapshot();
  const Impact impact{1, 1, kSpeed, what.slip * kSpeed, 0};
  const double truth = slip_of(integrate(rough_law(what, 2 * kStiffness), impact, duration), 1);
  double squares = 0;
  for (size_t i = 0; i < what.impacts; i++) {
    const size_t right = 2 * i + 1;
    const Motion found{after.velocities[3 * right], after.velocities[3 * right + 1], after.spins[3 * right + 2]};
    squares += std::pow((slip_of(found, 1) - truth) / kSpeed, 2);
  }
  return std::sqrt(squares / static_cast<double>(what.impacts));
}

}  // namespace accuracy
