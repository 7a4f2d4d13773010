// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Single collisions against closed forms: linear springs with dashpots, and Hertz contacts.
#include "tests/dem/bodies.hpp"
#include "tests/support/frame.h"

#include <cstdio>

namespace {

struct Result {
  double restitution, duration, overlap;                 // found
  double true_restitution, true_duration, true_overlap;  // by theory

  bool is_near(double tolerance, double time_tolerance) const {
    const double errors[] = {restitution - true_restitution, duration / true_duration - 1, overlap / true_overlap - 1};
    std::printf("restitution %.6f (%.6f), duration %.6g (%.6g), overlap %.6g (%.6g)\n", restitution, true_restitution,
                duration, true_duration, overlap, true_overlap);
    return std::fabs(errors[0]) < tolerance && std::fabs(errors[1]) < time_tolerance &&
           std::fabs(errors[2]) < tolerance;
  }
};

constexpr double kSteps = 1000;  // per contact

// Relative normal speed along x of bodies 0 and 1, or of body 0 alone.
double closing_speed(const dem::Snapshot &state) {
  const auto d = static_cast<size_t>(state.dimension);
  return state.velocities[0] - (state.radii.size() > 1 ? state.velocities[d] : 0.0);
}

Result collide(const dem::Setup &setup) {
  const bodies::Collision collision = bodies::follow_collision(setup, static_cast<size_t>(20 * kSteps));
  Result result{};
  result.restitution = -closing_speed(collision.after) / closing_speed(collision.before);
  result.duration = collision.duration;
  result.overlap = collision.largest_overlap;
  return result;
}

// omega_0 = sqrt(k / mu), eta = -ln e / t_c, t_c = pi / sqrt(omega_0^2 - eta^2); the damped oscillator is deepest at
// phase atan(w / eta).
void set_linear_theory(const dem::Setup &setup, double mass, double speed, Result &result) {
  const double e = setup.contact.restitution, log_e = std::log(e);
  const double natural = std::sqrt(setup.contact.stiffness / mass);
  const double damping = natural * -log_e / std::sqrt(bodies::kPi * bodies::kPi + log_e * log_e);
  const double frequency = std::sqrt(natural * natural - damping * damping);
  result.true_restitution = e;
  result.true_duration = bodies::kPi / frequency;
  const double phase = damping > 0 ? damping / frequency * std::atan(frequency / damping) : 0;
  result.true_overlap = speed / natural * std::exp(-phase);
}

Result two_linear_spheres(int dimension, double restitution) {
  dem::Setup setup;
  setup.dimension = dimension;
  bodies::set_linear(setup, 1e5, restitution);
  std::vector<double> left(static_cast<size_t>(dimension), 0.0), right = left, fast = left, slow = left;
  right[0] = 3.02;
  fast[0] = 2;
  slow[0] = -1;
  bodies::add(setup, left, fast, 1, 1);
  bodies::add(setup, right, slow, 2, 3);
  bodies::set_steps_per_contact(setup, kSteps);
  Result result = collide(setup);
  set_linear_theory(setup, 0.75, 3, result);
  return result;
}

Result linear_sphere_on_wall(double restitution) {
  dem::Setup setup;
  bodies::set_linear(setup, 1e5, restitution);
  bodies::set_walls(setup, 0, -2, 1.02);
  bodies::add(setup, {0, 0, 0}, {2, 0, 0}, 1, 4);
  bodies::set_steps_per_contact(setup, kSteps);
  Result result = collide(setup);
  set_linear_theory(setup, 4, 2, result);
  return result;
}

// d_max = (15 mu v^2 / (16 E* sqrt(R*)))^(2/5), t_c = 2.943275 d_max / v without dissipation.
void set_hertz_theory(double mass, double modulus, double radius, double speed, Result &result) {
  result.true_restitution = 1;
  result.true_overlap = std::pow(15 * mass * speed * speed / (16 * modulus * std::sqrt(radius)), 0.4);
  result.true_duration = 2.943275 * result.true_overlap / speed;
}

dem::Setup hertz(double young, double poisson, double restitution) {
  dem::Setup setup;
  setup.effects = dem::kHertz;
  setup.contact.young_modulus = young;
  setup.contact.poisson_ratio = poisson;
  setup.contact.restitution = restitution;
  if (restitution < 1) setup.effects |= dem::kDissipation;
  return setup;
}

// Chung & Ooi, test 1: two equal spheres, r = 10 mm, 10 m/s each.
Result chung_ooi_1(double young, double poisson, double density) {
  dem::Setup setup = hertz(young, poisson, 1);
  const double mass = bodies::ball_mass(0.01, density);
  bodies::add(setup, {0, 0, 0}, {10, 0, 0}, 0.01, mass);
  bodies::add(setup, {0.0201, 0, 0}, {-10, 0, 0}, 0.01, mass);
  bodies::set_steps_per_contact(setup, kSteps);
  Result result = collide(setup);
  set_hertz_theory(mass / 2, young / (1 - poisson * poisson) / 2, 0.005, 20, result);
  return result;
}

// Tests 2 and 3: a sphere on a rigid plane.
Result on_rigid_plane(double young, double poisson, double density, double radius, double speed, double restitution) {
  dem::Setup setup = hertz(young, poisson, restitution);
  const double mass = bodies::ball_mass(radius, density);
  bodies::set_walls(setup, 0, -10 * radius, 1.001 * radius);
  bodies::add(setup, {0, 0, 0}, {speed, 0, 0}, radius, mass);
  bodies::set_steps_per_contact(setup, kSteps);
  Result result = collide(setup);
  set_hertz_theory(mass, young / (1 - poisson * poisson), radius, speed, result);
  result.true_restitution = restitution;
  if (restitution < 1) {  // duration and overlap have no closed form then
    result.true_duration = result.duration;
    result.true_overlap = result.overlap;
  }
  return result;
}

bool agrees_with_print(const Result &found, double overlap, double duration) {
  // The paper's numbers come with six figures.
  return std::fabs(found.true_overlap / overlap - 1) < 2e-5 && std::fabs(found.true_duration / duration - 1) < 2e-5;
}

void linear_spheres_collide_as_an_oscillator(void **) {
  for (const int dimension : {2, 3}) {
    for (const double e : {1.0, 0.9, 0.5, 0.1}) {
      // The dashpot makes the force jump at first touch, which costs first order: 1 / steps.
      assert_true(two_linear_spheres(dimension, e).is_near(e == 1 ? 1e-5 : 5e-3, 3e-3));
    }
  }
}

void linear_sphere_meets_wall_with_its_own_mass(void **) {
  assert_true(linear_sphere_on_wall(1).is_near(1e-5, 3e-3));
  assert_true(linear_sphere_on_wall(0.6).is_near(5e-3, 3e-3));
}

void chung_ooi_test_1(void **) {
  const Result glass = chung_ooi_1(48e9, 0.2, 2800), limestone = chung_ooi_1(20e9, 0.25, 2500);
  assert_true(glass.is_near(1e-4, 3e-3));
  assert_true(limestone.is_near(1e-4, 3e-3));
  assert_true(agrees_with_print(glass, 274.113e-6, 40.3395e-6));
  assert_true(agrees_with_print(limestone, 368.304e-6, 54.2010e-6));
}

void chung_ooi_test_2(void **) {
  const Result aluminium = on_rigid_plane(70e9, 0.30, 2699, 0.1, 0.2, 1);
  const Result magnesium = on_rigid_plane(40e9, 0.35, 1800, 0.1, 0.2, 1);
  assert_true(aluminium.is_near(1e-4, 3e-3));
  assert_true(magnesium.is_near(1e-4, 3e-3));
  assert_true(agrees_with_print(aluminium, 49.7172e-6, 731.657e-6));
  assert_true(agrees_with_print(magnesium, 52.1233e-6, 767.066e-6));
}

void chung_ooi_test_3(void **) {
  for (const double e : {0.2, 0.4, 0.6, 0.8, 1.0}) {
    const Result alumina = on_rigid_plane(380e9, 0.23, 4000, 0.0025, 3.9, e);
    const Result iron = on_rigid_plane(100e9, 0.25, 7000, 0.0025, 3.9, e);
    assert_true(alumina.is_near(5e-3, 3e-3));
    assert_true(iron.is_near(5e-3, 3e-3));
    if (e < 1) continue;
    assert_true(agrees_with_print(alumina, 8.08881e-6, 6.10451e-6));
    assert_true(agrees_with_print(iron, 17.1887e-6, 12.9721e-6));
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(linear_spheres_collide_as_an_oscillator),
      cmocka_unit_test(linear_sphere_meets_wall_with_its_own_mass),
      cmocka_unit_test(chung_ooi_test_1),
      cmocka_unit_test(chung_ooi_test_2),
      cmocka_unit_test(chung_ooi_test_3),
  };
  return cmocka_run_group_tests_name("collision", tests, nullptr, nullptr);
}
