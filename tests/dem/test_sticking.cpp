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
#include "tests/dem/oblique.hpp"
#include "tests/support/frame.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace {

constexpr double kSteps = 1000;  // per contact
const double kNoSliding = 1e7;   // a coefficient of friction

using oblique::Impact;
using oblique::Motion;

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

// A contact with a wall at some overlap, from the material's numbers (docs/guide/simulation.md, What is computed).
struct Law {
  double normal, normal_damping;          // the spring's force, force per closing speed
  double tangential, tangential_damping;  // force per stretch and per its rate
};

Law law_at(const dem::Setup &setup, double mass, double radius, double overlap) {
  const dem::ContactParameters &p = setup.contact;
  const double log_e = std::log(p.restitution);
  const double loss = -log_e / std::sqrt(bodies::kPi * bodies::kPi + log_e * log_e);
  if (!dem::has(setup.effects, dem::kHertz)) {
    const double damping = 2 * loss * std::sqrt(mass * p.stiffness), q = p.tangential_stiffness;
    return {p.stiffness * overlap, damping, q * p.stiffness, q * damping};
  }
  // Against a rigid wall E* = E / (1 - nu^2), G* = E / (2 (1 + nu) (2 - nu)); k_t = 8 G* a, k = 2 E* a.
  const double nu = p.poisson_ratio, contact_radius = std::sqrt(radius * overlap);
  const double e_star = p.young_modulus / (1 - nu * nu), g_star = p.young_modulus / (2 * (1 + nu) * (2 - nu));
  const double root = std::sqrt(mass * 4 / 3 * e_star * std::sqrt(radius)) * std::pow(overlap, 0.25);
  const double damping = std::sqrt(5.0) * loss * root;
  return {4.0 / 3 * e_star * contact_radius * overlap, damping, 8 * g_star * contact_radius,
          4 * g_star / e_star * damping};
}

// How fast the spring along the surface stretches: with the surface as long as spring and dashpot bear no more than the
// slider does, else as fast as the rest of the limit drives the dashpot.
double stretching(const Law &law, double limit, double stretch, double slip) {
  const double sticking = law.tangential * stretch + law.tangential_damping * slip;
  if (std::fabs(sticking) <= limit) return slip;
  return (std::copysign(limit, sticking) - law.tangential * stretch) / law.tangential_damping;
}

// The same impact by many small steps of the equation of motion. Without a dashpot the spring bears the limit alone.
Motion integrate(const dem::Setup &setup, const Impact &impact, double duration) {
  const double h = duration / 400000, inertia = 0.4 * impact.mass * impact.radius * impact.radius;
  double closing = impact.normal, overlap = h * closing, v = impact.tangential, spin = impact.spin, stretch = 0;
  while (overlap > 0) {
    const Law law = law_at(setup, impact.mass, impact.radius, overlap);
    const double arm = impact.radius - overlap, slip = v - arm * spin, limit = setup.contact.friction * law.normal;
    double rate = 0;
    if (law.tangential_damping > 0) {
      rate = stretching(law, limit, stretch, slip);
      stretch += h * rate;
    } else {
      stretch = std::clamp(stretch + h * slip, -limit / law.tangential, limit / law.tangential);
    }
    const double force = -law.tangential * stretch - law.tangential_damping * rate;
    closing -= h * (law.normal + law.normal_damping * closing) / impact.mass;
    v += h * force / impact.mass;
    spin -= h * arm * force / inertia;
    overlap += h * closing;
  }
  return {-closing, v, spin};
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
