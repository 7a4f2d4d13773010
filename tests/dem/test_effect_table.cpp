// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The table of effects: its bits and names, every set of effects it allows or refuses, every number it checks.
#include "dem/effects/table.hpp"
#include "tests/dem/bodies.hpp"
#include "tests/support/frame.h"
#include "tests/support/refusal.hpp"

#include <cstdio>
#include <set>
#include <string>

namespace {

constexpr dem::EffectSet kAll = (1u << 13) - 1;

// Two particles in contact, with every number that any of the effects asks for.
dem::Setup setup_of(dem::EffectSet effects, int dimension) {
  dem::Setup setup;
  setup.dimension = dimension;
  setup.effects = effects;
  setup.contact.stiffness = 1e4;
  setup.contact.modulus = 1e4;
  setup.contact.restitution = 0.9;
  setup.contact.friction = 0.5;
  setup.contact.rolling_friction = 0.1;
  setup.contact.adhesion_force = 1;
  setup.contact.adhesion_range = 0.1;
  setup.contact.young_modulus = 1e4;
  setup.contact.poisson_ratio = 0.3;
  setup.impact_speed = 1;
  setup.gravity[1] = -1;
  setup.viscosity = 0.1;
  setup.growth_rate = 0.01;
  setup.shear_rate = 0.1;
  const bool periodic = dem::has(effects, dem::kPeriodic | dem::kShear), walled = dem::has(effects, dem::kWalls);
  for (int axis = 0; axis < dimension; axis++) {
    setup.box_max[axis] = 10;
    setup.walled[axis] = walled && (!periodic || axis == dimension - 1);
    setup.periodic[axis] = periodic && !setup.walled[axis];
  }
  const auto size = static_cast<size_t>(dimension);
  std::vector<double> center(size, 5), other(size, 5), velocity(size, 0);
  other[0] = 6.9;
  velocity[0] = 1;
  bodies::add(setup, center, velocity, 1, 1);
  bodies::add(setup, other, std::vector<double>(size, 0), 1, 1);
  if (dem::has(effects, dem::kMaterials)) {
    setup.materials.assign(2, {"m", 1, setup.contact});
    setup.pairs.assign(6, setup.contact);
    setup.material_ids = {0, 1};
  }
  setup.time_step = 1e-3;
  return setup;
}

std::string error_of(const dem::Setup &setup, dem::Precision precision = dem::Precision::kDouble) {
  return test::error_of([&] { dem::make_engine(setup, precision)->run(3); });
}

// What the engine should say of a set, told apart from its table.
std::string expected_error(dem::EffectSet set) {
  if (has(set, dem::kRolling) && !has(set, dem::kFriction)) {
    return "rolling needs [friction]: without it particles do not rotate";
  }
  if (has(set, dem::kAdhesion) && has(set, dem::kHertz)) {
    return "adhesion does not go together with [hertz]: it is a law of linear contacts";
  }
  if (has(set, dem::kModulus) && has(set, dem::kHertz)) {
    return "modulus does not go together with [hertz]: it is a law of linear contacts";
  }
  if (has(set, dem::kShear) && !has(set, dem::kPeriodic)) return "shear needs [periodic]: it moves the images";
  return "";
}

bool behaves(dem::EffectSet set, int dimension) {
  if (dimension == 2 && has(set, dem::kShear) && has(set, dem::kWalls)) return true;  // no axis is left for walls
  const std::string error = error_of(setup_of(set, dimension)), expected = expected_error(set);
  if (error != expected) std::printf("%s in %d: '%s'\n", dem::names_of(set).c_str(), dimension, error.c_str());
  return error == expected;
}

void every_set_of_effects_runs_or_is_refused(void **) {
  for (const int dimension : {2, 3}) {
    for (dem::EffectSet set = 0; set <= kAll; set++) assert_true(behaves(set, dimension));
  }
}

bool float_behaves(dem::EffectSet set) {
  constexpr dem::EffectSet kBuilt =
      dem::kDissipation | dem::kHertz | dem::kModulus | dem::kPeriodic | dem::kWalls | dem::kGravity;
  const std::string error = error_of(setup_of(set, 3), dem::Precision::kFloat);
  // What has no kernel of its own needs none.
  if ((set & ~(kBuilt | dem::kGrowth)) == 0) return error == expected_error(set);
  return error.find("this build has no kernel") == 0 || error == expected_error(set);
}

void states_in_float_have_some_effects(void **) {
  for (dem::EffectSet set = 0; set <= kAll; set++) assert_true(float_behaves(set));
}

// The bits are those of checkpoints, and no two effects share one.
void bits_and_names_stay(void **) {
  const char *names[] = {"dissipation", "friction", "rolling", "adhesion", "hertz",   "periodic", "shear",
                         "walls",       "gravity",  "drag",    "growth",   "modulus", "materials"};
  dem::EffectSet bit = 1;
  for (const char *name : names) {
    assert_true(dem::names_of(bit) == name);
    assert_true(dem::effect_of_name(name)->effect == bit);
    bit <<= 1;
  }
  assert_true(dem::names_of(0) == "none");
  assert_true(dem::names_of(kAll).find("dissipation, friction, rolling, adhesion, hertz") == 0);
  assert_true(dem::effect_of_name("frictoin") == nullptr);
}

// A setup of the effect of a number, and of what it needs, is refused if the number is `value`.
std::string error_with(const dem::Parameter &parameter, double value) {
  dem::EffectSet effects = parameter.effect;
  for (const dem::EffectRow &row : dem::kEffects) effects |= row.effect == parameter.effect ? row.needs : 0u;
  dem::Setup setup = setup_of(effects, 3);
  setup.impact_speed = 1;
  const auto set = [&](auto place) {
    if constexpr (std::is_same_v<decltype(place), bool(dem::Physics::*)[3]>)
      return;
    else if constexpr (std::is_same_v<decltype(place), double(dem::Physics::*)[3]>)
      (setup.*place)[2] = value;
    else
      dem::at(setup, place) = value;
  };
  std::visit(set, parameter.place);
  return error_of(setup);
}

bool is_checked(const dem::Parameter &parameter) {
  const std::string start = std::string(dem::table_of(parameter.effect)) + "." + parameter.key + " lies ";
  const auto refused = [&](double value) { return error_with(parameter, value).compare(0, start.size(), start) == 0; };
  const dem::Range &range = parameter.range;
  bool good = refused(NAN);
  if (std::isfinite(range.low)) good = good && refused(range.closed ? std::nextafter(range.low, -1e9) : range.low);
  if (std::isfinite(range.high)) good = good && refused(std::nextafter(range.high, INFINITY));
  good = good && !refused(std::isfinite(range.low) ? range.low + 0.5 : 0.5);
  if (!good) std::printf("%s\n", start.c_str());
  return good;
}

void every_number_is_checked(void **) {
  for (const dem::Parameter &parameter : dem::kParameters) {
    if (std::holds_alternative<bool(dem::Physics::*)[3]>(parameter.place)) continue;  // letters of axes
    assert_true(is_checked(parameter));
  }
}

// What a scene may leave out makes sense as it is, and no key stands twice.
void numbers_that_may_be_left_out_are_sound(void **) {
  std::set<std::string> seen;
  for (const dem::Parameter &parameter : dem::kParameters) {
    assert_true(seen.insert(std::string(dem::table_of(parameter.effect)) + "." + parameter.key).second);
    assert_true(parameter.needed() || dem::fault_of(parameter, dem::Physics()).empty());
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(every_set_of_effects_runs_or_is_refused),
      cmocka_unit_test(states_in_float_have_some_effects),
      cmocka_unit_test(bits_and_names_stay),
      cmocka_unit_test(every_number_is_checked),
      cmocka_unit_test(numbers_that_may_be_left_out_are_sound),
  };
  return cmocka_run_group_tests_name("effect table", tests, nullptr, nullptr);
}
