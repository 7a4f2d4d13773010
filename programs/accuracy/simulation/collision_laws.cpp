// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How the errors of a collision fall with the steps per contact.
//
// Elastic: e^2 is the energy of the oscillator that the particle meets over that of the one it leaves, both off by
// (pi / n)^2 g (contact_onset.hpp), so e - 1 = (pi^2 / 2 n^2) (g(q) - g(p)) with the moments p of meeting and q of
// parting, seen backwards. In a whole number of steps q = 1 - p but for the error of the duration, and g(1 - p) = g(p).
#include "programs/accuracy/simulation/collision_laws.hpp"

#include "programs/accuracy/simulation/contact_onset.hpp"
#include "programs/accuracy/simulation/oscillator.hpp"

#include <cmath>

namespace accuracy {
namespace {

bool is_fourth_order(const dem::Scheme &scheme) { return scheme.order >= 4; }

// Symplectic Euler goes through the same positions as velocity Verlet; only the velocities shown with them differ.
dem::Scheme path_of(const dem::Scheme &scheme) { return scheme.order == 1 ? dem::velocity_verlet() : scheme; }

// With a dashpot, to first order in eta h = Lambda / n, Lambda = -ln e: a velocity half a step old makes the oscillator
// one of eta (1 + eta h) and omega^2 (1 + eta h).
struct Damped {
  explicit Damped(double restitution)
      : loss(-std::log(restitution)), zeta(Oscillator(1, 1, restitution).damping_ratio()) {}

  // By how many steps the contact is shorter: Lambda (omega^2 - 2 eta^2) / (2 w^2).
  double shortening() const { return loss * (1 - 2 * zeta * zeta) / (2 * (1 - zeta * zeta)); }

  double loss, zeta;
};

}  // namespace

double half_swing(const dem::Scheme &scheme, double steps) {
  const double turn = kPi / steps;  // omega h
  // Where (x, v) = (1, 0) and (0, 1) go in a step without the sharing of kicks: the trace is the same.
  double x[2] = {1, 0}, v[2] = {0, 1};
  for (const dem::Stage &stage : scheme.stages) {
    for (int k = 0; k < 2; k++) {
      v[k] -= stage.kick * turn * x[k];
      x[k] += stage.drift * turn * v[k];
    }
  }
  // 1 - cos(angle) = 2 sin^2(angle / 2) keeps its digits for small angles.
  return turn / (2 * std::asin(std::sqrt((2 - x[0] - v[1]) / 4)));
}

PowerLaw elastic_duration_law(const dem::Scheme &scheme) {
  constexpr double kManySteps = 100;
  const double order = is_fourth_order(scheme) ? 4 : 2;
  return {order, std::fabs(half_swing(scheme, kManySteps) - 1) * std::pow(kManySteps, order)};
}

// The moment of parting is off by n (pi^2 / 24) / n^2 of a step, the slope of p (1 - p) has the rms 1 / sqrt(3).
PowerLaw elastic_restitution_law(const dem::Scheme &scheme) {
  if (is_fourth_order(scheme)) return {4, 0};
  return {3, std::pow(kPi, 4) / (48 * std::sqrt(3.0))};
}

PowerLaw any_step_restitution_law(const dem::Scheme &scheme) {
  return {2, kPi * kPi / 2 * std::sqrt(2 * onset_energy(path_of(scheme)).variance)};
}

// The amplitude is that of the energy at meeting: less by (pi^2 / 2 n^2) g. A scheme of second order swings wider by
// x^2 / 2 = pi^2 / (8 n^2) if it shows the positions at which forces are computed, else narrower by as much. And no
// step need fall on the top: the nearest is off by up to half a step, m, and lower by (pi m / n)^2 / 2; m^2 has the
// mean 1 / 12 and the variance 1 / 180.
PowerLaw any_step_overlap_law(const dem::Scheme &scheme) {
  const OnsetEnergy onset = onset_energy(path_of(scheme));
  const double swing = is_fourth_order(scheme) ? 0 : scheme.shared_drift == 0 ? 0.25 : -0.25;
  const double mean = swing - onset.mean - 1.0 / 12;
  return {2, kPi * kPi / 2 * std::sqrt(mean * mean + onset.variance + 1.0 / 180)};
}

PowerLaw damped_duration_law(double restitution) { return {1, Damped(restitution).shortening()}; }

// ln e changes by -Lambda^2 omega^2 / (2 w^2) / n inside the contact. The dashpot's force jumps at meeting and parting,
// which fall anywhere within a step: speeds are off by (1 - 2 p) and (2 q - 1) times Lambda / n. The contact is shorter
// by s steps: the two add up to -2 s for a share 1 - s of the moments and to 2 (1 - s) for the others.
PowerLaw damped_restitution_law(double restitution) {
  const Damped damped(restitution);
  const double bias = damped.loss * damped.loss / (2 * (1 - damped.zeta * damped.zeta));
  const double s = damped.shortening() - std::floor(damped.shortening());
  return {1, restitution * std::sqrt(bias * bias + 4 * damped.loss * damped.loss * s * (1 - s))};
}

// ln d = -ln omega - zeta arccos(zeta) / sqrt(1 - zeta^2) with the changes of omega and zeta, and the error of the
// speed at meeting.
PowerLaw damped_overlap_law(double restitution) {
  const Damped damped(restitution);
  const double zeta = damped.zeta, rest = 1 - zeta * zeta;
  const double slope = std::acos(zeta) / std::pow(rest, 1.5) - zeta / rest;
  const double bias = damped.loss / 2 * (1 + zeta * slope);
  return {1, std::sqrt(bias * bias + damped.loss * damped.loss / 3)};
}

}  // namespace accuracy
