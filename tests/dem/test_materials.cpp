// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Several materials: the rules of pairs against closed forms, every particle and wall by its own law, equal materials
// as none, the time step of the shortest pair, checkpoints.
#include "packing/random.hpp"
#include "tests/dem/gas.hpp"
#include "tests/support/frame.h"
#include "tests/support/refusal.hpp"

#include <algorithm>
#include <cstdio>

namespace {

constexpr uint64_t kSeed = 41;
constexpr double kPi = bodies::kPi;

// Materials 0 and 1 of these stiffnesses or moduli, whatever the law takes.
dem::Setup of_two(dem::EffectSet effects, double first, double second) {
  dem::Setup setup;
  setup.effects = effects | dem::kMaterials;
  for (const double number : {first, second}) {
    dem::Material material;
    material.name = number == first ? "first" : "second";
    material.contact.stiffness = material.contact.modulus = material.contact.young_modulus = number;
    material.contact.poisson_ratio = number == first ? 0.2 : 0.4;
    setup.materials.push_back(material);
  }
  dem::ContactParameters both;
  both.restitution = 0.9;
  both.friction = 0.4;
  both.rolling_friction = 0.1;
  both.adhesion_force = 0.3;
  both.adhesion_range = 0.1;
  setup.contact.adhesion_range = 0.1;
  setup.contact.wall_modulus = setup.contact.wall_young_modulus = 2e4;
  setup.contact.wall_poisson_ratio = 0.1;
  setup.pairs.assign(6, both);
  setup.impact_speed = 1;
  return setup;
}

void add(dem::Setup &setup, const std::vector<double> &center, double radius, double mass, uint8_t material,
         const std::vector<double> &velocity = {0, 0, 0}) {
  bodies::add(setup, center, velocity, radius, mass);
  setup.material_ids.push_back(material);
}

// dF/dd of the linear contact of two particles, by 1 / k as a sum or mean.
double linear_stiffness(const dem::Setup &setup, size_t a, size_t b, double radius, double other) {
  const dem::ContactParameters &p = setup.materials[a].contact, &q = setup.materials[b].contact;
  if (dem::has(setup.effects, dem::kModulus))
    return 1 / (1 / (kPi * p.modulus * radius) + 1 / (kPi * q.modulus * other));
  return 2 / (1 / p.stiffness + 1 / q.stiffness);
}

double hertz_modulus(const dem::ContactParameters &p, double young, double poisson) {
  return 1 / ((1 - p.poisson_ratio * p.poisson_ratio) / p.young_modulus + (1 - poisson * poisson) / young);
}

double energy_of(dem::Setup setup) {
  setup.time_step = dem::usual_step(setup);
  return dem::make_engine(setup)->measure().contact;
}

bool is_near(double value, double expected, double within) {
  const bool near = std::fabs(value / expected - 1) < within;
  if (!near) std::printf("%.12g where %.12g is expected\n", value, expected);
  return near;
}

void springs_of_two_materials_lie_in_series(void **) {
  const double overlap = 0.01, other = 3;
  for (const dem::EffectSet law : {dem::EffectSet{0}, dem::EffectSet{dem::kModulus}, dem::EffectSet{dem::kHertz}}) {
    for (const uint8_t a : {0, 1}) {
      dem::Setup setup = of_two(law, 1e4, 5e4);
      add(setup, {0, 0, 0}, 1, 1, a);
      add(setup, {1 + other - overlap, 0, 0}, other, 27, 1);
      const dem::ContactParameters &q = setup.materials[1].contact;
      const double hertz = 8.0 / 15 * hertz_modulus(setup.materials[a].contact, q.young_modulus, q.poisson_ratio) *
                           std::sqrt(1 / (1 + 1 / other)) * std::pow(overlap, 2.5);
      const double linear = 0.5 * linear_stiffness(setup, a, 1, 1, other) * overlap * overlap;
      assert_true(is_near(energy_of(setup), law == dem::kHertz ? hertz : linear, 1e-10));
    }
  }
}

// Walls of a material, and of none: as the scene says of walls, or with one stiffness that of the particle.
void walls_are_of_materials_too(void **) {
  const double overlap = 0.01, radius = 2;
  for (const dem::EffectSet law : {dem::EffectSet{0}, dem::EffectSet{dem::kModulus}, dem::EffectSet{dem::kHertz}}) {
    for (const int wall : {-1, 0, 1}) {
      dem::Setup setup = of_two(law, 1e4, 5e4);
      bodies::set_walls(setup, 2, 0, 10);
      setup.wall_materials[4] = wall;
      setup.wall_materials[5] = 1;
      add(setup, {0, 0, radius - overlap}, radius, 8, 0);
      const dem::ContactParameters &p = setup.materials[0].contact, &all = setup.contact,
                                   &q = setup.materials[static_cast<size_t>(std::max(wall, 0))].contact;
      const double young = wall < 0 ? all.wall_young_modulus : q.young_modulus;
      const double poisson = wall < 0 ? all.wall_poisson_ratio : q.poisson_ratio;
      const double modulus = wall < 0 ? all.wall_modulus : q.modulus;
      double expected = 0.5 * (wall < 0 ? p.stiffness : 2 / (1 / p.stiffness + 1 / q.stiffness)) * overlap * overlap;
      if (law == dem::kModulus) expected = 0.5 * kPi * radius / (1 / p.modulus + 1 / modulus) * overlap * overlap;
      if (law == dem::kHertz)
        expected = 8.0 / 15 * hertz_modulus(p, young, poisson) * std::sqrt(radius) * std::pow(overlap, 2.5);
      assert_true(is_near(energy_of(setup), expected, 1e-10));
    }
  }
}

// The speed after a head-on collision over that before it.
double restitution_of(dem::Setup setup) {
  setup.time_step = dem::shortest_contact(setup).duration / 500;
  const bodies::Collision collision = bodies::follow_collision(setup, 5000);
  const auto approach = [](const dem::Snapshot &s) { return s.velocities[2] - (s.count() > 1 ? s.velocities[5] : 0); };
  return -approach(collision.after) / approach(collision.before);
}

void restitution_belongs_to_the_pair(void **) {
  const double expected[] = {0.9, 0.7, 0.5, 0.3};  // both first; both second; first and second; second and wall
  for (size_t k = 0; k < 4; k++) {
    dem::Setup setup = of_two(dem::kDissipation, 1e4, 4e4);
    setup.pairs[setup.pair_of(0, 0)].restitution = 0.9;
    setup.pairs[setup.pair_of(1, 1)].restitution = 0.7;
    setup.pairs[setup.pair_of(0, 1)].restitution = setup.pairs[setup.pair_of(1, 0)].restitution = 0.5;
    setup.pairs[setup.pair_of(1, 2)].restitution = 0.3;
    const bool wall = k == 3;
    if (wall) bodies::set_walls(setup, 2, 0, 10);
    add(setup, {0, 0, 1.001}, 1, 1, k % 2 == 1 ? 1 : 0, {0, 0, wall ? -0.5 : 0.5});
    if (!wall) add(setup, {0, 0, 3.003}, 1, 2, k == 0 ? 0 : 1);
    assert_true(is_near(restitution_of(setup), expected[k], 4e-3));
  }
}

// A ball that slides over a floor takes mu (1 + e) v of speed along it.
void friction_belongs_to_the_pair(void **) {
  for (const double friction : {0.05, 0.15}) {
    dem::Setup setup = of_two(dem::kFriction, 1e4, 1e4);
    bodies::set_walls(setup, 2, 0, 10);
    setup.wall_materials[4] = friction < 0.1 ? 0 : 1;
    setup.pairs[setup.pair_of(0, 0)].friction = 0.05;
    setup.pairs[setup.pair_of(0, 1)].friction = 0.15;
    add(setup, {0, 0, 1.001}, 1, 1, 0, {5, 0, -0.5});
    setup.time_step = dem::shortest_contact(setup).duration / 200;
    const dem::Snapshot after = bodies::follow_collision(setup, 5000).after;
    assert_true(is_near(5 - after.velocities[0], friction * 2 * 0.5, 1e-3));
  }
}

// The force of each of many particles from the laws of its pairs, summed here from closed forms. A first step from rest
// moves it by dt^2 / 2 of its acceleration.
bool forces_are_those_of_the_pairs(dem::EffectSet law) {
  packing::Random random(kSeed);
  dem::Setup setup = of_two(law, 1e4, 3e4);
  for (int n = 0; n < 200; n++) {
    const double radius = 0.5 + random.uniform();
    add(setup, {9 * random.uniform(), 9 * random.uniform(), 9 * random.uniform()}, radius, radius * radius * radius,
        random.uniform() < 0.5 ? 0 : 1);
  }
  setup.time_step = dem::usual_step(setup);
  const size_t count = setup.count();
  std::vector<double> expected(3 * count);
  for (size_t a = 0; a < count; a++) {
    for (size_t b = 0; b < count; b++) {
      double d[3], square = 0;
      for (size_t k = 0; k < 3; k++) square += std::pow(d[k] = setup.centers[3 * b + k] - setup.centers[3 * a + k], 2);
      const double overlap = setup.radii[a] + setup.radii[b] - std::sqrt(square);
      if (a == b || overlap <= 0) continue;
      const double stiffness =
          linear_stiffness(setup, setup.material_ids[a], setup.material_ids[b], setup.radii[a], setup.radii[b]);
      for (size_t k = 0; k < 3; k++)
        expected[3 * a + k] -= stiffness * overlap * d[k] / std::sqrt(square) / setup.masses[a];
    }
  }
  const auto engine = dem::make_engine(setup);
  engine->run(1);
  const dem::Snapshot after = engine->snapshot();
  double worst = 0, largest = 0;
  for (size_t k = 0; k < 3 * count; k++) {
    const double found = (after.centers[k] - setup.centers[k]) / (0.5 * setup.time_step * setup.time_step);
    worst = std::max(worst, std::fabs(found - expected[k]));
    largest = std::max(largest, std::fabs(expected[k]));
  }
  std::printf("accelerations up to %.3g within %.3g\n", largest, worst);
  return largest > 1e4 && worst < 1e-8 * largest;
}

void every_particle_follows_the_laws_of_its_pairs(void **) {
  assert_true(forces_are_those_of_the_pairs(0));
  assert_true(forces_are_those_of_the_pairs(dem::kModulus));
}

dem::Setup gas_of(dem::EffectSet effects, bool walled) {
  bodies::Gas gas;
  gas.edge = 4;
  gas.spacing = 2.05;
  gas.temperature = 4;
  gas.effects = effects;
  dem::Setup setup = bodies::make_gas(gas, kSeed);
  setup.contact = {};
  setup.contact.stiffness = setup.contact.modulus = setup.contact.young_modulus = 1e4 / 3;
  setup.contact.wall_modulus = setup.contact.wall_young_modulus = 7e4;
  setup.contact.restitution = 0.83;
  setup.contact.friction = 0.37;
  setup.contact.rolling_friction = 0.11;
  setup.contact.adhesion_force = 5;
  setup.contact.adhesion_range = 0.1;
  setup.contact.poisson_ratio = 0.31;
  setup.impact_speed = 30;
  if (walled) bodies::wall_in(setup);
  if (!walled) bodies::make_periodic(setup);
  setup.time_step = dem::usual_step(setup);
  return setup;
}

// Three materials of the same numbers.
dem::Setup of_equal_materials(dem::Setup setup) {
  packing::Random random(kSeed);
  setup.effects |= dem::kMaterials;
  setup.materials.assign(3, {"same", 1, setup.contact});
  setup.pairs.assign(12, setup.contact);
  for (size_t i = 0; i < setup.count(); i++) setup.material_ids.push_back(static_cast<uint8_t>(3 * random.uniform()));
  return setup;
}

bool change_no_bit(dem::EffectSet effects, bool walled) {
  const dem::Setup one = gas_of(effects, walled), several = of_equal_materials(one);
  const auto a = dem::make_engine(one), b = dem::make_engine(several);
  a->run(200);
  b->run(200);
  const dem::Snapshot x = a->snapshot(), y = b->snapshot();
  const bool same = x.centers == y.centers && x.velocities == y.velocities && x.spins == y.spins &&
                    a->measure().energy() == b->measure().energy() && dem::usual_step(several) == one.time_step &&
                    a->measure().step_load == b->measure().step_load;
  if (!same) std::printf("effects %u, %s\n", effects, walled ? "walls" : "periodic");
  return same;
}

void equal_materials_change_no_bit(void **) {
  const dem::EffectSet laws[] = {0, dem::kModulus, dem::kHertz, dem::kAdhesion, dem::kAdhesion | dem::kModulus};
  const dem::EffectSet losses[] = {0, dem::kDissipation, dem::kFriction,
                                   dem::kDissipation | dem::kFriction | dem::kRolling};
  for (const dem::EffectSet law : laws) {
    for (const dem::EffectSet loss : losses) {
      for (const bool walled : {false, true}) assert_true(change_no_bit(law | loss, walled));
    }
  }
}

// pi / w of a pair, w^2 = k / mu, damped.
double duration_of(const dem::Setup &setup, size_t a, size_t b, size_t i, size_t j) {
  const double log_e = std::log(setup.pairs[setup.pair_of(a, b)].restitution);
  const double reduced = 1 / (1 / setup.masses[i] + 1 / setup.masses[j]);
  const double stiffness = linear_stiffness(setup, a, b, setup.radii[i], setup.radii[j]);
  return std::sqrt(reduced * (kPi * kPi + log_e * log_e) / stiffness);
}

// No pair is over sooner than the step is reckoned from, and with one stiffness for each material one is over then.
bool step_is_of_the_shortest_pair(packing::Random &random, dem::EffectSet law) {
  dem::Setup setup = of_two(law | dem::kDissipation, std::pow(10, 3 + 2 * random.uniform()), 1e4);
  for (dem::ContactParameters &both : setup.pairs) both.restitution = 0.1 + 0.9 * random.uniform();
  setup.pairs[setup.pair_of(1, 0)] = setup.pairs[setup.pair_of(0, 1)];
  for (int n = 0; n < 12; n++) {
    const double radius = std::pow(10, random.uniform()), mass = std::pow(10, 3 * random.uniform());
    add(setup, {0, 0, 0}, radius, mass, random.uniform() < 0.5 ? 0 : 1);
  }
  const double shortest = dem::shortest_contact(setup).duration;
  double found = dem::kInfinity;
  for (size_t i = 0; i < setup.count(); i++) {
    for (size_t j = 0; j < i; j++)
      found = std::min(found, duration_of(setup, setup.material_ids[i], setup.material_ids[j], i, j));
  }
  const double tight = law == dem::kModulus ? 0 : 1 - 1e-12;
  return shortest <= found * (1 + 1e-12) && shortest >= tight * found;
}

void the_step_is_that_of_the_shortest_pair(void **) {
  packing::Random random(kSeed);
  for (int round = 0; round < 100; round++) {
    assert_true(step_is_of_the_shortest_pair(random, 0));
    assert_true(step_is_of_the_shortest_pair(random, dem::kModulus));
  }
}

// A wall of much stiffer material makes contacts shorter, and steps with them.
void stiff_walls_shorten_the_step(void **) {
  dem::Setup setup = of_two(0, 1e4, 1e8);
  add(setup, {0, 0, 5}, 1, 1, 0);
  const double open = dem::shortest_contact(setup).duration;
  bodies::set_walls(setup, 2, 0, 10);
  assert_true(is_near(dem::shortest_contact(setup).duration, open, 1e-12));
  setup.wall_materials[4] = 1;
  const double stiffness = 2 / (1 / 1e4 + 1 / 1e8);
  assert_true(is_near(dem::shortest_contact(setup).duration, kPi / std::sqrt(stiffness), 1e-12));
}

void checkpoints_keep_materials(void **) {
  dem::Setup setup = of_equal_materials(gas_of(dem::kDissipation | dem::kFriction, true));
  setup.materials[1].contact.stiffness *= 2;
  setup.materials[1].name = "stiffer";
  setup.pairs[setup.pair_of(1, 1)].friction = 0.9;
  setup.time_step /= 2;
  const auto whole = dem::make_engine(setup), half = dem::make_engine(setup), again = dem::make_engine(setup);
  whole->run(200);
  half->run(100);
  dem::Checkpoint checkpoint;
  half->save(checkpoint);
  again->restore(checkpoint);
  again->run(100);
  assert_true(again->snapshot().centers == whole->snapshot().centers);
  assert_true(again->snapshot().material_ids == setup.material_ids);
  std::swap(setup.materials[0].name, setup.materials[1].name);
  const auto other = dem::make_engine(setup);
  assert_true(
      test::is_refused("the checkpoint has the materials same, stiffer, same, the scene has stiffer, same, same",
                       [&] { other->restore(checkpoint); }));
}

bool is_refused(const dem::Setup &setup, const char *part) {
  return test::is_refused(part, [&] { dem::make_engine(setup); });
}

void faults_name_material_or_pair(void **) {
  dem::Setup good = of_two(dem::kDissipation, 1e4, 2e4);
  add(good, {0, 0, 0}, 1, 1, 0);
  add(good, {3, 0, 0}, 1, 1, 1);
  good.time_step = dem::usual_step(good);
  dem::Setup setup = good;
  setup.pairs[setup.pair_of(0, 1)].restitution = 1.5;
  assert_true(is_refused(setup, "restitution of first with second lies in (0, 1], not at 1.5"));
  setup = good;
  setup.materials[1].contact.stiffness = -1;
  assert_true(is_refused(setup, "stiffness of second lies above 0, not at -1"));
  setup = good;
  setup.material_ids[1] = 7;
  assert_true(is_refused(setup, "particle 1 is of material 7, and there are 2"));
  setup = good;
  setup.material_ids.pop_back();
  assert_true(is_refused(setup, "materials: 1 numbers where 2 are needed"));
  setup = good;
  setup.pairs.pop_back();
  assert_true(is_refused(setup, "pairs of materials: 5 where 6 are needed"));
  // Who never meets may be at fault: no particles are against walls here.
  setup = good;
  setup.pairs[setup.pair_of(0, 2)].restitution = 1.5;
  assert_true(dem::make_engine(setup) != nullptr);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(springs_of_two_materials_lie_in_series),
      cmocka_unit_test(walls_are_of_materials_too),
      cmocka_unit_test(restitution_belongs_to_the_pair),
      cmocka_unit_test(friction_belongs_to_the_pair),
      cmocka_unit_test(every_particle_follows_the_laws_of_its_pairs),
      cmocka_unit_test(equal_materials_change_no_bit),
      cmocka_unit_test(the_step_is_that_of_the_shortest_pair),
      cmocka_unit_test(stiff_walls_shorten_the_step),
      cmocka_unit_test(checkpoints_keep_materials),
      cmocka_unit_test(faults_name_material_or_pair),
  };
  return cmocka_run_group_tests_name("materials", tests, nullptr, nullptr);
}
