// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Gases against kinetic theory: Haff's law of cooling, and the pressure of a soft elastic gas.
#include "tests/dem/gas.hpp"
#include "tests/support/frame.h"

#include <algorithm>
#include <cstdio>
#include <vector>

namespace {

constexpr uint64_t kSeed = 41;

double temperature(const dem::Measurement &m, size_t count) {
  return 2 * m.translation / (3 * static_cast<double>(count));
}

dem::Setup mono_gas(size_t edge, double fraction, double stiffness) {
  bodies::Gas gas;
  gas.edge = edge;
  gas.spacing = std::cbrt(4 * bodies::kPi / 3 / fraction);
  dem::Setup setup = bodies::make_gas(gas, kSeed);
  std::fill(setup.radii.begin(), setup.radii.end(), 1.0);
  std::fill(setup.masses.begin(), setup.masses.end(), 1.0);
  bodies::make_periodic(setup);
  setup.contact.stiffness = stiffness;
  return setup;
}

// Collisions per particle and time: 4 n sigma^2 g sqrt(pi T / m), g = (1 - nu / 2) / (1 - nu)^3.
double collision_rate(double fraction, double temperature) {
  const double density = fraction / (4 * bodies::kPi / 3), g = (1 - fraction / 2) / std::pow(1 - fraction, 3);
  return 4 * density * 4 * g * std::sqrt(bodies::kPi * temperature);
}

// T(t) = T0 / (1 + t / tau)^2 with 1 / tau = (1 - e^2) / 6 times the collision rate at T0. Returns the fitted 1 / tau
// over that of theory.
double cooling_rate(double restitution) {
  constexpr double kFraction = 0.05;
  dem::Setup setup = mono_gas(8, kFraction, 1e5);
  bodies::set_steps_per_contact(setup, 20);  // the elastic way into equilibrium
  const auto mixing = dem::make_engine(setup);
  mixing->run(15000);
  const dem::Snapshot start = mixing->snapshot();
  setup.centers = start.centers;
  setup.velocities = start.velocities;
  bodies::set_linear(setup, 1e5, restitution);
  bodies::set_steps_per_contact(setup, 20);
  const auto engine = dem::make_engine(setup);
  const double first = temperature(engine->measure(), setup.count());
  double xy = 0, xx = 0;  // 1 / sqrt(T) - 1 / sqrt(T0) = t / (tau sqrt(T0))
  for (int look = 0; look < 30; look++) {
    engine->run(1500);
    const double y = std::sqrt(first / temperature(engine->measure(), setup.count())) - 1;
    xy += engine->time() * y;
    xx += engine->time() * engine->time();
  }
  const double theory = (1 - restitution * restitution) / 6 * collision_rate(kFraction, first);
  std::printf("Haff, e = %g: 1 / tau = %.5f (%.5f), T fell to %.3f\n", restitution, xy / xx, theory,
              temperature(engine->measure(), setup.count()) / first);
  return xy / xx / theory;
}

void a_dilute_gas_cools_by_haffs_law(void **) { assert_true(std::fabs(cooling_rate(0.9) - 1) < 0.05); }

// Z = p V / (N T) = 1 + sum of (force x distance) / (3 N T), Carnahan & Starling: (1 + nu + nu^2 - nu^3) / (1 - nu)^3.
double compressibility_ratio(double fraction) {
  dem::Setup setup = mono_gas(8, fraction, 1e6);
  bodies::set_steps_per_contact(setup, 20);
  const auto engine = dem::make_engine(setup);
  engine->run(10000);
  double sum = 0, heat = 0;
  constexpr int kLooks = 2500;
  for (int look = 0; look < kLooks; look++) {
    engine->run(7);
    const dem::Measurement m = engine->measure();
    sum += m.virial;
    heat += m.translation;
  }
  const double found = 1 + sum / (2 * heat);
  const double theory = (1 + fraction + fraction * fraction - std::pow(fraction, 3)) / std::pow(1 - fraction, 3);
  std::printf("Z at %g: %.4f (%.4f)\n", fraction, found, theory);
  return found / theory;
}

void a_soft_gas_has_the_pressure_of_hard_spheres(void **) {
  assert_true(std::fabs(compressibility_ratio(0.2) - 1) < 0.05);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_dilute_gas_cools_by_haffs_law),
      cmocka_unit_test(a_soft_gas_has_the_pressure_of_hard_spheres),
  };
  return cmocka_run_group_tests_name("cooling", tests, nullptr, nullptr);
}
