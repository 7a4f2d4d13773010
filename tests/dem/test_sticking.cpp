// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Oblique impacts whose contacts stick, wholly or for a while: where they stick throughout, against the closed form;
// in between, among them Chung & Ooi's tests 4 to 6 at small angles, against the equation of motion integrated here.
//
// A contact that sticks is a damped oscillator along the surface too. A tangential force changes the slip u of a ball
// by 7/2 of it per mass, so with k_t = q k, and c_t = q c of the dashpots, u'' + 2 h u' + w0^2 u = 0 with
// w0^2 = 7/2 q k / m, h = 7/2 q eta, of the normal motion eta = c / (2 m). With u = u0 at first touch,
// u(t_c) = u0 exp(-h t_c) (cos(w t_c) - h / w sin(w t_c)), w^2 = w0^2 - h^2. For q = 2/7 both motions are the same:
// u(t_c) = -e u0.
#include "programs/accuracy/simulation/oblique_impact.hpp"
#include "tests/dem/oblique.hpp"
#include "tests/support/frame.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace {

constexpr double kSteps = 1000;  // per contact
const double kNoSliding = 1e7;   // a coefficient of friction

using accuracy::Impact;
using accuracy::integrate;
using accuracy::Motion;

double slip_of(const Impact &impact) { return impact.tangential - impact.radius * impact.spin; }

// What a change of the slip by friction makes of the rest: the speed takes 2/7 of it, the surface's turning 5/7.
Motion with_slip(const Impact &impact, double restitution, double slip) {
  const double change = slip - slip_of(impact);
  return {restitution * impact.normal, impact.tangential + change * 2 / 7,
          impact.spin - change * 5 / (7 * impact.radius)};
}

// u(t_c) / u0 of a contact that sticks throughout, of normal restitution e and k_t / k = q.
double sticking_restitution(double e, double q) {
  const double log_e = std::log(e), eta = -log_e;  // times t_c
  const double normal_square = bodies::kPi * bodies::kPi + log_e * log_e;
  const double h = 3.5 * q * eta, w = std::sqrt(3.5 * q * normal_square - h * h);
  return std::exp(-h) * (std::cos(w) - h / w * std::sin(w));
}

bool is_near(const char *what, const Motion &found, const Motion &expected, const Impact &impact, double tolerance) {
  std::printf("%s: speed %.5f (%.5f), spin %.5f (%.5f)\n", what, found.tangential, expected.tangential, found.spin,
              expected.spin);
  const double scale = std::max(impact.normal, std::fabs(slip_of(impact)));
  return std::fabs(found.normal - expected.normal) < tolerance * scale &&
         std::fabs(found.tangential - expected.tangential) < tolerance * scale &&
         impact.radius * std::fabs(found.spin - expected.spin) < tolerance * scale;
}

// Stiff, so that the arm of the force is the radius within 1e-4.
constexpr double kStiffness = 1e8;

bool sticks_as_the_closed_form(double restitution, double ratio, double friction, const Impact &impact) {
  const dem::Setup law = oblique::rough_linear(kStiffness, ratio, restitution, friction);
  const Motion found = oblique::rebound_of(oblique::against_wall(law, impact), kSteps);
  const double slip = sticking_restitution(restitution, ratio) * slip_of(impact);
  char what[64];
  std::snprintf(what, sizeof what, "e = %g, k_t / k = %.3f", restitution, ratio);
  return is_near(what, found, with_slip(impact, restitution, slip), impact, 2e-3);
}

void without_sliding_the_rebound_is_an_oscillators(void **) {
  for (const double restitution : {1.0, 0.8, 0.5}) {
    for (const double ratio : {0.1, 2.0 / 7, 0.5, 0.8}) {
      assert_true(sticks_as_the_closed_form(restitution, ratio, kNoSliding, {1, 1, 1, 0.7, 0}));
      assert_true(sticks_as_the_closed_form(restitution, ratio, kNoSliding, {1, 1, 1, 0, 0.7}));
    }
  }
}

// Elastic, q = 2/7: both forces are sines of the same frequency, so the slider never gives way as long as
// q u0 < mu v: the closed form with an ordinary coefficient, up to the limit.
void below_the_limit_an_elastic_contact_sticks_throughout(void **) {
  for (const double slip : {0.1, 0.7, 1.38}) {
    assert_true(sticks_as_the_closed_form(1, 2.0 / 7, 0.4, {1, 1, 1, slip, 0}));
  }
}

// Beyond, and wherever the frequencies differ or there are dashpots, a contact slides for a part of the time. Friction
// turns the slip round at most: a spring that is wound up further than the surface moves would do more.
void between_sticking_and_sliding_the_equation_of_motion_holds(void **) {
  for (const double restitution : {1.0, 0.7}) {
    for (const double ratio : {2.0 / 7, 0.6}) {
      for (const double slip : {0.2, 0.8, 1.6, 2.4}) {
        const Impact impact{1, 1, 1, slip, 0};
        const dem::Setup law = oblique::rough_linear(kStiffness, ratio, restitution, 0.4);
        const dem::Setup setup = oblique::against_wall(law, impact);
        const Motion found = oblique::rebound_of(setup, kSteps);
        const Motion expected = integrate(setup, impact, dem::shortest_contact(setup).duration);
        char what[64];
        std::snprintf(what, sizeof what, "e = %g, k_t / k = %.3f, slip %g", restitution, ratio, slip);
        assert_true(is_near(what, found, expected, impact, 2e-3));
        assert_true(std::fabs(found.tangential - found.spin) < 1.002 * slip);
      }
    }
  }
}

bool hertz_follows_the_equation(const char *what, const dem::Setup &law, const Impact &impact) {
  const dem::Setup setup = oblique::against_wall(law, impact);
  const Motion expected = integrate(setup, impact, dem::shortest_contact(setup).duration);
  return is_near(what, oblique::rebound_of(setup, kSteps), expected, impact, 2e-3);
}

// Where chung_ooi_test_4_oblique_impact of test_friction.cpp does not slide throughout.
void chung_ooi_test_4_at_small_angles(void **) {
  for (const double degrees : {5.0, 10.0, 15.0, 20.0, 25.0, 30.0}) {
    const double angle = degrees * bodies::kPi / 180;
    char what[32];
    std::snprintf(what, sizeof what, "%g degrees", degrees);
    assert_true(hertz_follows_the_equation(
        what, oblique::rough_hertz(380e9, 0.23, 0.98, 0.092),
        {0.0025, bodies::ball_mass(0.0025, 4000), 3.9 * std::cos(angle), 3.9 * std::sin(angle), 0}));
  }
}

void chung_ooi_tests_5_and_6_at_small_slips(void **) {
  const dem::Setup law = oblique::rough_hertz(70e9, 0.33, 0.5, 0.4);
  const double mass = bodies::ball_mass(0.1, 2700);
  for (const double tangential : {0.2, 0.6, 1.0, 1.5}) {
    assert_true(hertz_follows_the_equation("test 5", law, {0.1, mass, 1, tangential, 0}));
  }
  for (const double spin : {0.175, 1.0, 2.0, 4.0}) {
    assert_true(hertz_follows_the_equation("test 6", law, {0.1, mass, 0.2, 0, spin}));
  }
}

// Two balls with equal spins, which stick: the slip 2 r w turns round to e of it.
void spinning_pairs_stick_as_the_closed_form(void **) {
  for (const double restitution : {1.0, 0.8}) {
    dem::Setup setup = oblique::rough_linear(kStiffness, 0.2, restitution, kNoSliding);
    bodies::add(setup, {0, 0, 0}, {0.5, 0, 0}, 1, 1, {0, 0, 0.4});
    bodies::add(setup, {2.001, 0, 0}, {-0.5, 0, 0}, 1, 1, {0, 0, 0.4});
    bodies::set_steps_per_contact(setup, kSteps);
    const dem::Snapshot after = bodies::follow_collision(setup, 40000).after;
    // Each takes half of the change of slip as a sphere on a wall does: 2/7 by its speed, 5/7 by its turning.
    const double change = (sticking_restitution(restitution, 0.2) - 1) * 0.8;
    const double speed = -change / 7, spin = 0.4 + change * 5 / 14;
    std::printf("pair: speeds %.5f %.5f (%.5f), spin %.5f (%.5f)\n", after.velocities[1], after.velocities[4], speed,
                after.spins[2], spin);
    const double worst = std::max(std::fabs(after.velocities[4] - speed), std::fabs(after.spins[2] - spin));
    assert_true(worst < 2e-3 && std::fabs(after.velocities[1] + after.velocities[4]) < 1e-12);
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(without_sliding_the_rebound_is_an_oscillators),
      cmocka_unit_test(below_the_limit_an_elastic_contact_sticks_throughout),
      cmocka_unit_test(between_sticking_and_sliding_the_equation_of_motion_holds),
      cmocka_unit_test(chung_ooi_test_4_at_small_angles),
      cmocka_unit_test(chung_ooi_tests_5_and_6_at_small_slips),
      cmocka_unit_test(spinning_pairs_stick_as_the_closed_form),
  };
  return cmocka_run_group_tests_name("sticking", tests, nullptr, nullptr);
}
