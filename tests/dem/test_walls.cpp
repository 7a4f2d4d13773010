// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Walls beside those of the box against closed forms: planes of any direction and cylinders, and how they move;
// walls of all kinds at once to the same bits.
#include "tests/dem/gas.hpp"
#include "tests/dem/wall_bodies.hpp"
#include "tests/support/frame.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>

namespace {

constexpr uint64_t kSeed = 17;
using namespace bodies;

// A ball meets a plane of any direction as it meets the wall of a box.
bool tilted_plane_as_floor(double restitution) {
  dem::Setup flat;
  bodies::set_linear(flat, kStiffness, restitution);
  flat.effects |= dem::kFriction;
  flat.contact.friction = 0.3;
  dem::Setup tilted = flat;
  bodies::set_walls(flat, 2, 0, 100);
  tilted.effects |= dem::kSurfaces;
  tilted.walls = {plane({0, 0, 0}, {0.6, 0, 0.8})};  // the floor turned by y: x to (0.8, 0, -0.6)
  const auto turned = [](double x, double y, double z) {
    return std::vector<double>{0.8 * x + 0.6 * z, y, -0.6 * x + 0.8 * z};
  };
  bodies::add(flat, {0.2, 0.1, 1.1}, {0.7, 0.4, -1}, 1, 1, {0.1, 0.2, 0.3});
  bodies::add(tilted, turned(0.2, 0.1, 1.1), turned(0.7, 0.4, -1), 1, 1, turned(0.1, 0.2, 0.3));
  bodies::set_steps_per_contact(flat, 100);
  tilted.time_step = flat.time_step;
  const auto on_floor = dem::make_engine(flat), on_plane = dem::make_engine(tilted);
  on_floor->run(400);
  on_plane->run(400);
  const dem::Snapshot a = on_floor->snapshot(), b = on_plane->snapshot();
  double error = 0;
  for (const auto &[x, y] : {std::pair(&a.velocities, &b.velocities), std::pair(&a.spins, &b.spins)}) {
    const std::vector<double> expected = turned((*x)[0], (*x)[1], (*x)[2]);
    for (size_t k = 0; k < 3; k++) error = std::max(error, std::fabs((*y)[k] - expected[k]));
  }
  return a.velocities[2] > 0 && near(error, 0, 1e-11, "tilted plane against floor");
}

void planes_of_any_direction_are_walls(void **) {
  assert_true(tilted_plane_as_floor(1));
  assert_true(tilted_plane_as_floor(0.6));
}

// Elastic, at rest, hit by a plane that moves at V: leaves with 2 V, and the wall has done all the work.
bool hit_by_a_plane() {
  dem::WallBody wall = plane({0, 0, 0}, {0, 0.6, 0.8});
  const double speed = 0.5;
  for (size_t k = 0; k < 3; k++) wall.velocity[k] = speed * wall.normal[k];
  wall.velocity[0] = 3;  // along itself, which no smooth ball feels
  dem::Setup setup = with_walls(3, {wall});
  bodies::add(setup, {0, 0.6 * 1.05, 0.8 * 1.05}, {0, 0, 0}, 1, 2);
  bodies::set_steps_per_contact(setup, 100);
  const auto engine = dem::make_engine(setup);
  engine->run(400);
  const dem::Snapshot state = engine->snapshot();
  const dem::Measurement m = engine->measure();
  const double left = 0.6 * state.velocities[1] + 0.8 * state.velocities[2];
  return near(left, 2 * speed, 1e-4, "speed after the hit") && near(state.velocities[0], 0, 1e-15, "along the plane") &&
         near(m.energy() - m.wall_work, 0, 1e-3, "energy less work") && m.wall_work > 0.99;
}

void a_moving_plane_doubles_its_speed(void **) { assert_true(hit_by_a_plane()); }

// The energy that walls do not account for, of an elastic gas between a swinging plane and fixed ones, at its worst.
double unaccounted(double steps_per_contact) {
  dem::WallBody piston = plane({0, 0}, {1, 0});
  piston.swing[0] = 0.3;
  piston.frequency = 0.5;
  dem::Setup setup = with_walls(2, {piston});
  bodies::set_walls(setup, 1, 0, 12);
  setup.walls.push_back(plane({12, 0}, {-1, 0}));
  setup.walls.back().name = "other";
  packing::Random random(kSeed);
  for (int i = 0; i < 4; i++) {
    for (int j = 0; j < 4; j++) {
      bodies::add(setup, {2.5 + 2.3 * i, 2 + 2.5 * j}, {random.normal(), random.normal()}, 1, 1);
    }
  }
  bodies::set_steps_per_contact(setup, steps_per_contact);
  const auto engine = dem::make_engine(setup);
  const double start = engine->measure().energy();
  double worst = 0;
  const auto steps = static_cast<uint64_t>(6 / setup.time_step / 40);
  for (int look = 0; look < 40; look++) {
    engine->run(steps);
    const dem::Measurement m = engine->measure();
    worst = std::max(worst, std::fabs(m.energy() - m.wall_work - start));
  }
  std::printf("%.0f steps per contact: energy %.6g, work %.6g, unaccounted %.3g\n", steps_per_contact,
              engine->measure().energy(), engine->measure().wall_work, worst);
  return worst;
}

void work_of_walls_is_accounted_for(void **) {
  const double coarse = unaccounted(50), fine = unaccounted(200);
  assert_true(coarse < 0.02);
  assert_true(fine < coarse / 8);  // second order: 16
}

// A disc between a floor and a plane that presses: at rest the plane bears its force, less the weight below.
bool pressed_to_a_force() {
  dem::WallBody piston = plane({0, 5}, {0, -1});
  piston.force = 30;
  piston.fastest = 0.5;
  dem::Setup setup = with_walls(2, {piston}, 0.5);
  bodies::set_walls(setup, 1, 0, 100);
  bodies::add(setup, {0, 1}, {0, 0}, 1, 1);
  bodies::add(setup, {0, 3}, {0, 0}, 1, 1);
  bodies::set_steps_per_contact(setup, 50);
  const auto engine = dem::make_engine(setup);
  engine->run(static_cast<uint64_t>(20 / setup.time_step));
  const dem::WallReport wall = engine->walls_now()[0];
  const dem::Snapshot state = engine->snapshot();
  const double overlap = 30 / kStiffness;
  return near(wall.push[1], -30, 1e-9, "force of the plane") &&
         near(wall.place.shift[1], -1 - 3 * overlap, 1e-9, "its way") &&
         near(state.centers[3] - state.centers[1], 2 - overlap, 1e-9, "distance of the discs");
}

// The two discs again: K is k, and C that of a disc with a wall. The largest miss of the force late in the run.
double swing_of(double share, double restitution) {
  dem::WallBody piston = plane({0, 5}, {0, -1});
  piston.force = 30;
  dem::Setup setup = with_walls(2, {piston}, restitution);
  bodies::set_walls(setup, 1, 0, 100);
  bodies::add(setup, {0, 1}, {0, 0}, 1, 1);
  bodies::add(setup, {0, 3}, {0, 0}, 1, 1);
  bodies::set_steps_per_contact(setup, 50);
  const double log_e = std::log(restitution),
               damping = -2 * log_e * std::sqrt(kStiffness) / std::hypot(bodies::kPi, log_e);
  setup.walls[0].fastest = share * piston.force / (kStiffness * setup.time_step / 2 + damping);
  const auto engine = dem::make_engine(setup);
  engine->run(20000);
  double largest = 0, load = 0;
  for (int look = 0; look < 50; look++) {
    engine->run(1);
    load = std::max(load, engine->measure().press_load);
    largest = std::max(largest, std::fabs(engine->walls_now()[0].push[1] + 30));
  }
  std::printf("load %.3f, e = %.1f: misses the force by %.3g\n", load, restitution, largest);
  assert_true(std::fabs(load / share - 1) < 1e-9);
  return largest;
}

bool faster_planes_swing() {
  bool good = true;
  for (const double restitution : {0.5, 0.8}) {
    good = good && swing_of(0.5, restitution) < 1e-9 && swing_of(0.9, restitution) < 1e-6;
    good = good && swing_of(1.3, restitution) > 1;
  }
  return good;
}

void a_plane_swings_above_the_speed_that_the_page_tells(void **) { assert_true(faster_planes_swing()); }

void a_pressing_plane_comes_to_rest_at_its_force(void **) { assert_true(pressed_to_a_force()); }

// Round and round in a smooth drum: k d = m v^2 / (R - r + d).
bool circles_in_a_drum(int dimension) {
  const double R = 5, v = 2;
  dem::Setup setup = with_walls(dimension, {cylinder(std::vector<double>(static_cast<size_t>(dimension), 0.0), R)});
  const double path = (R - 1 + std::sqrt((R - 1) * (R - 1) + 4 * v * v / kStiffness)) / 2;
  std::vector<double> center(static_cast<size_t>(dimension), 0.0), velocity = center;
  center[0] = path;
  velocity[1] = v;
  bodies::add(setup, center, velocity, 1, 1);
  bodies::set_steps_per_contact(setup, 200);
  const auto engine = dem::make_engine(setup);
  const double turns = 1.3;
  engine->run(static_cast<uint64_t>(std::lround(turns * 2 * bodies::kPi * path / v / setup.time_step)));
  const dem::Snapshot state = engine->snapshot();
  const double angle = v / path * state.time;
  return near(state.centers[0], path * std::cos(angle), 1e-3, "x in the drum") &&
         near(state.centers[1], path * std::sin(angle), 1e-3, "y in the drum") &&
         near(std::hypot(state.velocities[0], state.velocities[1]), v, 1e-4, "speed in the drum");
}

void a_smooth_drum_leads_round(void **) {
  assert_true(circles_in_a_drum(2));
  assert_true(circles_in_a_drum(3));
}

// In a rough drum that turns, drag brings a ball to stay at the bottom, its surface as fast as the drum's.
bool rolls_at_the_bottom(int dimension) {
  const double R = 5, turning = 0.4;
  dem::WallBody drum = cylinder(std::vector<double>(static_cast<size_t>(dimension), 0.0), R);
  drum.turning = turning;
  dem::Setup setup = with_walls(dimension, {drum}, 0.3);
  setup.effects |= dem::kFriction | dem::kGravity | dem::kDrag;
  setup.contact.friction = 0.5;
  setup.viscosity = 0.02;
  setup.gravity[1] = -10;
  std::vector<double> center(static_cast<size_t>(dimension), 0.0);
  center[1] = -3.9;
  bodies::add(setup, center, std::vector<double>(static_cast<size_t>(dimension), 0.0), 1, 1);
  bodies::set_steps_per_contact(setup, 50);
  const auto engine = dem::make_engine(setup);
  engine->run(static_cast<uint64_t>(100 / setup.time_step));
  const dem::Snapshot state = engine->snapshot();
  const double spin = state.spins[dimension == 3 ? 2 : 0];
  const double arm = 1 - 10 / kStiffness;  // from the centre to the surface
  return near(spin, turning * R / arm, 1e-5, "spin at the bottom") &&
         near(state.centers[0], 0, 1e-3, "place at the bottom");
}

void a_rough_drum_takes_along(void **) {
  assert_true(rolls_at_the_bottom(2));
  assert_true(rolls_at_the_bottom(3));
}

// A rough crowd in a turning drum with a paddle, a swinging lid and one that presses.
dem::Setup busy_setup(int dimension) {
  bodies::Gas gas;
  gas.dimension = dimension;
  gas.edge = dimension == 3 ? 4 : 12;
  gas.spacing = 2.02;
  gas.temperature = 4;
  gas.effects = dem::kDissipation | dem::kFriction | dem::kRolling | dem::kGravity | dem::kSurfaces;
  dem::Setup setup = bodies::make_gas(gas, kSeed);
  setup.contact.restitution = 0.8;
  setup.contact.friction = 0.4;
  setup.contact.rolling_friction = 0.1;
  setup.gravity[1] = -3;
  const double middle = setup.box_max[0] / 2;
  dem::WallBody drum = cylinder(std::vector<double>(static_cast<size_t>(dimension), middle), 1.6 * middle);
  drum.turning = 0.7;
  setup.walls.push_back(drum);
  std::vector<double> point(static_cast<size_t>(dimension), middle), normal(static_cast<size_t>(dimension), 0.0);
  normal[0] = 1;
  point[0] = -1;
  dem::WallBody lid = plane(point, normal);
  lid.name = "lid";
  lid.swing[0] = 0.5;
  lid.frequency = 2;
  setup.walls.push_back(lid);
  normal[0] = -1;
  point[0] = 2 * middle + 1;
  dem::WallBody piston = plane(point, normal);
  piston.name = "piston";
  piston.force = 50;
  piston.fastest = 0.5;
  setup.walls.push_back(piston);
  if (dimension == 3) {
    bodies::set_walls(setup, 2, setup.box_min[2], setup.box_max[2]);
    dem::WallBody paddle = tiled_floor(3, 4);
    paddle.name = "paddle";
    std::fill_n(paddle.pivot, 3, middle);
    for (double &corner : paddle.corners) corner += middle;
    paddle.axis[2] = 0;
    paddle.axis[0] = 1;
    paddle.turning = -1;
    setup.walls.push_back(paddle);
  }
  bodies::set_steps_per_contact(setup, 50);
  return setup;
}

dem::Handover state_after(
    const dem::Setup &setup, const std::function<void(dem::Engine &)> &meanwhile = [](dem::Engine &) {}) {
  const auto engine = dem::make_engine(setup);
  engine->run(150);
  meanwhile(*engine);
  engine->run(150);
  return engine->hand_over();
}

bool same_bits(const std::vector<double> &a, const std::vector<double> &b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

bool same_bits(const dem::Handover &a, const dem::Handover &b) {
  bool same = same_bits(a.particles.centers, b.particles.centers) &&
              same_bits(a.particles.velocities, b.particles.velocities) &&
              same_bits(a.particles.spins, b.particles.spins) &&
              a.beginning.wall_places.size() == b.beginning.wall_places.size();
  for (size_t k = 0; same && k < a.beginning.wall_places.size(); k++) {
    const dem::WallPlace &x = a.beginning.wall_places[k].place, &y = b.beginning.wall_places[k].place;
    same = std::memcmp(x.shift, y.shift, sizeof x.shift) == 0 && x.angle == y.angle;
  }
  return same;
}

bool same_whatever(int dimension) {
  dem::Setup setup = busy_setup(dimension);
  const dem::Handover plain = state_after(setup);
  bool same = true;
  for (const int threads : {2, 3}) {
    setup.threads = threads;
    same = same && same_bits(plain, state_after(setup));
  }
  for (const double skin : {0.02, 0.3}) {
    setup.skin = skin;
    same = same && same_bits(plain, state_after(setup));
  }
  same = same && same_bits(plain, state_after(setup, [](dem::Engine &engine) {
                             engine.measure();
                             engine.snapshot();
                             engine.walls_now();
                           }));
  const auto through_checkpoint = [&](dem::Engine &engine) {
    dem::Checkpoint saved;
    engine.save(saved);
    engine.run(7);
    engine.restore(saved);
  };
  return same && same_bits(plain, state_after(setup, through_checkpoint));
}

void neither_threads_nor_skin_nor_restart_change_a_bit(void **) {
  assert_true(same_whatever(2));
  assert_true(same_whatever(3));
}

// A stage that changes nothing: walls and what contacts with them remember go along. Without dashpots, since these take
// velocities half a step old, but at the beginning those of the time.
double seam(const dem::Setup &setup) {
  const auto whole = dem::make_engine(setup), first = dem::make_engine(setup);
  dem::Handover handover;
  while (handover.beginning.surfaces.pairs.empty() && first->steps_done() < 5000) {
    first->run(20);
    handover = first->hand_over();
  }
  whole->run(first->steps_done() + 40);
  dem::Setup rest = setup;
  static_cast<dem::ParticleArrays &>(rest) = handover.particles;
  rest.beginning = handover.beginning;
  for (size_t k = 0; k < rest.walls.size(); k++) {
    rest.walls[k].start = handover.beginning.wall_places[k].place;
  }
  const auto second = dem::make_engine(rest);
  second->run(40);
  const dem::Snapshot a = whole->snapshot(), b = second->snapshot();
  double largest = 0;
  for (size_t k = 0; k < a.centers.size(); k++) largest = std::max(largest, std::fabs(a.centers[k] - b.centers[k]));
  for (size_t k = 0; k < a.spins.size(); k++) largest = std::max(largest, std::fabs(a.spins[k] - b.spins[k]));
  std::printf("seam %.3g, springs of %zu contacts with surfaces\n", largest, handover.beginning.surfaces.pairs.size());
  return handover.beginning.surfaces.pairs.empty() ? 1 : largest;
}

void walls_go_along_from_stage_to_stage(void **) {
  for (const int dimension : {2, 3}) {
    dem::Setup setup = busy_setup(dimension);
    setup.effects &= ~static_cast<unsigned>(dem::kDissipation);
    setup.walls[1].swing[0] = 0;  // it would start anew
    assert_true(seam(setup) < 1e-8);
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(planes_of_any_direction_are_walls),
      cmocka_unit_test(a_moving_plane_doubles_its_speed),
      cmocka_unit_test(work_of_walls_is_accounted_for),
      cmocka_unit_test(a_pressing_plane_comes_to_rest_at_its_force),
      cmocka_unit_test(a_plane_swings_above_the_speed_that_the_page_tells),
      cmocka_unit_test(a_smooth_drum_leads_round),
      cmocka_unit_test(a_rough_drum_takes_along),
      cmocka_unit_test(neither_threads_nor_skin_nor_restart_change_a_bit),
      cmocka_unit_test(walls_go_along_from_stage_to_stage),
  };
  return cmocka_run_group_tests_name("walls", tests, nullptr, nullptr);
}
