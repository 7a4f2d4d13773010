// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Systems that come to rest, and hard starts: stacks, a heap, extreme ratios of size and mass, deep overlaps.
#include "packing/random.hpp"
#include "tests/dem/bodies.hpp"
#include "tests/support/frame.h"

#include <algorithm>
#include <cstdio>

namespace {

constexpr uint64_t kSeed = 5;

dem::Setup on_the_floor(int dimension, double stiffness, double restitution) {
  dem::Setup setup;
  setup.dimension = dimension;
  setup.effects = dem::kGravity;
  bodies::set_linear(setup, stiffness, restitution);
  setup.gravity[dimension - 1] = -1;
  bodies::set_walls(setup, dimension - 1, 0, 1000);
  return setup;
}

struct Stack {
  double kinetic = 0, worst_overlap_error = 0;
};

// Equal spheres on top of each other: contact k from the top carries k + 1 of them, so it overlaps by (k + 1) m g / k.
Stack settle_stack(int height) {
  dem::Setup setup = on_the_floor(3, 1e4, 0.3);
  for (int n = 0; n < height; n++) bodies::add(setup, {0, 0, 1.0 + 2.0 * n}, {0, 0, 0}, 1, 1);
  bodies::set_steps_per_contact(setup, 20);
  const auto engine = dem::make_engine(setup);
  engine->run(40000);
  const dem::Snapshot state = engine->snapshot();
  Stack result;
  result.kinetic = engine->measure().translation;
  for (int n = 0; n < height; n++) {
    const double below = n > 0 ? state.centers[3 * static_cast<size_t>(n - 1) + 2] + 1 : 0;
    const double overlap = below + 1 - state.centers[3 * static_cast<size_t>(n) + 2];
    const double expected = (height - n) / setup.contact.stiffness;
    result.worst_overlap_error = std::max(result.worst_overlap_error, std::fabs(overlap / expected - 1));
  }
  std::printf("stack of %d: kinetic energy %.3g, overlaps within %.3g\n", height, result.kinetic,
              result.worst_overlap_error);
  return result;
}

void a_stack_stands_on_its_springs(void **) {
  const Stack stack = settle_stack(10);
  assert_true(stack.kinetic < 1e-20);
  assert_true(stack.worst_overlap_error < 1e-8);
}

struct Heap {
  double kinetic = 0, drift = 0, height = 0;
};

// Rough discs dropped onto a floor of fixed ones; late in the run nothing may move any more.
Heap settle_heap() {
  dem::Setup setup;
  setup.dimension = 2;
  setup.effects = dem::kGravity | dem::kFriction | dem::kRolling;
  bodies::set_linear(setup, 1e4, 0.3);
  setup.gravity[1] = -1;
  setup.contact.friction = 0.6;
  setup.contact.tangential_stiffness = 2.0 / 7;
  setup.contact.rolling_friction = 0.1;
  setup.contact.rolling_stiffness = 2.0 / 7;
  for (int n = 0; n < 40; n++) bodies::add(setup, {2.0 * n - 39, 0}, {0, 0}, 1, dem::kImmovable);
  packing::Random random(kSeed);
  for (int n = 0; n < 80; n++) {
    const double x = 2.1 * (n % 8) - 7.35 + 0.1 * random.uniform();
    bodies::add(setup, {x, 2.2 + 2.1 * static_cast<double>(n / 8)}, {0, 0}, 1, 1);
  }
  bodies::set_steps_per_contact(setup, 20);
  const auto engine = dem::make_engine(setup);
  engine->run(70000);
  const dem::Snapshot settled = engine->snapshot();
  engine->run(10000);
  const dem::Snapshot later = engine->snapshot();
  Heap result;
  result.kinetic = engine->measure().translation + engine->measure().rotation;
  for (size_t k = 0; k < later.centers.size(); k++) {
    result.drift = std::max(result.drift, std::fabs(later.centers[k] - settled.centers[k]));
    if (k % 2 == 1) result.height = std::max(result.height, later.centers[k]);
  }
  std::printf("heap: kinetic energy %.3g, moved %.3g in %.3g, %.1f high\n", result.kinetic, result.drift,
              10000 * setup.time_step, result.height);
  return result;
}

void a_heap_stays(void **) {
  const Heap heap = settle_heap();
  assert_true(heap.kinetic < 1e-9);
  assert_true(heap.drift < 1e-4);
  assert_true(heap.height > 4);  // more than a layer
}

struct Mixture {
  double energy_rise = 0;   // of the total, over that at the start
  double lowest = 0;        // the deepest centre over the radius of its particle
  double kinetic_left = 0;  // over the energy of the fall
};

// One giant, 50 times as large and 125 000 times as heavy, falls onto small ones.
Mixture drop_a_giant() {
  dem::Setup setup = on_the_floor(3, 1e6, 0.5);
  for (int axis = 0; axis < 2; axis++) bodies::set_walls(setup, axis, 0, 110);
  bodies::add(setup, {55, 55, 54}, {0, 0, 0}, 50, 125000);
  packing::Random random(kSeed);
  for (int i = 0; i < 20; i++) {
    for (int j = 0; j < 20; j++) {
      bodies::add(setup, {3 + 5.4 * i + random.uniform(), 3 + 5.4 * j + random.uniform(), 1.2}, {0, 0, 0}, 1, 1);
    }
  }
  bodies::set_steps_per_contact(setup, 20);
  const auto engine = dem::make_engine(setup);
  const double start = engine->measure().energy();
  Mixture result;
  result.energy_rise = -1;
  for (int look = 0; look < 60; look++) {
    engine->run(1000);
    result.energy_rise = std::max(result.energy_rise, engine->measure().energy() / start - 1);
  }
  const dem::Snapshot state = engine->snapshot();
  result.lowest = state.centers[2] / 50;
  for (size_t i = 0; i < state.radii.size(); i++) {
    result.lowest = std::min(result.lowest, state.centers[3 * i + 2] / state.radii[i]);
  }
  result.kinetic_left = engine->measure().translation / (125000.0 * 2);
  std::printf("giant: energy rose by %.3g, lowest centre at %.3f of its radius, kinetic energy left %.3g\n",
              result.energy_rise, result.lowest, result.kinetic_left);
  return result;
}

void size_ratio_50_and_mass_ratio_125000_stay_calm(void **) {
  const Mixture mixture = drop_a_giant();
  assert_true(mixture.energy_rise < 1e-6);
  assert_true(mixture.lowest > 0.5);
  assert_true(mixture.kinetic_left < 0.1);
}

struct Burst {
  double energy_error = 0, speed = 0, expected_speed = 0;
};

// Two spheres that start with nine tenths of their reach overlapped fly apart with sqrt(k / mu) d.
Burst deep_overlap(double separation) {
  dem::Setup setup;
  bodies::set_linear(setup, 1e4);
  bodies::add(setup, {0, 0, 0}, {0, 0, 0}, 1, 1);
  bodies::add(setup, {separation, 0, 0}, {0, 0, 0}, 1, 1);
  bodies::set_steps_per_contact(setup, 200);
  const auto engine = dem::make_engine(setup);
  const double start = engine->measure().energy();
  engine->run(400);
  const dem::Snapshot state = engine->snapshot();
  Burst result;
  result.energy_error = std::fabs(engine->measure().energy() / start - 1);
  result.speed = state.velocities[3] - state.velocities[0];
  result.expected_speed = std::sqrt(1e4 / 0.5) * (2 - separation);
  std::printf("apart with %.6f (%.6f), energy within %.3g\n", result.speed, result.expected_speed, result.energy_error);
  return result;
}

void deep_overlaps_fly_apart_as_springs_do(void **) {
  for (const double separation : {0.2, 1e-9, 0.0}) {
    const Burst burst = deep_overlap(separation);
    assert_true(burst.energy_error < 1e-4);
    assert_true(std::fabs(burst.speed / burst.expected_speed - 1) < 1e-4);
  }
}

// A centre that starts behind the wall comes back.
void a_centre_behind_a_wall_comes_back(void **) {
  dem::Setup setup;
  bodies::set_linear(setup, 1e4);
  bodies::set_walls(setup, 0, 0, 10);
  bodies::add(setup, {-0.5, 0, 0}, {0, 0, 0}, 1, 1);
  bodies::set_steps_per_contact(setup, 50);
  const auto engine = dem::make_engine(setup);
  engine->run(100);
  const double x = engine->snapshot().centers[0];
  assert_true(x > 1);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_stack_stands_on_its_springs),
      cmocka_unit_test(a_heap_stays),
      cmocka_unit_test(size_ratio_50_and_mass_ratio_125000_stay_calm),
      cmocka_unit_test(deep_overlaps_fly_apart_as_springs_do),
      cmocka_unit_test(a_centre_behind_a_wall_comes_back),
  };
  return cmocka_run_group_tests_name("rest", tests, nullptr, nullptr);
}
