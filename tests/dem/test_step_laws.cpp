// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Errors of single collisions against the steps per contact: measured ones follow the derived laws.
#include "programs/accuracy/report/convergence_table.hpp"
#include "programs/accuracy/simulation/collision_laws.hpp"
#include "programs/accuracy/simulation/contact_onset.hpp"
#include "programs/accuracy/simulation/error_curves.hpp"
#include "programs/accuracy/simulation/single_collision.hpp"
#include "tests/support/frame.h"

#include <cmath>
#include <cstdio>

namespace {

constexpr double kPi = 3.14159265358979323846;

bool is_near(double value, double expected, double tolerance) {
  if (std::fabs(value - expected) <= tolerance) return true;
  std::printf("%.10g is not within %g of %.10g\n", value, tolerance, expected);
  return false;
}

// Figures from elsewhere: sampled over many moments by a program that knows nothing of these formulas, and textbook
// integrals.
void laws_have_known_factors(void **) {
  const dem::Scheme verlet = dem::velocity_verlet();
  assert_true(is_near(accuracy::onset_energy(verlet).mean, 1.0 / 6, 1e-6));
  assert_true(is_near(accuracy::onset_energy(verlet).variance, 1.0 / 180, 1e-6));
  assert_true(is_near(accuracy::elastic_restitution_law(verlet).factor, 1.17, 0.005));
  assert_true(is_near(accuracy::elastic_duration_law(verlet).factor, 0.411, 0.0005));
  assert_true(is_near(accuracy::damped_restitution_law(0.527).factor, 0.33, 0.005));
  const double x = kPi / 20;
  assert_true(is_near(accuracy::half_swing(verlet, 10), x / std::asin(x), 1e-14));
}

bool follows(const dem::Scheme &scheme, const accuracy::ErrorCurve &curve) {
  const accuracy::PowerLaw expected = accuracy::expected_law(scheme, curve.error_of);
  const accuracy::PowerLaw found = accuracy::fitted_law(curve.steps, curve.errors);
  std::printf("%s, %s: %.3g n^-%.3f (%.3g n^-%g)\n", scheme.name.c_str(), curve.error_of.c_str(), found.factor,
              found.order, expected.factor, expected.order);
  if (!is_near(found.order, expected.order, accuracy::kOrderTolerance)) return false;
  // The last errors are nearest to the leading order.
  return expected.factor == 0 || is_near(curve.errors.back() / expected.at(curve.steps.back()), 1, 0.05);
}

void collisions_follow_the_derived_laws(void **) {
  for (const dem::Scheme &scheme :
       {dem::velocity_verlet(), dem::symplectic_euler(), dem::leapfrog(), dem::forest_ruth()}) {
    const auto curves = accuracy::collision_curves(scheme, {20, 28, 40, 56, 80, 112, 160});
    const bool is_usual = scheme.name == dem::Setup().scheme.name;
    assert_int_equal(curves.size(), is_usual ? 12 : scheme.stages.size() == 1 ? 7 : 4);
    for (const accuracy::ErrorCurve &curve : curves) assert_true(follows(scheme, curve));
  }
}

// At n = 10, far from any limit.
void durations_are_exact_inside_the_contact(void **) {
  for (const dem::Scheme &scheme : {dem::velocity_verlet(), dem::symplectic_euler(), dem::leapfrog()}) {
    accuracy::CollisionCase what;
    what.scheme = scheme;
    what.steps = 10;
    const accuracy::CollisionErrors errors = accuracy::collide(what);
    assert_true(is_near(errors.duration.mean, accuracy::half_swing(scheme, 10) - 1, 1e-4));
    // Elastic collisions err to both sides alike.
    assert_true(std::fabs(errors.restitution.mean) < 0.05 * errors.restitution.rms);
  }
}

void a_late_dashpot_takes_too_much(void **) {
  accuracy::CollisionCase what;
  what.steps = 160;
  what.restitution = 0.527;
  assert_true(is_near(accuracy::collide(what).restitution.mean * what.steps, -0.11, 0.005));
}

// The state in float can follow a collision to about ulp(1) over the overlap, not further.
void float_collisions_stop_getting_better(void **) {
  accuracy::CollisionCase what;
  what.steps = 320;
  const double in_double = accuracy::collide(what).restitution.rms;
  what.precision = dem::Precision::kFloat;
  const double in_float = accuracy::collide(what).restitution.rms;
  std::printf("restitution, n = 320: %.3g in double, %.3g in float\n", in_double, in_float);
  assert_true(in_float > 100 * in_double);
  assert_true(in_float < 5e-4);
}

std::string table_of_order(double order) {
  std::vector<accuracy::Point> points;
  for (const double n : {20.0, 50.0, 100.0}) {
    accuracy::Point point{"step", "velocity-verlet", "n", "duration", std::pow(n, -order), n, false, "", n};
    points.push_back(point);
  }
  return accuracy::convergence_table(points, accuracy::Style::kText);
}

void the_table_tells_wrong_orders_from_right_ones(void **) {
  assert_true(table_of_order(2.1).find("agrees") != std::string::npos);
  assert_true(table_of_order(2.2).find("differs") != std::string::npos);
  assert_true(table_of_order(1.8).find("differs") != std::string::npos);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(laws_have_known_factors),
                              cmocka_unit_test(collisions_follow_the_derived_laws),
                              cmocka_unit_test(durations_are_exact_inside_the_contact),
                              cmocka_unit_test(a_late_dashpot_takes_too_much),
                              cmocka_unit_test(float_collisions_stop_getting_better),
                              cmocka_unit_test(the_table_tells_wrong_orders_from_right_ones)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
