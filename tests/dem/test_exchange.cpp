// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Particles that come and go: where and when they do, that nothing else notices, that the bits are the same for any
// number of threads, any skin and through a checkpoint; what regions hold.
#include "dem/engine/region_content.hpp"
#include "tests/dem/gas.hpp"
#include "tests/support/frame.h"
#include "tests/support/refusal.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

namespace {

constexpr uint64_t kSeed = 5;

dem::Region box_of(const char *name, const std::vector<double> &low, const std::vector<double> &high) {
  dem::Region region;
  region.name = name;
  std::copy(low.begin(), low.end(), region.low);
  std::copy(high.begin(), high.end(), region.high);
  return region;
}

dem::Region below(int axis, double height) {
  dem::Region region;
  region.name = "below";
  region.is_box = false;
  region.point[axis] = height;
  region.normal[axis] = 1;
  return region;
}

void add_inflow(dem::Setup &setup, const dem::Region &box, double rate, const std::vector<double> &radii) {
  dem::Inflow inflow;
  inflow.box = box;
  inflow.rate = rate;
  inflow.radii = radii;
  for (const double radius : radii) {
    inflow.masses.push_back(radius * radius * radius);
    for (int twice = 0; twice < 2; twice++) {
      setup.expected.centers.insert(setup.expected.centers.end(), box.low, box.low + setup.dimension);
      setup.expected.velocities.resize(setup.expected.centers.size());
      setup.expected.radii.push_back(radius);
      setup.expected.masses.push_back(inflow.masses.back());
    }
  }
  setup.inflows.push_back(inflow);
}

// Spheres in a row along x that fly through a plane, 10 apart.
dem::Setup row_of_spheres() {
  dem::Setup setup;
  bodies::set_linear(setup, 1e4);
  for (int k = 0; k < 20; k++) bodies::add(setup, {10.0 * k + 5, 0, 0}, {-20, 0, 0}, 1, k + 1);
  bodies::set_steps_per_contact(setup, 50);
  setup.removals = {below(0, 0)};
  return setup;
}

// Each is gone at the first look after it has passed.
bool fly_out() {
  const dem::Setup setup = row_of_spheres();
  const auto engine = dem::make_engine(setup);
  double worst = 0;
  for (int look = 0; look < 40; look++) {
    engine->run(400);
    const double time = engine->time(), passed = 20 * (time - 50 * setup.time_step);  // all by the last look
    const auto fewest = static_cast<size_t>(std::max(0.0, std::ceil((passed - 5) / 10)));
    const auto most = static_cast<size_t>(std::max(0.0, std::ceil((20 * time - 5) / 10)));
    const dem::Passage out = engine->passages()[0];
    const dem::Snapshot state = engine->snapshot();
    if (out.count < fewest || out.count > most || state.count() != 20 - out.count) return false;
    if (out.mass != static_cast<double>(out.count * (out.count + 1)) / 2) return false;
    for (size_t i = 0; i < state.count(); i++) {
      const double number = static_cast<double>(out.count + i);
      if (state.masses[i] != number + 1) return false;
      worst = std::max(worst, std::fabs(state.centers[3 * i] - (10 * number + 5 - 20 * time)));
    }
  }
  std::printf("gone %zu of 20, the others at their places within %.2g\n", 20 - engine->particle_count(), worst);
  return worst < 1e-8 && engine->particle_count() < 10 && engine->particle_count() > 0;
}

// The box is as wide as the ball, so its place is known; verlet follows a parabola exactly.
bool falls_on_a_parabola() {
  dem::Setup setup;
  setup.effects = dem::kGravity;
  setup.gravity[2] = -3;
  bodies::set_linear(setup, 1e4);
  add_inflow(setup, box_of("in", {1, 2, 3}, {3, 4, 5}), 2, {1});
  setup.inflows[0].velocity[0] = 0.5;
  setup.inflows[0].most = 1;
  bodies::set_steps_per_contact(setup, 50);
  const auto engine = dem::make_engine(setup);
  uint64_t came = 0;
  while (engine->particle_count() == 0 && engine->steps_done() < 100000) {
    came = engine->steps_done();
    engine->run(1);
  }
  const double first = static_cast<double>(came) * setup.time_step;
  engine->run(20000);
  const dem::Snapshot state = engine->snapshot();
  const double t = state.time - first;
  const double expected[3] = {2 + 0.5 * t, 3, 4 - 1.5 * t * t}, speed[3] = {0.5, 0, -3 * t};
  double worst = 0;
  for (int k = 0; k < 3; k++) {
    worst = std::max(worst, std::fabs(state.centers[k] - expected[k]) / (1 + std::fabs(expected[k])));
    worst = std::max(worst, std::fabs(state.velocities[k] - speed[k]) / (1 + std::fabs(speed[k])));
  }
  std::printf("came at %.6f (due at 0.5), a parabola within %.2g\n", first, worst);
  return state.count() == 1 && first >= 0.5 && first < 0.5 + 51 * setup.time_step && worst < 1e-10;
}

// Balls that stay where they appear: none overlaps another, a wall of the box, a slanting plane or an image; those that
// find no room wait.
bool fill_without_overlap(int dimension) {
  dem::Setup setup;
  setup.dimension = dimension;
  bodies::set_linear(setup, 1e4);
  bodies::set_periodic(setup, 0, 0, 12);
  bodies::set_walls(setup, dimension - 1, 0, 12);
  const std::vector<double> low(static_cast<size_t>(dimension)), high(static_cast<size_t>(dimension), 12.0);
  add_inflow(setup, box_of("in", low, high), 1e4, {0.6, 1, 0.8});
  dem::WallBody plane;
  plane.point[0] = 6;
  plane.point[dimension - 1] = 6;
  plane.normal[dimension - 1] = 1;
  setup.walls = {plane};
  setup.effects |= dem::kSurfaces;
  bodies::set_steps_per_contact(setup, 50);
  const auto engine = dem::make_engine(setup);
  engine->run(2000);
  const dem::Measurement m = engine->measure();
  const dem::Passage in = engine->passages()[0];
  const dem::Snapshot state = engine->snapshot();
  double lowest = 12;
  for (size_t i = 0; i < state.count(); i++)
    lowest = std::min(lowest, state.centers[(i + 1) * static_cast<size_t>(dimension) - 1] - state.radii[i]);
  std::printf("%zu came, %llu wait, %zu contacts, lowest at %.3f\n", state.count(),
              static_cast<unsigned long long>(in.waiting), m.contacts + m.wall_contacts, lowest);
  return in.count == state.count() && in.count > 10 && in.waiting > 100 && m.contacts + m.wall_contacts == 0 &&
         m.translation == 0 && lowest >= 6;
}

bool fill_without_overlaps() { return fill_without_overlap(2) && fill_without_overlap(3); }

// Rough balls in a stream: they come from above, fall on a plane, and go where they roll into a box.
dem::Setup stream(int dimension) {
  bodies::Gas gas;
  gas.dimension = dimension;
  gas.edge = dimension == 3 ? 5 : 12;
  gas.spacing = 2.02;
  gas.temperature = 1;
  gas.effects = dem::kDissipation | dem::kFriction | dem::kRolling | dem::kGravity;
  dem::Setup setup = bodies::make_gas(gas, kSeed);
  setup.contact.restitution = 0.6;
  setup.contact.friction = 0.5;
  setup.contact.rolling_friction = 0.1;
  const int up = dimension - 1;
  setup.gravity[up] = -10;
  const double width = setup.box_max[0], top = 2 * width;
  bodies::set_periodic(setup, 0, 0, width);
  bodies::set_walls(setup, up, 0, top);
  if (dimension == 3) bodies::set_walls(setup, 1, 0, width);
  dem::WallBody slope;
  slope.normal[up] = 1;
  slope.point[up] = 0.5;
  setup.walls = {slope};
  setup.effects |= dem::kSurfaces;
  std::vector<double> low(static_cast<size_t>(dimension), 0.1), high(static_cast<size_t>(dimension), width - 0.1);
  low.back() = width + 2;
  high.back() = top - 1;
  add_inflow(setup, box_of("in", low, high), 40, {1, 0.7, 0.5});
  setup.inflows[0].velocity[up] = -4;
  std::fill(low.begin(), low.end(), 0.0);
  std::fill(high.begin(), high.end(), width);
  high[0] = width / 2;
  high.back() = 2;
  setup.removals = {box_of("hole", low, high)};
  bodies::set_steps_per_contact(setup, 20);
  setup.skin = 0.2;
  return setup;
}

constexpr uint64_t kSteps = 3000;

bool same_bits(const std::vector<double> &a, const std::vector<double> &b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

bool same_end(dem::Engine &a, dem::Engine &b) {
  const dem::Snapshot x = a.snapshot(), y = b.snapshot();
  const dem::Passage in = a.passages()[0], out = a.passages()[1];
  return same_bits(x.centers, y.centers) && same_bits(x.velocities, y.velocities) && same_bits(x.spins, y.spins) &&
         same_bits(x.radii, y.radii) && in.count == b.passages()[0].count && out.mass == b.passages()[1].mass;
}

std::unique_ptr<dem::Engine> run_of(const dem::Setup &setup, dem::Precision precision = dem::Precision::kDouble) {
  auto engine = dem::make_engine(setup, precision);
  engine->run(kSteps);
  return engine;
}

bool has_traffic(const dem::Engine &engine) {
  const std::vector<dem::Passage> passages = engine.passages();
  std::printf("%zu particles; %llu have come, %llu gone\n", engine.particle_count(),
              static_cast<unsigned long long>(passages[0].count), static_cast<unsigned long long>(passages[1].count));
  return passages[0].count > 20 && passages[1].count > 20;
}

bool is_reproducible(dem::Setup setup) {
  const auto alone = run_of(setup);
  bool same = has_traffic(*alone);
  setup.threads = 3;
  same = same && same_end(*alone, *run_of(setup));
  setup.threads = 1;
  setup.skin = 0;
  same = same && same_end(*alone, *run_of(setup));
  return same;
}

// Someone looks at every seventh step, and the rest goes on from a checkpoint, which is read by a new engine.
bool survives_looks_and_restarts(const dem::Setup &setup) {
  const auto alone = run_of(setup);
  const auto first = dem::make_engine(setup), second = dem::make_engine(setup);
  while (first->steps_done() < kSteps / 2) {
    first->run(7);
    first->measure();
  }
  dem::Checkpoint checkpoint;
  first->save(checkpoint);
  second->restore(checkpoint);
  second->run(kSteps - second->steps_done());
  return same_end(*alone, *second) && second->particle_count() != setup.count();
}

bool all_is_reproducible() {
  bool good = true;
  for (const int dimension : {2, 3}) {
    const dem::Setup setup = stream(dimension);
    good = good && is_reproducible(setup) && survives_looks_and_restarts(setup);
  }
  return good;
}

bool float_numbers_work() {
  dem::Setup setup = stream(2);
  setup.walls.clear();
  setup.spins.clear();
  setup.effects &= ~(dem::kSurfaces | dem::kFriction | dem::kRolling);
  return has_traffic(*run_of(setup, dem::Precision::kFloat));
}

// Far away flies somebody out: a packing with springs notices nothing but another order of sums.
bool others_keep_their_contacts() {
  bodies::Gas gas;
  gas.edge = 5;
  gas.spacing = 1.97;
  gas.temperature = 4;
  gas.effects = dem::kFriction | dem::kRolling;
  dem::Setup setup = bodies::make_gas(gas, kSeed);
  setup.contact.friction = 0.4;
  setup.contact.rolling_friction = 0.1;
  bodies::wall_in(setup);
  bodies::set_steps_per_contact(setup, 50);
  const auto plain = dem::make_engine(setup);
  bodies::add(setup, {-50, 5, 5}, {-1, 0, 0}, 1, 1);
  setup.removals = {below(0, -45)};
  const auto with = dem::make_engine(setup);
  plain->run(300);
  with->run(300);
  const dem::Snapshot a = plain->snapshot(), b = with->snapshot();
  if (a.count() != b.count()) return false;
  double worst = 0;
  for (size_t k = 0; k < a.spins.size(); k++) {
    worst = std::max({worst, std::fabs(a.centers[k] - b.centers[k]), std::fabs(a.spins[k] - b.spins[k])});
  }
  std::printf("the others: within %.2g, %zu contacts\n", worst, plain->measure().contacts);
  return worst < 1e-9 && plain->measure().contacts > 15;
}

// A stream without forces: what flows through a region is what comes and what goes, by the mean over time.
bool flow_is_what_passes() {
  dem::Setup setup;
  bodies::set_linear(setup, 1e4);
  add_inflow(setup, box_of("in", {0, 0, 0}, {4, 30, 30}), 5, {1});
  setup.inflows[0].velocity[0] = 2;
  setup.removals = {box_of("out", {40, -1, -1}, {60, 31, 31})};
  bodies::set_steps_per_contact(setup, 50);
  setup.time_step *= 4;
  const dem::Region region = box_of("middle", {10, 0, 0}, {30, 30, 30});
  const auto engine = dem::make_engine(setup);
  engine->run(static_cast<uint64_t>(25 / setup.time_step));
  const double before = engine->passages()[1].mass, start = engine->time();
  double flow = 0, count = 0;
  constexpr int kLooks = 40;
  for (int look = 0; look < kLooks; look++) {
    engine->run(static_cast<uint64_t>(1 / setup.time_step));
    const dem::RegionContent in = dem::content_of(region, engine->snapshot());
    flow += in.flow[0] / kLooks;
    count += static_cast<double>(in.count) / kLooks;
    if (std::fabs(in.fraction * 20 * 900 - static_cast<double>(in.count) * 4 * bodies::kPi / 3) > 1e-9) return false;
    if (std::fabs(in.flow[0] - in.mass * 2 / 20) > 1e-9 || in.flow[1] != 0) return false;
  }
  const double out = (engine->passages()[1].mass - before) / (engine->time() - start);
  std::printf("flow in the middle %.4f, out %.4f (5), %.2f inside (50)\n", flow, out, count);
  return std::fabs(flow - 5) < 0.1 && std::fabs(out - 5) < 0.15 && std::fabs(count - 50) < 1;
}

bool what_does_not_go_along_is_refused() {
  dem::Setup setup = stream(3);
  setup.effects |= dem::kGrowth;
  const bool growth =
      test::is_refused("inflows and removals do not go together with growth", [&] { dem::make_engine(setup); });
  setup = row_of_spheres();
  setup.scheme = dem::scheme_of_name("leapfrog");
  const bool scheme =
      test::is_refused("inflows and removals do not go together with the scheme", [&] { dem::make_engine(setup); });
  return growth && scheme && test::is_refused("work is not counted with [[inflow]] and [[removal]]", [&] {
           dem::make_engine(stream(2))->count_work();
         });
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(passes<fly_out>),
      cmocka_unit_test(passes<falls_on_a_parabola>),
      cmocka_unit_test(passes<fill_without_overlaps>),
      cmocka_unit_test(passes<all_is_reproducible>),
      cmocka_unit_test(passes<float_numbers_work>),
      cmocka_unit_test(passes<others_keep_their_contacts>),
      cmocka_unit_test(passes<flow_is_what_passes>),
      cmocka_unit_test(passes<what_does_not_go_along_is_refused>),
  };
  return cmocka_run_group_tests_name("exchange", tests, nullptr, nullptr);
}
