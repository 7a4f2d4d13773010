// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The hard cases of docs/evidence/robustness.md that are the simulation's: faces, images, walls, extreme masses, many
// contacts.
#include "dem/effects/table.hpp"
#include "tests/dem/gas.hpp"
#include "tests/support/frame.h"
#include "tests/support/refusal.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace {

constexpr uint64_t kSeed = 46;
constexpr double kWeak = 1e-10;  // a stiffness whose forces move nothing

// 7: centres that coincide part along x, the first to the left, whatever the law.
bool parts_along_x(int dimension, dem::EffectSet effects) {
  dem::Setup setup;
  setup.dimension = dimension;
  setup.effects = effects;
  bodies::set_linear(setup, 1e4);
  setup.contact.restitution = 0.9;
  setup.contact.friction = 0.5;
  setup.contact.tangential_stiffness = 2.0 / 7;
  setup.contact.young_modulus = 1e4;
  setup.contact.poisson_ratio = 0.3;
  setup.impact_speed = 100;
  const std::vector<double> center(static_cast<size_t>(dimension), 0.3), rest(center.size(), 0.0);
  bodies::add(setup, center, rest, 1, 1);
  bodies::add(setup, center, rest, 1, 1);
  bodies::set_steps_per_contact(setup, 50);
  const auto engine = dem::make_engine(setup);
  const double start = engine->measure().energy();
  engine->run(200);
  const dem::Snapshot state = engine->snapshot();
  const size_t second = center.size();
  std::printf("%s: at %g and %g, energy %g of %g\n", dem::names_of(effects).c_str(), state.centers[0],
              state.centers[second], engine->measure().energy(), start);
  bool apart = state.centers[second] - state.centers[0] > 2 && engine->measure().energy() <= start * (1 + 1e-2);
  for (size_t k = 0; k < second; k++) {
    apart = apart && state.velocities[k] + state.velocities[second + k] == 0;
    if (k > 0) apart = apart && state.velocities[k] == 0;
  }
  return apart && state.velocities[0] < 0;
}

void coincident_centres_part_along_x(void **) {
  for (const int dimension : {2, 3}) {
    for (const dem::EffectSet effects : {0u, dem::kDissipation | dem::kFriction, unsigned{dem::kHertz},
                                         dem::kHertz | dem::kDissipation | dem::kFriction}) {
      assert_true(parts_along_x(dimension, effects));
    }
  }
}

// 27: two that roll on each other while they drift over the faces of the box do as they do in open space: first one is
// across the faces of each axis, then both are, and their contact keeps its memory.
dem::Snapshot drifting_pair(bool periodic) {
  dem::Setup setup;
  setup.effects = dem::kDissipation | dem::kFriction;
  bodies::set_linear(setup, 1e4, 0.5);
  setup.contact.friction = 0.5;
  setup.contact.tangential_stiffness = 2.0 / 7;
  bodies::add(setup, {4.95, 4.9, 4.85}, {8, 8, 8}, 1, 1, {1, 2, 3});
  const double across = periodic ? 5 : 0;  // the image in the box
  bodies::add(setup, {6.35 - across, 6.1 - across, 5.45 - across}, {7, 8, 8}, 1, 2, {3, 1, -2});
  if (periodic) {
    for (int k = 0; k < 3; k++) bodies::set_periodic(setup, k, 0, 5);
  }
  setup.time_step = 2e-4;
  const auto engine = dem::make_engine(setup);
  engine->run(300);  // the contact begins before the first passes the faces, and ends after
  return engine->snapshot();
}

void a_rolling_contact_crosses_the_faces(void **) {
  const dem::Snapshot open = drifting_pair(false), wrapped = drifting_pair(true);
  double worst = 0;
  for (size_t k = 0; k < open.spins.size(); k++) {
    worst = std::max(
        {worst, std::fabs(open.velocities[k] - wrapped.velocities[k]), std::fabs(open.spins[k] - wrapped.spins[k])});
  }
  std::printf("across the faces and in open space: within %.3g\n", worst);
  assert_true(worst < 1e-9);
  for (size_t k = 0; k < 3; k++) assert_true(open.centers[k] > 5 && wrapped.centers[k] < 1);
  assert_true(std::fabs(open.spins[0] - 1) > 0.1);
}

// 28: at the time when the images above have moved by exactly half a box, a pair meets across the face.
void images_moved_by_half_a_box(void **) {
  constexpr double kEdge = 20;
  for (const double direction : {1.0, -1.0}) {
    dem::Setup setup;
    setup.effects = dem::kShear;
    bodies::set_linear(setup, kWeak);
    for (int k = 0; k < 3; k++) bodies::set_periodic(setup, k, 0, kEdge);
    setup.shear_rate = 0.5 * direction;
    bodies::add(setup, {2, 19.25, 5}, {0, 0, 0}, 1, 1);
    bodies::add(setup, {12, 0.75, 5}, {0, 0, 0}, 1, 1);
    setup.time_step = 0x1p-6;
    const auto engine = dem::make_engine(setup);
    engine->run(64);  // rate x edge x 1 = half an edge; the second's image is at (2, 20.75)
    const dem::Measurement m = engine->measure();
    std::printf("direction %g: %zu contacts, overlap %.15g (0.5)\n", direction, m.contacts, m.largest_overlap);
    assert_true(m.contacts == 1);
    assert_true(std::fabs(m.largest_overlap - 0.5) < 1e-9);
  }
}

size_t contacts_by_images(const dem::Snapshot &state, double edge) {
  size_t contacts = 0;
  for (size_t i = 0; i < state.radii.size(); i++) {
    for (size_t j = 0; j < i; j++) {
      double square = 0;
      for (size_t k = 0; k < 3; k++) {
        square += std::pow(std::remainder(state.centers[3 * i + k] - state.centers[3 * j + k], edge), 2);
      }
      if (square < std::pow(state.radii[i] + state.radii[j], 2)) contacts++;
    }
  }
  return contacts;
}

// 29: particles that pass skins, cells and whole boxes in a step are where they should be and meet whom they should.
void steps_longer_than_the_box(void **) {
  bodies::Gas gas;
  gas.edge = 4;
  gas.spacing = 2.2;
  dem::Setup setup = bodies::make_gas(gas, kSeed);
  bodies::make_periodic(setup);
  setup.contact.stiffness = kWeak;
  setup.skin = 0.1;
  setup.time_step = 0.25;
  const double edge = setup.box_max[0];
  packing::Random random(kSeed);
  for (size_t k = 0; k < setup.velocities.size(); k++) {
    setup.velocities[k] = (2 * random.uniform() - 1) * (k % 2 == 0 ? 10.0 : 0.1) * edge / setup.time_step;
  }
  const auto engine = dem::make_engine(setup);
  size_t met = 0;
  double worst = 0;
  for (int step = 1; step <= 100; step++) {
    engine->run(1);
    const dem::Snapshot state = engine->snapshot();
    const size_t expected = contacts_by_images(state, edge);
    assert_int_equal(engine->measure().contacts, expected);
    met += expected;
    for (size_t k = 0; k < state.centers.size(); k++) {
      const double truth = setup.centers[k] + step * setup.time_step * setup.velocities[k];
      worst = std::max(worst, std::fabs(std::remainder(state.centers[k] - truth, edge)));
    }
  }
  std::printf("seed %llu: %zu contacts in 100 steps, places within %.3g\n", static_cast<unsigned long long>(kSeed), met,
              worst);
  assert_true(met > 100);
  assert_true(worst < 1e-6);
}

dem::Setup one_between_walls(double edge, double center, double radius, double restitution) {
  dem::Setup setup;
  bodies::set_linear(setup, 1e4, restitution);
  bodies::set_walls(setup, 0, 0, edge);
  bodies::add(setup, {center, 0, 0}, {0, 0, 0}, radius, 1);
  bodies::set_steps_per_contact(setup, 50);
  return setup;
}

// 30: the deeper behind a wall, the harder it is pushed back, and keeps its energy.
void centres_behind_walls_come_back(void **) {
  for (const double center : {-0.5, -20.0, 110.0}) {
    const auto engine = dem::make_engine(one_between_walls(100, center, 1, 1));
    const double start = engine->measure().energy();
    engine->run(80);
    const double x = engine->snapshot().centers[0], energy = engine->measure().energy();
    std::printf("from %g to %g, energy %g of %g\n", center, x, energy, start);
    assert_true(x > 1 && x < 99);
    assert_true(std::fabs(energy / start - 1) < 1e-2);
  }
}

// 30: a sphere larger than the box swings between both walls, which pull together as a spring of twice the stiffness.
void a_sphere_larger_than_the_box_swings_in_its_middle(void **) {
  const dem::Setup setup = one_between_walls(4, 2.3, 3, 1);
  const auto engine = dem::make_engine(setup);
  double worst = 0;
  for (int look = 0; look < 40; look++) {
    engine->run(7);
    const double expected = 2 + 0.3 * std::cos(std::sqrt(2e4) * engine->time());
    worst = std::max(worst, std::fabs(engine->snapshot().centers[0] - expected));
  }
  const size_t walls = engine->measure().wall_contacts;
  std::printf("within %.3g of the swing\n", worst);
  assert_int_equal(walls, 2);
  assert_true(worst < 0.3 * 2e-2);
}

// 45: radii of ratio 10^6, masses of 10^18. The lightest pair decides the step; light ones bounce off the giant as off
// a wall, and what it gets from all sides adds up to what they lost.
void masses_of_ratio_1e18(void **) {
  constexpr double kGiant = 1e6, kMass = 1e18;
  dem::Setup setup;
  bodies::set_linear(setup, 1e5);
  bodies::add(setup, {0, 0, 0}, {0, 0, 0}, kGiant, kMass);
  packing::Random random(kSeed);
  for (int i = 0; i < 200; i++) {
    const double x = random.normal(), y = random.normal(), z = random.normal(), norm = std::sqrt(x * x + y * y + z * z);
    const double away = (kGiant + 1.01) / norm, speed = (1 + random.uniform()) / norm;
    bodies::add(setup, {away * x, away * y, away * z}, {-speed * x, -speed * y, -speed * z}, 1, 1);
  }
  assert_true(std::fabs(dem::shortest_contact(setup).duration / (bodies::kPi * std::sqrt(0.5 / 1e5)) - 1) < 1e-12);
  bodies::set_steps_per_contact(setup, 50);
  const auto engine = dem::make_engine(setup);
  const dem::Measurement start = engine->measure();
  engine->run(400);
  const dem::Snapshot state = engine->snapshot();
  double worst_speed = 0, worst_momentum = 0, lost[3] = {0, 0, 0};
  for (size_t k = 3; k < state.velocities.size(); k++) {
    worst_speed = std::max(worst_speed, std::fabs(state.velocities[k] + setup.velocities[k]));
    lost[k % 3] += setup.velocities[k] - state.velocities[k];
  }
  for (size_t k = 0; k < 3; k++) {
    worst_momentum = std::max(worst_momentum, std::fabs(kMass * state.velocities[k] - lost[k]));
  }
  const double energy = engine->measure().energy() / start.energy() - 1;
  std::printf(
      "seed %llu: velocities turned round within %.3g, momentum of the giant within %.3g of %.3g, energy %.3g\n",
      static_cast<unsigned long long>(kSeed), worst_speed, worst_momentum, std::fabs(lost[0]), energy);
  // Places near 10^6 are multiples of 10^-10, a thousandth of a millionth of the overlaps.
  assert_true(worst_speed < 2e-3);
  assert_true(worst_momentum < 1e-10);
  assert_true(std::fabs(energy) < 1e-3);
}

// 46: ten thousand on top of each other, each contact pressed by what lies above it, stay as they are.
void a_stack_of_ten_thousand_stands(void **) {
  constexpr int kHeight = 10000;
  dem::Setup setup;
  setup.effects = dem::kGravity;
  bodies::set_linear(setup, 1e6, 0.5);
  setup.gravity[2] = -1;
  bodies::set_walls(setup, 2, 0, 3 * kHeight);
  double top = 0;
  for (int n = 0; n < kHeight; n++) {
    const double overlap = (kHeight - n) / 1e6;  // of the contact below
    bodies::add(setup, {0, 0, top + 1 - overlap}, {0, 0, 0}, 1, 1);
    top += 2 - overlap;
  }
  setup.skin = 0.1;
  bodies::set_steps_per_contact(setup, 20);
  const auto engine = dem::make_engine(setup);
  engine->run(1000);
  const dem::Snapshot state = engine->snapshot();
  double worst = 0;
  for (size_t k = 0; k < state.centers.size(); k++) {
    worst = std::max(worst, std::fabs(state.centers[k] - setup.centers[k]));
  }
  const dem::Measurement m = engine->measure();
  std::printf("moved by %.3g in %.3g, kinetic energy %.3g\n", worst, engine->time(), m.translation);
  assert_int_equal(m.contacts + m.wall_contacts, kHeight);
  assert_true(worst < 1e-9);
}

// 46: a light one squeezed by two that are a thousand times as heavy stays in the middle, and they turn back as from a
// wall at its centre: after pi sqrt(M / k), with all their speed.
void squeezed_between_two(void **) {
  constexpr double kHeavy = 1000, kSpeed = 5;
  dem::Setup setup;
  bodies::set_linear(setup, 1e5);
  bodies::add(setup, {0, 0, 0}, {0, 0, 0}, 1, 1);
  bodies::add(setup, {-2, 0, 0}, {kSpeed, 0, 0}, 1, kHeavy);
  bodies::add(setup, {2, 0, 0}, {-kSpeed, 0, 0}, 1, kHeavy);
  bodies::set_steps_per_contact(setup, 50);
  const auto engine = dem::make_engine(setup);
  const double start = engine->measure().energy(), turn = bodies::kPi * std::sqrt(kHeavy / 1e5);
  engine->run(static_cast<uint64_t>(turn / 2 / setup.time_step));
  const double deepest = engine->measure().largest_overlap;
  engine->run(static_cast<uint64_t>(turn / 2 / setup.time_step) + 10);
  const dem::Snapshot state = engine->snapshot();
  std::printf("deepest %.5f (%.5f), speeds %.6f %.6f, middle at %.3g\n", deepest, kSpeed * std::sqrt(kHeavy / 1e5),
              state.velocities[3], state.velocities[6], state.centers[0]);
  assert_true(std::fabs(deepest / (kSpeed * std::sqrt(kHeavy / 1e5)) - 1) < 1e-3);
  assert_true(std::fabs(state.velocities[3] + kSpeed) < 1e-3 * kSpeed && state.velocities[6] == -state.velocities[3]);
  assert_true(state.centers[0] == 0 && std::fabs(engine->measure().energy() / start - 1) < 1e-3);
}

// A close packing, each sphere pressed on twelve others.
dem::Setup pressed_crystal() {
  constexpr int kCells = 4;
  constexpr double kSpacing = 1.98, kCell = kSpacing * 1.4142135623730951;
  const double sites[4][3] = {{0, 0, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 0}};
  dem::Setup setup;
  bodies::set_linear(setup, 1e4);
  packing::Random random(kSeed);
  for (int cell = 0; cell < kCells * kCells * kCells; cell++) {
    for (const auto &site : sites) {
      const double x = (cell % kCells + site[0]) * kCell, y = (cell / kCells % kCells + site[1]) * kCell;
      const double z = (static_cast<double>(cell / (kCells * kCells)) + site[2]) * kCell;
      const double u = 0.1 * random.normal(), v = 0.1 * random.normal(), w = 0.1 * random.normal();
      bodies::add(setup, {x, y, z}, {u, v, w}, 1, 1);
    }
  }
  for (int k = 0; k < 3; k++) bodies::set_periodic(setup, k, 0, kCells * kCell);
  return setup;
}

// 46: with twelve contacts a sphere swings faster than with one. The largest step that is taken is safe for that; the
// next larger one is refused. Energy is that of the swings: the pressed springs' own is taken off.
void the_largest_step_is_stable_with_twelve_contacts(void **) {
  dem::Setup setup = pressed_crystal();
  bodies::set_steps_per_contact(setup, 10.0000001);
  const auto engine = dem::make_engine(setup);
  const size_t contacts = engine->measure().contacts;
  assert_int_equal(contacts, 6 * setup.count());
  const double start = engine->measure().energy(), swings = engine->measure().translation;
  double worst = 0;
  for (int look = 0; look < 100; look++) {
    engine->run(41);
    worst = std::max(worst, std::fabs(engine->measure().energy() - start) / swings);
  }
  std::printf("energy within %.3g of that of the swings\n", worst);
  assert_true(worst < 0.15);
  setup.time_step = dem::shortest_contact(setup).duration / 9.999;
  assert_true(test::is_refused("", [&] { dem::make_engine(setup); }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(coincident_centres_part_along_x),
      cmocka_unit_test(a_rolling_contact_crosses_the_faces),
      cmocka_unit_test(images_moved_by_half_a_box),
      cmocka_unit_test(steps_longer_than_the_box),
      cmocka_unit_test(centres_behind_walls_come_back),
      cmocka_unit_test(a_sphere_larger_than_the_box_swings_in_its_middle),
      cmocka_unit_test(masses_of_ratio_1e18),
      cmocka_unit_test(a_stack_of_ten_thousand_stands),
      cmocka_unit_test(squeezed_between_two),
      cmocka_unit_test(the_largest_step_is_stable_with_twelve_contacts),
  };
  return cmocka_run_group_tests_name("hard cases", tests, nullptr, nullptr);
}
