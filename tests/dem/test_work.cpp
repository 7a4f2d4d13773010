// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Dissipated work and work put in, of each channel against closed forms; the balance of all energies, which errs by the
// square of the step; the course of a run that nobody counts.
#include "packing/random.hpp"
#include "tests/dem/gas.hpp"
#include "tests/support/frame.h"
#include "tests/support/refusal.hpp"

#include <algorithm>
#include <cstdio>

namespace {

constexpr uint64_t kSeed = 17;

bool is_near(double value, double expected, double within) {
  const bool near = std::fabs(value - expected) <= within * std::fabs(expected);
  if (!near) std::printf("%.12g where %.12g is expected\n", value, expected);
  return near;
}

dem::Measurement after(const dem::Setup &setup, double time) {
  const auto engine = dem::make_engine(setup);
  engine->count_work();
  engine->run(static_cast<uint64_t>(time / setup.time_step));
  return engine->measure();
}

// (1 - e^2) mu v^2 / 2 of a collision.
void dashpots_take_what_restitution_says(void **) {
  for (const double restitution : {0.9, 0.5, 0.1}) {
    dem::Setup setup;
    bodies::set_linear(setup, 1e4, restitution);
    bodies::add(setup, {0, 0, 0}, {0.5, 0.1, 0}, 1, 1);
    bodies::add(setup, {2.01, 0, 0}, {0, 0.1, 0}, 1, 2);
    bodies::set_steps_per_contact(setup, 1000);
    const dem::Measurement m = after(setup, 0.5);
    assert_true(m.contacts == 0);
    assert_true(is_near(m.work.dashpot, (1 - restitution * restitution) / 3 * 0.25, 5e-3));
    assert_true(m.work.friction == 0 && m.work.rolling == 0 && m.work.drag == 0 && m.work.input == 0);
  }
}

// A ball thrown along a floor slides until it rolls, with 5/7 of its speed: friction takes m v^2 / 7.
void sliding_takes_two_sevenths_of_the_motion(void **) {
  dem::Setup setup;
  setup.effects = dem::kFriction | dem::kGravity;
  bodies::set_linear(setup, 1e5, 0.5);
  setup.contact.friction = 0.3;
  setup.gravity[2] = -10;
  bodies::set_walls(setup, 2, 0, 10);
  bodies::add(setup, {0, 0, 1 - 10.0 / 1e5}, {2, 0, 0}, 1, 1);
  setup.time_step = dem::usual_step(setup);
  const dem::Measurement m = after(setup, 2);
  assert_true(is_near(m.work.friction, 4.0 / 7, 1e-3));
  assert_true(is_near(m.balance(), 2 + 10 * (1 - 1e-4) + 0.5e5 * 1e-8, 1e-5));
}

// A ball that rolls to rest leaves its energy to both.
void rolling_resistance_takes_the_rest(void **) {
  dem::Setup setup;
  setup.effects = dem::kFriction | dem::kRolling | dem::kGravity;
  bodies::set_linear(setup, 1e5, 0.5);
  setup.contact.friction = 0.5;
  setup.contact.rolling_friction = 0.05;
  setup.gravity[2] = -10;
  bodies::set_walls(setup, 2, 0, 10);
  bodies::add(setup, {0, 0, 1 - 10.0 / 1e5}, {1, 0, 0}, 1, 1, {0, 1, 0});
  setup.time_step = dem::usual_step(setup);
  const dem::Measurement m = after(setup, 8);
  std::printf("rolling %.5f, friction %.5f of 0.7\n", m.work.rolling, m.work.friction);
  assert_true(m.translation + m.rotation < 1e-9);
  assert_true(is_near(m.work.rolling + m.work.friction + m.work.dashpot, 0.7, 1e-4) && m.work.rolling > 0.6);
}

// Falling at the terminal speed, drag takes all that weight gives.
void drag_takes_what_weight_gives(void **) {
  dem::Setup setup;
  setup.effects = dem::kDrag | dem::kGravity;
  bodies::set_linear(setup, 1e4);
  setup.viscosity = 0.2;
  setup.gravity[2] = -2;
  const double speed = 3 * 2 / (6 * bodies::kPi * 0.2 * 1.5);
  bodies::add(setup, {0, 0, 0}, {0, 0, -speed}, 1.5, 3);
  setup.time_step = 1e-3;
  const dem::Measurement m = after(setup, 5);
  assert_true(is_near(m.work.drag, 3 * 2 * speed * 5, 1e-9));
}

// A fixed ball that moves with u gives one at rest 2 u.
void fixed_particles_that_move_put_energy_in(void **) {
  dem::Setup setup;
  bodies::set_linear(setup, 1e4);
  bodies::add(setup, {0, 0, 0}, {0.25, 0, 0}, 1, dem::kImmovable);
  bodies::add(setup, {2.001, 0, 0}, {0, 0, 0}, 1, 2);
  bodies::set_steps_per_contact(setup, 200);
  const dem::Measurement m = after(setup, 1);
  assert_true(m.contacts == 0 && is_near(m.translation, 0.25, 1e-4) && is_near(m.work.input, 0.25, 1e-4));
}

dem::Setup gas_of(dem::EffectSet effects, double steps) {
  bodies::Gas gas;
  gas.edge = 5;
  gas.spacing = 2.1;
  gas.temperature = 4;
  gas.effects = effects;
  dem::Setup setup = bodies::make_gas(gas, kSeed);
  setup.contact.restitution = 0.8;
  setup.contact.friction = 0.4;
  setup.contact.rolling_friction = 0.1;
  setup.contact.modulus = setup.contact.young_modulus = 1e4;
  setup.contact.poisson_ratio = 0.3;
  setup.contact.adhesion_force = 5;
  setup.contact.adhesion_range = 0.1;
  setup.gravity[2] = -1;
  setup.viscosity = 0.05;
  setup.shear_rate = 0.5;
  if (dem::has(effects, dem::kShear)) {
    setup.impact_speed = 60;
    bodies::make_periodic(setup);
  } else {
    bodies::wall_in(setup);
  }
  setup.time_step = dem::shortest_contact(setup).duration / steps;
  return setup;
}

// The largest departure of the balance from its start over the kinetic energy then, rms of looks.
double imbalance(dem::EffectSet effects, double steps) {
  const dem::Setup setup = gas_of(effects, steps);
  const auto engine = dem::make_engine(setup);
  engine->count_work();
  const dem::Measurement start = engine->measure();
  double sum = 0, dissipated = 0;
  constexpr int kLooks = 40;
  for (int look = 0; look < kLooks; look++) {
    engine->run(static_cast<uint64_t>(steps / 2));
    const dem::Measurement m = engine->measure();
    sum += std::pow((m.balance() - start.balance()) / (start.translation + start.rotation), 2);
    dissipated = m.work.dissipated() / (start.translation + start.rotation);
  }
  const double rms = std::sqrt(sum / kLooks);
  std::printf("effects %4u, %3.0f steps: imbalance %.2e, dissipated %.3f\n", effects, steps, rms, dissipated);
  return rms;
}

// Dashpots and sliders err in the first order of the step, what they take does not: the balance is of the second order.
void the_balance_errs_by_the_square_of_the_step(void **) {
  const dem::EffectSet sets[] = {
      dem::kDissipation,
      dem::kDissipation | dem::kFriction | dem::kRolling | dem::kGravity,
      dem::kDissipation | dem::kFriction | dem::kModulus | dem::kDrag,
      dem::kDissipation | dem::kFriction | dem::kPeriodic | dem::kShear,
  };
  for (const dem::EffectSet set : sets) {
    const double coarse = imbalance(set, 50), fine = imbalance(set, 200);
    std::printf("order %.2f\n", std::log(coarse / fine) / std::log(4));
    assert_true(coarse < 2e-3);
    assert_true(coarse > 6 * fine);
  }
}

// Velocities c against the profile obey d/dt (sum of m c c / 2 + elastic energy) = -rate s_xy V - what is dissipated.
void shear_feeds_motion_by_its_stress(void **) {
  dem::Setup setup = gas_of(dem::kDissipation | dem::kPeriodic | dem::kShear, 50);
  double mass = 0;
  for (size_t i = 0; i < setup.count(); i++) {
    setup.velocities[3 * i] += setup.shear_rate * (setup.centers[3 * i + 1] - setup.box_max[1] / 2);
    mass += setup.masses[i];
  }
  const auto engine = dem::make_engine(setup);
  engine->count_work();
  const auto held = [&](const dem::Measurement &m) {
    return 1.5 * mass * m.bulk.temperature + m.contact + m.work.dissipated();
  };
  const double start = held(engine->measure()), volume = std::pow(setup.box_max[0], 3);
  constexpr uint64_t kSteps = 5;
  double fed = 0;
  for (int look = 0; look < 4000; look++) {
    engine->run(kSteps);
    fed -= engine->measure().bulk.stress[3] * setup.shear_rate * volume * kSteps * setup.time_step;
  }
  const double gained = held(engine->measure()) - start;
  std::printf("fed %.5g, gained and dissipated %.5g\n", fed, gained);
  assert_true(is_near(fed, gained, 5e-3));
}

void counting_changes_nothing_and_goes_on(void **) {
  const dem::Setup setup = gas_of(dem::kDissipation | dem::kFriction, 50);
  const auto plain = dem::make_engine(setup), counting = dem::make_engine(setup), again = dem::make_engine(setup);
  counting->count_work();
  again->count_work();
  plain->run(200);
  counting->run(100);
  dem::Checkpoint checkpoint;
  counting->save(checkpoint);
  again->restore(checkpoint);
  counting->run(100);
  again->run(100);
  assert_true(plain->snapshot().centers == counting->snapshot().centers);
  assert_true(plain->snapshot().spins == counting->snapshot().spins);
  assert_true(counting->measure().work.friction == again->measure().work.friction);
  assert_true(counting->measure().work.dashpot == again->measure().work.dashpot);
}

void what_cannot_be_counted_is_refused(void **) {
  dem::Setup setup = gas_of(dem::kGrowth, 50);
  assert_true(test::is_refused("not counted with growth", [&] { dem::make_engine(setup)->count_work(); }));
  setup = gas_of(0, 50);
  setup.scheme = dem::symplectic_euler();
  assert_true(test::is_refused("scheme symplectic-euler", [&] { dem::make_engine(setup)->count_work(); }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(dashpots_take_what_restitution_says),
      cmocka_unit_test(sliding_takes_two_sevenths_of_the_motion),
      cmocka_unit_test(rolling_resistance_takes_the_rest),
      cmocka_unit_test(drag_takes_what_weight_gives),
      cmocka_unit_test(fixed_particles_that_move_put_energy_in),
      cmocka_unit_test(the_balance_errs_by_the_square_of_the_step),
      cmocka_unit_test(shear_feeds_motion_by_its_stress),
      cmocka_unit_test(counting_changes_nothing_and_goes_on),
      cmocka_unit_test(what_cannot_be_counted_is_refused),
  };
  return cmocka_run_group_tests_name("work", tests, nullptr, nullptr);
}
