// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What a run is warned of: absurd starts, steps that cannot be stable, energy from nowhere; and sound runs are not.
#include "dem/engine/watch.hpp"
#include "tests/dem/gas.hpp"
#include "tests/support/frame.h"

#include <cstdio>

namespace {

// All warnings of a run of `looks` looks, `steps` steps apart, in one text.
std::string warnings_of(const dem::Setup &setup, int looks, uint64_t steps) {
  const auto engine = dem::make_engine(setup);
  dem::Watch watch(setup);
  std::string all;
  for (int look = 0; look <= looks; look++) {
    for (const std::string &warning : watch.look(engine->steps_done(), engine->measure())) {
      all += std::to_string(engine->steps_done()) + ": " + warning + "\n";
    }
    if (look < looks) engine->run(steps);
  }
  std::printf("%s%s\n", all.c_str(), watch.summary().c_str());
  assert_true(watch.has_warned() == !all.empty());
  return all;
}

bool holds(const std::string &text, const char *part) { return text.find(part) != std::string::npos; }

dem::Setup pair_of(double distance) {
  dem::Setup setup;
  bodies::set_linear(setup, 1e4);
  bodies::add(setup, {0, 0, 0}, {0, 0, 0}, 1, 1);
  bodies::add(setup, {distance, 0, 0}, {0, 0, 0}, 1, 1);
  bodies::set_steps_per_contact(setup, 50);
  return setup;
}

void deep_starts_are_seen_at_once(void **) {
  assert_true(holds(warnings_of(pair_of(1.5), 0, 0), "0: surfaces overlap by 0.5 of the smaller radius"));
  assert_true(warnings_of(pair_of(1.95), 3, 100).empty());
  dem::Setup setup = pair_of(2.5);
  setup.velocities[0] = 100;  // they meet later, and go deep
  assert_true(holds(warnings_of(setup, 30, 10), ": surfaces overlap by"));
}

void centres_behind_walls_are_seen(void **) {
  dem::Setup setup = pair_of(5);
  bodies::set_walls(setup, 2, 0.5, 10);
  assert_true(holds(warnings_of(setup, 0, 0), "centres of particles lie behind walls: 2"));
}

void planes_that_swing_are_seen(void **) {
  dem::Setup setup = pair_of(2);
  dem::WallBody piston;
  piston.point[0] = 3;
  piston.normal[0] = -1;
  piston.force = 10;
  setup.effects |= dem::kSurfaces;
  bodies::set_walls(setup, 0, -1, 100);
  piston.fastest = 3 * piston.force / (1e4 * setup.time_step);
  setup.walls = {piston};
  assert_true(holds(warnings_of(setup, 100, 1), "a plane that presses swings without end: its speed is 1.5 times"));
  setup.walls[0].fastest /= 3;
  assert_true(!holds(warnings_of(setup, 100, 1), "swings"));
}

void crowds_are_seen(void **) {
  dem::Setup setup;
  bodies::set_linear(setup, 1e4, 0.001);
  packing::Random random(7);
  for (int n = 0; n < 100; n++) bodies::add(setup, {random.normal(), 0, 0.1 * random.normal()}, {0, 0, 0}, 5, 1);
  setup.time_step = dem::usual_step(setup);
  assert_true(holds(warnings_of(setup, 0, 0), "may make the time step unstable"));
}

// More than a hundredth of what was in motion and in contacts, where nothing puts energy in.
void energy_from_nowhere_is_seen(void **) {
  dem::Setup setup = pair_of(2.5);
  dem::Watch watch(setup);
  dem::Measurement m;
  m.translation = 1;
  assert_true(watch.look(0, m).empty());
  m.translation = 0.5;
  m.contact = 0.5049;
  assert_true(watch.look(1, m).empty());
  m.contact = 0.52;
  const std::vector<std::string> warnings = watch.look(2, m);
  assert_int_equal(warnings.size(), 1);
  assert_true(holds(warnings.front(), "the energy has risen by"));
  assert_true(watch.look(3, m).empty());  // once is enough
  setup.effects |= dem::kGrowth;
  dem::Watch lenient(setup);
  m.translation = 0;
  assert_true(lenient.look(0, m).empty());
  m.translation = 9;
  m.contact = 0;
  assert_true(lenient.look(1, m).empty());
}

void sound_runs_are_not_warned_of(void **) {
  bodies::Gas gas;
  gas.edge = 5;
  gas.temperature = 0.1;
  dem::Setup setup = bodies::make_gas(gas, 3);
  bodies::wall_in(setup);
  bodies::set_steps_per_contact(setup, 50);
  assert_true(warnings_of(setup, 20, 200).empty());
  dem::Setup ball;
  ball.effects = dem::kGravity;
  bodies::set_linear(ball, 1e6, 0.8);
  ball.gravity[2] = -10;
  bodies::set_walls(ball, 2, 0, 100);
  bodies::add(ball, {0, 0, 2}, {0, 0, 0}, 1, 1);
  bodies::set_steps_per_contact(ball, 50);
  assert_true(warnings_of(ball, 100, 400).empty());
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(deep_starts_are_seen_at_once), cmocka_unit_test(centres_behind_walls_are_seen),
      cmocka_unit_test(planes_that_swing_are_seen),   cmocka_unit_test(crowds_are_seen),
      cmocka_unit_test(energy_from_nowhere_is_seen),  cmocka_unit_test(sound_runs_are_not_warned_of),
  };
  return cmocka_run_group_tests_name("watch", tests, nullptr, nullptr);
}
