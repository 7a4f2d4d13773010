// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Triangle meshes as walls: one force at each point, nothing felt where triangles of a plane meet, turning.
#include "tests/dem/wall_bodies.hpp"
#include "tests/support/frame.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace {

using namespace bodies;

// What a floor of triangles does differently from a plane to a ball that slides, then rolls over their edges and
// corners.
double difference_on_tiles(const std::vector<double> &center, const std::vector<double> &velocity) {
  dem::Setup setup = with_walls(3, {plane({0, 0, 0}, {0, 0, 1})}, 0.5);
  setup.effects |= dem::kFriction | dem::kRolling | dem::kGravity;
  setup.contact.friction = 0.3;
  setup.contact.rolling_friction = 0.01;
  setup.gravity[2] = -10;
  bodies::add(setup, center, velocity, 1, 1);
  bodies::set_steps_per_contact(setup, 50);
  dem::Setup tiled = setup;
  tiled.walls = {tiled_floor(12, 12)};
  const auto on_plane = dem::make_engine(setup), on_tiles = dem::make_engine(tiled);
  double worst = 0;
  size_t most_contacts = 0;
  for (int look = 0; look < 200; look++) {
    on_plane->run(20);
    on_tiles->run(20);
    most_contacts = std::max(most_contacts, on_tiles->measure().wall_contacts);
    const dem::Snapshot a = on_plane->snapshot(), b = on_tiles->snapshot();
    for (const auto &[x, y] :
         {std::pair(&a.centers, &b.centers), std::pair(&a.velocities, &b.velocities), std::pair(&a.spins, &b.spins)}) {
      for (size_t k = 0; k < 3; k++) worst = std::max(worst, std::fabs((*x)[k] - (*y)[k]));
    }
  }
  std::printf("tiles: %.3g from the plane, at x = %.3g, y = %.3g\n", worst, on_tiles->snapshot().centers[0],
              on_tiles->snapshot().centers[1]);
  return most_contacts == 1 ? worst : 1;
}

void edges_between_coplanar_triangles_are_not_felt(void **) {
  const double sunk = 1 - 10 / kStiffness;
  assert_true(difference_on_tiles({-8, -7.3, sunk}, {4, 3.1, 0}) < 1e-9);        // across edges
  assert_true(difference_on_tiles({-8, -8, sunk}, {3, 3, 0}) < 1e-9);            // along diagonals, through corners
  assert_true(difference_on_tiles({-8, 2, sunk}, {4, 0, 0}) < 1e-9);             // along edges
  assert_true(difference_on_tiles({-8.1, 2.3, sunk + 0.1}, {4, 1, -1}) < 1e-9);  // bouncing
}

// Elastic force on a ball at rest, from its velocity after a step.
std::vector<double> force_at(const dem::WallBody &wall, const std::vector<double> &center, size_t &contacts) {
  dem::Setup setup = with_walls(3, {wall});
  bodies::add(setup, center, {0, 0, 0}, 1, 1);
  bodies::set_steps_per_contact(setup, 1e6);
  const auto engine = dem::make_engine(setup);
  contacts = engine->measure().wall_contacts;
  engine->run(1);
  std::vector<double> force = engine->snapshot().velocities;
  for (double &component : force) component /= setup.time_step;
  return force;
}

bool force_is(const dem::WallBody &wall, const std::vector<double> &center, size_t contacts,
              const std::vector<double> &expected) {
  size_t found = 0;
  const std::vector<double> force = force_at(wall, center, found);
  std::printf("%zu contacts, force %.6f %.6f %.6f (%.6f %.6f %.6f)\n", found, force[0], force[1], force[2], expected[0],
              expected[1], expected[2]);
  bool good = found == contacts;
  for (size_t k = 0; k < 3; k++) good = good && std::fabs(force[k] - expected[k]) < 1e-4 * kStiffness * 0.1;
  return good;
}

// A roof whose edge runs along x at z = 0, in six triangles, and a pyramid of four with its top there.
dem::WallBody roof() {
  return mesh({{-5, 0, 0},
               {0, 0, 0},
               {-5, 5, -5},
               {0, 0, 0},
               {5, 0, 0},
               {5, 5, -5},  //
               {-5, 0, 0},
               {-5, -5, -5},
               {0, 0, 0},
               {0, 0, 0},
               {5, -5, -5},
               {5, 0, 0},  //
               {0, 0, 0},
               {5, 5, -5},
               {-5, 5, -5},
               {0, 0, 0},
               {-5, -5, -5},
               {5, -5, -5}});
}

dem::WallBody pyramid(double height) {
  const Corner a{5, 5, -height}, b{-5, 5, -height}, c{-5, -5, -height}, d{5, -5, -height}, top{0, 0, 0};
  return mesh({a, b, top, b, c, top, c, d, top, d, a, top});
}

// Above an edge or a corner that sticks out there is one contact, whoever shares it; over a face that of the face; in
// a groove or a pit one for each side.
void edges_and_corners_push_once(void **) {
  const double k = kStiffness;
  assert_true(force_is(roof(), {1.5, 0, 0.9}, 1, {0, 0, k * 0.1}));
  assert_true(force_is(roof(), {0, 0, 0.9}, 1, {0, 0, k * 0.1}));  // where six triangles meet
  // Over one side of the edge, nearer to the face than to the edge, and not yet so.
  const double s = std::sqrt(0.5), deep = k * (1 - 0.95);
  assert_true(force_is(roof(), {1.5, 2 + 0.95 * s, -2 + 0.95 * s}, 1, {0, deep * s, deep * s}));
  assert_true(
      force_is(roof(), {1.5, 0.3, std::sqrt(0.81 - 0.09)}, 1, {0, k * 0.1 * 0.3 / 0.9, k * 0.1 * std::sqrt(8.0) / 3}));
  assert_true(force_is(pyramid(5), {0, 0, 0.9}, 1, {0, 0, k * 0.1}));
  assert_true(force_is(pyramid(5), {0.1, -0.05, std::sqrt(0.81 - 0.0125)}, 1,
                       {k * 0.1 * 0.1 / 0.9, -k * 0.1 * 0.05 / 0.9, k * 0.1 * std::sqrt(0.81 - 0.0125) / 0.9}));
  // A pit with sides of slope 1: four faces, each at distance z / sqrt(2).
  assert_true(force_is(pyramid(-5), {0, 0, 0.95 / s}, 4, {0, 0, 4 * deep * s}));
}

// A paddle that turns about z hits a ball at rest at distance L: it leaves with twice the speed of the paddle there.
bool hit_by_a_paddle() {
  dem::WallBody paddle = mesh({{0, 0, -2}, {6, 0, -2}, {6, 0, 2}, {0, 0, -2}, {6, 0, 2}, {0, 0, 2}});
  paddle.turning = 0.05;
  dem::Setup setup = with_walls(3, {paddle});
  const double L = 4;
  bodies::add(setup, {L, 1.001, 0}, {0, 0, 0}, 1, 1);
  bodies::set_steps_per_contact(setup, 200);
  const auto engine = dem::make_engine(setup);
  engine->run(1000);
  const dem::Snapshot state = engine->snapshot();
  const dem::Measurement m = engine->measure();
  const double speed = std::hypot(state.velocities[0], state.velocities[1], state.velocities[2]);
  return m.wall_contacts == 0 && near(speed, 2 * paddle.turning * L, 4e-4, "speed after the paddle") &&
         near(m.energy() - m.wall_work, 0, 1e-5, "energy less work of the paddle");
}

void a_turning_mesh_hits_as_fast_as_it_is_there(void **) { assert_true(hit_by_a_paddle()); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(edges_between_coplanar_triangles_are_not_felt),
      cmocka_unit_test(edges_and_corners_push_once),
      cmocka_unit_test(a_turning_mesh_hits_as_fast_as_it_is_there),
  };
  return cmocka_run_group_tests_name("mesh walls", tests, nullptr, nullptr);
}
