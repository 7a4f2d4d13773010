// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/accuracy/simulation/elastic_gas.hpp"

#include "dem/engine/engine.hpp"
#include "dem/setup/time_step.hpp"
#include "packing/random.hpp"
#include "programs/accuracy/simulation/oscillator.hpp"

#include <cmath>

namespace accuracy {
namespace {

constexpr double kStiffness = 1e4;

void heat(const GasCase &what, dem::Setup &gas, packing::Random &random) {
  double momentum[3] = {0, 0, 0}, mass = 0;
  for (const double m : gas.masses) {
    for (double &p : momentum) {
      const double v = std::sqrt(temperature_of(what) / m) * random.normal();
      gas.velocities.push_back(v);
      p += m * v;
    }
    mass += m;
  }
  for (size_t k = 0; k < gas.velocities.size(); k++) gas.velocities[k] -= momentum[k % 3] / mass;
}

}  // namespace

double temperature_of(const GasCase &what) { return 2 * kStiffness * what.overlap * what.overlap / kPi; }

dem::Setup elastic_gas(const GasCase &what) {
  dem::Setup gas;
  gas.effects = what.periodic ? dem::kPeriodic : dem::kWalls;
  gas.contact.stiffness = kStiffness;
  packing::Random random(what.seed);
  const double spacing = std::cbrt(4 * kPi / 3 / what.density);
  const size_t count = what.edge * what.edge * what.edge;
  for (size_t i = 0; i < count; i++) {
    const size_t place[] = {i % what.edge, i / what.edge % what.edge, i / what.edge / what.edge};
    for (const size_t p : place) gas.centers.push_back((static_cast<double>(p) + 0.5) * spacing);
    gas.radii.push_back(1);
    gas.masses.push_back(1 + what.mass_spread * random.uniform());
  }
  for (int axis = 0; axis < 3; axis++) {
    gas.box_max[axis] = static_cast<double>(what.edge) * spacing;
    gas.periodic[axis] = what.periodic;
    gas.walled[axis] = !what.periodic;
  }
  heat(what, gas, random);
  return gas;
}

dem::Setup melted_gas(const GasCase &what) {
  constexpr auto kSteps = static_cast<uint64_t>(20 * dem::kUsualStepsPerContact);
  dem::Setup gas = elastic_gas(what);
  gas.time_step = dem::shortest_contact(gas).duration / dem::kUsualStepsPerContact;
  gas.skin = 0.1;
  const auto engine = dem::make_engine(gas);
  engine->run(kSteps);
  const dem::Snapshot state = engine->snapshot();
  gas.centers = state.centers;
  gas.velocities = state.velocities;
  return gas;
}

GasCase timed_gas(size_t count) {
  GasCase gas;
  gas.edge = static_cast<size_t>(std::lround(std::cbrt(static_cast<double>(count))));
  gas.density = 0.4;
  gas.periodic = false;
  return gas;
}

double collision_rate(const GasCase &what, const dem::Setup &gas) {
  double speed = 0;  // sqrt(kT / (2 mu)), averaged over pairs
  const auto count = static_cast<double>(gas.count());
  for (const double a : gas.masses) {
    for (const double b : gas.masses) speed += std::sqrt(temperature_of(what) * (1 / a + 1 / b) / 2) / (count * count);
  }
  constexpr double kSphereVolume = 4 * kPi / 3, kDiameter = 2;
  const double number_density = what.density / kSphereVolume;
  const double contact_value = (1 - what.density / 2) / std::pow(1 - what.density, 3);
  return 4 * number_density * kDiameter * kDiameter * contact_value * std::sqrt(kPi) * speed;
}

}  // namespace accuracy
