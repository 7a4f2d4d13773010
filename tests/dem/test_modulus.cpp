// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Stiffness by size: the rule of pairs and walls, collisions of any sizes, and mixtures that do not sink into each
// other.
#include "packing/random.hpp"
#include "tests/dem/bodies.hpp"
#include "tests/support/frame.h"

#include <algorithm>
#include <cstdio>

namespace {

constexpr uint64_t kSeed = 12;
constexpr double kModulus = 5e4;

dem::Setup of_modulus(double restitution = 1) {
  dem::Setup setup;
  setup.effects = dem::kModulus;
  setup.contact.modulus = kModulus;
  setup.contact.restitution = restitution;
  if (restitution < 1) setup.effects |= dem::kDissipation;
  return setup;
}

// Columns in series: 1 / k is the sum of 1 / (pi E r); what is stored tells k.
void columns_lie_in_series(void **) {
  for (const double other : {1.0, 3.0, 50.0}) {
    dem::Setup setup = of_modulus();
    bodies::add(setup, {0, 0, 0}, {0, 0, 0}, 1, 1);
    bodies::add(setup, {0.99 + other, 0, 0}, {0, 0, 0}, other, 1);
    setup.time_step = dem::usual_step(setup);
    const double stiffness = bodies::kPi * kModulus / (1 + 1 / other);
    assert_true(std::fabs(dem::make_engine(setup)->measure().contact / (0.5 * stiffness * 1e-4) - 1) < 1e-9);
  }
  for (const double wall : {0.0, 1e4}) {
    dem::Setup setup = of_modulus();
    setup.contact.wall_modulus = wall;
    bodies::set_walls(setup, 2, 0, 10);
    bodies::add(setup, {0, 0, 1.99}, {0, 0, 0}, 2, 1);
    setup.time_step = dem::usual_step(setup);
    const double stiffness = bodies::kPi * 2 / (1 / kModulus + (wall > 0 ? 1 / wall : 0));
    assert_true(std::fabs(dem::make_engine(setup)->measure().contact / (0.5 * stiffness * 1e-4) - 1) < 1e-9);
  }
}

// Restitution is that of the scene for every pair, and the duration that of its spring.
bool collides_as_an_oscillator(double other, double restitution) {
  dem::Setup setup = of_modulus(restitution);
  const double mass = bodies::ball_mass(1, 1), heavy = bodies::ball_mass(other, 1);
  bodies::add(setup, {0, 0, 0}, {0.3, 0, 0}, 1, mass);
  bodies::add(setup, {1.001 + other, 0, 0}, {0, 0, 0}, other, heavy);
  const double reduced = mass * heavy / (mass + heavy), log_e = std::log(restitution);
  const double stiffness = bodies::kPi * kModulus / (1 + 1 / other);
  const double duration = std::sqrt(reduced * (bodies::kPi * bodies::kPi + log_e * log_e) / stiffness);
  setup.time_step = duration / 2000;
  const bodies::Collision collision = bodies::follow_collision(setup, 20000);
  const double after = collision.after.velocities[3] - collision.after.velocities[0];
  std::printf("ratio %g: restitution %.5f (%g), duration %.6g (%.6g)\n", other, after / 0.3, restitution,
              collision.duration, duration);
  return std::fabs(after / 0.3 - restitution) < 2e-3 && std::fabs(collision.duration / duration - 1) < 3e-3;
}

void pairs_of_any_sizes_keep_their_restitution(void **) {
  for (const double other : {1.0, 3.0, 50.0}) {
    for (const double restitution : {1.0, 0.5}) assert_true(collides_as_an_oscillator(other, restitution));
  }
}

// No pair of particles of any size and density, and no wall, has a shorter contact than the step is reckoned from.
void the_step_is_that_of_the_shortest_pair(void **) {
  packing::Random random(kSeed);
  for (int round = 0; round < 100; round++) {
    dem::Setup setup = of_modulus();
    for (int n = 0; n < 10; n++) {
      const double radius = std::pow(10, 2 * random.uniform()), density = std::pow(10, random.uniform());
      bodies::add(setup, {0, 0, 0}, {0, 0, 0}, radius, bodies::ball_mass(radius, density));
    }
    const double shortest = dem::shortest_contact(setup).duration;
    double found = dem::kInfinity;
    for (size_t i = 0; i < setup.count(); i++) {
      const double r = setup.radii[i], m = setup.masses[i];
      found = std::min(found, bodies::kPi * std::sqrt(m / (bodies::kPi * kModulus * r)));
      for (size_t j = 0; j < i; j++) {
        const double stiffness = bodies::kPi * kModulus / (1 / r + 1 / setup.radii[j]);
        found = std::min(found, bodies::kPi * std::sqrt(1 / (1 / m + 1 / setup.masses[j]) / stiffness));
      }
    }
    assert_true(shortest <= found * (1 + 1e-12) && shortest > 0.99 * found);
  }
}

// Giants of ratio 20 among small ones on the floor: nobody sinks. With one stiffness for all sizes, that of the small
// ones, the giants' own weight would press them in by more than their radius.
void giants_settle_with_small_overlaps(void **) {
  dem::Setup setup = of_modulus(0.5);
  setup.effects |= dem::kGravity | dem::kDrag;
  setup.gravity[2] = -1;
  setup.viscosity = 1;
  for (int axis = 0; axis < 3; axis++) bodies::set_walls(setup, axis, 0, axis == 2 ? 120 : 45);
  packing::Random random(kSeed);
  for (int giant = 0; giant < 2; giant++) {
    bodies::add(setup, {22.5 + giant, 22.5, 28.0 + 42 * giant}, {0, 0, 0}, 20, bodies::ball_mass(20, 1));
  }
  for (int n = 0; n < 1200; n++) {
    const double x = 1.5 + 2.1 * (n % 20), y = 1.5 + 2.1 * (n / 20 % 20), z = 1.1 + 2.2 * static_cast<double>(n / 400);
    bodies::add(setup, {x + 0.05 * random.uniform(), y, z}, {0, 0, 0}, 1, bodies::ball_mass(1, 1));
  }
  setup.time_step = dem::shortest_contact(setup).duration / 20;
  const auto engine = dem::make_engine(setup);
  engine->run(static_cast<uint64_t>(30 / setup.time_step));
  const dem::Measurement m = engine->measure();
  std::printf("overlap %.4f of the smaller radius, kinetic energy %.3g, %zu contacts\n", m.largest_overlap,
              m.translation, m.contacts + m.wall_contacts);
  assert_true(m.largest_overlap < 0.01 && m.behind_walls == 0);
  assert_true(m.contacts + m.wall_contacts > setup.count());
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(columns_lie_in_series),
      cmocka_unit_test(pairs_of_any_sizes_keep_their_restitution),
      cmocka_unit_test(the_step_is_that_of_the_shortest_pair),
      cmocka_unit_test(giants_settle_with_small_overlaps),
  };
  return cmocka_run_group_tests_name("modulus", tests, nullptr, nullptr);
}
