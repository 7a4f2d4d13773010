// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/accuracy/simulation/gas_energy.hpp"

#include "dem/setup/time_step.hpp"
#include "programs/accuracy/simulation/collision_laws.hpp"
#include "programs/accuracy/simulation/oscillator.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace accuracy {
namespace {

// By then the lattice has melted: each sphere has met a few others.
constexpr double kContactsToMelt = 100;

// n of the lightest two over that of a pair, squared, averaged over pairs with 1 / sqrt(mu) as weight: pairs meet as
// often as that.
double mean_square_of_step(const dem::Setup &gas) {
  const double lightest = 0.5 * *std::min_element(gas.masses.begin(), gas.masses.end());
  double sum = 0, weights = 0;
  for (const double a : gas.masses) {
    for (const double b : gas.masses) {
      const double mass = a * b / (a + b), weight = 1 / std::sqrt(mass);
      sum += weight * std::pow(lightest / mass, 2);
      weights += weight;
    }
  }
  return sum / weights;
}

}  // namespace

EnergyErrors energy_errors(const EnergyCase &what) {
  dem::Setup gas = elastic_gas(what.gas);
  gas.scheme = what.scheme;
  gas.time_step = dem::shortest_contact(gas).duration / what.steps;
  gas.skin = 0.2;
  const auto engine = dem::make_engine(gas, what.precision);
  engine->run(static_cast<uint64_t>(kContactsToMelt * what.steps));
  const double first = engine->measure().energy();
  EnergyErrors result;
  double before = first, squares = 0;
  for (int span = 0; span < what.spans; span++) {
    engine->run(static_cast<uint64_t>(what.contacts_per_span * what.steps));
    const double now = engine->measure().energy();
    squares += std::pow(now - before, 2);
    result.largest = std::max(result.largest, std::fabs(now / first - 1));
    before = now;
  }
  result.change = std::sqrt(squares / what.spans) / first;
  return result;
}

// The energy K of the approach has the mean square 2 kT^2. The energy of N spheres is 1.5 N kT.
//   collisions: each changes it by 2 (e - 1) K, a random walk of N rate t / 2 of them
//   contacts at either look, N rate t_c / 2: in those the energy shown is off by K (pi / 2 n) sin(2 phase) under
//   symplectic Euler, whose velocities are half a step off; by K (pi / 2 n)^2 sin^2(phase) under velocity Verlet and
//   with a cosine under leapfrog, which keep a shadow of the energy
PowerLaw energy_change_law(const EnergyCase &what) {
  const dem::Setup gas = elastic_gas(what.gas);
  const auto count = static_cast<double>(gas.count());
  const double met = collision_rate(what.gas, gas) * dem::shortest_contact(gas).duration;  // per sphere and t_c
  const double kicks = std::pow(kPi / 2, 2);
  const double contacts = 2 * count * met / 2;  // at both looks
  if (what.scheme.order == 1) return {1, std::sqrt(2 * contacts * kicks / 2) / (1.5 * count)};
  const PowerLaw collision = any_step_restitution_law(what.scheme);
  const double walk = count * met * what.contacts_per_span / 2 * std::pow(2 * collision.factor, 2);
  const double shown = what.scheme.order == 2 ? contacts * kicks * kicks * 3 / 8 : 0;
  return {collision.order, std::sqrt(2 * mean_square_of_step(gas) * (walk + shown)) / (1.5 * count)};
}

}  // namespace accuracy
