// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Averages over the box against closed forms: stress of a pair, of lattices, of a pile at rest and of a gas, fabric,
// coordination, rattlers, granular temperature; the list of contacts.
#include "tests/dem/gas.hpp"
#include "tests/support/frame.h"

#include <cstdio>

namespace {

constexpr double kStiffness = 1e4;

bool is_near(double value, double expected, double within) {
  const bool near = std::fabs(value - expected) <= within;
  if (!near) std::printf("%.12g where %.12g is expected\n", value, expected);
  return near;
}

// Two balls that lean on each other along (0.6, 0.8, 0): F l n n / V.
void a_pair_has_the_stress_of_its_branch(void **) {
  const double overlap = 0.01, distance = 3 - overlap, force = kStiffness * overlap, volume = 10 * 20 * 30;
  dem::Setup setup;
  bodies::set_linear(setup, kStiffness);
  for (int axis = 0; axis < 3; axis++) bodies::set_periodic(setup, axis, 0, 10 * (axis + 1));
  bodies::add(setup, {5, 19, 5}, {0, 0, 0}, 1, 1);
  bodies::add(setup, {5 + 0.6 * distance, 19 + 0.8 * distance - 20, 5}, {0, 0, 0}, 2, 8);
  setup.time_step = dem::usual_step(setup);
  const auto engine = dem::make_engine(setup);
  const dem::Bulk bulk = engine->measure().bulk;
  const double unit = force * distance / volume;
  const double expected[] = {0.36 * unit, 0.64 * unit, 0, 0.48 * unit, 0, 0};
  for (int k = 0; k < 6; k++) assert_true(is_near(bulk.stress[k], expected[k], 1e-12 * unit));
  assert_true(is_near(bulk.pressure, unit / 3, 1e-12 * unit));
  assert_true(is_near(bulk.fabric[0], 0.36, 1e-12) && is_near(bulk.fabric[3], 0.48, 1e-12));
  assert_true(bulk.coordination == 1 && bulk.rattlers == 2 && bulk.backbone == 0);
  const std::vector<dem::ContactLine> lines = engine->contacts();
  assert_int_equal(lines.size(), 1);
  assert_true(lines[0].a == 0 && lines[0].b == 1);
  assert_true(is_near(lines[0].normal, force, 1e-9) && is_near(lines[0].overlap, overlap, 1e-12));
  assert_true(is_near(lines[0].to[1] - lines[0].from[1], 0.8 * distance, 1e-12));  // the image, not the particle
}

// Every sphere of a cubic lattice bears k d on each axis: the stress is k d a / a^3.
void a_lattice_has_the_stress_of_its_springs(void **) {
  constexpr size_t kEdge = 4;
  const double spacing[] = {1.98, 1.96, 1.99};
  dem::Setup setup;
  bodies::set_linear(setup, kStiffness);
  for (int axis = 0; axis < 3; axis++) bodies::set_periodic(setup, axis, 0, kEdge * spacing[axis]);
  for (size_t n = 0; n < kEdge * kEdge * kEdge; n++) {
    const double place[] = {static_cast<double>(n % kEdge), static_cast<double>(n / kEdge % kEdge),
                            static_cast<double>(n / kEdge / kEdge)};
    bodies::add(setup, {place[0] * spacing[0], place[1] * spacing[1], place[2] * spacing[2]}, {0, 0, 0}, 1, 1);
  }
  bodies::add(setup, {0.5 * spacing[0], 0.5 * spacing[1], 0.5 * spacing[2]}, {0, 0, 0}, 0.5, 1);  // loose in a cage
  setup.time_step = dem::usual_step(setup);
  const dem::Bulk bulk = dem::make_engine(setup)->measure().bulk;
  const double cell = spacing[0] * spacing[1] * spacing[2];
  for (int axis = 0; axis < 3; axis++) {
    const double expected = kStiffness * (2 - spacing[axis]) * spacing[axis] / cell;
    assert_true(is_near(bulk.stress[axis], expected, 1e-9 * expected));
    assert_true(is_near(bulk.stress[3 + axis], 0, 1e-9 * expected));
    assert_true(is_near(bulk.fabric[axis], 1.0 / 3, 1e-12) && is_near(bulk.fabric[3 + axis], 0, 1e-12));
  }
  assert_true(bulk.rattlers == 1 && bulk.backbone == 6 && is_near(bulk.coordination, 6 * 64.0 / 65, 1e-12));
}

// A cubic block without cages: corners have 3 contacts, then edges, and nothing is left. With friction 3 are enough.
void rattlers_leave_others_loose(void **) {
  for (const bool rough : {false, true}) {
    dem::Setup setup;
    bodies::set_linear(setup, kStiffness);
    if (rough) setup.effects |= dem::kFriction;
    for (int n = 0; n < 27; n++) {
      bodies::add(setup, {1.99 * (n % 3), 1.99 * (n / 3 % 3), 1.99 * static_cast<double>(n / 9)}, {0, 0, 0}, 1, 1);
    }
    setup.time_step = dem::usual_step(setup);
    const dem::Bulk bulk = dem::make_engine(setup)->measure().bulk;
    assert_true(is_near(bulk.coordination, 2 * 54 / 27.0, 1e-12));
    assert_int_equal(bulk.rattlers, rough ? 0 : 27);
    assert_true(is_near(bulk.backbone, rough ? 4 : 0, 1e-12));
  }
}

// A pile at rest: V s_zz = sum of m g z above the floor, whatever bears it; the floor bears all of the weight.
void a_pile_at_rest_has_the_stress_of_its_weight(void **) {
  dem::Setup setup;
  setup.effects = dem::kGravity;
  bodies::set_linear(setup, kStiffness, 0.3);
  setup.gravity[2] = -2;
  bodies::set_walls(setup, 2, 0, 40);
  for (int axis = 0; axis < 2; axis++) bodies::set_periodic(setup, axis, 0, 5);
  for (int n = 0; n < 10; n++) bodies::add(setup, {2.5, 2.5, 0.99 + 1.99 * n}, {0, 0, 0}, 1, 1.5);
  setup.time_step = dem::usual_step(setup);
  const auto engine = dem::make_engine(setup);
  engine->run(60000);
  const dem::Measurement m = engine->measure();
  const dem::Snapshot state = engine->snapshot();
  double moment = 0;
  for (size_t i = 0; i < state.count(); i++) moment += 1.5 * 2 * state.centers[3 * i + 2];
  assert_true(m.translation < 1e-12);
  assert_true(is_near(m.bulk.stress[2], moment / (5 * 5 * 40), 1e-6 * moment / 1000));
  double floor = 0;
  for (const dem::ContactLine &line : engine->contacts()) floor += line.b < 0 ? line.normal : 0;
  assert_true(is_near(floor, 10 * 1.5 * 2, 1e-4));
}

// Of particles that do not touch the stress is that of their motion: N kT / V; drift and shear are no temperature.
void motion_against_the_flow_is_temperature(void **) {
  bodies::Gas gas;
  gas.temperature = 3;
  dem::Setup setup = bodies::make_gas(gas, 7);
  bodies::make_periodic(setup);
  setup.time_step = dem::usual_step(setup);
  const dem::Measurement still = dem::make_engine(setup)->measure();
  double mass = 0, drift[3] = {0, 0, 0}, square = 0;
  for (size_t i = 0; i < setup.count(); i++) {
    mass += setup.masses[i];
    for (size_t k = 0; k < 3; k++) drift[k] += setup.masses[i] * setup.velocities[3 * i + k];
  }
  for (const double p : drift) square += p * p / mass;
  const double expected = (2 * still.translation - square) / 3, volume = std::pow(setup.box_max[0], 3);
  assert_true(is_near(still.bulk.temperature, expected / mass, 1e-12 * expected / mass));
  assert_true(is_near(still.bulk.pressure, expected / volume, 1e-12 * expected / volume));
  for (size_t i = 0; i < setup.count(); i++) setup.velocities[3 * i + 1] += 100;
  assert_true(is_near(dem::make_engine(setup)->measure().bulk.temperature, expected / mass, 1e-9));
}

void the_profile_of_shear_is_no_temperature(void **) {
  bodies::Gas gas;
  gas.temperature = 0;
  gas.effects = dem::kShear;
  dem::Setup setup = bodies::make_gas(gas, 7);
  bodies::make_periodic(setup);
  setup.shear_rate = 2;
  for (size_t i = 0; i < setup.count(); i++)
    setup.velocities[3 * i] += 2 * (setup.centers[3 * i + 1] - setup.box_max[1] / 2);
  setup.time_step = dem::usual_step(setup);
  assert_true(dem::make_engine(setup)->measure().bulk.temperature < 1e-24);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_pair_has_the_stress_of_its_branch),
      cmocka_unit_test(a_lattice_has_the_stress_of_its_springs),
      cmocka_unit_test(rattlers_leave_others_loose),
      cmocka_unit_test(a_pile_at_rest_has_the_stress_of_its_weight),
      cmocka_unit_test(motion_against_the_flow_is_temperature),
      cmocka_unit_test(the_profile_of_shear_is_no_temperature),
  };
  return cmocka_run_group_tests_name("bulk", tests, nullptr, nullptr);
}
