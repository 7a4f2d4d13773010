// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What the equations of motion keep: energy, momentum, angular momentum; and the way back in time.
#include "dem/effects/table.hpp"
#include "tests/dem/gas.hpp"
#include "tests/support/frame.h"

#include <algorithm>
#include <cstdio>

namespace {

constexpr uint64_t kSeed = 3;

double largest_energy_error(dem::Setup setup, int looks, uint64_t steps_between) {
  bodies::set_steps_per_contact(setup, 50);
  const auto engine = dem::make_engine(setup);
  const double start = engine->measure().energy();
  double worst = 0;
  for (int look = 0; look < looks; look++) {
    engine->run(steps_between);
    worst = std::max(worst, std::fabs(engine->measure().energy() / start - 1));
  }
  std::printf("energy error at most %.3g in %d looks\n", worst, looks);
  return worst;
}

dem::Setup elastic_gas(int dimension, dem::EffectSet effects) {
  bodies::Gas gas;
  gas.dimension = dimension;
  gas.edge = dimension == 3 ? 6 : 12;
  gas.spacing = 2.3;
  gas.effects = effects;
  return bodies::make_gas(gas, kSeed);
}

// A contact keeps a shadow energy, which differs by a part of n^-2 from the true one; collisions leave a random walk of
// that size (long_run.cpp).
void elastic_gases_keep_their_energy(void **) {
  for (const int dimension : {2, 3}) {
    dem::Setup walled = elastic_gas(dimension, 0);
    bodies::wall_in(walled);
    assert_true(largest_energy_error(walled, 40, 250) < 3e-4);
    dem::Setup periodic = elastic_gas(dimension, 0);
    bodies::make_periodic(periodic);
    assert_true(largest_energy_error(periodic, 40, 250) < 3e-4);
  }
}

void hertz_and_adhesion_keep_energy(void **) {
  dem::Setup hertz = elastic_gas(3, dem::kHertz);
  hertz.contact.young_modulus = 1e5;
  hertz.contact.poisson_ratio = 0.3;
  bodies::wall_in(hertz);
  assert_true(largest_energy_error(hertz, 20, 250) < 3e-4);
  dem::Setup sticky = elastic_gas(3, dem::kAdhesion);
  sticky.contact.adhesion_force = 10;
  sticky.contact.adhesion_range = 0.05;
  bodies::wall_in(sticky);
  assert_true(largest_energy_error(sticky, 20, 250) < 2e-3);
}

struct Balance {
  double momentum = 0, angular = 0;  // largest changes over typical sizes
};

// A cluster in open space with all that acts between two particles.
Balance balance_of(int dimension, dem::EffectSet effects) {
  bodies::Gas gas;
  gas.dimension = dimension;
  gas.edge = 4;
  gas.spacing = 2.0;
  gas.effects = effects;
  dem::Setup setup = bodies::make_gas(gas, kSeed);
  setup.contact.restitution = 0.7;
  setup.contact.friction = 0.5;
  setup.contact.tangential_stiffness = 2.0 / 7;
  setup.contact.adhesion_force = 20;
  setup.contact.adhesion_range = 0.1;
  // Towards the middle, so that all collide.
  const auto d = static_cast<size_t>(dimension);
  for (size_t k = 0; k < setup.centers.size(); k++) {
    setup.velocities[k] -= 0.5 * (setup.centers[k] - 4.0) + (k % d == 0 ? 0.1 * setup.centers[k + 1] : 0);
  }
  bodies::set_steps_per_contact(setup, 50);
  const auto engine = dem::make_engine(setup);
  const dem::Measurement start = engine->measure();
  engine->run(4000);
  const dem::Measurement end = engine->measure();
  Balance result;
  double mass = 0;
  for (const double m : setup.masses) mass += m;
  for (int k = 0; k < 3; k++) {
    result.momentum = std::max(result.momentum, std::fabs(end.momentum[k] - start.momentum[k]) / mass);
    result.angular = std::max(result.angular, std::fabs(end.angular_momentum[k] - start.angular_momentum[k]) / mass);
  }
  std::printf("%s: momentum changed by %.3g, angular momentum by %.3g\n", dem::names_of(effects).c_str(),
              result.momentum, result.angular);
  return result;
}

void pairs_keep_momentum_and_angular_momentum(void **) {
  for (const int dimension : {2, 3}) {
    for (const dem::EffectSet effects : {0u, unsigned{dem::kDissipation}, dem::kDissipation | dem::kFriction,
                                         dem::kDissipation | dem::kFriction | dem::kAdhesion}) {
      const Balance balance = balance_of(dimension, effects);
      assert_true(balance.momentum < 1e-12);
      // Rounding only: forces act along the line of centres or, with friction, at the middle of the overlap.
      assert_true(balance.angular < 1e-11);
    }
  }
}

// Velocities turned round at the time of a step lead back to the start.
double way_back_error(int dimension) {
  bodies::Gas gas;
  gas.dimension = dimension;
  gas.edge = 3;
  gas.spacing = 2.1;
  gas.temperature = 25;
  dem::Setup setup = bodies::make_gas(gas, kSeed);
  bodies::wall_in(setup);
  bodies::set_steps_per_contact(setup, 50);
  const auto out = dem::make_engine(setup);
  out->run(1500);
  const dem::Snapshot turned = out->snapshot();
  dem::Setup back = setup;
  back.centers = turned.centers;
  for (size_t k = 0; k < turned.velocities.size(); k++) back.velocities[k] = -turned.velocities[k];
  const auto home = dem::make_engine(back);
  home->run(1500);
  const dem::Snapshot end = home->snapshot();
  double worst = 0;
  for (size_t k = 0; k < end.centers.size(); k++) {
    worst = std::max(worst, std::fabs(end.centers[k] - setup.centers[k]));
  }
  std::printf("back within %.3g\n", worst);
  return worst;
}

void elastic_motion_runs_backwards(void **) {
  assert_true(way_back_error(2) < 1e-9);
  assert_true(way_back_error(3) < 1e-9);
}

// The same system seen from a moving frame.
double moving_frame_error() {
  bodies::Gas gas;
  gas.edge = 3;
  gas.spacing = 2.1;
  dem::Setup setup = bodies::make_gas(gas, kSeed);
  bodies::make_periodic(setup);
  bodies::set_steps_per_contact(setup, 50);
  dem::Setup moving = setup;
  for (size_t k = 0; k < moving.velocities.size(); k += 3) moving.velocities[k] += 5;
  const auto a = dem::make_engine(setup), b = dem::make_engine(moving);
  a->run(1000);
  b->run(1000);
  const dem::Snapshot at_rest = a->snapshot(), in_motion = b->snapshot();
  double worst = 0;
  for (size_t k = 0; k < at_rest.velocities.size(); k++) {
    worst = std::max(worst, std::fabs(in_motion.velocities[k] - at_rest.velocities[k] - (k % 3 == 0 ? 5 : 0)));
  }
  std::printf("moving frame: velocities within %.3g\n", worst);
  return worst;
}

void motion_is_the_same_in_a_moving_frame(void **) { assert_true(moving_frame_error() < 1e-8); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(elastic_gases_keep_their_energy),          cmocka_unit_test(hertz_and_adhesion_keep_energy),
      cmocka_unit_test(pairs_keep_momentum_and_angular_momentum), cmocka_unit_test(elastic_motion_runs_backwards),
      cmocka_unit_test(motion_is_the_same_in_a_moving_frame),
  };
  return cmocka_run_group_tests_name("conservation", tests, nullptr, nullptr);
}
