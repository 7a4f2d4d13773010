// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Contacts that get shorter with speed, Hertz ones and the range of adhesion: the step is short enough for what the
// energy at the start can do, or the run stops and says so.
#include "tests/dem/bodies.hpp"
#include "tests/support/frame.h"
#include "tests/support/refusal.hpp"

#include <algorithm>
#include <cstdio>

namespace {

// A ball of 10 mm above a floor, falling as good as from rest.
dem::Setup dropped_ball(double height, double restitution, double speed) {
  dem::Setup setup;
  setup.effects = dem::kHertz | dem::kGravity;
  if (restitution < 1) setup.effects |= dem::kDissipation;
  setup.contact.young_modulus = 1e9;
  setup.contact.poisson_ratio = 0.3;
  setup.contact.restitution = restitution;
  setup.gravity[2] = -9.81;
  bodies::set_walls(setup, 2, 0, 2 * (height + 0.02));
  bodies::add(setup, {0, 0, 0.01 + height}, {0, 0, -speed}, 0.01, bodies::ball_mass(0.01, 2500));
  return setup;
}

struct Bounce {
  double energy_error = 0;  // the largest, over that of the fall; without losses
  double height = 0;        // that the ball comes to after the bounce, over that of the fall
};

Bounce bounce(const dem::Setup &setup, double height) {
  const auto engine = dem::make_engine(setup);
  const double floor = 0.01 * setup.masses[0] * 9.81, start = engine->measure().energy() - floor;
  Bounce result;
  bool rises = false;
  while (true) {
    engine->run(1);
    const dem::Measurement m = engine->measure();
    result.energy_error = std::max(result.energy_error, std::fabs((m.energy() - floor) / start - 1));
    const dem::Snapshot state = engine->snapshot();
    rises = rises || state.velocities[2] > 0;
    if (!rises || m.wall_contacts > 0) continue;
    const double v = state.velocities[2];
    result.height = (state.centers[2] - 0.01 + v * v / (2 * 9.81)) / height;
    return result;
  }
}

void balls_fall_from_any_height(void **) {
  for (const double height : {1e-3, 0.03, 1.0, 10.0}) {
    for (const double speed : {0.0, 1e-9, 1e-3}) {
      dem::Setup setup = dropped_ball(height, 1, speed);
      setup.time_step = dem::usual_step(setup);
      const Bounce elastic = bounce(setup, height);
      setup = dropped_ball(height, 0.8, speed);
      setup.time_step = dem::usual_step(setup);
      const Bounce lossy = bounce(setup, height);
      std::printf("from %g m with %g m/s: energy within %.3g, e = 0.8: %.4f (0.64)\n", height, speed,
                  elastic.energy_error, lossy.height);
      assert_true(elastic.energy_error < 5e-3 && std::fabs(elastic.height - 1) < 5e-3);
      assert_true(std::fabs(lossy.height - 0.64) < 0.01);
    }
  }
}

// Whatever speed the step is reckoned for, the bounce is right or the run stops.
void wrong_speeds_stop_the_run(void **) {
  int stopped = 0;
  for (double speed = 1e-8; speed < 100; speed *= 10) {
    dem::Setup setup = dropped_ball(1, 1, 1e-9);
    setup.impact_speed = speed;
    setup.time_step = dem::usual_step(setup);
    Bounce found;
    const std::string error = test::error_of([&] { found = bounce(setup, 1); });
    if (error.empty()) {
      std::printf("reckoned for %g m/s: energy within %.3g\n", speed, found.energy_error);
      assert_true(found.energy_error < 0.02);
    } else {
      std::printf("reckoned for %g m/s: %s\n", speed, error.c_str());
      assert_true(error.find("give an impact_speed of ") != std::string::npos && error.find("at step ") == 0);
      stopped++;
    }
  }
  assert_true(stopped >= 5);
}

// Two that meet with a speed, of a force and range of adhesion.
dem::Setup sticky_pair(double force, double range, double speed) {
  dem::Setup setup;
  setup.effects = dem::kAdhesion;
  bodies::set_linear(setup, 1e4);
  setup.contact.adhesion_force = force;
  setup.contact.adhesion_range = range;
  bodies::add(setup, {0, 0, 0}, {speed, 0, 0}, 1, 1);
  bodies::add(setup, {2 + 1.01 * range, 0, 0}, {0, 0, 0}, 1, 1);
  return setup;
}

// The largest change of the energy over what adhesion and motion have, until both have met and parted or a while is
// over.
double energy_error_of(const dem::Setup &setup) {
  const auto engine = dem::make_engine(setup);
  const double start = engine->measure().energy();
  const dem::ContactParameters &p = setup.contact;
  const double scale = start + p.adhesion_force * (p.adhesion_range / 2 + p.adhesion_force / (2 * p.stiffness));
  const double while_s = 10 * dem::shortest_contact(setup).duration + 2 * p.adhesion_range / setup.velocities[0];
  double worst = 0;
  while (engine->time() < while_s) {
    engine->run(1);
    worst = std::max(worst, std::fabs(engine->measure().energy() - start) / scale);
  }
  return worst;
}

void adhesion_keeps_energy_at_any_range(void **) {
  for (const double force : {1.0, 100.0, 1000.0}) {
    for (const double range : {1e-4, 1e-3, 1e-1}) {
      for (const double speed : {0.1, 3.0}) {
        dem::Setup setup = sticky_pair(force, range, speed);
        setup.time_step = dem::usual_step(setup);
        const double error = energy_error_of(setup);
        std::printf("F %g, h %g, v %g: step %.3g, energy within %.3g\n", force, range, speed, setup.time_step, error);
        assert_true(error < 5e-3);
      }
    }
  }
}

void steps_too_long_for_the_range_are_refused(void **) {
  dem::Setup setup = sticky_pair(1000, 1e-4, 1);
  setup.time_step = dem::shortest_contact(setup).duration / 50;
  assert_true(test::is_refused("surfaces cross the range of adhesion within", [&] { dem::make_engine(setup); }));
  setup = sticky_pair(1, 1e-3, 5);
  setup.impact_speed = 0.01;
  setup.time_step = dem::usual_step(setup);
  assert_true(test::is_refused("give an impact_speed", [&] { dem::make_engine(setup)->run(1); }));
}

// Adhesion that is never met, and Hertz contacts, may be looked at as often as one likes: nothing else changes.
void looking_changes_nothing(void **) {
  dem::Setup setup = dropped_ball(0.03, 0.8, 0);
  setup.time_step = dem::usual_step(setup);
  const auto one = dem::make_engine(setup), other = dem::make_engine(setup);
  one->run(1000);
  for (int k = 0; k < 1000; k++) other->run(1);
  assert_true(one->snapshot().centers == other->snapshot().centers);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(balls_fall_from_any_height),
      cmocka_unit_test(wrong_speeds_stop_the_run),
      cmocka_unit_test(adhesion_keeps_energy_at_any_range),
      cmocka_unit_test(steps_too_long_for_the_range_are_refused),
      cmocka_unit_test(looking_changes_nothing),
  };
  return cmocka_run_group_tests_name("speeds", tests, nullptr, nullptr);
}
