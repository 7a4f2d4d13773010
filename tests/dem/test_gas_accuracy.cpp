// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Gases: energy against time steps as kinetic theory has it, the state in float, the skin.
#include "dem/setup/time_step.hpp"
#include "programs/accuracy/simulation/gas_energy.hpp"
#include "programs/accuracy/simulation/state_errors.hpp"
#include "programs/accuracy/simulation/studies.hpp"
#include "tests/support/frame.h"

#include <cmath>
#include <cstdio>

namespace {

accuracy::EnergyCase energy_case(const dem::Scheme &scheme, double steps, dem::Precision precision) {
  accuracy::EnergyCase what;
  what.gas.mass_spread = 0.3;
  what.gas.edge = 4;
  what.contacts_per_span = 10;
  what.spans = 300;
  what.scheme = scheme;
  what.steps = steps;
  what.precision = precision;
  return what;
}

// 300 spans: the rms of each run is known to 4 %, the order to 0.04. Three spheres in contact at once are not in the
// theory.
bool energy_follows(const dem::Scheme &scheme) {
  const std::vector<double> steps = {20, 80};
  std::vector<double> changes;
  bool near = true;
  const accuracy::PowerLaw expected = accuracy::energy_change_law(energy_case(scheme, 0, dem::Precision::kDouble));
  for (const double n : steps) {
    changes.push_back(accuracy::energy_errors(energy_case(scheme, n, dem::Precision::kDouble)).change);
    near = near && std::fabs(changes.back() / expected.at(n) - 1) < 0.2;
  }
  const accuracy::PowerLaw found = accuracy::fit_power_law(steps, changes);
  std::printf("%s: %.3g n^-%.3f (%.3g n^-%g)\n", scheme.name.c_str(), found.factor, found.order, expected.factor,
              expected.order);
  return near && std::fabs(found.order - expected.order) < 0.15;
}

void energy_changes_as_kinetic_theory_has_it(void **) {
  for (const dem::Scheme &scheme :
       {dem::velocity_verlet(), dem::symplectic_euler(), dem::leapfrog(), dem::forest_ruth()}) {
    assert_true(energy_follows(scheme));
  }
}

// With large steps float is as good as double; with small ones rounding adds up.
void float_sets_a_floor_to_the_energy_error(void **) {
  const auto change = [](double steps, dem::Precision precision) {
    accuracy::EnergyCase what = energy_case(dem::velocity_verlet(), steps, precision);
    what.spans = 80;
    return accuracy::energy_errors(what).change;
  };
  const double coarse = change(20, dem::Precision::kFloat), fine = change(160, dem::Precision::kFloat);
  std::printf("float: %.3g at n = 20, %.3g at n = 160\n", coarse, fine);
  assert_true(std::fabs(coarse / change(20, dem::Precision::kDouble) - 1) < 0.25);
  assert_true(fine > 5 * change(160, dem::Precision::kDouble));
  assert_true(fine < 1e-4);
}

struct Pair {
  dem::Setup setup;
  std::unique_ptr<dem::Engine> in_double, in_float;
};

Pair melted_pair() {
  Pair pair;
  pair.setup = accuracy::melted_gas(accuracy::timed_gas(1728));
  pair.in_double = dem::make_engine(pair.setup, dem::Precision::kDouble);
  pair.in_float = dem::make_engine(pair.setup, dem::Precision::kFloat);
  return pair;
}

// Places are rounded by up to 2^-25 of the box, on three axes of two spheres; overlaps are about half a per cent of the
// radius.
void float_rounds_overlaps_by_the_box_over_the_overlap(void **) {
  const Pair pair = melted_pair();
  const double rounding = std::ldexp(1.0, -25) * pair.setup.box_max[0];
  const accuracy::StateErrors errors = accuracy::compare_states(pair.setup, *pair.in_double, *pair.in_float);
  std::printf("%zu pairs, overlaps off by %.3g, rounding %.3g\n", errors.pairs, errors.overlap, rounding);
  assert_true(errors.pairs > 50);
  assert_true(errors.overlap > 0 && errors.overlap < std::sqrt(6.0) * rounding / 0.005);
  assert_true(errors.missed + errors.extra <= 1);
  assert_true(errors.energy < 1e-5);
}

void float_follows_double_for_a_contact(void **) {
  const Pair pair = melted_pair();
  pair.in_double->run(50);
  pair.in_float->run(50);
  const accuracy::StateErrors errors = accuracy::compare_states(pair.setup, *pair.in_double, *pair.in_float);
  std::printf("after one t_c: %zu missed, %zu extra of %zu, overlaps %.3g, largest %.3g, energy %.3g\n", errors.missed,
              errors.extra, errors.pairs, errors.overlap, errors.largest_overlap, errors.energy);
  assert_true(errors.missed + errors.extra <= errors.pairs / 50);
  assert_true(errors.overlap < 0.01 && errors.largest_overlap < 0.01);
  assert_true(errors.energy < 2e-5);
  assert_true(pair.in_float->state_bytes() < pair.in_double->state_bytes());
}

void equal_states_have_no_errors(void **) {
  const Pair pair = melted_pair();
  const accuracy::StateErrors errors = accuracy::compare_states(pair.setup, *pair.in_double, *pair.in_double);
  assert_int_equal(errors.missed + errors.extra, 0);
  assert_true(errors.overlap == 0 && errors.largest_overlap == 0 && errors.energy == 0);
}

void no_skin_changes_a_bit(void **) {
  accuracy::Budget budget;
  budget.timed_count = 1000;
  budget.repeats = 1;
  accuracy::Recorder record("skin", budget, [](const std::string &) {});
  accuracy::measure_skin_lengths(record);
  assert_true(record.points().size() >= 10);
  for (const accuracy::Point &point : record.points()) assert_true(point.error == 0);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(energy_changes_as_kinetic_theory_has_it),
                              cmocka_unit_test(float_sets_a_floor_to_the_energy_error),
                              cmocka_unit_test(float_rounds_overlaps_by_the_box_over_the_overlap),
                              cmocka_unit_test(float_follows_double_for_a_contact),
                              cmocka_unit_test(equal_states_have_no_errors),
                              cmocka_unit_test(no_skin_changes_a_bit)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
