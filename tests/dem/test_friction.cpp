// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Friction, rotation and rolling resistance against closed forms, among them Chung & Ooi's tests 4 to 8 where contacts
// slide throughout.
//
// A sphere that hits with normal speed v and tangential slip u of its surface, sliding to the end, takes the tangential
// impulse mu (1 + e) v per mass against the slip: the speed falls by it, the spin by 5/2 of it over r.
#include "tests/dem/oblique.hpp"
#include "tests/support/frame.h"

#include <cstdio>

namespace {

constexpr double kSteps = 500;  // per contact

struct Rebound {
  double speed, spin;            // tangential, found
  double true_speed, true_spin;  // by the sliding formulas
  bool is_near(double scale) const {
    std::printf("speed %.6f (%.6f), spin %.5f (%.5f)\n", speed, true_speed, spin, true_spin);
    return std::fabs(speed - true_speed) < 2e-3 * scale && std::fabs(spin / true_spin - 1) < 5e-3;
  }
};

Rebound slide_along_wall(const dem::Setup &law, const oblique::Impact &impact) {
  const oblique::Motion after = oblique::rebound_of(oblique::against_wall(law, impact), kSteps);
  const double slip = impact.tangential - impact.radius * impact.spin > 0 ? 1 : -1;
  const double impulse = law.contact.friction * (1 + law.contact.restitution) * impact.normal;
  return {after.tangential, after.spin, impact.tangential - slip * impulse,
          impact.spin + slip * 2.5 * impulse / impact.radius};
}

void chung_ooi_test_4_oblique_impact(void **) {
  // Alumina at 3.9 m/s. Beyond tan(angle) = 7/2 mu (1 + e), 33 degrees, the contact slides throughout.
  for (const double degrees : {40.0, 60.0, 80.0}) {
    const double angle = degrees * bodies::kPi / 180;
    const oblique::Impact impact{0.0025, bodies::ball_mass(0.0025, 4000), 3.9 * std::cos(angle), 3.9 * std::sin(angle),
                                 0};
    assert_true(slide_along_wall(oblique::rough_hertz(380e9, 0.23, 0.98, 0.092), impact).is_near(3.9));
  }
}

void chung_ooi_test_5_fast_tangential_impact(void **) {
  for (const double tangential : {3.0, 5.0, 10.0}) {
    const oblique::Impact impact{0.1, bodies::ball_mass(0.1, 2700), 1, tangential, 0};
    assert_true(slide_along_wall(oblique::rough_hertz(70e9, 0.33, 0.5, 0.4), impact).is_near(1));
  }
}

void chung_ooi_test_6_spinning_impact(void **) {
  for (const double spin : {10.0, 22.0}) {
    const oblique::Impact impact{0.1, bodies::ball_mass(0.1, 2700), 0.2, 0, spin};
    assert_true(slide_along_wall(oblique::rough_hertz(70e9, 0.33, 0.5, 0.4), impact).is_near(0.2));
  }
}

// Test 7: equal spheres, equal spins: the surfaces slip with 2 r w. Test 8: the second is far larger.
Rebound spinning_pair(double radius_b, double spin_b, double young, double poisson, double density) {
  dem::Setup setup = oblique::rough_hertz(young, poisson, 0.5, 0.4);
  const double r = 0.1, v = 0.2, spin = 10;
  const double mass_a = bodies::ball_mass(r, density), mass_b = bodies::ball_mass(radius_b, density);
  bodies::add(setup, {0, 0, 0}, {v, 0, 0}, r, mass_a, {0, 0, spin});
  bodies::add(setup, {1.0005 * (r + radius_b), 0, 0}, {radius_b > r ? 0 : -v, 0, 0}, radius_b, mass_b, {0, 0, spin_b});
  bodies::set_steps_per_contact(setup, kSteps);
  const dem::Snapshot after = bodies::follow_collision(setup, static_cast<size_t>(40 * kSteps)).after;
  const double closing = radius_b > r ? v : 2 * v;
  const double impulse = 0.4 * 1.5 * closing * mass_b / (mass_a + mass_b);  // per mass of a
  return {after.velocities[1], after.spins[2], -impulse, spin - 2.5 * impulse / r};
}

void chung_ooi_test_7_equal_spheres(void **) {
  assert_true(spinning_pair(0.1, 10, 70e9, 0.33, 2700).is_near(0.2));
  assert_true(spinning_pair(0.1, 10, 120e9, 0.35, 8900).is_near(0.2));
}

void chung_ooi_test_8_unequal_spheres(void **) {
  assert_true(spinning_pair(1.0, 0, 70e9, 0.33, 2700).is_near(0.2));
  assert_true(spinning_pair(1.0, 0, 120e9, 0.35, 8900).is_near(0.2));
}

// Opposite spins of equal spheres do not slip: nothing tangential happens.
void opposite_spins_roll_off(void **) {
  dem::Setup setup = oblique::rough_hertz(70e9, 0.33, 0.5, 0.4);
  const double mass = bodies::ball_mass(0.1, 2700);
  bodies::add(setup, {0, 0, 0}, {0.2, 0, 0}, 0.1, mass, {0, 0, 10});
  bodies::add(setup, {0.2001, 0, 0}, {-0.2, 0, 0}, 0.1, mass, {0, 0, -10});
  bodies::set_steps_per_contact(setup, kSteps);
  const dem::Snapshot after = bodies::follow_collision(setup, 20000).after;
  const double speed = after.velocities[1], spin = after.spins[2];
  assert_true(std::fabs(speed) < 1e-12 && std::fabs(spin - 10) < 1e-10);
}

// A rough plane z = 0 under gravity that is tilted by the angle in the x z plane.
dem::Setup slope(int dimension, double angle, dem::EffectSet effects) {
  dem::Setup setup;
  setup.dimension = dimension;
  setup.effects = effects | dem::kFriction | dem::kGravity | dem::kDissipation;
  bodies::set_linear(setup, 1e5, 0.3);
  setup.contact.friction = 0.5;
  setup.contact.tangential_stiffness = 2.0 / 7;
  const int up = dimension - 1;
  setup.gravity[0] = 10 * std::sin(angle);
  setup.gravity[up] = -10 * std::cos(angle);
  bodies::set_walls(setup, up, 0, 100);
  return setup;
}

// Speed along x of a ball (disc) of radius and mass 1 after a time, set on the plane as deep as its weight presses it.
double speed_after(dem::Setup setup, double speed, double spin, double time) {
  std::vector<double> center(static_cast<size_t>(setup.dimension), 0.0), velocity = center;
  center.back() = 1 + setup.gravity[setup.dimension - 1] / setup.contact.stiffness;
  velocity[0] = speed;
  bodies::add(setup, center, velocity, 1, 1,
              setup.dimension == 3 ? std::vector<double>{0, spin, 0} : std::vector<double>{-spin});
  bodies::set_steps_per_contact(setup, 20);
  const auto engine = dem::make_engine(setup);
  engine->run(static_cast<uint64_t>(time / setup.time_step));
  return engine->snapshot().velocities[0] * time / engine->time();
}

// Rolling without slip: a = g sin / (1 + I / m r^2); with slip: a = g (sin - mu cos).
void balls_and_discs_roll_down_a_slope(void **) {
  const double gentle = 0.2, steep = 1.2;
  const double ball = speed_after(slope(3, gentle, 0), 0, 0, 2), disc = speed_after(slope(2, gentle, 0), 0, 0, 2);
  const double sliding = speed_after(slope(3, steep, 0), 0, 0, 2);
  std::printf("ball %.5f, disc %.5f, sliding %.5f\n", ball, disc, sliding);
  assert_true(std::fabs(ball / (20 * std::sin(gentle) * 5 / 7) - 1) < 2e-3);
  assert_true(std::fabs(disc / (20 * std::sin(gentle) * 2 / 3) - 1) < 2e-3);
  assert_true(std::fabs(sliding / (20 * (std::sin(steep) - 0.5 * std::cos(steep))) - 1) < 2e-3);
}

// A sliding ball ends rolling at 5/7 of its speed, a disc at 2/3.
void sliding_turns_into_rolling(void **) {
  const double ball = speed_after(slope(3, 0, 0), 1, 0, 1), disc = speed_after(slope(2, 0, 0), 1, 0, 1);
  std::printf("ball %.5f, disc %.5f\n", ball, disc);
  assert_true(std::fabs(ball - 5.0 / 7) < 2e-3);
  assert_true(std::fabs(disc - 2.0 / 3) < 2e-3);
}

// A rolling ball slows down by mu_r g / (1 + 2/5): the torque mu_r r N acts on m r^2 (1 + 2/5).
void rolling_resistance_stops_a_ball(void **) {
  dem::Setup setup = slope(3, 0, dem::kRolling);
  setup.contact.rolling_friction = 0.02;
  setup.contact.rolling_stiffness = 2.0 / 7;
  const double moving = speed_after(setup, 1, 1, 2), stopped = speed_after(setup, 1, 1, 12);
  std::printf("after 2: %.5f (%.5f), after 12: %.2g\n", moving, 1 - 2 * 0.2 * 5 / 7, stopped);
  assert_true(std::fabs(moving - (1 - 2 * 0.2 * 5 / 7)) < 5e-3);
  assert_true(std::fabs(stopped) < 1e-4);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(chung_ooi_test_4_oblique_impact),   cmocka_unit_test(chung_ooi_test_5_fast_tangential_impact),
      cmocka_unit_test(chung_ooi_test_6_spinning_impact),  cmocka_unit_test(chung_ooi_test_7_equal_spheres),
      cmocka_unit_test(chung_ooi_test_8_unequal_spheres),  cmocka_unit_test(opposite_spins_roll_off),
      cmocka_unit_test(balls_and_discs_roll_down_a_slope), cmocka_unit_test(sliding_turns_into_rolling),
      cmocka_unit_test(rolling_resistance_stops_a_ball),
  };
  return cmocka_run_group_tests_name("friction", tests, nullptr, nullptr);
}
