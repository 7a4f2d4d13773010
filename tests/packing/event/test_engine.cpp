// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The engine against brute force: no overlap at any time, conserved quantities, and the trajectories of a simulation
// that looks at all pairs and images in every step.
#include "packing/event/collision.hpp"
#include "tests/packing/event/systems.hpp"
#include "tests/support/frame.h"
#include "tests/support/refusal.hpp"

#include <cstdio>
#include <string>
#include <utility>

namespace {

using event_test::Points;
using event_test::random_points;
using event_test::smallest_gap;
using packing::Box;
using packing::Vector;
using namespace packing::event;

constexpr uint64_t kSeed = 4711;
constexpr std::array<bool, 3> kWalls{false, false, false}, kPeriodic{true, true, true}, kMixed{true, false, true};

Epoch epoch_of(double growth, double longest) {
  Epoch epoch;
  epoch.growth = growth;
  epoch.longest = longest;
  epoch.most_collisions = 1000000;
  epoch.highest_energy = kNever;
  return epoch;
}

// The hulls of so few particles may end an epoch early: the time left then goes into the next one.
void run_for(Engine &engine, double growth, double duration) {
  const double until = engine.tally().time + duration;
  while (until - engine.tally().time > 1e-13) engine.run(epoch_of(growth, until - engine.tally().time));
}

Vector momentum(const State &state) {
  Vector sum = Vector::Zero();
  for (size_t i = 0; i < state.count(); i++) sum += state.masses[i] * state.velocities[i];
  return sum;
}

// Grows in many short epochs; looks at all pairs after each.
bool never_overlaps(int dimension, const std::array<bool, 3> &periodic, double ratio, double density) {
  const Points points = random_points(150, dimension, periodic, ratio, density, kSeed);
  Engine engine(points.box, points.state);
  const double energy = engine.state().kinetic_energy();
  const Vector before = momentum(engine.state());
  constexpr int kEpochs = 400;
  for (int k = 1; k <= kEpochs; k++) {
    run_for(engine, 0.05, 1.0 / (0.05 * kEpochs));
    const double gap = smallest_gap(points.box, engine.state());
    if (gap > -1e-13 * points.box.edge(0)) continue;
    std::fprintf(stderr, "seed %llu, %dD, ratio %g, epoch %d, scale %g: gap %g\n",
                 static_cast<unsigned long long>(kSeed), dimension, ratio, k, engine.state().scale, gap);
    return false;
  }
  const Tally &tally = engine.tally();
  const double gain = engine.state().kinetic_energy() - energy;
  const double drift = std::sqrt(packing::square(momentum(engine.state()) - before));
  const bool all_periodic = periodic[0] && periodic[1] && (dimension == 2 || periodic[2]);
  const bool ok = std::fabs(engine.state().scale - 1) < 1e-12 && tally.collisions > 300 && gain > 0 &&
                  std::fabs(gain - tally.energy_gain) < 1e-9 * energy && (!all_periodic || drift < 1e-10) &&
                  (all_periodic == (tally.wall_hits == 0));
  if (!ok) {
    std::fprintf(stderr, "seed %llu: scale %g, %llu collisions, gain %g (counted %g), momentum drift %g\n",
                 static_cast<unsigned long long>(kSeed), engine.state().scale,
                 static_cast<unsigned long long>(tally.collisions), gain, tally.energy_gain, drift);
  }
  return ok;
}

bool no_overlap_at_any_time() {
  return never_overlaps(3, kPeriodic, 2, 0.5) && never_overlaps(3, kWalls, 5, 0.55) &&
         never_overlaps(3, kMixed, 1, 0.45) && never_overlaps(2, {true, true, false}, 2, 0.7) &&
         never_overlaps(2, kWalls, 4, 0.7);
}

// One particle after the other, all pairs and their images, everything moved in every step.
class BruteForce {
 public:
  BruteForce(Box box, State state, double growth) : box_(std::move(box)), state_(std::move(state)), growth_(growth) {}

  void run(double duration) {
    for (double left = duration; left > 0;) {
      next_ = left;
      kind_ = kNothing;
      for (size_t i = 0; i < state_.count(); i++) {
        look_for_walls(i);
        for (size_t j = i + 1; j < state_.count(); j++) look_for_images(i, j);
      }
      move(next_);
      left -= next_;
      if (kind_ == kPair) collide();
      if (kind_ == kWall) bounce();
      if (kind_ != kNothing) events_++;
    }
  }
  const State &state() const { return state_; }
  int events() const { return events_; }

 private:
  enum Kind { kNothing, kPair, kWall };

  double rate(size_t i) const { return growth_ * state_.radii[i]; }

  void look_for_walls(size_t i) {
    const double r = state_.scale * state_.radii[i];
    for (int k = 0; k < box_.dimension(); k++) {
      if (box_.is_periodic(k)) continue;
      for (const int side : {-1, 1}) {
        const double x = state_.centers[i][k], gap = (side < 0 ? x : box_.edge(k) - x) - r;
        const double tau = wall_time(gap, side * state_.velocities[i][k], rate(i));
        if (tau < next_) next_ = tau, kind_ = kWall, i_ = i, axis_ = k;
      }
    }
  }

  void look_for_images(size_t i, size_t j) {
    const Vector v = state_.velocities[j] - state_.velocities[i];
    const int a = box_.is_periodic(0) ? 2 : 0, b = box_.is_periodic(1) ? 2 : 0, c = box_.is_periodic(2) ? 2 : 0;
    for (int p = -a; p <= a; p++) {
      for (int q = -b; q <= b; q++) {
        for (int s = -c; s <= c; s++) {
          const Vector shift(p * box_.edge(0), q * box_.edge(1), s * box_.edge(2));
          const Vector x = state_.centers[j] - state_.centers[i] + shift;
          const double sigma = state_.scale * (state_.radii[i] + state_.radii[j]);
          const double tau = meeting_time(x, v, sigma, rate(i) + rate(j));
          if (tau < next_) next_ = tau, kind_ = kPair, i_ = i, j_ = j;
        }
      }
    }
  }

  void move(double time) {
    for (size_t i = 0; i < state_.count(); i++) {
      state_.centers[i] += time * state_.velocities[i];
      box_.wrap(state_.centers[i]);
    }
    state_.scale += time * growth_;
  }

  void collide() {
    Vector n = box_.nearest(state_.centers[j_] - state_.centers[i_]);
    n /= std::sqrt(packing::square(n));
    const double m = state_.masses[i_], w = state_.masses[j_], a = rate(i_) + rate(j_);
    const double v_n = packing::dot(n, state_.velocities[j_] - state_.velocities[i_]);
    const double impulse = pair_impulse(m * w / (m + w), v_n, a);
    state_.velocities[i_] -= impulse / m * n;
    state_.velocities[j_] += impulse / w * n;
  }

  void bounce() {
    double &v = state_.velocities[i_][axis_];
    const double inward = state_.centers[i_][axis_] < box_.edge(axis_) / 2 ? 1 : -1;
    v = inward * wall_rebound(inward * v, rate(i_));
  }

  Box box_;
  State state_;
  double growth_, next_ = 0;
  Kind kind_ = kNothing;
  size_t i_ = 0, j_ = 0;
  int axis_ = 0, events_ = 0;
};

bool follows_brute_force(int dimension, const std::array<bool, 3> &periodic) {
  constexpr double kGrowth = 0.1, kFirst = 7, kSecond = 2;
  const Points points = random_points(12, dimension, periodic, 2, 0.25, kSeed);
  Engine engine(points.box, points.state);
  BruteForce brute(points.box, points.state, kGrowth);
  for (const double duration : {kFirst, kSecond}) {
    brute.run(duration);
    run_for(engine, kGrowth, duration);
  }
  double worst = 0;
  for (size_t i = 0; i < 12; i++) {
    const Vector apart = points.box.nearest(engine.state().centers[i] - brute.state().centers[i]);
    worst = std::max(worst, std::sqrt(packing::square(apart)));
  }
  const auto events = engine.tally().collisions + engine.tally().wall_hits;
  if (worst < 1e-5 && brute.events() > 20 && events == static_cast<uint64_t>(brute.events())) return true;
  std::fprintf(stderr, "seed %llu, %dD: %g apart after %d events (%llu)\n", static_cast<unsigned long long>(kSeed),
               dimension, worst, brute.events(), static_cast<unsigned long long>(events));
  return false;
}

bool same_as_brute_force() {
  return follows_brute_force(3, kWalls) && follows_brute_force(3, kPeriodic) &&
         follows_brute_force(2, {true, false, false});
}

void ends_of_epochs(void **) {
  Points points = random_points(100, 3, kPeriodic, 1, 0.3, kSeed);
  Engine engine(points.box, points.state);
  Epoch epoch = epoch_of(0.1, 100);
  epoch.most_collisions = 10;
  EpochEnd end = EpochEnd::kTime;
  while (engine.tally().collisions < 10) end = engine.run(epoch);
  assert_true(end == EpochEnd::kCollisions);
  const double time = engine.tally().time;
  assert_true(engine.run(epoch_of(0, 1e-6)) == EpochEnd::kTime);
  assert_true(std::fabs(engine.tally().time - time - 1e-6) < 1e-12);
  int polls = 0;
  end = EpochEnd::kTime;
  while (end == EpochEnd::kHulls || end == EpochEnd::kTime) {
    end = engine.run(epoch_of(0, 1000), [&polls] { return ++polls < 3; });
  }
  assert_true(end == EpochEnd::kStopped);
  assert_int_equal(polls, 3);
  epoch = epoch_of(0, 1000);
  epoch.highest_energy = 1;
  do {
    end = engine.run(epoch);
  } while (end == EpochEnd::kHulls);
  assert_true(end == EpochEnd::kEnergy);
}

template <class Change>
bool refuses(Change change, const std::string &text) {
  Points points = random_points(10, 3, kWalls, 1, 0.1, kSeed);
  change(points.state);
  return test::is_refused(text, [&] { Engine(points.box, points.state); });
}

bool nonsense_is_refused() {
  return refuses([](State &s) { s.radii[3] = 0; }, "particle 3: radius 0") &&
         refuses([](State &s) { s.masses[2] = -1; }, "particle 2: mass -1") &&
         refuses([](State &s) { s.centers[1][2] = NAN; }, "particle 1: centre or velocity") &&
         refuses([](State &s) { s.centers[1][2] = -1; }, "outside the box") &&
         refuses([](State &s) { s.scale = -1; }, "scale -1") &&
         refuses([](State &s) { s.masses.pop_back(); }, "not of one number");
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(passes<no_overlap_at_any_time>),
      cmocka_unit_test(passes<same_as_brute_force>),
      cmocka_unit_test(ends_of_epochs),
      cmocka_unit_test(passes<nonsense_is_refused>),
  };
  return cmocka_run_group_tests_name("engine", tests, nullptr, nullptr);
}
