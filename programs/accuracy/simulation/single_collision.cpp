// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/accuracy/simulation/single_collision.hpp"

#include "dem/base/error.hpp"
#include "dem/setup/time_step.hpp"
#include "packing/random.hpp"
#include "programs/accuracy/simulation/oscillator.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace accuracy {
namespace {

constexpr double kSpeed = 0.01;  // of approach; overlaps are about 0.7 % of the radius 1
constexpr double kYoungModulus = 64;
// In steps: the schemes' inner stages look up to 1.4 steps ahead and must all be free of force at first.
constexpr double kFirstGap = 3;
constexpr double kSpareSteps = 6;  // after the contact, for the same reason

struct Theory {
  double duration, overlap;
};

struct Pairs {
  dem::Setup setup;
  std::vector<Theory> theory;
};

// d = (15 mu v^2 / (16 E* sqrt(R)))^(2/5), t_c = 2.943275 d / v, of the radius 1 and Poisson's ratio 0.
Theory hertz_theory(double reduced_mass) {
  const double overlap = std::pow(15 * reduced_mass * kSpeed * kSpeed / (16 * kYoungModulus / 2 * std::sqrt(0.5)), 0.4);
  return {2.943275 * overlap / kSpeed, overlap};
}

Theory theory_of(const CollisionCase &what, double reduced_mass) {
  if (what.hertz) return hertz_theory(reduced_mass);
  const Oscillator oscillator(1, reduced_mass, what.restitution);
  return {oscillator.duration(), oscillator.largest_overlap(kSpeed)};
}

// By whose share t_c grows by one part in n: t_c ~ m^(1/2), with Hertz ~ m^(2/5).
double mass_of(const CollisionCase &what, double share) {
  return 2 * std::pow(1 + share / what.steps, what.hertz ? 2.5 : 2);
}

// Discs in a row each; only the coordinate along x plays a part.
Pairs make_pairs(const CollisionCase &what) {
  Pairs result;
  dem::Setup &setup = result.setup;
  setup.dimension = 2;
  setup.scheme = what.scheme;
  setup.contact.stiffness = 1;
  setup.contact.restitution = what.restitution;
  if (what.restitution < 1) setup.effects |= dem::kDissipation;
  if (what.hertz) {
    setup.effects |= dem::kHertz;
    setup.contact.young_modulus = kYoungModulus;
    setup.impact_speed = 1.1 * kSpeed;  // forces of a few steps make it a little faster
  }
  packing::Random random(what.seed);
  for (size_t p = 0; p < what.pairs; p++) {
    // The first pair is the lightest and sets the time step.
    const double share = what.whole_steps || p < 1 ? 0 : random.uniform();
    const double mass = mass_of(what, share);
    result.theory.push_back(theory_of(what, mass / 2));
    setup.radii.insert(setup.radii.end(), 2, 1.0);
    setup.masses.insert(setup.masses.end(), 2, mass);
  }
  setup.time_step = result.theory.front().duration / what.steps;
  const auto count = static_cast<double>(what.pairs);
  for (size_t p = 0; p < what.pairs; p++) {
    const double phase = (static_cast<double>(p) + random.uniform()) / count;
    const double x = 1 + kSpeed * setup.time_step * (kFirstGap + phase) / 2, y = 4 * static_cast<double>(p);
    setup.centers.insert(setup.centers.end(), {-x, y, x, y});
    setup.velocities.insert(setup.velocities.end(), {kSpeed / 2, 0, -kSpeed / 2, 0});
  }
  return result;
}

double gap(const dem::Snapshot &state, size_t pair) {
  const size_t left = 4 * pair, right = left + 2;
  return state.centers[right] - state.centers[left] - (state.radii[2 * pair] + state.radii[2 * pair + 1]);
}

double opening_speed(const dem::Snapshot &state, size_t pair) {
  return state.velocities[4 * pair + 2] - state.velocities[4 * pair];
}

Deviation deviation(const std::vector<double> &errors) {
  Deviation result;
  double squares = 0;
  for (const double error : errors) {
    result.mean += error;
    squares += error * error;
  }
  result.mean /= static_cast<double>(errors.size());
  result.rms = std::sqrt(squares / static_cast<double>(errors.size()));
  return result;
}

}  // namespace

CollisionErrors collide(const CollisionCase &what) {
  const Pairs pairs = make_pairs(what);
  const auto engine = dem::make_engine(pairs.setup, what.precision);
  const dem::Snapshot before = engine->snapshot();
  std::vector<double> deepest(what.pairs, 0.0);
  // With a dashpot Hertz contacts last longer than t_c.
  const double longest = (what.hertz && what.restitution < 1 ? 1.5 : 1) * what.steps + 1;
  const auto last = static_cast<uint64_t>(longest + kFirstGap + 1 + kSpareSteps);
  dem::Snapshot state;
  while (engine->steps_done() < last) {
    engine->run(1);
    state = engine->snapshot();
    for (size_t p = 0; p < what.pairs; p++) deepest[p] = std::max(deepest[p], -gap(state, p));
  }
  std::vector<double> duration, restitution, overlap;
  CollisionErrors result;
  for (size_t p = 0; p < what.pairs; p++) {
    const Theory &theory = pairs.theory[p];
    const double approach = -opening_speed(before, p), retreat = opening_speed(state, p);
    if (!(gap(state, p) > 0 && retreat > 0)) {
      throw dem::Error("pair " + std::to_string(p) + " has not parted after " + std::to_string(last) + " steps");
    }
    const double met = gap(before, p) / approach, parted = state.time - gap(state, p) / retreat;
    duration.push_back((parted - met) / theory.duration - 1);
    restitution.push_back(retreat / approach - what.restitution);
    overlap.push_back(deepest[p] / theory.overlap - 1);
    result.steps += theory.duration / pairs.setup.time_step / static_cast<double>(what.pairs);
  }
  result.duration = deviation(duration);
  result.restitution = deviation(restitution);
  result.overlap = deviation(overlap);
  return result;
}

}  // namespace accuracy
